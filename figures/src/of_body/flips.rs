//! How a slip grows, and the time between flips.

use super::Subject;
use crate::draw::{Canvas, Fill, Ink, Label, Pen, Plot, Scale};
use crate::picture::{Drawing, power_of_ten};
use crate::units;
use nalgebra::Vector3;

/// The time between flips for pushes from 1e-9 to 1e-1.
pub(crate) fn time(subject: &Subject<'_>) -> Drawing {
    let longest = 1.12 * subject.flip_time(1e-10)?;
    let (unit, name) = units::TIME.of(longest);
    let canvas = Canvas::sized(500, 450);
    canvas.label((14.0, 24.0), &Label::new(subject.heading()).bold());
    let (x, y) = (Scale::log(1e-10..1.0), 0.0..longest / unit);
    let plot = Plot::new(&canvas, [76.0, 78.0, 484.0, 376.0], x, y);
    plot.x_axis((-4..=0).map(|n| (100_f64.powi(n), power_of_ten(2 * n))), "slip, as a part of the spin");
    plot.y_axis(units::ticks(longest / unit), &format!("time between two flips ({name})"));
    let curve: Result<Vec<_>, Box<dyn std::error::Error>> = (0..=200)
        .map(|i| 10_f64.powf(-10.0 + 0.0495 * f64::from(i)))
        .map(|push| Ok((push, subject.flip_time(push)? / unit)))
        .collect();
    plot.curve(curve?, Pen::new(Ink::Text, 2.4))?;
    for n in 1..=9 {
        let push = 10_f64.powi(-n);
        let at = plot.at(push, subject.flip_time(push)? / unit);
        canvas.disc(at, 5.0, Fill::new(Ink::Paper), Some(Pen::new(Ink::Text, 2.0)));
    }
    let decade = 2.0 * 10_f64.ln() / (subject.growth() * subject.spin);
    canvas.label((480.0, 108.0), &Label::new("a slip ten times smaller:").end());
    let label = Label::new(format!("{} longer", units::TIME.say(decade))).end().bold();
    canvas.label((480.0, 130.0), &label);
    canvas.described(format!(
        "Time between two flips of {} spun about its middle axis, {}, against the slip: from {} at a slip of 0.1 to {} at 1e-9, \
         nearly a straight line over a logarithmic axis, {} for each factor of ten.",
        subject.name(),
        units::turning(subject.spin),
        units::TIME.say(subject.flip_time(0.1)?),
        units::TIME.say(subject.flip_time(1e-9)?),
        units::TIME.say(decade)
    ))
}

/// The angle between spin and middle axis after three small pushes, until the first flip is over.
pub(crate) fn growth(subject: &Subject<'_>) -> Drawing {
    let longest = 1.12 * subject.flip_time(1e-6)?;
    let (unit, name) = units::TIME.of(longest);
    let canvas = Canvas::sized(500, 470);
    canvas.label((14.0, 24.0), &Label::new(subject.heading()).bold());
    let (x, y) = (0.0..longest / unit, Scale::log(1e-8..100.0));
    let plot = Plot::new(&canvas, [66.0, 78.0, 484.0, 396.0], x, y);
    plot.x_axis(units::ticks(longest / unit), &format!("time ({name})"));
    let powers = (-3..=0).map(|n| (100_f64.powi(n), power_of_ten(2 * n)));
    plot.y_axis(powers, "angle between the spin and the middle axis (rad)");
    let mut said = Vec::new();
    for exponent in [-2, -4, -6] {
        let push = 10_f64.powi(exponent);
        let whole = subject.flip_time(push)?;
        let motion = subject.motion(&Vector3::new(0.0, push.cos(), push.sin()))?;
        let points: Result<Vec<_>, tumbling::Error> = (0..=600)
            .map(|k| whole * f64::from(k) / 600.0)
            .map(|t| Ok((t / unit, motion.omega(t).map(|w| w.x.hypot(w.z).atan2(w.y.abs()))?)))
            .collect();
        plot.curve(points?.into_iter().map(|(t, angle)| (t, angle.max(1e-8))), Pen::new(Ink::Text, 2.2))?;
        let half = plot.at(0.5 * whole / unit, 3.0);
        let words = Label::new(units::TIME.say(0.5 * whole)).middle();
        canvas.label_at_first(&[0.0, -22.0].map(|down| (half.0, half.1 + down)), &words);
        let start = plot.at(whole / unit, push);
        let power = Label::new(power_of_ten(exponent)).end().size(15.5);
        canvas.label_at_first(&[16.0, 34.0].map(|down| (start.0 - 4.0, start.1 + down)), &power);
        said.push(format!("after {push:.0e} rad it flips at {}", units::TIME.say(0.5 * whole)));
    }
    let fold = 1.0 / (subject.growth() * subject.spin);
    let words = format!("grows e-fold in {}", units::TIME.say(fold));
    canvas.label_at_first(&[(472.0, 384.0), (472.0, 362.0)], &Label::new(words).end().bold());
    canvas.described(format!(
        "{} spun about its middle axis with small slips about the largest. On a logarithmic scale the angle between spin and \
         middle axis grows along a straight line, by a factor of e in {}: {}.",
        subject.name(),
        units::TIME.say(fold),
        said.join("; ")
    ))
}
