//! The exact motion as a power series in the time.

use crate::number::{Fraction, Series};
use crate::symbols::vector;
use nalgebra::Quaternion;
use num_traits::{One, Zero};
use tumbling::laws::Rate;
use tumbling::number::Field;
use tumbling::step::State;

pub type Number = Series<Fraction>;
pub(super) fn constant(x: &Fraction) -> Number {
    Series::constant(x.clone())
}

/// At the start the body's axes are the world's, which loses nothing: the world's are ours to choose.
pub(super) fn start() -> State<Number> {
    let [one, zero] = [Number::one(), Number::zero()];
    let attitude = Quaternion::new(one, zero.clone(), zero.clone(), zero);
    State { attitude, momentum: vector("L").map(|x| constant(&x)) }
}

/// The exact motion of a state under a law, to the power `order`: each round of `y = y0 + ∫ law(y)` settles
/// one more.
pub fn exact<T: Field>(
    start: &State<Series<T>>,
    order: usize,
    law: impl Fn(&State<Series<T>>) -> Rate<Series<T>>,
) -> State<Series<T>> {
    let (attitude, momentum) = (&start.attitude.coords, &start.momentum);
    let cut = Quaternion::from_vector(attitude.map(|x| x.cut(0)));
    let mut motion = State { attitude: cut, momentum: momentum.map(|x| x.cut(0)) };
    for _ in 0..order {
        let rate = law(&motion);
        let turned = attitude.zip_map(&rate.attitude.coords, |y, f| y + f.integral());
        let momentum = momentum.zip_map(&rate.momentum, |y, f| y + f.integral());
        motion = State { attitude: Quaternion::from_vector(turned), momentum };
    }
    motion
}

/// Attitude and momentum.
pub(super) fn components<T: Field>(m: &State<Series<T>>) -> Vec<Series<T>> {
    m.attitude.coords.iter().chain(&m.momentum).cloned().collect()
}
