//! The law of motion as polynomials: the data of a body and its torques for the recurrences of the series.

use super::sums::{Lanes, lanes};
use super::{largest, ratio};
use crate::number::{DoubleDouble, exponent, functions::sin_cos, times_power_of_two};
use crate::step::system::System;
use crate::step::torques::{Periodic, WorldVector};
use alloc::vec::Vec;
use nalgebra::Vector3;
#[cfg(not(feature = "std"))]
use num_traits::Float as _;

/// Angular acceleration as a function of spin, attitude and time, in one unit of time. Every term is a
/// polynomial or periodic. The rows have the layout of the series.
#[derive(Debug, Clone)]
pub(super) struct Law {
    /// `(I2 - I3) / I1` and so on round.
    pub(super) coupling: Lanes,
    /// By torques that are constant in the body.
    pub(super) constant: Lanes,
    /// The decay rates of the spin's components by damping, if there is any.
    pub(super) decay: Option<Lanes>,
    pub(super) dissipation: Option<DissipationLaw>,
    pub(super) gradients: Vec<GradientLaw>,
    pub(super) world: Vec<WorldLaw>,
    /// One entry for each rate.
    pub(super) periodic: Vec<PeriodicLaw>,
}

impl Law {
    /// The law of a system in units of this number of seconds, if none of its torques is a function.
    pub(super) fn of(system: &System<f64>, unit: f64) -> Option<Self> {
        let (inverse, sum) = (&system.inverse, &system.sum);
        if !sum.functions.is_empty() || !sum.timed.is_empty() {
            return None;
        }
        // Values per second squared, converted to units of time.
        let squared = |x: f64| x * unit * unit;
        let [x, y, z] = (*system.moments()).into();
        let coupling = [(y - z) / x, (z - x) / y, (x - y) / z];
        let damping = sum.damping.component_mul(inverse).map(|x| x * unit);
        let mut law = Self {
            coupling: lanes(coupling),
            constant: lanes(sum.constant.component_mul(inverse).map(squared).into()),
            decay: damping.iter().any(|x| *x != 0.0).then(|| lanes(damping.into())),
            dissipation: (sum.dissipation != 0.0).then(|| DissipationLaw {
                moments: lanes((*system.moments()).into()),
                acceleration: lanes(system.moments().map(|moment| sum.dissipation / unit / moment).into()),
            }),
            gradients: sum
                .gradients
                .iter()
                .map(|one| GradientLaw {
                    acceleration: lanes(coupling.map(|x| x * (one.strength * unit * unit))),
                    orbit: one.orbit.map(|x| x * unit),
                    circle: Circle::of(&one.direction, &one.orbit),
                })
                .collect(),
            world: sum
                .world
                .iter()
                .map(|WorldVector { vector, torque }| {
                    let column =
                        |axis: usize| lanes([0, 1, 2].map(|i| squared(torque[(i, axis)] * inverse[i])));
                    WorldLaw { vector: *vector, acceleration: [0, 1, 2].map(column) }
                })
                .collect(),
            periodic: Vec::new(),
        };
        for torque in &sum.periodic {
            let acceleration = torque.amplitude.component_mul(inverse).map(squared);
            law.add_periodic(torque, &lanes(acceleration.into()), unit);
        }
        Some(law)
    }

    fn add_periodic(&mut self, torque: &Periodic<f64>, acceleration: &Lanes, unit: f64) {
        let (sine, cosine) = sin_cos(torque.phase);
        let (cosine, sine) = (acceleration.map(|x| x * cosine), acceleration.map(|x| -(x * sine)));
        if let Some(one) = self.periodic.iter_mut().find(|one| one.rate == torque.rate) {
            for i in 0..4 {
                one.cosine[i] += cosine[i];
                one.sine[i] += sine[i];
            }
        } else {
            let (rate, rate_in_units) = (torque.rate, torque.rate * unit);
            self.periodic.push(PeriodicLaw { rate, rate_in_units, cosine, sine });
        }
    }
}

/// Sine and cosine of a phase that grows at `rate` (rad/s) for `time` (s): the product of the two is exact,
/// so that many turns cost no digits.
pub(in crate::step) fn turned(phase: f64, rate: f64, time: f64) -> (f64, f64) {
    let angle = DoubleDouble::product(rate, time);
    let [(p, q), (s, c), (t, d)] = [phase, angle.hi(), angle.lo()].map(sin_cos);
    let (s, c) = (s * d + c * t, c * d - s * t);
    (p * c + q * s, q * c - p * s)
}

/// The rates at which a system's torques change its motion.
#[derive(Debug, Clone, Copy)]
pub(super) struct Rates {
    /// A bound on the angular acceleration by torques that do not depend on the spin, rad/s².
    pub(super) acceleration: f64,
    /// The rate of the fastest orbit or periodic torque, rad/s.
    driving: f64,
    /// The fastest decay by damping, 1/s.
    damping: f64,
    /// The decay by dissipation, divided by the square of the momentum.
    dissipation: f64,
}

impl Rates {
    /// The rates of a system, whose law is in seconds.
    pub(super) fn of(system: &System<f64>, law: &Law) -> Self {
        let sum = &system.sum;
        let world = law.world.iter().map(|one| {
            // Any axis may turn onto the vector, whose length is less than twice its largest component.
            2.0 * largest(one.vector.as_slice()) * largest(one.acceleration.as_flattened())
        });
        let periodic = law.periodic.iter();
        let acceleration = largest(&law.constant)
            + periodic.clone().map(|one| largest(&one.cosine) + largest(&one.sine)).sum::<f64>()
            + world.sum::<f64>()
            + sum.gradients.iter().map(|gradient| gradient.strength.abs()).sum::<f64>();
        let orbits = sum.gradients.iter().map(|gradient| largest(gradient.orbit.as_slice()));
        let inverse = system.inverse.map(|x| x.abs());
        Self {
            acceleration,
            driving: periodic.map(|one| one.rate.abs()).chain(orbits).fold(0.0, f64::max),
            damping: law.decay.map_or(0.0, |decay| largest(&decay)),
            dissipation: sum.dissipation.abs() * (inverse.max() - inverse.min()),
        }
    }

    /// The fastest decay rate of the momentum by damping and dissipation alone, 1/s.
    pub(super) fn fastest_decay(&self, momentum: &Vector3<f64>) -> f64 {
        if self.dissipation == 0.0 {
            return self.damping;
        }
        let size = largest(momentum.as_slice());
        self.damping.max(self.dissipation * size * size)
    }

    /// The rate at which the motion changes, 1/s.
    pub(super) fn fastest(&self, omega: &Vector3<f64>, decay: f64) -> f64 {
        largest(&[largest(omega.as_slice()), self.acceleration.sqrt(), decay, self.driving])
    }
}

/// The effect of a world vector: the angular acceleration for each of its components in body axes.
#[derive(Debug, Clone, Copy)]
pub(super) struct WorldLaw {
    /// In world axes.
    pub(super) vector: Vector3<f64>,
    pub(super) acceleration: [Lanes; 3],
}

/// The effect of periodic torques of one rate: the angular acceleration by the cosine and by the sine of rate
/// times time.
#[derive(Debug, Clone, Copy)]
pub(super) struct PeriodicLaw {
    /// rad/s.
    pub(super) rate: f64,
    pub(super) rate_in_units: f64,
    pub(super) cosine: Lanes,
    pub(super) sine: Lanes,
}

/// The effect of the dissipation.
#[derive(Debug, Clone, Copy)]
pub(super) struct DissipationLaw {
    /// kg m².
    pub(super) moments: Lanes,
    /// For each component of `L x (L x w)`.
    pub(super) acceleration: Lanes,
}

/// The effect of the gravity gradient.
#[derive(Debug, Clone, Copy)]
pub(super) struct GradientLaw {
    /// For each product of two components of the direction, with the opposite sign.
    pub(super) acceleration: Lanes,
    /// In world axes.
    pub(super) orbit: Vector3<f64>,
    /// The direction to the attracting body.
    pub(super) circle: Circle,
}

/// A direction that turns in the world at a fixed rate.
#[derive(Debug, Clone, Copy)]
pub(in crate::step) struct Circle {
    /// rad/s.
    rate: DoubleDouble,
    /// The direction's part along the axis.
    along: Vector3<f64>,
    /// The perpendicular part, at time zero and a quarter of a turn later.
    across: [Vector3<f64>; 2],
}

impl Circle {
    pub(in crate::step) fn of(direction: &Vector3<f64>, orbit: &Vector3<f64>) -> Self {
        // Divided by a power of two, so that no square overflows or underflows. Late angles need the length
        // in two numbers.
        let scale = exponent(largest(orbit.as_slice()));
        let part = orbit.map(|x| times_power_of_two(x, -scale));
        let [x, y, z]: [_; 3] = part.map(|x| DoubleDouble::product(x, x)).into();
        let length = (x + y + z).sqrt();
        let axis = part.map(|x| ratio(x, length.hi()));
        let ahead = axis.cross(direction);
        let across = ahead.cross(&axis);
        Self { rate: length.scaled(scale), along: direction - across, across: [across, ahead] }
    }

    /// The direction at a time, s.
    pub(in crate::step) fn at(&self, time: f64) -> Vector3<f64> {
        let Self { rate, along, across: [across, ahead] } = self;
        let (sine, cosine) = turned(rate.lo() * time, rate.hi(), time);
        Vector3::from_fn(|i, _| along[i] + across[i] * cosine + ahead[i] * sine)
    }
}
