//! Records invented from a seed, each of one rule in one body, layout and precision, perhaps with a fault;
//! and whether the judge says what made it.

use nalgebra::{Quaternion, UnitQuaternion, Vector3};
use std::io;
use tumbling::attitude::{product, rotation_matrix, turn};
use tumbling::dynamics::euler::angular_acceleration;
use tumbling::exact::FreeMotion;
use tumbling::step::{Method, PositionStage, State, System};
use tumbling_judge::{
    Alteration, Base, Confidence, Diagnosis, FileMistake, Options, Outcome, PHYSICS_ENGINES, Rule, Steps,
    Turn, Verdict, When, judge,
};

/// An attitude, body to world, and a spin in body axes, rad/s.
type Motion = (Quaternion<f64>, Vector3<f64>);
type Step = Box<dyn Fn(&Motion, f64) -> Option<Motion>>;

/// Numbers by chance, the same for the same seed: Steele, Lea and Flood's SplitMix64.
struct Chance(u64);

impl Chance {
    fn share(&mut self) -> f64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        ((z ^ (z >> 31)) >> 11) as f64 / (1_u64 << 53) as f64
    }

    fn below(&mut self, most: usize) -> usize {
        ((self.share() * most as f64) as usize).min(most - 1)
    }

    fn of<T: Copy>(&mut self, all: &[T]) -> T {
        all[self.below(all.len())]
    }

    fn between(&mut self, least: f64, most: f64) -> f64 {
        least * (most / least).powf(self.share())
    }

    fn vector(&mut self) -> Vector3<f64> {
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

/// What the judge makes of it.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Named {
    /// The rule, first.
    Rightly,
    /// The rule, among those that make the same steps here; or the exact motion, from which it differs by
    /// less than rounding.
    AmongEquals,
    /// No rule.
    Not,
    /// Another rule.
    Wrongly,
}

fn single(x: f64) -> f64 {
    f64::from(x as f32)
}

fn rate(moments: &Vector3<f64>, omega: &Vector3<f64>) -> Vector3<f64> {
    angular_acceleration(moments, omega, &Vector3::zeros())
}

fn turned(q: &Quaternion<f64>, omega: &Vector3<f64>, h: f64) -> Quaternion<f64> {
    product(q, &turn(&(omega * h)))
}

/// A rule that the judge knows, for a body with these moments.
fn known(base: Base, moments: Vector3<f64>) -> Step {
    let system = System::free(moments.try_into().unwrap()).unwrap();
    let stage = PositionStage::new(&moments).unwrap();
    Box::new(move |(q, omega), h| {
        let start = State { attitude: *q, momentum: system.momentum(omega) };
        let end = |state: State<f64>| (state.attitude, system.omega(&state.momentum));
        match base {
            Base::Exact => {
                let end = FreeMotion::new(moments.try_into().ok()?, omega).ok()?.at(h).ok()?;
                Some((product(q, &end.attitude), end.omega))
            }
            Base::Method(method, _) => method.step(&system, &start, h).ok().map(end),
            Base::Engine(engine) => engine.step(&system, &start, h).ok().map(end),
            Base::PositionStage(_) => {
                let end = stage.step(q, &(rotation_matrix(q) * omega), h);
                (end.parts > 0).then(|| (end.attitude, rotation_matrix(&end.attitude).tr_mul(&end.omega)))
            }
            Base::Straight(method, _) => {
                let mut engines = PHYSICS_ENGINES.iter().filter(|engine| engine.limits.straight);
                engines.find(|engine| engine.method == method)?.step(&system, &start, h).ok().map(end)
            }
            Base::FrozenTensor(first, _) => {
                let spin = first.conjugate() * (q * Quaternion::from_imag(*omega) * q.conjugate()) * first;
                let spin = spin.imag() + rate(&moments, &spin.imag()) * h;
                let world = rotation_matrix(&first) * spin;
                let q = product(&turn(&(world * h)), q);
                Some((q, rotation_matrix(&q).tr_mul(&world)))
            }
            Base::MomentumForSpin(mass) => {
                let (inside, world) = (start.momentum, rotation_matrix(q) * start.momentum);
                let q = turned(q, &(inside / mass), h);
                Some((q, system.omega(&rotation_matrix(&q).tr_mul(&world))))
            }
            _ => None,
        }
    })
}

/// A step of a rule that the judge does not know.
struct Unknown<'a> {
    moments: &'a Vector3<f64>,
    w: Vector3<f64>,
    h: f64,
    /// Of the steps before: how many, the first speed, and the last term.
    past: &'a mut (u32, f64, Vector3<f64>),
    /// What turns the body, where that is not the new spin.
    by: Option<Vector3<f64>>,
}

/// The spin at its end.
type Spin = fn(&mut Unknown<'_>) -> Option<Vector3<f64>>;

impl Unknown<'_> {
    fn f(&self, w: Vector3<f64>) -> Vector3<f64> {
        rate(self.moments, &w)
    }

    fn explicit(&self) -> Vector3<f64> {
        self.w + self.f(self.w) * self.h
    }

    fn exact(&self) -> Option<Vector3<f64>> {
        FreeMotion::new((*self.moments).try_into().ok()?, &self.w).ok()?.omega(self.h).ok()
    }

    fn energy(&self, w: &Vector3<f64>) -> f64 {
        w.dot(&self.moments.component_mul(w))
    }

    /// The spin at the end, where the mean of both turns the body.
    fn by_mean(&mut self, end: Vector3<f64>) -> Option<Vector3<f64>> {
        self.by = Some((self.w + end) / 2.0);
        Some(end)
    }
}

const OUTSIDE: [(&str, Spin); 12] = [
    ("Heun, the mean spin turns", |s| s.by_mean(s.w + (s.f(s.w) + s.f(s.explicit())) * (s.h / 2.0))),
    ("Kutta's third order, the new spin turns", |s| {
        let a = s.f(s.w);
        let b = s.f(s.w + a * (s.h / 2.0));
        Some(s.w + (a + b * 4.0 + s.f(s.w + (b * 2.0 - a) * s.h)) * (s.h / 6.0))
    }),
    ("the exact spin, the new one turns", |s| s.exact()),
    ("two rounds of the midpoint rule", |s| s.by_mean(s.w + s.f((s.w + s.explicit()) / 2.0) * s.h)),
    ("explicit, energy and momentum put right", |s| {
        // Two of the squares of the spin's components are solved for, the third is kept.
        let (mut end, [a, b, c]) = (s.explicit(), (*s.moments).into());
        let (e, l) = (s.energy(&s.w), s.moments.component_mul(&s.w).norm_squared());
        let (e, l) = (e - a * end.x * end.x, l - a * a * end.x * end.x);
        let (y, z) = ((c * e - l) / (b * (c - b)), (l - b * e) / (c * (c - b)));
        if y > 0.0 && z > 0.0 && y.is_finite() && z.is_finite() {
            (end.y, end.z) = (y.sqrt().copysign(end.y), z.sqrt().copysign(end.z));
        }
        Some(end)
    }),
    ("explicit, energy put right", |s| {
        Some(s.explicit() * (s.energy(&s.w) / s.energy(&s.explicit())).sqrt())
    }),
    ("drag of the square of the speed", |s| Some(s.exact()? * (1.0 - 0.02 * s.h * s.w.norm()))),
    ("damping about one axis", |s| {
        Some(s.explicit().component_mul(&Vector3::new(1.0 - 0.05 * s.h, 1.0, 1.0)))
    }),
    ("friction of one size", |s| {
        Some(s.explicit() * (1.0 - (0.02 * s.past.1 * s.h / s.explicit().norm()).min(1.0)))
    }),
    ("momentum in the world, the old tensor", |s| {
        s.by = Some(s.w);
        let after = rotation_matrix(&turn(&(s.w * s.h))).tr_mul(&s.moments.component_mul(&s.w));
        Some(after.component_div(s.moments))
    }),
    (IN_TURN, |s| Some(if s.past.0 % 2 == 1 { s.explicit() } else { s.w })),
    ("Adams and Bashforth, the new spin turns", |s| Some(s.w + (s.f(s.w) * 1.5 - s.past.2 * 0.5) * s.h)),
];

/// Of which two steps are one, of half of the term.
const IN_TURN: &str = "every second step without the term";

/// A rule that the judge does not know.
fn outside(rule: Spin, moments: Vector3<f64>) -> Step {
    let past = std::cell::Cell::new((0, 0.0, Vector3::zeros()));
    Box::new(move |(q, w), h| {
        let (count, speed, term) = past.get();
        let now = rate(&moments, w);
        let mut before = if count == 0 { (1, w.norm(), now) } else { (count + 1, speed, term) };
        past.set((before.0, before.1, now));
        let mut step = Unknown { moments: &moments, w: *w, h, past: &mut before, by: None };
        let end = rule(&mut step)?;
        Some((turned(q, &step.by.unwrap_or(end), h), end))
    })
}

/// Of which the new spin turns the body, so that it may be altered before it does.
const BY_THE_NEW: [Method; 5] = [
    Method::SemiImplicitEuler,
    Method::Rescaled,
    Method::ImplicitOneNewton,
    Method::LinearisedImplicit,
    Method::ConstantSpin,
];

/// A rule with a fault.
fn altered(step: Step, fault: Fault) -> Step {
    Box::new(move |(q, w), h| match fault {
        Fault::Damped(rate, When::Before) => step(&(*q, w * (1.0 - rate * h)), h),
        Fault::Damped(rate, When::After) => {
            let w = step(&(*q, *w), h)?.1 * (1.0 - rate * h);
            Some((turned(q, &w, h), w))
        }
        Fault::Damped(rate, When::Turned) => step(&(*q, *w), h).map(|(q, w)| (q, w * (1.0 - rate * h))),
        Fault::Term(times) => {
            let w = step(&(*q, *w), h * times)?.1;
            Some((turned(q, &w, h), w))
        }
        Fault::Turned(Turn::Old) => Some((turned(q, w, h), step(&(*q, *w), h)?.1)),
        Fault::Turned(Turn::BodyInWorld) => {
            let w = step(&(*q, *w), h)?.1;
            Some((product(&turn(&(w * h)), q), w))
        }
        Fault::Turned(Turn::WorldInBody) => {
            let world = rotation_matrix(q) * step(&(*q, *w), h)?.1;
            let q = turned(q, &world, h);
            Some((q, rotation_matrix(&q).tr_mul(&world)))
        }
        Fault::Turned(Turn::TwiceBefore) => step(&(turned(q, w, h), *w), h),
        Fault::Turned(Turn::TwiceAfter) => step(&(*q, *w), h).map(|(q, w)| (turned(&q, &w, h), w)),
        Fault::Turned(Turn::Own) => {
            let (end, w) = step(&(*q, *w), h)?;
            let w = rotation_matrix(q).tr_mul(&(rotation_matrix(&end) * w));
            Some((turned(q, &w, h), w))
        }
        _ => step(&(*q, *w), h),
    })
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

    /// Whether a rule is the one that made it.
    fn is(&self, rule: &Rule) -> bool {
        matches!(self.truth, Truth::Known(base) if self.is_as_said(rule) && self.is_base(base, rule))
    }

    /// Whether the fault is the one that was made.
    fn is_as_said(&self, rule: &Rule) -> bool {
        let near = |a: f64, b: f64| (a / b - 1.0).abs() < 1e-2;
        match (self.fault, rule.alteration) {
            (Fault::Damped(wanted, place), Some(Alteration::Damped { rate, when, .. })) => {
                near(rate, wanted) && (when == When::Open || when == place)
            }
            (Fault::Term(wanted), Some(Alteration::Term(times) | Alteration::TermOrTimes(times))) => {
                near(times, wanted)
            }
            // It is said of both.
            (
                Fault::Turned(Turn::TwiceBefore | Turn::TwiceAfter),
                Some(Alteration::Turned(Turn::TwiceBefore | Turn::TwiceAfter)),
            ) => true,
            (Fault::Turned(wanted), Some(Alteration::Turned(turn))) => turn == wanted,
            (Fault::Other(wanted, degrees), Some(Alteration::OtherMoments(moments, axes))) => {
                (moments / moments.sum() - wanted / wanted.sum()).norm() < 1e-2
                    && (axes.angle().to_degrees() - degrees).abs() < 1.0
            }
            // A spin that does not change, or is written alone, hides which of its values turned the body.
            (Fault::Turned(_), None) => self.layout == Layout::Spin,
            (Fault::Paced(times), found) if self.layout == Layout::Spin => {
                matches!(found, Some(Alteration::TermOrTimes(found)) if near(found * times, 1.0))
            }
            (Fault::Paced(times), Some(Alteration::Times(found))) => near(found * times, 1.0),
            (Fault::None | Fault::Hits(_) | Fault::Rest | Fault::Paced(_), None) => true,
            _ => false,
        }
    }

    fn is_base(&self, base: Base, rule: &Rule) -> bool {
        let plain = match base {
            Base::Engine(engine) if engine.limits.straight => Base::Straight(engine.method, engine.parts),
            Base::Engine(engine) => Base::Method(engine.method, engine.parts),
            other => other,
        };
        let every = self.every;
        match (plain, rule.base) {
            // A momentum that turns the body turns it about itself, and the spin in the body stays.
            _ if is_still(base) && !matches!(self.layout, Layout::Both | Layout::World) => {
                is_still(rule.base)
            }
            (_, Base::Engine(found)) => matches!(plain, Base::Method(m, _) if m == found.method),
            (Base::Exact, Base::Exact) | (Base::FrozenTensor(..), Base::FrozenTensor(..)) => true,
            (Base::MomentumForSpin(_), Base::MomentumForSpin(_)) => true,
            (Base::Method(..), Base::Method(..)) if is_still(plain) && is_still(rule.base) => true,
            (Base::Method(a, parts), Base::Method(b, found)) => {
                self.spins_alike(a) == self.spins_alike(b) && found == parts * every
            }
            (Base::PositionStage(parts), Base::PositionStage(found)) => found == parts * every,
            (Base::Straight(a, parts), Base::Straight(b, found)) => a == b && found == parts * every,
            _ => false,
        }
    }

    /// Of a record of spins alone the method whose spin is the same.
    fn spins_alike(&self, method: Method) -> Method {
        match method {
            Method::ExplicitEuler if self.layout == Layout::Spin => Method::SemiImplicitEuler,
            Method::RescaledLinearAttitude if self.layout == Layout::Spin => Method::Rescaled,
            other => other,
        }
    }

    /// What the judge made of it.
    fn named(&self, verdict: &Verdict) -> Named {
        let Some(found) = &verdict.diagnosis else { return Named::Not };
        let all = || std::iter::once(&found.best.rule).chain(&found.alike);
        let (first, any) = (found.leading.iter().any(|x| self.is(x)), all().any(|x| self.is(x)));
        // A spin alone leaves wrong sign, other moments and the other hand open: all are offered.
        let sure = found.confidence.names_a_rule();
        let is_own = |rule: &Rule| matches!(self.truth, Truth::Known(base) if self.is_base(base, rule));
        let in_mirror = |rule: &Rule| match self.fault {
            // The other hand's spin goes by the term with its own sign.
            Fault::Term(-1.0) => rule.alteration.is_none() && is_own(rule),
            // What is left of the other body, of the rule or of the motion.
            Fault::Other(..) => matches!(rule.alteration, Some(Alteration::OtherMoments(..))),
            _ => false,
        };
        let mirrored = (!sure || all().any(in_mirror))
            && matches!(self.fault, Fault::Term(-1.0) | Fault::Other(..))
            && verdict.file_mistakes.contains(&FileMistake::LeftHandedSpin)
            && verdict.to_string().contains("wrong sign");
        // The exact motion with the fault: the rule's own error is less than what is left.
        let of_fault = found.best.rule.base == Base::Exact && self.is_as_said(&found.best.rule);
        let near = found.confidence == Confidence::Near;
        // Times that are said to be wrong are, and by this much; those that are wrong are said to be.
        let said = verdict.file_mistakes.iter().find_map(|mistake| match mistake {
            FileMistake::Times(times) => Some(*times),
            _ => None,
        });
        let times = match self.fault {
            Fault::Paced(times) if matches!(self.layout, Layout::Both | Layout::World) => Some(1.0 / times),
            _ => None,
        };
        match (said, times) {
            (Some(said), times) if times.is_none_or(|times| (said / times - 1.0).abs() > 1e-2) => {
                return Named::Wrongly;
            }
            (None, Some(_)) if !first => return if sure { Named::Wrongly } else { Named::Not },
            _ => {}
        }
        let Truth::Known(base) = self.truth else { return self.outside(found, verdict.record.rounding) };
        match (sure, first, any) {
            (true, true, _) if found.alike.is_empty() => Named::Rightly,
            (true, true, _) if found.leading.len() == 1 => Named::Rightly,
            // What the digits do not show.
            (true, ..) if found.is_exact() && verdict.outcome != Outcome::Failed => Named::AmongEquals,
            (_, _, true) => Named::AmongEquals,
            // A spin that stays, turned as it is.
            _ if is_still(base) && is_still(found.best.rule.base) => Named::AmongEquals,
            _ if mirrored || sure && of_fault => Named::AmongEquals,
            // The rule is right, and a fault is not seen.
            _ if near && all().any(|x| self.is_base(base, &Rule::plain(x.base))) => Named::Not,
            (true, ..) => Named::Wrongly,
            (false, ..) => Named::Not,
        }
    }

    /// Whether the place in the step where damping acts is named rightly, not, or wrongly.
    fn places(&self, verdict: &Verdict) -> [u64; 3] {
        let is_said = |x: &&Diagnosis| x.confidence.names_a_rule() || x.confidence == Confidence::Altered;
        let said = verdict.diagnosis.as_ref().filter(is_said).and_then(|found| found.best.rule.alteration);
        let (Fault::Damped(_, place), Some(Alteration::Damped { when, .. })) = (self.fault, said) else {
            return [0; 3];
        };
        [when == place, when == When::Open, ![place, When::Open].contains(&when)].map(u64::from)
    }

    /// What is made of a rule that the judge does not know.
    fn outside(&self, found: &Diagnosis, rounding: f64) -> Named {
        // Less than the rounding of the first row and the last.
        let is_equal = || self.off(&found.best.rule).is_some_and(|off| off < 2.0 * rounding);
        match found.confidence.names_a_rule() && !found.is_exact() {
            true if is_equal() => Named::AmongEquals,
            true => Named::Wrongly,
            false => Named::Not,
        }
    }

    /// How far a plain rule is from all the steps that were made, before they were written, together:
    /// relative to the spin or in rad.
    fn off(&self, rule: &Rule) -> Option<f64> {
        let (Base::Method(method, parts), None) = (rule.base, rule.alteration) else { return None };
        let step = known(Base::Method(method, 1), self.body);
        let off = |two: &[Motion]| {
            let end = (0..parts).try_fold(two[0], |now, _| step(&now, self.between / f64::from(parts)))?;
            let [to, q] = [end.0, two[1].0].map(UnitQuaternion::new_normalize);
            let turn = if self.layout == Layout::Spin { 0.0 } else { to.angle_to(&q) };
            // Less what the arithmetic of a step leaves.
            Some(((end.1 - two[1].1).norm() / two[1].1.norm() + turn - 1e-15).max(0.0))
        };
        self.rows.windows(2).map(off).sum()
    }
}

/// Judges the records of this many seeds, and writes which are not named, or wrongly, or praised beside a
/// failure; a single one in full. How many are named rightly, among equals, not and wrongly, and how many are
/// praised and refused (an attitude that turns too far from row to row); and of how many that are damped the
/// place in the step is named rightly, not and wrongly.
pub fn counted(first: u64, count: u64, is_known: bool, out: &mut impl io::Write) -> io::Result<[u64; 9]> {
    let mut counts = [0; 9];
    for seed in first..first.saturating_add(count) {
        let record = Invented::of(seed, is_known);
        let Ok(verdict) = judge(record.text.as_bytes(), &Options::default()) else {
            counts[5] += 1;
            continue;
        };
        let (named, praise) = (record.named(&verdict), praise(&verdict));
        counts[named as usize] += 1;
        counts[4] += u64::from(praise.is_some());
        counts[6..].iter_mut().zip(record.places(&verdict)).for_each(|(count, here)| *count += here);
        if count == 1 {
            writeln!(out, "{}\n{}\n{named:?}\n{verdict}", record.text, record.what)?;
        } else if named == Named::Wrongly || named == Named::Not && is_known || praise.is_some() {
            writeln!(out, "{seed} {named:?} {praise:?}: {}", record.what)?;
            let found =
                verdict.diagnosis.map(|found| (found.confidence, found.best.rule.name(), found.alike.len()));
            writeln!(out, "    {found:?}")?;
        }
    }
    Ok(counts)
}

/// Words of praise in the verdict on a record that fails, and not for its file or for jumps.
fn praise(verdict: &Verdict) -> Option<&'static str> {
    let jumps = verdict.diagnosis.as_ref().is_some_and(|found: &Diagnosis| !found.jumps.is_empty());
    let of_file = !verdict.file_mistakes.is_empty() || !verdict.resets.is_empty();
    if verdict.outcome != Outcome::Failed || jumps || of_file {
        return None;
    }
    let text = verdict.to_string().to_lowercase();
    let accurate = verdict.diagnosis.as_ref().map(|found| found.confidence) == Some(Confidence::Accurate);
    let words = "accurate|is: the exact motion|is that of: the exact motion|nothing to do|good method|\
                 conserves what it should|every step is made by: the exact motion";
    words.split('|').find(|words| text.contains(words)).or(accurate.then_some("accurate"))
}
