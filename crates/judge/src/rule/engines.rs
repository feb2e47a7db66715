//! The catalogue of physics engines: each row in full, with where it is known from.

use crate::rule::{Limits, PhysicsEngine};
use std::f64::consts::FRAC_PI_4;
use tumbling::step::Method;

/// A rule in one part, known from an engine's source or documentation.
const RULE_ALONE: PhysicsEngine = PhysicsEngine {
    name: "",
    version: None,
    setting: "",
    method: Method::ConstantSpin,
    parts: 1,
    limits: Limits::NONE,
    record: None,
    date: "",
    source: "",
};

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
/// assert_eq!(never_flips.count(), 4);
/// ```
pub const PHYSICS_ENGINES: &[PhysicsEngine] = &[
    PhysicsEngine {
        name: "MuJoCo",
        version: Some("4.0.0"),
        setting: "Euler (default)",
        method: Method::SemiImplicitEuler,
        limits: Limits { rate: Some(1e10), ..Limits::NONE },
        record: Some("mujoco-4.0.0-euler"),
        date: "2026-11-21",
        source: "recorded from the Python package mujoco",
        ..RULE_ALONE
    },
    PhysicsEngine {
        name: "MuJoCo",
        version: Some("4.0.0"),
        setting: "implicitfast, implicit",
        method: Method::LinearisedImplicit,
        limits: Limits { rate: Some(1e10), ..Limits::NONE },
        record: Some("mujoco-4.0.0-implicitfast"),
        date: "2026-11-21",
        source: "recorded from the Python package mujoco",
        ..RULE_ALONE
    },
    PhysicsEngine {
        name: "MuJoCo",
        version: Some("4.0.0"),
        setting: "RK4",
        method: Method::TurnedRungeKutta4,
        limits: Limits { rate: Some(1e10), ..Limits::NONE },
        record: Some("mujoco-4.0.0-rk4"),
        date: "2026-11-21",
        source: "recorded from the Python package mujoco",
        ..RULE_ALONE
    },
    PhysicsEngine {
        name: "MuJoCo",
        version: Some("3.17.0"),
        setting: "RK4",
        method: Method::MeanSpinRungeKutta4,
        limits: Limits { rate: Some(1e10), ..Limits::NONE },
        record: Some("mujoco-3.17.0-rk4"),
        date: "2026-11-21",
        source: "recorded from the Python package mujoco",
        ..RULE_ALONE
    },
    PhysicsEngine {
        name: "Bullet",
        version: Some("3.2.7 (pybullet)"),
        setting: "multibody (pybullet's default)",
        method: Method::SemiImplicitEuler,
        limits: Limits { turn: Some(FRAC_PI_4), component: Some(100.0), ..Limits::NONE },
        record: Some("bullet-3.2.7-multibody"),
        date: "2026-11-21",
        source: "recorded from the Python package pybullet",
        ..RULE_ALONE
    },
    PhysicsEngine {
        name: "Bullet",
        version: Some("3.2.7 (pybullet)"),
        setting: "rigid body (maximal coordinates)",
        method: Method::ImplicitOneNewton,
        limits: Limits { turn: Some(FRAC_PI_4), ..Limits::NONE },
        record: Some("bullet-3.2.7-rigid"),
        date: "2026-11-21",
        source: "recorded from the Python package pybullet",
        ..RULE_ALONE
    },
    PhysicsEngine {
        name: "Rapier",
        version: Some("0.36.1"),
        setting: "gyroscopic forces on (default)",
        method: Method::RescaledLinearAttitude,
        parts: 4,
        limits: Limits { spin: Some(FRAC_PI_4), ..Limits::NONE },
        record: Some("rapier3d-f64-0.36.1"),
        date: "2026-11-21",
        source: "recorded from the crate rapier3d-f64",
    },
    PhysicsEngine {
        name: "Avian",
        setting: "gyroscopic motion on, six substeps (default)",
        method: Method::Rescaled,
        parts: 6,
        date: "2026-11-21",
        source: "Jondolf/avian, src/dynamics/integrator/semi_implicit_euler.rs: solve_gyroscopic_torque",
        ..RULE_ALONE
    },
    PhysicsEngine {
        name: "Jolt",
        setting: "gyroscopic force on",
        method: Method::Rescaled,
        date: "2026-11-21",
        source: "jrouwe/JoltPhysics: BodyCreationSettings::mApplyGyroscopicForce",
        ..RULE_ALONE
    },
    PhysicsEngine {
        name: "Jolt",
        setting: "gyroscopic force off (default)",
        method: Method::ConstantSpin,
        date: "2026-11-21",
        source: "jrouwe/JoltPhysics: BodyCreationSettings::mApplyGyroscopicForce",
        ..RULE_ALONE
    },
    PhysicsEngine {
        name: "Box3D",
        setting: "four substeps",
        method: Method::ImplicitOneNewton,
        parts: 4,
        date: "2026-11-22",
        source: "erincatto/box3d at 04ce9fb9, src/solver.c: b3IntegrateVelocitiesTask",
        ..RULE_ALONE
    },
    PhysicsEngine {
        name: "PhysX, Unity",
        setting: "gyroscopic forces off (default)",
        method: Method::ConstantSpin,
        date: "2026-11-21",
        source: "NVIDIA PhysX: PxRigidBodyFlag::eENABLE_GYROSCOPIC_FORCES is not set by default",
        ..RULE_ALONE
    },
    PhysicsEngine {
        name: "Godot Physics",
        setting: "default",
        method: Method::ConstantSpin,
        date: "2026-11-21",
        source: "godotengine/godot, modules/godot_physics_3d/godot_body_3d.cpp: no gyroscopic term",
        ..RULE_ALONE
    },
    PhysicsEngine {
        name: "Brax",
        setting: "positional",
        method: Method::ConstantSpin,
        date: "2026-11-22",
        source: "google/brax at 0d513cdb, brax/positional/integrator.py: no gyroscopic term",
        ..RULE_ALONE
    },
];
