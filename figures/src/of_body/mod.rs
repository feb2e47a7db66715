//! Figures of any body: units, ticks and the places of labels follow from its numbers.

pub(crate) mod arrows;
pub(crate) mod flips;
pub(crate) mod gaps;
pub(crate) mod moments;
pub(crate) mod polhodes;
pub(crate) mod spins;
pub(crate) mod tosses;

use crate::draw::{P, polar};
use crate::units;
use nalgebra::{Matrix3, Vector3};
use std::error::Error;
use std::f64::consts::TAU;
use tumbling::exact::{FreeMotion, time_between_flips};
use tumbling::{Axis, Inertia, PrincipalMoments};
use tumbling_bodies::BodyModel;

/// Which of the three moments are equal, to 1e-12 of the largest.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Kind {
    /// None.
    Three,
    /// The two moments about the axes other than this one.
    Round(Axis),
    /// All.
    Ball,
}

/// A body, prepared for its figures: in its principal axes.
#[derive(Debug, Clone)]
pub(crate) struct Subject<'a> {
    pub(crate) model: &'a BodyModel,
    /// Smallest first, kg m²; moments that are equal to rounding are made equal.
    pub(crate) moments: PrincipalMoments,
    /// Principal axes to body axes.
    pub(crate) frame: Matrix3<f64>,
    pub(crate) kind: Kind,
    /// The spin of its motions, rad/s.
    pub(crate) spin: f64,
}

/// The names of the axes, smallest moment first.
pub(crate) const NAMES: [&str; 3] = ["smallest", "middle", "largest"];

/// Places for the middle of a label beyond the tip of an arrow from `centre`, the straight continuation
/// first.
pub(crate) fn beyond(centre: P, tip: P) -> [P; 5] {
    let (x, y) = (tip.0 - centre.0, tip.1 - centre.1);
    let length = x.hypot(y);
    // An arrow straight to the viewer points nowhere.
    let angle = if length > 1.0 { (-y).atan2(x) } else { 0.8 };
    [0.0, 0.7, -0.7, 1.4, -1.4].map(|aside| {
        let (x, y) = polar(tip, 15.0, angle + aside);
        (x, y + 6.0)
    })
}

impl<'a> Subject<'a> {
    pub(crate) fn new(model: &'a BodyModel) -> Result<Self, Box<dyn Error>> {
        let principal = model.principal();
        let mut m = principal.moments();
        let near = |a: f64, b: f64| (a - b).abs() <= 1e-12 * m.z;
        let kind = match (near(m.x, m.y), near(m.y, m.z)) {
            (true, true) => Kind::Ball,
            (true, false) => Kind::Round(Axis::Largest),
            (false, true) => Kind::Round(Axis::Smallest),
            (false, false) => Kind::Three,
        };
        match kind {
            Kind::Ball => m.fill(m.y),
            Kind::Round(Axis::Largest) => m.x = m.y,
            Kind::Round(_) => m.z = m.y,
            Kind::Three => {}
        }
        let by_size = match model.reach() {
            _ if !model.has_size() => TAU,
            ..=3.0 => TAU,
            3.0..=100.0 => TAU / 60.0,
            _ => TAU / 10_800.0,
        };
        let spin = model.spin.unwrap_or(by_size);
        Ok(Self { model, moments: m.try_into()?, frame: principal.frame(), kind, spin })
    }

    /// Its name, short enough for a line.
    pub(crate) fn name(&self) -> String {
        let name = &self.model.name;
        if name.chars().count() <= 22 { name.clone() } else { name.chars().take(21).chain(['…']).collect() }
    }

    /// Its name, spin and what sort of line: `the phone, one turn a second`.
    pub(crate) fn heading(&self) -> String {
        format!("{}, {}", self.name(), units::turning(self.spin))
    }

    /// The tensor in its principal axes.
    pub(crate) fn inertia(&self) -> Result<Inertia, tumbling::Error> {
        let [a, b, c] = self.moments.vector().into();
        Inertia::from_moments(a, b, c)
    }

    /// The motion with a spin along the principal axes, in units of [`spin`](Self::spin).
    pub(crate) fn motion(&self, parts: &Vector3<f64>) -> Result<FreeMotion, tumbling::Error> {
        FreeMotion::new(self.moments, &(parts * self.spin))
    }

    /// The growth rate of a slip off the middle axis, relative to the spin in rad/s.
    pub(crate) fn growth(&self) -> f64 {
        let [a, b, c] = self.moments.vector().into();
        tumbling::dynamics::stability::rate_squared(&1.0, &b, &a, &c).max(0.0).sqrt()
    }

    /// The time between flips of a spin about the middle axis, after a slip about the largest axis that is
    /// given as a fraction of the spin.
    pub(crate) fn flip_time(&self, push: f64) -> Result<f64, Box<dyn Error>> {
        self.flips()?;
        let omega = Vector3::new(0.0, 1.0, push) * self.spin;
        Ok(time_between_flips(self.moments, &omega)?.ok_or("it does not flip")?)
    }

    /// Checks that it flips at all.
    pub(crate) fn flips(&self) -> Result<(), Box<dyn Error>> {
        let equal = match self.kind {
            Kind::Three => return Ok(()),
            Kind::Round(_) => "two of its three principal moments are equal",
            Kind::Ball => "its three principal moments are equal",
        };
        Err(format!("{} never flips ({equal}), and this figure shows flips", self.model.name).into())
    }

    /// Its sizes and mass in words: `77 mm × 7.8 mm × 160 mm, 200 g`.
    pub(crate) fn sizes(&self) -> String {
        let sides = self.model.sides.map(|sides| sides.map(|x| units::LENGTH.say(x)).join(" × "));
        let reach =
            || format!("{} from its centre to its farthest point", units::LENGTH.say(self.model.reach()));
        let size = sides.or_else(|| (!self.model.surfaces.is_empty()).then(reach));
        let mass = self.model.mass.map(|x| units::MASS.say(x));
        let known: Vec<String> = size.into_iter().chain(mass).collect();
        if known.is_empty() { "mass and size not given".into() } else { known.join(", ") }
    }
}
