//! Evaluations of the law that a step is worth, by counting: the library's steps run on numbers that count.

use nalgebra::{Quaternion, Vector3};
use num_traits::{One, Zero};
use std::cell::Cell;
use std::ops::{Add, AddAssign, Div, DivAssign, Mul, MulAssign, Neg, Sub, SubAssign};
use tumbling::number::Analytic;
use tumbling::step::{Method, State, System, Torque};

thread_local! {
    static COUNT: Cell<u64> = const { Cell::new(0) };
}

/// An `f64` that counts what is done with it: sums, products, quotients, roots, exponentials one each, a sine
/// with its cosine two. A product with the constant one is free, as is a change of sign.
#[derive(Debug, Clone, Copy)]
pub struct Tallied {
    value: f64,
    unity: bool,
}

impl Tallied {
    const fn new(value: f64) -> Self {
        Self { value, unity: false }
    }
}

impl PartialEq for Tallied {
    fn eq(&self, other: &Self) -> bool {
        self.value == other.value
    }
}

impl PartialOrd for Tallied {
    fn partial_cmp(&self, other: &Self) -> Option<std::cmp::Ordering> {
        self.value.partial_cmp(&other.value)
    }
}

fn tally(n: u64) {
    COUNT.set(COUNT.get() + n);
}

macro_rules! tallied {
    ($Op:ident $op:ident $OpAssign:ident $op_assign:ident) => {
        impl $Op for Tallied {
            type Output = Self;
            fn $op(self, other: Self) -> Self {
                let free = stringify!($op) == "mul" && (self.unity || other.unity);
                tally(u64::from(!free));
                Self::new(self.value.$op(other.value))
            }
        }
        impl $OpAssign for Tallied {
            fn $op_assign(&mut self, other: Self) {
                *self = self.$op(other);
            }
        }
    };
}
tallied!(Add add AddAssign add_assign);
tallied!(Sub sub SubAssign sub_assign);
tallied!(Mul mul MulAssign mul_assign);
tallied!(Div div DivAssign div_assign);

impl Neg for Tallied {
    type Output = Self;
    fn neg(self) -> Self {
        Self::new(-self.value)
    }
}

impl Zero for Tallied {
    fn zero() -> Self {
        Self::new(0.0)
    }
    fn is_zero(&self) -> bool {
        self.value == 0.0
    }
}

impl One for Tallied {
    fn one() -> Self {
        Self { value: 1.0, unity: true }
    }
}

impl Analytic for Tallied {
    fn sqrt(&self) -> Self {
        tally(1);
        Self::new(self.value.sqrt())
    }
    fn sin_cos(&self) -> (Self, Self) {
        tally(2);
        let (sine, cosine) = self.value.sin_cos();
        (Self::new(sine), Self::new(cosine))
    }
    fn exp(&self) -> Self {
        tally(1);
        Self::new(self.value.exp())
    }
    fn cos_sinc_of_root(&self) -> (Self, Self) {
        // A root, a sine with its cosine, a quotient.
        tally(4);
        let (cosine, sinc) = self.value.cos_sinc_of_root();
        (Self::new(cosine), Self::new(sinc))
    }
    fn size(&self) -> f64 {
        self.value.abs()
    }
    fn rounding() -> f64 {
        f64::EPSILON
    }
}

fn vector(v: &Vector3<f64>) -> Vector3<Tallied> {
    v.map(Tallied::new)
}

fn counting(system: &System<f64>) -> Option<System<Tallied>> {
    let torques = system.torques().iter().map(|torque| {
        Some(match torque {
            Torque::InBody(v) => Torque::InBody(vector(v)),
            Torque::InWorld(v) => Torque::InWorld(vector(v)),
            Torque::Aligning { arm, field } => Torque::Aligning { arm: vector(arm), field: vector(field) },
            Torque::Damping(v) => Torque::Damping(vector(v)),
            Torque::Dissipation(strength) => Torque::Dissipation(Tallied::new(*strength)),
            _ => return None,
        })
    });
    Some(System::of_numbers(vector(system.moments()), torques.collect::<Option<_>>()?))
}

fn counted<R>(work: impl FnOnce() -> R) -> (R, u64) {
    COUNT.set(0);
    let result = work();
    (result, COUNT.get())
}

/// Steps over which the mean is taken: an implicit method's differ.
const STEPS: u32 = 16;

/// How many evaluations of the law (`System::rate`) one step of this length costs in arithmetic: operations
/// of a step over operations of an evaluation. `None` if the method refuses that step.
///
/// So a method without evaluations, as those made of rotations, is held to the same measure as one with
/// nothing else.
#[must_use]
pub fn evaluations_of_step(
    method: Method,
    system: &System<f64>,
    start: &State<f64>,
    step: f64,
) -> Option<f64> {
    let system = counting(system)?;
    let [x, y, z, w] = start.attitude.coords.map(Tallied::new).into();
    let mut motion = State { attitude: Quaternion::new(w, x, y, z), momentum: vector(&start.momentum) };
    let (_, law) = counted(|| system.rate(&motion));
    let h = Tallied::new(step);
    let (done, steps) = counted(|| {
        for _ in 0..STEPS {
            motion = method.step(&system, &motion, h).ok()?;
        }
        Some(())
    });
    done?;
    let each = steps as f64 / law as f64 / f64::from(STEPS);
    Some(each)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Four evaluations, and the sums between them.
    #[test]
    fn a_step_of_runge_kutta_is_worth_four_evaluations_and_some_sums() {
        let stories = crate::story::all().unwrap();
        let worth =
            |method| evaluations_of_step(method, &stories[0].system, &stories[0].start, 0.01).unwrap();
        let (euler, classical) = (worth(Method::ExplicitEuler), worth(Method::RungeKutta4));
        assert!(euler > 1.0 && euler < 1.5, "{euler}");
        // The law is 42 operations: 3 for the spin, 24 and 9 for the rates of attitude and momentum, 3 to add
        // the torque, and 3 to make the number two. The sums between the four are about three times that.
        assert!(classical > 6.5 && classical < 7.5, "{classical}");
    }
}
