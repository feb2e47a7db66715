//! The atlas: every method on every hard case, and what became of it.
//!
//! A [`Chart`] sweeps one difficulty (a turn per step, a needle's thinness, a push, a damping, or a list of named cases); each of its
//! [`Place`]s is one run of one method, judged against the exact motion with the rules of [`Fate`]. No time is measured, so the same
//! machine always draws the same atlas.

use nalgebra::{Quaternion, Vector3};
use num_traits::{FromPrimitive, ToPrimitive};
use std::fmt;
use tumbling::Error;
use tumbling::exact::FreeMotion;
use tumbling::scalar::Analytic;
use tumbling::step::{Method, Motion, System, Torque};
use tumbling::{flow, observe};

/// What became of a run.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Fate {
    /// All is within its bounds: energy and momentum to a hundredth, the count of flips, the last flip or the attitude to a tenth.
    Right,
    /// The flips are counted right, but the last comes more than a tenth of the time between flips too early or late; of a motion
    /// without flips, the attitude is off by more than a tenth of a radian.
    Late,
    /// Energy or momentum is off by more than a hundredth, and no more than a tenth.
    Worn,
    /// The wrong number of sign changes of the watched spin.
    WrongFlips,
    /// Energy, or momentum, more than a tenth too high.
    Gained,
    /// Energy, or momentum, more than a tenth too low.
    Lost,
    /// Damping that turned the momentum round.
    Reversed,
    /// An error that says why.
    Refused,
    /// Infinite or not a number, without an error.
    NotFinite,
}

impl Precision {
    /// As Rust calls it.
    #[must_use]
    pub const fn word(self) -> &'static str {
        match self {
            Self::Single => "f32",
            Self::Double => "f64",
        }
    }
}

impl Fate {
    /// All of them, best first.
    pub const ALL: [Self; 9] = [
        Self::Right,
        Self::Late,
        Self::Worn,
        Self::WrongFlips,
        Self::Gained,
        Self::Lost,
        Self::Reversed,
        Self::Refused,
        Self::NotFinite,
    ];

    /// One word.
    #[must_use]
    pub const fn word(self) -> &'static str {
        match self {
            Self::Right => "right",
            Self::Late => "late",
            Self::Worn => "worn",
            Self::WrongFlips => "miscounted",
            Self::Gained => "gained",
            Self::Lost => "lost",
            Self::Reversed => "reversed",
            Self::Refused => "refused",
            Self::NotFinite => "not finite",
        }
    }
}

impl fmt::Display for Fate {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(self.word())
    }
}

/// Who runs.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Runner {
    /// The closed form: the whole way at once, or between kicks where a torque acts.
    Exact,
    /// A stepper.
    Stepper(Method),
}

impl Runner {
    /// The exact motion, then every method.
    pub fn all() -> impl Iterator<Item = Self> {
        std::iter::once(Self::Exact).chain(Method::ALL.iter().map(|&method| Self::Stepper(method)))
    }

    /// What it is called.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Exact => "exact motion",
            Self::Stepper(method) => method.about().name,
        }
    }
}

/// The numbers that a run computes with.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Precision {
    /// `f32`.
    Single,
    /// `f64`.
    Double,
}

/// One hard case.
#[derive(Debug, Clone, PartialEq)]
pub struct Case {
    /// What it is called, or the value that is swept.
    pub name: String,
    moments: [f64; 3],
    omega: [f64; 3],
    /// Damping in proportion to the momentum, 1/s.
    damping: f64,
    step: f64,
    count: usize,
    /// Which component's sign changes are counted, and how many there truly are before the end.
    watched: usize,
    flips: Option<usize>,
}

/// A difficulty, and the cases along it.
#[derive(Debug, Clone, PartialEq)]
pub struct Chart {
    /// Short name, with dashes.
    pub name: &'static str,
    /// What is swept, with its unit.
    pub swept: &'static str,
    /// The cases, mildest first.
    pub cases: Vec<Case>,
}

/// A run's place in the atlas.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Place {
    /// The chart's name.
    pub chart: &'static str,
    /// The case's name.
    pub case: String,
    /// Who ran.
    pub runner: &'static str,
    /// With which numbers.
    pub precision: Precision,
    /// What became of it.
    pub fate: Fate,
}

/// Moments 1, 2, 3 kg m².
const PLAIN: [f64; 3] = [1.0, 2.0, 3.0];

/// Turns of about a radian each that a run without flips is followed for.
const RADIANS: f64 = 600.0;

fn free(
    name: impl Into<String>,
    moments: [f64; 3],
    omega: [f64; 3],
    step: f64,
    span: f64,
    watched: usize,
) -> Case {
    // At least a few steps, at most what a run should take.
    #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)] // clamped
    let count = (span / step).ceil().clamp(4.0, 200_000.0) as usize;
    Case { name: name.into(), moments, omega, damping: 0.0, step, count, watched, flips: None }
}

/// A case of the body that flips, for `flips` flips and a half.
fn flipping(
    name: impl Into<String>,
    moments: [f64; 3],
    omega: [f64; 3],
    step: f64,
    flips: usize,
) -> Result<Case, Error> {
    let motion = FreeMotion::new(&moments.into(), &omega.into())?;
    let first = motion.next_flip(0.0)?.unwrap_or(10.0);
    let second = motion.next_flip(first * (1.0 + 1e-9))?.unwrap_or(2.0 * first);
    let between = second - first;
    #[allow(clippy::cast_precision_loss)] // a handful
    let span = first + between * (flips as f64 - 0.5);
    let mut case = free(name, moments, omega, step, span, 1);
    case.flips = Some(flips);
    Ok(case)
}

/// All charts.
///
/// # Errors
/// None, unless the exact motion refuses one of the cases.
pub fn charts() -> Result<Vec<Chart>, Error> {
    const TURNS: [f64; 9] = [0.01, 0.03, 0.1, 0.2, 0.5, 1.0, 1.6, 3.1, 10.0];
    let speed = |omega: [f64; 3]| Vector3::from(omega).norm();
    let stable = [0.5, 0.5, 10.0];
    let steady = TURNS.iter().map(|&turn| {
        let step = turn / speed(stable);
        free(format!("{turn}"), PLAIN, stable, step, RADIANS / speed(stable), 2)
    });
    let tossed = [0.0, 10.0, 0.01];
    let flips = TURNS.iter().map(|&turn| flipping(format!("{turn}"), PLAIN, tossed, turn / 10.0, 8));
    let needles = [0, 1, 2, 3, 4, 6, 8, 10, 12].map(|power| {
        let thin = 10_f64.powi(-power);
        let omega = [0.8, 0.5, 0.33];
        free(format!("1e{power}"), [thin, 1.0, 1.0 + 0.4 * thin], omega, 0.1, RADIANS, 0)
    });
    let pushes = [1, 2, 3, 6, 9, 12, 15, 30, 100, 300]
        .map(|power| flipping(format!("1e-{power}"), PLAIN, [0.0, 10.0, 10_f64.powi(-power)], 0.01, 3));
    let damped = [0.01, 0.1, 0.5, 1.0, 2.0, 3.0, 10.0, 1e2, 1e4, 1e6].map(|strength| {
        let step = 0.05;
        let mut case = free(format!("{strength}"), [1.0, 2.0, 2.6], [0.4, 1.5, -0.3], step, 40.0 * step, 1);
        case.damping = strength / step;
        case
    });
    Ok(vec![
        Chart { name: "steady spin", swept: "turn a step, rad", cases: steady.collect() },
        Chart { name: "flipping", swept: "turn a step, rad", cases: flips.collect::<Result<_, _>>()? },
        Chart { name: "needles", swept: "ratio of moments", cases: needles.into() },
        Chart { name: "pushes", swept: "push, rad/s", cases: pushes.into_iter().collect::<Result<_, _>>()? },
        Chart { name: "damping", swept: "damping times step over inertia", cases: damped.into() },
        Chart { name: "named", swept: "case", cases: named()? },
    ])
}

/// Cases that users of engines have met.
fn named() -> Result<Vec<Case>, Error> {
    let (h, span) = (0.01, 20.0);
    let spun = |name: &str, moments: [f64; 3], omega: [f64; 3], watched| {
        free(name, moments, omega, h, span, watched)
    };
    let separatrix = {
        // 2E I2 = L^2: the push along both other axes that balances.
        let (a, c) = (PLAIN[0] * (PLAIN[1] - PLAIN[0]), PLAIN[2] * (PLAIN[2] - PLAIN[1]));
        [0.03 * (c / a).sqrt(), 10.0, 0.03]
    };
    let scaled = |name: &str, mass: f64, speed: f64| {
        let moments = PLAIN.map(|x| x * mass);
        // The longest step that an f64 has room for a thousand of.
        let step = (0.1 / speed).min(1e305);
        free(name, moments, [0.3 * speed, speed, 0.2 * speed], step, 1000.0 * step, 1)
    };
    Ok(vec![
        spun("steady on the middle axis", PLAIN, [0.0, 10.0, 0.0], 1),
        {
            let mut case = free("on the separatrix", PLAIN, separatrix, h, 3.0, 1);
            case.flips = None;
            case
        },
        spun("sphere", [2.0; 3], [3.0, 4.0, 5.0], 1),
        spun("symmetric top", [2.0, 2.0, 3.0], [3.0, 0.4, 5.0], 2),
        spun("a rounding off a symmetric top", [2.0, 2.0 + 4.0 * f64::EPSILON, 3.0], [3.0, 0.4, 5.0], 2),
        spun("needle of 26 to 1", [1.0, 26.0, 26.5], [9.0, 2.0, 1.0], 0),
        spun("needle of 1300 to 1", [1.0, 1300.0, 1300.5], [9.0, 2.0, 1.0], 0),
        spun("flat plate", [1.0, 2.0, 3.0], [4.0, 7.0, 2.0], 2),
        flipping("tennis racket", [0.00121, 0.01638, 0.01748], [0.0, 10.0, 0.1], h, 4)?,
        scaled("1e-5 rad/s", 1.0, 1e-5),
        flipping("1e7 kg m²", PLAIN.map(|x| x * 1e7), [0.0, 10.0, 0.01], h, 4)?,
        scaled("1e-20 kg m²", 1e-20, 1.0),
        scaled("1e150 kg m²", 1e150, 1.0),
        scaled("1e-150 kg m²", 1e-150, 1.0),
        scaled("1e150 rad/s", 1.0, 1e150),
        scaled("1e-150 rad/s", 1.0, 1e-150),
        scaled("1e-310 rad/s", 1.0, 1e-310),
    ])
}

/// All that a judge needs of a run.
#[derive(Debug, Clone, Copy)]
struct Seen {
    /// Worst over the run, of the truth's.
    energy: [f64; 2],
    momentum: [f64; 2],
    changes: usize,
    last_change: f64,
    /// At the end.
    attitude: Quaternion<f64>,
    left: Vector3<f64>,
    reversed: bool,
}

enum End {
    Seen(Seen),
    NotFinite,
    Refused,
}

impl Case {
    fn system(&self) -> Result<System<f64>, Error> {
        let moments = Vector3::from(self.moments);
        if self.damping == 0.0 {
            return System::free(&moments);
        }
        System::with(&moments, vec![Torque::Damping(moments * self.damping)])
    }

    fn duration(&self) -> f64 {
        #[allow(clippy::cast_precision_loss)] // at most 2e5
        let count = self.count as f64;
        self.step * count
    }

    /// The truth at `t`: of a damped body the free motion at a later start's time.
    fn truth(&self, motion: &FreeMotion, t: f64) -> Result<(Vector3<f64>, Quaternion<f64>), Error> {
        let left = (-self.damping * t).exp();
        let time = if self.damping == 0.0 { t } else { (1.0 - left) / self.damping };
        let at = motion.at(time)?;
        Ok((at.omega * left, at.attitude.into_inner()))
    }

    /// Runs it and says what became of it.
    #[must_use]
    pub fn judged(&self, runner: Runner, precision: Precision) -> Fate {
        let end = match (runner, precision) {
            (Runner::Exact, _) => self.exactly(),
            (Runner::Stepper(method), Precision::Double) => self.stepped::<f64>(method),
            (Runner::Stepper(method), Precision::Single) => self.stepped::<f32>(method),
        };
        match end {
            End::Refused => Fate::Refused,
            End::NotFinite => Fate::NotFinite,
            End::Seen(seen) => self.fate(&seen).unwrap_or(Fate::Refused),
        }
    }

    fn exactly(&self) -> End {
        let result = self.system().and_then(|system| {
            let start =
                Motion { attitude: Quaternion::identity(), vector: system.momentum(&self.omega.into()) };
            let motion = FreeMotion::new(&self.moments.into(), &self.omega.into())?;
            let mut kicked = start.clone();
            self.watch(&system, &start, |k| {
                #[allow(clippy::cast_precision_loss)] // at most 2e5
                let t = self.step * k as f64;
                if self.damping > 0.0 {
                    kicked = flow::step(&system, &kicked, self.step)?;
                    return Ok(kicked.clone());
                }
                let at = motion.at(t)?;
                Ok(Motion { attitude: at.attitude.into_inner(), vector: system.momentum(&at.omega) })
            })
        });
        result.unwrap_or(End::Refused)
    }

    fn stepped<T: Analytic + FromPrimitive + ToPrimitive>(&self, method: Method) -> End {
        let number = |x: f64| T::from_f64(x).unwrap_or_else(T::zero);
        let back = |x: &T| x.to_f64().unwrap_or(f64::NAN);
        let vector = |x: [f64; 3]| Vector3::from(x.map(number));
        let Ok(checked) = self.system() else { return End::Refused };
        let torques = if self.damping == 0.0 {
            Vec::new()
        } else {
            vec![Torque::Damping(vector(self.moments.map(|x| x * self.damping)))]
        };
        let system = System::of_numbers(vector(self.moments), torques);
        let attitude = Quaternion::new(T::one(), T::zero(), T::zero(), T::zero());
        let mut motion = Motion { attitude, vector: system.momentum(&vector(self.omega)) };
        let outside = |motion: &Motion<T>| Motion {
            attitude: Quaternion::from_vector(motion.attitude.coords.map(|x| back(&x))),
            vector: motion.vector.map(|x| back(&x)),
        };
        let start = outside(&motion);
        let h = number(self.step);
        self.watch(&checked, &start, |_| {
            motion = method.step(&system, &motion, &h)?;
            Ok(outside(&motion))
        })
        .unwrap_or(End::Refused)
    }

    /// Follows a run, step by step.
    fn watch(
        &self,
        system: &System<f64>,
        start: &Motion<f64>,
        mut next: impl FnMut(usize) -> Result<Motion<f64>, Error>,
    ) -> Result<End, Error> {
        // In units of the start's, so that no square leaves the range.
        let (size, length) = (start.vector.amax(), |v: &Vector3<f64>| v.amax());
        let unit = |v: &Vector3<f64>| if size > 0.0 { v / size } else { *v };
        let energy = |v: &Vector3<f64>| {
            let part = unit(v);
            let moments = system.moments() / system.moments().amax();
            part.component_div(&moments).dot(&part)
        };
        let start_energy = energy(&start.vector);
        let start_momentum = unit(&start.vector).norm();
        let mut seen = Seen {
            energy: [1.0; 2],
            momentum: [1.0; 2],
            changes: 0,
            last_change: f64::NAN,
            attitude: start.attitude,
            left: start.vector,
            reversed: false,
        };
        let mut before = start.clone();
        for k in 1..=self.count {
            let motion = next(k)?;
            if !motion.vector.iter().chain(&motion.attitude.coords).all(|x| x.is_finite()) {
                return Ok(End::NotFinite);
            }
            let grow = |bounds: &mut [f64; 2], x: f64| *bounds = [bounds[0].min(x), bounds[1].max(x)];
            grow(&mut seen.energy, energy(&motion.vector) / start_energy);
            grow(&mut seen.momentum, unit(&motion.vector).norm() / start_momentum);
            let [a, b] = [before.vector[self.watched], motion.vector[self.watched]];
            #[allow(clippy::cast_precision_loss)] // at most 2e5
            let t = self.step * (k - 1) as f64;
            // Below the smallest sign that matters, rounding may change it.
            if a * b < 0.0
                || (a == 0.0 && b != 0.0 && k > 1)
                || (a.signum() != b.signum() && length(&motion.vector) < 1e-150)
            {
                seen.changes += 1;
                seen.last_change = t + self.step * a / (a - b);
            }
            if self.damping > 0.0 && before.vector.dot(&motion.vector) < 0.0 && k == 1 {
                seen.reversed = true;
            }
            (seen.attitude, seen.left) = (motion.attitude, motion.vector);
            before = motion;
            if seen.energy[1] > 1e9 {
                break;
            }
        }
        Ok(End::Seen(seen))
    }

    fn fate(&self, seen: &Seen) -> Result<Fate, Error> {
        let motion = FreeMotion::new(&self.moments.into(), &self.omega.into())?;
        let end = self.duration();
        let (omega, attitude) = self.truth(&motion, end)?;
        let distance = |q: &Quaternion<f64>| {
            let q = q.normalize().coords;
            4.0 * ((q - attitude.coords).norm().min((q + attitude.coords).norm()) / 2.0).min(1.0).asin()
        };
        if self.damping > 0.0 {
            let moments = Vector3::from(self.moments);
            let truth = omega.component_mul(&moments);
            let start = Vector3::from(self.omega).component_mul(&moments).norm();
            let off = (seen.left.norm() - truth.norm()) / start;
            return Ok(match off {
                _ if seen.reversed => Fate::Reversed,
                _ if seen.momentum[1] > 1.1 || off > 0.1 => Fate::Gained,
                off if off < -0.1 => Fate::Lost,
                off if off.abs() > 0.01 => Fate::Worn,
                _ if truth.norm() > 0.1 * start && distance(&seen.attitude) > 0.1 => Fate::Late,
                _ => Fate::Right,
            });
        }
        let [low, high] = [seen.energy[0].min(seen.momentum[0]), seen.energy[1].max(seen.momentum[1])];
        if high > 1.1 {
            return Ok(Fate::Gained);
        }
        if low < 0.9 {
            return Ok(Fate::Lost);
        }
        let expected = self.expected(&motion, end)?;
        if seen.changes != expected.len() {
            return Ok(Fate::WrongFlips);
        }
        if high > 1.01 || low < 0.99 {
            return Ok(Fate::Worn);
        }
        let late = match expected.as_slice() {
            [] => distance(&seen.attitude) > 0.1,
            [only] => (seen.last_change - only).abs() > 0.1 * only,
            [.., before, last] => (seen.last_change - last).abs() > 0.1 * (last - before),
        };
        Ok(if late { Fate::Late } else { Fate::Right })
    }

    /// When the watched component truly changes sign.
    fn expected(&self, motion: &FreeMotion, end: f64) -> Result<Vec<f64>, Error> {
        let mut order = [0, 1, 2];
        order.sort_by(|&i, &j| self.moments[i].total_cmp(&self.moments[j]));
        if self.flips.is_some() || order[1] == self.watched {
            return Ok(motion.flips(0.0, end)?.collect());
        }
        // Seen at each step: of a motion about this axis there are none.
        let mut signs = Vec::new();
        for k in 0..=self.count {
            #[allow(clippy::cast_precision_loss)] // at most 2e5
            let t = self.step * k as f64;
            signs.push((t, motion.omega(t)?[self.watched]));
        }
        Ok(observe::sign_changes(signs.into_iter()))
    }
}

/// Runs everything, some seconds, on as many threads as there are charts.
///
/// # Errors
/// None, unless the exact motion refuses one of the cases.
pub fn atlas() -> Result<Vec<Place>, Error> {
    let charts = charts()?;
    Ok(std::thread::scope(|scope| {
        let runs: Vec<_> = charts.iter().map(|chart| scope.spawn(|| filled(chart))).collect();
        runs.into_iter().flat_map(|run| run.join().unwrap_or_default()).collect()
    }))
}

/// The atlas as a record: a head that says what it is, then a line for each place.
#[must_use]
pub fn written(places: &[Place]) -> String {
    let mut text = String::from(
        "# What becomes of each method of the library on each hard case, judged against the exact motion.\n\
         # Made by: cargo run --release -- atlas. No time is measured.\n\
         chart\tcase\trunner\tprecision\tfate\n",
    );
    for Place { chart, case, runner, precision, fate } in places {
        text += &format!("{chart}\t{case}\t{runner}\t{}\t{fate}\n", precision.word());
    }
    text
}

/// The atlas to be read on a terminal: a table for each chart and precision, a line for each method.
#[must_use]
pub fn table(places: &[Place]) -> String {
    let mut text = String::new();
    let mut head = None;
    let mut line = None;
    for place in places {
        if head != Some((place.chart, place.precision)) {
            head = Some((place.chart, place.precision));
            let cases = places.iter().filter(|p| {
                p.chart == place.chart && p.precision == place.precision && p.runner == place.runner
            });
            text += &format!("\n\n{}, {}:\n", place.chart, place.precision.word());
            let names: Vec<&str> = cases.map(|p| p.case.as_str()).collect();
            text += &format!("{}\n", names.join(" | "));
            line = None;
        }
        if line != Some(place.runner) {
            line = Some(place.runner);
            text += &format!("\n{:28}", place.runner);
        }
        text += &format!(" {:10}", place.fate);
    }
    text.trim().to_owned()
}

fn filled(chart: &Chart) -> Vec<Place> {
    let mut places = Vec::new();
    for precision in [Precision::Double, Precision::Single] {
        for runner in Runner::all() {
            // The closed form is of f64 alone.
            if runner == Runner::Exact && precision == Precision::Single {
                continue;
            }
            for case in &chart.cases {
                let fate = case.judged(runner, precision);
                let (chart, case, runner) = (chart.name, case.name.clone(), runner.name());
                places.push(Place { chart, case, runner, precision, fate });
            }
        }
    }
    places
}
