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
    /// Its source: a key into the [references](crate::references), or a word.
    pub source: &'static str,
    /// Whether it conserves the energy of a free motion to rounding, in every step that it takes: the
    /// implicit methods refuse steps that turn the body too far.
    pub energy: bool,
    /// Whether it conserves the length of the angular momentum, likewise.
    pub momentum: bool,
    /// Whether it conserves the angular momentum in the world, including its direction, likewise.
    pub direction: bool,
    /// Whether it conserves the length of the attitude quaternion, likewise.
    pub unit: bool,
    /// A step backward undoes a successful step, or is refused where the iteration of the midpoint rule
    /// or of Gauss's stages hardly converges. It is exact to rounding where the step turns the body by at
    /// most a radian. The splittings of order 4 and 6 go forward and backward within a step, which amplifies
    /// rounding in longer steps: after a step of ten radians, the step backward may lead to a different
    /// state.
    pub reversible: bool,
}

/// The sets of properties that occur: whether a method conserves the energy, the length of the momentum, its
/// direction and the length of the attitude, and whether it is reversible.
pub(super) type Kept = [bool; 5];
pub(super) const NONE: Kept = [false; 5];
pub(super) const UNIT: Kept = [false, false, false, true, false];
pub(super) const LENGTHS: Kept = [false, true, false, true, false];
pub(super) const MOMENTUM: Kept = [false, true, true, true, false];
pub(super) const ALL_BUT_ENERGY: Kept = [false, true, true, true, true];
/// Everything quadratic in attitude and momentum; the momentum in the world is cubic.
pub(super) const SQUARES: Kept = [true, true, false, true, true];
pub(super) const ALL: Kept = [true; 5];
