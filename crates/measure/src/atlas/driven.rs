//! The hard cases under torques. Where their bodies truly are stands in a table, by a program of its own.

use super::{BUDGET, Fate, Judged, Precision, Runner, TOLERANCES};
use crate::drive::{Drive, single};
use crate::errors::turn;
use crate::story::{Wrong, number, numbers, vector};
use nalgebra::{Quaternion, UnitQuaternion, Vector3};
use num_traits::{FromPrimitive, ToPrimitive};
use serde_json::Value;
use tumbling::number::Analytic;
use tumbling::step::{Method, State, Stepper};
use tumbling::{Body, Error, Inertia};

/// A hard case under torques.
#[derive(Debug, Clone)]
pub struct Driven {
    chart: String,
    name: String,
    moments: Vector3<f64>,
    omega: Vector3<f64>,
    /// That of the methods with a fixed step, s.
    step: f64,
    drive: Drive,
    /// Where it truly is at the end.
    truth: State<f64>,
}

/// The charts of bodies under torques, as in the table.
pub const DRIVEN: [&str; 7] = ["drag", "one axis", "weight", "shapes", "stop", "resonance", "blow"];

/// Each chart's name, and its cases.
pub(super) fn charts() -> Result<Vec<(&'static str, Vec<Driven>)>, Wrong> {
    let table: Value = serde_json::from_str(include_str!("../../data/atlas.json"))?;
    let cases = table["cases"].as_array().ok_or("a table without cases")?;
    let cases = cases.iter().map(Driven::read).collect::<Result<Vec<_>, _>>()?;
    let of = |name: &str| cases.iter().filter(|case| case.chart == name).cloned().collect();
    Ok(DRIVEN.map(|name| (name, of(name))).into())
}

impl Driven {
    fn read(entry: &Value) -> Result<Self, Wrong> {
        let word = |key: &str| entry[key].as_str().map(str::to_owned).ok_or("a case without a name");
        let [w, x, y, z] = numbers(&entry["attitude"])?;
        let truth = State { attitude: Quaternion::new(w, x, y, z), momentum: vector(&entry["momentum"])? };
        Ok(Self {
            chart: word("chart")?,
            name: word("name")?,
            moments: vector(&entry["moments"])?,
            omega: vector(&entry["omega"])?,
            step: number(&entry["step"])?,
            drive: Drive::read(entry)?,
            truth,
        })
    }

    /// By a method at its fixed step, or within a tolerance.
    fn run<T>(&self, method: Option<Method>, tolerance: f64) -> Result<State<f64>, Error>
    where
        T: Analytic + Copy + FromPrimitive + ToPrimitive + Send + Sync,
    {
        let inertia = Inertia::from_moments(self.moments.x, self.moments.y, self.moments.z)?;
        let mut body = Body::spinning(inertia, UnitQuaternion::identity(), &self.omega)?;
        for (phase, &(seconds, _)) in self.drive.phases.iter().enumerate() {
            let (stepper, steps) = match method {
                Some(method) => {
                    (Stepper::<T>::new(&body, method)?, (seconds / self.step).ceil().clamp(1.0, 1e5))
                }
                None => (Stepper::adaptive(&body, tolerance, BUDGET)?, 1.0),
            };
            let mut stepper = stepper.with_torques(self.drive.torques(phase))?;
            let h = T::from_f64(seconds / steps).unwrap_or_else(T::zero);
            stepper.run(h, steps as usize).try_for_each(|state| state.map(drop))?;
            body = stepper.body()?;
        }
        Ok(body.state())
    }

    /// The body that single precision is given, of rounded numbers: another one, where two moments are nearly
    /// equal. Where it truly is, the run within a tolerance in `f64` gives, which a test below holds to the
    /// table; where that refuses, the table.
    fn in_single(&self) -> Self {
        let mut given = Self {
            moments: self.moments.map(single),
            omega: self.omega.map(single),
            drive: self.drive.in_single(),
            ..self.clone()
        };
        if let Ok(end) = given.run::<f64>(None, TOLERANCES[0]) {
            given.truth = end;
        }
        given
    }

    /// How far a state is from the true one: the momentum as a share of the larger of those at start and end,
    /// and the angle, rad.
    fn off(&self, end: &State<f64>) -> [f64; 2] {
        let angle = turn(&end.attitude, &self.truth.attitude);
        [(end.momentum - self.truth.momentum).norm() / self.scale(), angle]
    }

    fn scale(&self) -> f64 {
        self.moments.component_mul(&self.omega).norm().max(self.truth.momentum.norm())
    }

    fn fate(&self, end: &State<f64>) -> Fate {
        let [momentum, angle] = self.off(end);
        match (end.momentum.norm() - self.truth.momentum.norm()) / self.scale() {
            longer if !(longer + momentum + angle).is_finite() => Fate::NotFinite,
            longer if longer > 0.1 => Fate::Gained,
            longer if longer < -0.1 => Fate::Lost,
            _ if momentum > 0.1 || angle > 0.1 => Fate::Late,
            _ if momentum > 0.01 => Fate::Worn,
            _ => Fate::Right,
        }
    }
}

impl Judged for Driven {
    fn name(&self) -> &str {
        &self.name
    }

    fn judged(&self, runner: Runner, precision: Precision) -> Option<Fate> {
        let method = match runner {
            Runner::Exact => return None,
            Runner::Adaptive => None,
            Runner::Stepper(method) => Some(method),
        };
        Some(match precision {
            Precision::Double => {
                self.run::<f64>(method, TOLERANCES[0]).map_or(Fate::Refused, |end| self.fate(&end))
            }
            Precision::Single => {
                let given = self.in_single();
                given.run::<f32>(method, TOLERANCES[1]).map_or(Fate::Refused, |end| given.fate(&end))
            }
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use tumbling::exact::FreeMotion;

    fn cases() -> Vec<Driven> {
        charts().unwrap().into_iter().flat_map(|(_, cases)| cases).collect()
    }

    /// A torque against the momentum, constant in the world, slows the free motion's clock: after `t` of the
    /// two seconds that it takes to rest, the body is where it was, free, after `t - t^2/4`.
    #[test]
    fn the_table_has_a_tumbling_body_at_rest_where_the_closed_form_has_it() {
        for (name, time) in [("tumbling, at rest", 1.0), ("tumbling, through rest", 0.0)] {
            let case = cases().into_iter().find(|case| case.name == name).unwrap();
            let motion = FreeMotion::new(case.moments.try_into().unwrap(), &case.omega).unwrap();
            let there = motion.at(time).unwrap().attitude;
            assert!(turn(&case.truth.attitude, &there) < 1e-14, "{name}");
        }
    }

    /// The two larger moments of these needles and strips differ by a millionth or less: rounding changes the
    /// difference, and the truth by up to half a radian.
    #[test]
    fn in_single_precision_a_needle_with_a_weight_is_another_body_of_which_the_run_is_right() {
        let shapes = cases().into_iter().filter(|case| case.chart == "shapes");
        let mut another = Vec::new();
        for case in shapes {
            let given = case.in_single();
            let end = given.run::<f32>(None, TOLERANCES[1]).unwrap();
            let off = given.off(&end);
            assert!(off[0].max(off[1]) < 5e-5, "{}: {off:?}", case.name);
            if case.off(&given.truth)[1] > 0.01 {
                another.push(case.name.clone());
            }
        }
        assert!(another.len() > 3, "{another:?}");
    }

    #[test]
    fn a_run_with_a_chosen_step_is_right_to_many_digits_or_refuses() {
        let (mut right, mut refused) = (0, Vec::new());
        for case in cases() {
            match case.run::<f64>(None, TOLERANCES[0]) {
                Ok(end) => {
                    let off = case.off(&end);
                    assert!(off[0].max(off[1]) < 1e-6, "{}, {}: {off:?}", case.chart, case.name);
                    right += 1;
                }
                Err(_) => refused.push(format!("{}, {}", case.chart, case.name)),
            }
        }
        assert!(right > 5 * refused.len(), "{right} right, refused: {refused:?}");
    }
}
