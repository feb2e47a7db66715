//! The angle between spin and momentum.

use crate::number::{Fraction, Rational};
use crate::proof::{Outcome, Residue, positive, same};
use crate::symbols::{Vector, diagonal, ordered_moments, variables, vector};
use num_traits::{One, Zero};
use tumbling::dynamics::euler::{coupling, tensor_times_acceleration};
use tumbling::solid::{Cuboid, Shape};

proofs! {
    "inertia" {
        "gap-of-a-box": box_gap(|m, a, b, c| Cuboid::moments(m, [a, b, c])),
            "For every box spun equally about x and y the tangent of the gap is (a² - b²)/(a² + b² + 2 c²), whatever it weighs; for edges 2, 1, 3 that is 3/23.";
            but "edges a and b swapped": box_gap(|m, a, b, c| Cuboid::moments(m, [b, a, c])),
        "gap-is-zero-on-principal-axes-alone": zero_gap(&ordered_moments(), coupling),
            "|L x w|² is a sum of squares, one for each pair of axes, each with a positive factor if the moments differ: it vanishes only where two of the three components of the spin do.";
            but "one pair left out": zero_gap(&ordered_moments(), |i, w| { let mut x = coupling(i, w); x.y = Fraction::zero(); x }),
            but "moments in no order, whose differences may vanish": zero_gap(&vector("I"), coupling),
        "momentum-leans-to-the-heavier-axis": lean(1),
            "For all moments, L is turned from w towards the axis with the larger moment: L_j / L_i - w_j / w_i is positive if I_j exceeds I_i and the components are positive.";
            but "towards the lighter axis": lean(-1),
        "gap-is-never-a-right-angle": acute(1),
            "w.L is positive for every spin but none: the angle between them stays below a right angle.";
            but "one moment with a minus": acute(-1),
        "largest-gap": largest(4),
            "Between two axes with moments I and J the gap is largest where the spin's slope squared is I / J; its tangent squared is then (J - I)² / (4 I J), and everywhere else less, by a square.";
            but "4 becomes 2": largest(2),
    }
}

fn box_gap(law: impl Fn(&Fraction, &Fraction, &Fraction, &Fraction) -> Vector) -> Outcome {
    let [m, a, b, c] = variables(["m", "a", "b", "c"]);
    let tensor = diagonal(&law(&m, &a, &b, &c));
    let omega = Vector::new(Fraction::one(), Fraction::one(), Fraction::zero());
    let momentum = &tensor * &omega;
    // L x w, as the law of motion has it; it has one component, so its length is that.
    let cross = tensor_times_acceleration(&tensor, &omega, &Vector::zeros());
    same("L x w along x", &cross.x, &Fraction::zero())?;
    same("L x w along y", &cross.y, &Fraction::zero())?;
    // Turned from w towards L, about z.
    let tangent = -cross.z.clone() / omega.dot(&momentum);
    let [a2, b2, c2] = [a, b, c].map(|x| x.pow(2));
    same("the tangent", &tangent, &((&a2 - &b2) / (a2 + b2 + Fraction::from(2) * c2)))?;
    let edges = [("a", 2), ("b", 1), ("c", 3), ("m", 1)].map(|(name, size)| (name, Rational::from(size)));
    same("the book's box", &tangent.at(&edges).into(), &Fraction::ratio(3, 23))
}

fn zero_gap(moments: &Vector, law: impl Fn(&Vector, &Vector) -> Vector) -> Outcome {
    let omega = vector("omega");
    let cross = law(moments, &omega);
    let square = cross.dot(&cross);
    let mut sum = Fraction::zero();
    for (i, j) in [(0, 1), (1, 2), (2, 0)] {
        let factor = (&moments[i] - &moments[j]).pow(2);
        positive("the factor of a pair", &factor)?;
        sum += factor * omega[i].pow(2) * omega[j].pow(2);
    }
    same("|L x w|²", &square, &sum)
}

fn lean(factor: i64) -> Outcome {
    let (moments, omega) = (ordered_moments(), vector("omega"));
    let momentum = diagonal(&moments) * &omega;
    for (light, heavy) in [(0, 1), (1, 2), (0, 2)] {
        let lean = &momentum[heavy] / &momentum[light] - &omega[heavy] / &omega[light];
        positive("the lean", &(lean * Fraction::from(factor)))?;
    }
    Ok(())
}

fn acute(factor: i64) -> Outcome {
    let mut moments = vector("I");
    moments.y *= Fraction::from(factor);
    let omega = vector("omega");
    let dot = omega.dot(&(diagonal(&moments) * &omega));
    // Only squares of the spin, each with a positive factor.
    for (monomial, _) in dot.numerator().terms() {
        if (0..3).all(|i| monomial.degree_in(&format!("omega{}", i + 1).as_str().into()) != 2) {
            return Err(Residue::NotOneSign {
                claim: "w.L in squares of w".to_owned(),
                quantity: dot.clone(),
            });
        }
    }
    positive("w.L", &dot)
}

fn largest(divisor: i64) -> Outcome {
    let [i, j, slope] = variables(["I", "J", "t"]);
    let moments = Vector::new(i.clone(), j.clone(), Fraction::one());
    let omega = Vector::new(Fraction::one(), slope.clone(), Fraction::zero());
    let cross = coupling(&moments, &omega);
    let tangent = &cross.z / &omega.dot(&(diagonal(&moments) * &omega));
    let most = (&j - &i).pow(2) / (Fraction::from(divisor) * &i * j.clone());
    // What is missing from the largest is (J - I)² (J t² - I)² over something positive.
    let below = Fraction::from(4) * &i * &j * (&i + &j * slope.pow(2)).pow(2);
    let missing = (&j - &i).pow(2) * (&j * slope.pow(2) - i).pow(2) / below.clone();
    positive("the square's divisor", &below)?;
    same("the tangent squared", &tangent.pow(2), &(most - missing))
}
