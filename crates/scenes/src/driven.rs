//! How a body under torques is stepped: a tolerance is chosen from the accuracy and tried; the body is
//! stepped again with finer tolerances until two runs agree.

use crate::cost;
use crate::error::{Error, within};
use crate::initial_state::Checked;
use crate::plan::Driven;
use crate::scene::{Outputs, Scene};
use crate::torques::Rates;
use nalgebra::{UnitQuaternion, Vector3};
use tumbling::dynamics::observe;
use tumbling::step::{State, Stepper, Torque};
use tumbling::{Body, attitude};

/// The largest number of steps of all trial runs together.
const MOST_STEPS: usize = 3_000_000;
/// The number of requested times at which runs are compared, besides the last,
const COMPARED: u64 = 32;
/// and the number of equal parts of the span at whose ends they are.
const INNER: u32 = 16;

/// How many coarser accuracies are tried if the one requested cannot be reached.
const OFFERS: usize = 8;

/// The run that the trials showed to be accurate enough.
///
/// The error offers another accuracy only if a plan for it succeeded. The smallest difference between two
/// runs would be a bad guess: it may be small by chance where it consists of rounding alone.
pub(crate) fn chosen(start: &Checked, body: &Body, scene: &Scene) -> Result<Driven, Error> {
    let requested = scene.accuracy();
    let mut found = chosen_to(requested, start, body, scene);
    let mut offered = None;
    for _ in 0..OFFERS {
        match found {
            Err(Error::Unattainable { attainable, .. }) => {
                let offer = two_digits(attainable.max(2.0 * offered.unwrap_or(0.0)));
                offered = Some(offer);
                found = chosen_to(offer, start, body, scene);
            }
            Ok(driven) => {
                let refused = |attainable| Err(Error::Unattainable { requested, attainable });
                return offered.map_or(Ok(driven), refused);
            }
            _ => break,
        }
    }
    match found {
        Err(Error::Unattainable { .. }) | Ok(_) => Err(Error::Disagreement { requested, steps: 0 }),
        Err(Error::Disagreement { steps, .. }) => Err(Error::Disagreement { requested, steps }),
        Err(error) => Err(error),
    }
}

/// The number rounded up to the two digits that are printed of it.
fn two_digits(x: f64) -> f64 {
    format!("{:.1e}", 1.05 * x).parse().unwrap_or(x).max(x)
}

fn chosen_to(accuracy: f64, start: &Checked, body: &Body, scene: &Scene) -> Result<Driven, Error> {
    let end = scene.times().end();
    let rates = Rates::of(start, scene.torques(), end)?;
    let (times, stiff) = (compared(scene), rates.are_stiff(end));
    let outputs = Outputs { flips: scene.outputs().flips && start.can_flip(), ..scene.outputs() };
    let turned = (rates.spin * end).max(1.0);
    let trial = Trial { body, torques: scene.torques(), times: &times, outputs, accuracy, turned };
    // Leaves room for a finer tolerance, so that there are two runs to compare.
    let first = (0.03 * accuracy).max(8.0 * LEAST_TOLERANCE);
    // Where damping is that fast, each step is a collocation; MOST_STEPS of them take too long to try.
    let most = if stiff { MOST_STEPS / 20 } else { MOST_STEPS };
    let mut budget = Budget { left: most, spent: 0.0 };
    let (tolerance, difference, steps) =
        if end == 0.0 { (first, 0.0, 0) } else { trial.refined(first, &mut budget)? };
    let stepper = trial.stepper(tolerance, usize::MAX)?;
    Ok(Driven { stepper, tolerance, difference, steps, trials: budget.spent, stiff })
}

/// Times at which runs are compared, in order: a selection of those requested, evenly chosen, with the last,
/// and denser towards the first, where fast transients still exist; and some times between, because two wrong
/// runs may agree at a single instant.
fn compared(scene: &Scene) -> Vec<f64> {
    let last = scene.times().count().saturating_sub(1);
    let every = scene.times().count().div_ceil(COMPARED).max(1);
    let doubled = (0..64).map(|k| 1_u64 << k);
    let places = (0..COMPARED).map(|k| k * every).chain(doubled).filter(|n| *n < last).chain([last]);
    let end = scene.times().end();
    let inner = (1..INNER).map(|k| end * (f64::from(k) / f64::from(INNER)));
    let mut times: Vec<f64> = places.map(|n| scene.times().nth(n)).chain(inner).collect();
    times.sort_by(f64::total_cmp);
    times.dedup();
    times
}

/// The least tolerance that an adaptive [`Stepper`] accepts: below it the error of a step is rounding.
const LEAST_TOLERANCE: f64 = 4.0 * f64::EPSILON;

/// The budget of the trial runs, and their cost.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Budget {
    /// The number of steps left.
    left: usize,
    /// The cost of those taken, in instructions.
    spent: f64,
}

/// Why a run ended early.
#[derive(Debug, Clone, PartialEq)]
enum Stop {
    /// The steps allowed are used up.
    OutOfSteps,
    /// A step is refused.
    Refused(Error),
}

/// What two runs are compared by.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Run {
    /// At the times compared, with the spin in body axes.
    pub states: Vec<(Vector3<f64>, State<f64>)>,
    /// Their times, s.
    pub flips: Vec<f64>,
    /// The number of steps.
    pub steps: usize,
}

/// How runs are tried.
#[derive(Debug)]
pub struct Trial<'a> {
    /// The body at its start.
    pub body: &'a Body,
    /// The torques on it.
    pub torques: &'a [Torque<f64>],
    /// At which runs are compared.
    pub times: &'a [f64],
    /// What is compared.
    pub outputs: Outputs,
    /// The error allowed.
    pub accuracy: f64,
    /// Radians from start to end.
    pub turned: f64,
}

impl Trial<'_> {
    /// A stepper at the start with this tolerance, and at most this number of steps from one time to the
    /// next.
    fn stepper(&self, tolerance: f64, budget: usize) -> Result<Stepper, Error> {
        let stepper = Stepper::adaptive(self.body, tolerance, budget)?;
        Ok(stepper.with_torques(self.torques.iter().cloned())?)
    }

    /// Refines until two runs agree to half of the accuracy (and then uses the finer) or to a tenth of it
    /// (and then uses the coarser), with at most the steps of the budget in total. Returns the tolerance, the
    /// difference from the other run and the number of steps.
    ///
    /// Each tolerance is a hundredth of the one before, which costs a quarter more. Errors decrease with the
    /// tolerance only on average: where the motion amplifies errors, two runs with tolerances ten times apart
    /// were observed to have the same error.
    fn refined(&self, first: f64, budget: &mut Budget) -> Result<(f64, f64, usize), Error> {
        let (all, steps) = (budget.left, self.turned / cost::RADIANS);
        // Known to take more steps than two runs may.
        let rule = format!("it must not be above {}, the most that are tried", all / 2);
        within("the number of steps that the torques require", steps, steps <= (all / 2) as f64, rule)?;
        let (mut tolerance, mut best) = (first, f64::INFINITY);
        let mut coarse = self.run(tolerance, budget);
        while coarse != Err(Stop::OutOfSteps) {
            let finer = (0.01 * tolerance).max(LEAST_TOLERANCE);
            if finer == tolerance || steps > budget.left as f64 {
                break;
            }
            let fine = self.run(finer, budget);
            let difference = match (&coarse, &fine) {
                (Ok(a), Ok(b)) => self.apart(a, b),
                _ => f64::INFINITY,
            };
            // If the runs agree this much better than requested, the coarser run is accurate enough.
            for (tolerance, run, share) in [(tolerance, &coarse, 0.1), (finer, &fine, 0.5)] {
                if difference <= share * self.accuracy
                    && let Ok(Run { steps, .. }) = run
                {
                    return Ok((tolerance, difference, *steps));
                }
            }
            best = best.min(difference);
            (coarse, tolerance) = (fine, finer);
        }
        match coarse {
            // Runs must agree to half of the accuracy; another factor of two, since another accuracy leads to
            // other steps and roundings.
            _ if 4.0 * best < 1.0 => {
                Err(Error::Unattainable { requested: self.accuracy, attainable: 4.0 * best })
            }
            Err(Stop::Refused(error)) if best.is_infinite() => Err(error),
            _ => Err(Error::Disagreement { requested: self.accuracy, steps: all - budget.left }),
        }
    }

    fn run(&self, tolerance: f64, budget: &mut Budget) -> Result<Run, Stop> {
        let mut run = Run::default();
        let done = self.fill(&mut run, tolerance, budget.left);
        budget.left = budget.left.saturating_sub(run.steps);
        budget.spent += cost::run(tolerance, self.times.len() as u64, run.steps, false);
        done.map(|()| run)
    }

    /// In at most `left` steps.
    fn fill(&self, run: &mut Run, tolerance: f64, left: usize) -> Result<(), Stop> {
        let mut stepper = self.stepper(tolerance, left).map_err(Stop::Refused)?;
        let flips = self.outputs.flips;
        for &time in self.times {
            let there = if flips {
                stepper.flips(time).map(|found| run.flips.extend(found))
            } else {
                stepper.step_to(time).map(drop)
            };
            run.steps = stepper.steps_of_run();
            if run.steps > left || (run.steps == left && there.is_err()) {
                return Err(Stop::OutOfSteps);
            }
            there.map_err(|error| Stop::Refused(error.into()))?;
            run.states.push((stepper.omega(), stepper.state()));
        }
        Ok(())
    }

    /// The largest difference between two runs: in spin and energy, relative to the largest so far, in the
    /// angle between attitudes, and in the angle turned between their flips. All but the spin are compared
    /// only if they are requested. Infinite where a value is not a number, or only one of the two runs has a
    /// flip.
    pub fn apart(&self, a: &Run, b: &Run) -> f64 {
        let Outputs { energy: rich, attitude, flips, .. } = self.outputs;
        let (mut fastest, mut richest, mut worst) = (0.0_f64, 0.0_f64, 0.0_f64);
        let share = |x: f64, y: f64| if y > 0.0 { x / y } else { 0.0 };
        for ((w, one), (v, other)) in a.states.iter().zip(&b.states) {
            fastest = fastest.max(v.norm());
            let spin = share((w - v).norm(), fastest);
            let energy = if rich {
                let [d, e] = [(w, one), (v, other)].map(|(w, state)| observe::energy(w, &state.momentum));
                richest = richest.max(e);
                share((d - e).abs(), richest)
            } else {
                0.0
            };
            if spin.is_nan() || energy.is_nan() {
                return f64::INFINITY;
            }
            worst = worst.max(spin).max(energy);
        }
        if flips {
            let pairs = a.flips.iter().zip(&b.flips);
            let late = pairs.map(|(one, other)| (one - other).abs()).fold(0.0, f64::max);
            worst = if a.flips.len() == b.flips.len() { worst.max(late * fastest) } else { f64::INFINITY };
        }
        if attitude { worst.max(largest_angle(a, b)) } else { worst }
    }
}

/// The largest angle between two runs' attitudes: from the end, where it mostly is, and with an arctangent
/// only where the chord says that it may be larger than those before; infinite where one is not a number.
fn largest_angle(a: &Run, b: &Run) -> f64 {
    let (mut largest, mut longest) = (0.0_f64, 0.0_f64);
    for ((_, one), (_, other)) in a.states.iter().zip(&b.states).rev() {
        let [p, q] = [one, other].map(|state| UnitQuaternion::from_quaternion(state.attitude));
        let (minus, plus) = (p.coords - q.coords, p.coords + q.coords);
        let chord = minus.norm_squared().min(plus.norm_squared());
        // A margin for the rounding of two attitudes that agree.
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
