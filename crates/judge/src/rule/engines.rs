//! The catalogue of physics engines: each row in full, with where it is known from.

use crate::rule::{Limits, PhysicsEngine};
use std::f64::consts::FRAC_PI_4;
use tumbling::step::Method;

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

/// Engines and what they do to a free body. The recorded ones are followed step by step in
/// `tests/judge/engines_recorded.rs`; of the others the rule is known, and neither the last digits nor their
/// limits.
///
/// ```
/// use tumbling::step::Method;
/// use tumbling_judge::PHYSICS_ENGINES;
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
