//! What is known of a method: its order and the quantities that it conserves.

use super::method::Method;

/// A method's name, order and conserved quantities, as the tests find them for free motion.
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

impl Method {
    /// Its name, order and conserved quantities.
    #[must_use]
    pub const fn info(self) -> MethodInfo {
        const ENGINES: &str = "a rule of physics engines";
        const EXPLICIT: bool = false;
        const IMPLICIT: bool = true;
        let (name, order, implicit, conserved, source) = match self {
            Self::ExplicitEuler => ("explicit Euler", 1, EXPLICIT, Conserved::NONE, "Eul68"),
            Self::RungeKutta4 => ("Runge-Kutta 4", 4, EXPLICIT, Conserved::NONE, "Kut01"),
            Self::DormandPrince5 => ("Dormand-Prince 5", 5, EXPLICIT, Conserved::NONE, "DP80"),
            Self::MuntheKaas4 => ("Munthe-Kaas 4", 4, EXPLICIT, Conserved::MOMENTUM, "MK98"),
            Self::Buss => ("Buss's augmented", 2, EXPLICIT, Conserved::MOMENTUM, "Bus00"),
            Self::Spiral => ("SPIRAL", 2, EXPLICIT, Conserved::UNIT, "Val24"),
            Self::ImplicitMidpoint => ("implicit midpoint", 2, IMPLICIT, Conserved::ALL, "HLW06"),
            Self::Gauss4 => ("Gauss 4", 4, IMPLICIT, Conserved::SQUARES, "But64"),
            Self::Gauss6 => ("Gauss 6", 6, IMPLICIT, Conserved::SQUARES, "But64"),
            Self::RotationSplitting2 => ("three rotations", 2, EXPLICIT, Conserved::ALL_BUT_ENERGY, "McL93"),
            Self::RotationSplitting4 => {
                ("three rotations, 7 in 1", 4, EXPLICIT, Conserved::ALL_BUT_ENERGY, "our own weights")
            }
            Self::RotationSplitting6 => {
                ("three rotations, 9 in 1", 6, EXPLICIT, Conserved::ALL_BUT_ENERGY, "KL97")
            }
            Self::SymmetricTop => ("symmetric top", 2, EXPLICIT, Conserved::ALL_BUT_ENERGY, "DLM97"),
            Self::MoserVeselov2 => ("Moser-Veselov", 2, IMPLICIT, Conserved::ALL, "MV91"),
            Self::MoserVeselov4 => ("Moser-Veselov 4", 4, IMPLICIT, Conserved::ALL, "HV06"),
            Self::MoserVeselov6 => ("Moser-Veselov 6", 6, IMPLICIT, Conserved::ALL, "HV06"),
            Self::MoserVeselov8 => ("Moser-Veselov 8", 8, IMPLICIT, Conserved::ALL, "HV06"),
            Self::MoserVeselov10 => ("Moser-Veselov 10", 10, IMPLICIT, Conserved::ALL, "HV06"),
            Self::ConstantSpin => ("no gyroscopic term", 0, EXPLICIT, Conserved::SQUARES, ENGINES),
            Self::SemiImplicitEuler => ("explicit gyroscopic step", 1, EXPLICIT, Conserved::UNIT, ENGINES),
            Self::Rescaled => ("explicit, rescaled", 1, EXPLICIT, Conserved::LENGTHS, ENGINES),
            Self::RescaledLinearAttitude => {
                ("rescaled, turned straight", 1, EXPLICIT, Conserved::LENGTHS, ENGINES)
            }
            Self::ImplicitOneNewton => ("one Newton step", 1, IMPLICIT, Conserved::UNIT, "Cat15"),
            Self::LinearisedImplicit => ("linearised implicit", 1, IMPLICIT, Conserved::UNIT, ENGINES),
            Self::MeanSpinRungeKutta4 => ("Runge-Kutta 4, mean spin", 2, EXPLICIT, Conserved::UNIT, ENGINES),
            Self::TurnedRungeKutta4 => ("Runge-Kutta 4, turned", 4, EXPLICIT, Conserved::UNIT, "MK98"),
        };
        MethodInfo { name, order, implicit, conserved, source }
    }
}
