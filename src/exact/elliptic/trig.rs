//! Sine and cosine of an angle given in turns: no division by the circle's constant to lose digits in.

use crate::number::double_double::DoubleDouble;
use crate::number::{Lane, splat};

/// Sine and cosine of `turns` whole turns.
///
/// Whole and quarter turns are taken off first, exactly, so that a phase of 1e9 turns costs what a small one
/// does, and what is left keeps all its digits.
#[inline(always)]
pub(crate) fn sin_cos_of_turns<T: Lane>(turns: DoubleDouble<T>) -> (T, T) {
    let (_, part) = turns.split();
    let [quarters, left] = (part * 4.0).whole_and_left();
    let (sin, cos) = (left * 0.25).sin_cos_of_part();
    // Quarters from -2 to 2: an odd one exchanges the two, and each then has its half of the circle below
    // zero.
    let size = quarters.abs();
    let odd = (size - 1.0).abs().lt(splat::<T>(0.5));
    let (s, c) = (T::select(odd, cos, sin), T::select(odd, sin, cos));
    let opposite = splat::<T>(1.5).lt(size);
    let sin_sign = T::select(quarters.lt(splat::<T>(-0.5)), splat::<T>(-1.0), splat::<T>(1.0));
    let cos_sign = T::select(splat::<T>(0.5).lt(quarters), splat::<T>(-1.0), splat::<T>(1.0));
    let signed = |sign, x| T::select(opposite, splat(-1.0), sign) * x;
    (signed(sin_sign, s), signed(cos_sign, c))
}

#[cfg(test)]
mod tests {
    use super::*;
    use core::f64::consts::TAU;
    use proptest::prelude::*;

    proptest! {
        // Independent: the platform's own sine and cosine.
        #[test]
        fn sine_and_cosine_of_turns_are_those_of_the_angle(turns in -0.6_f64..0.6) {
            let (sin, cos) = sin_cos_of_turns(DoubleDouble::from(turns));
            let (s, c) = (turns * TAU).sin_cos();
            prop_assert!((sin - s).abs() < 1e-15 && (cos - c).abs() < 1e-15, "{sin} {s} {cos} {c}");
        }

        #[test]
        fn whole_turns_change_nothing(turns in -0.5_f64..0.5, whole in -(1_i64 << 40)..(1 << 40)) {
            let many = DoubleDouble::sum(whole as f64, turns);
            prop_assert_eq!(sin_cos_of_turns(many), sin_cos_of_turns(DoubleDouble::from(turns)));
        }
    }

    #[test]
    fn quarter_turns_are_exact_and_their_neighbours_keep_all_digits() {
        assert_eq!(sin_cos_of_turns(DoubleDouble::from(0.25)), (1.0, 0.0));
        assert_eq!(sin_cos_of_turns(DoubleDouble::from(-0.25)), (-1.0, 0.0));
        assert_eq!(sin_cos_of_turns(DoubleDouble::from(7.5)).1, -1.0);
        let beyond = 2_f64.powi(-50);
        let (_, cos) = sin_cos_of_turns(DoubleDouble::sum(1e6 + 0.25, beyond));
        assert!((cos / (-TAU * beyond) - 1.0).abs() < 1e-15, "{cos}");
    }
}
