//! The equation that a step of Moser and Veselov solves: near zero it has one solution, and the motion obeys
//! it to the step's order. So the step agrees with the motion to that order.
//!
//! The equation is written here a second time. That the library's own step solves it is checked on letters.

use crate::number::{Fraction, Relations, Symbol};
use crate::proof::Case;
use crate::proofs::methods::{alike, any, step};
use crate::proofs::order::{Number, constant, exact};
use crate::symbols::{Vector, adjugate, diagonal, quaternion, vector};
use crate::tex::Scope;
use nalgebra::{Matrix3, Vector3};
use num_traits::One;
use tumbling::attitude::rotation_matrix;
use tumbling::laws::altered;
use tumbling::step::Method::{
    self, ImplicitMidpoint, MoserVeselov2, MoserVeselov4, MoserVeselov6, MoserVeselov8, MoserVeselov10,
};
use tumbling::step::State;

proofs! {
    "step" {
        [Again] "moser-veselov-has-one-solution": one_solution(1, 2),
            r"A turn by a quaternion of length one with the parts $w$ and $p$ takes the vector $M$ in body axes to $N$ with $w (M - N) = p\times (M + N)$. So where half of the sum of two such vectors is the part $w$ times a diagonal matrix times the other part, the first vector is $n = w K p + p\times (K p)$, and the half-angle tangents $t = p/w$ solve $K t + t\times (K t) = (1 + t\cdot t) n$. What two triples of tangents leave of that equation, $E = K b + b\times (K b) - (1 + b\cdot b) n$ and $F = K c + c\times (K c) - (1 + c\cdot c) n$, differs by a matrix times their difference, $E - F = A (b - c)$. Where both are zero the determinant of the matrix is $d = K_1 K_2 K_3$, which is zero for no body. So by the implicit function theorem one power series without a constant term solves the equation, and a series that obeys it through a power is that one through this power.";
            but "the turn taken the other way": one_solution(-1, 2),
            but "the matrix taken at one of the two": one_solution(1, 1),
        "moser-veselov-is-obeyed": obeyed(0, [0, 0]),
            r"Four times the product of the two parts of a turn is the step times the altered inverse moments times the sum of the momenta before and after it. This equation, with the inverse moments that the code of the step alters, whichever moment is taken for the smallest, and with the differences of the body's own, is obeyed on letters by each step of Moser and Veselov through the power $p = 5$ of the step, and by the motion of every free body through the orders $p_1 = 2$, $p_2 = 4$, $p_3 = 6$, $p_4 = 8$ and $p_5 = 10$, and no further; in units of the first moment. The step of the implicit midpoint obeys, through the power $m = 5$, that of the body's own inverse moments with the first part of the turn on the other side.";
            but "one coefficient of the factor of the inverse moments off by one": obeyed(8, [1, 0]),
            but "one coefficient of what is added to them off by one": obeyed(8, [0, 1]),
    }
}

/// The turn's sign, and of how many triples of tangents the mean is taken for the matrix.
fn one_solution(sign: i64, of: i64) -> Vec<Scope> {
    let names = ["w", "p1", "p2", "p3"];
    let (w, p, moments, n) = (Fraction::variable("w"), vector("p"), vector("K"), vector("n"));
    let turn = rotation_matrix(&quaternion(w.clone(), &p.map(|x| x * Fraction::from(sign))));
    let scope = Scope::default().with("M", vector("M")).with("N", turn.transpose() * vector("M"));
    let turn = scope.with("w", w.clone()).with("p", p.clone()).under(Relations::unit_quaternion(names));
    let k = diagonal(&moments);
    let before = (&k * &p).map(|x| x * &w) + p.cross(&(&k * &p));
    let solved = turn.clone().with("n", before).with("t", p.map(|x| x / &w)).with("K", k.clone());
    let left = |t: &Vector| &k * t + t.cross(&(&k * t)) - n.map(|x| x * (Fraction::one() + t.dot(t)));
    let [b, c] = ["b", "c"].map(vector);
    let [one, other] = [left(&b), left(&c)];
    let names = ["c1", "c2", "c3"].map(Symbol::from);
    let slopes = Matrix3::from_fn(|i, j| other[i].derivative(&names[j]));
    let mean = (&c * Fraction::from(of - 1) + &b).map(|x| x / Fraction::from(of));
    let [between, zero] = [mean, Vector::zeros()]
        .map(|at| slopes.map(|x| names.iter().zip(&at).fold(x, |x, (name, to)| x.substitute(name, to))));
    let scope = Scope::default().with("E", one).with("F", other).with("A", between).with("b", b).with("c", c);
    let scope = scope.with("d", adjugate(&zero).1).with("K", k).with_each("K", &moments);
    vec![turn, solved, scope.with("n", n)]
}

/// The highest powers through which the steps and the motion obey the equation, up to the first of the motion
/// that is not the order. For one order the two first coefficients of its last power are off by so much.
fn obeyed(of: u32, off: [i64; 2]) -> Case {
    let ((system, start), mut least) = (any(), 5);
    let few = Number::step(least);
    let middle = step(ImplicitMidpoint, &system, &start, &few)?;
    let middle = through(ImplicitMidpoint, [&start, &middle], &few, [0, 0])?;
    let mut scope = Scope::default().with("m", Fraction::from(middle as i64));
    for method in [MoserVeselov2, MoserVeselov4, MoserVeselov6, MoserVeselov8, MoserVeselov10] {
        let order = method.info().order as usize;
        let off = if method.info().order == of { off } else { [0, 0] };
        let end = step(method, &system, &start, &few)?;
        least = least.min(through(method, [&start, &end], &few, off)?);
        let end = exact(&start, order + 1, |motion| system.rate(motion));
        let last = through(method, [&start, &end], &Number::step(order + 1), off)?;
        scope = scope.with(&format!("p_{}", order / 2), Fraction::from(last as i64));
        if last != order {
            break;
        }
    }
    Ok(scope.with("p", Fraction::from(least as i64)))
}

/// The highest power known through which the equation holds between two states, a step `h` apart.
fn through(method: Method, [start, end]: [&State<Number>; 2], h: &Number, off: [i64; 2]) -> Case<usize> {
    let (system, order, turn) = (any().0, method.info().order, &end.attitude.coords);
    let both = [turn.w.clone(), Number::one()];
    let [left, right] = if method == ImplicitMidpoint { [&both[1], &both[0]] } else { [&both[0], &both[1]] };
    let turned = turn.xyz().map(|x| x * left.clone() * constant(&Fraction::from(4)));
    let inverse = system.omega(&Vector3::repeat(Number::one()));
    let less = Vector3::from_fn(|i, _| inverse[(i + 1) % 3].clone() - inverse[(i + 2) % 3].clone());
    let [push, sum] = [&start.momentum, &(&start.momentum + &end.momentum)].map(|v| v.map(|x| x * h.clone()));
    let mut last = h.order().unwrap_or_default();
    for axis in 0..3 {
        let [mut altered, differences] = altered(axis, system.moments(), &push, order);
        alike("the differences", method, less.as_slice(), differences.as_slice(), 0..=0)?;
        // The code's unit, and the highest power of the momentum that a coefficient of this order has there.
        let unit = (inverse.sum() - inverse[axis].clone()) * constant(&Fraction::ratio(1, 2));
        let square = push.dot(&push) * unit.clone() * unit.clone();
        let power = (2..order / 2).fold(square.clone(), |power, _| power * square.clone());
        let [times, plus] = off.map(|n| power.clone() * constant(&Fraction::ratio(n, 20_160)));
        altered.zip_apply(&inverse, |x, own| *x += own * times.clone() + unit.clone() * plus.clone());
        let equation = altered.component_mul(&sum).map(|x| x * right.clone());
        let alike = |n: usize| alike("it", method, turned.as_slice(), equation.as_slice(), n..=n);
        last = (0..=last).find(|n| alike(*n).is_err()).map_or(last, |n| n.saturating_sub(1));
    }
    Ok(last)
}
