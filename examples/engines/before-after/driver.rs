//! What the programs in Rust share: a scene a line on standard input, a record a scene into the folder that
//! the command line names. The lines are those of `before_after.py`.

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
    pub start: Seen,
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

/// Three numbers from a place on; what is not there is zero.
fn three(numbers: &[f32], from: usize) -> [f32; 3] {
    [0, 1, 2].map(|i| numbers.get(from + i).copied().unwrap_or(0.0))
}

fn body(words: &[f32]) -> Body {
    let ([mass, ..], [w, ..], [x, y, z]) = (three(words, 0), three(words, 4), three(words, 5));
    let spin = turned([w, x, y, z].map(f64::from), three(words, 8).map(f64::from), 1.0).map(|x| x as f32);
    let (position, velocity) = (three(words, 11), three(words, 14));
    let start = Seen { attitude: [w, x, y, z], spin, position, velocity };
    Body { mass, moments: three(words, 1), start }
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
                let place = if count > 1 { [seen.position, seen.velocity].concat() } else { Vec::new() };
                let row = [f64::from(n) / 60.0].into_iter().chain(attitude).chain(spin);
                let row = row.chain(place.into_iter().map(f64::from)).map(|x| format!("{x:?}"));
                text += &(row.collect::<Vec<_>>().join(",") + "\n");
            }
        }
        world.step();
    }
    text
}

fn timed<E: Engine>(mut new: impl FnMut() -> E, steps: u32, repeats: u32) {
    let time = |_| {
        let mut world = new();
        world.step();
        let start = Instant::now();
        (0..steps).for_each(|_| world.step());
        format!("{:.3}", start.elapsed().as_secs_f64() * 1e6 / f64::from(steps))
    };
    println!("{}", (0..repeats).map(time).collect::<Vec<_>>().join(" "));
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
                head += &format!("# inertia: {a} {b} {c} kg m2\nt,qw,qx,qy,qz,wx,wy,wz\n");
                record(&mut E::bodies(&[body(&numbers)], None), 1, steps, every)
            }
            "wheel" => {
                let both = [body(&numbers[3..20]), body(&numbers[20..])];
                record(&mut E::bodies(&both, Some(three(&numbers, 0))), 2, steps, every)
            }
            "top" => {
                record(&mut E::top(body(&numbers[4..]), three(&numbers, 0), numbers[3]), 1, steps, every)
            }
            "stack" => {
                let count = numbers[0] as usize;
                record(&mut E::stack(count, three(&numbers, 1)), count, steps, every)
            }
            "time-stack" => {
                timed(|| E::stack(numbers[0] as usize, three(&numbers, 1)), steps, every);
                continue;
            }
            "time-crowd" => {
                let one = body(&numbers[1..]);
                let of = |i: usize| {
                    let spin = one.start.spin.map(|x| x * (1.0 + 0.001 * (i % 100) as f32));
                    Body { start: Seen { spin, position: [3.0 * i as f32, 0.0, 0.0], ..one.start }, ..one }
                };
                let crowd: Vec<Body> = (0..numbers[0] as usize).map(of).collect();
                timed(|| E::bodies(&crowd, None), steps, every);
                continue;
            }
            _ => continue,
        };
        std::fs::write(format!("{folder}/{name}.csv"), head + &text)?;
    }
    Ok(())
}
