//! What a step costs: processor instructions, as counted (see [`Cost`](crate::Cost)).

/// A step of Dormand and Prince's pair under a torque, rejected ones included.
pub(crate) const PAIR: f64 = 7000.0;
/// It restarts at each state, with at least this number of steps.
pub(crate) const RESTART: f64 = 2.0;
/// A step of Moser and Veselov's method between two half kicks.
pub(crate) const KICKED: f64 = 1500.0;
/// A step that linearises the damping.
pub(crate) const LINEARISED: f64 = 860.0;
/// A step by the exact drift between two half kicks.
pub(crate) const DRIFT: f64 = 11_000.0;
