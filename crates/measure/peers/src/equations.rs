//! The equations of motion as the solvers get them: seven numbers, each of size one.

use nalgebra::{Quaternion, Vector3};
use tumbling::step::State;
use tumbling_measure::story::Story;

/// Attitude (scalar first) and momentum in body axes over its size at the start, so that one tolerance fits
/// all.
pub type Packed = [f64; 7];

/// A story as a solver of differential equations sees it, through one of its phases.
#[derive(Debug, Clone)]
pub struct Equations {
    moments: [f64; 3],
    /// Inverse moments times the size of the momentum: spin by scaled momentum.
    inverse: [f64; 3],
    size: f64,
    /// The torques over the size of the momentum: weight times arm, damping over moments, gravity gradient, a
    /// push and a pulse.
    lever: Option<[f64; 3]>,
    damping: [f64; 3],
    gradient: f64,
    orbit: f64,
    push: Option<[f64; 3]>,
    rate: f64,
    pulse: [f64; 3],
}

impl Equations {
    /// The law of a story, and the state at its start.
    pub fn of(story: &Story) -> (Self, Packed) {
        let size = story.start.momentum.norm();
        let (moments, drive) = (*story.system.moments(), &story.drive);
        let some = |v: [f64; 3]| (v != [0.0; 3]).then_some(v);
        let law = Self {
            moments: moments.into(),
            inverse: moments.map(|x| size / x).into(),
            size,
            lever: some(drive.arm.map(|x| x * drive.weight / size)),
            damping: Vector3::from(drive.damping).component_div(&moments).into(),
            gradient: drive.gradient / size,
            orbit: drive.orbit,
            push: some(drive.push.map(|x| x / size)),
            rate: drive.rate,
            pulse: [0.0; 3],
        };
        let start = law.state(&story.start);
        (law, start)
    }

    /// Through each of the phases: the law, when it begins and when it ends, s.
    pub fn phases<'a>(&'a self, story: &'a Story) -> impl Iterator<Item = (Self, f64, f64)> + 'a {
        let mut end = 0.0;
        story.drive.phases.iter().map(move |(seconds, torque)| {
            let begin = end;
            end += seconds;
            (Self { pulse: torque.map(|x| x / self.size), ..self.clone() }, begin, end)
        })
    }

    fn state(&self, motion: &State<f64>) -> Packed {
        let (q, l) = (&motion.attitude, &motion.momentum / self.size);
        [q.w, q.i, q.j, q.k, l.x, l.y, l.z]
    }

    /// The motion behind a state.
    pub fn motion(&self, y: &[f64]) -> State<f64> {
        let at = |i: usize| y.get(i).copied().unwrap_or(f64::NAN);
        State {
            attitude: Quaternion::new(at(0), at(1), at(2), at(3)),
            momentum: Vector3::new(at(4), at(5), at(6)) * self.size,
        }
    }

    /// The rates of a state at a time.
    #[inline]
    pub fn rate(&self, time: f64, y: &Packed) -> Packed {
        let [a, b, c, d, l, m, n] = *y;
        let (x, v, z) = (self.inverse[0] * l, self.inverse[1] * m, self.inverse[2] * n);
        let ([e, f, g], [p, q, r]) = (self.damping, self.pulse);
        let mut rate = [
            0.5 * (-b * x - c * v - d * z),
            0.5 * (a * x + c * z - d * v),
            0.5 * (a * v - b * z + d * x),
            0.5 * (a * z + b * v - c * x),
            m * z - n * v - e * l + p,
            n * x - l * z - f * m + q,
            l * v - m * x - g * n + r,
        ];
        if let Some([p, q, r]) = self.lever {
            let up = [2.0 * (b * d - a * c), 2.0 * (c * d + a * b), 1.0 - 2.0 * (b * b + c * c)];
            rate[4] -= q * up[2] - r * up[1];
            rate[5] -= r * up[0] - p * up[2];
            rate[6] -= p * up[1] - q * up[0];
        }
        if self.gradient != 0.0 {
            let (sine, cosine) = (self.orbit * time).sin_cos();
            let toward = [
                cosine * (1.0 - 2.0 * (c * c + d * d)) + sine * 2.0 * (b * c + a * d),
                cosine * 2.0 * (b * c - a * d) + sine * (1.0 - 2.0 * (b * b + d * d)),
                cosine * 2.0 * (b * d + a * c) + sine * 2.0 * (c * d - a * b),
            ];
            for i in 0..3 {
                let (j, k) = ((i + 1) % 3, (i + 2) % 3);
                rate[4 + i] += self.gradient * (self.moments[k] - self.moments[j]) * toward[j] * toward[k];
            }
        }
        if let Some(push) = self.push {
            let cosine = (self.rate * time).cos();
            for i in 0..3 {
                rate[4 + i] += push[i] * cosine;
            }
        }
        rate
    }
}
