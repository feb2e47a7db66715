//! What a plan does, in words.

use crate::cost::Cost;
use crate::plan::Plan;
use crate::plan::{Driven, Strategy};
use crate::torques::is_damping;
use std::fmt::Write as _;

/// A count of instructions in two digits.
#[expect(clippy::disallowed_methods, reason = "a plan in words rounds its numbers")]
fn about(x: f64) -> String {
    if x < 1.0 {
        return "none".to_owned();
    }
    let power = x.log10().floor().min(300.0);
    let unit = 10_f64.powf(power - 1.0).max(1.0);
    let rounded = (x / unit).round() * unit;
    if rounded < 1e6 { format!("{rounded:.0}") } else { format!("{rounded:.1e}") }
}

impl Plan<'_> {
    /// What was chosen, what was left out and why, how accurate it is, and what it costs: four lines.
    ///
    /// ```
    /// use nalgebra::Vector3;
    /// use tumbling_scenes::{InitialState, Outputs, Scene, Times};
    /// let ball = InitialState::spinning(Vector3::new(0.4, 0.4, 0.4), Vector3::new(1.0, 2.0, 3.0));
    /// let outputs = Outputs { spin: true, ..Outputs::NOTHING };
    /// let scene = Scene::new([ball], vec![], Times::every(0.1, 1.0), outputs, 1e-9)?;
    /// let text = scene.plan(0)?.explain();
    /// assert!(text.starts_with("chosen: the spin as it is at the start, for all time\n"), "{text}");
    /// assert!(text.contains("\nleft out: the gyroscopic term"), "{text}");
    /// # Ok::<(), tumbling_scenes::Error>(())
    /// ```
    #[must_use]
    pub fn explain(&self) -> String {
        let Cost { once, state } = self.cost();
        let mut text = format!("chosen: {}\nleft out: {}\n", self.chosen(), self.left_out().join("; "));
        let _ = writeln!(text, "accuracy: {}", self.accuracy_line());
        let _ =
            write!(text, "cost: about {} instructions for each state, {} once", about(state), about(once));
        text
    }

    fn equal(&self) -> usize {
        let [a, b, c] = self.start.moments.into();
        usize::from(a == b) + usize::from(b == c) + usize::from(c == a)
    }

    fn chosen(&self) -> String {
        let outputs = self.scene.outputs();
        if let Some(driven) = &self.driven {
            let stiff =
                if driven.stiff { ", collocation where damping is much faster than the motion" } else { "" };
            return format!("Taylor series, {:.1e} allowed to each step{stiff}", driven.tolerance);
        }
        match self.strategy {
            Strategy::Nothing if outputs.flips => "the instants of the flips, from the period and the phase",
            Strategy::Nothing if !self.scene.torques().is_empty() => "nothing",
            Strategy::Nothing => "what follows from energy and momentum",
            Strategy::Constant if outputs.attitude => "the body as it lies, for all time",
            Strategy::Constant => "the spin as it is at the start, for all time",
            Strategy::Rotation => "one even turn about one axis: a sine and a cosine",
            Strategy::SymmetricTop if outputs.attitude => {
                "two even turns, one after the other: two sines and cosines"
            }
            Strategy::SymmetricTop => "the spin circles the axis evenly: one sine and cosine",
            Strategy::EllipticSpin => "the spin by Jacobi's functions",
            Strategy::Elliptic | Strategy::Adaptive => "spin and attitude by Jacobi's and theta functions",
        }
        .to_owned()
    }

    fn left_out(&self) -> Vec<&str> {
        let (moves, free) = (self.strategy != Strategy::Nothing, self.scene.torques().is_empty());
        let mut out = Vec::new();
        match self.strategy {
            Strategy::Nothing => out.push("all motion, since nothing that moves is requested"),
            Strategy::Constant | Strategy::Rotation => out.push(match self.equal() {
                3 => "the gyroscopic term, since all three moments are equal",
                _ if self.start.omega == nalgebra::Vector3::zeros() => "all motion, since the body is at rest",
                _ => "the gyroscopic term, since the spin is along a principal axis or within the plane of two equal moments",
            }),
            Strategy::SymmetricTop => out.push("elliptic functions, since two moments are equal"),
            Strategy::EllipticSpin | Strategy::Elliptic | Strategy::Adaptive => {}
        }
        if !free {
            out.push(if self.scene.torques().iter().any(is_damping) {
                "the closed form, since damping acts"
            } else {
                "the closed form, since a torque acts"
            });
        } else if moves {
            out.push("steps through time, since no torque acts");
            if !self.scene.outputs().attitude {
                out.push("the attitude, which is not requested");
            }
        }
        out
    }

    fn accuracy_line(&self) -> String {
        let requested = self.scene.accuracy();
        let how = match &self.driven {
            Some(Driven { difference, steps, .. }) => {
                format!("trial runs were at most {difference:.0e} apart, and one of {steps} steps is taken")
            }
            None if !self.scene.torques().is_empty() => "nothing is computed".to_owned(),
            None => "the closed form is as accurate as the rounding of the start permits".to_owned(),
        };
        format!("{requested:.0e} requested; {how}")
    }
}
