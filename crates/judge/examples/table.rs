//! How often the judge names the rule of a record: every rule of the library, in 1 to 16 steps from row to
//! row, with spins of 0.1 to 30 rad/s, rows at 30 to 240 Hz, 5 to 17 digits, in single and in double
//! precision, with and without attitudes.
//!
//! ```sh
//! cargo run --release -p tumbling-judge --example table -- 20000
//! ```
//!
//! A second argument is the seed. It prints the numbers of records named rightly, named among equals, left
//! unnamed and named wrongly, and each record that is named wrongly.

use nalgebra::{Quaternion, UnitQuaternion, Vector3};
use std::collections::BTreeMap;
use std::fmt::Write as _;
use tumbling::PrincipalMoments;
use tumbling::attitude::rotation_matrix;
use tumbling::exact::FreeMotion;
use tumbling::step::{Method, PositionStage, State, System};
use tumbling_judge::{Base, Confidence, Options, Rule, Verdict, judge};

/// A generator of numbers in 0..1, of period 2^64.
struct Random(u64);

impl Random {
    fn next(&mut self) -> f64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        let mixed = (self.0 ^ (self.0 >> 33)).wrapping_mul(0xff51_afd7_ed55_8ccd);
        (mixed >> 11) as f64 / (1_u64 << 53) as f64
    }

    fn pick<T: Copy>(&mut self, all: &[T]) -> T {
        all[((self.next() * all.len() as f64) as usize).min(all.len() - 1)]
    }
}

/// What a record is made by.
#[derive(Debug, Clone, Copy)]
struct Made {
    /// The library's position stage where it is none.
    method: Option<Method>,
    /// Steps from row to row.
    steps: u32,
    moments: Vector3<f64>,
    omega: Vector3<f64>,
    /// Rows a second.
    rate: f64,
    digits: usize,
    single: bool,
    attitude: bool,
    rows: u32,
}

impl Made {
    fn of(random: &mut Random) -> Self {
        let (a, b) = (0.3 + random.next(), 0.3 + random.next());
        let moments = [a, b, (a - b).abs() + (a + b - (a - b).abs()) * (0.02 + 0.96 * random.next())];
        let direction = Vector3::from([(); 3].map(|()| random.next() - 0.5)).normalize();
        Self {
            method: Method::ALL.get((random.next() * (Method::ALL.len() + 1) as f64) as usize).copied(),
            steps: random.pick(&[1, 2, 3, 4, 5, 7, 8, 11, 16]),
            moments: moments.into(),
            omega: direction * 0.1 * 300_f64.powf(random.next()),
            rate: random.pick(&[30.0, 50.0, 60.0, 100.0, 120.0, 144.0, 240.0]),
            digits: random.pick(&[5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16, 17]),
            single: random.next() < 0.5,
            attitude: random.next() < 0.5,
            rows: random.pick(&[60, 200, 600]),
        }
    }

    /// The rounding of its numbers, relative to 1.
    fn rounding(&self) -> f64 {
        let digits = 10_f64.powi(1 - self.digits as i32);
        digits.max(if self.single { f64::from(f32::EPSILON) } else { f64::EPSILON })
    }

    /// The record, and the median distance of its steps from the exact motion, relative to the spin.
    fn record(&self) -> Option<(String, f64)> {
        let checked = PrincipalMoments::try_from(self.moments).ok()?;
        let system = System::free(checked).ok()?;
        let round = |x: f64| if self.single { f64::from(x as f32) } else { x };
        let q = UnitQuaternion::from_euler_angles(0.3, -0.4, 1.2).into_inner();
        let (mut q, mut omega) = (Quaternion::from_vector(q.coords.map(round)), self.omega.map(round));
        let stage = PositionStage::new(&self.moments).ok()?;
        let [a, b, c] = self.moments.into();
        let names = if self.attitude { "t,qw,qx,qy,qz,wx,wy,wz" } else { "t,wx,wy,wz" };
        let mut text = format!("# inertia: {a:e} {b:e} {c:e}\n{names}\n");
        let mut errors = Vec::new();
        for row in 0..self.rows {
            let t = f64::from(row) / self.rate;
            write!(text, "{t:e}").ok()?;
            let attitude = q.coords.iter().cycle().skip(3).take(4).filter(|_| self.attitude);
            for x in attitude.chain(&omega) {
                let digits = self.digits.min(if self.single { 9 } else { 17 }) - 1;
                write!(text, ",{x:.digits$e}").ok()?;
            }
            text.push('\n');
            let exact = FreeMotion::new(checked, &omega).ok()?.omega(1.0 / self.rate).ok()?;
            for _ in 0..self.steps {
                let h = 1.0 / self.rate / f64::from(self.steps);
                (q, omega) = match self.method {
                    Some(method) => {
                        let from = State { attitude: q, momentum: system.momentum(&omega) };
                        let next = method.step(&system, &from, h).ok()?;
                        (next.attitude, system.omega(&next.momentum))
                    }
                    None => {
                        let next = stage.step(&(q / q.norm()), &(rotation_matrix(&q) * omega), h);
                        (next.attitude, rotation_matrix(&next.attitude).tr_mul(&next.omega))
                    }
                };
                q = Quaternion::from_vector(q.coords.map(round));
                omega = omega.map(round);
            }
            errors.push((omega - exact).norm() / omega.norm());
            if omega.norm() > 1e3 * self.omega.norm() {
                return None;
            }
        }
        errors.sort_by(f64::total_cmp);
        Some((text, errors[errors.len() / 2]))
    }

    /// The number of parts from row to row if the position stage takes this number of steps: it cuts a long
    /// step itself, so that two numbers of steps may be the same motion.
    fn parts_of_stage(&self, steps: u32) -> Option<u32> {
        let stage = PositionStage::new(&self.moments).ok()?;
        let step = stage.step(&Quaternion::identity(), &self.omega, 1.0 / self.rate / f64::from(steps));
        Some(step.parts * steps)
    }

    /// How a verdict does: 0 named, 1 among equals, 2 unnamed, 3 wrong.
    fn graded(&self, verdict: &Verdict, error: f64) -> usize {
        let Some(diagnosis) = &verdict.diagnosis else { return 2 };
        let parts = |n| n == self.steps || self.method == Some(Method::ConstantSpin);
        let is = |rule: &Rule| match rule.base {
            Base::PositionStage(n) => {
                self.method.is_none()
                    && self.parts_of_stage(n) == self.parts_of_stage(self.steps)
                    && rule.alteration.is_none()
            }
            _ => rule.method().is_some_and(|(method, n)| Some(method) == self.method && parts(n)),
        };
        let among = is(&diagnosis.best.rule) || diagnosis.alike.iter().any(is);
        let exact = error <= 16.0 * self.rounding();
        let names_exact = diagnosis.best.rule == Rule::EXACT || diagnosis.alike.contains(&Rule::EXACT);
        match diagnosis.confidence {
            Confidence::NoneFits | Confidence::Accurate | Confidence::FewSteps => 2,
            Confidence::SmallErrors if among || exact => 2,
            _ if is(&diagnosis.best.rule) && diagnosis.alike.is_empty() => 0,
            _ if among || exact && names_exact => 1,
            Confidence::FewDigits if diagnosis.drifts == Some(0) => 2,
            _ => 3,
        }
    }
}

fn main() {
    let mut arguments = std::env::args().skip(1).map(|x| x.parse::<u64>().unwrap_or(0));
    let (count, seed) = (arguments.next().unwrap_or(2000), arguments.next().unwrap_or(1));
    let mut random = Random(seed);
    let mut table: BTreeMap<(bool, bool, &str), [u64; 4]> = BTreeMap::new();
    let mut judged = 0;
    while judged < count {
        let made = Made::of(&mut random);
        let Some((text, error)) = made.record() else { continue };
        judged += 1;
        let grade = match judge(text.as_bytes(), &Options::default()) {
            Ok(verdict) => {
                let grade = made.graded(&verdict, error);
                if grade == 3 {
                    let diagnosis = verdict.diagnosis.as_ref().map(ToString::to_string).unwrap_or_default();
                    println!("WRONG: {made:?}, exact to {error:.1e}\n{diagnosis}\n");
                }
                grade
            }
            Err(wrong) => {
                println!("REFUSED: {made:?}: {wrong}");
                2
            }
        };
        let digits = match made.digits {
            ..=7 => " 5 to 7",
            8..=12 => " 8 to 12",
            _ => "13 to 17",
        };
        table.entry((made.single, made.attitude, digits)).or_default()[grade] += 1;
    }
    println!("| precision | attitudes | digits | named | among equals | unnamed | wrong |");
    println!("|---|---|---|---|---|---|---|");
    let mut sum = [0; 4];
    for ((single, attitude, digits), counts) in table {
        let (precision, attitude) = (if single { "f32" } else { "f64" }, if attitude { "yes" } else { "no" });
        println!("| {precision} | {attitude} | {digits} | {} |", counts.map(|x| x.to_string()).join(" | "));
        (0..4).for_each(|i| sum[i] += counts[i]);
    }
    println!("| all | | | {} |", sum.map(|x| x.to_string()).join(" | "));
}
