//! The angle between spin and momentum.

use crate::equations::slant;
use crate::number::Fraction;
use crate::proof::{Residue, positive};
use crate::symbols::{Vector, diagonal, momentum, ordered_moments, variables, vector};
use crate::tex::Scope;
use num_traits::{One, Zero};
use tumbling::dynamics::euler::{coupling, tensor_times_acceleration};
use tumbling::solid::{Cuboid, Shape};

proofs! {
    "inertia" {
        "gap-of-a-box": box_gap(|m, a, b, c| Cuboid::moments(m, [a, b, c])),
            r"For every box with the spin $\omega = (1, 1, 0)$ the gap has $\tan(\text{gap}) = (a^2 - b^2)/(a^2 + b^2 + 2 c^2)$, whatever the box weighs: $L\times\omega = (0, 0, -\tan(\text{gap})\omega\cdot L)$.";
            but "edges a and b swapped": box_gap(|m, a, b, c| Cuboid::moments(m, [b, a, c])),
        "gap-is-zero-on-principal-axes-alone": zero_gap(&ordered_moments(), coupling),
            r"Of $C = L\times\omega$ the square is a sum of squares, each with a positive factor if the moments differ: $C\cdot C = (I_1 - I_2)^2\omega_1^2\omega_2^2 + (I_2 - I_3)^2\omega_2^2\omega_3^2 + (I_3 - I_1)^2\omega_3^2\omega_1^2$. So it vanishes only where two of the three components of the spin do.";
            but "one pair left out": zero_gap(&ordered_moments(), |i, w| { let mut x = coupling(i, w); x.y = Fraction::zero(); x }),
            but "moments in no order, whose differences may vanish": zero_gap(&vector("I"), coupling),
        "momentum-leans-to-the-heavier-axis": lean([[0, 1], [1, 2], [0, 2]]),
            r"For all moments, the momentum is turned from the spin towards the axis with the larger moment: with positive components, and the larger moment about the second axis, $L_j/L_i - \omega_j/\omega_i > 0$.";
            but "towards the lighter axis": lean([[1, 0], [2, 1], [2, 0]]),
        "gap-is-never-a-right-angle": acute(1),
            r"The product $\omega\cdot L = I_1\omega_1^2 + I_2\omega_2^2 + I_3\omega_3^2$ is positive for every spin that is not zero: the angle stays below a right angle.";
            but "one moment with a minus": acute(-1),
        "largest-gap": slant(),
            r"Between two axes with moments $a$ and $b$ the gap has $\tan(\text{gap})^2 = \frac{(b - a)^2}{4 a b} - \frac{(b - a)^2 (b\tan(\theta)^2 - a)^2}{4 a b (a + b\tan(\theta)^2)^2}$, of which the last term, with $4 a b (a + b\tan(\theta)^2)^2 > 0$, is zero at the largest gap alone.";
            but "the moments exchanged": exchanged(),
    }
}

/// The tangent of the gap of a box spun equally about x and y.
pub(crate) fn box_gap(law: impl Fn(&Fraction, &Fraction, &Fraction, &Fraction) -> Vector) -> Scope {
    let [m, a, b, c] = variables(["m", "a", "b", "c"]);
    let tensor = diagonal(&law(&m, &a, &b, &c));
    let omega = Vector::new(Fraction::one(), Fraction::one(), Fraction::zero());
    let momentum = &tensor * &omega;
    // L x w, as the law of motion has it. Turned from w towards L, about z.
    let cross = tensor_times_acceleration(&tensor, &omega, &Vector::zeros());
    let tangent = -cross.z.clone() / omega.dot(&momentum);
    let scope = Scope::default().with_all([("a", a), ("b", b), ("c", c), (r"\tan(\text{gap})", tangent)]);
    scope.with("L", momentum).with(r"\omega", omega)
}

fn zero_gap(moments: &Vector, law: impl Fn(&Vector, &Vector) -> Vector) -> Result<Scope, Residue> {
    let omega = vector("omega");
    for (i, j) in [(0, 1), (1, 2), (2, 0)] {
        positive("the factor of a pair", &(&moments[i] - &moments[j]).pow(2))?;
    }
    let scope = Scope::default().with_each("I", moments).with_each(r"\omega", &omega);
    Ok(scope.with("C", law(moments, &omega)).with("L", diagonal(moments) * &omega).with(r"\omega", omega))
}

/// With the larger moment of each pair about the second axis.
fn lean(pairs: [[usize; 2]; 3]) -> Vec<Scope> {
    let (moments, omega) = (ordered_moments(), vector("omega"));
    let momentum = momentum(&moments, &omega);
    let scope = Scope::default().positive(["I1", "a", "b", "omega1", "omega2", "omega3"]);
    let pair = |[i, j]: [usize; 2]| {
        let names = [("L_i", &momentum[i]), ("L_j", &momentum[j]), (r"\omega_i", &omega[i])];
        scope.clone().with_all(names.map(|(name, x)| (name, x.clone()))).with(r"\omega_j", omega[j].clone())
    };
    pairs.map(pair).into()
}

fn acute(factor: i64) -> Scope {
    let (moments, omega) = (vector("I"), vector("omega"));
    let mut momentum = momentum(&moments, &omega);
    momentum.y *= Fraction::from(factor);
    let scope = Scope::default().with_each("I", &moments).with_each(r"\omega", &omega);
    scope.with("L", momentum).with(r"\omega", omega)
}

fn exchanged() -> Scope {
    let [a, d] = variables(["a", "d"]);
    slant().with("b", a.clone()).with("a", a + d)
}
