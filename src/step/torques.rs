//! All torques on a body, summed by kind: the form in which a [`System`](super::System) holds them.

use super::torque::{Instant, Torque, TorqueFunction, before_or_at};
use crate::attitude;
use crate::number::{Analytic, Field};
use alloc::vec::Vec;
use nalgebra::{Matrix3, Vector3};

/// The sum of torques. The order of torques that add to the same number or vector changes only rounding. In a
/// kick, functions and timed torques act one after another, in their order.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Torques<T: nalgebra::Scalar> {
    /// Constant in body axes, N m.
    pub(crate) constant: Vector3<T>,
    /// At most three.
    pub(crate) world: Vec<WorldVector<T>>,
    pub(crate) periodic: Vec<Periodic<T>>,
    pub(crate) gradients: Vec<Gradient<T>>,
    /// Along each axis, N m s.
    pub(crate) damping: Vector3<T>,
    /// s/(kg m²).
    pub(crate) dissipation: T,
    pub(crate) functions: Vec<TorqueFunction<T>>,
    pub(crate) timed: Vec<Timed<T>>,
}

/// A constant world vector, and the matrix that maps its body components to its torque.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct WorldVector<T: nalgebra::Scalar> {
    pub(crate) vector: Vector3<T>,
    pub(crate) torque: Matrix3<T>,
}

/// A [`Torque::Periodic`].
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Periodic<T: nalgebra::Scalar> {
    pub(crate) amplitude: Vector3<T>,
    pub(crate) rate: T,
    pub(crate) phase: T,
}

/// A [`Torque::GravityGradient`].
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Gradient<T: nalgebra::Scalar> {
    pub(crate) strength: T,
    pub(crate) direction: Vector3<T>,
    pub(crate) orbit: Vector3<T>,
}

/// Torques that act from `start` until before `end`.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Timed<T: nalgebra::Scalar> {
    pub(crate) start: T,
    pub(crate) end: T,
    pub(crate) torques: Torques<T>,
}

impl<T: Field> Torques<T> {
    pub(crate) fn of(torques: &[Torque<T>]) -> Self {
        let none = Vector3::from_fn(|_, _| T::zero());
        let mut sum = Self {
            constant: none.clone(),
            world: Vec::new(),
            periodic: Vec::new(),
            gradients: Vec::new(),
            damping: none,
            dissipation: T::zero(),
            functions: Vec::new(),
            timed: Vec::new(),
        };
        torques.iter().for_each(|torque| sum.add(torque));
        sum
    }

    fn add(&mut self, torque: &Torque<T>) {
        match torque.clone() {
            Torque::InBody(torque) => self.constant += torque,
            Torque::InWorld(vector) => self.add_world(WorldVector { vector, torque: identity() }),
            Torque::Aligning { arm, field } => {
                let none = T::zero;
                let [x, y, z]: [T; 3] = arm.into();
                let cross = Matrix3::new(none(), -z.clone(), y.clone(), z, none(), -x.clone(), -y, x, none());
                self.add_world(WorldVector { vector: field, torque: cross });
            }
            Torque::Damping(coefficients) => self.damping += coefficients,
            Torque::Dissipation(strength) => self.dissipation += strength,
            Torque::GravityGradient { strength, direction, orbit } => {
                self.gradients.push(Gradient { strength, direction, orbit });
            }
            Torque::Periodic { amplitude, rate, phase } => {
                self.periodic.push(Periodic { amplitude, rate, phase });
            }
            Torque::During { start, end, torque } => {
                self.timed.push(Timed { start, end, torques: Self::of(&[*torque]) });
            }
            Torque::Function(function) => self.functions.push(function),
        }
    }

    /// More than three vectors are replaced by the world's three axes.
    fn add_world(&mut self, more: WorldVector<T>) {
        if let Some(one) = self.world.iter_mut().find(|one| one.vector == more.vector) {
            one.torque += more.torque;
            return;
        }
        self.world.push(more);
        if self.world.len() > 3 {
            let axes = (0..3).map(|axis| WorldVector {
                vector: identity().column(axis).into_owned(),
                torque: self.world.iter().fold(identity().map(|_: T| T::zero()), |sum, one| {
                    sum + one.torque.map(|x| x * one.vector[axis].clone())
                }),
            });
            self.world = axes.collect();
        }
    }
}

impl Torques<f64> {
    /// A bound on the sum of constant, periodic and world-fixed torques, N m, and on each coefficient;
    /// infinite where a sum overflows.
    pub(crate) fn largest(&self) -> f64 {
        let world = self.world.iter().map(|one| 3.0 * one.torque.amax() * one.vector.amax());
        let periodic = self.periodic.iter().map(|one| one.amplitude.amax());
        let timed = self.timed.iter().map(|one| one.torques.largest());
        let coefficients = self.damping.amax().max(self.dissipation);
        (self.constant.amax() + world.chain(periodic).chain(timed).sum::<f64>()).max(coefficients)
    }
}

fn identity<T: Field>() -> Matrix3<T> {
    Matrix3::from_fn(|i, j| if i == j { T::one() } else { T::zero() })
}

impl<T: Analytic> Torques<T> {
    /// Their sum in body axes, N m.
    pub(crate) fn at(&self, now: &Instant<'_, T>) -> Vector3<T> {
        let mut sum = self.fixed(now) - self.damping.component_mul(now.omega);
        if !self.dissipation.is_zero() {
            let turned = now.momentum.cross(&now.momentum.cross(now.omega));
            sum += turned.map(|x| x * self.dissipation.clone());
        }
        for function in &self.functions {
            sum += function.at(now, now.omega);
        }
        for timed in self.timed.iter().filter(|timed| timed.acts_at(now.time)) {
            sum += timed.torques.at(now);
        }
        sum
    }

    /// The sum of those that depend on time and attitude alone.
    fn fixed(&self, now: &Instant<'_, T>) -> Vector3<T> {
        let mut sum = self.constant.clone();
        for one in &self.world {
            sum += &one.torque * now.rotation.tr_mul(&one.vector);
        }
        for Periodic { amplitude, rate, phase } in &self.periodic {
            let (_, cosine) = (rate.clone() * now.time.clone() + phase.clone()).sin_cos();
            sum += amplitude.map(|x| x * cosine.clone());
        }
        for gradient in &self.gradients {
            sum += gradient.at(now);
        }
        sum
    }

    /// The momentum (body axes) after the torques have acted for `h` seconds, one kind after another, at
    /// constant attitude and time; `adjoint` applies them in the opposite order. Damping and dissipation use
    /// their exact solutions, so that neither overshoots in a long step; a function acts by the explicit
    /// midpoint rule.
    pub(crate) fn kick(&self, now: &Instant<'_, T>, h: &T, adjoint: bool) -> Vector3<T> {
        let mut momentum = now.momentum.clone();
        for kind in in_order(5, adjoint) {
            momentum = match kind {
                0 => momentum + self.fixed(now).map(|x| x * h.clone()),
                1 => damped(&momentum, &self.damping.component_mul(now.inverse), h),
                2 => dissipated(&momentum, now.inverse, &(self.dissipation.clone() * h.clone())),
                3 => in_order(self.functions.len(), adjoint)
                    .fold(momentum, |momentum, i| self.functions[i].kick(&now.with(&momentum), h)),
                _ => in_order(self.timed.len(), adjoint)
                    .map(|i| &self.timed[i])
                    .filter(|timed| timed.acts_at(now.time))
                    .fold(momentum, |momentum, timed| timed.torques.kick(&now.with(&momentum), h, adjoint)),
            };
        }
        momentum
    }
}

/// The numbers below `count`, ascending or, if `reversed`, descending.
fn in_order(count: usize, reversed: bool) -> impl Iterator<Item = usize> {
    (0..count).map(move |i| if reversed { count - 1 - i } else { i })
}

impl<T: Analytic> Timed<T> {
    fn acts_at(&self, time: &T) -> bool {
        before_or_at(&self.start, time) && !before_or_at(&self.end, time)
    }
}

impl<T: Analytic> Gradient<T> {
    fn at(&self, now: &Instant<'_, T>) -> Vector3<T> {
        let mut here = self.direction.clone();
        if !now.time.is_zero() && self.orbit.iter().any(|x| !x.is_zero()) {
            let back = attitude::turn(&self.orbit.map(|x| -(x * now.time.clone())));
            here = attitude::rotate_inverse(&back, &self.direction);
        }
        let n = now.rotation.tr_mul(&here);
        n.cross(&n.component_div(now.inverse)).map(|x| x * self.strength.clone())
    }
}

/// The momentum after its components have decayed at these rates.
fn damped<T: Analytic>(momentum: &Vector3<T>, rates: &Vector3<T>, h: &T) -> Vector3<T> {
    momentum.zip_map(rates, |x, rate| if rate.is_zero() { x } else { x * (-(rate * h.clone())).exp() })
}

/// The flow of `L' = L x (L x w)` with `w = J L`: each component decays by `exp(-|L|^2 J_i t)`, and then the
/// vector is rescaled to its initial length. Rates are relative to the slowest, so that one component never
/// vanishes; lengths are relative to the largest component, so that no square overflows or underflows.
fn dissipated<T: Analytic>(momentum: &Vector3<T>, inverse: &Vector3<T>, time: &T) -> Vector3<T> {
    if time.is_zero() {
        return momentum.clone();
    }
    let present = |i: &usize| momentum[*i].size() > 0.0;
    let slowest = (0..3).filter(present).min_by(|&i, &j| inverse[i].size().total_cmp(&inverse[j].size()));
    let Some(slowest) = slowest else { return momentum.clone() };
    let largest = &momentum[momentum.map(|x| x.size()).imax()];
    let part = momentum.map(|x| x / largest.clone());
    let square = part.dot(&part);
    let decay = |i: usize| {
        // Subtract the rates first: where the difference is zero the product is zero, however large the other
        // factors are.
        let faster = (inverse[i].clone() - inverse[slowest].clone()) * time.clone();
        (-(faster * largest.clone() * largest.clone() * square.clone())).exp()
    };
    let shrunk = Vector3::from_fn(|i, _| part[i].clone() * decay(i));
    let back = (square.clone() / shrunk.dot(&shrunk)).sqrt();
    shrunk.map(|x| x * back.clone() * largest.clone())
}

#[cfg(test)]
mod tests;
