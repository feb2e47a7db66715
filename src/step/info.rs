//! What is known of a method: its order and the quantities that it conserves.

/// A method's name, order and conserved quantities, as proven or measured by the tests for free motion.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct MethodInfo {
    /// Its usual name.
    pub name: &'static str,
    /// Errors of free motion at a given time fall as this power of the step. Under a torque a [`Method`](super::Method) may
    /// be of lower order.
    pub order: u32,
    /// Whether it solves equations in each step.
    pub implicit: bool,
    /// The quantities of a free motion that it conserves to rounding in every step that it takes: the
    /// implicit methods refuse steps that turn the body too far.
    pub conserved: Conserved,
    /// Where it comes from: a key into the [references](crate::references), or a word.
    pub source: &'static str,
}

/// The quantities of free motion that a method conserves to rounding, and whether it is reversible.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Conserved {
    /// The energy.
    pub energy: bool,
    /// The length of the angular momentum.
    pub momentum: bool,
    /// The angular momentum in the world, direction and all.
    pub direction: bool,
    /// The length of the attitude quaternion.
    pub unit: bool,
    /// A step back undoes every step that is taken, or is refused where the iteration of the midpoint rule or
    /// of Gauss's stages hardly converges.
    pub reversible: bool,
}

impl Conserved {
    /// None of them.
    pub const NONE: Self =
        Self { energy: false, momentum: false, direction: false, unit: false, reversible: false };
}
