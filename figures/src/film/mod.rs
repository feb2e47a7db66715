//! Films of a free body: the exact motion, drawn at any instant.

mod frame;
mod length;

pub use frame::Projection;

use crate::figures::polhode::Ellipsoid;
use crate::units;
use length::Length;
use nalgebra::{Matrix3, Rotation3, UnitQuaternion, Vector3};
use std::error::Error;
use std::f64::consts::{PI, TAU};
use tumbling::exact::FreeMotion;
use tumbling::{Axis, Body};
use tumbling_bodies::{BodyModel, Surface};

/// The frame of reference of the camera.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Camera {
    /// At rest in the room.
    Room,
    /// Fixed to the body.
    Body,
    /// Turning steadily about the momentum, by the angle that is missing for the film to close.
    Momentum,
}

/// The request for a film.
#[derive(Debug, Clone, Copy)]
pub struct Request {
    /// The axis of the spin.
    pub axis: Axis,
    /// The spin about it, rad/s.
    pub spin: f64,
    /// The spin across it, as a fraction of the spin about it: along the axis with the largest moment, or
    /// along the smallest if the body spins about the largest. `None` lets the film choose.
    pub push: Option<f64>,
    /// The duration of the film, s. `None` lets it end where the motion starts again.
    pub seconds: Option<f64>,
    /// `None` lets the film choose.
    pub camera: Option<Camera>,
    /// A square with the body alone; otherwise as wide as a slide, with the path of the spin in the body.
    pub square: bool,
}

impl Default for Request {
    /// A turn a second about the middle axis.
    fn default() -> Self {
        Self { axis: Axis::Middle, spin: TAU, push: None, seconds: None, camera: None, square: false }
    }
}

/// A film of a free body, ready to be drawn.
#[derive(Debug)]
pub struct Film {
    name: String,
    request: Request,
    push: f64,
    motion: FreeMotion,
    momentum: Vector3<f64>,
    surfaces: Vec<Surface>,
    /// The scale of the body, points per metre.
    scale: f64,
    /// The relative length of the arrows: in a film from the body they swing down to the words.
    share: f64,
    length: Length,
    /// Principal axes as columns, in the body's.
    frame: Matrix3<f64>,
    ellipsoid: Ellipsoid,
    /// The longest spin of the film, rad/s, and the length of the ellipsoid's first half axis, rad/s.
    fastest: f64,
    first_reach: f64,
}

impl Film {
    /// Computes the motion and how long the film is.
    ///
    /// # Errors
    /// A spin of zero, a spin, a push or a length out of range, or a motion that the library refuses.
    pub fn new(model: &BodyModel, request: &Request) -> Result<Self, Box<dyn Error>> {
        if request.spin == 0.0 {
            return Err("a spin of 0 rad/s: nothing would move".into());
        }
        if !(1e-12..=1e12).contains(&request.spin.abs()) {
            return Err(format!("a spin of {:e} rad/s: films go from 1e-12 to 1e12", request.spin).into());
        }
        if let Some(push) = request.push.filter(|push| !(-100.0..=100.0).contains(push)) {
            return Err(format!("a push of {push:e}: a share of the spin, from -100 to 100").into());
        }
        if let Some(seconds) = request.seconds.filter(|s| !(0.1..=600.0).contains(s)) {
            return Err(format!("{seconds} seconds: a film takes from 0.1 to 600").into());
        }
        let (push, length) = length::choose(model, request)?;
        let body = thrown(model, request, push)?;
        let motion = FreeMotion::of(&body)?;
        let (omega, momentum) = (body.omega_body(), body.momentum_world());
        let moments = model.principal().moments();
        let fastest = (0..=400).try_fold(0.0, |most: f64, i| {
            Ok::<_, Box<dyn Error>>(most.max(motion.omega(length.motion * f64::from(i) / 400.0)?.norm()))
        })?;
        let energy = omega.dot(&model.inertia.momentum(&omega));
        let surfaces = model.drawn();
        let mut film = Self {
            name: model.name.clone(),
            request: *request,
            push,
            motion,
            momentum,
            scale: 1.0,
            share: if length.camera == Camera::Body { 0.74 } else { 1.0 },
            surfaces,
            length,
            frame: model.principal().frame(),
            ellipsoid: Ellipsoid::new((moments / moments[0]).into())?,
            fastest,
            first_reach: (energy / moments[0]).sqrt(),
        };
        film.scale = film.fitting()?;
        Ok(film)
    }

    /// The playing time, s: a turn of the first spin takes a second.
    #[must_use]
    pub fn seconds(&self) -> f64 {
        self.length.film
    }

    /// The duration of the motion that it shows, s.
    #[must_use]
    pub fn shows(&self) -> f64 {
        self.length.motion
    }

    /// The camera that was requested or chosen.
    #[must_use]
    pub fn camera(&self) -> Camera {
        self.length.camera
    }

    /// The exact motion that it shows; its first attitude has the momentum upwards.
    #[must_use]
    pub fn motion(&self) -> &FreeMotion {
        &self.motion
    }

    /// One line on what is shown, how long, and whether the end equals the start.
    ///
    /// # Errors
    /// None for a film that was made.
    pub fn explained(&self) -> Result<String, Box<dyn Error>> {
        let apart = self.rotation(0.0)?.angle_to(&self.rotation(1.0)?);
        let [first, last] = [0.0, 1.0].map(|share| self.motion.omega(share * self.length.motion));
        let seamless = apart < 2e-3 && (last? - first?).norm() < 2e-3 * self.fastest;
        let end = if seamless { "it starts again without a seam" } else { "it does not close" };
        let spin = frame::spin_in_words(self.request.spin, self.request.axis);
        let (push, why) = (share_in_words(self.push), &self.length.why);
        Ok(format!("{}: {spin}, {push}; {why}; {end}", self.name))
    }

    /// The body's attitude in the camera's axes, at this fraction of the film.
    fn rotation(&self, share: f64) -> Result<UnitQuaternion<f64>, Box<dyn Error>> {
        let attitude = self.motion.attitude(share * self.length.motion)?;
        Ok(self.seen_from(share, &attitude) * attitude)
    }

    /// The rotation from the world to the camera's axes.
    fn seen_from(&self, share: f64, attitude: &UnitQuaternion<f64>) -> UnitQuaternion<f64> {
        match self.length.camera {
            Camera::Room => UnitQuaternion::identity(),
            Camera::Momentum => {
                UnitQuaternion::from_axis_angle(&Vector3::z_axis(), -self.length.missing * share)
            }
            // Seen along the same direction as at the start, when the spin's axis points upwards.
            Camera::Body => {
                upwards(&self.frame.column(self.request.axis as usize).into()) * attitude.inverse()
            }
        }
    }
}

/// The shortest rotation of this vector to the world's z.
fn upwards(v: &Vector3<f64>) -> UnitQuaternion<f64> {
    let half_turn = UnitQuaternion::from_axis_angle(&Vector3::x_axis(), PI);
    Rotation3::rotation_between(v, &Vector3::z()).map_or(half_turn, |turn| turn.into())
}

/// The body at the start: its momentum points upwards.
fn thrown(model: &BodyModel, request: &Request, push: f64) -> Result<Body, Box<dyn Error>> {
    let principal = model.principal();
    let across = if request.axis == Axis::Largest { Axis::Smallest } else { Axis::Largest };
    let omega = (principal.axis(request.axis) + push * principal.axis(across)) * request.spin;
    Ok(Body::spinning(model.inertia, upwards(&model.inertia.momentum(&omega)), &omega)?)
}

/// The slip as a share of the spin, in percent.
fn share_in_words(share: f64) -> String {
    format!("a slip of {} %", units::number(100.0 * share, 3))
}
