//! The constants of an elliptic motion, from its conserved quantities and the spin at the start.

use super::range_reduction::Reduction;
use super::{ComplementaryAttitude, ComplementarySpin, Constants, DirectAttitude, DirectSpin};
use super::{EllipticMotion, Form};
use crate::dynamics::invariants::Asymmetric;
use crate::error::{Error, Refusal, Subject};
use crate::exact::cayley_klein::{ComplementaryPair, DirectPair, Pair, Shape};
use crate::exact::elementary::Axes;
use crate::exact::elliptic::{self, ComplementarySeries, DirectSeries, NOME_RATIO};
use crate::exact::geometry::quarter_period;
use crate::inertia::Axis;
use crate::number::{DoubleDouble, Real, splat};

/// Up to this power of two the spin's components come out in one product with their amplitudes, with all
/// digits: the rest of the exponent's range is room for what is small relative to the largest.
const ONE_PRODUCT: i32 = 600;

/// The motion in scaled units: everything that both series are prepared from. Triples go across, middle,
/// circled.
struct Preparation<'a, T> {
    motion: &'a Asymmetric<T>,
    modulus: T,
    complement: T,
    /// `K`, and `K'`.
    quarter: DoubleDouble<T>,
    other: T,
    direct: bool,
    /// Powers of two taken into cn, dn and the complement, and into sn and cn.
    shift: i32,
    lift: i32,
    scaled_complement: T,
    /// The first two times `2^lift`.
    amplitudes: [DoubleDouble<T>; 3],
    /// The spin at the start, in the units of the series.
    omega: [T; 3],
    /// The rate of Jacobi's argument, with its sign.
    rate: DoubleDouble<T>,
    /// 1 where the spin along the circled axis is positive, otherwise -1.
    sign: T,
    /// Whether across, middle and circled follow each other in cyclic order.
    cyclic: bool,
    /// `2E` and `L`.
    twice_energy: DoubleDouble<T>,
    momentum: DoubleDouble<T>,
}

/// What both series have in common.
struct Prepared<T> {
    form: Form<T>,
    argument: DoubleDouble<T>,
    /// Corrected so that the start comes out as it was given.
    amplitudes: [T; 3],
}

impl<T: Real> EllipticMotion<T> {
    /// Refuses a deviation from the middle axis so small relative to the spin that `f64` cannot hold their
    /// ratio even when scaled up: 1e-570.
    pub(crate) fn new(motion: &Asymmetric<T>, omega: &[T; 3]) -> Result<Self, Error> {
        let preparation = Preparation::new(motion, omega)?;
        let Preparation { modulus, complement, scaled_complement, quarter, rate, .. } = preparation;
        let shares = preparation.shares();
        let Prepared { form, argument, amplitudes } =
            if preparation.direct { preparation.direct(shares) } else { preparation.complementary(shares) };
        let largest = motion.moments[motion.middle].lt(motion.moments[motion.around]);
        let about = if largest { Axis::Largest } else { Axis::Smallest };
        let lifts = preparation.lifts();
        Ok(Self {
            axes: preparation.axes(),
            amplitudes,
            unscale: preparation.unscale(),
            greatest: preparation.greatest(),
            form,
            constants: Constants {
                about,
                modulus,
                complement,
                scaled_complement,
                lifts,
                rate,
                quarter,
                argument,
                shares,
            },
        })
    }
}

impl<'a, T: Real> Preparation<'a, T> {
    fn new(motion: &'a Asymmetric<T>, omega: &[T; 3]) -> Result<Self, Error> {
        // (C4)
        let modulus = motion.modulus();
        let complement = motion.complement(0).hi();
        // (C8)
        let quarter = quarter_period(motion);
        let other = elliptic::quarter_period(modulus);
        let direct = !motion.separatrix && !(other / quarter.hi()).lt(splat(NOME_RATIO));
        // What is small may be out of range relative to what is not: near the saddle the across and the
        // circled component (with cn, dn and the complement), in a small libration the across and the middle
        // one.
        let shift = if direct || motion.small > -200 { 0 } else { (-motion.small).min(1000) };
        let lift = if direct && motion.off_axis < -200 { -motion.off_axis } else { 0 };
        let scaled_complement = if shift == 0 { complement } else { motion.complement(shift).hi() };
        Refusal::OutOfRange { what: Subject::ComplementaryModulus, value: complement.lane(0) }
            .when(!motion.separatrix && !direct && !scaled_complement.has_all_digits())?;
        let at_start = |axis: usize, up: i32| omega[axis].times_power_of_two(up - motion.clock);
        let (x, m, c) = (motion.across, motion.middle, motion.around);
        let spin = [at_start(x, shift + lift), at_start(m, lift), at_start(c, shift)];
        let i = motion.moments;
        let sign = if T::zero().lt(spin[2]) { 1.0 } else { -1.0 };
        let cyclic = (x + 1) % 3 == m;
        let direction = if cyclic { 1.0 } else { -1.0 } * sign * if i[m].lt(i[c]) { 1.0 } else { -1.0 };
        // L and 2E in the same units.
        let w = [0, 1, 2].map(|axis| at_start(axis, 0));
        let sum = |f: &dyn Fn(usize) -> DoubleDouble<T>| f(0) + f(1) + f(2);
        let square = |k: usize| DoubleDouble::product(w[k], w[k]);
        Ok(Self {
            motion,
            modulus,
            complement,
            quarter,
            other,
            direct,
            shift,
            lift,
            scaled_complement,
            // (C5), by the sums of (C3)
            amplitudes: motion.amplitudes(lift),
            omega: spin,
            // (C6), with its sign
            rate: motion.rate().times_exact(splat(direction)),
            sign: splat(sign),
            cyclic,
            // (C1)
            twice_energy: sum(&|k| square(k) * i[k]),
            momentum: sum(&|k| square(k) * DoubleDouble::product(i[k], i[k])).sqrt(),
        })
    }

    fn axes(&self) -> [usize; 3] {
        [self.motion.across, self.motion.middle, self.motion.around]
    }

    /// The three moments.
    fn moments(&self) -> [T; 3] {
        self.axes().map(|axis| self.motion.moments[axis])
    }

    /// The powers of two taken into the three components.
    fn lifts(&self) -> [i32; 3] {
        [self.shift + self.lift, self.lift, self.shift]
    }

    /// The momentum's greatest shares.
    fn shares(&self) -> [T; 3] {
        // (C17)
        let [across, middle, circled] = self.amplitudes;
        let [i_x, i_m, i_c] = self.moments();
        let momentum = self.momentum.hi();
        let share =
            |amplitude: DoubleDouble<T>, moment: T| amplitude.scaled(-self.lift).hi() * moment / momentum;
        [share(across, i_x), share(middle, i_m), circled.hi() * i_c / momentum]
    }

    /// The largest component that the spin ever has, rad/s.
    fn greatest(&self) -> T {
        let top = |k: usize, up: i32| self.amplitudes[k].hi().times_power_of_two(self.motion.clock - up);
        let larger = |a: T, b: T| T::select(a.lt(b), b, a);
        larger(larger(top(0, self.lift), top(1, self.lift)), top(2, 0))
    }

    /// Whether the amplitudes can be in rad/s.
    fn within_range(&self) -> bool {
        self.lifts() == [0; 3] && self.motion.clock.abs() <= ONE_PRODUCT
    }

    /// The powers of two that take the three components, in the order of the body, to rad/s if the amplitudes
    /// are not.
    fn unscale(&self) -> Option<[[T; 2]; 3]> {
        if self.within_range() {
            return None;
        }
        let power = |exponent: i32| T::one().times_power_of_two(exponent);
        let mut powers = [[T::one(); 2]; 3];
        for (axis, up) in self.axes().into_iter().zip(self.lifts()) {
            let total = self.motion.clock - up;
            let part = if total < -900 { 600 } else { 0 };
            powers[axis] = [power(total + part), power(-part)];
        }
        Some(powers)
    }

    /// The amplitudes as the series take them: in rad/s where that is within range.
    fn in_series(&self, amplitudes: [T; 3]) -> [T; 3] {
        let clock = if self.within_range() { self.motion.clock } else { 0 };
        amplitudes.map(|x| x.times_power_of_two(clock))
    }

    /// `sn`, and `cn`, `dn` times `2^shift`, at the start.
    fn values(&self) -> [T; 3] {
        let [w_x, w_m, w_c] = self.omega;
        let [across, middle, circled] = self.amplitudes.map(DoubleDouble::hi);
        // (C10)
        [w_m / middle, w_x / across, w_c.abs() / circled]
    }

    /// What the attitude's theta functions are made from, with their zero at `depth` per argument.
    fn shape(&self, shares: [T; 3], per_argument: T) -> Shape<T> {
        let Asymmetric { d_cx, d_cm, d_mx, .. } = self.motion;
        let [d_cx, d_cm, d_mx] = [d_cx, d_cm, d_mx].map(|d| d.hi());
        let [i_x, i_m, i_c] = self.moments();
        // (C18)
        // The zero: y = rho^(-1/2) R_F((rho-1)/rho, (rho-1+m)/rho, 1).
        let over_rho = d_cm * i_x / (d_cx * i_m);
        let excess = d_mx * i_c / (d_cx * i_m);
        let shifted = (excess + self.modulus * self.modulus * over_rho).sqrt();
        // (C19)
        let depth = over_rho.sqrt() * elliptic::rf_of_roots(excess.sqrt(), shifted, T::one());
        Shape {
            cyclic: self.cyclic,
            forward: T::zero().lt(self.sign),
            // (C24)
            tilt: shares[1] / (shares[2] * self.complement + 1.0),
            // (C21), (C31)
            depth: pi::<T>() * depth / per_argument,
        }
    }

    /// By the series of the nome.
    fn direct(&self, shares: [T; 3]) -> Prepared<T> {
        let quarter = self.quarter.hi();
        // (C9)
        let nome = (-pi::<T>() * (self.other / quarter)).exp_and_exp_m1().0;
        let series = DirectSeries::new(nome);
        let pair = DirectPair::of_shape(nome, &self.shape(shares, quarter));
        // (C13)
        let quarters = self.rate / self.quarter;
        let turns_per_argument = splat::<T>(0.25) / quarter;
        let [sin, cos] = phase_at_start(self.values(), self.complement, quarter);
        let (amplitudes, shift) = self.meeting_the_start(series.values(sin, cos));
        let angle = pi::<T>() * 2.0 * turns_per_argument * shift;
        let start @ [sin, cos] = [sin - cos * angle, cos + sin * angle];
        // Steady rate: that of the smooth phase about L where the across component is largest, less what
        // the theta function turns there.
        let (circled, [_, _, i_c]) = (self.amplitudes[2], self.moments());
        // (C20)
        let about = (self.twice_energy + self.momentum * circled) / (self.momentum + circled * i_c);
        // (C25)
        let drift = about.times_exact(self.sign) / DoubleDouble::pi() - quarters * pair.turning_at_zero();
        let amplitudes_in_series = self.in_series(amplitudes);
        let axes = Axes::new(self.axes());
        let spin = DirectSpin { series, start, quarters, amplitudes: amplitudes_in_series, axes };
        let attitude = DirectAttitude { pair, start: of_length_one(pair.raw(sin, cos)), drift };
        // From the nearest flip, where it has all its digits.
        let angle = sin.abs().atan2(cos.abs()).with_sign(sin * cos);
        let argument = DoubleDouble::from(angle / (pi::<T>() * 2.0 * turns_per_argument));
        Prepared { form: Form::Direct { spin, attitude }, argument, amplitudes }
    }

    /// By the series of the complementary nome.
    fn complementary(&self, shares: [T; 3]) -> Prepared<T> {
        let Self { rate, quarter, other, .. } = *self;
        let values = self.values();
        let start = argument_at_start(values, self.scaled_complement, quarter, self.shift);
        let turn = splat(if values[1].lt(T::zero()) { -1.0 } else { 1.0 });
        // (C27)
        let reduction = Reduction::new(start, rate, quarter, other, turn);
        let Reduction { nome_root, stretch, .. } = reduction;
        let power = T::one().times_power_of_two(self.shift);
        let series = ComplementarySeries::new(nome_root * nome_root, self.scaled_complement, power);
        let pair = ComplementaryPair::of_shape(nome_root, &self.shape(shares, other * 4.0));
        let zero = T::zero();
        let (amplitudes, shift) = self.meeting_the_start(reduction.argument(zero).values(&series));
        let (argument, reduction) = (start - DoubleDouble::from(shift), reduction.back(shift));
        let start = of_length_one(reduction.argument(zero).pair(&pair));
        let (turned, half) = (rate * (stretch * pair.turning_at_saddle()), splat(0.5));
        let quarter_turn = DoubleDouble::pi().times_exact(half);
        let drift = (self.rate_about_momentum().times_exact(half) - turned) / quarter_turn;
        // (C33)
        let step = pair.angle_at_saddle() * 2.0 / (pi::<T>() * 0.5);
        let axes = Axes::new(self.axes());
        let spin = ComplementarySpin { series, reduction, amplitudes: self.in_series(amplitudes), axes };
        let attitude = ComplementaryAttitude { pair, start, drift, step };
        Prepared { form: Form::Complementary { spin, attitude }, argument, amplitudes }
    }

    /// How fast the smooth phase about the momentum runs at the saddle: as `L/I_M` but for terms that vanish
    /// with the complement.
    fn rate_about_momentum(&self) -> DoubleDouble<T> {
        let [_, i_m, i_c] = self.moments();
        let slow = self.amplitudes[2].hi() * self.complement;
        let lead = self.momentum / DoubleDouble::from(i_m);
        // (C34), with the discriminant of (C2)
        let sign = splat::<T>(if i_m.lt(i_c) { 1.0 } else { -1.0 });
        let signed_distance = sign * self.motion.distance_from_separatrix();
        let l = self.momentum.hi();
        let rest = -(signed_distance + l * slow * (i_c - i_m)) / (i_m * (l + i_c * slow));
        (lead + DoubleDouble::from(rest)).times_exact(self.sign)
    }

    /// The amplitudes scaled, and Jacobi's argument at the start shifted back, by roundings, so that the
    /// start comes out as it was given; from the functions as the series give them there.
    ///
    /// The difference between the relative errors of the across and middle components is corrected in the
    /// phase; their common part, weighted so that a component near zero does not count, is corrected in the
    /// amplitude.
    fn meeting_the_start(&self, [sn, cn, dn]: [T; 3]) -> ([T; 3], T) {
        let [across, middle, circled] = self.amplitudes.map(DoubleDouble::hi);
        let mut amplitudes = [across, middle, self.sign * circled];
        let found = [cn, sn, dn];
        let off = [0, 1, 2].map(|k| (amplitudes[k] * found[k] / self.omega[k] - 1.0).but_for_rounding());
        // (C12)
        let square = sn * sn;
        let shared = off[1] * square + off[0] * (-square + 1.0);
        let quotient = sn * (cn / dn);
        let shift = (off[1] - off[0]) * quotient;
        amplitudes[0] *= -shared + 1.0;
        amplitudes[1] *= -shared + 1.0;
        amplitudes[2] *= -(off[2] + shift * self.modulus * self.modulus * quotient) + 1.0;
        (amplitudes, shift)
    }
}

fn pi<T: Real>() -> T {
    DoubleDouble::pi().hi()
}

fn of_length_one<T: Real>(pair: Pair<T>) -> Pair<T> {
    pair.scaled(T::one() / pair.length())
}

/// Sine and cosine of the phase `pi u/(2K)` at the start; from the nearer end, so that both keep their
/// digits.
pub(crate) fn phase_at_start<T: Real>([sn, cn, dn]: [T; 3], complement: T, quarter: T) -> [T; 2] {
    let phase = |u: T| (pi::<T>() * 0.5 * u / quarter).sin_cos();
    // (C11)
    let (sin, cos) = if cn.abs().lt(sn.abs()) {
        let u = cn.abs() * elliptic::rf_of_roots(complement * sn.abs(), complement, dn);
        let (cos, sin) = phase(u);
        (sin, cos)
    } else {
        phase(sn.abs() * elliptic::rf_of_roots(cn.abs(), dn, T::one()))
    };
    [sin.with_sign(sn), cos.with_sign(cn)]
}

/// Jacobi's argument at the start, between the saddles (`cn` taken as positive); `cn`, `dn` and the
/// complement are times `2^shift`.
pub(crate) fn argument_at_start<T: Real>(
    [sn, cn, dn]: [T; 3],
    complement: T,
    quarter: DoubleDouble<T>,
    shift: i32,
) -> DoubleDouble<T> {
    let [from_flip, cn] = if cn.lt(T::zero()) { [-sn, -cn] } else { [sn, cn] };
    let [true_cn, true_dn] = [cn, dn].map(|x| x.times_power_of_two(-shift));
    // (C11)
    let near = !true_cn.lt(sn.abs()) || !quarter.hi().finite();
    let size = if near {
        let true_cn = true_cn.of_one_sign();
        DoubleDouble::from(sn.abs() * elliptic::rf_of_roots(true_cn, true_dn, T::one()))
    } else {
        let root = complement / dn;
        let left = cn / dn * elliptic::rf_of_roots(root * sn.abs(), root, T::one());
        quarter - DoubleDouble::from(left)
    };
    size.times_exact(T::one().with_sign(from_flip + 0.0))
}
