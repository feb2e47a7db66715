//! One run of one method on one case, and what became of it.

use super::cases::Case;
use super::{BUDGET, Fate, Judged, Precision, Runner, TOLERANCES};
use crate::drive::single;
use nalgebra::{Quaternion, Vector3};
use num_traits::{FromPrimitive, ToPrimitive};
use tumbling::dynamics::observe;
use tumbling::exact::FreeMotion;
use tumbling::number::Analytic;
use tumbling::step::{Method, State, Stepper, System, Torque};
use tumbling_scenes::{Error, exact_drift};

/// All that a judge needs of a run.
#[derive(Debug, Clone, Copy)]
struct Seen {
    /// Worst over the run, of the truth's.
    energy: [f64; 2],
    momentum: [f64; 2],
    changes: usize,
    last_change: f64,
    /// At the end.
    attitude: Quaternion<f64>,
    left: Vector3<f64>,
    reversed: bool,
}

enum End {
    Seen(Seen),
    NotFinite,
    Refused,
}

impl Judged for Case {
    fn name(&self) -> &str {
        &self.name
    }

    fn judged(&self, runner: Runner, precision: Precision) -> Option<Fate> {
        let method = match runner {
            Runner::Stepper(method) => Some(method),
            Runner::Exact | Runner::Adaptive => None,
        };
        let given = if precision == Precision::Single { &self.in_single() } else { self };
        let end = match (runner, precision) {
            (Runner::Exact, Precision::Single) => return None,
            (Runner::Exact, Precision::Double) => given.exactly(),
            (_, Precision::Double) => given.stepped::<f64>(method, TOLERANCES[0]),
            (_, Precision::Single) => given.stepped::<f32>(method, TOLERANCES[1]),
        };
        Some(match end {
            End::Refused => Fate::Refused,
            End::NotFinite => Fate::NotFinite,
            End::Seen(seen) => given.fate(&seen).unwrap_or(Fate::Refused),
        })
    }
}

impl Case {
    /// The body that single precision is given, of rounded numbers.
    fn in_single(&self) -> Self {
        Self { moments: self.moments.map(single), omega: self.omega.map(single), ..self.clone() }
    }

    fn system(&self) -> Result<System<f64>, tumbling::Error> {
        let moments = Vector3::from(self.moments);
        if self.damping == 0.0 {
            return System::free(moments.try_into()?);
        }
        System::with(moments.try_into()?, vec![Torque::Damping(moments * self.damping)])
    }

    fn duration(&self) -> f64 {
        let count = self.count as f64;
        self.step * count
    }

    /// The truth at `t`: of a damped body the free motion at a later start's time.
    fn truth(&self, motion: &FreeMotion, t: f64) -> Result<(Vector3<f64>, Quaternion<f64>), Error> {
        let left = (-self.damping * t).exp();
        let time = if self.damping == 0.0 { t } else { (1.0 - left) / self.damping };
        let at = motion.at(time)?;
        Ok((at.omega * left, at.attitude.into_inner()))
    }

    fn exactly(&self) -> End {
        let result = self.system().map_err(Error::from).and_then(|system| {
            let start =
                State { attitude: Quaternion::identity(), momentum: system.momentum(&self.omega.into()) };
            let motion = FreeMotion::new(self.moments.try_into()?, &self.omega.into())?;
            let mut kicked = start;
            self.watch(&system, &start, |k| {
                let t = self.step * k as f64;
                if self.damping > 0.0 {
                    kicked = exact_drift::step(&system, &kicked, self.step)?;
                    return Ok(kicked);
                }
                let at = motion.at(t)?;
                Ok(State { attitude: at.attitude.into_inner(), momentum: system.momentum(&at.omega) })
            })
        });
        result.unwrap_or(End::Refused)
    }

    /// By a method, or, where there is none, within a tolerance from each of its steps to the next.
    fn stepped<T>(&self, method: Option<Method>, tolerance: f64) -> End
    where
        T: Analytic + Copy + FromPrimitive + ToPrimitive + Send + Sync,
    {
        let number = |x: f64| T::from_f64(x).unwrap_or_else(T::zero);
        let back = |x: &T| x.to_f64().unwrap_or(f64::NAN);
        let vector = |x: [f64; 3]| Vector3::from(x.map(number));
        let Ok(checked) = self.system() else { return End::Refused };
        let torques = if self.damping == 0.0 {
            Vec::new()
        } else {
            vec![Torque::Damping(vector(self.moments.map(|x| x * self.damping)))]
        };
        let system = System::of_numbers(vector(self.moments), torques);
        let attitude = Quaternion::new(T::one(), T::zero(), T::zero(), T::zero());
        let mut motion = State { attitude, momentum: system.momentum(&vector(self.omega)) };
        let outside = |motion: &State<T>| State {
            attitude: Quaternion::from_vector(motion.attitude.coords.map(|x| back(&x))),
            momentum: motion.momentum.map(|x| back(&x)),
        };
        let start = outside(&motion);
        let h = number(self.step);
        let Ok(mut stepper) = Stepper::of_system(system.clone(), &motion, tolerance, BUDGET) else {
            return End::Refused;
        };
        self.watch(&checked, &start, |_| {
            motion = match method {
                Some(method) => method.step(&system, &motion, h)?,
                None => stepper.step(h)?,
            };
            Ok(outside(&motion))
        })
        .unwrap_or(End::Refused)
    }

    /// Follows a run, step by step.
    fn watch(
        &self,
        system: &System<f64>,
        start: &State<f64>,
        mut next: impl FnMut(usize) -> Result<State<f64>, Error>,
    ) -> Result<End, Error> {
        // In units of the start's, so that no square leaves the range.
        let (size, length) = (start.momentum.amax(), |v: &Vector3<f64>| v.amax());
        let unit = |v: &Vector3<f64>| if size > 0.0 { v / size } else { *v };
        let energy = |v: &Vector3<f64>| {
            let part = unit(v);
            let moments = system.moments() / system.moments().amax();
            part.component_div(&moments).dot(&part)
        };
        let start_energy = energy(&start.momentum);
        let start_momentum = unit(&start.momentum).norm();
        let mut seen = Seen {
            energy: [1.0; 2],
            momentum: [1.0; 2],
            changes: 0,
            last_change: f64::NAN,
            attitude: start.attitude,
            left: start.momentum,
            reversed: false,
        };
        let mut before = *start;
        for k in 1..=self.count {
            let motion = next(k)?;
            if !motion.momentum.iter().chain(&motion.attitude.coords).all(|x| x.is_finite()) {
                return Ok(End::NotFinite);
            }
            let grow = |bounds: &mut [f64; 2], x: f64| *bounds = [bounds[0].min(x), bounds[1].max(x)];
            grow(&mut seen.energy, energy(&motion.momentum) / start_energy);
            grow(&mut seen.momentum, unit(&motion.momentum).norm() / start_momentum);
            let [a, b] = [before.momentum[self.watched], motion.momentum[self.watched]];
            let t = self.step * (k - 1) as f64;
            // Below the smallest sign that matters, rounding may change it.
            if a * b < 0.0
                || (a == 0.0 && b != 0.0 && k > 1)
                || (a.signum() != b.signum() && length(&motion.momentum) < 1e-150)
            {
                seen.changes += 1;
                seen.last_change = t + self.step * a / (a - b);
            }
            // By more than rounding leaves of a momentum that is gone.
            if self.damping > 0.0 && unit(&before.momentum).dot(&unit(&motion.momentum)) < -1e-9 && k == 1 {
                seen.reversed = true;
            }
            (seen.attitude, seen.left) = (motion.attitude, motion.momentum);
            before = motion;
            if seen.energy[1] > 1e9 {
                break;
            }
        }
        Ok(End::Seen(seen))
    }

    fn fate(&self, seen: &Seen) -> Result<Fate, Error> {
        let motion = FreeMotion::new(self.moments.try_into()?, &self.omega.into())?;
        let end = self.duration();
        let (omega, attitude) = self.truth(&motion, end)?;
        let distance = |q: &Quaternion<f64>| {
            let q = q.normalize().coords;
            4.0 * ((q - attitude.coords).norm().min((q + attitude.coords).norm()) / 2.0).min(1.0).asin()
        };
        if self.damping > 0.0 {
            let moments = Vector3::from(self.moments);
            let truth = omega.component_mul(&moments);
            let start = Vector3::from(self.omega).component_mul(&moments).norm();
            let off = (seen.left.norm() - truth.norm()) / start;
            return Ok(match off {
                _ if seen.reversed => Fate::Reversed,
                _ if seen.momentum[1] > 1.1 || off > 0.1 => Fate::Gained,
                off if off < -0.1 => Fate::Lost,
                off if off.abs() > 0.01 => Fate::Worn,
                _ if truth.norm() > 0.1 * start && distance(&seen.attitude) > 0.1 => Fate::Late,
                _ => Fate::Right,
            });
        }
        let [low, high] = [seen.energy[0].min(seen.momentum[0]), seen.energy[1].max(seen.momentum[1])];
        if high > 1.1 {
            return Ok(Fate::Gained);
        }
        if low < 0.9 {
            return Ok(Fate::Lost);
        }
        let expected = self.expected(&motion, end)?;
        if seen.changes != expected.len() {
            return Ok(Fate::WrongFlips);
        }
        if high > 1.01 || low < 0.99 {
            return Ok(Fate::Worn);
        }
        let late = match expected.as_slice() {
            [] => distance(&seen.attitude) > 0.1,
            [only] => (seen.last_change - only).abs() > 0.1 * only,
            [.., before, last] => (seen.last_change - last).abs() > 0.1 * (last - before),
        };
        Ok(if late { Fate::Late } else { Fate::Right })
    }

    /// When the watched component truly changes sign.
    fn expected(&self, motion: &FreeMotion, end: f64) -> Result<Vec<f64>, Error> {
        let mut order = [0, 1, 2];
        order.sort_by(|&i, &j| self.moments[i].total_cmp(&self.moments[j]));
        if self.flips.is_some() || order[1] == self.watched {
            return Ok(motion.flips(0.0, end)?.collect());
        }
        // Seen at each step: of a motion about this axis there are none.
        let mut signs = Vec::new();
        for k in 0..=self.count {
            let t = self.step * k as f64;
            signs.push((t, motion.omega(t)?[self.watched]));
        }
        Ok(observe::sign_changes(signs))
    }
}
