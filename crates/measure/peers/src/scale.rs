//! Many bodies: the library's batches on one thread and two, and a world of Rapier with as many free bodies,
//! in one run.

use rapier3d_f64::prelude::*;
use rayon::{ThreadPool, ThreadPoolBuilder};
use std::path::Path;
use tumbling_measure::record::Record;
use tumbling_measure::scale::crowd::{self, Crowd, Effort, Prepare, Ready, Run, body};
use tumbling_measure::scale::{self, Scale};
use tumbling_measure::story::Wrong;

/// Far enough apart that nothing meets.
fn world(bodies: usize) -> PhysicsWorld {
    let mut world = PhysicsWorld::default();
    world.gravity = Vector::ZERO;
    world.integration_parameters.dt = 1.0 / 60.0;
    for k in 0..bodies {
        let given = body(k);
        let Ok(whole) = given.body() else { continue };
        let (m, w) = (given.moments, whole.omega_world());
        let (axis, angle) = given
            .attitude
            .axis_angle()
            .map_or((nalgebra::Vector3::z(), 0.0), |(axis, angle)| (axis.into_inner(), angle));
        let turn = axis * angle;
        let principal = AngVector::new(m.x, m.y, m.z);
        let one = RigidBodyBuilder::dynamic()
            .additional_mass_properties(MassProperties::new(Vector::ZERO, 1.0, principal))
            .rotation(AngVector::new(turn.x, turn.y, turn.z))
            .angvel(AngVector::new(w.x, w.y, w.z))
            .linear_damping(0.0)
            .angular_damping(0.0)
            .can_sleep(false)
            .gyroscopic_forces_enabled(true)
            .build();
        world.bodies.insert(one);
    }
    world
}

fn pool(threads: usize) -> Result<ThreadPool, Wrong> {
    Ok(ThreadPoolBuilder::new().num_threads(threads).build()?)
}

/// Measures and writes `scale.csv`, with what another build left in `with` put first.
pub fn write(
    build: &str,
    effort: Effort,
    with: Option<&Path>,
    folder: &Path,
    versions: &[(String, String)],
    tell: &mut dyn FnMut(&str),
) -> Result<String, Wrong> {
    let (one, two) = (pool(1)?, pool(2)?);
    let on_one: &Run<'_> = &|pass| one.install(pass);
    let on_two: &Run<'_> = &|pass| two.install(pass);
    let mut crowds = crowd::ours(on_one, Some(on_two));
    let prepare: Prepare<'_> = Box::new(|bodies| {
        let mut world = world(bodies);
        Ready { pass: Box::new(move |_| world.step()), bytes: None }
    });
    crowds.push(Crowd { name: "Rapier", lanes: 1, threads: 1, instants: 1, most: 1_000_000, prepare });
    let mut rows = match with {
        Some(path) => Record::<Scale>::read(&std::fs::read_to_string(path)?)?.rows,
        None => Vec::new(),
    };
    rows.extend(crowd::measure(build, &crowds, effort, tell));
    let record = scale::record(rows, versions, effort);
    std::fs::create_dir_all(folder)?;
    std::fs::write(folder.join("scale.csv"), record.write())?;
    Ok(scale::text(&record))
}
