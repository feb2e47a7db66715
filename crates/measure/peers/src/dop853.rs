//! DOP853 of the crate `differential-equations`.

use crate::law::{Law, Packed};
use differential_equations::prelude::*;
use differential_equations::solout::Solout;
use std::cell::Cell;
use tumbling_measure::contestant::{About, Contestant, Group, Knob, Setting};
use tumbling_measure::ended::{Ended, Failure};
use tumbling_measure::errors::Watch;
use tumbling_measure::story::Story;

pub struct Dop853;

impl ODE<f64, Packed> for Law {
    fn diff(&self, t: f64, y: &Packed, dydt: &mut Packed) {
        *dydt = self.rate(t, y);
    }
}

/// Shows each step to the watch, and keeps the last alone.
struct Seen<'a, 'b, 'c> {
    law: &'a Law,
    watch: Option<&'b mut Watch<'c>>,
    last: &'a Cell<Packed>,
}

impl Solout<f64, Packed> for Seen<'_, '_, '_> {
    fn solout<I>(
        &mut self,
        t: f64,
        t_before: f64,
        y: &Packed,
        _before: &Packed,
        _between: &mut I,
        _solution: &mut Solution<f64, Packed>,
    ) -> ControlFlag<f64, Packed>
    where
        I: Interpolation<f64, Packed> + ?Sized,
    {
        self.last.set(*y);
        if let Some(watch) = self.watch.as_deref_mut().filter(|_| t > t_before) {
            watch.see(t, &self.law.motion(y));
        }
        ControlFlag::Continue
    }
}

impl Contestant for Dop853 {
    fn about(&self) -> About {
        About {
            name: "DOP853 (differential-equations)",
            group: Group::Peer,
            order: 8,
            knob: Knob::Tolerance,
            free_only: false,
        }
    }

    fn run(
        &self,
        story: &Story,
        setting: Setting,
        mut watch: Option<&mut Watch<'_>>,
    ) -> Result<Ended, Failure> {
        let Setting::Tolerance(tolerance) = setting else {
            return Err(Failure::Refused("it is set by a tolerance".into()));
        };
        let (whole, start) = Law::of(story);
        let (last, mut steps, mut evaluations) = (Cell::new(start), 0, 0);
        for (law, begin, end) in whole.phases(story) {
            let method = ExplicitRungeKutta::dop853().rtol(tolerance).atol(tolerance).max_steps(10_000_000);
            let solution = IVP::ode(&law, begin, end, last.get())
                .method(method)
                .solout(Seen { law: &law, watch: watch.as_deref_mut(), last: &last })
                .solve()
                .map_err(|e| Failure::Refused(format!("{e:?}")))?;
            steps += solution.steps.accepted as u64;
            evaluations += solution.evals.function as u64;
        }
        let motion = whole.motion(&last.get());
        Ok(Ended { motion, steps, evaluations: Some(evaluations), seconds: None })
    }
}
