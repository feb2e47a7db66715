//! The law of motion as polynomials: what the recurrences of the series need of a body and its torques.

use crate::number::Analytic;
use crate::step::system::System;
use crate::step::torque::Torque;
use nalgebra::{Matrix3, Vector3};
#[cfg(not(feature = "std"))]
use num_traits::Float as _;

use super::largest;
use super::sums::{Lanes, lanes};

/// A vector that stands still in the world, and the angular acceleration that it gives.
#[derive(Debug, Clone, Copy)]
pub(super) struct WorldVector<T> {
    /// In world axes.
    pub(super) vector: Vector3<T>,
    /// Takes the vector in body axes to the angular acceleration.
    pub(super) acceleration: Matrix3<T>,
}

/// The gravity gradient: the direction to the attracting body turns in the world at a fixed rate.
#[derive(Debug, Clone, Copy)]
pub(super) struct Gradient<T> {
    /// 1/s².
    strength: T,
    /// In world axes, rad/s.
    orbit: Vector3<T>,
    /// Its length, or less it, rad/s.
    rate: T,
    /// The direction's part along the orbit's axis, in world axes.
    along: Vector3<T>,
    /// The rest of it, at time zero and a quarter of a turn on.
    across: [Vector3<T>; 2],
}

impl<T: Analytic + Copy> Gradient<T> {
    fn new(strength: T, direction: &Vector3<T>, orbit: &Vector3<T>) -> Self {
        let largest = orbit[orbit.map(|x| x.size()).imax()];
        if largest.is_zero() {
            let none = Vector3::repeat(T::zero());
            return Self { strength, orbit: *orbit, rate: largest, along: *direction, across: [none; 2] };
        }
        // By the largest component, so that no square leaves the range.
        let part = orbit.map(|x| x / largest);
        let length = part.dot(&part).sqrt();
        let axis = part.map(|x| x / length);
        let ahead = axis.cross(direction);
        let across = ahead.cross(&axis);
        let along = direction - across;
        Self { strength, orbit: *orbit, rate: largest * length, along, across: [across, ahead] }
    }
}

/// How many rates periodic torques may have.
pub(super) const PERIODIC_RATES: usize = 2;

/// Torques of one period, that stand still in the body.
#[derive(Debug, Clone, Copy)]
pub(super) struct PeriodicTorque<T> {
    /// rad/s.
    pub(super) rate: T,
    /// The angular acceleration by the cosine and by the sine of rate times time, rad/s².
    cosine: Vector3<T>,
    sine: Vector3<T>,
}

/// Angular acceleration by spin, attitude and time, all of it polynomial or periodic.
#[derive(Debug, Clone, Copy)]
pub(super) struct Law<T> {
    /// Principal moments, kg m².
    pub(super) moments: Vector3<T>,
    /// `(I2 - I3) / I1` and so on round.
    pub(super) coupling: [T; 3],
    /// By torques that stand still in the body, rad/s².
    pub(super) constant: [T; 3],
    /// The rates at which damping takes the spin's components, 1/s.
    pub(super) decay: [T; 3],
    /// The strength of the dissipation, s/(kg m²).
    pub(super) dissipation: T,
    pub(super) world: [WorldVector<T>; 3],
    /// How many of these there are.
    pub(super) count: usize,
    pub(super) gradient: Option<Gradient<T>>,
    periodic: [Option<PeriodicTorque<T>>; PERIODIC_RATES],
    /// A bound of the angular acceleration by torques that do not depend on the spin, rad/s².
    torque_bound: f64,
}

impl<T: Analytic + Copy> Law<T> {
    /// That of a system, if all its torques are polynomials: not of a function, and not of two gravity
    /// gradients.
    pub(super) fn of(system: &System<T>) -> Option<Self> {
        let (moments, inverse) = (*system.moments(), *system.inverse());
        let none = Vector3::repeat(T::zero());
        let empty = WorldVector { vector: none, acceleration: Matrix3::repeat(T::zero()) };
        let [x, y, z] = [moments.x, moments.y, moments.z];
        let mut law = Self {
            moments,
            coupling: [(y - z) / x, (z - x) / y, (x - y) / z],
            constant: [T::zero(); 3],
            decay: system.drag().component_mul(&inverse).into(),
            dissipation: T::zero(),
            world: [empty; 3],
            count: 0,
            gradient: None,
            periodic: [None; PERIODIC_RATES],
            torque_bound: 0.0,
        };
        for torque in system.torques() {
            match torque {
                Torque::InBody(torque) => {
                    let sum = Vector3::from(law.constant) + torque.component_mul(&inverse);
                    law.constant = sum.into();
                }
                Torque::InWorld(torque) => law.add(torque, Matrix3::from_diagonal(&inverse)),
                Torque::Aligning { arm, field } => {
                    let (a, none) = (arm, T::zero());
                    let across = Matrix3::new(none, -a.z, a.y, a.z, none, -a.x, -a.y, a.x, none);
                    law.add(field, Matrix3::from_fn(|i, j| across[(i, j)] * inverse[i]));
                }
                Torque::Damping(_) => {}
                Torque::Dissipation(strength) => law.dissipation += *strength,
                Torque::GravityGradient { strength, direction, orbit } if law.gradient.is_none() => {
                    law.gradient = Some(Gradient::new(*strength, direction, orbit));
                }
                Torque::Periodic { amplitude, rate, phase } => {
                    law.add_periodic(&amplitude.component_mul(&inverse), *rate, phase)?;
                }
                _ => return None,
            }
        }
        law.torque_bound = law.bound();
        Some(law)
    }

    /// Adds a periodic torque, if there is a place for its rate.
    fn add_periodic(&mut self, acceleration: &Vector3<T>, rate: T, phase: &T) -> Option<()> {
        let (sine, cosine) = Analytic::sin_cos(phase);
        let place = self.periodic.iter_mut().find(|place| place.is_none_or(|one| one.rate == rate))?;
        let none = Vector3::repeat(T::zero());
        let one = place.get_or_insert(PeriodicTorque { rate, cosine: none, sine: none });
        one.cosine += acceleration * cosine;
        one.sine -= acceleration * sine;
        Some(())
    }

    /// Adds what a world vector does. More than three vectors are sums of the world's three axes.
    fn add(&mut self, vector: &Vector3<T>, acceleration: Matrix3<T>) {
        if let Some(same) = self.world[..self.count].iter_mut().find(|one| one.vector == *vector) {
            same.acceleration += acceleration;
        } else if self.count < 3 {
            self.world[self.count] = WorldVector { vector: *vector, acceleration };
            self.count += 1;
        } else {
            let parts = |axis: usize, sum: Matrix3<T>, one: &WorldVector<T>| {
                sum + one.acceleration.map(|x| x * one.vector[axis])
            };
            let last = WorldVector { vector: *vector, acceleration };
            let world = core::array::from_fn(|axis| {
                let all = self.world.iter().chain([&last]);
                let acceleration = all.fold(Matrix3::repeat(T::zero()), |sum, one| parts(axis, sum, one));
                let vector = Vector3::from_fn(|i, _| if i == axis { T::one() } else { T::zero() });
                WorldVector { vector, acceleration }
            });
            self.world = world;
        }
    }

    fn bound(&self) -> f64 {
        let world = self.world[..self.count].iter().map(|one| {
            let [vector, acceleration] = [one.vector.as_slice(), one.acceleration.as_slice()].map(largest);
            // Any axis may turn onto the vector, which is shorter than twice its largest component.
            2.0 * vector * acceleration
        });
        let periodic = self.periodic.iter().flatten();
        largest(&self.constant)
            + periodic.map(|one| largest(one.cosine.as_slice()) + largest(one.sine.as_slice())).sum::<f64>()
            + world.sum::<f64>()
            + self.gradient.map_or(0.0, |gradient| gradient.strength.size())
    }

    /// A bound of the torques that do not grow with the spin, N m.
    pub(super) fn torque_size(&self) -> f64 {
        self.torque_bound * largest(self.moments.as_slice())
    }

    /// The fastest rate at which losses alone would have the momentum decay, 1/s.
    pub(super) fn fastest_decay(&self, momentum: &Vector3<T>) -> f64 {
        let mut decay = largest(&self.decay);
        if !self.dissipation.is_zero() {
            let size = largest(momentum.as_slice());
            let [x, y, z] = [0, 1, 2].map(|i| 1.0 / self.moments[i].size());
            let span = x.max(y).max(z) - x.min(y).min(z);
            decay = decay.max(self.dissipation.size() * size * size * span);
        }
        decay
    }

    /// How fast the motion changes, 1/s.
    pub(super) fn rate(&self, omega: &Vector3<T>, decay: f64) -> f64 {
        let orbit = self.gradient.map_or(0.0, |gradient| largest(gradient.orbit.as_slice()));
        let periodic = self.periodic.iter().flatten().map(|one| one.rate.size());
        largest(&[
            largest(omega.as_slice()),
            self.torque_bound.sqrt(),
            decay,
            orbit,
            periodic.fold(0.0, f64::max),
        ])
    }

    /// This law with `unit` seconds for a unit of time.
    pub(super) fn in_units(&self, unit: T) -> InUnits<T> {
        let squared = |x: T| x * unit * unit;
        let rows = |one: &WorldVector<T>| WorldInUnits {
            vector: one.vector,
            acceleration: core::array::from_fn(|axis| {
                lanes(core::array::from_fn(|i| squared(one.acceleration[(i, axis)])))
            }),
        };
        let periodic = self.periodic.map(|one| {
            let none = Vector3::repeat(T::zero());
            let one = one.unwrap_or(PeriodicTorque { rate: T::zero(), cosine: none, sine: none });
            let [cosine, sine] = [one.cosine, one.sine].map(|v| lanes(v.map(squared).into()));
            PeriodicInUnits { rate: one.rate, rate_in_units: one.rate * unit, cosine, sine }
        });
        let strength = self.dissipation / unit;
        InUnits {
            coupling: lanes(self.coupling),
            constant: lanes(self.constant.map(squared)),
            decay: lanes(self.decay.map(|x| x * unit)),
            damped: self.decay.iter().any(|x| !x.is_zero()),
            dissipation: (!self.dissipation.is_zero()).then(|| DissipationInUnits {
                moments: lanes(self.moments.into()),
                acceleration: lanes(self.moments.map(|m| strength / m).into()),
            }),
            world: self.world.each_ref().map(rows),
            count: self.count,
            periodic,
            periodic_count: self.periodic.iter().flatten().count(),
            gradient: self.gradient.map(|gradient| GradientInUnits {
                acceleration: lanes(self.coupling.map(|x| x * squared(gradient.strength))),
                gradient,
                orbit: gradient.orbit.map(|x| x * unit),
            }),
        }
    }
}

/// What a world vector does: the angular acceleration for each of its components in body axes.
#[derive(Debug, Clone, Copy)]
pub(super) struct WorldInUnits<T> {
    /// In world axes.
    pub(super) vector: Vector3<T>,
    pub(super) acceleration: [Lanes<T>; 3],
}

/// What periodic torques of one rate do.
#[derive(Debug, Clone, Copy)]
pub(super) struct PeriodicInUnits<T> {
    /// rad/s.
    pub(super) rate: T,
    pub(super) rate_in_units: T,
    pub(super) cosine: Lanes<T>,
    pub(super) sine: Lanes<T>,
}

/// What the dissipation does.
#[derive(Debug, Clone, Copy)]
pub(super) struct DissipationInUnits<T> {
    /// kg m².
    pub(super) moments: Lanes<T>,
    /// For each component of `L x (L x w)`.
    pub(super) acceleration: Lanes<T>,
}

/// What the gravity gradient does.
#[derive(Debug, Clone, Copy)]
pub(super) struct GradientInUnits<T> {
    gradient: Gradient<T>,
    /// For each product of two components of the direction, less.
    pub(super) acceleration: Lanes<T>,
    /// In world axes.
    pub(super) orbit: Vector3<T>,
}

impl<T: Analytic + Copy> GradientInUnits<T> {
    /// The direction at a time (s), in world axes.
    pub(super) fn direction_at(&self, time: T) -> Vector3<T> {
        let Gradient { rate, along, across: [across, ahead], .. } = &self.gradient;
        let (sine, cosine) = Analytic::sin_cos(&(*rate * time));
        Vector3::from_fn(|i, _| along[i] + across[i] * cosine + ahead[i] * sine)
    }
}

/// A law in a unit of time, in rows as the series are.
#[derive(Debug, Clone, Copy)]
pub(super) struct InUnits<T> {
    pub(super) coupling: Lanes<T>,
    pub(super) constant: Lanes<T>,
    pub(super) decay: Lanes<T>,
    /// Whether any of the decay is not zero.
    pub(super) damped: bool,
    pub(super) dissipation: Option<DissipationInUnits<T>>,
    pub(super) gradient: Option<GradientInUnits<T>>,
    world: [WorldInUnits<T>; 3],
    count: usize,
    periodic: [PeriodicInUnits<T>; PERIODIC_RATES],
    periodic_count: usize,
}

impl<T> InUnits<T> {
    #[inline(always)]
    pub(super) fn world(&self) -> &[WorldInUnits<T>] {
        &self.world[..self.count]
    }

    #[inline(always)]
    pub(super) fn periodic(&self) -> &[PeriodicInUnits<T>] {
        &self.periodic[..self.periodic_count]
    }
}
