//! Stepping through time.

mod adaptive;
mod driven;
mod energy;
mod engine_rules;
mod expected_error;
mod extreme;
mod fixed_rate;
mod flips;
mod geometric;
mod implicit;
mod method;
mod moser_veselov;
mod order;
mod pitfalls;
mod position_stage_in_c;
mod position_stage_in_one_file;
mod requests;
mod stepper;
mod stiff;
mod top;
mod torque;
mod transition;

use crate::common::{free, free_motion, turned, under};
use nalgebra::{Matrix3, Quaternion, UnitQuaternion, Vector3};
use tumbling::step::{Method, State, Stepper, System};
use tumbling::{Body, Error, Inertia};

/// The state `duration` seconds after the start by an adaptive run; its steps are taken off the budget.
fn adaptive(
    system: &System<f64>,
    start: &State<f64>,
    duration: f64,
    tolerance: f64,
    budget: &mut usize,
) -> Result<State<f64>, Error> {
    let mut stepper = Stepper::of_system(system.clone(), start, tolerance, *budget)?;
    let end = stepper.step_to(duration);
    *budget -= stepper.steps_of_run();
    end
}

fn apart(a: &State<f64>, b: &State<f64>) -> f64 {
    let turn =
        (a.attitude.coords - b.attitude.coords).norm().min((a.attitude.coords + b.attitude.coords).norm());
    turn + (a.momentum - b.momentum).norm() / b.momentum.norm()
}

fn in_world(motion: &State<f64>) -> Vector3<f64> {
    tumbling::attitude::rotation_matrix(&motion.attitude.normalize()) * motion.momentum
}

/// The kinetic energy.
fn energy(system: &System<f64>, state: &State<f64>) -> f64 {
    tumbling::dynamics::observe::energy(&system.omega(&state.momentum), &state.momentum)
}

fn start(system: &System<f64>, omega: &Vector3<f64>) -> State<f64> {
    State { attitude: Quaternion::identity(), momentum: system.momentum(omega) }
}

/// Relative changes of energy, momentum, its direction and the attitude's length.
fn changes(system: &System<f64>, start: &State<f64>, end: &State<f64>) -> [f64; 4] {
    let relative = |x: f64, y: f64| (x / y - 1.0).abs();
    [
        relative(energy(system, end), energy(system, start)),
        relative(end.momentum.norm(), start.momentum.norm()),
        (in_world(end) - in_world(start)).norm() / start.momentum.norm(),
        relative(end.attitude.norm(), start.attitude.norm()),
    ]
}

/// A body with these moments, its axes along the world's.
fn spinning([a, b, c]: [f64; 3], omega: &Vector3<f64>) -> Body {
    Body::spinning(Inertia::from_moments(a, b, c).unwrap(), UnitQuaternion::identity(), omega).unwrap()
}

fn in_axes(moments: Vector3<f64>, axes: &UnitQuaternion<f64>) -> Inertia {
    Inertia::try_from(turned(&moments, *axes)).unwrap()
}

/// The same state in other axes, which `turn` rotates to the old ones.
fn seen_along(state: &State<f64>, turn: &UnitQuaternion<f64>) -> State<f64> {
    State { attitude: state.attitude * turn.into_inner(), momentum: turn.inverse() * state.momentum }
}

fn steppers() -> impl Iterator<Item = Option<Method>> {
    let to_the_truth = Method::ALL.iter().filter(|method| method.info().order > 0);
    to_the_truth.copied().map(Some).chain([None])
}

/// By a method, or at a fixed rate.
fn by(body: &Body, method: Option<Method>) -> Result<Stepper, Error> {
    method.map_or_else(|| Stepper::fixed_rate(body), |method| Stepper::new(body, method))
}

fn finite(state: &State<f64>) -> bool {
    state.attitude.coords.iter().chain(&state.momentum).all(|x| x.is_finite())
}

/// The turn that a rotation matrix makes.
fn turn_by(frame: &Matrix3<f64>) -> UnitQuaternion<f64> {
    UnitQuaternion::from_rotation_matrix(&nalgebra::Rotation3::from_matrix_unchecked(*frame))
}
