//! The instants at which states are requested.

use crate::error::{Error, not_negative, positive, within};

/// The instants at which states are requested, s from the start.
#[derive(Debug, Clone, PartialEq)]
pub enum Times {
    /// These, in ascending order and none before the start.
    Given(Vec<f64>),
    /// From the start in equal steps up to the end of the span, which is included where it is a multiple of
    /// the step.
    Every {
        /// From one to the next, s.
        step: f64,
        /// The duration of the scene, s. Zero requests the start alone.
        span: f64,
    },
}

/// A span counts as a multiple of the step where their quotient is whole to this relative tolerance: 0.3 /
/// 0.1 is one rounding below 3.
const MULTIPLE: f64 = 4.0 * f64::EPSILON;

/// The largest number of steps: up to here `f64` counts one by one.
const MOST: f64 = 1.0 / f64::EPSILON;

impl Times {
    /// Every `step` seconds from 0 to `span`.
    #[must_use]
    pub const fn every(step: f64, span: f64) -> Self {
        Self::Every { step, span }
    }

    /// Checks that these times are valid for a scene.
    ///
    /// # Errors
    /// An empty list; a time that is not finite, negative or before its predecessor; a step that is not above
    /// zero; more than 2^52 steps.
    pub fn validate(&self) -> Result<(), Error> {
        match self {
            Self::Given(times) => {
                positive("the number of times", times.len() as f64)?;
                for &time in times {
                    not_negative("a time", time)?;
                }
                let unordered = times.windows(2).find(|pair| pair[0] > pair[1]);
                unordered.map_or(Ok(()), |pair| {
                    let rule = format!("it must not be larger than the one after it, {:?}", pair[1]);
                    within("a time", pair[0], false, rule).map(drop)
                })
            }
            Self::Every { step, span } => {
                let steps = not_negative("the span", *span)? / positive("the time between states", *step)?;
                let rule = format!("it must not be above {MOST:e}, up to which f64 counts one by one");
                within("the number of states", steps, steps <= MOST, rule).map(drop)
            }
        }
    }

    /// The number of instants. Zero for a step and a span that [`validate`](Self::validate) refuses.
    ///
    /// ```
    /// use tumbling_scenes::Times;
    /// assert_eq!(Times::every(0.1, 0.3).count(), 4);
    /// assert_eq!(Times::every(1e-300, 1.0).count(), 0);
    /// ```
    #[must_use]
    pub fn count(&self) -> u64 {
        match self {
            Self::Given(times) => times.len() as u64,
            Self::Every { step, span } => {
                let steps = span / step;
                if !(*step > 0.0 && (0.0..=MOST).contains(&steps)) {
                    return 0;
                }
                let whole = steps.round();
                let whole = if (steps - whole).abs() <= MULTIPLE * steps { whole } else { steps.floor() };
                whole as u64 + 1
            }
        }
    }

    /// The instant of number `n` (from 0), s; the last for a number beyond.
    #[must_use]
    pub fn nth(&self, n: u64) -> f64 {
        self.within(n.min(self.count().saturating_sub(1)))
    }

    /// The instant of a number below the count.
    pub(crate) fn within(&self, n: u64) -> f64 {
        match self {
            Self::Given(times) => {
                usize::try_from(n).ok().and_then(|n| times.get(n)).copied().unwrap_or_default()
            }
            Self::Every { step, span } => {
                // By way of a signed number, one instruction: a count is below 2^63.
                let time = n as i64 as f64 * step;
                if time < *span { time } else { *span }
            }
        }
    }

    /// The last instant of the scene, s.
    #[must_use]
    pub fn end(&self) -> f64 {
        match self {
            Self::Given(times) => times.last().copied().unwrap_or_default(),
            Self::Every { span, .. } => *span,
        }
    }
}
