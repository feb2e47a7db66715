//! A [`Crowd`] is prepared for a number of bodies and then passes: each pass answers (or steps) every body
//! some number of times. Passes of all crowds are taken in turns, and the least time of each counts, with the
//! spread.

use super::Scale;
use nalgebra::{UnitQuaternion, Vector3};
use std::hint::black_box;
use std::ops::ControlFlow;
use std::sync::atomic::{AtomicU64, Ordering};
use std::time::Instant;
use tumbling::exact::Batch;
use tumbling_scenes::batch::{self, Block};
use tumbling_scenes::ensemble::{Chunk, Ensemble, FourLanes, INSTANTS, Solver};
use tumbling_scenes::{InitialState, Outputs, Scene, Times};

/// A body of the crowd: a box of its own proportions, spun and turned in a way of its own, so that the kinds
/// of motion come mixed.
#[must_use]
pub fn body(k: usize) -> InitialState {
    // Multiples of irrational numbers, less their whole parts, fill the unit cube evenly.
    let part = |n: i32| (k as f64 * 0.851_799_642_079_243_f64.powi(n)).fract();
    let sides = [part(1), part(2), part(3)].map(|x| (1.0 + 2.0 * x).powi(2));
    let moments = Vector3::new(sides[1] + sides[2], sides[2] + sides[0], sides[0] + sides[1]) / 12.0;
    let omega = Vector3::new(part(4) - 0.5, part(5) - 0.5, part(6) - 0.5) * 10.0;
    let angles = [part(7), part(8), part(9)].map(|x| 6.0 * x);
    let attitude = UnitQuaternion::from_euler_angles(angles[0], angles[1], angles[2]);
    InitialState { attitude, ..InitialState::spinning(moments, omega) }
}

/// What is measured: a name, lanes, threads, instants in a pass, and how to prepare a pass over a number
/// of bodies.
pub struct Crowd<'a> {
    /// Who.
    pub name: &'static str,
    /// Numbers side by side.
    pub lanes: u32,
    /// Threads.
    pub threads: u32,
    /// Instants (or steps) of each body in a pass.
    pub instants: usize,
    /// The largest number of bodies that is measured.
    pub most: usize,
    /// Prepares it for a number of bodies.
    pub prepare: Prepare<'a>,
}

/// Prepares a crowd of a number of bodies.
pub type Prepare<'a> = Box<dyn Fn(usize) -> Ready<'a> + 'a>;

/// Prepared.
pub struct Ready<'a> {
    /// A pass over all bodies, `k` the number of the pass.
    pub pass: Box<dyn FnMut(u32) + 'a>,
    /// Bytes that all bodies hold together, if known.
    pub bytes: Option<usize>,
}

impl std::fmt::Debug for Crowd<'_> {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "{} in {} lanes on {} threads", self.name, self.lanes, self.threads)
    }
}

impl std::fmt::Debug for Ready<'_> {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "ready, {:?} bytes", self.bytes)
    }
}

/// Something of an answer, so that none goes unused.
trait Digest {
    fn digest(&self) -> f64;
}

impl Digest for tumbling::exact::Instant {
    fn digest(&self) -> f64 {
        self.attitude.w
    }
}

impl Digest for Vector3<f64> {
    fn digest(&self) -> f64 {
        self.x
    }
}

/// The exact motion, prepared as `W` and evaluated at `instants` times in a pass; `run` drives it.
fn ready<'a, W: Solver + 'a>(bodies: usize, instants: usize, run: &'a Run<'a>) -> Ready<'a>
where
    W::Answer: Digest,
{
    let ensemble = Ensemble::<W>::prepare(bodies, body, |_| {});
    let bytes = ensemble.bytes();
    let pass = move |k: u32| {
        let times: Vec<f64> = (0..instants).map(|n| 1.0 + 0.37 * n as f64 + f64::from(k)).collect();
        let digest = AtomicU64::new(0);
        let put = |chunk: Chunk<'_, W::Answer>| {
            let last = chunk.answers.last().map_or(0.0, Digest::digest);
            digest.fetch_xor(black_box(last).to_bits(), Ordering::Relaxed);
        };
        let times = black_box(times);
        run(&mut || drop(ensemble.each(&times, |_| {}, put)));
        black_box(digest.into_inner());
    };
    Ready { pass: Box::new(pass), bytes: Some(bytes) }
}

/// A scene of as many bodies, planned and answered anew in each pass.
fn scene<'a>(bodies: usize, instants: usize, run: &'a Run<'a>) -> Ready<'a> {
    let states: Vec<InitialState> = (0..bodies).map(body).collect();
    let outputs = Outputs { spin: true, attitude: true, ..Outputs::NOTHING };
    let pass = move |k: u32| {
        let times = (0..instants).map(|n| 1.0 + 0.37 * n as f64 + f64::from(k)).collect();
        let scene = Scene::new(states.iter().copied(), Vec::new(), Times::Given(times), outputs, 1e-9);
        let digest = |block: &Block<'_>| {
            black_box(block.answers.last().copied().flatten());
        };
        run(&mut || {
            if let Ok(scene) = &scene {
                batch::run(scene, digest, |()| ControlFlow::Continue(()));
            }
        });
    };
    Ready { pass: Box::new(pass), bytes: None }
}

/// How a pass is run: on which threads.
pub type Run<'r> = dyn Fn(&mut (dyn FnMut() + Send)) + Sync + 'r;

/// The library's own: `one` sees a pass through on one thread, `two` on two.
#[must_use]
pub fn ours<'a>(one: &'a Run<'a>, two: Option<&'a Run<'a>>) -> Vec<Crowd<'a>> {
    const MOST: usize = 10_000_000;
    type Instants = Batch<FourLanes>;
    let mut all = vec![
        Crowd {
            name: "spin and attitude",
            lanes: 4,
            threads: 1,
            instants: INSTANTS,
            most: MOST,
            prepare: Box::new(move |n| ready::<Instants>(n, INSTANTS, one)),
        },
        Crowd {
            name: "spin and attitude",
            lanes: 1,
            threads: 1,
            instants: INSTANTS,
            most: MOST / 10,
            prepare: Box::new(move |n| ready::<Batch<f64>>(n, INSTANTS, one)),
        },
        Crowd {
            name: "spin",
            lanes: 4,
            threads: 1,
            instants: INSTANTS,
            most: MOST,
            prepare: Box::new(move |n| ready::<Batch<FourLanes, Vector3<f64>>>(n, INSTANTS, one)),
        },
        Crowd {
            name: "spin",
            lanes: 1,
            threads: 1,
            instants: INSTANTS,
            most: MOST / 10,
            prepare: Box::new(move |n| ready::<Batch<f64, Vector3<f64>>>(n, INSTANTS, one)),
        },
        Crowd {
            name: "spin and attitude once",
            lanes: 4,
            threads: 1,
            instants: 1,
            most: MOST,
            prepare: Box::new(move |n| ready::<Instants>(n, 1, one)),
        },
        Crowd {
            name: "scene",
            lanes: 4,
            threads: 1,
            instants: INSTANTS,
            most: MOST / 10,
            prepare: Box::new(move |n| scene(n, INSTANTS, one)),
        },
    ];
    if let Some(two) = two {
        let both = |instants: usize, name: &'static str| Crowd {
            name,
            lanes: 4,
            threads: 2,
            instants,
            most: MOST,
            prepare: Box::new(move |n| ready::<Instants>(n, instants, two)) as Prepare<'a>,
        };
        all.push(both(INSTANTS, "spin and attitude"));
        all.push(both(1, "spin and attitude once"));
    }
    all
}

/// How much to do.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Effort {
    /// The most bodies.
    pub most: usize,
    /// How often each pass is taken.
    pub repeats: u32,
    /// The least time to take, s: shorter passes are made several times over.
    pub least: f64,
    /// From this number of bodies on crowds are prepared one after the other, for they would not fit the
    /// memory together.
    pub together: usize,
}

impl Effort {
    /// For the record: some minutes.
    pub const FULL: Self = Self { most: 10_000_000, repeats: 9, least: 5e-3, together: 1_000_000 };
    /// For a look.
    pub const QUICK: Self = Self { most: 100_000, repeats: 3, least: 1e-3, together: 1_000_000 };
}

/// One that is being measured.
struct Runner<'a, 'b> {
    crowd: &'b Crowd<'a>,
    ready: Ready<'a>,
    inner: u32,
    count: u32,
    times: Vec<f64>,
    preparing: f64,
}

impl Runner<'_, '_> {
    fn time(&mut self) -> f64 {
        let start = Instant::now();
        for _ in 0..self.inner {
            (self.ready.pass)(self.count % 1000);
            self.count += 1;
        }
        start.elapsed().as_secs_f64() / f64::from(self.inner)
    }
}

/// All crowds at every number of bodies, from a hundred up by tens. `tell` hears how far it is.
pub fn measure(build: &str, crowds: &[Crowd<'_>], effort: Effort, tell: &mut dyn FnMut(&str)) -> Vec<Scale> {
    let mut rows = Vec::new();
    let mut bodies = 100;
    while bodies <= effort.most {
        let these: Vec<&Crowd<'_>> = crowds.iter().filter(|crowd| bodies <= crowd.most).collect();
        let group = if bodies < effort.together { these.len().max(1) } else { 1 };
        for some in these.chunks(group) {
            tell(&format!("{build} build, {bodies} bodies: {:?}", some.first()));
            rows.extend(in_turns(build, some, bodies, effort));
        }
        bodies *= 10;
    }
    rows
}

fn in_turns(build: &str, crowds: &[&Crowd<'_>], bodies: usize, effort: Effort) -> Vec<Scale> {
    let mut runners: Vec<_> = crowds
        .iter()
        .map(|crowd| {
            let start = Instant::now();
            let ready = (crowd.prepare)(bodies);
            let preparing = start.elapsed().as_secs_f64() / bodies as f64;
            let mut runner = Runner { crowd, ready, inner: 1, count: 0, times: Vec::new(), preparing };
            let once = runner.time().max(1e-9);
            let inner = (effort.least / once).ceil() as u32;
            runner.inner = inner.max(1);
            runner
        })
        .collect();
    for _ in 0..effort.repeats {
        for runner in &mut runners {
            let time = runner.time();
            runner.times.push(time);
        }
    }
    runners
        .into_iter()
        .map(|runner| {
            let least = runner.times.iter().copied().fold(f64::INFINITY, f64::min);
            let longest = runner.times.iter().copied().fold(0.0, f64::max);
            let Crowd { name, lanes, threads, instants, .. } = *runner.crowd;
            Scale {
                build: build.to_owned(),
                crowd: name.to_owned(),
                lanes,
                threads,
                bodies: bodies as u64,
                instants: u32::try_from(instants).unwrap_or(u32::MAX),
                seconds: least,
                spread: longest / least,
                bytes: runner.ready.bytes.map(|bytes| bytes as f64 / bodies as f64),
                preparing: Some(runner.preparing),
            }
        })
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn bodies_of_the_crowd_are_possible_and_of_both_kinds_of_circulation() {
        let mut kinds = [0, 0];
        for k in 1..2000 {
            let motion = body(k).motion().unwrap();
            if let tumbling::exact::Regime::Elliptic { about, .. } = motion.regime() {
                kinds[usize::from(about == tumbling::Axis::Largest)] += 1;
            }
        }
        assert!(kinds[0] > 500 && kinds[1] > 500, "{kinds:?}");
    }
}
