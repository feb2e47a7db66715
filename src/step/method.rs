//! The methods of stepping: each with its name, order, conserved quantities and step.

use super::info::{ALL, ALL_BUT_ENERGY, LENGTHS, MOMENTUM, MethodInfo, NONE, SQUARES, UNIT};
use super::methods::{averaged, engine_rules, gauss, moser_veselov, runge_kutta, splitting};
use crate::body::State;
use crate::error::{Error, Refusal, Subject};
use crate::number::Analytic;
use crate::step::system::System;
use core::fmt;
use nalgebra::Vector3;

/// The methods, each in one row: its [`MethodInfo`], and its step.
macro_rules! methods {
    ($(#[$meta:meta])* |$system:ident, $start:ident, $h:ident| $(
        $(#[$doc:meta])* $Name:ident(
            $name:literal, $order:literal, $implicit:ident, $kept:ident, $source:expr
        ) => $step:expr;
    )*) => {
        $(#[$meta])*
        pub enum Method {
            $($(#[$doc])* $Name,)*
        }

        impl Method {
            /// All of them.
            pub const ALL: &[Self] = &[$(Self::$Name),*];

            /// Its name, order and conserved quantities.
            #[must_use]
            pub const fn info(self) -> MethodInfo {
                let (name, order, implicit, kept, source) = match self {
                    $(Self::$Name => ($name, $order, $implicit, $kept, $source),)*
                };
                let [energy, momentum, direction, unit, reversible] = kept;
                MethodInfo { name, order, implicit, source, energy, momentum, direction, unit, reversible }
            }

            #[inline(always)]
            fn end<T: Analytic>(
                self, $system: &System<T>, $start: &State<T>, $h: &T,
            ) -> Result<State<T>, Error> {
                Ok(match self {
                    $(Self::$Name => $step,)*
                })
            }
        }
    };
}

const ENGINES: &str = "a rule of physics engines";
const EXPLICIT: bool = false;
const IMPLICIT: bool = true;

methods! {
    /// A way to step a body through time.
    ///
    /// One step advances a [`State`] (attitude, and angular momentum in body axes) by `h` seconds. No other
    /// data is kept between steps, so a run may be stopped, stored and resumed at any step, and the step size
    /// may change.
    ///
    /// Which one to choose: for a fixed rate such as 60 Hz, [`fixed_rate`](fn@crate::step::fixed_rate), or,
    /// unless the body is a needle, [`RotationSplitting4`](Self::RotationSplitting4), which is a few
    /// lines in any language; for accuracy under smooth torques, and for needles in `f32`,
    /// [`Gauss6`](Self::Gauss6); for
    /// an error tolerance instead of a step, [`Stepper::adaptive`](crate::step::Stepper::adaptive). Free
    /// motion needs no steps: see [`exact`](crate::exact). The rules of physics engines, from
    /// [`ConstantSpin`](Self::ConstantSpin) on, are included for comparison; `PHYSICS_ENGINES` in the crate
    /// `tumbling-judge` lists which engine uses which.
    ///
    /// [Order](crate::step::MethodInfo::order) and conserved quantities are those of free motion. Under a
    /// torque, the methods that apply it as half kicks before and after the free step (Buss, SPIRAL, rotation
    /// splitting, symmetric top, Moser-Veselov) are of order 2.
    #[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
    #[non_exhaustive]

    |system, start, h|
    /// Straight ahead along the rates at the start.
    ExplicitEuler("explicit Euler", 1, EXPLICIT, NONE, "Eul68") => runge_kutta::euler(system, start, h);
    /// The classical Runge-Kutta method, without renormalising the attitude.
    RungeKutta4("Runge-Kutta 4", 4, EXPLICIT, NONE, "Kut01") => runge_kutta::rk4_step(system, start, h);
    /// The step of order 5 of Dormand and Prince's pair, without renormalising the attitude.
    DormandPrince5("Dormand-Prince 5", 5, EXPLICIT, NONE, "DP80") => runge_kutta::dormand_prince(system, start, h);
    /// Runge-Kutta for the rotation vector since the start of the step, so that the attitude stays a rotation
    /// and a free body keeps its momentum in the world. It accepts every needle, but turns long ones wrongly:
    /// in `f32`, a solid rod of 100 diameters that spins at 10 rad/s, stepped at 60 Hz for ten seconds, is
    /// off by more than a radian.
    MuntheKaas4("Munthe-Kaas 4", 4, EXPLICIT, MOMENTUM, "MK98") => runge_kutta::munthe_kaas(system, start, h);
    /// Buss's augmented method: one turn by an averaged spin, the momentum kept in the world.
    Buss("Buss's augmented", 2, EXPLICIT, MOMENTUM, "Bus00") => averaged::buss(system, start, h);
    /// SPIRAL, in its synchronous form.
    Spiral("SPIRAL", 2, EXPLICIT, UNIT, "Val24") => averaged::spiral(system, start, h);
    /// The implicit midpoint rule, attitude and momentum turned as one.
    ImplicitMidpoint("implicit midpoint", 2, IMPLICIT, ALL, "HLW06") => gauss::midpoint(system, start, h)?;
    /// Gauss's collocation with two stages.
    Gauss4("Gauss 4", 4, IMPLICIT, SQUARES, "But64") => gauss::collocated(system, start, h, &gauss::order_4())?;
    /// Gauss's collocation with three stages.
    Gauss6("Gauss 6", 6, IMPLICIT, SQUARES, "But64") => gauss::collocated(system, start, h, &gauss::order_6())?;
    /// An exact turn about each principal axis, there and back.
    RotationSplitting2("three rotations", 2, EXPLICIT, ALL_BUT_ENERGY, "McL93") => splitting::order_2(system, start, h);
    /// Seven steps of [`RotationSplitting2`](Self::RotationSplitting2) in one. It accepts every needle, but
    /// turns long ones wrongly: in `f32`, a solid rod of 1000 diameters that spins at 10 rad/s, stepped at 60
    /// Hz for ten seconds, is off by more than a tenth of a radian.
    RotationSplitting4("three rotations, 7 in 1", 4, EXPLICIT, ALL_BUT_ENERGY, "our own weights") => splitting::order_4(system, start, h);
    /// Nine steps of [`RotationSplitting2`](Self::RotationSplitting2) in one.
    RotationSplitting6("three rotations, 9 in 1", 6, EXPLICIT, ALL_BUT_ENERGY, "KL97") => splitting::order_6(system, start, h);
    /// The exact motion of a symmetric top, and turns that correct for the difference. Best for bodies whose
    /// first two moments are the closest to each other.
    SymmetricTop("symmetric top", 2, EXPLICIT, ALL_BUT_ENERGY, "DLM97") => splitting::symmetric_top(system, start, h);
    /// The discrete Moser-Veselov algorithm. It and the four after it refuse a step that turns the body by a
    /// quarter turn or more, and needles whose smallest moment is below 1000 roundings of the others: in
    /// `f32` a rod longer than 112 of its diameters. Step such a rod in `f64`.
    MoserVeselov2("Moser-Veselov", 2, IMPLICIT, ALL, "MV91") => moser_veselov::step(system, start, h, 2)?;
    /// Moser and Veselov's algorithm with the moments preprocessed to order 4.
    MoserVeselov4("Moser-Veselov 4", 4, IMPLICIT, ALL, "HV06") => moser_veselov::step(system, start, h, 4)?;
    /// Moser and Veselov's algorithm with the moments preprocessed to order 6.
    MoserVeselov6("Moser-Veselov 6", 6, IMPLICIT, ALL, "HV06") => moser_veselov::step(system, start, h, 6)?;
    /// Moser and Veselov's algorithm with the moments preprocessed to order 8.
    MoserVeselov8("Moser-Veselov 8", 8, IMPLICIT, ALL, "HV06") => moser_veselov::step(system, start, h, 8)?;
    /// Moser and Veselov's algorithm with the moments preprocessed to order 10.
    MoserVeselov10("Moser-Veselov 10", 10, IMPLICIT, ALL, "HV06") => moser_veselov::step(system, start, h, 10)?;
    /// No gyroscopic term: the spin is carried unchanged in the world and turns the attitude. Energy and
    /// `|L|` stay, but the spin never flips or precesses, and the momentum direction changes unless the body
    /// spins along a principal axis. No step is small enough to avoid this, so its order is 0.
    ConstantSpin("no gyroscopic term", 0, EXPLICIT, SQUARES, ENGINES) => engine_rules::constant_spin(system, start, h);
    /// An explicit gyroscopic step of the momentum, then a turn by the new spin. A wobbling body gains energy
    /// in each step, so that its wobble grows.
    SemiImplicitEuler("explicit gyroscopic step", 1, EXPLICIT, UNIT, ENGINES) => engine_rules::semi_implicit(system, start, h);
    /// An explicit gyroscopic step, with the momentum brought back to its length before the turn. It keeps
    /// `|L|` and turns a body that spins stably about its largest moment toward the middle one.
    Rescaled("explicit, rescaled", 1, EXPLICIT, LENGTHS, ENGINES) => engine_rules::rescaled(system, start, h, engine_rules::turned);
    /// [`Rescaled`](Self::Rescaled), with the attitude moved straight along its rate and normalised.
    RescaledLinearAttitude("rescaled, turned straight", 1, EXPLICIT, LENGTHS, ENGINES) => engine_rules::rescaled(system, start, h, engine_rules::turned_straight);
    /// One Newton step of implicit Euler for the gyroscopic term, the torques applied apart from it
    /// [Cat15](crate::references). It takes energy and momentum from most bodies that tumble; a step that
    /// turns by a radian or more can multiply the energy.
    ImplicitOneNewton("one Newton step", 1, IMPLICIT, UNIT, "Cat15") => engine_rules::one_newton(system, start, h);
    /// Implicit Euler linearised at the start, with the torques inside the equation, and with the derivative
    /// of the damping only. For a free body it equals [`ImplicitOneNewton`](Self::ImplicitOneNewton).
    LinearisedImplicit("linearised implicit", 1, IMPLICIT, UNIT, ENGINES) => engine_rules::linearised(system, start, h);
    /// Runge-Kutta 4 for the spin, one turn by the mean of its four spins. The spin is right to the fourth
    /// order, the attitude to the second.
    MeanSpinRungeKutta4("Runge-Kutta 4, mean spin", 2, EXPLICIT, UNIT, ENGINES) => engine_rules::runge_kutta_4(system, start, h, |_, omega| omega.clone());
    /// Runge-Kutta 4 with each of the four spins corrected to the rate of the turn since the step's start, as
    /// [MK98](crate::references). Unlike [`MuntheKaas4`](Self::MuntheKaas4) it steps the momentum in body
    /// axes.
    TurnedRungeKutta4("Runge-Kutta 4, turned", 4, EXPLICIT, UNIT, "MK98") => engine_rules::runge_kutta_4(system, start, h, engine_rules::turn_rate);
}

impl Method {
    /// One step of `h` seconds: backward in time if `h` is negative; if it is zero, the result is the start,
    /// to rounding.
    ///
    /// The attitude should have length 1. This is not checked; a torque that depends on the attitude is
    /// proportional to the square of the length.
    ///
    /// ```
    /// use nalgebra::{Quaternion, Vector3};
    /// use tumbling::PrincipalMoments;
    /// use tumbling::step::{Method, State, System};
    /// let system = System::free(PrincipalMoments::new(1.0, 2.0, 2.5)?)?;
    /// let start = State { attitude: Quaternion::identity(), momentum: Vector3::new(0.0, 4.0, 0.0) };
    /// for &method in Method::ALL {
    ///     // A steady spin of 2 rad/s about the middle axis stays one, right or wrong the method.
    ///     let end = method.step(&system, &start, 0.01)?;
    ///     assert!((end.momentum - start.momentum).norm() < 1e-15, "{method:?}");
    ///     assert!((end.attitude.j - 0.01_f64.sin()).abs() < 1e-6, "{method:?}");
    /// }
    /// # Ok::<(), tumbling::Error>(())
    /// ```
    ///
    /// # Errors
    /// A step so long that an implicit method does not find its solution, or might find a wrong one, or that
    /// the motion leaves the range of the number type; for Moser and Veselov's methods, a needle too thin for
    /// that type. A step whose result is finite but wrong is not an error: see
    /// [`MethodInfo`](crate::step::MethodInfo).
    pub fn step<T: Analytic>(self, system: &System<T>, start: &State<T>, h: T) -> Result<State<T>, Error> {
        let h = &h;
        check_square_underflow(&system.omega(&start.momentum), h)?;
        self.end(system, start, h)?.checked()
    }
}

/// Its [name](crate::step::MethodInfo::name).
impl fmt::Display for Method {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(self.info().name)
    }
}

/// Refuses a spin so small that its squares lose digits, if it turns the body within the step: without these
/// digits the gyroscopic term would vanish.
pub(crate) fn check_square_underflow<T: Analytic>(omega: &Vector3<T>, h: &T) -> Result<(), Error> {
    let largest = &omega[omega.map(|x| x.size()).imax()];
    let (size, rounding) = (largest.size(), T::rounding());
    if !(size > 0.0 && rounding > 0.0 && size * h.size() > 1e-9) {
        return Ok(());
    }
    let back = largest.clone() * largest.clone() / largest.clone() - largest.clone();
    if back.size() <= 4.0 * rounding * size {
        return Ok(());
    }
    Err(Refusal::OutOfRange { what: Subject::SpinSquare, value: size * size }.into())
}
