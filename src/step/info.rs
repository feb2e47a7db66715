//! The properties of a method: its order and the quantities that it conserves.

/// A method's name, and its order and conserved quantities in free motion. The order is proven: for the
/// longest splitting, except for the last digits of its decimal weights; for Moser and Veselov's orders 8 and
/// 10, of the equation that the step solves. Each quantity is tested.
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
    /// Its source: a key into the [references](crate::references), or a word.
    pub source: &'static str,
}

/// The quantities of free motion that a method conserves to rounding, and whether it is reversible.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Conserved {
    /// The energy.
    pub energy: bool,
    /// The length of the angular momentum.
    pub momentum: bool,
    /// The angular momentum in the world, including its direction.
    pub direction: bool,
    /// The length of the attitude quaternion.
    pub unit: bool,
    /// A step backward undoes a successful step, or is refused where the iteration of the midpoint rule
    /// or of Gauss's stages hardly converges. It is exact to rounding where the step turns the body by at
    /// most a radian. The splittings of order 4 and 6 go forward and backward within a step, which amplifies
    /// rounding in longer steps: after a step of ten radians, the step backward may lead to a different
    /// state.
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
    /// Everything quadratic in attitude and momentum; the momentum in the world is cubic.
    pub(super) const SQUARES: Self = Self { energy: true, direction: false, ..Self::ALL_BUT_ENERGY };
    pub(super) const ALL: Self = Self { energy: true, ..Self::ALL_BUT_ENERGY };
}
