//! What the programs in Rust share: a scene a line on standard input, a record a scene into the folder that
//! the command line names. The lines are those of `before_after.py`.

use std::fmt::Write as _;
use std::io::BufRead as _;
use std::time::Instant;

pub const H: f32 = 1.0 / 60.0;

/// Attitude (w, x, y, z; body to world), spin, position and velocity in world axes.
#[derive(Clone, Copy, Default)]
pub struct Seen {
    pub attitude: [f32; 4],
    pub spin: [f32; 3],
    pub position: [f32; 3],
    pub velocity: [f32; 3],
}

/// A free body, or one of several.
#[derive(Clone, Copy)]
pub struct Body {
    pub mass: f32,
    pub moments: [f32; 3],
    pub attitude: [f32; 4],
    /// In world axes.
    pub spin: [f32; 3],
    pub position: [f32; 3],
    pub velocity: [f32; 3],
}

/// The scenes in an engine, stepped at [`H`].
pub trait Engine: Sized {
    const NAME: &'static str;
    /// Bodies without shapes and without gravity; if `axle` is given, the first two are joined there by a
    /// hinge about the z axis of both.
    fn bodies(bodies: &[Body], axle: Option<[f32; 3]>) -> Self;
    /// A body with a ball of radius `ball` at `tip` in its own axes, on a plane `y = 0`, with gravity.
    fn top(body: Body, tip: [f32; 3], ball: f32) -> Self;
    /// Boxes of these half sides on each other, with gravity.
    fn stack(count: usize, half: [f32; 3]) -> Self;
    fn step(&mut self);
    fn see(&self, body: usize) -> Seen;
}

fn turned([w, x, y, z]: [f64; 4], [a, b, c]: [f64; 3], back: f64) -> [f64; 3] {
    let cross = |[a, b, c]: [f64; 3]| [y * c - z * b, z * a - x * c, x * b - y * a];
    let [u, v, t] = cross([a, b, c]);
    let twice = cross([u, v, t]);
    let w = back * w;
    [a + 2.0 * (w * u + twice[0]), b + 2.0 * (w * v + twice[1]), c + 2.0 * (w * t + twice[2])]
}

fn body(words: &[f32]) -> Body {
    let at = |i: usize| words.get(i).copied().unwrap_or(0.0);
    let attitude = [at(4), at(5), at(6), at(7)];
    let spin = turned(attitude.map(f64::from), [at(8), at(9), at(10)].map(f64::from), 1.0).map(|x| x as f32);
    let position = [at(11), at(12), at(13)];
    let velocity = [at(14), at(15), at(16)];
    Body { mass: at(0), moments: [at(1), at(2), at(3)], attitude, spin, position, velocity }
}

/// Rows of time, attitude and spin in body axes; of several bodies also position and velocity.
fn record<E: Engine>(world: &mut E, count: usize, steps: u32, every: u32) -> String {
    let mut text = String::new();
    for n in 0..=steps {
        if n % every == 0 {
            for i in 0..count {
                let seen = world.see(i);
                let attitude = seen.attitude.map(f64::from);
                let spin = turned(attitude, seen.spin.map(f64::from), -1.0);
                let mut row = vec![f64::from(n) / 60.0];
                row.extend(attitude.into_iter().chain(spin));
                if count > 1 {
                    row.extend(seen.position.into_iter().chain(seen.velocity).map(f64::from));
                }
                let row: Vec<String> = row.iter().map(|x| format!("{x:?}")).collect();
                let _ = writeln!(text, "{}", row.join(","));
            }
        }
        world.step();
    }
    text
}

fn timed<E: Engine>(mut new: impl FnMut() -> E, steps: u32, repeats: u32) {
    let times: Vec<f64> = (0..repeats)
        .map(|_| {
            let mut world = new();
            world.step();
            let start = Instant::now();
            (0..steps).for_each(|_| world.step());
            start.elapsed().as_secs_f64() * 1e6 / f64::from(steps)
        })
        .collect();
    let times: Vec<String> = times.iter().map(|x| format!("{x:.3}")).collect();
    println!("{}", times.join(" "));
}

/// Runs the scenes.
pub fn run<E: Engine>() -> Result<(), Box<dyn std::error::Error>> {
    let folder = std::env::args().nth(1).ok_or("name a folder")?;
    for line in std::io::stdin().lock().lines() {
        let line = line?;
        let words: Vec<&str> = line.split_whitespace().collect();
        let [kind, name, steps, every, rest @ ..] = &words[..] else { continue };
        let (steps, every): (u32, u32) = (steps.parse()?, every.parse()?);
        let numbers: Vec<f32> = rest.iter().map(|x| x.parse()).collect::<Result<_, _>>()?;
        let mut head = format!("# engine: {}\n# dt: 1/60 s\n", E::NAME);
        let text = match *kind {
            "free" => {
                let [_, a, b, c, ..] = numbers[..] else { continue };
                let _ = write!(head, "# inertia: {a} {b} {c} kg m2\nt,qw,qx,qy,qz,wx,wy,wz\n");
                record(&mut E::bodies(&[body(&numbers)], None), 1, steps, every)
            }
            "wheel" => {
                let (one, two) = (body(&numbers[3..20]), body(&numbers[20..]));
                let axle = [numbers[0], numbers[1], numbers[2]];
                record(&mut E::bodies(&[one, two], Some(axle)), 2, steps, every)
            }
            "top" => {
                let mut world = E::top(body(&numbers[4..]), [numbers[0], numbers[1], numbers[2]], numbers[3]);
                record(&mut world, 1, steps, every)
            }
            "stack" => {
                let half = [numbers[1], numbers[2], numbers[3]];
                record(&mut E::stack(numbers[0] as usize, half), numbers[0] as usize, steps, every)
            }
            "time-stack" => {
                timed(|| E::stack(numbers[0] as usize, [numbers[1], numbers[2], numbers[3]]), steps, every);
                continue;
            }
            "time-crowd" => {
                let crowd: Vec<Body> = (0..numbers[0] as usize)
                    .map(|i| {
                        let one = body(&numbers[1..]);
                        let turn = |x: f32| x * (1.0 + 0.001 * (i % 100) as f32);
                        Body { spin: one.spin.map(turn), position: [3.0 * i as f32, 0.0, 0.0], ..one }
                    })
                    .collect();
                timed(|| E::bodies(&crowd, None), steps, every);
                continue;
            }
            _ => continue,
        };
        std::fs::write(format!("{folder}/{name}.csv"), head + &text)?;
    }
    Ok(())
}
