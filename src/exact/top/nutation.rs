//! A motion in which the axis of a top rises and sinks, or precesses steadily, and its constants in theta
//! functions.

use super::factor::{Carrier, Complementary, Direct, Shape, align_weakest, turn_together};
use super::factor::{complementary_denominator, cubic, denominator};
use super::integrals::{Integrals, Start};
use crate::exact::cayley_klein::times;
use crate::exact::elliptic::{
    NOME_RATIO, quarter_period, quarter_period_from_root, rf_of_roots, sin_cos_of_turns,
};
use crate::exact::elliptic_motion::{Reduction, argument_at_start, phase_at_start};
use crate::number::DoubleDouble;
use crate::number::functions::{atan2, exp, hypot};
use core::f64::consts::{PI, TAU};
#[cfg(not(feature = "std"))]
use num_traits::Float as _;

/// The constants from which an instant is computed, in units of one rate.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Nutation {
    form: Form,
    /// The carriers of `alpha`, `beta` and the spin across the axis.
    pub(super) carriers: [Carrier; 3],
    /// The time from the lowest position to the highest and back (T10); infinite on the separatrix.
    pub(super) half_period: DoubleDouble,
    /// The rate of Jacobi's argument.
    pub(super) rate: f64,
    /// The mean rate at which the axis turns about the vertical, in radians.
    pub(super) precession: f64,
}

/// The form of the series.
#[derive(Debug, Clone, Copy, PartialEq)]
enum Form {
    /// In the nome.
    Direct {
        /// Turns of the phase per unit of time, and its sine and cosine at the start.
        turns: DoubleDouble,
        start: [f64; 2],
        denominator: [f64; 4],
        factors: [Direct; 3],
    },
    /// In the complementary nome, which is zero on the separatrix, where the motion does not return.
    Complementary { reduction: Reduction, nome: f64, factors: [Complementary; 3] },
}

impl Nutation {
    /// `alpha` and `beta`, of one common length, and the spin across the axis.
    #[inline(always)]
    pub(super) fn at(&self, time: f64) -> ([[f64; 2]; 2], [f64; 2]) {
        let (factors, denominator, halves) = match &self.form {
            Form::Direct { turns, start: [sin0, cos0], denominator, factors } => {
                let (sin, cos) = sin_cos_of_turns(*turns * time);
                let phase @ [sin, cos] = [sin0 * cos + cos0 * sin, cos0 * cos - sin0 * sin];
                let denominator = cubic(denominator, (cos - sin) * (cos + sin));
                (factors.each_ref().map(|factor| factor.at(phase)), denominator, DoubleDouble::ZERO)
            }
            Form::Complementary { reduction, nome, factors } => {
                let exponentials = reduction.argument(time).exponentials();
                let denominator = complementary_denominator(*nome, &exponentials);
                (factors.each_ref().map(|factor| factor.at(&exponentials)), denominator, exponentials.halves)
            }
        };
        let inverse = 1.0 / denominator;
        let [alpha, beta, across] = [0, 1, 2].map(|k| times(self.carriers[k].at(time, halves), factors[k]));
        ([alpha, beta], across.map(|x| x * inverse))
    }

    /// Whether the motion is finite at two sample times, and its rate positive and finite.
    pub(super) fn is_finite(&self) -> bool {
        [1e-3, 0.5].into_iter().all(|time| {
            let ([a, b], spin) = self.at(time);
            let length = hypot(hypot(a[0], a[1]), hypot(b[0], b[1]));
            length > 0.0 && length.is_finite() && spin[0].is_finite() && spin[1].is_finite()
        }) && self.rate > 0.0
            && self.rate.is_finite()
    }
}

/// `F = sqrt(a) R_F(x, y, z)` of squares (T15), and the quarter period minus `F`; `square` is the square of
/// the other modulus. Each has full relative accuracy where it is small.
fn depths(a: DoubleDouble, [x, y, z]: [DoubleDouble; 3], square: DoubleDouble) -> [f64; 2] {
    let root = |x: DoubleDouble| x.hi().max(0.0).sqrt();
    let product = |a: DoubleDouble, [x, y, z]: [DoubleDouble; 3]| {
        if a.hi() > 0.0 { root(a) * rf_of_roots(root(x), root(y), root(z)) } else { 0.0 }
    };
    let rest = if square.hi() == 0.0 { f64::INFINITY } else { product(x, [square * a, square * z, y]) };
    [product(a, [x, y, z]), rest]
}

fn sense(x: DoubleDouble) -> f64 {
    if x.hi() < 0.0 { -1.0 } else { 1.0 }
}

/// `x/y`, and zero where `y` is zero.
fn ratio(x: DoubleDouble, y: DoubleDouble) -> DoubleDouble {
    if y.hi() == 0.0 { DoubleDouble::ZERO } else { x / y }
}

/// The differences of the roots times the pull: `long` and `short` are those of the third root from the
/// lowest and the highest of the motion, and `range` that of these two.
struct Spans {
    long: DoubleDouble,
    short: DoubleDouble,
    range: DoubleDouble,
    /// The same as `range`, but not times the pull.
    swept: DoubleDouble,
}

impl Integrals {
    fn spans(&self) -> Spans {
        let swept = self.down + self.up;
        Spans {
            long: self.third + self.pull * self.tops[0],
            short: self.third + self.pull * self.tops[1],
            range: self.pull * swept,
            swept,
        }
    }

    /// `alpha`, `beta` and the spin across the axis: their zeros (T13, T14) and their sides (T16).
    fn shapes(&self, start: &Start) -> [Shape; 3] {
        let Spans { long, short, range, swept } = self.spans();
        let ([low, high], [lowest, highest]) = (self.bottoms, self.tops);
        let [still, beyond, fastest] = self.rest();
        let size = |square: DoubleDouble| square.hi().max(0.0).sqrt();
        // Where the motion only approaches the upright position, it never passes a zero.
        let saddle = short.hi() == 0.0;
        let square = ratio(range, long);
        let zero = |a, of| if saddle { [0.0; 2] } else { depths(a, of, square) };
        let ([w, z], [x, y], [p, q]) = (start.alpha, start.beta, start.across);
        let b = self.along.hi();
        let [v, u] = self.vertical.map(DoubleDouble::hi);
        let alpha = Shape {
            first: true,
            depths: depths(
                low * long,
                [swept * long, swept * (self.pull * 2.0 + self.third), high * long],
                square,
            ),
            sense: sense(self.at_bottom),
            size: size(high * 0.5),
            rate: ratio(self.at_bottom, high * 2.0),
            start: start.alpha,
            // q' = q w/2.
            start_rate: [-p * x - q * y - b * z, -(p * y) + q * x + b * w],
        };
        let beta = Shape {
            first: false,
            depths: zero(highest * long, [self.third * swept, swept * short, lowest * short]),
            sense: sense(self.at_top),
            size: size(lowest * 0.5),
            rate: ratio(self.at_top, lowest * 2.0),
            start: start.beta,
            start_rate: [p * w - q * z + b * y, p * z + q * w - b * x],
        };
        let low_about = self.about + self.along * self.down;
        let across = Shape {
            first: false,
            depths: zero(still * long, [beyond * range, range * short, fastest * short]),
            sense: sense(self.turning_at_zero()),
            size: size(fastest),
            rate: ratio(self.pull * low_about * -0.5, fastest),
            start: start.across,
            start_rate: [u, -v],
        };
        [alpha, beta, across]
    }

    /// The motion of a spherical top (T8) from its start (T9), in the axes of a body that turns about its
    /// axis faster by `ahead` per unit of time (T3).
    pub(super) fn nutation(&self, start: &Start, ahead: DoubleDouble) -> Nutation {
        let Spans { long, short, range, swept } = self.spans();
        let rate = long.sqrt() * 0.5;
        let separatrix = short.hi() <= 0.0;
        let complement = ratio(short, long).sqrt();
        let modulus = ratio(range, long).hi().max(0.0).sqrt();
        let quarter = if separatrix {
            DoubleDouble::from(f64::INFINITY)
        } else {
            quarter_period_from_root(complement, complement.sqrt())
        };
        let other = quarter_period(modulus);
        let shapes = self.shapes(start);
        let part = |x: DoubleDouble, y: DoubleDouble| ratio(x, y).hi().clamp(0.0, 1.0).sqrt();
        let sn = part(self.down, swept).copysign(self.rising.hi());
        let cn = if swept.hi() > 0.0 { part(self.up, swept) } else { 1.0 };
        let dn = part(self.third + self.pull * self.from_top, long);
        let sn = if self.rising.hi() == 0.0 { sn.abs() } else { sn };
        let turn = ahead / (DoubleDouble::PI * 2.0);
        let (form, mut carriers, lowest, half_periods) = if !separatrix && other / quarter.hi() >= NOME_RATIO
        {
            let quarter_hi = quarter.hi();
            let nome = exp(-PI * (other / quarter_hi));
            let turns = rate / (quarter * 4.0);
            let start = phase_at_start([sn, cn, dn], complement.hi(), quarter_hi);
            let all = shapes.map(|shape| Direct::new(nome, quarter_hi, turns, start, &shape));
            let lowest = -atan2(start[0], start[1]) / (TAU * turns.hi());
            let factors = all.map(|one| one.0);
            let form = Form::Direct { turns, start, denominator: denominator(nome), factors };
            (form, all.map(|one| one.1), lowest, Some(turns * 2.0))
        } else {
            let start = argument_at_start([sn, cn, dn], complement.hi(), quarter, 0);
            let reduction = Reduction::new(start, rate, quarter, other, 1.0);
            let exponentials = reduction.argument(0.0).exponentials();
            let nome = reduction.nome_root * reduction.nome_root;
            let all =
                shapes.map(|shape| Complementary::new(nome, reduction.stretch, rate, &exponentials, &shape));
            let lowest = -start.hi() / rate.hi();
            let form = Form::Complementary { reduction, nome, factors: all.map(|one| one.0) };
            (form, all.map(|one| one.1), lowest, (!separatrix).then_some(reduction.rate))
        };
        self.join(&shapes, &mut carriers, lowest, half_periods, turn);
        let half_period = if separatrix { quarter } else { quarter * 2.0 / rate };
        Nutation {
            form,
            carriers,
            half_period,
            rate: rate.hi(),
            precession: self.precession(long, complement.hi(), quarter.hi()),
        }
    }

    /// Makes the carriers consistent: the one whose direction at the start is lost in rounding follows from
    /// the others. Then adds the turn of the body by `ahead`.
    fn join(
        &self,
        shapes: &[Shape; 3],
        carriers: &mut [Carrier; 3],
        lowest: f64,
        half_periods: Option<DoubleDouble>,
        ahead: DoubleDouble,
    ) {
        if let Some(half_periods) = half_periods {
            let spin = hypot(shapes[2].size, self.along.hi());
            turn_together(carriers, [1.0, 1.0, spin], half_periods);
        }
        let shares = shapes.map(|shape| shape.share());
        let share = |k: usize| shares[k];
        for (weakest, [a, b]) in [[1, 2], [2, 0], [0, 1]].into_iter().enumerate() {
            if share(weakest) > 0.0 && share(weakest) < 0.1 * share(a).min(share(b)) {
                let about_lowest = self.at_bottom - self.along * self.bottoms[0];
                let sign = -shapes[0].sense * sense(about_lowest);
                align_weakest(carriers, weakest, sign, lowest);
            }
        }
        for (carrier, times) in carriers.iter_mut().zip([0.5, -0.5, -1.0]) {
            carrier.drift = carrier.drift + ahead * times;
        }
    }
}
