//! Trial runs: a scene is stepped and stepped again finer, until two runs agree.

use crate::error::Error;
use crate::outputs::Outputs;
use crate::prices;
use crate::step_control::{StepControl, Stepping, Stop};
use nalgebra::UnitQuaternion;
use tumbling::attitude;
use tumbling::dynamics::observe;
use tumbling::step::{State, System};

/// Rounds of refinement before a trial is given up.
const ROUNDS: usize = 30;

/// What a trial showed to be accurate enough.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Chosen {
    pub(crate) control: StepControl,
    /// The largest difference from a run of other steps.
    pub(crate) difference: f64,
    /// The number of steps of the run.
    pub(crate) steps: usize,
}

/// What trial runs may take, and what they took.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Budget {
    /// The number of steps left.
    pub(crate) left: usize,
    /// The cost of those taken, in instructions.
    pub(crate) spent: f64,
}

/// The states of a run at the times compared, with its number of steps.
type Run = Result<(Vec<State<f64>>, usize), Stop>;

pub(crate) struct Trial<'a> {
    pub(crate) system: &'a System<f64>,
    pub(crate) start: &'a State<f64>,
    /// At which runs are compared.
    pub(crate) times: &'a [f64],
    pub(crate) outputs: Outputs,
    pub(crate) accuracy: f64,
    pub(crate) end: f64,
    /// Radians from start to end.
    pub(crate) turned: f64,
}

impl Trial<'_> {
    /// The expected number of steps of a run.
    fn steps(&self, control: StepControl) -> f64 {
        match control {
            StepControl::ExactDrift(step) => self.end / step,
            StepControl::Tolerance(_) => self.turned / prices::RADIANS,
        }
    }

    /// Refines until two runs agree to half of the accuracy, and takes the finer, or to a tenth, and takes
    /// the coarser; in at most the steps of the budget in all.
    pub(crate) fn refined(&self, first: StepControl, budget: &mut Budget) -> Result<Chosen, Error> {
        self.worth_trying(first, budget.left)?;
        let all = budget.left;
        let mut control = first;
        let mut best = f64::INFINITY;
        let mut coarse = self.run(control, None, budget);
        for _ in 0..ROUNDS {
            if coarse == Err(Stop::OutOfSteps) {
                break;
            }
            let observed = coarse.as_ref().map_or(f64::INFINITY, |_| best);
            let finer =
                control.finer(if observed.is_finite() { 0.5 * self.accuracy / observed } else { 0.0 });
            if finer == control || self.steps(finer) > budget.left as f64 {
                break;
            }
            let fine = self.run(finer, Some(control), budget);
            let difference = match (&coarse, &fine) {
                (Ok((a, _)), Ok((b, _))) => self.apart(a, b),
                _ => f64::INFINITY,
            };
            // Halving the step halves an error at least: what is so much better than requested is right by
            // the coarser run already.
            for (control, run, share) in [(control, &coarse, 0.1), (finer, &fine, 0.5)] {
                if difference <= share * self.accuracy
                    && let Ok((_, steps)) = run
                {
                    return Ok(Chosen { control, difference, steps: *steps });
                }
            }
            best = best.min(difference);
            // What was cut for the comparison alone is put back before it is compared with the next.
            coarse = if self.cuts(finer, control) { self.run(finer, None, budget) } else { fine };
            control = finer;
        }
        match coarse {
            // Agreement is half of the accuracy; as much again, for roundings differ with the steps that
            // another accuracy leads to.
            _ if 4.0 * best < 1.0 => {
                Err(Error::Unattainable { requested: self.accuracy, attainable: 4.0 * best })
            }
            Err(Stop::Refused(error)) if best.is_infinite() => Err(error),
            _ => Err(Error::Disagreement { requested: self.accuracy, steps: all - budget.left }),
        }
    }

    /// Refuses a run that is known to take more steps than are left.
    fn worth_trying(&self, control: StepControl, left: usize) -> Result<(), Error> {
        let (steps, what) = (self.steps(control), "the number of steps that the torques require");
        if steps.is_nan() {
            return Err(Error::OutOfRange { what, value: steps });
        }
        if steps > left as f64 {
            let rule = format!("it must not be above {left}, the most that are tried");
            return Err(Error::Value { what, value: steps, rule });
        }
        Ok(())
    }

    /// Whether a finer step is not finer everywhere: between some of the times both are one step, or as many.
    fn cuts(&self, finer: StepControl, coarser: StepControl) -> bool {
        let mut from = 0.0;
        self.times.iter().any(|&to| {
            let between = to - std::mem::replace(&mut from, to);
            between > 0.0 && finer.count(between) < coarser.count(between).map(|count| 2 * count)
        })
    }

    /// With `over` a coarser one, at least twice its steps between each two times: what takes one step either
    /// way would agree with itself.
    fn run(&self, control: StepControl, over: Option<StepControl>, budget: &mut Budget) -> Run {
        let mut now = 0.0;
        let whole = budget.left;
        let mut of_run = whole;
        let mut states = Vec::with_capacity(self.times.len());
        let mut on = |of_run: &mut usize| {
            let mut stepping = Stepping::new(control, self.system, self.start, *of_run)?;
            for &time in self.times {
                let between = time - std::mem::replace(&mut now, time);
                let least = over.and_then(|coarser| coarser.count(between)).map_or(1, |count| 2 * count);
                states.push(stepping.to(time, least, of_run)?);
            }
            Ok::<(), Stop>(())
        };
        let done = on(&mut of_run);
        let taken = whole - of_run;
        budget.left -= taken;
        budget.spent += control.price(self.times.len() as u64, taken, false);
        done.map(|()| (states, taken))
    }

    /// The largest angle between two runs' attitudes, or difference of spin, or of energy, relative to the
    /// largest so far; of attitude and energy where they are requested.
    fn apart(&self, a: &[State<f64>], b: &[State<f64>]) -> f64 {
        let (mut fastest, mut richest, mut worst) = (0.0_f64, 0.0_f64, 0.0_f64);
        let over = |x: f64, y: f64| if y > 0.0 { x / y } else { 0.0 };
        for (one, other) in a.iter().zip(b) {
            let (w, v) = (self.system.omega(&one.momentum), self.system.omega(&other.momentum));
            fastest = fastest.max(v.norm());
            let spin = over((w - v).norm(), fastest);
            let energy = if self.outputs.energy {
                let [d, e] = [(&w, one), (&v, other)].map(|(w, motion)| observe::energy(w, &motion.momentum));
                richest = richest.max(e);
                over((d - e).abs(), richest)
            } else {
                0.0
            };
            worst = worst.max(spin).max(energy);
            // A difference that is not a number is no agreement.
            if spin.is_nan() || energy.is_nan() {
                return f64::INFINITY;
            }
        }
        if self.outputs.attitude { worst.max(largest_angle(a, b)) } else { worst }
    }
}

/// The largest angle between two runs' attitudes: from the end, where it mostly is, and with an arctangent
/// only where the chord says that it may be larger than those before; infinite where one is not a number.
fn largest_angle(a: &[State<f64>], b: &[State<f64>]) -> f64 {
    let (mut largest, mut longest) = (0.0_f64, 0.0_f64);
    for (one, other) in a.iter().zip(b).rev() {
        let [p, q] = [one, other].map(|motion| UnitQuaternion::from_quaternion(motion.attitude));
        let (minus, plus) = (p.coords - q.coords, p.coords + q.coords);
        let chord = minus.norm_squared().min(plus.norm_squared());
        // With room for the rounding of two attitudes that agree.
        if chord + 1e-30 < 0.9 * longest {
            continue;
        }
        let angle = attitude::angle_between(&p, &q);
        if angle.is_nan() {
            return f64::INFINITY;
        }
        (largest, longest) = (largest.max(angle), longest.max(chord));
    }
    largest
}

#[cfg(test)]
mod tests {
    use super::*;
    use nalgebra::{Quaternion, Vector3};

    /// A needle turns fast about its light axis, and its energy is in the heavy ones: a percent of the spin
    /// is two thirds of it.
    #[test]
    fn runs_that_agree_in_spin_and_not_in_energy_are_apart_where_energy_is_requested() {
        let system = System::free([1e-4, 1.0, 1.0].try_into().unwrap()).unwrap();
        let [a, b] = [0.1, 0.2].map(|heavy| State {
            attitude: Quaternion::identity(),
            momentum: system.momentum(&Vector3::new(10.0, heavy, 0.0)),
        });
        let apart = |energy| {
            let (times, accuracy, end, turned) = (&[1.0][..], 0.1, 1.0, 10.0);
            let outputs = Outputs { spin: true, energy, ..Outputs::NOTHING };
            let trial = Trial { system: &system, start: &a, times, outputs, accuracy, end, turned };
            trial.apart(std::slice::from_ref(&a), std::slice::from_ref(&b))
        };
        assert!((apart(false) - 0.01).abs() < 1e-5);
        // 0.005 + 0.005 J and 0.005 + 0.02 J.
        assert!((apart(true) - 0.6).abs() < 1e-12);
    }

    /// Between times that are closer than a step two runs would take the same one, and agree whatever it is
    /// worth.
    #[test]
    fn a_finer_run_has_twice_the_steps_between_any_two_times() {
        let system = System::free([1.0, 2.0, 2.5].try_into().unwrap()).unwrap();
        let start = State { attitude: Quaternion::identity(), momentum: Vector3::new(0.1, 2.0, 0.3) };
        let times = &[0.01, 0.02, 1.0][..];
        let (accuracy, end, turned) = (0.1, 1.0, 1.0);
        let outputs = Outputs { spin: true, ..Outputs::NOTHING };
        let trial = Trial { system: &system, start: &start, times, outputs, accuracy, end, turned };
        let [coarse, fine] = [0.5, 0.25].map(StepControl::ExactDrift);
        let steps = |by, over| trial.run(by, over, &mut Budget { left: 1000, spent: 0.0 }).unwrap().1;
        assert_eq!((steps(coarse, None), steps(fine, None), steps(fine, Some(coarse))), (4, 6, 8));
        assert!(trial.cuts(fine, coarse) && !trial.cuts(StepControl::ExactDrift(0.005), coarse));
    }
}
