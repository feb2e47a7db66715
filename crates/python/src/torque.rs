//! The kinds of torques.

use crate::arrays::{Numbers, row};
use crate::error::Answer;
use nalgebra::Vector3;
use pyo3::prelude::*;
use tumbling::PrincipalMoments;
use tumbling::step::System;

/// A torque on a body.
///
/// Raises `Error` for numbers that are not valid.
///
/// >>> import tumbling
/// >>> weight = tumbling.Torque.gravity(arm=[0, 0, 0.1], weight=9.81)
/// >>> thruster = tumbling.Torque.in_body([0, 0, 2]).during(0.5, 0.8)
#[pyclass(frozen, module = "tumbling")]
pub struct Torque {
    pub torque: tumbling::step::Torque<f64>,
}

type Law = tumbling::step::Torque<f64>;

fn vector(what: &str, numbers: &Numbers<'_>) -> Answer<Vector3<f64>> {
    Ok(row(what, numbers)?.into())
}

/// A torque that has been checked; on any body.
fn checked(torque: Law) -> Answer<Torque> {
    System::with(PrincipalMoments::new(1.0, 1.0, 1.0)?, vec![torque.clone()])?;
    Ok(Torque { torque })
}

/// The torques of a list.
pub fn laws(torques: Vec<Bound<'_, Torque>>) -> Vec<Law> {
    torques.iter().map(|torque| torque.get().torque.clone()).collect()
}

#[pymethods]
impl Torque {
    /// Constant along the body's axes, N m: a thruster.
    #[staticmethod]
    fn in_body(torque: Numbers<'_>) -> Answer<Self> {
        checked(Law::InBody(vector("torque", &torque)?))
    }

    /// Constant along the world's axes, N m.
    #[staticmethod]
    fn in_world(torque: Numbers<'_>) -> Answer<Self> {
        checked(Law::InWorld(vector("torque", &torque)?))
    }

    /// The weight (N, along the world's -z) of a top whose centre of mass is at `arm` (m, body axes) from the
    /// fixed point, about which its inertia must be.
    #[staticmethod]
    fn gravity(arm: Numbers<'_>, weight: f64) -> Answer<Self> {
        checked(Law::gravity(&vector("arm", &arm)?, weight))
    }

    /// `arm` (body axes) x `field` (world axes), N m: a magnetic moment (A m²) in a field (T), or a spring
    /// that turns the arm toward the field, with the product of their lengths as stiffness (N m/rad).
    #[staticmethod]
    fn aligning(arm: Numbers<'_>, field: Numbers<'_>) -> Answer<Self> {
        checked(Law::Aligning { arm: vector("arm", &arm)?, field: vector("field", &field)? })
    }

    /// The gravity gradient in a circular orbit: `toward` points to the attracting body at time 0 (world
    /// axes, of length 1), `orbit` is the orbit's rate about its normal (world axes, rad/s).
    #[staticmethod]
    fn gravity_gradient(toward: Numbers<'_>, orbit: Numbers<'_>) -> Answer<Self> {
        checked(Law::gravity_gradient(&vector("toward", &toward)?, &vector("orbit", &orbit)?))
    }

    /// Viscous drag, with coefficients in N m s about the principal axes: the torque is minus the
    /// coefficients times the spin.
    #[staticmethod]
    fn damping(coefficients: Numbers<'_>) -> Answer<Self> {
        checked(Law::Damping(vector("coefficients", &coefficients)?))
    }

    /// Internal dissipation of a body that is not quite rigid, in s/(kg m²). It keeps the length of the
    /// momentum.
    #[staticmethod]
    fn dissipation(strength: f64) -> Answer<Self> {
        checked(Law::Dissipation(strength))
    }

    /// `amplitude` (N m, body axes) times the cosine of `rate` (rad/s) times the time plus `phase` (rad).
    #[staticmethod]
    #[pyo3(signature = (amplitude, rate, phase=0.0))]
    fn periodic(amplitude: Numbers<'_>, rate: f64, phase: f64) -> Answer<Self> {
        checked(Law::Periodic { amplitude: vector("amplitude", &amplitude)?, rate, phase })
    }

    /// This torque from the time `start` to the time `end` (s), and none before and after.
    fn during(&self, start: f64, end: f64) -> Answer<Self> {
        checked(Law::during(start, end, self.torque.clone()))
    }

    fn __repr__(&self) -> String {
        format!("Torque({:?})", self.torque)
    }
}
