//! DOP853 of the crate `differential-equations`.

use crate::equations::{Equations, Packed};
use differential_equations::prelude::*;
use differential_equations::solout::Solout;
use std::cell::Cell;
use tumbling_measure::contestant::{About, Contestant, Group, Knob, Setting};
use tumbling_measure::errors::{Ended, Observed, Observer, Outcome};
use tumbling_measure::story::Story;

pub struct Dop853;

impl ODE<f64, Packed> for Equations {
    fn diff(&self, t: f64, y: &Packed, dydt: &mut Packed) {
        *dydt = self.rate(t, y);
    }
}

/// Shows each step to the observer, and keeps the last alone.
struct Seen<'a, 'b, 'c> {
    law: &'a Equations,
    observer: Option<&'b mut Observer<'c>>,
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
        if let Some(observer) = self.observer.as_deref_mut().filter(|_| t > t_before) {
            observer.observe(t, &self.law.motion(y));
        }
        ControlFlag::Continue
    }
}

impl Contestant for Dop853 {
    fn about(&self) -> About {
        About { name: "DOP853 (differential-equations)", group: Group::Peer, knob: Knob::Tolerance }
    }

    fn run(&self, story: &Story, setting: Setting, mut observer: Observed<'_, '_>) -> Result<Ended, Outcome> {
        let tolerance = setting.tolerance()?;
        let (whole, start) = Equations::of(story);
        let (last, mut steps) = (Cell::new(start), 0);
        for (law, begin, end) in whole.phases(story) {
            let method = ExplicitRungeKutta::dop853().rtol(tolerance).atol(tolerance).max_steps(10_000_000);
            let solution = IVP::ode(&law, begin, end, last.get())
                .method(method)
                .solout(Seen { law: &law, observer: observer.as_deref_mut(), last: &last })
                .solve()
                .map_err(|e| Outcome::Refused(format!("{e:?}")))?;
            steps += solution.steps.accepted as u64;
        }
        let motion = whole.motion(&last.get());
        Ok(Ended { motion, steps, seconds: None })
    }
}
