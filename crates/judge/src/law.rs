//! The laws of free motion, by name.

/// What a record is tested for.
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
    /// How far the spin is ahead of the exact one on its closed curve in body axes, in periods.
    Phase,
    /// The turn from row to row against the spin, relative to the spin, less what this step and the last
    /// changed the spin.
    Consistency,
}

impl LawName {
    /// All of them.
    pub const ALL: [Self; 7] = {
        use LawName::{Consistency, Direction, Energy, Momentum, Phase, Separatrix, Unit};
        [Energy, Momentum, Direction, Unit, Separatrix, Phase, Consistency]
    };

    /// A name for programs, a name in words, and that with its unit where the words leave it open.
    const fn names(self) -> [&'static str; 3] {
        match self {
            Self::Energy => ["energy"; 3],
            Self::Momentum => ["momentum", "|L|", "|L|"],
            Self::Direction => ["direction", "direction of L", "direction of L, rad"],
            Self::Unit => ["unit", "quaternion's length", "quaternion's length"],
            Self::Separatrix => ["separatrix", "2 E I₂ / L²", "2 E I₂ / L²"],
            Self::Phase => ["phase", "phase", "phase, periods"],
            Self::Consistency => ["consistency", "turn against spin", "turn against spin"],
        }
    }

    /// In plain words.
    #[must_use]
    pub const fn words(self) -> &'static str {
        self.names()[1]
    }

    /// The words with the unit.
    pub(crate) const fn heading(self) -> &'static str {
        self.names()[2]
    }

    /// A name for programs.
    #[must_use]
    pub const fn key(self) -> &'static str {
        self.names()[0]
    }

    /// Whether an engine fails by it: the exact motion keeps it for ever.
    #[must_use]
    pub const fn is_conserved(self) -> bool {
        !matches!(self, Self::Phase | Self::Consistency)
    }
}
