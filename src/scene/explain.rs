//! What a plan does, in words.

use super::cost::Cost;
use super::plan::{Plan, Way};
use crate::step::{Method, Torque};
use std::fmt::Write as _;

/// A count of instructions in one or two digits, as a reader says it.
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
    /// What was chosen, what was left out and why, how right it is, and what it costs: four lines.
    ///
    /// ```
    /// use nalgebra::Vector3;
    /// use tumbling::scene::{Scene, Times, Toss, Wants};
    /// let ball = Toss::spinning(Vector3::new(0.4, 0.4, 0.4), Vector3::new(1.0, 2.0, 3.0));
    /// let wants = Wants { spin: true, ..Wants::NOTHING };
    /// let scene = Scene::new(vec![ball], vec![], Times::every(0.1, 1.0), wants, 1e-9)?;
    /// let told = scene.plan(0)?.explain();
    /// assert!(told.starts_with("chosen: the spin as it is at the start, for all time\n"), "{told}");
    /// assert!(told.contains("\nleft out: the gyroscopic term"), "{told}");
    /// # Ok::<(), tumbling::Error>(())
    /// ```
    #[must_use]
    pub fn explain(&self) -> String {
        let Cost { once, state } = self.cost();
        let mut text = format!("chosen: {}\nleft out: {}\n", self.chosen(), self.left_out().join("; "));
        let _ = writeln!(text, "accuracy: {}", self.told_accuracy());
        let _ =
            write!(text, "cost: about {} instructions for each state, {} once", about(state), about(once));
        text
    }

    fn equal(&self) -> usize {
        let [a, b, c] = self.body.moments.into();
        usize::from(a == b) + usize::from(b == c) + usize::from(c == a)
    }

    fn chosen(&self) -> String {
        let wants = self.scene.wants;
        let step = |step: Option<f64>| step.map_or_else(String::new, |step| format!("{step:.3e} s"));
        match &self.way {
            Way::Nothing if wants.flips => "the instants of the flips, from the period and the phase".into(),
            Way::Nothing if !self.scene.torques.is_empty() => "nothing".into(),
            Way::Nothing => "what follows from energy and momentum".into(),
            Way::Constant { attitude: None, .. } => "the spin as it is at the start, for all time".into(),
            Way::Constant { .. } => "the body as it lies, for all time".into(),
            Way::Rotation(_) => "one even turn about one axis: a sine and a cosine".into(),
            Way::SymmetricTop(_) if wants.attitude => {
                "two even turns, one after the other: two sines and cosines".into()
            }
            Way::SymmetricTop(_) => "the spin circles the axis evenly: one sine and cosine".into(),
            Way::EllipticSpin(_) => "the spin by Jacobi's functions".into(),
            Way::Elliptic(_) => "spin and attitude by Jacobi's and theta functions".into(),
            Way::Stepper(driven) | Way::Stiff(driven) => {
                let name = driven.method().map_or("", |method| method.info().name);
                let torque = match driven.method() {
                    Some(Method::LinearisedImplicit) => "with the torque inside",
                    _ => "between kicks of the torque",
                };
                format!("{name} {torque}, in steps of up to {}", step(driven.step()))
            }
            Way::Flow(driven) => {
                format!("the exact free motion between kicks, in steps of up to {}", step(driven.step()))
            }
            Way::Controlled(driven) => {
                format!(
                    "Dormand and Prince's pair, {:.1e} allowed to each step",
                    driven.tolerance().unwrap_or_default()
                )
            }
        }
    }

    fn left_out(&self) -> Vec<String> {
        let wants = self.scene.wants;
        let mut out: Vec<&str> = Vec::new();
        match &self.way {
            Way::Nothing => out.push("all motion, since nothing that moves is asked for"),
            Way::Constant { .. } | Way::Rotation(_) => out.push(match self.equal() {
                3 => "the gyroscopic term, since all three moments are equal",
                _ if self.body.omega == nalgebra::Vector3::zeros() => "all motion, since the body is at rest",
                _ => "the gyroscopic term, since the spin is along a principal axis or within the plane of two equal moments",
            }),
            Way::SymmetricTop(_) => out.push("elliptic functions, since two moments are equal"),
            Way::EllipticSpin(_) | Way::Elliptic(_) => {}
            Way::Flow(_) => out.push("small steps, since the torque is weak"),
            Way::Stepper(_) => out.push("control of the error, since a fixed step is enough"),
            Way::Controlled(driven) if driven.stiff => {
                out.push("steps that fast damping does not shorten: dearer to this accuracy, if they reach it at all");
            }
            Way::Controlled(_) => out.push("kicks, whose errors fall with the square of the step alone"),
            Way::Stiff(_) => {
                out.push("explicit steps of controlled error, which fast damping makes short: dearer, or too many to try");
            }
        }
        let moves = !matches!(self.way, Way::Nothing);
        if self.scene.torques.is_empty() || !moves {
            if moves {
                out.push("steps through time, since no torque acts");
            }
        } else {
            let lossless =
                |torque: &Torque<f64>| !matches!(torque, Torque::Damping(_) | Torque::Dissipation(_));
            out.push(if self.scene.torques.iter().all(lossless) {
                "the closed form, since a torque acts"
            } else {
                "the closed form, since damping acts"
            });
        }
        if moves && self.scene.torques.is_empty() && !wants.attitude {
            out.push("the attitude, which is not asked for");
        }
        out.into_iter().map(str::to_owned).collect()
    }

    fn told_accuracy(&self) -> String {
        let asked = self.scene.accuracy;
        match &self.way {
            Way::Stepper(driven) | Way::Flow(driven) | Way::Controlled(driven) | Way::Stiff(driven) => {
                format!(
                    "{asked:.0e} asked; two runs of different steps were {:.0e} apart, and one of {} steps is taken",
                    driven.seen(),
                    driven.steps()
                )
            }
            Way::Nothing if !self.scene.torques.is_empty() => {
                format!("{asked:.0e} asked; nothing is computed")
            }
            _ => format!(
                "{asked:.0e} asked; the closed form is as right as the rounding of the start leaves it"
            ),
        }
    }
}
