//! What is known of a method: its order and the quantities that it conserves.

/// A method's name, and its order and conserved quantities in free motion: the order is proven (that of the
/// longest splitting but for the last digits of its decimal weights), and each quantity is tested.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct MethodInfo {
    /// Its usual name.
    pub name: &'static str,
    /// Errors of free motion at a given time fall as this power of the step. Under a torque a
    /// [`Method`](super::Method) may be of lower order.
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
    /// of Gauss's stages hardly converges. It does so to rounding where the step turns the body by no more
    /// than a radian. A longer step of a splitting of order 4 or 6 goes some way forth and back several times
    /// on itself, which multiplies rounding: of ten radians it may lead back to another state.
    pub reversible: bool,
}

/// The sets of conserved quantities that occur.
impl Conserved {
    pub(super) const NONE: Self =
        Self { energy: false, momentum: false, direction: false, unit: false, reversible: false };
    pub(super) const UNIT: Self = Self { unit: true, ..Self::NONE };
    pub(super) const LENGTHS: Self = Self { momentum: true, ..Self::UNIT };
    pub(super) const MOMENTUM: Self = Self { direction: true, ..Self::LENGTHS };
    pub(super) const ALL_BUT_ENERGY: Self = Self { reversible: true, ..Self::MOMENTUM };
    /// All that is square in attitude and momentum; the momentum in the world is a product of three.
    pub(super) const SQUARES: Self = Self { energy: true, direction: false, ..Self::ALL_BUT_ENERGY };
    pub(super) const ALL: Self = Self { energy: true, ..Self::ALL_BUT_ENERGY };
}
