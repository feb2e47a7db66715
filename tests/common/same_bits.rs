//! One hash of very many answers, which must be the same wherever `f64` follows IEEE 754: the tests compute
//! it, and `.ci/same-bits` elsewhere.

use nalgebra::{Matrix3, Quaternion, Rotation3, UnitQuaternion, Vector3};
use tumbling::exact::{Batch, FreeMotion};
use tumbling::step::{Method, PositionStage, Stepper, System, Torque, fixed_rate};
use tumbling::{Body, Inertia, PrincipalMoments, State, body::named::NamedBody};

/// Hashes numbers: FNV-1a over their bits.
pub struct Hash {
    state: u64,
    /// The number of numbers put in.
    pub numbers: u64,
}

impl Default for Hash {
    fn default() -> Self {
        Self { state: 0xcbf2_9ce4_8422_2325, numbers: 0 }
    }
}

impl Hash {
    /// The hash so far.
    #[must_use]
    pub fn value(&self) -> u64 {
        self.state
    }

    /// Puts a number in.
    pub fn put(&mut self, x: f64) {
        // IEEE 754 does not define the bits of a NaN.
        let bits = if x.is_nan() { u64::MAX } else { x.to_bits() };
        for byte in bits.to_le_bytes() {
            self.state = (self.state ^ u64::from(byte)).wrapping_mul(0x100_0000_01b3);
        }
        self.numbers += 1;
    }

    /// Puts numbers in.
    pub fn all<'a>(&mut self, numbers: impl IntoIterator<Item = &'a f64>) {
        numbers.into_iter().for_each(|&x| self.put(x));
    }

    /// Either the numbers of an answer, or one for a refusal.
    pub fn answer<T, E>(&mut self, answer: Result<T, E>, numbers: impl FnOnce(&mut Self, T)) {
        match answer {
            Ok(answer) => numbers(self, answer),
            Err(_) => self.put(f64::NAN),
        }
    }

    fn state(&mut self, state: &State<f64>) {
        self.all(&state.attitude.coords);
        self.all(&state.momentum);
    }
}

/// Random numbers: SplitMix64.
pub struct Random(pub u64);

impl Random {
    /// 64 bits.
    pub fn bits(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let z = (self.0 ^ (self.0 >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        let z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    }

    /// From -1 to 1.
    pub fn signed(&mut self) -> f64 {
        (self.bits() >> 11) as f64 * (2.0 / 9_007_199_254_740_992.0) - 1.0
    }

    /// Each component from -1 to 1.
    pub fn vector(&mut self) -> Vector3<f64> {
        Vector3::from_fn(|_, _| self.signed())
    }

    /// From 1 down to 2^-`most`, with every power of two equally likely.
    fn size(&mut self, most: u64) -> f64 {
        let halvings = self.bits() % most;
        (0..halvings).fold(0.75 + 0.25 * self.signed(), |size, _| 0.5 * size)
    }

    /// Moments that a body can have, some of them equal or nearly.
    fn moments(&mut self) -> PrincipalMoments {
        let [x, mut y, mut z] = [0, 1, 2].map(|_| self.size(if self.0.is_multiple_of(4) { 30 } else { 3 }));
        match self.bits() % 8 {
            0 => (y, z) = (x, x),
            1 => y = x,
            2 => z = y,
            3 => z = y * (1.0 + 1e-9 * self.signed()),
            _ => {}
        }
        // Sums of two: no rounding makes them impossible.
        PrincipalMoments::new(y + z, x + z, x + y).expect("moments of a body")
    }

    /// A body's moments and spin, of every kind of motion.
    pub fn motion(&mut self) -> (PrincipalMoments, Vector3<f64>) {
        let mut moments = self.moments();
        let mut omega = self.vector() * 8.0;
        let separatrix = PrincipalMoments::new(3.0, 4.0, 6.0).expect("moments of a body");
        match self.bits() % 10 {
            0 => omega = Vector3::zeros(),
            1 => omega = Vector3::new(0.0, omega.y, 0.0),
            // Next to an axis, in half of the cases the middle one.
            2 | 3 => {
                let (axis, size) = (self.bits() % 3, self.size(40));
                for k in 0..3 {
                    omega[k] *= if k as u64 == axis { 1.0 } else { size };
                }
            }
            // The separatrix itself, and next to it: I1 (I2 - I1) w1² = I3 (I3 - I2) w3².
            4 => (moments, omega.x) = (separatrix, 2.0 * omega.z),
            5 => (moments, omega.x) = (separatrix, 2.0 * omega.z * (1.0 + self.size(50))),
            _ => {}
        }
        (moments, omega)
    }

    fn time(&mut self) -> f64 {
        match self.bits() % 4 {
            0 => 1e6 * self.signed(),
            _ => 20.0 * self.signed(),
        }
    }

    /// Of length 1.
    pub fn attitude(&mut self) -> Quaternion<f64> {
        let q = self.vector().push(self.signed());
        Quaternion::from_vector(q / q.norm())
    }
}

/// The hash of `rounds` rounds of answers, of some hundred numbers each.
#[must_use]
pub fn hash(rounds: u32) -> Hash {
    let (mut hash, mut random) = (Hash::default(), Random(14));
    named_bodies(&mut hash);
    for _ in 0..rounds {
        exact(&mut hash, &mut random);
        batch(&mut hash, &mut random);
        stepped(&mut hash, &mut random);
        tensor(&mut hash, &mut random);
        in_an_engine(&mut hash, &mut random);
    }
    hash
}

/// The ready bodies: mass, centre, tensor.
fn named_bodies(hash: &mut Hash) {
    for body in NamedBody::ALL {
        hash.answer(body.properties(), |hash, properties| {
            hash.put(properties.mass());
            hash.all(&properties.centre());
            hash.all(&properties.inertia().matrix());
        });
    }
}

/// The closed form at several times, and what is read off it.
fn exact(hash: &mut Hash, random: &mut Random) {
    let (moments, omega) = random.motion();
    hash.answer(FreeMotion::new(moments, &omega), |hash, motion| {
        for _ in 0..8 {
            let t = random.time();
            hash.answer(motion.at(t), |hash, instant| {
                hash.all(&instant.omega);
                hash.all(&instant.attitude.coords);
            });
        }
        hash.answer(motion.state_transition(random.time()), |hash, transition| hash.all(&transition));
        hash.answer(motion.sensitivities(random.time()), |hash, (_, by_tensor)| hash.all(&by_tensor));
        hash.answer(motion.period(), |hash, period| hash.put(period.unwrap_or(f64::NAN)));
        hash.answer(motion.next_flip(0.0), |hash, flip| hash.put(flip.unwrap_or(f64::NAN)));
        hash.put(motion.twist_of_half_period().unwrap_or(f64::NAN));
        for axis in tumbling::Axis::ALL {
            hash.answer(motion.angles_to_momentum(axis), |hash, angles| hash.all(&angles));
        }
    });
}

/// Several bodies answered together.
fn batch(hash: &mut Hash, random: &mut Random) {
    let motions: Vec<_> = (0..4)
        .filter_map(|_| {
            let (moments, omega) = random.motion();
            FreeMotion::new(moments, &omega).ok()
        })
        .collect();
    let times = [random.time(), random.time()];
    let mut answers = vec![[f64::NAN; 7]; 2 * motions.len()];
    let answered = Batch::<f64>::new(&motions).each(&times, |time, body, instant| {
        let (w, q) = (instant.omega, instant.attitude.coords);
        answers[2 * body + time] = [w.x, w.y, w.z, q.x, q.y, q.z, q.w];
    });
    hash.answer(answered, |hash, ()| hash.all(answers.iter().flatten()));
}

/// A few steps of every method, with and without torques, in both precisions.
fn stepped(hash: &mut Hash, random: &mut Random) {
    let torques = match random.bits() % 3 {
        0 => vec![],
        1 => vec![Torque::gravity(&random.vector(), random.signed()), Torque::Damping(random.vector().abs())],
        _ => {
            vec![Torque::InBody(random.vector()), Torque::InWorld(random.vector()), Torque::Dissipation(0.01)]
        }
    };
    hash.answer(System::with(random.moments(), torques), |hash, system| {
        let start = State { attitude: random.attitude(), momentum: random.vector() };
        let h = 0.1 * random.size(4);
        for method in Method::ALL {
            let end = (0..3).try_fold(start, |state, _| method.step(&system, &state, h));
            hash.answer(end, |hash, end| hash.state(&end));
        }
        let end = (0..3).try_fold(start, |state, _| fixed_rate(&system, &state, 4.0 * h));
        hash.answer(end, |hash, end| hash.state(&end));
        // So short that a needle's spin and a stiff torque are no work.
        let short = h * system.moments().min();
        let stepper = Stepper::of_system(system.clone(), &start, 1e-9, 1_000_000);
        let end = stepper.and_then(|mut stepper| stepper.step_to(short * short));
        hash.answer(end, |hash, end| hash.state(&end));
        singles(hash, &system, &start);
    });
}

/// The position stage, in both precisions, in one part and in several.
fn in_an_engine(hash: &mut Hash, random: &mut Random) {
    let (moments, attitude, frame) = (random.moments().vector(), random.attitude(), random.attitude());
    let (omega, h) = (random.vector() * 8.0, 0.1 * random.size(6));
    let body = PositionStage::new(&moments).and_then(|body| body.in_frame(frame));
    hash.answer(body, |hash, body| {
        let end = body.step(&attitude, &omega, h);
        hash.all(end.attitude.coords.iter().chain(&end.omega));
    });
    let [attitude, frame] = [attitude, frame].map(|q| Quaternion::from_vector(q.coords.cast::<f32>()));
    let body = PositionStage::new(&moments.cast::<f32>()).and_then(|body| body.in_frame(frame));
    hash.answer(body, |hash, body| {
        let end = body.step(&attitude, &omega.cast(), h as f32);
        hash.all(end.attitude.coords.cast::<f64>().iter().chain(&end.omega.cast::<f64>()));
    });
}

/// Two methods in single precision.
fn singles(hash: &mut Hash, system: &System<f64>, start: &State<f64>) {
    let torques = vec![Torque::Damping(Vector3::new(0.1, 0.2, 0.3)), Torque::Dissipation(0.01)];
    let system = System::of_numbers(system.moments().map(|x| x as f32), torques);
    let start = State {
        attitude: Quaternion::from_vector(start.attitude.coords.map(|x| x as f32)),
        momentum: start.momentum.map(|x| x as f32),
    };
    for method in [Method::RotationSplitting2, Method::MuntheKaas4, Method::MoserVeselov4] {
        hash.answer(method.step(&system, &start, 0.05), |hash, end| {
            let state = State {
                attitude: Quaternion::from_vector(end.attitude.coords.map(f64::from)),
                momentum: end.momentum.map(f64::from),
            };
            hash.state(&state);
        });
    }
}

/// A tensor in any axes: its principal ones, the angle to the momentum, and the body's exact motion.
fn tensor(hash: &mut Hash, random: &mut Random) {
    let turn = UnitQuaternion::new_unchecked(random.attitude());
    let r = turn.to_rotation_matrix().into_inner();
    let tensor = r * Matrix3::from_diagonal(&random.moments().vector()) * r.transpose();
    let symmetric = (tensor + tensor.transpose()) * 0.5;
    hash.answer(Inertia::try_from(symmetric), |hash, inertia| {
        let principal = inertia.principal();
        hash.all(&principal.frame());
        hash.all(
            &UnitQuaternion::from_rotation_matrix(&Rotation3::from_matrix_unchecked(principal.frame()))
                .coords,
        );
        let omega = random.vector();
        hash.answer(inertia.angle_to_momentum(&omega), Hash::put);
        hash.answer(Body::spinning(inertia, turn, &omega), |hash, body| {
            hash.answer(
                FreeMotion::of(&body).and_then(|motion| motion.at(random.time())),
                |hash, instant| {
                    hash.all(&instant.omega);
                    hash.all(&instant.attitude.coords);
                },
            );
        });
    });
}
