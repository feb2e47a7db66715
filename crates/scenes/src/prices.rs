//! What a step costs: processor instructions, as counted (see [`Cost`](crate::Cost)).

/// A step by Taylor series under a torque, rejected ones included, whose order rises with the digits of the
/// tolerance.
fn series(tolerance: f64) -> f64 {
    let binary_digits = 1023.0 - (tolerance.to_bits() >> 52 & 0x7ff) as f64;
    let order = 5.0 + 0.4 * binary_digits;
    2200.0 + 37.0 * order * order
}
/// It turns the body by about this many radians, whatever the tolerance.
pub(crate) const RADIANS: f64 = 1.6;

/// A number of states in a number of such steps, most of them by collocation where damping is stiff.
pub(crate) fn run(tolerance: f64, states: u64, steps: usize, stiff: bool) -> f64 {
    // Before the first step; for a state between the ends of two; and a collocation in steps by series.
    const BEGIN: f64 = 35_000.0;
    const WITHIN: f64 = 500.0;
    let dearer = if stiff { 3.5 } else { 1.0 };
    BEGIN + dearer * series(tolerance) * steps as f64 + WITHIN * states as f64
}
