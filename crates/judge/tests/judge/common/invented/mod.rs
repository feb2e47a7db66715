//! Records invented from a seed, each of one rule in one body, layout and precision, perhaps with a fault;
//! and whether the judge says what made it.

mod graded;
mod rules;

pub use graded::counted;

use nalgebra::{Quaternion, UnitQuaternion, Vector3};
use rules::{BY_THE_NEW, IN_TURN, OUTSIDE, Spin, altered, known, outside};
use tumbling::attitude::{product, rotation_matrix, turn};
use tumbling::step::Method;
use tumbling_judge::{Base, PHYSICS_ENGINES, Steps, Turn, When};

/// An attitude, body to world, and a spin in body axes, rad/s.
type Motion = (Quaternion<f64>, Vector3<f64>);
type Step = Box<dyn Fn(&Motion, f64) -> Option<Motion>>;

/// Numbers by chance, the same for the same seed: Steele, Lea and Flood's SplitMix64.
pub struct Chance(pub u64);

impl Chance {
    pub fn share(&mut self) -> f64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        ((z ^ (z >> 31)) >> 11) as f64 / (1_u64 << 53) as f64
    }

    pub fn below(&mut self, most: usize) -> usize {
        ((self.share() * most as f64) as usize).min(most - 1)
    }

    fn of<T: Copy>(&mut self, all: &[T]) -> T {
        all[self.below(all.len())]
    }

    fn between(&mut self, least: f64, most: f64) -> f64 {
        least * (most / least).powf(self.share())
    }

    pub fn vector(&mut self) -> Vector3<f64> {
        Vector3::from_fn(|_, _| self.share() * 2.0 - 1.0)
    }
}

/// What is wrong besides the rule.
#[derive(Debug, Clone, Copy, PartialEq)]
enum Fault {
    None,
    Damped(f64, When),
    Term(f64),
    Turned(Turn),
    /// The times are written this many times too long.
    Paced(f64),
    /// Of the body with these moments, about axes turned from the record's by this angle in degrees.
    Other(Vector3<f64>, f64),
    Hits(usize),
    Rest,
    Interpolated,
}

/// The rule that made a record: one that the judge may name, or none that it knows.
#[derive(Clone, Copy)]
enum Truth {
    Known(Base),
    Outside(&'static str, Spin),
}

#[derive(Debug, Clone, Copy, PartialEq)]
enum Layout {
    Both,
    World,
    Spin,
    Attitude,
}

/// How the numbers are kept and written.
#[derive(Debug, Clone, Copy, PartialEq)]
enum Digits {
    Double,
    Single,
    /// Attitude and spin in the world in single precision, the spin turned to the body in double.
    Converted,
    Decimal(usize),
}

/// A record, and what is true of it.
struct Invented {
    text: String,
    what: String,
    truth: Truth,
    fault: Fault,
    every: u32,
    layout: Layout,
    /// The moments, the rows before they are written, and the time from row to row.
    body: Vector3<f64>,
    rows: Vec<Motion>,
    between: f64,
}

fn single(x: f64) -> f64 {
    f64::from(x as f32)
}

/// The moments of a body, now and then of a flat or a symmetric one.
fn body(chance: &mut Chance) -> Vector3<f64> {
    let mut squares = Vector3::from_fn(|_, _| chance.between(0.1, 1.0));
    match chance.below(12) {
        0 => squares[chance.below(3)] = 0.0,
        1 => squares.x = squares.y,
        _ => {}
    }
    let moments = Vector3::new(squares.y + squares.z, squares.z + squares.x, squares.x + squares.y);
    if chance.below(5) == 0 { moments * chance.between(1e-6, 1e6) } else { moments }
}

/// Six bodies that are mistaken for others, two of them flat.
const MISTAKEN: [[f64; 3]; 6] =
    [[1.0, 2.0, 3.0], [1.0, 2.0, 2.5], [2.0, 1.0, 3.0], [1.0, 1.7, 2.3], [0.2, 1.0, 1.1], [3.0, 2.5, 1.0]];

/// Whether a rule keeps the spin as it is in the body.
fn is_still(base: Base) -> bool {
    match base {
        Base::Straight(method, _) | Base::Method(method, _) => method == Method::ConstantSpin,
        Base::Engine(engine) => engine.method == Method::ConstantSpin,
        other => matches!(other, Base::MomentumForSpin(_)),
    }
}

/// A fault that shows in the columns.
fn fault(chance: &mut Chance, base: Base, layout: Layout) -> Fault {
    let (still, both) = (is_still(base), matches!(layout, Layout::Both | Layout::World));
    let by_new = matches!(base, Base::Method(method, 1) if BY_THE_NEW.contains(&method));
    let stage = base == Base::PositionStage(1);
    match chance.below(20) {
        8 | 9 => {
            let when = chance.of(&[When::Before, When::After, When::Turned]);
            let when = if when == When::After && !by_new { When::Turned } else { when };
            Fault::Damped(chance.of(&[0.01, 0.05, 0.1, 0.25, 0.5]), when)
        }
        10 | 11 if by_new && !still => Fault::Term(chance.of(&[0.5, -1.0, 2.0])),
        12 if by_new && both && !still => Fault::Turned(Turn::Old),
        13 if both && !still => Fault::Turned(Turn::Late),
        14 | 15 if !still && !matches!(base, Base::FrozenTensor(..)) => {
            let (moments, degrees) = (chance.of(&MISTAKEN), chance.of(&[0.0, 1.0, 5.0, 10.0, 30.0]));
            // The header may name these.
            let same = degrees == 0.0 && moments == [1.0, 2.0, 2.5];
            Fault::Other(moments.into(), if same { 5.0 } else { degrees })
        }
        16 => Fault::Hits(1 + chance.below(3)),
        17 => Fault::Rest,
        18 if !still => Fault::Interpolated,
        19 if still && both => Fault::Paced(chance.of(&[0.5, 2.0])),
        19 if !still => match chance.below(9) {
            0 if both => Fault::Turned(Turn::Early),
            1 if both && by_new => Fault::Turned(Turn::BodyInWorld),
            2 if both && by_new => Fault::Turned(Turn::WorldInBody),
            3 if both && (by_new || stage) => {
                Fault::Turned(chance.of(&[Turn::TwiceBefore, Turn::TwiceAfter]))
            }
            4 if both && stage => Fault::Turned(Turn::Own),
            _ => Fault::Paced(chance.of(&[0.2, 0.5, 2.0, 5.0, 1.0 / 3.0, 1.2])),
        },
        _ => Fault::None,
    }
}

fn base(chance: &mut Chance, first: Quaternion<f64>, moments: &Vector3<f64>) -> Base {
    match chance.below(12) {
        0 => Base::Exact,
        1 => Base::PositionStage(1),
        2 => Base::Straight(chance.of(&[Method::ConstantSpin, Method::SemiImplicitEuler]), 1),
        3 if chance.below(2) == 0 => Base::FrozenTensor(first, Steps::First),
        3 => Base::MomentumForSpin(moments.sum() / 3.0),
        4..=7 => Base::Engine(chance.of(PHYSICS_ENGINES)),
        _ => Base::Method(chance.of(Method::ALL), 1),
    }
}

impl Invented {
    /// The record of a seed: of a rule that the judge knows, or of one that it does not.
    fn of(seed: u64, is_known: bool) -> Self {
        let mut chance = Chance(seed.wrapping_mul(2) + u64::from(is_known));
        let mut named = body(&mut chance);
        let first = if chance.below(2) == 0 { Quaternion::identity() } else { turn(&chance.vector()) };
        let h = chance.of(&[1.0 / 30.0, 1.0 / 60.0, 1.0 / 120.0, 1.0 / 240.0, 0.01, 0.005, 1e-3]);
        let truth = if is_known {
            Truth::Known(base(&mut chance, first, &named))
        } else {
            let (name, rule) = chance.of(&OUTSIDE);
            Truth::Outside(name, rule)
        };
        let layout = chance.of(&[Layout::Both, Layout::Both, Layout::World, Layout::Spin, Layout::Attitude]);
        let fault = match truth {
            Truth::Known(base) => fault(&mut chance, base, layout),
            Truth::Outside(..) => Fault::None,
        };
        let moments = if let Fault::Other(moments, _) = fault {
            // The named ones are some ten or twenty per cent off, and those of a body.
            let off = moments.map(|x| x * (1.0 + 0.15 * chance.share()));
            named = if chance.below(2) == 0 { Vector3::new(1.0, 2.0, 2.5) } else { off };
            if 2.0 * named.max() > named.sum() {
                named = Vector3::new(2.0, 2.2, 1.7);
            }
            moments
        } else {
            named
        };
        let step = match truth {
            Truth::Known(base) => altered(known(base, moments), fault),
            Truth::Outside(_, rule) => outside(rule, moments),
        };
        let digits = match chance.below(10) {
            0..=3 => Digits::Double,
            4 | 5 => Digits::Single,
            6 => Digits::Converted,
            _ => Digits::Decimal(chance.of(&[5, 6, 7, 9, 11])),
        };
        let alone = fault == Fault::None;
        let in_turn = matches!(truth, Truth::Outside(IN_TURN, _));
        let every = match fault {
            // The rows that are left out are not counted.
            Fault::Paced(times) if times < 1.0 && chance.below(2) == 0 => (1.0 / times).round() as u32,
            _ if alone && !in_turn && chance.below(3) == 0 => chance.of(&[2, 3, 4, 5, 10]),
            _ => 1,
        };
        let speed = chance.between(0.02, 0.7) / h;
        let mut spin = chance.vector();
        if chance.below(3) == 0 {
            spin[chance.below(3)] *= 20.0;
        }
        let (text, what) = Default::default();
        let (rows, between) = (Vec::new(), h * f64::from(every));
        let mut invented = Self { text, what, truth, fault, every, layout, body: moments, rows, between };
        let start = (first, spin.normalize() * speed.min(60.0));
        invented.rows = invented.rows(&mut chance, step, start, h, digits);
        invented.write(&mut chance, &named, h, digits);
        invented
    }

    /// The rows, each a step of `h` seconds after the last.
    fn rows(&self, chance: &mut Chance, step: Step, start: Motion, h: f64, digits: Digits) -> Vec<Motion> {
        let kept = |(q, w): Motion| match digits {
            Digits::Double | Digits::Decimal(_) => (q, w),
            Digits::Single => (Quaternion::from_vector(q.coords.map(single)), w.map(single)),
            Digits::Converted => {
                let q = Quaternion::from_vector(q.coords.map(single));
                let world = (rotation_matrix(&q) * w / q.norm_squared()).map(single);
                (q, rotation_matrix(&q).tr_mul(&world) / q.norm_squared())
            }
        };
        let axes = match self.fault {
            Fault::Other(_, degrees) => turn(&(Vector3::new(0.48, 0.6, 0.64) * degrees.to_radians())),
            _ => Quaternion::identity(),
        };
        let count = 200 + chance.below(200);
        let hits: Vec<usize> = match self.fault {
            Fault::Hits(hits) => (1..=hits).map(|i| count * i / (hits + 1)).collect(),
            _ => Vec::new(),
        };
        let (mut now, mut all) = (kept(start), Vec::new());
        for i in 0..count * self.every as usize {
            if i.is_multiple_of(self.every as usize) {
                all.push((product(&now.0, &axes), rotation_matrix(&axes).tr_mul(&now.1)));
            }
            if hits.contains(&i) {
                now.1 += chance.vector() * (0.3 * now.1.norm());
            }
            // What leaves the numbers, or a step that is refused, ends the record.
            let Some(next) = step(&now, h).filter(|next| next.1.norm() < 1e3 * start.1.norm()) else { break };
            now = kept(next);
        }
        match self.fault {
            Fault::Turned(Turn::Late) => {
                let late = all.windows(2).map(|two| (two[1].0, two[0].1)).collect();
                all = late;
            }
            Fault::Turned(Turn::Early) => {
                let early = all.windows(2).map(|two| (two[0].0, two[1].1)).collect();
                all = early;
            }
            Fault::Rest => {
                let rest = std::iter::repeat_n((start.0, Vector3::zeros()), 20);
                all = rest.chain(all).collect();
            }
            Fault::Interpolated => {
                let at = |i: usize| {
                    let (place, share) = ((i as f64 * 0.4) as usize, (i as f64 * 0.4).fract());
                    let [a, b] = [all[place], all[place + 1]];
                    let q =
                        UnitQuaternion::new_normalize(a.0).slerp(&UnitQuaternion::new_normalize(b.0), share);
                    (q.into_inner(), a.1 * (1.0 - share) + b.1 * share)
                };
                all = (0..all.len().saturating_sub(2) * 2).map(at).collect();
            }
            _ => {}
        }
        all
    }

    fn write(&mut self, chance: &mut Chance, moments: &Vector3<f64>, h: f64, digits: Digits) {
        let written = match self.fault {
            Fault::Interpolated => 0.4,
            Fault::Paced(times) => times,
            _ => 1.0,
        };
        let between = h * f64::from(self.every) * written;
        let short = self.every == 1 && h >= 0.01 && self.fault != Fault::Interpolated && chance.below(6) == 0;
        let [x, y, z] = (*moments).into();
        self.text = format!("# inertia: {x:e} {y:e} {z:e}\n");
        if self.every > 1 && chance.below(2) == 0 {
            self.text += &format!("# dt: {h:e}\n");
        }
        // The columns of an attitude, and those of a spin.
        let (names, places) = match self.layout {
            Layout::Both => ("t,qw,qx,qy,qz,wx,wy,wz", 0..7),
            Layout::World => ("t,qw,qx,qy,qz,wxw,wyw,wzw", 0..7),
            Layout::Spin => ("t,wx,wy,wz", 4..7),
            Layout::Attitude => ("t,qw,qx,qy,qz", 0..4),
        };
        let decimals = match digits {
            Digits::Double => 16,
            Digits::Single | Digits::Converted => 8,
            Digits::Decimal(digits) => digits - 1,
        };
        self.text += names;
        for (i, (q, w)) in self.rows.iter().enumerate() {
            let t = i as f64 * between;
            self.text += &if short { format!("\n{t:.2}") } else { format!("\n{t:e}") };
            let world = rotation_matrix(q) * w / q.norm_squared();
            let v = if self.layout == Layout::World { world } else { *w };
            for x in &[q.w, q.i, q.j, q.k, v.x, v.y, v.z][places.clone()] {
                self.text += &format!(",{x:.decimals$e}");
            }
        }
        self.text.push('\n');
        let rule = match self.truth {
            Truth::Known(base) => base.name(),
            Truth::Outside(name, _) => name.into(),
        };
        let step = if short { " (two decimals)" } else { "" };
        let (fault, every, speed) =
            (self.fault, self.every, self.rows.first().map_or(0.0, |row| row.1.norm()));
        self.what =
            format!("{rule}; {fault:?}; {names}; {digits:?}; every {every}; h {h:.5}{step}; |w| {speed:.2}");
    }
}
