//! What a step costs: processor instructions, as counted (see [`Cost`](crate::Cost)).

/// A step by Taylor series under a torque, rejected ones included, whose order rises with the digits of the
/// tolerance.
pub(crate) fn series(tolerance: f64) -> f64 {
    let binary_digits = 1023.0 - (tolerance.to_bits() >> 52 & 0x7ff) as f64;
    let order = 5.0 + 0.4 * binary_digits;
    2200.0 + 37.0 * order * order
}
/// It turns the body by about this many radians, whatever the tolerance.
pub(crate) const RADIANS: f64 = 1.6;
/// A run of such steps, before the first.
pub(crate) const BEGIN: f64 = 35_000.0;
/// A state between the ends of two such steps.
pub(crate) const WITHIN: f64 = 500.0;
/// A step by collocation takes as long as this number of steps by series.
pub(crate) const COLLOCATION: f64 = 3.5;
/// A step by the exact drift between two half kicks.
pub(crate) const DRIFT: f64 = 11_000.0;
