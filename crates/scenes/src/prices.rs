//! What a step costs: processor instructions, as counted (see [`Cost`](crate::Cost)).

/// A step of Dormand and Prince's pair under a torque, rejected ones included.
pub(crate) const PAIR: f64 = 3900.0;
/// It restarts at each state, with at least this number of steps.
pub(crate) const RESTART: f64 = 2.0;
/// A step of Moser and Veselov's method between two half kicks.
pub(crate) const KICKED: f64 = 1500.0;
/// A step that linearises the damping.
pub(crate) const LINEARISED: f64 = 860.0;
/// A step by the exact drift between two half kicks.
pub(crate) const DRIFT: f64 = 11_000.0;

/// The fifth root of a number above zero, for estimates: of rounded operations alone, so that every machine
/// plans alike.
pub(crate) fn fifth_root(x: f64) -> f64 {
    // y^4 = x/y: each round leaves a quarter of the logarithm's error.
    (0..16).fold(x.sqrt().sqrt(), |root, _| (x / root).sqrt().sqrt())
}
