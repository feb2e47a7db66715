//! The integrals of the closed form: Gauss's mean, Carlson's integrals by duplication, and Legendre's
//! integrals as Carlson writes them.
//!
//! Two integrals are equal if a change of variable takes one integrand and its range to the other; each claim
//! is about integrands, and no check is about the ranges. The roots in them are symbols, tied by their
//! squares or by their derivatives.

use crate::number::{Derivation, Fraction, Polynomial, Relations};
use crate::proof::{Outcome, positive, same, same_under, vanishes};
use crate::proofs::klein::{Change, Motion, motion};
use crate::symbols::{square, variables};
use num_traits::One;

proofs! {
    "exact" {
        "gauss-mean": gauss(-1, 2),
            "By u = (t - a b/t)/2, which rises with t, the integrand 1/sqrt((t² + a²)(t² + b²)) becomes that of the arithmetic and the geometric mean; for a = b = m it is 1/m by the angle of t = m tan; \
            by t = k' tan that of 1 and k' becomes Legendre's. For all a and b; the limits of the integrals are no part of it.";
            but "a plus in the change of variable": gauss(1, 2),
        "last-mean": last_mean(16),
            "Of two numbers with mean m, difference d and geometric mean g, the next mean is m - d²/(16 m), but for (m - g)²/(4 m), g being the root of m² - d²/4.";
            but "twice as much taken off": last_mean(8),
        "carlson-duplication": duplication(1, 3),
            "With s = t + XY + YZ + ZX, where X² = t + x and so on, ds/sqrt((s+x)(s+y)(s+z)) is half of dt/(XYZ), and the integrands of R_D before and after differ by the derivative of 3/(Z (Y+Z) (Z+X)). \
            Scaling and limits of the integrals are no part of it.";
            but "a product of roots the other way": duplication(-1, 3),
            but "another term taken off": duplication(1, 2),
        "legendre-by-carlson": legendre(1, 6),
            "By t = s²/sin² - 1 Legendre's integrand becomes that of s R_F(1 - s², 1 - m s², 1), and its derivative by m that of s³ R_D(1 - s², 1, 1 - m s²)/6; cn/dn, k' sn/dn and k'/dn are the functions \
            of what is left to the quarter period; and the squares of the theta zero's functions are tied by the complementary modulus. The limits are no part of it.";
            but "the parameter's sign": legendre(-1, 6),
    }
}

fn gauss(sign: i64, halves: i64) -> Outcome {
    let [a, b, t, m] = variables(["a", "b", "t", "m"]);
    let under = |t: &Fraction, a2: &Fraction, b2: &Fraction| (t.pow(2) + a2) * (t.pow(2) + b2);
    let u = (&t + &a * &b / &t * Fraction::from(sign)) / Fraction::from(2);
    let rate = u.derivative(&"t".into());
    let mean = (&a + &b) / Fraction::from(halves);
    let after = under(&u, &mean.pow(2), &(&a * &b)) * Fraction::from(4);
    same("the integrand", &(rate.pow(2) * under(&t, &a.pow(2), &b.pow(2))), &after)?;
    positive("u rises from below all numbers to above all", &rate)?;
    // By an angle: t = b tan.
    let [sin, cos, kp] = variables(["sin", "cos", "kp"]);
    let by_angle = Derivation::new([("sin", cos.clone()), ("cos", -sin.clone())]);
    let circle = Relations::circle("cos", "sin");
    let tangent = by_angle.of(&(&m * &sin / &cos));
    same_under(&circle, "of two equal numbers", &tangent, &((&m * &sin / &cos).pow(2) / &m + &m))?;
    let t = &kp * &sin / &cos;
    let one = Fraction::one();
    let root_squared = &one - (&one - kp.pow(2)) * sin.pow(2);
    let left = by_angle.of(&t).pow(2) * root_squared;
    same_under(&circle, "the quarter period", &left, &under(&t, &one, &kp.pow(2)))
}

fn last_mean(over: i64) -> Outcome {
    // g is the geometric mean of the two: the root of m² - d²/4.
    let [m, g, d] = variables(["m", "g", "d"]);
    let four = Polynomial::from(4);
    let relations = Relations::new(vec![("d", (square("m") - square("g")) * four)])?;
    let taken = &m - d.pow(2) / (&m * Fraction::from(over));
    let next = (&m + &g) / Fraction::from(2);
    same_under(&relations, "the next mean", &(taken - next), &((&m - &g).pow(2) / (&m * Fraction::from(4))))
}

fn duplication(sign: i64, thrice: i64) -> Outcome {
    let [x, y, z, t] = variables(["X", "Y", "Z", "t"]);
    let two = Fraction::from(2);
    let by_t = ["Y", "Z"].iter().fold(
        Derivation::new([("t", Fraction::one()), ("X", Fraction::one() / (&two * &x))]),
        |all, name| all.and(name, Fraction::one() / (&two * Fraction::variable(name))),
    );
    let s = &t + &x * &y + &y * &z + &z * &x * Fraction::from(sign);
    let sums = [&x + &y, &y + &z, &z + &x];
    // x = X² - t, and so on.
    same("s + x", &(&s + x.pow(2) - &t), &(&sums[0] * &sums[2]))?;
    same("s + y", &(&s + y.pow(2) - &t), &(&sums[0] * &sums[1]))?;
    same("s + z", &(&s + z.pow(2) - &t), &(&sums[1] * &sums[2]))?;
    let (product, roots) = (&sums[0] * &sums[1] * &sums[2], &x * &y * &z);
    same("the integrand of R_F", &(by_t.of(&s) / &product), &(Fraction::one() / (&two * &roots)))?;
    // Twice R_D after the duplication, and what goes before it: nothing where t is infinite.
    let taken = Fraction::from(thrice) / (&z * &sums[1] * &sums[2]);
    let before = Fraction::from(3) / (&two * z.pow(2) * &roots);
    let after = Fraction::from(3) * by_t.of(&s) / (&sums[1] * &sums[2] * &product);
    same("the integrand of R_D", &(before - after), &-by_t.of(&taken))
}

fn legendre(sign: i64, over: i64) -> Outcome {
    let [s, m, sin, cos, rate] = variables(["s", "m", "sin", "cos", "Delta"]);
    let (one, two) = (Fraction::one(), Fraction::from(2));
    let parameter = Polynomial::variable("m");
    let relations = Relations::new(vec![
        ("cos", Polynomial::one() - square("sin")),
        ("Delta", Polynomial::one() - &parameter * square("sin")),
    ])?;
    // From t = 0 at the angle with the sine s on to infinity at the angle zero.
    let t = s.pow(2) / sin.pow(2) - &one;
    let falls = -Derivation::new([("sin", cos.clone())]).of(&t);
    let under = [&one - s.pow(2), &one - &m * s.pow(2) * Fraction::from(sign), one.clone()];
    let roots = [&s * &cos / &sin, &s * &rate / &sin, &s / &sin];
    for ((under, root), of) in under.iter().zip(&roots).zip(["x", "y", "z"]) {
        same_under(&relations, &format!("t + {of}"), &(&t + under), &root.pow(2))?;
    }
    let product = &roots[0] * &roots[1] * &roots[2];
    let first = &s * &falls / (&two * &product);
    same_under(&relations, "the argument", &first, &(&one / &rate))?;
    let second =
        s.pow(3) / Fraction::from(over) * Fraction::ratio(3, 2) * &falls / (roots[1].pow(2) * &product);
    let by_parameter = Derivation::new([("Delta", -(sin.pow(2) / (&two * &rate)))]);
    same_under(&relations, "its derivative", &second, &by_parameter.of(&(&one / &rate)))?;
    // What is left to the quarter period: cn/dn, k' sn/dn and k'/dn are its three functions.
    let [sn, cn, dn, kp] = variables(["sn", "cn", "dn", "kp"]);
    let jacobi = Relations::new(vec![
        ("cn", Polynomial::one() - square("sn")),
        ("dn", Polynomial::one() - &parameter * square("sn")),
        ("kp", Polynomial::one() - parameter),
    ])?;
    let (far, fall) = (&cn / &dn, [&kp * &sn / &dn, &kp / &dn]);
    same_under(&jacobi, "the cosine of what is left", &fall[0].pow(2), &(&one - far.pow(2)))?;
    same_under(&jacobi, "its dn", &fall[1].pow(2), &(&one - &m * far.pow(2)))?;
    let by_argument = Derivation::elliptic(&one);
    same_under(&jacobi, "its rate", &by_argument.of(&far), &-(&fall[0] * &fall[1]))?;
    // The theta zero.
    let Motion { relations, zero: [beta, gamma, delta], .. } = motion(1, Change::None)?;
    let complement = beta.pow(2) * Fraction::variable("kp").pow(2);
    vanishes("the zero's cosine", &(beta.pow(2) + gamma.pow(2) - &one), &relations)?;
    vanishes("the zero's dn", &(delta.pow(2) + complement - one), &relations)
}
