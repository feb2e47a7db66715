//! What is requested of a body.

/// What is requested of each body.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Outputs {
    /// The angular velocity in body axes, at each time.
    pub spin: bool,
    /// The attitude, body to world, at each time.
    pub attitude: bool,
    /// The kinetic energy, at each time.
    pub energy: bool,
    /// The angle between spin and momentum, at each time.
    pub angle_to_momentum: bool,
    /// The instants up to the end at which the spin along the middle axis changes sign.
    pub flips: bool,
    /// The path of the spin in the body. Of free bodies alone.
    pub polhode: bool,
}

impl Outputs {
    /// None of them.
    pub const NOTHING: Self = Self {
        spin: false,
        attitude: false,
        energy: false,
        angle_to_momentum: false,
        flips: false,
        polhode: false,
    };

    /// Whether any of them belongs to a time.
    #[must_use]
    pub fn states(self) -> bool {
        self.spin || self.attitude || self.energy || self.angle_to_momentum
    }
}
