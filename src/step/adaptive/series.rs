//! The motion as power series in the time, by recurrences [JZ05](crate::references).
//!
//! Spin, attitude and world vectors in body axes are bilinear in each other, so each coefficient is a sum of
//! products of the coefficients before it.

#[cfg(test)]
mod tests;
mod variation;

use super::law::{DissipationLaw, GradientLaw, Law, WorldLaw, turned};
use super::sums::{
    Coefficients, Lanes, Turning, across, across_sums, add_scaled, each, lanes, pair_sums, pairs, scaled,
    sums,
};
use crate::attitude::rotate_inverse;
use alloc::boxed::Box;
use alloc::vec;
use alloc::vec::Vec;
use nalgebra::{Quaternion, Vector3};
pub(super) use variation::{Variation, Variations, identity, in_units};

/// The largest order, that of the least tolerance.
pub(super) const MOST: usize = 24;

/// The number of coefficients of a series of this order, and one that the end of a step adds.
pub(super) const LENGTH: usize = MOST + 2;

/// The series for the dissipation.
#[derive(Debug, Clone)]
struct DissipationSeries<const N: usize> {
    momentum: [Lanes; N],
    /// The rate of the spin without a torque, times the moments.
    coupling: Coefficients<N>,
}

/// The series for the gravity gradient, all in body axes.
#[derive(Debug, Clone)]
struct GradientSeries<const N: usize> {
    direction: Coefficients<N>,
    orbit: [Lanes; N],
    /// Spin minus orbit: the rate at which the direction turns.
    turning: Coefficients<N>,
}

/// What depends on the time alone.
#[derive(Debug, Clone, Default)]
pub(super) struct Now {
    /// Cosine and sine of each periodic torque.
    phases: Vec<[f64; 2]>,
    /// The direction of each gravity gradient, in world axes.
    toward: Vec<Vector3<f64>>,
}

impl Now {
    /// Sets the time, s after the system's.
    pub(super) fn set(&mut self, law: &Law, time: f64) {
        let phase = |rate: f64| <[f64; 2]>::from(turned(0.0, rate, time));
        self.phases.clear();
        self.phases
            .extend(law.periodic.iter().map(|one| phase(one.rate)).map(|[sine, cosine]| [cosine, sine]));
        self.toward.clear();
        self.toward.extend(law.gradients.iter().map(|one| one.circle.at(time)));
    }
}

/// Coefficients of powers of the time in units; `N` of each.
#[derive(Debug, Clone)]
pub(super) struct Series<const N: usize> {
    /// The highest power.
    pub(super) order: usize,
    pub(super) attitude: Turning<N>,
    pub(super) spin: Coefficients<N>,
    /// Cosine and sine of each periodic torque: the last coefficient alone.
    periodic: Vec<[f64; 2]>,
    // Few laws have them, and all runs are moved.
    /// World vectors in body axes.
    world: Vec<[Lanes; N]>,
    dissipation: Option<Box<DissipationSeries<N>>>,
    gradients: Vec<GradientSeries<N>>,
    /// The series of the motion's variations, if these are tracked.
    pub(super) variations: Option<Box<Variations<N>>>,
}

impl<const N: usize> Series<N> {
    /// The series for a law, with variations or without.
    pub(super) fn new(law: &Law, varied: bool) -> Self {
        Self {
            order: 0,
            attitude: Turning::NONE,
            spin: Coefficients::NONE,
            periodic: vec![[0.0; 2]; law.periodic.len()],
            world: vec![[[0.0; 4]; N]; law.world.len()],
            dissipation: law.dissipation.map(|_| {
                Box::new(DissipationSeries { momentum: [[0.0; 4]; N], coupling: Coefficients::NONE })
            }),
            gradients: vec![GradientSeries::NONE; law.gradients.len()],
            variations: varied.then(|| Box::new(Variations::new(law.gradients.len()))),
        }
    }

    /// Whether it has the terms of a law.
    pub(super) fn fits(&self, law: &Law) -> bool {
        self.world.len() == law.world.len()
            && self.gradients.len() == law.gradients.len()
            && self.dissipation.is_some() == law.dissipation.is_some()
    }

    /// The first coefficients at a time: the state itself, with its spin in units.
    pub(super) fn begin(&mut self, law: &Law, now: &Now, attitude: &Quaternion<f64>, spin: [f64; 3]) {
        let in_body = |v: &Vector3<f64>| lanes(rotate_inverse(attitude, v).into());
        self.order = 0;
        let q = &attitude.coords;
        self.attitude.set(0, [q.w, q.x, q.z, -q.y], lanes(spin));
        self.spin.set(0, lanes(spin));
        for (rows, one) in self.world.iter_mut().zip(&law.world) {
            rows[0] = in_body(&one.vector);
        }
        self.periodic.clone_from(&now.phases);
        for ((own, gradient), toward) in self.gradients.iter_mut().zip(&law.gradients).zip(&now.toward) {
            own.orbit[0] = in_body(&gradient.orbit);
            own.direction.set(0, in_body(toward));
        }
    }

    /// The coefficients of everything up to a power.
    pub(super) fn extend_to(&mut self, order: usize, law: &Law) {
        if law.world.is_empty() && law.gradients.is_empty() {
            self.extend_with::<false>(order, law);
        } else {
            self.extend_with::<true>(order, law);
        }
        if self.variations.is_some() {
            self.extend_variations(law);
        }
    }

    #[inline(never)]
    fn extend_variations(&mut self, law: &Law) {
        if let Some(mut variations) = self.variations.take() {
            while variations.order < self.order.min(N - 1) {
                variations.extend(self, law);
            }
            self.variations = Some(variations);
        }
    }

    /// The coefficients up to a power, with a vector that is multiplied by the spin along with the attitude,
    /// or without.
    // Not inlined: alone it has the registers to itself.
    #[inline(never)]
    fn extend_with<const ACROSS: bool>(&mut self, order: usize, law: &Law) {
        // Constant terms are in the first rate alone.
        let mut rate = if self.order == 0 { law.constant } else { [0.0; 4] };
        while self.order < order.min(N - 1) {
            self.extend::<ACROSS>(law, core::mem::replace(&mut rate, [0.0; 4]));
        }
    }

    /// The next coefficient of everything, given the part of the spin's rate that is constant.
    #[inline(always)]
    fn extend<const ACROSS: bool>(&mut self, law: &Law, mut rate: Lanes) {
        let n = self.order.min(N - 2);
        let inverse = 1.0 / (n + 1) as f64;
        let (attitude, spin, alone) = (&self.attitude, &self.spin, law.world.is_empty());
        // The sums come last: by then all other values are ready.
        if let Some(decay) = &law.decay {
            for ((rate, decay), spin) in rate.iter_mut().zip(decay).zip(&spin.up[n]) {
                *rate -= *decay * *spin;
            }
        }
        if !self.periodic.is_empty() {
            for ([cosine, sine], one) in self.periodic.iter_mut().zip(&law.periodic) {
                add_scaled(&mut rate, &one.cosine, *cosine);
                add_scaled(&mut rate, &one.sine, *sine);
                let turn = one.rate_in_units * inverse;
                (*cosine, *sine) = (-(*sine * turn), *cosine * turn);
            }
        }
        let vector = match (&*self.world, &*self.gradients) {
            ([first, ..], _) if ACROSS => first,
            (_, [own, ..]) if ACROSS => &own.orbit,
            _ => &attitude.up,
        };
        let sums = sums::<N, ACROSS>(n + 1, attitude, vector, spin);
        if ACROSS && let ([rows, more @ ..], [first, others @ ..]) = (&mut *self.world, &*law.world) {
            first.add_acceleration(&rows[n], &mut rate);
            rows[n + 1] = scaled(&across(&sums.across), inverse);
            // Few laws have more, and even an empty loop takes time.
            if !more.is_empty() {
                for (rows, one) in more.iter_mut().zip(others) {
                    one.add_acceleration(&rows[n], &mut rate);
                    rows[n + 1] = scaled(&across(&across_sums(n + 1, rows, spin)), inverse);
                }
            }
        }
        let [[w, x], [z, y]] = sums.turn;
        let turned = scaled(&[w, x, z, y], 0.25 * inverse);
        let pairs = pairs(&sums.pairs);
        if let (Some(own), Some(dissipation)) = (&mut self.dissipation, &law.dissipation) {
            let free = each(|i| law.coupling[i] * pairs[i]);
            own.add(dissipation, &spin.up[n], &free, n, &mut rate);
        }
        if ACROSS && let ([own, more @ ..], [first, others @ ..]) = (&mut *self.gradients, &*law.gradients) {
            let turned =
                if alone { across(&sums.across) } else { across(&across_sums(n + 1, &own.orbit, spin)) };
            own.add(first, turned, &spin.up[n], n, inverse, &mut rate);
            if !more.is_empty() {
                for (own, law) in more.iter_mut().zip(others) {
                    let turned = across(&across_sums(n + 1, &own.orbit, spin));
                    own.add(law, turned, &spin.up[n], n, inverse, &mut rate);
                }
            }
        }
        // The next coefficients wait for the sums alone: all else is scaled beforehand.
        let next = |i: usize| law.coupling[i] * inverse * pairs[i] + rate[i] * inverse;
        let spin = each(next);
        self.attitude.set(n + 1, turned, spin);
        self.spin.set(n + 1, spin);
        self.order = n + 1;
    }

    /// Sets the coefficients above the highest power to what changes attitude and spin by this much after `x`
    /// units of time.
    pub(super) fn append(&mut self, x: f64, attitude: &Lanes, spin: &Lanes) {
        let per = 1.0 / (0..self.order).fold(x, |power, _| power * x);
        // Where the inverse is infinite, the change is none.
        let per = if per.is_finite() { per } else { 0.0 };
        let next = (self.order + 1).min(N - 1);
        (self.attitude.up[next], self.spin.up[next]) = (scaled(attitude, per), scaled(spin, per));
    }

    /// The angular acceleration by the torques at the start.
    pub(super) fn torque(&self, law: &Law) -> [f64; 3] {
        let ([x, y, z, _], rate) = (self.spin.up[0], &self.spin.up[1]);
        let pairs = [y * z, z * x, x * y];
        let torque = |i: usize| rate[i] - law.coupling[i] * pairs[i];
        [torque(0), torque(1), torque(2)]
    }

    /// The larger of the attitude's coefficient of this power and the momentum's, in units of `1 / weights`;
    /// or the variations' coefficient, if it is larger relative to the sizes of their columns.
    #[inline(always)]
    pub(super) fn size(&self, power: usize, weights: &[f64; 3]) -> f64 {
        let spin = &self.spin.up[power];
        let momentum = [spin[0].abs() * weights[0], spin[1].abs() * weights[1], spin[2].abs() * weights[2]];
        let attitude = &self.attitude.up[power];
        let size = super::largest(&[super::largest(attitude), super::largest(&momentum)]);
        self.variations.as_ref().map_or(size, |variations| super::largest(&[size, variations.size(power)]))
    }

    /// The coefficients of a component of the spin.
    pub(super) fn spin(&self, axis: usize) -> [f64; N] {
        core::array::from_fn(|power| self.spin.up[power][axis % 3])
    }

    /// The changes of attitude and spin after `x` units of time.
    pub(super) fn value(&self, x: f64) -> [Lanes; 2] {
        let [mut q, mut w] = [[0.0; 4]; 2];
        let powers = 1..=self.order;
        for (attitude, spin) in self.attitude.up[powers.clone()].iter().zip(&self.spin.up[powers]).rev() {
            for i in 0..4 {
                q[i] = q[i] * x + attitude[i];
                w[i] = w[i] * x + spin[i];
            }
        }
        [scaled(&q, x), scaled(&w, x)]
    }

    /// The changes of attitude and spin after `x` units of time, and their rates there.
    // Not inlined: where a number is not used, the compiler does not compute two at a time.
    #[inline(never)]
    pub(super) fn at(&self, x: f64) -> [Lanes; 4] {
        let [mut q, mut w, mut dq, mut dw] = [[0.0; 4]; 4];
        let powers = 1..=self.order;
        for (attitude, spin) in self.attitude.up[powers.clone()].iter().zip(&self.spin.up[powers]).rev() {
            for i in 0..4 {
                dq[i] = dq[i] * x + q[i];
                dw[i] = dw[i] * x + w[i];
                q[i] = q[i] * x + attitude[i];
                w[i] = w[i] * x + spin[i];
            }
        }
        let rate = |value: &Lanes, derivative: &Lanes| each(|i| value[i] + derivative[i] * x);
        [scaled(&q, x), scaled(&w, x), rate(&q, &dq), rate(&w, &dw)]
    }
}

impl WorldLaw {
    /// Adds the angular acceleration by the vector in body axes.
    #[inline(always)]
    fn add_acceleration(&self, vector: &Lanes, rate: &mut Lanes) {
        for (acceleration, &x) in self.acceleration.iter().zip(vector) {
            add_scaled(rate, acceleration, x);
        }
    }
}

impl<const N: usize> DissipationSeries<N> {
    /// Adds the angular acceleration `J k L x (L x w)`; the argument is the acceleration without a torque.
    fn add(&mut self, law: &DissipationLaw, spin: &Lanes, free: &Lanes, n: usize, rate: &mut Lanes) {
        let m = &law.moments;
        self.coupling.set(n, each(|i| m[i] * free[i]));
        self.momentum[n] = each(|i| m[i] * spin[i]);
        let across = across(&across_sums(n + 1, &self.momentum, &self.coupling));
        for i in 0..4 {
            rate[i] += law.acceleration[i] * across[i];
        }
    }
}

impl<const N: usize> GradientSeries<N> {
    const NONE: Self =
        Self { direction: Coefficients::NONE, orbit: [[0.0; 4]; N], turning: Coefficients::NONE };

    /// Adds the angular acceleration by the gravity gradient, and computes the next coefficients of the
    /// orbit, from its products with the spin, and of the direction.
    #[inline(always)]
    fn add(
        &mut self,
        law: &GradientLaw,
        turned: Lanes,
        spin: &Lanes,
        n: usize,
        inverse: f64,
        rate: &mut Lanes,
    ) {
        self.turning.set(n, each(|i| spin[i] - self.orbit[n][i]));
        self.orbit[n + 1] = scaled(&turned, inverse);
        let turned = across_sums(n + 1, &self.direction.up, &self.turning);
        let pairs = pairs(&pair_sums(n + 1, &self.direction));
        for i in 0..4 {
            rate[i] -= law.acceleration[i] * pairs[i];
        }
        self.direction.set(n + 1, scaled(&across(&turned), inverse));
    }
}
