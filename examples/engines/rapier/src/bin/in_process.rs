//! Judges Rapier in process, in single and in double precision: `cargo run --release --bin in_process`; with
//! the name of a story after `--`, it prints the two verdicts on that.
//!
//! No record is written: the closure steps Rapier's world, and the judge takes each row from it.

use tumbling_judge::{Error, Outcome, Story, Verdict};

const H: f64 = 1.0 / 60.0;

/// A spin in world axes, in the axes of a body with this attitude (w, x, y, z; body to world).
fn in_body([w, x, y, z]: [f64; 4], [a, b, c]: [f64; 3]) -> [f64; 3] {
    let cross = |[a, b, c]: [f64; 3]| [b * z - c * y, c * x - a * z, a * y - b * x];
    let [u, v, t] = cross([a, b, c]);
    let twice = cross([u, v, t]);
    [a + 2.0 * (w * u + twice[0]), b + 2.0 * (w * v + twice[1]), c + 2.0 * (w * t + twice[2])]
}

/// A function that judges Rapier's run of a story, for the crate of one precision.
macro_rules! judged_by {
    ($name:ident, $rapier:ident, $real:ty) => {
        fn $name(story: &Story) -> Result<Verdict, Error> {
            use $rapier::prelude::*;
            let vector = |v: [f64; 3]| Vector::new(v[0] as $real, v[1] as $real, v[2] as $real);
            let [w, x, y, z] = story.attitude.map(|x| x as $real);
            let attitude = Rotation::from_xyzw(x, y, z, w);
            let mut world = PhysicsWorld::new();
            world.gravity = Vector::ZERO;
            world.integration_parameters.dt = H as $real;
            let body = RigidBodyBuilder::dynamic()
                .additional_mass_properties(MassProperties::new(Vector::ZERO, 1.0, vector(story.moments)))
                .rotation(attitude.to_scaled_axis())
                .angvel(attitude * vector(story.spin))
                .can_sleep(false);
            let handle = world.insert_body(body);
            story.run::<$real>(H, |_, _| {
                world.step();
                let (q, spin) = (*world.bodies[handle].rotation(), world.bodies[handle].angvel());
                let attitude = [q.w, q.x, q.y, q.z];
                let spin = in_body(attitude.map(f64::from), [spin.x, spin.y, spin.z].map(f64::from));
                (attitude, spin.map(|x| x as $real))
            })
        }
    };
}

judged_by!(single, rapier3d, f32);
judged_by!(double, rapier3d_f64, f64);

fn main() -> Result<(), Error> {
    if let Some(story) = std::env::args().nth(1).and_then(|name| Story::named(&name)) {
        println!("{}\n\n{}", single(&story)?, double(&story)?);
        return Ok(());
    }
    let (mut passed, stories) = ([0, 0], Story::all());
    println!("| story | precision | verdict | rule |\n|---|---|---|---|");
    for story in &stories {
        for (i, (precision, judged)) in
            [("f32", single as fn(&Story) -> _), ("f64", double)].into_iter().enumerate()
        {
            let verdict: Verdict = judged(story)?;
            passed[i] += usize::from(verdict.outcome == Outcome::Passed);
            let rule = verdict.diagnosis.as_ref().map_or("none".into(), |diagnosis| {
                format!("{}: {}", diagnosis.words(), diagnosis.best.rule.name())
            });
            println!("| {} | {precision} | {} | {rule} |", story.name, verdict.outcome.key());
        }
    }
    let [single, double] = passed;
    println!("\nOf {} stories {single} pass in f32, {double} in f64.", stories.len());
    Ok(())
}
