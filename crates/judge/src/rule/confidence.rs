//! How sure a diagnosis is, in steps that a reader can act on.

/// How sure a diagnosis is.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[non_exhaustive]
pub enum Confidence {
    /// Every step is the rule's to rounding.
    ToRounding,
    /// More than half of the steps are the rule's to rounding; one in twenty or more is not, or the record
    /// breaks a law that the rule keeps.
    MostSteps,
    /// Nearer than any other by far, and not to rounding: such a rule, in some other form.
    Near,
    /// The steps are its own to rounding, and so they are of other rules; over the whole record it does not
    /// drift as the record does, or it is one of several that do.
    FewDigits,
    /// The steps are its own to rounding, and their errors are hardly above rounding: many a rule has as
    /// small ones.
    SmallErrors,
    /// Too few of the rows follow one another by one step.
    FewSteps,
    /// None of the rules known here, and so near to the exact motion that the error of a step is a small
    /// share of what the gyroscopic term does in it ([`error`](crate::Diagnosis::error)).
    Accurate,
    /// None of the rules known here.
    NoneFits,
}

impl Confidence {
    /// Whether one rule is named, or several that are one here.
    #[must_use]
    pub const fn names_a_rule(self) -> bool {
        matches!(self, Self::ToRounding | Self::MostSteps | Self::Near)
    }

    /// All of them.
    pub const ALL: [Self; 8] = [
        Self::ToRounding,
        Self::MostSteps,
        Self::Near,
        Self::FewDigits,
        Self::SmallErrors,
        Self::FewSteps,
        Self::Accurate,
        Self::NoneFits,
    ];

    /// What a program calls it.
    #[must_use]
    pub const fn key(self) -> &'static str {
        match self {
            Self::ToRounding => "to rounding",
            Self::MostSteps => "most steps",
            Self::Near => "near",
            Self::FewDigits => "too few digits",
            Self::SmallErrors => "errors too small",
            Self::FewSteps => "too few steps",
            Self::Accurate => "accurate",
            Self::NoneFits => "none fits",
        }
    }
}
