//! The law as the solvers get it: seven numbers, lean, each of size one.

use nalgebra::{Quaternion, Vector3};
use tumbling::step::{State, System};
use tumbling_measure::story::Story;

/// Attitude (scalar first) and momentum in body axes over its size at the start, so that one tolerance fits
/// all.
pub type Packed = [f64; 7];

/// A story as a solver of differential equations sees it.
#[derive(Debug, Clone)]
pub struct Law {
    system: System<f64>,
    /// Inverse moments times the size of the momentum: spin by scaled momentum.
    inverse: [f64; 3],
    size: f64,
}

impl Law {
    /// The law of a story, and the state at its start.
    pub fn of(story: &Story) -> (Self, Packed) {
        let size = story.start.momentum.norm();
        let inverse = story.system.moments().map(|x| size / x).into();
        let law = Self { system: story.system.clone(), inverse, size };
        let start = law.state(&story.start);
        (law, start)
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

    /// The rates of a state.
    #[inline]
    pub fn rate(&self, y: &Packed) -> Packed {
        let [a, b, c, d, l, m, n] = *y;
        let (x, v, z) = (self.inverse[0] * l, self.inverse[1] * m, self.inverse[2] * n);
        let mut rate = [
            0.5 * (-b * x - c * v - d * z),
            0.5 * (a * x + c * z - d * v),
            0.5 * (a * v - b * z + d * x),
            0.5 * (a * z + b * v - c * x),
            m * z - n * v,
            n * x - l * z,
            l * v - m * x,
        ];
        if !self.system.torques().is_empty() {
            let torque = self.system.torque(&self.motion(y)) / self.size;
            rate[4] += torque.x;
            rate[5] += torque.y;
            rate[6] += torque.z;
        }
        rate
    }
}
