//! How a body under torques is stepped: a tolerance is chosen from the accuracy and tried; the body is
//! stepped again with finer tolerances until two runs agree.

use crate::cost;
use crate::error::Error;
use crate::free;
use crate::initial_state::Checked;
use crate::plan::Driven;
use crate::scene::{Outputs, Scene};
use crate::torques::are_stiff;
use nalgebra::{Matrix3, UnitQuaternion, Vector3};
use tumbling::dynamics::observe;
use tumbling::step::{State, Stepper, Torque};
use tumbling::{Body, Inertia, attitude};

/// The largest number of steps of all trial runs for an accuracy together.
const MOST_STEPS: usize = 3_000_000;
/// The number of requested times at which runs are compared, besides the last,
const COMPARED: u64 = 32;
/// and the number of equal parts of the span at whose ends they are.
const INNER: u32 = 16;

/// The tolerances that are tried. They are the same for every accuracy, so that what is accepted is accepted
/// for a coarser accuracy too.
const TOLERANCES: [f64; 7] =
    [0.03 * 1e-2, 0.03 * 1e-4, 0.03 * 1e-6, 0.03 * 1e-8, 0.03 * 1e-10, 0.03 * 1e-12, LEAST_TOLERANCE];

/// The run that the trials showed to be accurate enough.
///
/// The error offers another accuracy only if a plan for it succeeded.
pub(crate) fn chosen(start: &Checked, body: &Body, scene: &Scene) -> Result<Driven, Error> {
    let requested = scene.accuracy();
    let mut accuracy = requested;
    loop {
        match chosen_to(accuracy, start, body, scene) {
            Ok(driven) if accuracy == requested => return Ok(driven),
            Ok(_) => return Err(Error::unattainable(requested, accuracy)),
            Err(Error::Unattainable { attainable, .. }) if accuracy < attainable && attainable < 1.0 => {
                accuracy = attainable;
            }
            Err(Error::Unattainable { attainable, .. }) => {
                return Err(Error::unattainable(requested, attainable));
            }
            Err(error) => return Err(error),
        }
    }
}

fn chosen_to(accuracy: f64, start: &Checked, body: &Body, scene: &Scene) -> Result<Driven, Error> {
    free::determined(start, accuracy, 1.0)?;
    let end = scene.times().end();
    let stiff = are_stiff(start, scene.torques(), end)?;
    let times = compared(scene);
    let outputs = Outputs { flips: scene.outputs().flips && start.can_flip(), ..scene.outputs() };
    let trial = Trial { body, torques: scene.torques(), times: &times, outputs, accuracy };
    // Where damping is that fast, each step is a collocation; MOST_STEPS of them take too long to try.
    let most = if stiff { MOST_STEPS / 20 } else { MOST_STEPS };
    let mut budget = Budget { left: most, spent: 0.0 };
    let (tolerance, difference, steps) =
        if end == 0.0 { (LEAST_TOLERANCE, 0.0, 0) } else { trial.refined(&mut budget)? };
    let stepper = stepper(body, scene.torques(), tolerance, usize::MAX)?;
    Ok(Driven { stepper, tolerance, difference, steps, trials: budget.spent, stiff })
}

/// A stepper of a body at the start with this tolerance, and at most this number of steps from one time to
/// the next.
fn stepper(body: &Body, torques: &[Torque<f64>], tolerance: f64, budget: usize) -> Result<Stepper, Error> {
    Ok(Stepper::adaptive(body, tolerance, budget)?.with_torques(torques.iter().cloned())?)
}

/// The body up to four roundings longer or shorter along each axis, and as much faster or slower about it: as
/// far off as the rounding of its start and of its steps may leave it.
///
/// What is stretched are its sums of mass times two coordinates, so that the tensor stays possible. What is
/// zero stays zero.
pub fn changed(body: &Body, faster: f64) -> Result<Body, Error> {
    let [stretch, spin] = [[1.0, -1.0, 0.5], [-0.5 * faster, faster, faster]]
        .map(|signs| Vector3::from(signs).map(|sign| 1.0 + 4.0 * f64::EPSILON * sign));
    let tensor = body.inertia().matrix();
    let sums = Matrix3::from_diagonal_element(0.5 * tensor.trace()) - tensor;
    // Of the change alone, so that a needle's small moment keeps its digits.
    let change = sums.component_mul(&(stretch * stretch.transpose()).add_scalar(-1.0));
    let tensor = tensor + Matrix3::from_diagonal_element(change.trace()) - change;
    let omega = body.omega_body().component_mul(&spin);
    Ok(Body::spinning(Inertia::within(&tensor, 1e-12)?.0, body.attitude(), &omega)?)
}

/// Times at which runs are compared, in order: a selection of those requested, evenly chosen, with the last,
/// and denser towards the first, where fast transients still exist; some times between, because two wrong
/// runs may agree at a single instant; and those at which a torque begins or ends, where the spin may be at
/// its largest.
fn compared(scene: &Scene) -> Vec<f64> {
    let last = scene.times().count().saturating_sub(1);
    let every = scene.times().count().div_ceil(COMPARED).max(1);
    let doubled = (0..64).map(|k| 1_u64 << k);
    let places = (0..COMPARED).map(|k| k * every).chain(doubled).filter(|n| *n < last).chain([last]);
    let end = scene.times().end();
    let inner = (1..INNER).map(|k| end * (f64::from(k) / f64::from(INNER)));
    let edges = scene.torques().iter().flat_map(|torque| match torque {
        Torque::During { start, end, .. } => [*start, *end],
        _ => [0.0; 2],
    });
    let edges = edges.filter(|time| *time > 0.0 && *time < end);
    let mut times: Vec<f64> = places.map(|n| scene.times().nth(n)).chain(inner).chain(edges).collect();
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

/// What two runs are compared by.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Run {
    /// At the times compared, with the spin in body axes.
    pub states: Vec<(Vector3<f64>, State<f64>)>,
    /// The times of its flips, s.
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
}

impl Trial<'_> {
    /// Refines until two runs agree to half of the accuracy (and then uses the finer) or to a tenth of it
    /// (and then uses the coarser), with at most the steps of the budget in total. Returns the tolerance, the
    /// difference from the other run and the number of steps.
    ///
    /// Each tolerance but the last is a hundredth of the one before, which costs a quarter more. Errors
    /// decrease with the tolerance only on average: where the motion amplifies errors, two runs with
    /// tolerances ten times apart were observed to have the same error. With the least tolerance two runs
    /// differ by rounding alone, and may agree by chance; so the finer one is compared with two runs of a
    /// [`changed`] body too.
    fn refined(&self, budget: &mut Budget) -> Result<(f64, f64, usize), Error> {
        let (all, requested) = (budget.left, self.accuracy);
        let from = TOLERANCES.partition_point(|t| *t > 0.03 * requested).min(TOLERANCES.len() - 2);
        let mut tolerance = TOLERANCES[from];
        let (mut coarse, mut best) = (self.run(self.body, tolerance, budget), None);
        for &finer in &TOLERANCES[from + 1..] {
            // A finer run takes no fewer steps.
            if coarse.as_ref().map_or(0, |run| run.steps) >= budget.left {
                break;
            }
            let fine = self.run(self.body, finer, budget);
            let mut difference = self.between(&coarse, &fine);
            if finer == LEAST_TOLERANCE && difference < 0.5 {
                for faster in [1.0, -1.0] {
                    let other = self.run(&changed(self.body, faster)?, finer, budget);
                    if let Err(Error::OutOfSteps { .. }) = other {
                        return Err(Error::OutOfSteps { steps: all - budget.left });
                    }
                    difference = difference.max(self.between(&fine, &other));
                }
            }
            // If the runs agree this much better than requested, the coarser run is accurate enough.
            for (tolerance, run, share) in [(tolerance, &coarse, 0.1), (finer, &fine, 0.5)] {
                if difference <= share * requested
                    && let Ok(Run { steps, .. }) = run
                {
                    return Ok((tolerance, difference, *steps));
                }
            }
            best = Some(difference.min(best.unwrap_or(f64::INFINITY)));
            (coarse, tolerance) = (fine, finer);
        }
        let steps = all - budget.left;
        Err(match (best, coarse) {
            // Runs must agree to half of the accuracy.
            (Some(best), _) if 2.1 * best < 1.0 => Error::unattainable(requested, 2.0 * best),
            (None | Some(f64::INFINITY), Err(error)) if !matches!(error, Error::OutOfSteps { .. }) => error,
            (Some(f64::INFINITY), Err(_)) | (None, _) => Error::OutOfSteps { steps },
            _ => Error::Disagreement { steps },
        })
    }

    fn run(&self, body: &Body, tolerance: f64, budget: &mut Budget) -> Result<Run, Error> {
        let mut run = Run::default();
        let done = self.fill(&mut run, body, tolerance, budget.left);
        budget.left = budget.left.saturating_sub(run.steps);
        budget.spent += cost::run(tolerance, self.times.len() as u64, run.steps, false);
        done.map(|()| run)
    }

    /// In at most `left` steps.
    fn fill(&self, run: &mut Run, body: &Body, tolerance: f64, left: usize) -> Result<(), Error> {
        let mut stepper = stepper(body, self.torques, tolerance, left)?;
        let flips = self.outputs.flips;
        for &time in self.times {
            let there = if flips {
                stepper.flips(time).map(|found| run.flips.extend(found))
            } else {
                stepper.step_to(time).map(drop)
            };
            run.steps = stepper.steps_of_run();
            if run.steps > left || (run.steps == left && there.is_err()) {
                return Err(Error::OutOfSteps { steps: run.steps });
            }
            there?;
            run.states.push((stepper.omega(), stepper.state()));
        }
        Ok(())
    }

    /// The difference between two runs, infinite if there are not two.
    fn between(&self, a: &Result<Run, Error>, b: &Result<Run, Error>) -> f64 {
        let Ok((a, b)) = a.as_ref().and_then(|a| Ok((a, b.as_ref()?))) else { return f64::INFINITY };
        self.apart(a, b)
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
