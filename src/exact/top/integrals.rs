//! The conserved quantities of a top's motion, and the highest and lowest positions of its axis: (T1) to (T7)
//! of the book.

use crate::number::DoubleDouble;
#[cfg(not(feature = "std"))]
use num_traits::Float as _;

/// Half units in the last place by which the numbers of a steady start may be off. The rate of a steady
/// precession is `2 k / (L + sqrt(L² - 4 A k cos))`, with the momentum `L` about the axis and the weight's
/// torque `k`. It takes ten operations, its component across the axis a sine and a product, and the attitude
/// a sine, a cosine and a product of two.
pub(super) const ROUNDINGS: f64 = 16.0;

/// A start in units of one rate. The body's axis of symmetry comes last and points from the fixed point to
/// the centre of mass.
pub(super) struct Start {
    /// Its attitude's `alpha = w + i z` and `beta = x + i y` (T1).
    pub(super) alpha: [f64; 2],
    pub(super) beta: [f64; 2],
    /// The spin across the axis.
    pub(super) across: [f64; 2],
    /// The momentum along the axis over the moment across it (T2): the spin of the spherical top with the
    /// same motion of the axis (T3).
    pub(super) along: DoubleDouble,
    /// Twice the torque of a level axis over the moment across it (T2): 0 or above.
    pub(super) pull: DoubleDouble,
}

/// The constants of the motion, as a function of the cosine `u` of the lean. The square of the rate of `u` is
/// `(1 - u²)(e - pull u) - (l - along u)²` (T5), with the constants (T4); two of its roots, `low` and `high`,
/// bound the motion.
pub(super) struct Integrals {
    pub(super) along: DoubleDouble,
    pub(super) pull: DoubleDouble,
    /// `1 + u` and `1 - u` at the start, and the vertical across the axis.
    pub(super) from_bottom: DoubleDouble,
    pub(super) from_top: DoubleDouble,
    pub(super) vertical: [DoubleDouble; 2],
    /// The square of the spin across the axis; its part along the vertical; how fast `u` rises.
    pub(super) across_squared: DoubleDouble,
    pub(super) about: DoubleDouble,
    pub(super) rising: DoubleDouble,
    /// `l + along` and `l - along`: the momentum's parts at the bottom and the top.
    pub(super) at_bottom: DoubleDouble,
    pub(super) at_top: DoubleDouble,
    /// How far the start is above `low` and below `high`.
    pub(super) down: DoubleDouble,
    pub(super) up: DoubleDouble,
    /// `1 + u` at `low` and `high`, and `1 - u`.
    pub(super) bottoms: [DoubleDouble; 2],
    pub(super) tops: [DoubleDouble; 2],
    /// `pull (u3 - 1)` of the third root.
    pub(super) third: DoubleDouble,
}

fn not_negative(x: DoubleDouble) -> DoubleDouble {
    if x.hi() > 0.0 { x } else { DoubleDouble::ZERO }
}

impl Start {
    /// `1 + u`, `1 - u`, and the vertical's two components across the axis.
    fn height(&self) -> ([DoubleDouble; 2], [DoubleDouble; 2]) {
        let square = |[x, y]: [f64; 2]| DoubleDouble::product(x, x) + DoubleDouble::product(y, y);
        let (a, b) = (square(self.alpha), square(self.beta));
        let ([w, z], [x, y]) = (self.alpha, self.beta);
        let two = |p: DoubleDouble| p * 2.0 / (a + b);
        let first = DoubleDouble::product(z, x) - DoubleDouble::product(w, y);
        let second = DoubleDouble::product(w, x) + DoubleDouble::product(z, y);
        ([two(a), two(b)], [two(first), two(second)])
    }
}

impl Integrals {
    pub(super) fn new(start: &Start) -> Self {
        let ([from_bottom, from_top], vertical) = start.height();
        let ([v1, v2], [w1, w2], along, pull) = (vertical, start.across, start.along, start.pull);
        let across_squared = DoubleDouble::product(w1, w1) + DoubleDouble::product(w2, w2);
        let about = v1 * w1 + v2 * w2;
        let mut new = Self {
            along,
            pull,
            from_bottom,
            from_top,
            vertical,
            across_squared,
            about,
            rising: v1 * w2 - v2 * w1,
            at_bottom: about + along * from_bottom,
            at_top: about - along * from_top,
            down: DoubleDouble::ZERO,
            up: DoubleDouble::ZERO,
            bottoms: [DoubleDouble::ZERO; 2],
            tops: [DoubleDouble::ZERO; 2],
            third: DoubleDouble::ZERO,
        };
        new.find_bounds();
        new
    }

    /// The cosine of the lean at the start.
    pub(super) fn height(&self) -> DoubleDouble {
        let one = DoubleDouble::ONE;
        if self.from_top.hi() < 1.0 { one - self.from_top } else { self.from_bottom - one }
    }

    /// The derivative by `u` of the square of its rate, at the start: zero where the lean is in equilibrium.
    fn derivative(&self) -> DoubleDouble {
        (self.along * self.about - self.height() * self.across_squared) * 2.0
            - self.pull * self.from_bottom * self.from_top
    }

    /// Whether the lean is constant up to rounding: the axis neither rises nor is off equilibrium by more
    /// than [`ROUNDINGS`] of the start explain. At a height `x` above the start, that square is about `r² + s
    /// x - g x²`, with the rate `r` and the derivative `s`. So the range of the height is the root of `s² + 4
    /// g r²`, divided by `g`. The rounding of one number changes `s` and `r` in proportion to its terms in
    /// them.
    pub(super) fn is_steady(&self) -> bool {
        let [square, pull, along] = [self.across_squared, self.pull, self.along].map(|x| x.hi().abs());
        let level = (self.from_bottom * self.from_top).hi();
        let moving = (level * square).sqrt();
        let curvature = (self.third + self.pull * self.from_top).hi();
        let square_of_range =
            |derivative: f64, rising: f64| derivative * derivative + 4.0 * curvature * rising * rising;
        let terms = 2.0 * along * moving + 2.0 * square + pull * level;
        let rounding = ROUNDINGS * 0.5 * f64::EPSILON;
        square_of_range(self.derivative().hi(), self.rising.hi())
            <= square_of_range(rounding * terms, rounding * moving)
    }

    /// The roots, each computed relative to the start, the top or the bottom (T6), whichever is near, so that
    /// each has full relative accuracy and the distance of two of them is a sum. The third root is by (T7).
    fn find_bounds(&mut self) {
        let (b, pull, square) = (self.along, self.pull, self.across_squared);
        let twice = |x: DoubleDouble| x * 2.0;
        let curve = twice(pull * self.height()) - square - b * b;
        let from_start = Cubic([self.rising * self.rising, self.derivative(), curve, pull]);
        let (down, up) = (from_start.below(), from_start.above());

        let at_top = square - pull * self.from_top;
        let from_top = Cubic([
            self.at_top * self.at_top,
            twice(b * self.at_top - at_top),
            at_top + b * b - twice(pull),
            pull,
        ]);
        let at_bottom = square + pull * self.from_bottom;
        let from_bottom = Cubic([
            self.at_bottom * self.at_bottom,
            -twice(at_bottom + b * self.at_bottom),
            at_bottom + twice(pull) + b * b,
            -pull,
        ]);
        let near = |part: DoubleDouble, whole: DoubleDouble| part.hi() <= 0.5 * whole.hi();
        let low = if near(down, self.from_bottom) { self.from_bottom - down } else { from_bottom.above() };
        self.down = if near(down, self.from_bottom) { down } else { not_negative(self.from_bottom - low) };
        let high = if near(up, self.from_top) { self.from_top - up } else { from_top.above() };
        self.up = if near(up, self.from_top) { up } else { not_negative(self.from_top - high) };
        self.bottoms = [low, self.from_bottom + self.up];
        self.tops = [self.from_top + self.down, high];
        let two = DoubleDouble::from(2.0);
        let third = pull * (self.tops[0] + self.tops[1] - two) + at_top + b * b;
        self.third = if third.hi() > pull.hi() { third } else { pull * from_top.below() };
    }

    /// The heights relative to the zero of the spin across the axis, times the pull: how far below it `high`
    /// is, and how far above it the third root is; and the square of that spin at `low`.
    pub(super) fn rest(&self) -> [DoubleDouble; 3] {
        let highest = not_negative(self.across_squared - self.pull * self.up);
        let lowest = self.across_squared + self.pull * self.down;
        let sum = self.tops[0] + self.tops[1] - DoubleDouble::from(2.0);
        // A product if possible; next to a cusp, a difference of small terms.
        let third = if highest.hi() > 1e-3 * self.across_squared.hi() {
            let turning = self.turning_at_zero();
            turning * turning / (highest * lowest)
        } else if self.third.hi() > self.pull.hi() || self.along.hi() == 0.0 {
            not_negative(self.along * self.along + self.pull * sum)
        } else {
            not_negative(self.third + self.pull * self.from_top - self.across_squared)
        };
        [highest, third, lowest]
    }

    /// Proportional to the rate of the argument of the spin across the axis; its sign shows on which side
    /// that complex number passes zero.
    pub(super) fn turning_at_zero(&self) -> DoubleDouble {
        self.along * self.across_squared - self.pull * self.about
    }
}

/// The coefficients of 1, x, x² and x³. All roots are real, one of them may be at infinity, and the value at
/// zero is not negative. Each root has full relative accuracy, however small it is.
struct Cubic([DoubleDouble; 4]);

impl Cubic {
    /// The first root at zero or above.
    fn above(&self) -> DoubleDouble {
        let root = self.near();
        if root == 0.0 {
            return DoubleDouble::ZERO;
        }
        // Newton's method doubles the number of digits; the residue is computed in twice the precision.
        let mut x = DoubleDouble::from(root);
        for _ in 0..2 {
            let (value, derivative) = self.value_and_derivative(x);
            let step = value.hi() / derivative;
            if step.is_finite() {
                x = x - DoubleDouble::from(step);
            }
        }
        x
    }

    /// The distance from zero to the first root at zero or below.
    fn below(&self) -> DoubleDouble {
        let [a, b, c, d] = self.0;
        Self([a, -b, c, -d]).above()
    }

    fn value_and_derivative(&self, x: DoubleDouble) -> (DoubleDouble, f64) {
        let [a, b, c, d] = self.0;
        let value = ((d * x + c) * x + b) * x + a;
        let at = x.hi();
        (value, (3.0 * d.hi() * at + 2.0 * c.hi()) * at + b.hi())
    }

    /// The nearest root to rounding, by Laguerre's method, which never steps past it if all roots are real.
    fn near(&self) -> f64 {
        let [a, b, c, d] = self.0.map(DoubleDouble::hi);
        if a == 0.0 && (b < 0.0 || (b == 0.0 && c <= 0.0)) {
            return 0.0;
        }
        // With a rising start the value comes down to the one at zero where the rest has its first root.
        let mut x = if b > 0.0 { first_root(b, c, d) } else { 0.0 };
        for _ in 0..80 {
            let value = ((d * x + c) * x + b) * x + a;
            let derivative = (3.0 * d * x + 2.0 * c) * x + b;
            let second = 6.0 * d * x + 2.0 * c;
            let radicand = (4.0 * derivative * derivative - 6.0 * value * second).max(0.0);
            let step = 3.0 * value / (radicand.sqrt() - derivative);
            if !(step > 1e-15 * x && step.is_finite()) {
                break;
            }
            x += step;
        }
        x
    }
}

/// The first root above zero of `b + c x + d x²`, with `b` above zero.
fn first_root(b: f64, c: f64, d: f64) -> f64 {
    let root = (c * c - 4.0 * b * d).max(0.0).sqrt();
    let x = if c <= 0.0 { 2.0 * b / (root - c) } else { -0.5 * (root + c) / d };
    if x.is_finite() { x } else { 0.0 }
}
