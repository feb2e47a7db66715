//! One drawing of a film.

use super::{Camera, Film, share_in_words};
use crate::draw::{Canvas, Fill, Ink, Label, P, Pen, View, exit, solid};
use crate::picture::ink_of;
use crate::units;
use nalgebra::Vector3;
use std::error::Error;
use std::f64::consts::TAU;
use tumbling::Axis;

/// Width and height of a drawing.
const SHEET: [u32; 2] = [640, 360];
const SQUARE: [u32; 2] = [412, 412];

/// The positions of the body's centre and of the ellipsoid's centre.
const BODY: P = (206.0, 204.0);
const ELLIPSOID: P = (524.0, 190.0);

/// The direction of view, degrees.
const AZIMUTH: f64 = -52.0;
const ELEVATION: f64 = 22.0;

/// Lengths in the drawing: the momentum, the longest spin, the ellipsoid's longest half axis, and the part of
/// the pin outside the body.
const MOMENTUM: f64 = 176.0;
const SPIN: f64 = 150.0;
const HALF_AXIS: f64 = 112.0;
const PIN: f64 = 32.0;

/// How far the body moves in the whole film to either side of its centre, and up and down.
const ROOM: P = (192.0, 118.0);

/// The length of the strongly drawn part of the trace, in turns of the first spin.
const TAIL: f64 = 0.8;

/// The scale and position of the arrow of the spin, for programs that read a drawing.
#[derive(Debug, Clone, Copy)]
pub struct Projection {
    /// The longest spin of the film, rad/s: the longest arrow.
    fastest: f64,
}

impl Projection {
    /// The drawn position of the tip of this spin (rad/s, in the camera's axes, z up).
    #[must_use]
    pub fn tip(&self, omega: &Vector3<f64>) -> [f64; 2] {
        view(BODY, SPIN / self.fastest, AZIMUTH).at(omega).into()
    }
}

fn view(centre: P, scale: f64, azimuth: f64) -> View {
    View::new(centre, scale, azimuth, ELEVATION)
}

impl Film {
    /// How it draws arrows.
    #[must_use]
    pub fn projection(&self) -> Projection {
        Projection { fastest: self.fastest / self.share }
    }

    /// The spin in the camera's axes at this fraction of the film, rad/s, z up.
    ///
    /// # Errors
    /// A share that is not finite.
    pub fn spin_seen(&self, share: f64) -> Result<Vector3<f64>, Box<dyn Error>> {
        let now = self.motion.at(share * self.length.motion)?;
        Ok(self.seen_from(share, &now.attitude) * (now.attitude * now.omega))
    }

    /// The drawing at this fraction of the film: 0 at its start and 1 at its end, where it starts again.
    ///
    /// # Errors
    /// A share that is not finite.
    pub fn frame(&self, share: f64) -> Result<String, Box<dyn Error>> {
        let [wide, high] = self.sheet();
        let canvas = Canvas::sized(wide, high);
        self.body(&canvas, share)?;
        if !self.request.square {
            self.polhode(&canvas, share)?;
        }
        self.words(&canvas, share);
        let title = format!("{} in free motion", self.name);
        Ok(canvas.finish("film", &title, &self.explained()?))
    }

    /// The body with its spin and its momentum.
    fn body(&self, canvas: &Canvas, share: f64) -> Result<(), Box<dyn Error>> {
        let rotation = self.rotation(share)?;
        let arrows = view(BODY, 1.0, AZIMUTH);
        let axis = self.frame.column(self.request.axis as usize).into_owned();
        let (pole, ink) = (rotation * axis, ink_of(self.request.axis));
        let of_body = view(BODY, self.scale, AZIMUTH);
        // A pin along the axis of the spin: it shows the orientation of the body. Its part inside is hidden.
        let along = self.surfaces.iter().flat_map(|s| &s.vertices).map(|p| p.dot(&axis));
        let surface = along.fold(0.0, f64::max) * self.scale;
        let pin = |from: f64| {
            let [from, to] = [from, surface + PIN].map(|along| arrows.at(&(pole * along)));
            canvas.line(from, to, Pen::new(ink, 5.0));
        };
        pin(0.0);
        solid(canvas, &of_body, &self.surfaces, rotation.to_rotation_matrix().matrix(), Some((&axis, ink)));
        let whole: Vec<P> = self.trace(0.0, 1.0, 240)?;
        canvas.path(&whole, Pen::new(Ink::Omega, 1.2).opacity(0.4));
        let tail = TAIL / self.length.film;
        for (part, opacity) in [(0.0, 0.35), (1.0, 0.65), (2.0, 1.0)] {
            let from = share + tail * (part / 3.0 - 1.0);
            canvas.path(&self.trace(from, from + tail / 3.0, 8)?, Pen::new(Ink::Omega, 2.6).opacity(opacity));
        }
        if pole.dot(&arrows.toward()) > 0.0 {
            pin(exit(&self.surfaces, &axis) * self.scale);
        }
        let attitude = self.motion.attitude(share * self.length.motion)?;
        let momentum = self.seen_from(share, &attitude) * self.momentum.normalize();
        canvas.arrow(BODY, arrows.at(&(momentum * MOMENTUM * self.share)), Pen::new(Ink::Momentum, 3.6));
        canvas.arrow(BODY, self.projection().tip(&self.spin_seen(share)?).into(), Pen::new(Ink::Omega, 3.2));
        canvas.disc(BODY, 3.5, Fill::new(Ink::Text), None);
        Ok(())
    }

    /// The scale of the body, such that its whole motion fills its area.
    pub(super) fn fitting(&self) -> Result<f64, Box<dyn Error>> {
        let view = view((0.0, 0.0), 1.0, AZIMUTH);
        let mut most = 0.0_f64;
        for i in 0..120 {
            let rotation = self.rotation(f64::from(i) / 120.0)?;
            for p in self.surfaces.iter().flat_map(|s| &s.vertices) {
                let (x, y) = view.at(&(rotation * p));
                most = most.max(x.abs() / ROOM.0).max(y.abs() / ROOM.1);
            }
        }
        Ok(1.0 / most)
    }

    /// The path of the spin's tip between two fractions of the film.
    fn trace(&self, from: f64, to: f64, steps: u32) -> Result<Vec<P>, Box<dyn Error>> {
        let at = |i: u32| from + (to - from) * f64::from(i) / f64::from(steps);
        (0..=steps).map(|i| Ok(self.projection().tip(&self.spin_seen(at(i))?).into())).collect()
    }

    /// The ellipsoid of equal energy with the path of the spin on it.
    fn polhode(&self, canvas: &Canvas, share: f64) -> Result<(), Box<dyn Error>> {
        let on_it = |share: f64| -> Result<Vector3<f64>, Box<dyn Error>> {
            let omega = self.motion.omega(share * self.length.motion)?;
            Ok(self.frame.tr_mul(&omega) / self.first_reach)
        };
        let (ellipsoid, view) = (&self.ellipsoid, view(ELLIPSOID, HALF_AXIS, 58.0));
        ellipsoid.surface(canvas, &view, Pen::new(Ink::Faint, 1.2));
        let moments = &ellipsoid.moments;
        if moments[0] < moments[1] && moments[1] < moments[2] {
            for sign in [1.0, -1.0] {
                let faint = Some(Pen::new(Ink::Separatrix, 0.8).opacity(0.35));
                let pen = Pen::new(Ink::Separatrix, 1.4);
                ellipsoid.curve(canvas, &view, &ellipsoid.separatrix(sign), pen, faint);
            }
        }
        // The axis that is named: its ends.
        let axis = self.request.axis;
        for sign in [1.0, -1.0] {
            let end = Vector3::ith(axis as usize, sign * ellipsoid.reach[axis as usize]);
            if end.dot(&view.toward()) > 0.0 {
                canvas.disc(view.at(&end), 4.0, Fill::new(ink_of(axis)), None);
            }
        }
        let path: Vec<_> = (0..=240).map(|i| on_it(f64::from(i) / 240.0)).collect::<Result<_, _>>()?;
        let behind = Some(Pen::new(Ink::Omega, 1.2).opacity(0.4));
        ellipsoid.curve(canvas, &view, &path, Pen::new(Ink::Omega, 2.0), behind);
        let here = on_it(share)?;
        let opacity = if moments.component_mul(&here).dot(&view.toward()) > 0.0 { 1.0 } else { 0.4 };
        canvas.disc(view.at(&here), 6.0, Fill::new(Ink::Omega).opacity(opacity), None);
        Ok(())
    }

    fn words(&self, canvas: &Canvas, share: f64) {
        let small = |text: String| Label::new(text).size(15.0);
        let from = match self.length.camera {
            Camera::Room => "seen in the room",
            Camera::Body => "seen from the body",
            Camera::Momentum => "seen turning with it",
        };
        canvas.label((BODY.0 + 28.0, 22.0), &small(from.into()));
        canvas.label((14.0, 22.0), &small("spin $!ω$".into()).ink(Ink::Omega));
        canvas.label((14.0, 42.0), &small("momentum $!L$".into()).ink(Ink::Momentum));
        canvas.label((14.0, 62.0), &small(word(self.request.axis).into()).ink(ink_of(self.request.axis)));
        let mut words: String = self.name.chars().take(36).collect();
        let spun = [share_in_words(self.push), spin_in_words(self.request.spin, self.request.axis)];
        let [right, mut low] = self.sheet().map(|edge| f64::from(edge) - 14.0);
        if self.request.square {
            for line in spun {
                canvas.label((14.0, low), &small(line));
                low -= 22.0;
            }
        } else {
            words = format!("{words}, {}, {}", spun[1], spun[0]);
            canvas.label((right, 22.0), &small("the spin's path in the body".into()).end());
        }
        canvas.label((14.0, low), &small(words));
        // Enough decimals to distinguish two frames.
        let decimals = (1.0 - (self.length.motion / 30.0).log10().floor()).clamp(0.0, 9.0) as usize;
        let time = share * self.length.motion;
        canvas.label((right, low), &small(format!("t = {time:.decimals$} s")).end());
    }

    fn sheet(&self) -> [u32; 2] {
        if self.request.square { SQUARE } else { SHEET }
    }
}

fn word(axis: Axis) -> &'static str {
    match axis {
        Axis::Smallest => "easiest axis",
        Axis::Middle => "middle axis",
        Axis::Largest => "hardest axis",
    }
}

/// As in "1 turn/s about its middle axis".
pub(super) fn spin_in_words(spin: f64, axis: Axis) -> String {
    let turns = units::number(spin / TAU, 4);
    format!("{turns} turn{}/s about its {}", if turns == "1" { "" } else { "s" }, word(axis))
}
