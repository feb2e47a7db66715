//! The functions that Rust takes from the platform's C library, from the `libm` crate instead.
//!
//! WebAssembly has no C library: there `f64::sin` is the `libm` crate's sine, which the compiler brings
//! along. Another sine may differ in the last bit, and rightly. So that the grid asks about the module and
//! not about two sines, this program brings the same one. `./build` makes sure that the C library's
//! mathematics is not even loaded.

use std::mem::MaybeUninit;

macro_rules! instead {
    ($($name:ident($($x:ident),+);)+) => {$(
        #[expect(unsafe_code, reason = "it must bear the name that the compiler calls")]
        #[unsafe(no_mangle)]
        extern "C" fn $name($($x: f64),+) -> f64 {
            libm::$name($($x),+)
        }
    )+};
}

instead! {
    sin(x); cos(x); tan(x); asin(x); acos(x); atan(x); atan2(y, x);
    sinh(x); cosh(x); tanh(x); asinh(x); acosh(x); atanh(x);
    exp(x); exp2(x); expm1(x); log(x); log2(x); log10(x); log1p(x);
    pow(x, y); cbrt(x); hypot(x, y); fmod(x, y);
}

/// Where a sine and a cosine of one angle are wanted, the compiler asks for both at once.
#[expect(unsafe_code, reason = "the compiler calls these by name")]
#[unsafe(no_mangle)]
extern "C" fn sincos(x: f64, sine: &mut MaybeUninit<f64>, cosine: &mut MaybeUninit<f64>) {
    sine.write(libm::sin(x));
    cosine.write(libm::cos(x));
}
