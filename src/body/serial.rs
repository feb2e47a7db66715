//! The forms in which bodies and states are written and read with serde, feature `serde`. What is read goes
//! through the checks of the constructors.

use super::{Body, State};
use crate::attitude;
use crate::error::{Error, Subject, finite_vector};
use crate::inertia::Inertia;
use nalgebra::{Quaternion, UnitQuaternion, Vector3};
use serde::{Deserialize, Serialize};

/// A quaternion, by the names of its components so that no order can be mistaken.
#[derive(Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
struct Turn {
    w: f64,
    x: f64,
    y: f64,
    z: f64,
}

impl From<&Quaternion<f64>> for Turn {
    fn from(q: &Quaternion<f64>) -> Self {
        Self { w: q.w, x: q.i, y: q.j, z: q.k }
    }
}

impl Turn {
    fn attitude(&self) -> UnitQuaternion<f64> {
        UnitQuaternion::new_unchecked(Quaternion::new(self.w, self.x, self.y, self.z))
    }
}

/// Tensor in body axes, attitude body to world, momentum in world axes in kg m²/s.
#[derive(Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct Flight {
    inertia: Inertia,
    attitude: Turn,
    momentum_world: [f64; 3],
}

impl From<Body> for Flight {
    fn from(body: Body) -> Self {
        Self {
            inertia: body.inertia(),
            attitude: body.attitude().quaternion().into(),
            momentum_world: body.momentum_world().into(),
        }
    }
}

impl TryFrom<Flight> for Body {
    type Error = Error;

    fn try_from(flight: Flight) -> Result<Self, Error> {
        Self::new(flight.inertia, flight.attitude.attitude(), &flight.momentum_world.into())
    }
}

/// Attitude body to world, of length 1; momentum in body axes in kg m²/s.
#[derive(Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
struct Instant {
    attitude: Turn,
    momentum: [f64; 3],
}

// A state is generic over its number, of which `f64` alone is written and read.
impl Serialize for State<f64> {
    fn serialize<S: serde::Serializer>(&self, to: S) -> Result<S::Ok, S::Error> {
        Instant { attitude: (&self.attitude).into(), momentum: self.momentum.into() }.serialize(to)
    }
}

impl<'de> Deserialize<'de> for State<f64> {
    fn deserialize<D: serde::Deserializer<'de>>(from: D) -> Result<Self, D::Error> {
        let instant = Instant::deserialize(from)?;
        let momentum = Vector3::from(instant.momentum);
        let checked = finite_vector(Subject::AngularMomentum, &momentum)
            .and_then(|()| attitude::checked(instant.attitude.attitude()));
        let attitude = checked.map_err(serde::de::Error::custom)?.into_inner();
        Ok(Self { attitude, momentum })
    }
}
