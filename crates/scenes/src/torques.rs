//! The torques of a scene: which of them act, along which axes, and how strong they are.

use crate::error::Error;
use crate::initial_state::Principal;
use nalgebra::Vector3;
use tumbling::step::{State, System, Torque};

/// A torque as a scene keeps it: none if it is zero at all times; in one window of time where it had several,
/// and without a window where that is all of time.
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

/// Whether it takes energy, whatever the body does.
pub(crate) fn is_loss(torque: &Torque<f64>) -> bool {
    match torque {
        Torque::During { torque, .. } => is_loss(torque),
        _ => matches!(torque, Torque::Damping(_) | Torque::Dissipation(_)),
    }
}

/// Whether it depends on the time, which steps of a fixed method do not count.
pub(crate) fn is_timed(torque: &Torque<f64>) -> bool {
    match torque {
        Torque::During { .. } | Torque::Periodic { .. } => true,
        Torque::GravityGradient { orbit, .. } => *orbit != Vector3::zeros(),
        _ => false,
    }
}

/// Whether steps under these torques surely have series: under one gravity gradient and two rates of periodic
/// torques at most.
pub(crate) fn have_series(torques: &[Torque<f64>]) -> bool {
    fn inner(torque: &Torque<f64>) -> &Torque<f64> {
        if let Torque::During { torque, .. } = torque { inner(torque) } else { torque }
    }
    let count = |is: fn(&Torque<f64>) -> bool| torques.iter().map(inner).filter(|torque| is(torque)).count();
    count(|torque| matches!(torque, Torque::GravityGradient { .. })) < 2
        && count(|torque| matches!(torque, Torque::Periodic { .. })) < 3
}

/// A torque given in body axes, along the principal axes.
///
/// # Errors
/// Damping that differs from axis to axis, of a body whose principal axes are others; a function.
pub(crate) fn along(body: &Principal, torque: &Torque<f64>) -> Result<Torque<f64>, Error> {
    let turned = |v: &Vector3<f64>| body.frame.map_or(*v, |frame| frame.inverse() * v);
    Ok(match torque {
        Torque::InBody(value) => Torque::InBody(turned(value)),
        Torque::Aligning { arm, field } => Torque::Aligning { arm: turned(arm), field: *field },
        Torque::Periodic { amplitude, rate, phase } => {
            Torque::Periodic { amplitude: turned(amplitude), rate: *rate, phase: *phase }
        }
        Torque::During { start, end, torque } => Torque::during(*start, *end, along(body, torque)?),
        Torque::Damping(c) if body.frame.is_some() && (c.x != c.y || c.y != c.z) => {
            return Err(Error::Undefined {
                what: "damping that differs from axis to axis",
                why: "it acts along the principal axes, and those of a body with products of inertia have no order to go by: \
                      give the body's moments along them, without products",
            });
        }
        Torque::InWorld(_) | Torque::Damping(_) | Torque::Dissipation(_) | Torque::GravityGradient { .. } => {
            torque.clone()
        }
        _ => {
            return Err(Error::Undefined {
                what: "the motion under a torque given by a function",
                why: "a plan goes by how strong the torques are, which a function does not say: use a stepper",
            });
        }
    })
}

/// How fast the torques change the motion, 1/s.
pub(crate) struct Rates {
    /// The spin, or the larger one that the torques give in the scene's time.
    pub(crate) spin: f64,
    /// The relative change of the momentum by the lossless torques while the body turns by a radian.
    pub(crate) push: f64,
    /// The fastest loss.
    pub(crate) loss: f64,
}

impl Rates {
    /// Of a system from this start to the time `end`, s.
    pub(crate) fn of(system: &System<f64>, start: &State<f64>, end: f64) -> Self {
        let omega = system.omega(&start.momentum);
        let lightest = 1.0 / system.moments().min();
        let mut all = Strengths::default();
        system.torques().iter().for_each(|torque| all.add(torque, 1.0, end, system, start));
        let Strengths { torque, mean, loss, swing, rate } = all;
        // A constant torque spins the body up; one that aligns swings it.
        let gained = (mean * lightest * end).min(if swing > 0.0 { swing } else { f64::INFINITY });
        let spin = omega.norm().max(gained).max(swing).max(rate);
        let momentum = start.momentum.norm().max(spin / lightest);
        let push = if momentum * spin > 0.0 { torque / (momentum * spin) } else { 0.0 };
        Self { spin, push, loss }
    }

    /// Whether losses are much faster than the spin, and last many of their time constants until `end`, s.
    pub(crate) fn are_stiff(&self, end: f64) -> bool {
        self.loss > 30.0 * self.spin.max(1.0 / end) && self.loss * end > 300.0
    }
}

/// Bounds of all torques together.
#[derive(Default)]
struct Strengths {
    /// Of the lossless ones, N m.
    torque: f64,
    /// The same, on average over the scene's time.
    mean: f64,
    /// The fastest loss, 1/s.
    loss: f64,
    /// The fastest swing about where a torque points, rad/s.
    swing: f64,
    /// The fastest rate of an orbit, or of a torque that is periodic, rad/s.
    rate: f64,
}

impl Strengths {
    /// A torque that acts in this share of the time up to `end`, s.
    fn add(&mut self, torque: &Torque<f64>, share: f64, end: f64, system: &System<f64>, start: &State<f64>) {
        let moments = system.moments();
        let lightest = 1.0 / moments.min();
        match torque {
            Torque::InBody(value) | Torque::InWorld(value) => self.lossless(value.norm(), share),
            Torque::Aligning { arm, field } => {
                let torque = arm.norm() * field.norm();
                self.lossless(torque, share);
                self.swing = self.swing.max((torque * lightest).sqrt());
            }
            Torque::GravityGradient { strength, orbit, .. } => {
                // The size of n x I n is at most half of this.
                let most = strength * (moments.max() - moments.min());
                self.lossless(0.5 * most, share);
                self.swing = self.swing.max((most * lightest).sqrt());
                self.rate = self.rate.max(orbit.norm());
            }
            // In resonance with the spin it pushes one way, all the time.
            Torque::Periodic { amplitude, rate, .. } => {
                self.lossless(amplitude.norm(), share);
                self.rate = self.rate.max(rate.abs());
            }
            Torque::Damping(c) => self.loss = self.loss.max(c.component_div(moments).max()),
            Torque::Dissipation(k) => {
                self.loss = self.loss.max(k * start.momentum.norm_squared() * lightest);
            }
            Torque::During { start: from, end: to, torque } => {
                let acts = to.min(end) - from.max(0.0);
                if acts > 0.0 {
                    self.add(torque, acts / end, end, system, start);
                }
            }
            // `along` has refused others.
            _ => {}
        }
    }

    fn lossless(&mut self, torque: f64, share: f64) {
        self.torque += torque;
        self.mean += torque * share;
    }
}
