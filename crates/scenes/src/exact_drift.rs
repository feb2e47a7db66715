//! Exact drift between kicks of torque: where the exact motion and the steppers meet.
//!
//! Between two half kicks of the torques the body moves freely, and free motion is known exactly
//! ([CFSZ08](tumbling::references)). So all the error is that of the kicks: none without a torque, however
//! long the step; small for a weak one. Each step prepares a new [`FreeMotion`].

use crate::error::{Error, finite};
use tumbling::attitude;
use tumbling::exact::FreeMotion;
use tumbling::step::{State, System};

/// One step of `h` seconds: half a kick, the exact free motion, half a kick. Errors fall as `h^2`, in
/// proportion to the torque; a step back undoes it. Keeps the attitude's length.
///
/// ```
/// use nalgebra::{Quaternion, Vector3};
/// use tumbling::{PrincipalMoments, dynamics::observe};
/// use tumbling::step::{State, System, Torque};
/// use tumbling_scenes::exact_drift;
/// // A free body, an hour in one step.
/// let moments = PrincipalMoments::new(1.0, 2.0, 2.5)?;
/// let free = System::free(moments)?;
/// let start = State { attitude: Quaternion::identity(), momentum: Vector3::new(0.1, 2.0, 0.3) };
/// let end = exact_drift::step(&free, &start, 3600.0)?;
/// let energy = |state: &State<f64>| observe::energy(&free.omega(&state.momentum), &state.momentum);
/// assert!((energy(&end) / energy(&start) - 1.0).abs() < 1e-14);
/// // A step forth and one back, under a torque.
/// let weight = Torque::gravity(&Vector3::new(0.0, 0.0, 0.1), 3.0);
/// let top = System::with(moments, vec![weight])?;
/// let there = exact_drift::step(&top, &start, 0.1)?;
/// let back = exact_drift::step(&top, &there, -0.1)?;
/// assert!((back.momentum - start.momentum).norm() < 1e-14);
/// # Ok::<(), tumbling_scenes::Error>(())
/// ```
///
/// # Errors
/// A step that is not finite, moments that no body has, a motion that [`FreeMotion::new`] refuses, or one
/// that leaves `f64`.
pub fn step(system: &System<f64>, start: &State<f64>, h: f64) -> Result<State<f64>, Error> {
    finite("the step", h)?;
    let half = 0.5 * h;
    let kicked = if system.torques().is_empty() { *start } else { system.kick(start, half) };
    let omega = system.omega(&kicked.momentum);
    let drift = FreeMotion::new((*system.moments()).try_into()?, &omega)?.at(h)?;
    let end = State {
        attitude: attitude::product(&kicked.attitude, &drift.attitude.into_inner()),
        momentum: system.momentum(&drift.omega),
    };
    let end = if system.torques().is_empty() { end } else { system.adjoint_kick(&end, half) };
    let size: f64 = end.attitude.coords.iter().chain(&end.momentum).map(|x| x.abs()).sum();
    if size.is_finite() {
        Ok(end)
    } else {
        Err(Error::OutOfRange { what: "the motion after a step", value: size })
    }
}
