//! The steps of many bodies at once, in vector registers.

use super::coefficients::Coefficients;
use super::{End, PositionStage, Stepped, turn_square};
use crate::number::Field;
use nalgebra::{Quaternion, Vector3};
use num_traits::Float;

/// The number of bodies in one block.
const LANES: usize = 8;

/// The inputs of a block: attitude, spin, coefficients and frame.
type Rows<T> = [[T; LANES]; 29];

/// The results of a block: attitude, spin, and the values that decide whether a step is taken.
type Ends<T> = [[T; LANES]; 10];

impl<T: Field + Float + From<f32>> PositionStage<T> {
    /// The [`step`](Self::step) of `h` seconds for many bodies, in blocks of eight, which the compiler turns
    /// into vector instructions. The result of each body has the same bits as if it were computed alone.
    ///
    /// `all` is the engine's storage and `bodies` are the keys of the bodies in it. `read` returns a body's
    /// stage, attitude and spin, and `write` receives the end of its step. The order of the calls is not
    /// specified, so each key must occur only once. A body that needs no gyroscopic term (all moments
    /// equal, at rest, locked) is finished at once, without a block.
    ///
    /// ```
    /// use nalgebra::{Quaternion, Vector3};
    /// use tumbling::step::PositionStage;
    /// struct Bodies {
    ///     stages: Vec<PositionStage<f32>>,
    ///     moving: Vec<(Quaternion<f32>, Vector3<f32>)>,
    /// }
    /// let stages = vec![PositionStage::new(&Vector3::new(1.0, 2.0, 3.0))?; 20];
    /// let start = |k: u8| (Quaternion::identity(), Vector3::new(0.3, f32::from(k), 0.0));
    /// let moving: Vec<_> = (0..20).map(start).collect();
    /// let alone: Vec<_> = moving.iter().map(|(q, w)| stages[0].step(q, w, 0.01)).collect();
    /// let mut bodies = Bodies { stages, moving };
    /// PositionStage::step_all(
    ///     &mut bodies,
    ///     0..20,
    ///     0.01,
    ///     |bodies, k| (&bodies.stages[k], bodies.moving[k].0, bodies.moving[k].1),
    ///     |bodies, k, end| bodies.moving[k] = (end.attitude, end.omega),
    /// );
    /// assert!(alone.iter().zip(&bodies.moving).all(|(end, now)| (end.attitude, end.omega) == *now));
    /// # Ok::<(), tumbling::Error>(())
    /// ```
    pub fn step_all<A: ?Sized, I: Copy>(
        all: &mut A,
        bodies: impl IntoIterator<Item = I>,
        h: T,
        read: impl Fn(&A, I) -> (&Self, Quaternion<T>, Vector3<T>),
        mut write: impl FnMut(&mut A, I, Stepped<T>),
    ) {
        // Bodies whose principal axes differ from the body axes form blocks of their own.
        let mut kinds = [([[T::zero(); LANES]; 29], [None; LANES], 0); 2];
        for body in bodies {
            let (stage, attitude, omega) = read(all, body);
            if turn_square(&omega, h) <= stage.coefficients.steady {
                let end = stage.step(&attitude, &omega, h);
                write(all, body, end);
                continue;
            }
            let framed = stage.frame.is_some();
            let (rows, waiting, count) = &mut kinds[usize::from(framed)];
            fill(rows, *count, stage, &attitude, &omega);
            waiting[*count] = Some(body);
            *count = (*count + 1) % LANES;
            if *count == 0 {
                let ends = if framed { ends_of::<T, true> } else { ends_of::<T, false> }(rows, h);
                for (k, body) in waiting.iter_mut().enumerate() {
                    let Some(body) = body.take() else { continue };
                    let end = end_of(&ends, k);
                    // Each kind has a function call of its own, so that the numbers stay in registers.
                    if end.taken() {
                        write(all, body, end.stepped());
                    } else {
                        let end = alone(read(all, body), h);
                        write(all, body, end);
                    }
                }
            }
        }
        for body in kinds.into_iter().flat_map(|(_, waiting, _)| waiting).flatten() {
            let end = alone(read(all, body), h);
            write(all, body, end);
        }
    }
}

/// For bodies that do not fill a block, and for steps that need several parts.
#[inline(never)]
fn alone<T: Field + Float + From<f32>>(
    (stage, attitude, omega): (&PositionStage<T>, Quaternion<T>, Vector3<T>),
    h: T,
) -> Stepped<T> {
    stage.step(&attitude, &omega, h)
}

#[inline(always)]
fn fill<T: Field + Float + From<f32>>(
    rows: &mut Rows<T>,
    k: usize,
    stage: &PositionStage<T>,
    attitude: &Quaternion<T>,
    omega: &Vector3<T>,
) {
    let (c, q) = (&stage.coefficients, &attitude.coords);
    let mut put = |from: usize, numbers: &[T]| {
        for (i, x) in numbers.iter().enumerate() {
            rows[from + i][k] = *x;
        }
    };
    put(0, &[q.w, q.x, q.y, q.z, omega.x, omega.y, omega.z]);
    put(7, &c.coupling);
    put(10, &c.relative);
    put(13, &c.twist);
    put(16, &c.twist_2);
    put(22, &c.bound);
    if let Some(frame) = &stage.frame {
        put(25, &[frame.coords.w, frame.coords.x, frame.coords.y, frame.coords.z]);
    }
}

/// The ends of the steps of eight bodies. The compiler turns the loop into vector instructions.
#[inline(never)]
fn ends_of<T: Field + Float + From<f32>, const FRAMED: bool>(rows: &Rows<T>, h: T) -> Ends<T> {
    let mut ends = [[T::zero(); LANES]; 10];
    for k in 0..LANES {
        let row = |i: usize| rows[i][k];
        let three = |i: usize| [row(i), row(i + 1), row(i + 2)];
        let quaternion = |i: usize| Quaternion::new(row(i), row(i + 1), row(i + 2), row(i + 3));
        let coefficients = Coefficients {
            coupling: three(7),
            relative: three(10),
            twist: three(13),
            twist_2: [row(16), row(17), row(18), row(19), row(20), row(21)],
            bound: three(22),
            steady: T::zero(),
        };
        let frame = if FRAMED { Some(quaternion(25)) } else { None };
        let End { attitude, omega, turn, length, factor } =
            PositionStage { coefficients, frame }.turn(&quaternion(0), &three(4).into(), h);
        let q = attitude.coords;
        let numbers = [q.w, q.x, q.y, q.z, omega.x, omega.y, omega.z, turn, length, factor];
        for (row, x) in ends.iter_mut().zip(numbers) {
            row[k] = x;
        }
    }
    ends
}

#[inline(always)]
fn end_of<T: Field + Float + From<f32>>(ends: &Ends<T>, k: usize) -> End<T> {
    let at = |i: usize| ends[i][k];
    End {
        attitude: Quaternion::new(at(0), at(1), at(2), at(3)),
        omega: Vector3::new(at(4), at(5), at(6)),
        turn: at(7),
        length: at(8),
        factor: at(9),
    }
}
