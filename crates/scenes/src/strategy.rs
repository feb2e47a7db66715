//! The ways to answer for a body.

use tumbling::step::Stepper;

/// The ways to answer, the cheapest first.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[non_exhaustive]
pub enum Strategy {
    /// No output that moves is requested: all of it follows from what is conserved.
    Nothing,
    /// The outputs are constant: the spin of a steady motion, and the attitude of a body at rest.
    Constant,
    /// A steady rotation about a fixed axis.
    Rotation,
    /// Two equal moments: sines and cosines.
    SymmetricTop,
    /// Three different moments, the spin alone: Jacobi's functions.
    EllipticSpin,
    /// The attitude too: theta functions.
    Elliptic,
    /// Taylor series with their error controlled; collocation where damping is much faster than the motion.
    Adaptive,
}

/// A body under torques: how it is stepped, and what the trial runs showed.
#[derive(Debug, Clone)]
pub struct Driven {
    /// At the start.
    pub(crate) stepper: Stepper,
    /// Times at which steps end besides those requested, as they did in the trial runs; none where states are
    /// taken from series.
    pub(crate) stops: Vec<f64>,
    pub(crate) tolerance: f64,
    pub(crate) difference: f64,
    pub(crate) steps: usize,
    /// The instructions of all trial runs.
    pub(crate) trials: f64,
    /// Whether damping is much faster than the motion.
    pub(crate) stiff: bool,
}

impl Driven {
    /// The largest difference between two trial runs: the one that is taken and one of another tolerance.
    #[must_use]
    pub fn observed_difference(&self) -> f64 {
        self.difference
    }

    /// The number of steps of the run that is taken.
    #[must_use]
    pub fn steps(&self) -> usize {
        self.steps
    }
}
