//! What the judge is to go by.

use crate::error::Error;
use crate::law::LawName;
use crate::laws::{Growth, Law};
use crate::thresholds::ALLOWED;
use nalgebra::Vector3;

/// What the judge is to go by.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Options {
    /// Principal moments, kg m²; they take precedence over what the record says.
    pub inertia: Option<Vector3<f64>>,
    /// The most that a law may be broken by, where the digits of the record show it: of energy and momentum
    /// as a share, of a direction in rad.
    pub threshold: f64,
    /// Limits for single laws, in place of `threshold`. A limit for phase (in periods) or for consistency
    /// makes that law count. Without one, a phase fails that is off by more than a quarter of a period and a
    /// quarter of the periods of the exact motion.
    pub thresholds: [Option<f64>; 7],
}

impl Options {
    /// What is allowed of a law; nothing where it is not held to anything.
    #[must_use]
    pub fn allowed(&self, law: LawName) -> Option<f64> {
        let own = self.own().find(|own| own.0 == law).map(|own| own.1);
        own.or_else(|| law.is_conserved().then_some(self.threshold))
    }

    /// The laws with a limit of their own, and that limit.
    pub(crate) fn own(&self) -> impl Iterator<Item = (LawName, f64)> {
        LawName::ALL.into_iter().zip(self.thresholds).filter_map(|(law, most)| Some((law, most?)))
    }

    /// Whether a law is kept within what is allowed, or within what its digits show.
    pub(crate) fn allows(&self, law: &Law) -> bool {
        law.growth == Growth::Rounding || self.allowed(law.name).is_none_or(|most| law.most.abs() <= most)
    }

    /// With a limit of its own for a law.
    #[must_use]
    pub fn with(mut self, law: LawName, threshold: f64) -> Self {
        if let Some(i) = LawName::ALL.iter().position(|name| *name == law) {
            self.thresholds[i] = Some(threshold);
        }
        self
    }

    /// Limits that are numbers above zero.
    pub(crate) fn checked(&self) -> Result<(), Error> {
        let all = self.own().map(|(law, most)| (Some(law), most)).chain([(None, self.threshold)]);
        match all.into_iter().find(|(_, most)| most.is_nan() || *most <= 0.0) {
            Some((law, value)) => Err(Error::Threshold { law, value }),
            None => Ok(()),
        }
    }
}

impl Default for Options {
    fn default() -> Self {
        Self { inertia: None, threshold: ALLOWED, thresholds: [None; 7] }
    }
}
