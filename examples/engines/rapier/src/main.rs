//! Runs the kit's stories in Rapier: `cargo run -- STEP [STORY...]`, all stories if none is named.
//!
//! Writes STORY.csv into the folder `records` next to this package, for `judge`.

use rapier3d_f64::prelude::*;
use std::error::Error;
use std::fmt::Write as _;
use std::path::Path;
use tumbling_judge::Story;

/// Time, attitude (w, x, y, z) and spin in body axes, at each step.
fn run(story: &Story, h: f64) -> Vec<[f64; 8]> {
    let vector = |[x, y, z]: [f64; 3]| Vector::new(x, y, z);
    let [w, x, y, z] = story.attitude;
    let attitude = Rotation::from_xyzw(x, y, z, w);
    let mut world = PhysicsWorld::new();
    world.gravity = Vector::ZERO;
    world.integration_parameters.dt = h;
    // Rapier takes the spin in world axes. A body that sleeps would stop.
    let body = RigidBodyBuilder::dynamic()
        .additional_mass_properties(MassProperties::new(Vector::ZERO, 1.0, vector(story.moments)))
        .rotation(attitude.to_scaled_axis())
        .angvel(attitude * vector(story.spin))
        .can_sleep(false);
    let handle = world.insert_body(body);
    let row = |n: u32| {
        let body = &world.bodies[handle];
        let (q, w) = (*body.rotation(), body.rotation().inverse() * body.angvel());
        world.step();
        [f64::from(n) * h, q.w, q.x, q.y, q.z, w.x, w.y, w.z]
    };
    (0..=(story.duration / h).round() as u32).map(row).collect()
}

fn main() -> Result<(), Box<dyn Error>> {
    let args: Vec<String> = std::env::args().skip(1).collect();
    let (step, wanted) = args.split_first().ok_or("name the step, as in 1/60")?;
    let h = match step.split_once('/') {
        Some((over, under)) => over.parse::<f64>()? / under.parse::<f64>()?,
        None => step.parse()?,
    };
    let here = Path::new(env!("CARGO_MANIFEST_DIR"));
    std::fs::create_dir_all(here.join("records"))?;
    for story in Story::all().iter().filter(|story| wanted.is_empty() || wanted.contains(&story.name)) {
        let (name, [a, b, c]) = (&story.name, story.moments);
        let mut text = format!(
            "# engine: Rapier 0.36.1 (rapier3d-f64), gyroscopic forces on\n# inertia: {a:?} {b:?} {c:?} kg m2\n# dt: {step} s\nt,qw,qx,qy,qz,wx,wy,wz\n"
        );
        for row in run(story, h) {
            let row: Vec<String> = row.iter().map(|x| format!("{x:?}")).collect();
            writeln!(text, "{}", row.join(","))?;
        }
        let path = here.join(format!("records/{name}.csv"));
        std::fs::write(&path, text)?;
        println!("{}", path.display());
    }
    Ok(())
}
