//! Tsitouras's pair of orders 5 and 4 of the crate `diffsol`.

use crate::equations::Equations;
use diffsol::{NalgebraMat, OdeBuilder, OdeSolverMethod, OdeSolverStopReason};
use tumbling_measure::contestant::{About, Contestant, Group, Knob, Setting};
use tumbling_measure::errors::{Ended, Observed, Outcome};
use tumbling_measure::story::Story;

pub struct Tsit45;

impl Contestant for Tsit45 {
    fn about(&self) -> About {
        About { name: "Tsit45 (diffsol)", group: Group::Peer, knob: Knob::Tolerance }
    }

    fn run(&self, story: &Story, setting: Setting, observer: Observed<'_, '_>) -> Result<Ended, Outcome> {
        let tolerance = setting.tolerance()?;
        solve(story, tolerance, observer).map_err(|e| Outcome::Refused(e.to_string()))
    }
}

fn solve(
    story: &Story,
    tolerance: f64,
    mut observer: Observed<'_, '_>,
) -> Result<Ended, diffsol::error::DiffsolError> {
    let (whole, mut state) = Equations::of(story);
    let mut steps = 0;
    for (law, begin, end) in whole.phases(story) {
        let start = state;
        let rate = |y: &[f64], _p: &[f64], t: f64, dy: &mut [f64]| {
            let mut state = start;
            state.copy_from_slice(y);
            dy.copy_from_slice(&law.rate(t, &state));
        };
        let problem = OdeBuilder::<NalgebraMat<f64>>::new()
            .rtol(tolerance)
            .atol([tolerance])
            .t0(begin)
            .rhs(rate)
            .init(move |_p: &[f64], _t: f64, y: &mut [f64]| y.copy_from_slice(&start), start.len())
            .build()?;
        let mut solver = problem.tsit45()?;
        solver.set_stop_time(end)?;
        loop {
            let reason = solver.step()?;
            steps += 1;
            if let Some(observer) = observer.as_deref_mut() {
                let state = solver.state();
                observer.observe(state.t, &law.motion(state.y.batch_as_slice(0)));
            }
            if matches!(reason, OdeSolverStopReason::TstopReached) {
                break;
            }
        }
        state.copy_from_slice(solver.state().y.batch_as_slice(0));
    }
    let motion = whole.motion(&state);
    Ok(Ended { motion, steps, seconds: None })
}
