//! How well a record keeps a law: the error, its growth, and the flips counted.

use crate::law::LawName;
use crate::thresholds::KEPT;
use serde::Serialize;

/// How an error grows with time, best first.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub enum Growth {
    /// No more than the rounding of the numbers and of each step can make.
    Rounding,
    /// In the second half of the time no more than in the first, to a quarter.
    Bounded,
    /// Of a quantity that grew or shrank by a tenth or more, and then stayed away from what it was.
    Stayed,
    /// As the square root of time.
    RandomWalk {
        /// So much at one second, and as the root of time from there.
        rate: f64,
    },
    /// As time.
    Linear {
        /// So much a second.
        rate: f64,
    },
    /// As a power of time beyond the first.
    Power {
        /// That power.
        power: f64,
    },
    /// As an exponential of time.
    Exponential {
        /// By this much of itself a second; negative where it decays.
        rate: f64,
    },
}

impl Growth {
    /// From best, 0, to worst, 5; a name, in a word or three; and its rate or power.
    const fn parts(self) -> (u8, &'static str, Option<f64>) {
        match self {
            Self::Rounding => (0, "kept to rounding", None),
            Self::Bounded => (1, "bounded", None),
            Self::RandomWalk { rate } => (2, "random walk", Some(rate)),
            Self::Linear { rate } => (3, "linear", Some(rate)),
            Self::Power { power } => (4, "faster than linear", Some(power)),
            Self::Stayed => (5, "changed, then stayed", None),
            Self::Exponential { rate } => (5, "exponential", Some(rate)),
        }
    }

    /// From best, 0, to worst, 5.
    #[must_use]
    pub const fn rank(self) -> u8 {
        self.parts().0
    }

    /// A name, in a word or three.
    #[must_use]
    pub const fn name(self) -> &'static str {
        self.parts().1
    }

    /// What it grows by in a second, or to which power of time.
    pub(crate) const fn rate(self) -> Option<f64> {
        self.parts().2
    }
}

/// How a law was kept.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Law {
    /// Which.
    pub name: LawName,
    /// How its error grew.
    pub growth: Growth,
    /// The greatest error.
    pub most: f64,
    /// The last error, with its sign.
    pub last: f64,
}

impl Law {
    /// How its error grew, in a few words; an error that only few digits excuse is not called rounding.
    pub(crate) fn how(&self) -> &'static str {
        match self.growth {
            Growth::Rounding if self.most > KEPT => "within the error of few digits",
            Growth::Rounding => "within rounding error",
            other => other.name(),
        }
    }
}

/// Flips counted, in the record and in the exact motion.
#[derive(Debug, Clone, Default, PartialEq, Serialize)]
pub struct FlipCount {
    /// In the record: changes of sign of the spin along the middle axis.
    pub found: u64,
    /// In the exact motion, in the same time.
    pub exact: u64,
    /// The time of the first in the record, s from its start.
    pub first: Option<f64>,
    /// The time of the first of the exact motion, s from the start.
    pub first_exact: Option<f64>,
    /// The greatest difference in time between those of the first 512 flips in the record and in the exact
    /// motion that have the same number, s.
    pub apart: f64,
    /// The times of the first 512 in the record, s from its start.
    pub times: Vec<f64>,
    /// By how much they are later than the exact ones, if that is a share of the time and a number: the
    /// number, s, and the share.
    pub late: Option<[f64; 2]>,
    /// When the spin along the axis that it circles first changes sign, s from the start. In the exact motion
    /// it never does.
    pub turned_over: Option<f64>,
}
