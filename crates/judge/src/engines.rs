//! The catalogue of physics engines: each row in full, with where it is known from.

use crate::engine_step::{Limits, PhysicsEngine};
use std::f64::consts::FRAC_PI_4;
use tumbling::step::Method;

/// Engines and what they do to a free body. The recorded ones are followed step by step in
/// `tests/engines_recorded.rs`; of the others the rule is known, and neither the last digits nor their
/// limits.
///
/// ```
/// use tumbling::step::Method;
/// use tumbling_judge::PHYSICS_ENGINES;
/// let rapier = PHYSICS_ENGINES.iter().find(|engine| engine.name == "Rapier").unwrap();
/// assert_eq!((rapier.method, rapier.parts), (Method::RescaledLinearAttitude, 4));
/// let never_flips = PHYSICS_ENGINES.iter().filter(|engine| engine.method == Method::ConstantSpin);
/// assert_eq!(never_flips.count(), 4);
/// ```
pub const PHYSICS_ENGINES: &[PhysicsEngine] = &[
    PhysicsEngine {
        name: "MuJoCo",
        version: Some("4.0.0"),
        setting: "Euler (default)",
        method: Method::SemiImplicitEuler,
        parts: 1,
        limits: Limits { turn: None, component: None, spin: None, rate: Some(1e10) },
        record: Some("mujoco-4.0.0-euler"),
        date: "2026-11-21",
        source: "recorded from the Python package mujoco",
    },
    PhysicsEngine {
        name: "MuJoCo",
        version: Some("4.0.0"),
        setting: "implicitfast, implicit",
        method: Method::LinearisedImplicit,
        parts: 1,
        limits: Limits { turn: None, component: None, spin: None, rate: Some(1e10) },
        record: Some("mujoco-4.0.0-implicitfast"),
        date: "2026-11-21",
        source: "recorded from the Python package mujoco",
    },
    PhysicsEngine {
        name: "MuJoCo",
        version: Some("4.0.0"),
        setting: "RK4",
        method: Method::TurnedRungeKutta4,
        parts: 1,
        limits: Limits { turn: None, component: None, spin: None, rate: Some(1e10) },
        record: Some("mujoco-4.0.0-rk4"),
        date: "2026-11-21",
        source: "recorded from the Python package mujoco",
    },
    PhysicsEngine {
        name: "MuJoCo",
        version: Some("3.17.0"),
        setting: "RK4",
        method: Method::MeanSpinRungeKutta4,
        parts: 1,
        limits: Limits { turn: None, component: None, spin: None, rate: Some(1e10) },
        record: Some("mujoco-3.17.0-rk4"),
        date: "2026-11-21",
        source: "recorded from the Python package mujoco",
    },
    PhysicsEngine {
        name: "Bullet",
        version: Some("3.2.7 (pybullet)"),
        setting: "multibody (pybullet's default)",
        method: Method::SemiImplicitEuler,
        parts: 1,
        limits: Limits { turn: Some(FRAC_PI_4), component: Some(100.0), spin: None, rate: None },
        record: Some("bullet-3.2.7-multibody"),
        date: "2026-11-21",
        source: "recorded from the Python package pybullet",
    },
    PhysicsEngine {
        name: "Bullet",
        version: Some("3.2.7 (pybullet)"),
        setting: "rigid body (maximal coordinates)",
        method: Method::ImplicitOneNewton,
        parts: 1,
        limits: Limits { turn: Some(FRAC_PI_4), component: None, spin: None, rate: None },
        record: Some("bullet-3.2.7-rigid"),
        date: "2026-11-21",
        source: "recorded from the Python package pybullet",
    },
    PhysicsEngine {
        name: "Rapier",
        version: Some("0.36.1"),
        setting: "gyroscopic forces on (default)",
        method: Method::RescaledLinearAttitude,
        parts: 4,
        limits: Limits { turn: None, component: None, spin: Some(FRAC_PI_4), rate: None },
        record: Some("rapier3d-f64-0.36.1"),
        date: "2026-11-21",
        source: "recorded from the crate rapier3d-f64",
    },
    PhysicsEngine {
        name: "Avian",
        version: None,
        setting: "gyroscopic motion on, six substeps (default)",
        method: Method::Rescaled,
        parts: 6,
        limits: Limits { turn: None, component: None, spin: None, rate: None },
        record: None,
        date: "2026-11-21",
        source: "Jondolf/avian, src/dynamics/integrator/semi_implicit_euler.rs: solve_gyroscopic_torque",
    },
    PhysicsEngine {
        name: "Jolt",
        version: None,
        setting: "gyroscopic force on",
        method: Method::Rescaled,
        parts: 1,
        limits: Limits { turn: None, component: None, spin: None, rate: None },
        record: None,
        date: "2026-11-21",
        source: "jrouwe/JoltPhysics: BodyCreationSettings::mApplyGyroscopicForce",
    },
    PhysicsEngine {
        name: "Jolt",
        version: None,
        setting: "gyroscopic force off (default)",
        method: Method::ConstantSpin,
        parts: 1,
        limits: Limits { turn: None, component: None, spin: None, rate: None },
        record: None,
        date: "2026-11-21",
        source: "jrouwe/JoltPhysics: BodyCreationSettings::mApplyGyroscopicForce",
    },
    PhysicsEngine {
        name: "Box3D",
        version: None,
        setting: "four substeps",
        method: Method::ImplicitOneNewton,
        parts: 4,
        limits: Limits { turn: None, component: None, spin: None, rate: None },
        record: None,
        date: "2026-11-22",
        source: "erincatto/box3d at 04ce9fb9, src/solver.c: b3IntegrateVelocitiesTask",
    },
    PhysicsEngine {
        name: "PhysX, Unity",
        version: None,
        setting: "gyroscopic forces off (default)",
        method: Method::ConstantSpin,
        parts: 1,
        limits: Limits { turn: None, component: None, spin: None, rate: None },
        record: None,
        date: "2026-11-21",
        source: "NVIDIA PhysX: PxRigidBodyFlag::eENABLE_GYROSCOPIC_FORCES is not set by default",
    },
    PhysicsEngine {
        name: "Godot Physics",
        version: None,
        setting: "default",
        method: Method::ConstantSpin,
        parts: 1,
        limits: Limits { turn: None, component: None, spin: None, rate: None },
        record: None,
        date: "2026-11-21",
        source: "godotengine/godot, modules/godot_physics_3d/godot_body_3d.cpp: no gyroscopic term",
    },
    PhysicsEngine {
        name: "Brax",
        version: None,
        setting: "positional",
        method: Method::ConstantSpin,
        parts: 1,
        limits: Limits { turn: None, component: None, spin: None, rate: None },
        record: None,
        date: "2026-11-22",
        source: "google/brax at 0d513cdb, brax/positional/integrator.py: no gyroscopic term",
    },
];
