//! What an engine is, in one setting, and how it steps: its rule, and the limits that it adds to it; and the
//! catalogue, each row in full, with where it is known from.

use crate::Error;
use nalgebra::{Quaternion, Vector3};
use std::f64::consts::FRAC_PI_4;
use tumbling::attitude;
use tumbling::step::{Method, State, System};

/// A physics engine, in one setting: what it does to a body that touches nothing.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PhysicsEngine {
    /// Its name.
    pub name: &'static str,
    /// The version recorded; none where the rule is known from the engine's source or documentation alone.
    pub version: Option<&'static str>,
    /// The setting, and whether it is the default.
    pub setting: &'static str,
    /// Its rule.
    pub method: Method,
    /// Into how many equal parts it cuts a step.
    pub parts: u32,
    /// What it adds to the rule.
    pub limits: Limits,
    /// The name of its recorded motions in [`RECORDED`](crate::RECORDED).
    pub record: Option<&'static str>,
    /// What its own settings have against what the rule does to a free body, if anything.
    pub remedy: Option<&'static str>,
    /// When it was recorded or read, year-month-day.
    pub date: &'static str,
    /// Where the rule is known from.
    pub source: &'static str,
}

/// What an engine does to a body that is too fast for it. The rule alone has none of it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Limits {
    /// Bullet: beyond this angle (rad) a step turns by less than the spin times the step, never by more than
    /// half a turn. The spin stays.
    pub turn: Option<f64>,
    /// Bullet's multibody: the most spin (rad/s) along each axis of the world; what is beyond it is cut off.
    pub component: Option<f64>,
    /// Rapier: the most angle (rad) a whole step may turn; a faster spin is slowed to it, for good.
    pub spin: Option<f64>,
    /// MuJoCo: the most angular acceleration and spin (rad/s², rad/s) along any principal axis; beyond it
    /// MuJoCo puts the body back to its attitude at the beginning of all, at rest, and warns. Here that is an
    /// error.
    pub rate: Option<f64>,
    /// The attitude is stepped straight by the new spin, `q + h/2 q w` at length 1: always by too little, and
    /// never by more than half a turn.
    pub straight: bool,
}

impl Limits {
    /// None.
    pub const NONE: Self = Self { turn: None, component: None, spin: None, rate: None, straight: false };
    /// None, and the attitude stepped straight.
    pub const STRAIGHT: Self = Self { straight: true, ..Self::NONE };

    /// What the limits make of the end of a part of a step of `h` seconds.
    fn keep(
        &self,
        method: Method,
        system: &System<f64>,
        start: &State<f64>,
        end: State<f64>,
        part: f64,
        h: f64,
    ) -> Result<State<f64>, Error> {
        let requested = system.omega(&end.momentum);
        let mut omega = requested;
        if let Some(most) = self.component {
            // Cut in the world's axes, at the attitude before the turn.
            let rotation = attitude::rotation_matrix(&start.attitude);
            let world = rotation * requested;
            if world.amax() > most {
                omega = rotation.tr_mul(&world.map(|x| x.max(-most).min(most)));
            }
        }
        if let Some(most) = self.spin.map(|angle| angle / h.abs()) {
            let speed = omega.norm();
            if speed > most {
                omega *= most / speed;
            }
        }
        let cut = omega != requested;
        let most = self.turn.unwrap_or(f64::INFINITY);
        if !cut && !self.straight && omega.norm() * part.abs() <= most {
            return Ok(end);
        }
        let attitude = if self.straight || method == Method::RescaledLinearAttitude {
            turned_straight(&start.attitude, &omega, part)
        } else {
            turned_beyond(&start.attitude, &omega, part, most)
        };
        let momentum = if cut { system.momentum(&omega) } else { end.momentum };
        Ok(State { attitude, momentum }.checked()?)
    }
}

impl PhysicsEngine {
    /// Whether a word is the first of its name, or of one of its names.
    pub fn is_called(&self, word: &str) -> bool {
        let first = |name: &'static str| name.split(|c: char| !c.is_alphanumeric()).next();
        let mut names = self.name.split(", ").filter_map(first);
        names.any(|name| name.eq_ignore_ascii_case(word))
    }

    /// One step of `h` seconds as this engine takes it: its rule, its parts of a step and its limits.
    ///
    /// ```
    /// use nalgebra::{Quaternion, Vector3};
    /// use tumbling::PrincipalMoments;
    /// use tumbling::step::{State, System};
    /// use tumbling_engines::PHYSICS_ENGINES;
    /// let system = System::free(PrincipalMoments::new(1.0, 2.0, 2.5)?)?;
    /// let start = State { attitude: Quaternion::identity(), momentum: Vector3::new(0.0, 0.0, 250.0) };
    /// let rapier = PHYSICS_ENGINES.iter().find(|engine| engine.name == "Rapier").unwrap();
    /// // 100 rad/s about an axis, at 60 Hz: Rapier makes that an eighth of a turn a step, 47 rad/s.
    /// let end = rapier.step(&system, &start, 1.0 / 60.0)?;
    /// assert!((system.omega(&end.momentum).z - 15.0 * std::f64::consts::PI).abs() < 1e-12);
    /// # Ok::<(), tumbling_engines::Error>(())
    /// ```
    ///
    /// # Errors
    /// A step that is not finite, a motion that leaves what `f64` holds, or one that MuJoCo would take back
    /// to the beginning.
    pub fn step(&self, system: &System<f64>, start: &State<f64>, h: f64) -> Result<State<f64>, Error> {
        if let Some(most) = self.limits.rate {
            let omega = system.omega(&start.momentum);
            let rate = system.omega(&system.rate(start).momentum);
            let beyond = |x: &f64| x.is_nan() || x.abs() > most;
            if let Some(value) = omega.iter().chain(&rate).copied().find(beyond) {
                return Err(Error::StartsAnew { value, most });
            }
        }
        parted(self.method, self.parts, &self.limits, system, start, h)
    }
}

/// One step of `h` seconds by a rule, cut into this number of parts, within these limits on turn and spin.
///
/// # Errors
/// A step that is not finite, or a motion that leaves what `f64` holds.
pub fn parted(
    method: Method,
    parts: u32,
    limits: &Limits,
    system: &System<f64>,
    start: &State<f64>,
    h: f64,
) -> Result<State<f64>, Error> {
    if parts <= 1 {
        let end = method.step(system, start, h)?;
        return limits.keep(method, system, start, end, h, h);
    }
    // Cut in parts, a step takes the torques' change of spin from its start, the same in the world for all
    // parts.
    let part = h / f64::from(parts);
    if system.torques().is_empty() {
        return (0..parts).try_fold(*start, |motion, _| {
            limits.keep(method, system, &motion, method.step(system, &motion, part)?, part, h)
        });
    }
    let push = attitude::rotation_matrix(&start.attitude) * system.omega(&system.torque(start)) * part;
    let free = System::of_numbers(*system.moments(), Vec::new());
    (0..parts).try_fold(*start, |mut motion, _| {
        let inside = attitude::rotation_matrix(&motion.attitude).tr_mul(&push);
        motion.momentum += system.momentum(&inside);
        limits.keep(method, system, &motion, method.step(&free, &motion, part)?, part, h)
    })
}

/// `start` times `turn`, at length 1.
fn turned(start: &Quaternion<f64>, turn: &Quaternion<f64>) -> Quaternion<f64> {
    let q = attitude::product(start, turn);
    q / q.coords.dot(&q.coords).sqrt()
}

/// `start` moved along its rate at the spin `omega` (body axes, rad/s) for `h` seconds, at length 1: a turn
/// by `2 atan(|w| h / 2)` instead of `|w| h`.
pub fn turned_straight(start: &Quaternion<f64>, omega: &Vector3<f64>, h: f64) -> Quaternion<f64> {
    turned(start, &Quaternion::from_parts(1.0, omega * (h / 2.0)))
}

/// `start` turned by the spin `omega` (body axes, rad/s) for `h` seconds as Bullet does it: by `|w| h` up to
/// the angle `most`, beyond it by `2 atan((|w| h / most) tan(most / 2))`, which is too little and never more
/// than half a turn.
fn turned_beyond(start: &Quaternion<f64>, omega: &Vector3<f64>, h: f64, most: f64) -> Quaternion<f64> {
    if omega.norm() * h.abs() <= most {
        return turned(start, &attitude::turn(&(omega * h)));
    }
    let (sine, cosine) = (most / 2.0).sin_cos();
    turned(start, &Quaternion::from_parts(cosine, omega * (h * sine / most)))
}

const NONE: Limits = Limits::NONE;
const STRAIGHT: Limits = Limits::STRAIGHT;
const MUJOCO: Limits = Limits { rate: Some(1e10), ..NONE };
const BULLET: Limits = Limits { turn: Some(FRAC_PI_4), ..NONE };
const RAPIER: Limits = Limits { spin: Some(FRAC_PI_4), ..NONE };

/// Name, version if recorded, setting: rule in parts a step, limits, record, date, what to set, source.
macro_rules! engines {
    ($($name:literal, $version:expr, $setting:literal: $method:ident in $parts:literal, $limits:expr,
       $record:expr, $date:literal, $remedy:expr, $source:literal;)+) => {
        &[$(PhysicsEngine {
            name: $name,
            version: $version,
            setting: $setting,
            method: Method::$method,
            parts: $parts,
            limits: $limits,
            record: $record,
            date: $date,
            remedy: $remedy,
            source: $source,
        }),+]
    };
}

/// Engines and what they do to a free body. The recorded ones are followed step by step in the judge's
/// `tests/judge/engines_recorded.rs`; of the others the rule is known, and neither the last digits nor their
/// limits.
///
/// ```
/// use tumbling::step::Method;
/// use tumbling_engines::PHYSICS_ENGINES;
/// let rapier = PHYSICS_ENGINES.iter().find(|engine| engine.name == "Rapier").unwrap();
/// assert_eq!((rapier.method, rapier.parts), (Method::RescaledLinearAttitude, 4));
/// let never_flips = PHYSICS_ENGINES.iter().filter(|engine| engine.method == Method::ConstantSpin);
/// assert_eq!(never_flips.count(), 8);
/// ```
pub const PHYSICS_ENGINES: &[PhysicsEngine] = engines! {
    "MuJoCo", Some("4.0.0"), "Euler (default)": SemiImplicitEuler in 1, MUJOCO, Some("mujoco-4.0.0-euler"), "2026-11-21", Some("integrator=\"RK4\""), "recorded from the Python package mujoco";
    "MuJoCo", Some("4.0.0"), "implicitfast, implicit": LinearisedImplicit in 1, MUJOCO, Some("mujoco-4.0.0-implicitfast"), "2026-11-21", Some("integrator=\"RK4\""), "recorded from the Python package mujoco";
    "MuJoCo", Some("4.0.0"), "RK4": TurnedRungeKutta4 in 1, MUJOCO, Some("mujoco-4.0.0-rk4"), "2026-11-21", None, "recorded from the Python package mujoco";
    "MuJoCo", Some("3.17.0"), "RK4": MeanSpinRungeKutta4 in 1, MUJOCO, Some("mujoco-3.17.0-rk4"), "2026-11-21", None, "recorded from the Python package mujoco";
    "Bullet", Some("3.2.7 (pybullet)"), "multibody (pybullet's default)": SemiImplicitEuler in 1, Limits { component: Some(100.0), ..BULLET }, Some("bullet-3.2.7-multibody"), "2026-11-21", Some("a btRigidBody (pybullet: useMaximalCoordinates), whose BT_ENABLE_GYROSCOPIC_FORCE_IMPLICIT_BODY loses energy instead"), "recorded from the Python package pybullet";
    "Bullet", Some("3.2.7 (pybullet)"), "rigid body (maximal coordinates)": ImplicitOneNewton in 1, BULLET, Some("bullet-3.2.7-rigid"), "2026-11-21", None, "recorded from the Python package pybullet";
    "Rapier", Some("0.36.1"), "gyroscopic forces on (default)": RescaledLinearAttitude in 4, RAPIER, Some("rapier3d-f64-0.36.1"), "2026-11-21", None, "recorded from the crate rapier3d-f64";
    "MJX", Some("3.17.0"), "Euler, implicitfast": SemiImplicitEuler in 1, NONE, Some("mujoco-mjx-3.17.0-euler"), "2026-11-24", Some("integrator=\"RK4\""), "recorded from the Python package mujoco-mjx";
    "MJX", Some("3.17.0"), "RK4": MeanSpinRungeKutta4 in 1, NONE, Some("mujoco-mjx-3.17.0-rk4"), "2026-11-24", None, "recorded from the Python package mujoco-mjx";
    "DART", Some("6.20.0"), "default": SemiImplicitEuler in 1, NONE, Some("dartpy-6.20.0"), "2026-11-24", None, "recorded from the Python package dartpy";
    "Pinocchio", Some("4.1.0"), "aba, then integrate": SemiImplicitEuler in 1, NONE, Some("pin-4.1.0"), "2026-11-24", None, "recorded from the Python package pin";
    "Drake", Some("1.51.1"), "discrete": SemiImplicitEuler in 1, STRAIGHT, Some("drake-1.51.1-discrete"), "2026-11-24", Some("a continuous plant (time_step 0) with an error-controlled integrator"), "recorded from the Python package drake";
    "Newton", Some("1.8.0"), "Featherstone, SemiImplicit and XPBD, angular damping 0": SemiImplicitEuler in 1, STRAIGHT, Some("newton-1.8.0-semiimplicit"), "2026-11-24", None, "recorded from the Python package newton";
    "Avian", None, "gyroscopic motion on, six substeps (default)": Rescaled in 6, NONE, None, "2026-11-21", None, "Jondolf/avian, src/dynamics/integrator/semi_implicit_euler.rs: solve_gyroscopic_torque";
    "Jolt", Some("1.1.0 (jolt-physics)"), "gyroscopic force on": Rescaled in 1, NONE, Some("jolt-physics-1.1.0-gyroscopic"), "2026-11-24", None, "recorded from the package jolt-physics of npm, mApplyGyroscopicForce set";
    "Jolt", Some("1.1.0 (jolt-physics)"), "gyroscopic force off (default)": ConstantSpin in 1, NONE, Some("jolt-physics-1.1.0"), "2026-11-24", Some("BodyCreationSettings::mApplyGyroscopicForce"), "recorded from the package jolt-physics of npm";
    "PhysX", Some("2.7.3 (physx-js-webidl)"), "gyroscopic forces on": Rescaled in 1, NONE, Some("physx-js-webidl-2.7.3-gyroscopic"), "2026-11-24", None, "recorded from the package physx-js-webidl of npm, eENABLE_GYROSCOPIC_FORCES set";
    "SAPIEN", Some("3.0.3"), "default": Rescaled in 1, NONE, Some("sapien-3.0.3"), "2026-11-24", None, "recorded from the Python package sapien, which has PhysX with its flag on";
    "Box3D", None, "four substeps": ImplicitOneNewton in 4, NONE, None, "2026-11-22", None, "erincatto/box3d at 04ce9fb9, src/solver.c: b3IntegrateVelocitiesTask";
    "PhysX, Unity", Some("2.7.3 (physx-js-webidl)"), "gyroscopic forces off (default)": ConstantSpin in 1, NONE, Some("physx-js-webidl-2.7.3"), "2026-11-24", Some("in PhysX PxRigidBodyFlag::eENABLE_GYROSCOPIC_FORCES"), "recorded from the package physx-js-webidl of npm";
    "Godot Physics", None, "default": ConstantSpin in 1, NONE, None, "2026-11-21", None, "godotengine/godot, modules/godot_physics_3d/godot_body_3d.cpp: no gyroscopic term";
    "Havok", Some("1.3.14 (@babylonjs/havok)"), "default": ConstantSpin in 1, NONE, Some("babylonjs-havok-1.3.14"), "2026-11-24", None, "recorded from the package @babylonjs/havok of npm";
    "ammo.js", Some("1.1.0 (ammojs-typed)"), "default": ConstantSpin in 1, NONE, Some("ammojs-typed-1.1.0"), "2026-11-24", None, "recorded from the package ammojs-typed of npm";
    "Brax", Some("0.14.2"), "spring": ConstantSpin in 1, STRAIGHT, Some("brax-0.14.2-spring"), "2026-11-24", Some("the generalized pipeline"), "recorded from the Python package brax";
    "Brax", Some("0.14.2"), "generalized": SemiImplicitEuler in 1, NONE, Some("brax-0.14.2-generalized"), "2026-11-24", None, "recorded from the Python package brax";
    "cannon-es", Some("0.20.0"), "default": ConstantSpin in 1, STRAIGHT, Some("cannon-es-0.20.0"), "2026-11-24", None, "recorded from the package cannon-es of npm";
    "Oimo.js", Some("1.0.9 (oimo)"), "default": ConstantSpin in 1, STRAIGHT, Some("oimo-1.0.9"), "2026-11-24", None, "recorded from the package oimo of npm";
};
