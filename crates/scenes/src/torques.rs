//! The torques of a scene: which of them act, and how strong they are.

use crate::error::Error;
use crate::initial_state::Checked;
use nalgebra::Vector3;
use tumbling::step::Torque;

/// A torque as a scene stores it: `None` if it is zero at all times; with one window of time instead of
/// several, and without a window that covers all times.
pub(crate) fn simplified(torque: Torque<f64>) -> Option<Torque<f64>> {
    let (mut torque, mut from, mut to) = (torque, f64::NEG_INFINITY, f64::INFINITY);
    while let Torque::During { start, end, torque: inner } = torque {
        (torque, from, to) = (*inner, from.max(start), to.min(end));
    }
    if is_zero(&torque) || from >= to {
        return None;
    }
    let always = from == f64::NEG_INFINITY && to == f64::INFINITY;
    Some(if always { torque } else { Torque::during(from, to, torque) })
}

/// Whether it is zero at every attitude and spin.
fn is_zero(torque: &Torque<f64>) -> bool {
    let zero = Vector3::zeros();
    match torque {
        Torque::InBody(value) | Torque::InWorld(value) | Torque::Damping(value) => *value == zero,
        Torque::Aligning { arm, field } => *arm == zero || *field == zero,
        Torque::Periodic { amplitude, .. } => *amplitude == zero,
        Torque::Dissipation(strength) | Torque::GravityGradient { strength, .. } => *strength == 0.0,
        _ => false,
    }
}

/// Whether it always dissipates energy, whatever the body does.
pub(crate) fn is_damping(torque: &Torque<f64>) -> bool {
    match torque {
        Torque::During { torque, .. } => is_damping(torque),
        _ => matches!(torque, Torque::Damping(_) | Torque::Dissipation(_)),
    }
}

/// Whether damping is much faster than the spin of a body, and lasts many of its time constants until `end`
/// (s).
///
/// # Errors
/// A torque given by a function.
pub(crate) fn are_stiff(start: &Checked, torques: &[Torque<f64>], end: f64) -> Result<bool, Error> {
    let mut rates = Rates { spin: start.omega.norm(), ..Rates::default() };
    torques.iter().try_for_each(|torque| rates.add(torque, end, end, start))?;
    // A constant torque spins the body up; one that aligns makes it librate.
    let gained = rates.mean / start.moments.vector().min() * end;
    let gained = if rates.libration > 0.0 { gained.min(rates.libration) } else { gained };
    let spin = rates.spin.max(gained).max(rates.libration);
    Ok(rates.decay > 30.0 * spin.max(1.0 / end) && rates.decay * end > 300.0)
}

/// How fast the torques change the motion.
#[derive(Default)]
struct Rates {
    /// The spin, or the faster rate of a torque, rad/s.
    spin: f64,
    /// The fastest damping or dissipation, 1/s.
    decay: f64,
    /// The mean size, over the scene's time, of the torques that do not dissipate energy, N m.
    mean: f64,
    /// The fastest libration about where a torque points, rad/s.
    libration: f64,
}

impl Rates {
    /// A torque that acts for `duration` until the time `end`, s.
    fn add(&mut self, torque: &Torque<f64>, duration: f64, end: f64, start: &Checked) -> Result<(), Error> {
        let moments = start.moments.vector();
        let lightest = 1.0 / moments.min();
        let strength = match torque {
            Torque::InBody(value) | Torque::InWorld(value) => value.norm(),
            Torque::Aligning { arm, field } => {
                let torque = arm.norm() * field.norm();
                self.libration = self.libration.max((torque * lightest).sqrt());
                torque
            }
            Torque::GravityGradient { strength, orbit, .. } => {
                // The size of n x I n is at most half of this.
                let most = strength * (moments.max() - moments.min());
                self.libration = self.libration.max((most * lightest).sqrt());
                self.spin = self.spin.max(orbit.norm());
                0.5 * most
            }
            // In resonance with the spin it acts in the same direction all the time.
            Torque::Periodic { amplitude, rate, .. } => {
                self.spin = self.spin.max(rate.abs());
                amplitude.norm()
            }
            Torque::Damping(c) => {
                self.decay = self.decay.max(c.component_div(&moments).max());
                0.0
            }
            Torque::Dissipation(k) => {
                let momentum = start.inertia.momentum(&start.omega);
                self.decay = self.decay.max(k * momentum.norm_squared() * lightest);
                0.0
            }
            Torque::During { start: from, end: to, torque } => {
                let acts = to.min(end) - from.max(0.0);
                return if acts > 0.0 { self.add(torque, acts, end, start) } else { Ok(()) };
            }
            _ => {
                return Err(Error::Undefined {
                    what: "the motion under a torque given by a function",
                    why: "a plan goes by how strong the torques are, which a function does not say: use a stepper",
                });
            }
        };
        self.mean += strength * (duration / end);
        Ok(())
    }
}
