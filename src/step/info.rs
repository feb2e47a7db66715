//! What is known of a method: its order and the quantities that it conserves.

use super::method::Method;
use Conserved as C;
use Method as M;

/// A method's name, and its order and conserved quantities in free motion: the order is proven, and each
/// quantity is tested.
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
    const NONE: Self =
        Self { energy: false, momentum: false, direction: false, unit: false, reversible: false };
    const UNIT: Self = Self { unit: true, ..Self::NONE };
    const LENGTHS: Self = Self { momentum: true, ..Self::UNIT };
    const MOMENTUM: Self = Self { direction: true, ..Self::LENGTHS };
    const ALL_BUT_ENERGY: Self = Self { reversible: true, ..Self::MOMENTUM };
    /// All that is square in attitude and momentum; the momentum in the world is a product of three.
    const SQUARES: Self = Self { energy: true, direction: false, ..Self::ALL_BUT_ENERGY };
    const ALL: Self = Self { energy: true, ..Self::ALL_BUT_ENERGY };
}

const ENGINES: &str = "a rule of physics engines";
const EXPLICIT: bool = false;
const IMPLICIT: bool = true;

type Row = (Method, &'static str, u32, bool, Conserved, &'static str);

/// All methods in the order of their enum: name, order, kind of equations, conserved quantities, source.
const METHODS: [Row; 26] = [
    (M::ExplicitEuler, "explicit Euler", 1, EXPLICIT, C::NONE, "Eul68"),
    (M::RungeKutta4, "Runge-Kutta 4", 4, EXPLICIT, C::NONE, "Kut01"),
    (M::DormandPrince5, "Dormand-Prince 5", 5, EXPLICIT, C::NONE, "DP80"),
    (M::MuntheKaas4, "Munthe-Kaas 4", 4, EXPLICIT, C::MOMENTUM, "MK98"),
    (M::Buss, "Buss's augmented", 2, EXPLICIT, C::MOMENTUM, "Bus00"),
    (M::Spiral, "SPIRAL", 2, EXPLICIT, C::UNIT, "Val24"),
    (M::ImplicitMidpoint, "implicit midpoint", 2, IMPLICIT, C::ALL, "HLW06"),
    (M::Gauss4, "Gauss 4", 4, IMPLICIT, C::SQUARES, "But64"),
    (M::Gauss6, "Gauss 6", 6, IMPLICIT, C::SQUARES, "But64"),
    (M::RotationSplitting2, "three rotations", 2, EXPLICIT, C::ALL_BUT_ENERGY, "McL93"),
    (M::RotationSplitting4, "three rotations, 7 in 1", 4, EXPLICIT, C::ALL_BUT_ENERGY, "our own weights"),
    (M::RotationSplitting6, "three rotations, 9 in 1", 6, EXPLICIT, C::ALL_BUT_ENERGY, "KL97"),
    (M::SymmetricTop, "symmetric top", 2, EXPLICIT, C::ALL_BUT_ENERGY, "DLM97"),
    (M::MoserVeselov2, "Moser-Veselov", 2, IMPLICIT, C::ALL, "MV91"),
    (M::MoserVeselov4, "Moser-Veselov 4", 4, IMPLICIT, C::ALL, "HV06"),
    (M::MoserVeselov6, "Moser-Veselov 6", 6, IMPLICIT, C::ALL, "HV06"),
    (M::MoserVeselov8, "Moser-Veselov 8", 8, IMPLICIT, C::ALL, "HV06"),
    (M::MoserVeselov10, "Moser-Veselov 10", 10, IMPLICIT, C::ALL, "HV06"),
    (M::ConstantSpin, "no gyroscopic term", 0, EXPLICIT, C::SQUARES, ENGINES),
    (M::SemiImplicitEuler, "explicit gyroscopic step", 1, EXPLICIT, C::UNIT, ENGINES),
    (M::Rescaled, "explicit, rescaled", 1, EXPLICIT, C::LENGTHS, ENGINES),
    (M::RescaledLinearAttitude, "rescaled, turned straight", 1, EXPLICIT, C::LENGTHS, ENGINES),
    (M::ImplicitOneNewton, "one Newton step", 1, IMPLICIT, C::UNIT, "Cat15"),
    (M::LinearisedImplicit, "linearised implicit", 1, IMPLICIT, C::UNIT, ENGINES),
    (M::MeanSpinRungeKutta4, "Runge-Kutta 4, mean spin", 2, EXPLICIT, C::UNIT, ENGINES),
    (M::TurnedRungeKutta4, "Runge-Kutta 4, turned", 4, EXPLICIT, C::UNIT, "MK98"),
];

impl Method {
    /// Its name, order and conserved quantities.
    #[must_use]
    pub const fn info(self) -> MethodInfo {
        let (_, name, order, implicit, conserved, source) = METHODS[self as usize];
        MethodInfo { name, order, implicit, conserved, source }
    }

    /// All of them.
    pub const ALL: &[Self] = &{
        let mut all = [Self::ExplicitEuler; METHODS.len()];
        let mut i = 0;
        while i < all.len() {
            all[i] = METHODS[i].0;
            i += 1;
        }
        all
    };
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn each_method_has_its_own_row() {
        for (i, &method) in Method::ALL.iter().enumerate() {
            assert_eq!(method as usize, i, "{method:?}");
        }
    }
}
