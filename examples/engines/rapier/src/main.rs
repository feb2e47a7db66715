//! Runs the kit's stories in Rapier: `cargo run -- STEP [STORY...]`, all stories if none is named.
//!
//! Writes STORY.csv into the folder `records` next to this package, for `judge`.

use rapier3d_f64::prelude::*;
use serde_json::Value;
use std::error::Error;
use std::fmt::Write as _;
use std::path::Path;

/// Time, attitude (w, x, y, z) and spin in body axes, at each step.
fn run(story: &Value, h: f64) -> Result<Vec<[f64; 8]>, Box<dyn Error>> {
    let numbers = |name: &str| serde_json::from_value::<Vec<f64>>(story[name].clone());
    let vector = |name: &str| numbers(name).map(|v| Vector::new(v[0], v[1], v[2]));
    let q = numbers("attitude")?;
    let attitude = Rotation::from_xyzw(q[1], q[2], q[3], q[0]);
    let mut world = PhysicsWorld::new();
    world.gravity = Vector::ZERO;
    world.integration_parameters.dt = h;
    let mass = MassProperties::new(Vector::ZERO, 1.0, vector("moments")?);
    // Rapier takes the spin in world axes. A body that sleeps would stop.
    let body = RigidBodyBuilder::dynamic()
        .additional_mass_properties(mass)
        .rotation(attitude.to_scaled_axis())
        .angvel(attitude * vector("spin")?)
        .can_sleep(false);
    let handle = world.insert_body(body);
    let steps = (story["duration"].as_f64().ok_or("no duration")? / h).round() as u32;
    let mut rows = Vec::new();
    for n in 0..=steps {
        let body = &world.bodies[handle];
        let (q, w) = (*body.rotation(), body.rotation().inverse() * body.angvel());
        rows.push([f64::from(n) * h, q.w, q.x, q.y, q.z, w.x, w.y, w.z]);
        world.step();
    }
    Ok(rows)
}

fn main() -> Result<(), Box<dyn Error>> {
    let args: Vec<String> = std::env::args().skip(1).collect();
    let (step, wanted) = args.split_first().ok_or("name the step, as in 1/60")?;
    let h = match step.split_once('/') {
        Some((over, under)) => over.parse::<f64>()? / under.parse::<f64>()?,
        None => step.parse()?,
    };
    let here = Path::new(env!("CARGO_MANIFEST_DIR"));
    let kit = std::fs::read_to_string(here.join("../../../crates/judge/kit/stories.json"))?;
    let kit: Value = serde_json::from_str(&kit)?;
    std::fs::create_dir_all(here.join("records"))?;
    for story in kit["stories"].as_array().ok_or("no stories")? {
        let name = story["name"].as_str().ok_or("a story without a name")?;
        if !wanted.is_empty() && !wanted.iter().any(|x| x == name) {
            continue;
        }
        let moments = &story["moments"];
        let mut text = format!(
            "# engine: Rapier 0.36.1 (rapier3d-f64), gyroscopic forces on\n# inertia: {} {} {} kg m2\n# dt: {step} s\nt,qw,qx,qy,qz,wx,wy,wz\n",
            moments[0], moments[1], moments[2]
        );
        for row in run(story, h)? {
            let row: Vec<String> = row.iter().map(|x| format!("{x:?}")).collect();
            writeln!(text, "{}", row.join(","))?;
        }
        let path = here.join(format!("records/{name}.csv"));
        std::fs::write(&path, text)?;
        println!("{}", path.display());
    }
    Ok(())
}
