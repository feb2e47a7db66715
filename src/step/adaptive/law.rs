//! The law of motion as polynomials: what the recurrences of the series need of a body and its torques.

use crate::attitude;
use crate::number::Analytic;
use crate::step::system::System;
use crate::step::torque::Torque;
use nalgebra::{Matrix3, Quaternion, Vector3};
#[cfg(not(feature = "std"))]
use num_traits::Float as _;

use super::largest;

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
    pub(super) strength: T,
    /// In world axes, at time zero.
    pub(super) direction: Vector3<T>,
    /// In world axes, rad/s.
    pub(super) orbit: Vector3<T>,
}

/// Angular acceleration by spin and attitude, all of it polynomial.
#[derive(Debug, Clone, Copy)]
pub(super) struct Law<T> {
    /// Principal moments, kg m².
    pub(super) moments: Vector3<T>,
    /// `(I2 - I3) / I1` and so on round.
    pub(super) coupling: [T; 3],
    /// By torques that stand still in the body, rad/s².
    pub(super) constant: [T; 3],
    /// Of the damping, 1/s.
    pub(super) decay: [T; 3],
    /// The strength of the dissipation, s/(kg m²).
    pub(super) dissipation: T,
    pub(super) world: [WorldVector<T>; 3],
    /// How many of these there are.
    pub(super) count: usize,
    pub(super) gradient: Option<Gradient<T>>,
    /// A bound of the angular acceleration by torques that do not depend on the spin, rad/s².
    push: f64,
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
            push: 0.0,
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
                    let gradient = Gradient { strength: *strength, direction: *direction, orbit: *orbit };
                    law.gradient = Some(gradient);
                }
                _ => return None,
            }
        }
        law.push = law.bound();
        Some(law)
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
            let sizes = one.vector.map(|x| x.size());
            let rows = one.acceleration.map(|x| x.size()) * sizes;
            largest(rows.as_slice())
        });
        largest(&self.constant)
            + world.sum::<f64>()
            + self.gradient.map_or(0.0, |gradient| gradient.strength.size())
    }

    /// The fastest rate at which losses alone would have the momentum decay, 1/s.
    pub(super) fn loss(&self, momentum: &Vector3<T>) -> f64 {
        let mut loss = largest(&self.decay);
        if !self.dissipation.is_zero() {
            let size = largest(momentum.as_slice());
            let [x, y, z] = [0, 1, 2].map(|i| 1.0 / self.moments[i].size());
            let span = x.max(y).max(z) - x.min(y).min(z);
            loss = loss.max(self.dissipation.size() * size * size * span);
        }
        loss
    }

    /// How fast the motion changes, 1/s.
    pub(super) fn rate(&self, omega: &Vector3<T>, loss: f64) -> f64 {
        let orbit = self.gradient.map_or(0.0, |gradient| largest(gradient.orbit.as_slice()));
        largest(&[largest(omega.as_slice()), self.push.sqrt(), loss, orbit])
    }

    /// The direction of the gravity gradient at a time (s), in world axes.
    pub(super) fn direction(&self, time: T) -> Vector3<T> {
        self.gradient.map_or(Vector3::repeat(T::zero()), |g| turned(&g.direction, &g.orbit, time))
    }

    /// The same law with `unit` seconds for a unit of time.
    pub(super) fn in_units(&self, unit: T) -> Self {
        let squared = |x: T| x * unit * unit;
        let mut law = *self;
        law.constant = law.constant.map(squared);
        law.decay = law.decay.map(|x| x * unit);
        for one in &mut law.world[..law.count] {
            one.acceleration.apply(|x| *x = squared(*x));
        }
        if !law.dissipation.is_zero() {
            law.dissipation /= unit;
        }
        if let Some(gradient) = &mut law.gradient {
            gradient.strength = squared(gradient.strength);
            gradient.orbit.apply(|x| *x *= unit);
        }
        law
    }
}

/// A world vector that has turned at this rate (rad/s) for this time (s).
fn turned<T: Analytic + Copy>(vector: &Vector3<T>, rate: &Vector3<T>, time: T) -> Vector3<T> {
    if rate.iter().all(|x| x.is_zero()) || time.is_zero() {
        return *vector;
    }
    let back: Quaternion<T> = attitude::turn(&rate.map(|x| -(x * time)));
    attitude::rotate_inverse(&back, vector)
}
