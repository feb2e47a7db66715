//! Every free motion of the box on one sheet: level lines in a triangle, and the time that each takes to
//! flip.

use super::{Drawing, Picture, document_box, in_principal_axes, ink_of};
use crate::draw::{Canvas, Fill, Label, P, Pen, Plot, Scale};
use crate::ink::Ink;
use nalgebra::Vector3;
use std::error::Error;
use std::f64::consts::TAU;
use tumbling::Axis;
use tumbling::exact::{FreeMotion, Regime};

/// The triangle of all directions of the momentum, for momentum 1.
struct Map {
    moments: Vector3<f64>,
}

impl Map {
    /// `2 E I2 / L²` for a body that turns about this axis alone.
    fn corner(&self, axis: Axis) -> f64 {
        self.moments[1] / self.moments[axis as usize]
    }

    /// The motion at this level, started at a flip: no momentum along the middle axis.
    fn motion(&self, level: f64) -> Result<FreeMotion, Box<dyn Error>> {
        let [low, high] = [Axis::Largest, Axis::Smallest].map(|axis| self.corner(axis));
        let share = (level - low) / (high - low);
        let momentum = Vector3::new(share.sqrt(), 0.0, (1.0 - share).sqrt());
        Ok(FreeMotion::new(self.moments.try_into()?, &momentum.component_div(&self.moments))?)
    }

    /// Which axis the motion at this level circles, and the time between its flips in turns: in the times
    /// that the same momentum takes to turn the body once about its middle axis.
    fn flip(&self, level: f64) -> Result<(Axis, f64), Box<dyn Error>> {
        let motion = self.motion(level)?;
        let Regime::Elliptic { about, .. } = motion.regime() else {
            return Err("a level with no period".into());
        };
        let half = 0.5 * motion.period()?.ok_or("no period")?;
        Ok((about, half / (TAU * self.moments[1])))
    }

    /// The level on this axis' side at which a flip comes after this number of turns.
    fn level(&self, axis: Axis, turns: f64) -> Result<f64, Box<dyn Error>> {
        // Steps of the logarithm: near the separatrix the time changes with that.
        let (mut near, mut far) = (-30.0, (self.corner(axis) - 1.0).abs().ln());
        for _ in 0..60 {
            let middle = 0.5 * (near + far);
            if self.flip(self.beside(axis, middle.exp()))?.1 > turns { near = middle } else { far = middle }
        }
        Ok(self.beside(axis, near.exp()))
    }

    fn beside(&self, axis: Axis, distance: f64) -> f64 {
        if axis == Axis::Smallest { 1.0 + distance } else { 1.0 - distance }
    }

    /// The greatest share of the middle axis on this level: where the line meets the triangle's slanted side.
    fn reach(&self, level: f64) -> f64 {
        let axis = if level > 1.0 { Axis::Smallest } else { Axis::Largest };
        1.0 - (level - 1.0) / (self.corner(axis) - 1.0)
    }
}

const SIDES: [Axis; 2] = [Axis::Smallest, Axis::Largest];
const MOST_TURNS: f64 = 4.0;

pub(super) fn draw() -> Drawing {
    let moments = in_principal_axes(&document_box()?)?.principal().moments();
    let map = Map { moments };
    let canvas = Canvas::new(560);
    let range = || Scale::linear(0.67..2.05);
    let left = Plot::new(&canvas, 62.0, 58.0, 352.0, 484.0, Scale::linear(0.0..1.0), range());
    let right = Plot::new(&canvas, 392.0, 58.0, 655.0, 484.0, Scale::linear(0.0..MOST_TURNS), range());
    let heights = || [0.8, 1.0, 1.2, 1.4, 1.6, 1.8, 2.0].into_iter();
    left.x_axis([0.0, 0.5, 1.0].map(|x| (x, format!("{x}"))), "share of $L_2^{ 2}$ in $L^2$");
    left.y_axis(heights().map(|y| (y, format!("{y:.1}"))), "energy, as $2E I_2/L^2$");
    right.x_axis((0..=4).map(|n| (f64::from(n), n.to_string())), "time between flips (turns at $L/I_2$)");
    right.y_axis(heights().map(|y| (y, String::new())), "");

    let middle = left.at(1.0, 1.0);
    let mut said = Vec::new();
    for axis in SIDES {
        let corner = left.at(0.0, map.corner(axis));
        let area = [corner, middle, left.at(0.0, 1.0)];
        canvas.area(&area, Fill::new(ink_of(axis)).opacity(0.14), Some(Pen::new(ink_of(axis), 1.6)));
    }
    for axis in SIDES {
        said.push(side(&canvas, &map, axis, &left, &right)?);
    }
    canvas.line(left.at(0.0, 1.0), middle, Pen::new(Ink::Separatrix, 3.2));
    canvas.line(right.at(0.0, 1.0), right.at(MOST_TURNS, 1.0), Pen::new(Ink::Separatrix, 1.6).dashed());
    names(&canvas, &map, &left, &right);
    let [(_, slow_min, three_min), (_, slow_max, three_max)] = [said[0], said[1]];
    Ok(Picture {
        canvas,
        description: format!(
            "Free motions of the box. Left, a triangle of all directions of the momentum: across, the share of the middle \
             axis in the squared momentum; up, the energy as 2 E I2 / L². A motion runs to and fro on a level line. The \
             corners are steady spins: {:.2} about the smallest axis, 1 about the middle, {:.2} about the largest. The \
             separatrix, level 1, parts motions that circle the smallest axis, above, from those that circle the \
             largest. Right, the time between flips, in turns about the middle axis at the same momentum: {:.2} at \
             the top corner, {:.2} at the bottom one, without bound towards the separatrix; three turns at \
             levels {:.4} and {:.4}.",
            map.corner(Axis::Smallest),
            map.corner(Axis::Largest),
            slow_min,
            slow_max,
            three_min,
            three_max
        ),
    })
}

/// The motions that circle this axis: the axis, the least time between flips, and the level at which that
/// time is three turns.
fn side(
    canvas: &Canvas,
    map: &Map,
    axis: Axis,
    left: &Plot,
    right: &Plot,
) -> Result<(Axis, f64, f64), Box<dyn Error>> {
    // Lines of equal time, on into the picture at the right.
    let least = map.flip(map.beside(axis, (map.corner(axis) - 1.0).abs() * (1.0 - 1e-9)))?.1;
    for turns in [0.6, 0.8, 1.0, 1.5, 2.0, 3.0].into_iter().filter(|turns| *turns > least) {
        let level = map.level(axis, turns)?;
        let [start, end] = [0.0, map.reach(level)].map(|share| left.at(share, level));
        canvas.line(start, end, Pen::new(ink_of(axis), 1.4));
        let met = right.at(turns, level);
        canvas.line(end, met, Pen::new(ink_of(axis), 1.0).opacity(0.45));
        canvas.disc(met, 4.0, Fill::new(ink_of(axis)), None);
        if turns < 1.2 {
            let unit = if turns < 0.7 { " turns" } else { "" };
            let (dx, dy) = if axis == Axis::Smallest { (7.0, -5.0) } else { (30.0, 17.0) };
            let label = Label::new(format!("{turns:.1}{unit}")).ink(ink_of(axis)).size(15.5);
            canvas.label((end.0 + dx, end.1 + dy), &label);
        }
    }
    let curve = (0..=240).map(|i| {
        let share = f64::from(i) / 240.0;
        let depth = (map.corner(axis) - 1.0).abs() * 10_f64.powf(-7.0 * share) * (1.0 - 1e-9);
        let level = map.beside(axis, depth);
        map.flip(level).map(|(about, turns)| (about, (turns, level)))
    });
    let curve = curve.collect::<Result<Vec<_>, _>>()?;
    if curve.iter().any(|(about, _)| *about != axis) {
        return Err("a motion on the wrong side of the separatrix".into());
    }
    let points = curve.into_iter().map(|(_, point)| point).filter(|p| p.0 <= MOST_TURNS);
    right.curve(points, Pen::new(ink_of(axis), 2.6))?;
    Ok((axis, least, map.level(axis, 3.0)?))
}

fn names(canvas: &Canvas, map: &Map, left: &Plot, right: &Plot) {
    let write = |at: P, lines: &[&str], ink: Ink| {
        for (line, down) in lines.iter().zip([0.0, 20.0, 40.0]) {
            canvas.label((at.0, at.1 + down), &Label::new(*line).ink(ink).size(16.0));
        }
    };
    for axis in [Axis::Smallest, Axis::Middle, Axis::Largest] {
        let across = if axis == Axis::Middle { 1.0 } else { 0.0 };
        canvas.disc(left.at(across, map.corner(axis)), 5.5, Fill::new(ink_of(axis)), None);
    }
    let p = left.at(0.0, map.corner(Axis::Smallest));
    write((p.0 + 14.0, p.1 - 1.0), &["steady about the smallest"], Ink::AxisMin);
    let p = left.at(0.0, map.corner(Axis::Largest));
    write((p.0 + 14.0, p.1 + 25.0), &["steady about the largest"], Ink::AxisMax);
    write(left.at(0.76, 0.888), &["steady about", "the middle"], Ink::AxisMid);
    write(left.at(0.42, 1.84), &["to and fro on a", "level line; flips", "at the left edge"], Ink::Text);
    // One motion, between its flip and its turning point.
    let level = 1.36;
    let ends = [0.02, map.reach(level) - 0.02].map(|share| left.at(share, level));
    canvas.arrow(ends[0], ends[1], Pen::new(Ink::Text, 1.6));
    canvas.arrow(ends[1], ends[0], Pen::new(Ink::Text, 1.6));
    let p = left.at(0.05, level);
    write((p.0, p.1 - 11.0), &["one motion"], Ink::Text);
    write(right.at(2.35, 1.13), &["separatrix:", "only one flip"], Ink::Separatrix);
    let p = right.at(0.75, 1.72);
    write(p, &["circling the", "smallest axis"], Ink::AxisMin);
    write(right.at(1.3, 0.86), &["circling the", "largest axis"], Ink::AxisMax);
}
