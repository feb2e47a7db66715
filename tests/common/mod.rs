//! Shared by the tests: exact arithmetic, and what bodies and motions are drawn from.

pub mod same_bits;

use nalgebra::{Matrix3, UnitQuaternion, Vector3};
use num_rational::BigRational;
use num_traits::{ToPrimitive, Zero};
use proptest::prelude::*;
use tumbling::exact::FreeMotion;
use tumbling::step::{System, Torque};
use tumbling::{Error, ErrorKind, PrincipalMoments};

pub type Exact = BigRational;

/// Asserts that a result is an error of this kind whose sentence contains `words`; returns the error.
#[track_caller]
pub fn refused<T: std::fmt::Debug>(result: Result<T, Error>, kind: ErrorKind, words: &str) -> Error {
    let error = result.expect_err(words);
    let sentence = error.to_string();
    assert!(!sentence.contains("  "), "{sentence}");
    assert!(
        error.kind() == kind && sentence.contains(words),
        "{:?}, not {kind:?} with '{words}': {sentence}",
        error.kind()
    );
    error
}

/// The body with these moments, free of torque.
pub fn free(moments: impl Into<[f64; 3]>) -> System<f64> {
    under(moments, Vec::new())
}

/// The body with these moments under torques.
pub fn under(moments: impl Into<[f64; 3]>, torques: Vec<Torque<f64>>) -> System<f64> {
    System::with(PrincipalMoments::try_from(moments.into()).unwrap(), torques).unwrap()
}

/// The free motion of the body with these moments from this spin.
pub fn free_motion(moments: impl Into<[f64; 3]>, omega: &Vector3<f64>) -> FreeMotion {
    FreeMotion::new(PrincipalMoments::try_from(moments.into()).unwrap(), omega).unwrap()
}

/// The number after `words` in a sentence.
#[track_caller]
pub fn number_after(sentence: &impl ToString, words: &str) -> f64 {
    let sentence = sentence.to_string();
    let (_, rest) = sentence.split_once(words).expect(words);
    let end = rest.find(|c: char| !c.is_ascii_digit() && !".e-".contains(c)).unwrap_or(rest.len());
    rest[..end].parse().expect(&sentence)
}

/// The exact value of a finite `f64`.
pub fn exact(x: f64) -> Exact {
    Exact::from_float(x).expect("finite")
}

pub fn exact_matrix(m: &Matrix3<f64>) -> [[Exact; 3]; 3] {
    std::array::from_fn(|i| std::array::from_fn(|j| exact(m[(i, j)])))
}

pub fn exact_vector(v: &Vector3<f64>) -> [Exact; 3] {
    std::array::from_fn(|i| exact(v[i]))
}

/// The nearest `f64`, or one next to it.
pub fn rounded(x: &Exact) -> f64 {
    x.to_f64().expect("a number")
}

pub fn times(m: &[[Exact; 3]; 3], v: &[Exact; 3]) -> [Exact; 3] {
    std::array::from_fn(|i| dot(&m[i], v))
}

pub fn dot(a: &[Exact; 3], b: &[Exact; 3]) -> Exact {
    (0..3).map(|i| &a[i] * &b[i]).fold(Exact::zero(), |sum, x| sum + x)
}

pub fn cross(a: &[Exact; 3], b: &[Exact; 3]) -> [Exact; 3] {
    std::array::from_fn(|i| {
        let (j, k) = ((i + 1) % 3, (i + 2) % 3);
        &a[j] * &b[k] - &a[k] * &b[j]
    })
}

pub fn determinant(m: &[[Exact; 3]; 3]) -> Exact {
    dot(&m[0], &cross(&m[1], &m[2]))
}

/// The determinant of `m - x 1`: zero exactly at the eigenvalues, with one sign between two of them.
pub fn characteristic(m: &[[Exact; 3]; 3], x: &Exact) -> Exact {
    let shifted =
        std::array::from_fn(|i| std::array::from_fn(|j| if i == j { &m[i][j] - x } else { m[i][j].clone() }));
    determinant(&shifted)
}

/// Principal moments of a possible body, not sorted: from three positive "half moments" `sum m x²`.
pub fn moments() -> impl Strategy<Value = Vector3<f64>> {
    (0.05..1.0, 0.05..1.0, 0.05..1.0).prop_map(|(x, y, z): (f64, f64, f64)| Vector3::new(y + z, z + x, x + y))
}

pub fn attitude() -> impl Strategy<Value = UnitQuaternion<f64>> {
    (-3.0..3.0, -1.5..1.5, -3.0..3.0)
        .prop_map(|(roll, pitch, yaw)| UnitQuaternion::from_euler_angles(roll, pitch, yaw))
}

pub fn vector(range: f64) -> impl Strategy<Value = Vector3<f64>> {
    (-range..range, -range..range, -range..range).prop_map(|(x, y, z)| Vector3::new(x, y, z))
}

/// A spin of up to 1 rad/s without a small component, so that no motion of it is a special case.
pub fn generic_spin() -> impl Strategy<Value = Vector3<f64>> {
    let component = || (0.2..1.0_f64, any::<bool>()).prop_map(|(x, back)| if back { -x } else { x });
    (component(), component(), component()).prop_map(|(x, y, z)| Vector3::new(x, y, z))
}

/// Any `f64` at all: NaN, infinities, subnormals, zeros of both signs.
pub fn anything() -> impl Strategy<Value = f64> {
    prop_oneof![
        4 => any::<f64>(),
        1 => prop::sample::select(vec![
            0.0, -0.0, 1.0, -1.0, f64::NAN, f64::INFINITY, f64::NEG_INFINITY, f64::MAX, f64::MIN,
            f64::MIN_POSITIVE, 5e-324, -5e-324, 1e-200, 1e150, 1e300,
        ]),
        2 => -10.0..10.0,
    ]
}

pub fn any_vector() -> impl Strategy<Value = Vector3<f64>> {
    (anything(), anything(), anything()).prop_map(|(x, y, z)| Vector3::new(x, y, z))
}

/// The tensor with these moments about the axes that `axes` turns the body's to, made exactly symmetric.
pub fn turned(moments: &Vector3<f64>, axes: impl Into<Matrix3<f64>>) -> Matrix3<f64> {
    let axes = axes.into();
    let tensor = axes * Matrix3::from_diagonal(moments) * axes.transpose();
    (tensor + tensor.transpose()) * 0.5
}

/// The step from `x` to the next larger number.
pub fn ulp(x: f64) -> f64 {
    x.abs().next_up() - x.abs()
}
