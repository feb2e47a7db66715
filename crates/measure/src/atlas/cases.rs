//! The hard cases, by what makes them hard.

use nalgebra::Vector3;
use tumbling::Error;
use tumbling::exact::FreeMotion;

/// One hard case.
#[derive(Debug, Clone, PartialEq)]
pub struct Case {
    /// What it is called, or the value that is swept.
    pub name: String,
    pub(super) moments: [f64; 3],
    pub(super) omega: [f64; 3],
    /// Damping in proportion to the momentum, 1/s.
    pub(super) damping: f64,
    pub(super) step: f64,
    pub(super) count: usize,
    /// Which component's sign changes are counted, and how many there truly are before the end.
    pub(super) watched: usize,
    pub(super) flips: Option<usize>,
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
    let motion = FreeMotion::new(moments.try_into()?, &omega.into())?;
    let first = motion.next_flip(0.0)?.unwrap_or(10.0);
    let second = motion.next_flip(first * (1.0 + 1e-9))?.unwrap_or(2.0 * first);
    let between = second - first;
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
