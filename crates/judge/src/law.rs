//! The laws of free motion, by name.

/// What is held against the record.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[non_exhaustive]
pub enum LawName {
    /// The kinetic energy, as its ratio to the first one.
    Energy,
    /// The length of the angular momentum, as its ratio to the first one.
    Momentum,
    /// Where the angular momentum points in the world, rad from the first one.
    Direction,
    /// The length of the attitude quaternion, from 1.
    Unit,
    /// `2 E I2 / L²`, as its ratio to the first one; at 1 is the separatrix, beyond which a stable spin
    /// flips.
    Separatrix,
    /// How far the spin is ahead of the exact one on its closed curve in body axes, in times round it.
    Phase,
    /// The turn from row to row against the spin, relative to the spin, less what this step and the last
    /// changed the spin.
    Consistency,
}

impl LawName {
    /// All of them.
    pub const ALL: [Self; 7] = [
        Self::Energy,
        Self::Momentum,
        Self::Direction,
        Self::Unit,
        Self::Separatrix,
        Self::Phase,
        Self::Consistency,
    ];

    /// In plain words.
    #[must_use]
    pub const fn words(self) -> &'static str {
        match self {
            Self::Energy => "energy",
            Self::Momentum => "|L|",
            Self::Direction => "direction of L",
            Self::Unit => "quaternion's length",
            Self::Separatrix => "2 E I2 / L^2",
            Self::Phase => "phase",
            Self::Consistency => "turn against spin",
        }
    }

    /// The same with its unit, where the words alone leave it open.
    #[must_use]
    pub const fn heading(self) -> &'static str {
        match self {
            Self::Direction => "direction of L, rad",
            Self::Phase => "phase, times round",
            name => name.words(),
        }
    }

    /// A name for programs.
    #[must_use]
    pub const fn key(self) -> &'static str {
        match self {
            Self::Energy => "energy",
            Self::Momentum => "momentum",
            Self::Direction => "direction",
            Self::Unit => "unit",
            Self::Separatrix => "separatrix",
            Self::Phase => "phase",
            Self::Consistency => "consistency",
        }
    }

    /// Whether an engine fails by it: the exact motion keeps it for ever.
    #[must_use]
    pub const fn is_conserved(self) -> bool {
        !matches!(self, Self::Phase | Self::Consistency)
    }
}
