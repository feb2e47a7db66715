//! A motion in which the axis of a top rises and sinks, or precesses evenly.

use super::factor::{Complementary, Direct, complementary_denominator, cubic};
use crate::exact::elliptic::sin_cos_of_turns;
use crate::exact::elliptic_motion::Reduction;
use crate::number::double_double::DoubleDouble;
use crate::number::functions::hypot;

/// All that an instant needs, in units of one rate.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Nutation {
    pub(super) form: Form,
    /// The time from the lowest place to the highest and back (T10); infinite on the separatrix.
    pub(super) half_period: DoubleDouble,
    /// How fast Jacobi's argument runs.
    pub(super) rate: f64,
    /// How fast the axis goes round the vertical in the mean, in radians.
    pub(super) precession: f64,
}

/// The series by which it is summed.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Form {
    /// In the nome.
    Direct {
        /// Turns of the phase per unit of time, and its sine and cosine at the start.
        turns: DoubleDouble,
        start: [f64; 2],
        denominator: [f64; 4],
        factors: [Direct; 3],
    },
    /// In the complementary nome, which is zero on the separatrix: that motion does not return.
    Complementary { reduction: Reduction, nome: f64, factors: [Complementary; 3] },
}

impl Nutation {
    /// `alpha` and `beta`, of one common length, and the spin across the axis.
    #[inline(always)]
    pub(super) fn at(&self, time: f64) -> ([[f64; 2]; 2], [f64; 2]) {
        match &self.form {
            Form::Direct { turns, start: [sin0, cos0], denominator, factors: [alpha, beta, across] } => {
                let (sin, cos) = sin_cos_of_turns(*turns * time);
                let phase @ [sin, cos] = [sin0 * cos + cos0 * sin, cos0 * cos - sin0 * sin];
                let inverse = 1.0 / cubic(denominator, (cos - sin) * (cos + sin));
                let spin = across.at(phase, time).map(|x| x * inverse);
                ([alpha.at(phase, time), beta.at(phase, time)], spin)
            }
            Form::Complementary { reduction, nome, factors: [alpha, beta, across] } => {
                let exponentials = reduction.argument(time).exponentials();
                let inverse = 1.0 / complementary_denominator(*nome, &exponentials);
                let spin = across.at(&exponentials, time).map(|x| x * inverse);
                ([alpha.at(&exponentials, time), beta.at(&exponentials, time)], spin)
            }
        }
    }

    /// That all constants are numbers.
    pub(super) fn is_finite(&self) -> bool {
        [1e-3, 0.5].into_iter().all(|time| {
            let ([a, b], spin) = self.at(time);
            let length = hypot(hypot(a[0], a[1]), hypot(b[0], b[1]));
            length > 0.0 && length.is_finite() && spin[0].is_finite() && spin[1].is_finite()
        }) && self.rate > 0.0
            && self.rate.is_finite()
    }
}
