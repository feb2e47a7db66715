//! The spin against time: thrown about each axis, and in Jacobi's functions.

use super::{Kind, NAMES, Subject};
use crate::draw::{Canvas, Label, Pen, Plot};
use crate::picture::{Drawing, ink_of};
use crate::units;
use nalgebra::Vector3;
use std::error::Error;
use std::f64::consts::TAU;
use tumbling::Axis;
use tumbling::exact::FreeMotion;

/// The push about each other axis, as a part of the spin.
const PUSH: f64 = 0.03;
const POINTS: u32 = 2400;

/// The pens of the spin along each axis.
pub(crate) fn pens() -> [Pen; 3] {
    [
        Pen::new(ink_of(Axis::Smallest), 2.2).dash_dotted(),
        Pen::new(ink_of(Axis::Middle), 2.8),
        Pen::new(ink_of(Axis::Largest), 2.2).dashed(),
    ]
}

/// A plot of the spin's components, in parts of the spin, over times up to `end` (s) in a unit.
struct Panel<'a> {
    plot: Plot,
    canvas: &'a Canvas,
    unit: f64,
    end: f64,
}

impl<'a> Panel<'a> {
    fn new(canvas: &'a Canvas, top: f64, end: f64, last: bool, most: f64) -> Self {
        let (unit, name) = units::TIME.of(end);
        let x = 0.0..end / unit;
        let plot = Plot::new(canvas, [52.0, top, 440.0, top + 130.0], x, -most..most);
        let times = units::ticks(end / unit).into_iter();
        let times = times.map(|(t, text)| (t, if last { text } else { String::new() }));
        plot.x_axis(times, &if last { format!("time ({name})") } else { String::new() });
        plot.y_axis([(-1.0, "−1"), (0.0, "0"), (1.0, "1")].map(|(y, text)| (y, text.to_owned())), "");
        Self { plot, canvas, unit, end }
    }

    /// The components of a motion, and their names where they end.
    fn curves(
        &self,
        subject: &Subject<'_>,
        motion: &FreeMotion,
        order: [usize; 3],
    ) -> Result<Vec<Vector3<f64>>, Box<dyn Error>> {
        let time = |k: u32| self.end * f64::from(k) / f64::from(POINTS);
        let run: Result<Vec<Vector3<f64>>, tumbling::Error> =
            (0..=POINTS).map(|k| Ok(motion.omega(time(k))? / subject.spin)).collect();
        let run = run?;
        for i in order {
            self.plot.curve(run.iter().zip(0..).map(|(w, k)| (time(k) / self.unit, w[i])), pens()[i])?;
        }
        let last = run.last().copied().unwrap_or_default();
        for i in order.into_iter().rev() {
            let (x, y) = self.plot.at(self.end / self.unit, last[i].clamp(-1.0, 1.0));
            let places = [0.0, 20.0, -20.0, 40.0, -40.0, 60.0].map(|down| (x + 10.0, y + 5.0 + down));
            self.canvas.label_at_first(&places, &Label::new(format!("$ω_{}$", i + 1)).ink(pens()[i].ink()));
        }
        Ok(run)
    }
}

/// Thrown about each axis with a slip about both others.
pub(crate) fn three(subject: &Subject<'_>) -> Drawing {
    let turn = TAU / subject.spin;
    let end = match subject.kind {
        Kind::Three => 2.6 * subject.flip_time(PUSH)?,
        _ => 8.0 * turn,
    };
    let end = end.clamp(4.0 * turn, 60.0 * turn);
    let canvas = Canvas::sized(500, 640);
    canvas.label((14.0, 22.0), &Label::new(subject.heading()).bold());
    canvas.label((14.0, 46.0), &Label::new("components of the spin in body axes, over the spin"));
    let (written, unit) = units::moments(subject.moments.vector().as_slice());
    let mut said = Vec::new();
    for k in 0..3 {
        let top = 84.0 + 186.0 * k as f64;
        let panel = Panel::new(&canvas, top, end, k == 2, 1.15);
        let mut start = Vector3::repeat(PUSH);
        start[k] = 1.0;
        let run = panel.curves(subject, &subject.motion(&start)?, [(k + 1) % 3, (k + 2) % 3, k])?;
        let which = match subject.kind {
            Kind::Three => format!("the {} moment", NAMES[k]),
            Kind::Round(axis) if axis as usize == k => "the moment that differs".into(),
            Kind::Round(_) => "one of two equal moments".into(),
            Kind::Ball => "one of three equal moments".into(),
        };
        let title = format!("{which}, $I_{}$ = {} {unit}", k + 1, written[k]);
        canvas.label((14.0, top - 12.0), &Label::new(title).ink(pens()[k].ink()).size(15.5));
        let least = run.iter().map(|w| w[k]).fold(1.0, f64::min);
        said.push(format!("about the axis of {which} it falls to {least:.2} of what it was"));
    }
    canvas.described(format!(
        "The spin of {} in body axes over {}, thrown about each principal axis in turn with the same slip of {PUSH} of the spin \
         about both others. The component about the axis of the throw: {}.",
        subject.name(),
        units::TIME.say(end),
        said.join("; ")
    ))
}

/// Two motions: near the largest axis, and near the separatrix.
pub(crate) fn jacobi(subject: &Subject<'_>) -> Drawing {
    subject.flips()?;
    let m = subject.moments.vector();
    let canvas = Canvas::sized(500, 560);
    canvas.label((14.0, 22.0), &Label::new(subject.heading()).bold());
    canvas.label((14.0, 46.0), &Label::new("components of the spin in body axes, over the spin"));
    let panels = [(0.04, "small parameter: a wobble"), (0.9998, "parameter near one: it waits, then flips")];
    for (k, (parameter, words)) in panels.into_iter().enumerate() {
        let top = 96.0 + 236.0 * k as f64;
        // With nothing about the middle axis at the start, this ratio of the others has the parameter.
        let ratio = (parameter * (m.z - m.y) * m.z / ((m.y - m.x) * m.x)).sqrt();
        let motion = subject.motion(&(Vector3::new(ratio, 0.0, 1.0) / ratio.hypot(1.0)))?;
        let period = motion.period()?.ok_or("it does not return")?;
        let most = (0..=64)
            .map(|i| motion.omega(period * f64::from(i) / 64.0).map(|w| w.amax() / subject.spin))
            .try_fold(1.0_f64, |most, w| Ok::<_, tumbling::Error>(most.max(w?)))?;
        canvas.label((14.0, top - 16.0), &Label::new(words).bold().size(15.5));
        Panel::new(&canvas, top, 2.0 * period, true, 1.1 * most).curves(subject, &motion, [0, 1, 2])?;
    }
    canvas.label((14.0, 546.0), &Label::new("$ω_1$ as cn, $ω_2$ as sn, $ω_3$ as dn of Jacobi").size(15.5));
    canvas.described(format!(
        "The three components of the spin of {} against time, two periods each. Above, for the parameter 0.04, the component about \
         the largest axis is nearly constant; below, for 0.9998, the component about the middle axis waits and changes sign quickly.",
        subject.name()
    ))
}
