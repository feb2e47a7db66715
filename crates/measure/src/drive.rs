//! What acts on the bodies of the tables of truth: as the library's torques, and as plain numbers for
//! programs of others.

use crate::story::{Wrong, number, vector};
use nalgebra::Vector3;
use num_traits::FromPrimitive;
use serde_json::Value;
use tumbling::number::Analytic;
use tumbling::step::{System, Torque};

/// What acts on a body; what does not act is zero. `data/taylor.py` has the same names.
#[derive(Debug, Clone, PartialEq)]
pub struct Drive {
    /// From the fixed point to the centre of mass, body axes, m.
    pub arm: Vector3<f64>,
    /// Along the world's -z, N.
    pub weight: f64,
    /// Along each axis, N m s.
    pub damping: Vector3<f64>,
    /// Constant in the world's axes, N m.
    pub world: Vector3<f64>,
    /// Gravity gradient: three times the gravitational parameter over the distance cubed, 1/s².
    pub gradient: f64,
    /// How fast the direction of the attracting mass turns in the world's x-y plane, from x on, rad/s.
    pub orbit: f64,
    /// Along the body's axes, N m, times the cosine of `rate` times the time.
    pub push: Vector3<f64>,
    /// rad/s.
    pub rate: f64,
    /// One after another: seconds, and a torque constant in the body's axes meanwhile, N m.
    pub phases: Vec<(f64, Vector3<f64>)>,
}

impl Drive {
    /// From an entry of a table.
    pub(crate) fn read(entry: &Value) -> Result<Self, Wrong> {
        let vector_of = |key: &str| match &entry[key] {
            Value::Null => Ok(Vector3::zeros()),
            value => vector(value),
        };
        let number_of = |key: &str| match &entry[key] {
            Value::Null => Ok(0.0),
            value => number(value),
        };
        let phase = |phase: &Value| Ok::<_, Wrong>((number(&phase[0])?, vector(&phase[1])?));
        let phases = match entry["phases"].as_array() {
            Some(phases) => phases.iter().map(phase).collect::<Result<_, _>>()?,
            None => vec![(number(&entry["t"])?, Vector3::zeros())],
        };
        Ok(Self {
            arm: vector_of("arm")?,
            weight: number_of("weight")?,
            damping: vector_of("damping")?,
            world: vector_of("world")?,
            gradient: number_of("gradient")?,
            orbit: number_of("orbit")?,
            push: vector_of("push")?,
            rate: number_of("rate")?,
            phases,
        })
    }

    /// With its numbers rounded to single precision.
    pub(crate) fn in_single(&self) -> Self {
        let vector = |v: &Vector3<f64>| v.map(single);
        Self {
            arm: vector(&self.arm),
            weight: single(self.weight),
            damping: vector(&self.damping),
            world: vector(&self.world),
            gradient: single(self.gradient),
            orbit: single(self.orbit),
            push: vector(&self.push),
            rate: single(self.rate),
            phases: self.phases.iter().map(|(seconds, pulse)| (*seconds, vector(pulse))).collect(),
        }
    }

    /// Whether it depends on the time within a phase.
    #[must_use]
    pub fn timed(&self) -> bool {
        self.gradient != 0.0 || self.push != Vector3::zeros()
    }

    /// All that acts through one of the phases.
    #[must_use]
    pub fn torques<T>(&self, phase: usize) -> Vec<Torque<T>>
    where
        T: Analytic + FromPrimitive + Send + Sync,
    {
        let number = |x: f64| T::from_f64(x).unwrap_or_else(T::zero);
        let vector = |v: &Vector3<f64>| v.map(number);
        let mut torques = Vec::new();
        if self.weight != 0.0 {
            torques.push(Torque::gravity(&vector(&self.arm), number(self.weight)));
        }
        if self.damping != Vector3::zeros() {
            torques.push(Torque::Damping(vector(&self.damping)));
        }
        if self.world != Vector3::zeros() {
            torques.push(Torque::InWorld(vector(&self.world)));
        }
        if self.gradient != 0.0 {
            let (direction, orbit) = (vector(&Vector3::x()), vector(&(Vector3::z() * self.orbit)));
            torques.push(Torque::GravityGradient { strength: number(self.gradient), direction, orbit });
        }
        if self.push != Vector3::zeros() {
            let (amplitude, rate) = (vector(&self.push), number(self.rate));
            torques.push(Torque::Periodic { amplitude, rate, phase: T::zero() });
        }
        if let Some((_, pulse)) = self.phases.get(phase).filter(|(_, pulse)| *pulse != Vector3::zeros()) {
            torques.push(Torque::InBody(vector(pulse)));
        }
        torques
    }

    /// The phases as systems of a body of these moments.
    pub(crate) fn systems(&self, moments: &Vector3<f64>) -> Result<Vec<Phase>, Wrong> {
        let mut systems = Vec::new();
        for (at, &(seconds, _)) in self.phases.iter().enumerate() {
            let system = System::with((*moments).try_into()?, self.torques(at))?;
            systems.push(Phase { seconds, system });
        }
        Ok(systems)
    }
}

/// The number that single precision has of `x`: `x` itself where that is zero or infinite, or loses digits to
/// the end of the range.
pub(crate) fn single(x: f64) -> f64 {
    let rounded = x as f32;
    if rounded.is_normal() { f64::from(rounded) } else { x }
}

/// A time in which the same torques act.
#[derive(Debug, Clone)]
pub struct Phase {
    /// s.
    pub seconds: f64,
    /// The body and its torques.
    pub system: System<f64>,
}
