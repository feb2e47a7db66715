//! What acts on the bodies of the tables of truth: as the library's torques, and as plain numbers for
//! programs of others.

use nalgebra::Vector3;
use serde::Deserialize;
use std::num::ParseFloatError;
use tumbling::step::Torque;

/// A vector in a table: along x, y and z.
pub type Components = [f64; 3];

/// What acts on a body; what does not act is zero. `data/taylor.py` has the same names.
#[derive(Debug, Clone, Default, PartialEq, Deserialize)]
#[serde(default)]
pub struct Drive {
    /// From the fixed point to the centre of mass, body axes, m.
    pub arm: Components,
    /// Along the world's -z, N.
    pub weight: f64,
    /// Along each axis, N m s.
    pub damping: Components,
    /// Constant in the world's axes, N m.
    pub world: Components,
    /// Gravity gradient: three times the gravitational parameter over the distance cubed, 1/s².
    pub gradient: f64,
    /// How fast the direction of the attracting mass turns in the world's x-y plane, from x on, rad/s.
    pub orbit: f64,
    /// Along the body's axes, N m, times the cosine of `rate` times the time.
    pub push: Components,
    /// rad/s.
    pub rate: f64,
    /// One after another: seconds, and a torque constant in the body's axes meanwhile, N m.
    pub phases: Vec<(f64, Components)>,
}

impl Drive {
    /// With one phase to the end, where the table names none.
    pub(crate) fn until(mut self, end: f64) -> Self {
        if self.phases.is_empty() {
            self.phases.push((end, [0.0; 3]));
        }
        self
    }

    /// Whether it depends on the time within a phase.
    #[must_use]
    pub fn timed(&self) -> bool {
        self.gradient != 0.0 || self.push != [0.0; 3]
    }

    /// All that acts from the start to the end, each pulse for its time alone.
    pub(crate) fn throughout(&self) -> Vec<Torque<f64>> {
        let (mut all, mut end) = (self.torques([0.0; 3]), 0.0);
        for &(seconds, pulse) in &self.phases {
            end += seconds;
            if pulse != [0.0; 3] {
                all.push(Torque::during(end - seconds, end, Torque::InBody(pulse.into())));
            }
        }
        all
    }

    /// All that acts while the torque of this phase does.
    #[must_use]
    pub fn torques(&self, pulse: Components) -> Vec<Torque<f64>> {
        let acts = |v: Components| v != [0.0; 3];
        let all = [
            (self.weight != 0.0).then(|| Torque::gravity(&self.arm.into(), self.weight)),
            acts(self.damping).then(|| Torque::Damping(self.damping.into())),
            acts(self.world).then(|| Torque::InWorld(self.world.into())),
            (self.gradient != 0.0).then(|| Torque::GravityGradient {
                strength: self.gradient,
                direction: Vector3::x(),
                orbit: Vector3::z() * self.orbit,
            }),
            acts(self.push).then(|| Torque::Periodic {
                amplitude: self.push.into(),
                rate: self.rate,
                phase: 0.0,
            }),
            acts(pulse).then(|| Torque::InBody(pulse.into())),
        ];
        all.into_iter().flatten().collect()
    }
}

/// Numbers that a table has as text, to more digits than an `f64` holds.
pub(crate) fn digits<const N: usize>(texts: &[String; N]) -> Result<[f64; N], ParseFloatError> {
    let mut numbers = [0.0; N];
    for (number, text) in numbers.iter_mut().zip(texts) {
        *number = text.parse()?;
    }
    Ok(numbers)
}
