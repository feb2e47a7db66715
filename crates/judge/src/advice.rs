//! What a rule is called, who goes by it, and what to do about it.

use crate::catalogue::PHYSICS_ENGINES;
use crate::engines::Limits;
use crate::rules::{Alteration, Base, Rule, Spin, When};
use tumbling::step::Method;

/// A number with five significant digits, as people write it.
pub(crate) fn significant(x: f64) -> String {
    let size = x.abs().log10().floor();
    if x == 0.0 || !x.is_finite() {
        return x.to_string();
    }
    if !(-4.0..9.0).contains(&size) {
        return format!("{x:.4e}");
    }
    let decimals = (4.0 - size).max(0.0) as usize;
    format!("{x:.decimals$}")
}

impl Base {
    /// What it is called.
    #[must_use]
    pub fn name(&self) -> String {
        match self {
            Self::Exact => "the exact motion".into(),
            Self::Method(method, 1) => method.info().name.into(),
            Self::Method(method, parts) => format!("{}, {parts} parts a step", method.info().name),
            Self::Engine(engine) => {
                format!(
                    "{}, with the limits of {} ({})",
                    Self::Method(engine.method, engine.parts).name(),
                    engine.name,
                    limits(&engine.limits)
                )
            }
            Self::FrozenTensor(_) | Self::FrozenAt(..) => "a tensor frozen in the world".into(),
            Self::MomentumForSpin(mass) => {
                format!("momentum taken for spin (divided by {})", significant(*mass))
            }
            Self::Straight(Spin::Kept) => {
                "no gyroscopic term, and the attitude stepped straight (q + h/2 q w)".into()
            }
            Self::Straight(Spin::Explicit) => {
                "explicit gyroscopic step (w + h w'), and the attitude stepped straight by the new spin (q + h/2 q w)".into()
            }
        }
    }
}

impl Base {
    /// What it means for a body, and what to do.
    const fn advice(&self) -> &'static str {
        match self {
            Self::Exact => "Nothing to do: the steps are the motion itself.",
            Self::Method(method, _) => of_method(*method),
            Self::Engine(engine) if engine.limits.rate.is_none() => {
                "The body is too fast for the engine's limits, which slow it or turn it too little: take shorter steps, or raise the \
                 limits. Chapter \"Stepping through time\"."
            }
            Self::Engine(engine) => of_method(engine.method),
            Self::FrozenTensor(_) | Self::FrozenAt(..) => {
                "The spin is stepped in the world with the tensor of the body as it stood at the start: turn the tensor with the \
                 body, R I R^T, at each step. Chapter \"Three pitfalls\", 1."
            }
            Self::MomentumForSpin(_) => {
                "The momentum turns the body as if it were the spin: make the spin from it by the inverse tensor turned to the \
                 world, w = R J R^T L. Chapter \"Three pitfalls\", 2."
            }
            Self::Straight(Spin::Kept) => of_method(Method::ConstantSpin),
            Self::Straight(Spin::Explicit) => {
                "The gyroscopic term is taken at the start of the step and adds energy without bound: a stable spin blows up; and the \
                 straight step turns the body by too little. Turn the momentum instead of adding to it (three exact turns a step), and \
                 the body by the exact turn of its spin, (cos a/2, sin a/2 times the axis). Chapter \"Where things break\", the fix."
            }
        }
    }
}

impl When {
    const fn word(self) -> &'static str {
        match self {
            Self::Before => "before",
            Self::After => "after",
        }
    }
}

impl Alteration {
    /// What it is called.
    #[must_use]
    pub fn name(&self) -> String {
        match self {
            Self::OtherMoments(moments) => {
                let [x, y, z] = moments.map(significant).into();
                format!("other moments ({x}, {y}, {z})")
            }
            Self::Damped(factor, when) => {
                let (lost, when) = (1.0 - factor, when.word());
                format!("damping left on ({lost:.3e} of the spin each step, {when} the rule)")
            }
            Self::DampedByAxis(factors, when) => {
                let [x, y, z] = factors.map(|x| 1.0 - x).into();
                let when = when.word();
                format!(
                    "damping by axis ({x:.3e}, {y:.3e} and {z:.3e} of the spin about the body's axes each step, {when} the rule)"
                )
            }
            Self::SmallTurn(angle) => {
                format!("a threshold for small rotations (no turn of {angle:.3e} rad or less)")
            }
            Self::Zeroed(least) => {
                format!(
                    "small spins put to zero (a component of {least:.3e} rad/s or less about an axis of the body)"
                )
            }
            Self::OtherTurn(factor) => format!("a turn {} times what the spin says", significant(*factor)),
            Self::OtherStep(factor) => {
                format!("steps {} times as long as the record says", significant(*factor))
            }
            Self::Capped(most) => format!("a cap on the spin ({} rad/s)", significant(*most)),
        }
    }

    /// What it means for a body, and what to do.
    const fn advice(&self) -> &'static str {
        match self {
            Self::OtherMoments(..) => {
                "The engine steps a body with other moments than the record says: look for a wrong order of axes, a principal frame \
                 that is left out, or a shape that replaces the moments set. A free body tells their ratios, never their \
                 common scale. Chapter \"Principal axes\"."
            }
            Self::DampedByAxis(..) => {
                "Damping takes spin in each step, about each axis of the body by a factor of its own: set the engine's angular damping to \
                 0 about all of them. Chapter \"Stepping through time\"."
            }
            Self::SmallTurn(..) => {
                "A slow body, or one with short steps, stands still while it has spin: turn by small angles too (the sine of a small \
                 angle over the angle is 1, and no division is needed). Chapter \"Stepping through time\"."
            }
            Self::Zeroed(..) => {
                "A flip starts from a small spin across the axis, and this takes it away: the body spins on about its middle axis for \
                 ever. Take the threshold out, or let the body sleep as a whole. Chapter \"Stepping through time\"."
            }
            Self::OtherTurn(..) => {
                "The attitude does not turn by the spin times the step: look for the half in q' = q w / 2, for a turn made twice, or for \
                 a unit. Chapter \"Stepping through time\"."
            }
            Self::OtherStep(..) => {
                "The engine's step is not the one that the times tell: look for substeps that are not recorded, for steps recorded twice, \
                 or for a time scale. Chapter \"Stepping through time\"."
            }
            Self::Damped(..) => {
                "Damping takes spin in each step: set the engine's angular damping to 0. Chapter \"Stepping through time\"."
            }
            Self::Capped(..) => {
                "The spin is cut off at a limit: raise the engine's greatest angular velocity."
            }
        }
    }
}

impl Rule {
    /// What it is called.
    #[must_use]
    pub fn name(&self) -> String {
        match &self.alteration {
            Some(alteration) => format!("{}, {}", alteration.name(), self.base.name()),
            None => self.base.name(),
        }
    }

    /// Physics engines known to go by it, with their settings.
    #[must_use]
    pub fn engines(&self) -> Vec<String> {
        PHYSICS_ENGINES
            .iter()
            .filter(|engine| match (self.base, self.alteration) {
                (Base::Method(method, parts), None) => (engine.method, engine.parts) == (method, parts),
                (Base::Engine(this), None) => {
                    (engine.method, engine.parts, engine.limits) == (this.method, this.parts, this.limits)
                }
                _ => false,
            })
            .map(|engine| match engine.version {
                Some(version) => format!("{} {version}, {}", engine.name, engine.setting),
                None => format!("{}, {}", engine.name, engine.setting),
            })
            .collect()
    }

    /// What it means for a body, and what to do.
    #[must_use]
    pub fn advice(&self) -> &'static str {
        self.alteration.as_ref().map_or_else(|| self.base.advice(), Alteration::advice)
    }
}

fn limits(limits: &Limits) -> String {
    let mut all = Vec::new();
    if let Some(angle) = limits.turn {
        all.push(format!("a step beyond {:.0} degrees turns too little", angle.to_degrees()));
    }
    if let Some(most) = limits.component {
        all.push(format!("spin is cut at {most:.1} rad/s along each axis of the world"));
    }
    if let Some(angle) = limits.spin {
        all.push(format!("spin is slowed to {:.0} degrees a step", angle.to_degrees()));
    }
    if let Some(most) = limits.rate {
        all.push(format!("put back beyond {most:e} rad/s2"));
    }
    all.join("; ")
}

const fn of_method(method: Method) -> &'static str {
    match method {
        Method::ConstantSpin => {
            "There is no gyroscopic term: a body never flips and its momentum wanders (a record of the spin looks the same where the \
             momentum is taken for the spin). Turn gyroscopic forces on, or add w x I w. Chapter \"Three pitfalls\", 3."
        }
        Method::SemiImplicitEuler => {
            "The gyroscopic term is taken at the start of the step and adds energy without bound: a stable spin blows up. Turn the \
             momentum instead of adding to it (three exact turns a step, or Buss's method). Chapter \"Where things break\", the fix."
        }
        Method::Rescaled | Method::RescaledLinearAttitude => {
            "The momentum's length is put right after an explicit step, its energy is not: a stable spin drifts \
             toward the separatrix, and flips. Turn the momentum instead (three exact turns a step keep the length without \
             rescaling). Chapter \"Where things break\", the fix."
        }
        Method::ImplicitOneNewton | Method::LinearisedImplicit => {
            "One implicit step takes energy and momentum from most bodies that tumble, so that they slow down by themselves; of a step \
             that turns by a radian or more it can multiply the energy. Use the implicit midpoint rule or three exact turns a step. Chapter \"Where things break\", the fix."
        }
        Method::MeanSpinRungeKutta4 => {
            "The spin is of order 4, the attitude of order 2: the momentum wanders in the world. Correct the stages' spins to the turn \
             since the start of the step. Chapter \"Stepping through time\"."
        }
        Method::ExplicitEuler => {
            "Everything is stepped straight ahead, the crudest of all: take any other method. Chapter \"Stepping through time\"."
        }
        Method::RungeKutta4 | Method::DormandPrince5 | Method::TurnedRungeKutta4 | Method::MuntheKaas4 => {
            "A good method whose errors fall fast with the step, and add up: for long runs take one that keeps the laws. \
             Chapter \"Stepping through time\"."
        }
        _ => {
            "A method that keeps what it says it keeps; what is left is an error of phase. Chapter \"Stepping through time\"."
        }
    }
}
