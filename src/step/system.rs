//! The system that a stepper advances: a rigid body in its principal axes, and the torques on it.

use crate::attitude;
use crate::body::{Rate, State};
use crate::dynamics::{euler, observe};
use crate::error::{Error, Refusal, Subject, representable};
use crate::inertia::{PrincipalMoments, ascending};
use crate::number::{Analytic, Field};
use crate::step::methods::moser_veselov::Corrections;
pub use crate::step::methods::{gauss::rests_of_gauss, moser_veselov::altered};
use crate::step::torque::{Instant, Torque};
use crate::step::torques::Torques;
use alloc::vec::Vec;
use nalgebra::Vector3;

/// A body by its principal moments, and the torques that act on it.
///
/// All vectors are along its principal axes; a [`State`] of it carries the angular momentum in body axes,
/// kg m²/s.
#[derive(Debug, Clone, PartialEq)]
pub struct System<T: nalgebra::Scalar> {
    moments: Vector3<T>,
    /// The inverses of the principal moments, 1/(kg m²).
    pub(super) inverse: Vector3<T>,
    torques: Vec<Torque<T>>,
    /// All of them, summed by kind.
    pub(super) sum: Torques<T>,
    /// When the next step begins, s.
    pub(super) time: T,
    /// What steps at a fixed rate take of the body.
    pub(super) corrections: Corrections<T>,
}

impl System<f64> {
    /// A body with these principal moments, free of torque.
    ///
    /// ```
    /// use nalgebra::Vector3;
    /// use tumbling::{PrincipalMoments, step::System};
    /// let system = System::free(PrincipalMoments::new(1.0, 2.0, 2.5)?)?;
    /// assert_eq!(system.omega(&Vector3::new(1.0, 2.0, 5.0)), Vector3::new(1.0, 1.0, 2.0));
    /// # Ok::<(), tumbling::Error>(())
    /// ```
    ///
    /// # Errors
    /// An inverse moment beyond `f64`.
    pub fn free(moments: PrincipalMoments) -> Result<Self, Error> {
        Self::with(moments, Vec::new())
    }

    /// A body with these principal moments under all of `torques` together.
    ///
    /// # Errors
    /// The errors of [`free`](Self::free), a torque that is not valid, or torques whose sum is beyond `f64`.
    pub fn with(moments: PrincipalMoments, torques: Vec<Torque<f64>>) -> Result<Self, Error> {
        let system = Self::of_numbers(moments.vector(), torques);
        system.check_inverse()?;
        system.torques.iter().try_for_each(Torque::validate)?;
        representable(Subject::Torque, &[system.sum.largest()]).map(|()| system)
    }

    pub(super) fn check_inverse(&self) -> Result<(), Error> {
        let check = |&value: &f64| {
            Refusal::OutOfRange { what: Subject::InverseMoment, value }.when(!value.is_normal())
        };
        self.inverse.iter().try_for_each(check)
    }

    /// The system whose time zero is `time` seconds, with phases from the exact product of rate and time.
    pub(crate) fn starting_at(&self, time: f64) -> Self {
        self.under(self.torques.iter().map(|torque| torque.starting_at(time)).collect())
    }

    /// The same body under other torques, unchecked, at time zero.
    pub(crate) fn under(&self, torques: Vec<Torque<f64>>) -> Self {
        let (moments, inverse, corrections) = (self.moments, self.inverse, self.corrections.clone());
        Self { moments, inverse, sum: Torques::of(&torques), torques, time: 0.0, corrections }
    }
}

impl<T: Field> System<T> {
    /// Principal moments, kg m².
    #[must_use]
    pub fn moments(&self) -> &Vector3<T> {
        &self.moments
    }

    /// The torques on the body, all at once.
    #[must_use]
    pub fn torques(&self) -> &[Torque<T>] {
        &self.torques
    }

    /// Sets the time at which the next step begins, s, which is passed to a [`Torque::Function`]. It is zero
    /// by default.
    pub(crate) fn set_time(&mut self, time: T) {
        self.time = time;
    }

    pub(crate) fn is_free(&self) -> bool {
        self.torques.is_empty()
    }

    /// The spin (rad/s) for a momentum (kg m²/s), both along the principal axes.
    #[must_use]
    pub fn omega(&self, momentum: &Vector3<T>) -> Vector3<T> {
        momentum.component_mul(&self.inverse)
    }

    /// The momentum (kg m²/s) for a spin (rad/s), both along the principal axes.
    #[must_use]
    pub fn momentum(&self, omega: &Vector3<T>) -> Vector3<T> {
        omega.component_mul(&self.moments)
    }

    /// The kinetic energy of the rotation, J.
    #[must_use]
    pub fn energy(&self, state: &State<T>) -> T {
        observe::energy(&self.omega(&state.momentum), &state.momentum)
    }
}

impl<T: Analytic> System<T> {
    /// A system of any [`Analytic`] numbers, unchecked: a moment of zero is divided by as the number type
    /// does, and of moments that no body has a step may be refused.
    #[must_use]
    pub fn of_numbers(moments: Vector3<T>, torques: Vec<Torque<T>>) -> Self {
        let inverse = moments.map(|moment| T::one() / moment);
        let sum = Torques::of(&torques);
        let corrections = Corrections::about(ascending(&moments.map(|moment| moment.size()))[0], &moments);
        Self { moments, inverse, torques, sum, time: T::zero(), corrections }
    }

    /// The sum of all torques in body axes, N m, at the start of a step.
    #[must_use]
    #[inline]
    pub fn torque(&self, motion: &State<T>) -> Vector3<T> {
        self.torque_after(motion, &T::zero())
    }

    /// The sum of all torques `time` seconds after the start of a step.
    #[inline]
    pub(crate) fn torque_after(&self, motion: &State<T>, time: &T) -> Vector3<T> {
        if self.is_free() { Vector3::from_fn(|_, _| T::zero()) } else { self.driven(motion, time) }
    }

    // Not inlined: the code of a free body is the shorter for it.
    #[inline(never)]
    fn driven(&self, motion: &State<T>, time: &T) -> Vector3<T> {
        let rotation = attitude::rotation_matrix(&motion.attitude);
        let omega = self.omega(&motion.momentum);
        let then = self.time.clone() + time.clone();
        let (inverse, rotation, momentum) = (&self.inverse, &rotation, &motion.momentum);
        self.sum.at(&Instant { inverse, time: &then, rotation, momentum, omega: &omega })
    }

    /// The law of motion, `q' = q w / 2` and `L' = L x w + torque`, at the system's time.
    ///
    /// The cross product is taken as Euler wrote it, by differences of moments: of a needle's products of
    /// momentum and spin two nearly cancel.
    #[must_use]
    pub fn rate(&self, state: &State<T>) -> Rate<T> {
        self.rate_after(state, &T::zero())
    }

    /// The law of motion `time` seconds after the system's time.
    #[inline]
    pub(crate) fn rate_after(&self, state: &State<T>, time: &T) -> Rate<T> {
        let omega = self.omega(&state.momentum);
        Rate {
            attitude: attitude::rate(&state.attitude, &omega),
            momentum: euler::coupling(&self.moments, &omega) + self.torque_after(state, time),
        }
    }

    /// The state after the torques alone have changed the momentum for the time `h` at a fixed attitude: the
    /// kick of a kick-drift-kick scheme. Damping and dissipation decay by their own exact law, so no kick
    /// overshoots.
    ///
    /// The torques act one kind after another; the second kick of a step must be
    /// [`adjoint_kick`](Self::adjoint_kick), or the step is not symmetric in time, and only of first order.
    #[inline]
    pub(crate) fn kick(&self, motion: &State<T>, h: T) -> State<T> {
        self.kicked(&self.time, motion, h, false)
    }

    /// The second kick of a step of `2 h`: that of the end of the step, with the last kind of torque first.
    #[inline]
    pub(crate) fn adjoint_kick(&self, motion: &State<T>, h: T) -> State<T> {
        let end = self.time.clone() + h.clone() + h.clone();
        self.kicked(&end, motion, h, true)
    }

    /// A step of `h` seconds of free motion between two half kicks. With torques it is of order 2.
    #[inline]
    pub(crate) fn between_half_kicks(
        &self,
        start: &State<T>,
        h: &T,
        free: impl FnOnce(State<T>) -> State<T>,
    ) -> State<T> {
        let half = h.clone() / T::integer(2);
        self.adjoint_kick(&free(self.kick(start, half.clone())), half)
    }

    fn kicked(&self, time: &T, motion: &State<T>, h: T, adjoint: bool) -> State<T> {
        if self.is_free() {
            return motion.clone();
        }
        let rotation = attitude::rotation_matrix(&motion.attitude);
        let omega = self.omega(&motion.momentum);
        let (inverse, rotation, momentum) = (&self.inverse, &rotation, &motion.momentum);
        let now = Instant { inverse, time, rotation, momentum, omega: &omega };
        State { attitude: motion.attitude.clone(), momentum: self.sum.kick(&now, &h, adjoint) }
    }
}
