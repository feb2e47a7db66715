//! The attitude by Klein and Sommerfeld's two numbers, by the formulas of the exact motion, written here a
//! second time, put into `q' = q w/2` for all bodies; and the degenerate motions as its limits.
//!
//! Indices: 1 across, 2 middle, 3 circled. `h` is the modulus over the root `p` of the first difference of
//! the moments, so that nothing is divided by `p`.

use crate::equations::of_motion;
use crate::number::{Derivation, Fraction, Polynomial, Relations};
use crate::proof::{Cases, Outcome, Residue, same_entries_under, same_under, vanishes};
use crate::symbols::{Vector, diagonal, pure, quaternion, square, variables};
use crate::tex::Scope;
use nalgebra::Quaternion;
use num_traits::{One, Zero};
use tumbling::attitude::{product, rate};
use tumbling::dynamics::{euler::angular_acceleration, observe::energy};

proofs! {
    "exact" {
        [Again] "klein-momentum": both(|sense| momentum(sense, Change::None)),
            "The spin (C7), with the amplitudes (C5), the modulus (C4) and the rate (C6), obeys Euler's equations, with the energy and momentum (C1); and the quaternion of the closed form's two numbers takes the \
            momentum to the first axis. For every body, about either axis, in either sense.";
            but "the zero on the other side": both(|sense| momentum(sense, Change::Zero)),
            but "a sign in Euler's equations": both(|sense| momentum(sense, Change::Spin)),
        [Again] "klein-attitude": both(|sense| attitude(sense, Change::None)),
            "That quaternion, with the share (C17) and the zero (C18), turned about the momentum at the steady drift and the rate that the closed form gives the angle of its first number, obeys the attitude's law; \
            the whole rate is (C20). For every body, about either axis, in either sense. That a theta function's angle has this rate is no part of it.";
            but "the zero on the other side": both(|sense| attitude(sense, Change::Zero)),
            but "the theta function's angle reversed": both(|sense| attitude(sense, Change::Angle)),
        [Again] "limit-coin": coin(1),
            r"Where the middle moment equals the one across, the spin obeys Euler's equations, the rate is that of the coin (C38), $\Omega = \frac{I_3 - I_1}{I_1}\omega_3$, the two amplitudes across are equal, and the first number's length is constant.";
            but "the rate reversed": coin(-1),
        [Again] "limit-separatrix": separatrix(1),
            r"With modulus one the spin obeys Euler's equations, the last two functions change at one rate, the momentum is $L^2 = 2 E I_2$, and at the saddle the turn about it has the rate $\psi' = \sigma L/I_2$.";
            but "the last two functions opposite": separatrix(-1),
        [Again] "limit-steady": both(|order| steady(order, Change::None)),
            r"With no wobble the spin obeys Euler's equations, the second number times the conjugate of the first is $b_1 = b_2 = 0$, and the turn about the momentum has the rate that the attitude's law gives about the circled axis, $\dot{\psi} = \omega_3$.";
            but "the spin the other way": both(|order| steady(order, Change::Spin)),
    }
}

/// What a mutant changes.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum Change {
    None,
    Zero,
    Angle,
    Spin,
}

/// Both orders of the axes: cyclic or not.
pub(super) fn both<T: Cases>(check: impl Fn(i64) -> T) -> Result<Vec<Scope>, Residue> {
    Ok([check(1).cases()?, check(-1).cases()?].concat())
}

/// A motion in closed form, with all the constants of its attitude.
pub(crate) struct Motion {
    pub(crate) relations: Relations,
    pub(crate) time: Derivation,
    /// Across, middle, circled.
    pub(crate) moments: [Fraction; 3],
    pub(crate) amplitudes: [Fraction; 3],
    pub(crate) omega: [Fraction; 3],
    pub(crate) rate: Fraction,
    pub(crate) momentum: Fraction,
    pub(crate) twice_energy: Fraction,
    /// `sn`, `cn` and `dn` of the zero, with the complementary modulus.
    pub(crate) zero: [Fraction; 3],
    /// The rate of the angle about the momentum, by the theta function's angle and the drift.
    pub(crate) turning: Fraction,
    /// `a conj(a)`, and `conj(a) b`.
    pub(crate) size: Fraction,
    pub(crate) product: [Fraction; 2],
}

/// What ties the symbols: moments in either order by `tau`.
fn relations() -> Result<Relations, Residue> {
    let [x1, x3, p, q, h, sn] = ["x1", "x3", "p", "q", "h", "sn"].map(square);
    let (tau, one) = (Polynomial::variable("tau"), Polynomial::one);
    let modulus = &h * &p;
    let mut rules = vec![("cn", one() - &sn), ("dn", one() - &modulus * &sn), ("kp", one() - modulus)];
    rules.extend([("e", x3 + h * &x1 * &q), ("x2", &x1 + &tau * &p), ("x3", x1 + tau * (&p + &q))]);
    rules.extend([("r", p + q), ("sigma", one()), ("tau", one())]);
    Ok(Relations::new(rules)?)
}

/// `sense` is 1 where across, middle and circled follow each other in cyclic order, otherwise -1.
pub(crate) fn motion(sense: i64, change: Change) -> Result<Motion, Residue> {
    let relations = relations()?;
    let [x1, x2, x3, p, q, r] = variables(["x1", "x2", "x3", "p", "q", "r"]);
    let [h, big, e, sn, cn, dn] = variables(["h", "Q", "e", "sn", "cn", "dn"]);
    let [sigma, tau] = variables(["sigma", "tau"]);
    let s = Fraction::from(sense);
    let one = Fraction::one();
    let sign = |of: Change| Fraction::from(if change == of { -1 } else { 1 });
    let rate = &s * &sigma * &tau * &q * &big / (&x1 * &x2 * &x3) * sign(Change::Spin);
    let m = h.pow(2) * p.pow(2);
    let time = Derivation::new([
        ("sn", &cn * &dn * &rate),
        ("cn", -(&sn * &dn * &rate)),
        ("dn", -(&m * &sn * &cn * &rate)),
    ]);
    let amplitudes = [&h * &q * &big / (&x1 * &r), &h * &big / &x2, &big / (&x3 * &r)];
    let omega = [&amplitudes[0] * &cn, &amplitudes[1] * &sn, &sigma * &amplitudes[2] * &dn];
    let (momentum, twice_energy) = (&big * &e / &r, big.pow(2) * (&one + h.pow(2) * q.pow(2)) / r.pow(2));
    let zero = [&x1 * &q / (&x2 * &r), &x3 * &p / (&x2 * &r), &p * &e / (&x2 * &r)];
    // The quotient of the last two, and its derivative.
    let share = &x3 / &e;
    let falls = -(&x1 * &q * &x2 * &r * h.pow(2) / e.pow(2));
    let circled = x3.pow(2);
    let about = |dn: &Fraction| {
        let along = &amplitudes[2] * dn;
        &sigma * (&twice_energy + &momentum * &along) / (&momentum + &circled * along)
    };
    let angle = |dn: &Fraction| &s * &rate * dn * &falls / (&one + dn * &share) * sign(Change::Angle);
    // The drift is what the turn at the start of a passage needs beyond the theta function's.
    let turning = about(&one) - angle(&one) + angle(&dn);
    let size = (&one + &dn * &share) / Fraction::from(2);
    // conj(a) b = k (sn - i s beta cn)/(2 delta), with the middle axis where the order of the axes has it.
    let half = &sigma * Fraction::ratio(1, 2);
    let along_sn = &half * &h * &x2 * &r / &e * &sn;
    let along_cn = &half * &h * &x1 * &q / &e * &cn * sign(Change::Zero);
    let product = if sense > 0 { [along_sn, -along_cn] } else { [along_cn, -along_sn] };
    let moments = [x1.pow(2), x2.pow(2), circled];
    Ok(Motion {
        relations,
        time,
        moments,
        amplitudes,
        omega,
        rate,
        momentum,
        twice_energy,
        zero,
        turning,
        size,
        product,
    })
}

impl Motion {
    /// Along the circled axis and the next two in cyclic order.
    pub(crate) fn arranged(&self, [across, middle, circled]: &[Fraction; 3], sense: i64) -> Vector {
        let [next, last] = if sense > 0 { [across, middle] } else { [middle, across] };
        Vector::new(circled.clone(), next.clone(), last.clone())
    }

    /// `conj(a) (a + b j)`: the quaternion turned until its first part is real, times its length there.
    fn quaternion(&self) -> Quaternion<Fraction> {
        let [real, imaginary] = self.product.clone();
        Quaternion::new(self.size.clone(), Fraction::zero(), real, imaginary)
    }
}

/// That the spin obeys the library's equations, with its energy and momentum, and where the momentum points.
pub(crate) fn momentum(sense: i64, change: Change) -> Result<Scope, Residue> {
    let motion = motion(sense, change)?;
    let (omega, moments) = (motion.arranged(&motion.omega, sense), motion.arranged(&motion.moments, sense));
    let moved = omega.map(|x| motion.time.of(&x));
    let expected = angular_acceleration(&moments, &omega, &Vector::zeros());
    same_entries_under(&motion.relations, "w'", &moved, &expected)?;
    let momentum = diagonal(&moments) * &omega;
    let twice = energy(&omega, &momentum) * Fraction::from(2);
    same_under(&motion.relations, "2E", &twice, &motion.twice_energy)?;
    same_under(&motion.relations, "L²", &momentum.dot(&momentum), &motion.momentum.pow(2))?;
    // conj(q) i q, for q of length |a|.
    let q = motion.quaternion();
    let back = quaternion(q.coords.w.clone(), &-q.coords.xyz());
    let seen = product(&product(&back, &pure(&Vector::x())), &q).coords.xyz();
    let scale = &motion.size * Fraction::variable("sigma") / &motion.momentum;
    same_entries_under(&motion.relations, "the momentum", &seen, &momentum.map(|x| x * &scale))?;
    Ok(of_motion(motion, sense, false))
}

/// The motion, if its spin and its attitude obey the library's laws.
pub(crate) fn obeying(sense: i64) -> Result<Motion, Residue> {
    momentum(sense, Change::None).and(attitude(sense, Change::None))?;
    motion(sense, Change::None)
}

fn attitude(sense: i64, change: Change) -> Result<Scope, Residue> {
    let motion = motion(sense, change)?;
    let omega = motion.arranged(&motion.omega, sense);
    let q = motion.quaternion();
    let lengthens = motion.time.of(&motion.size) / (&motion.size * Fraction::from(2));
    let turned = product(&pure(&Vector::x()), &q);
    let half = &motion.turning / Fraction::from(2);
    let expected = rate(&q, &omega);
    let moved = q.coords.map(|x| motion.time.of(&x) - x * &lengthens) + turned.coords.map(|x| x * &half);
    same_entries_under(&motion.relations, "q'", &moved, &expected.coords)?;
    Ok(of_motion(motion, sense, false))
}

/// That the spin of a limit obeys the library's equations.
fn obeys(motion: &Motion, sense: i64, limit: impl Fn(&Fraction) -> Fraction, ties: &Relations) -> Outcome {
    let of = |all: [Fraction; 3]| motion.arranged(&all.each_ref().map(&limit), sense);
    let moved = of(motion.omega.each_ref().map(|x| motion.time.of(x)));
    let [moments, omega] = [&motion.moments, &motion.omega].map(|all| of(all.clone()));
    same_entries_under(ties, "w'", &moved, &angular_acceleration(&moments, &omega, &Vector::zeros()))
}

/// The expression with numbers or symbols put for some of its symbols.
fn put(x: &Fraction, values: &[(&str, Fraction)]) -> Fraction {
    values.iter().fold(x.clone(), |x, (name, value)| x.substitute(&(*name).into(), value))
}

fn coin(direction: i64) -> Result<Scope, Residue> {
    let motion = motion(1, Change::None)?;
    let [x1, q, one] = [Fraction::variable("x1"), Fraction::variable("q"), Fraction::one()];
    let values = [("p", Fraction::zero()), ("x2", x1), ("r", q), ("dn", one.clone())];
    let limit = |x: &Fraction| put(x, &values);
    let [x1, x3, q, h] = ["x1", "x3", "q", "h"].map(square);
    let mut ties = vec![("e", x3 + h * &x1 * &q), ("x3", x1 + Polynomial::variable("tau") * q)];
    ties.extend([("sigma", Polynomial::one()), ("tau", Polynomial::one())]);
    let ties = Relations::new(ties)?;
    same_under(&ties, "the amplitudes", &limit(&motion.amplitudes[0]), &limit(&motion.amplitudes[1]))?;
    obeys(&motion, 1, limit, &ties)?;
    vanishes("the rate of a", &limit(&motion.time.of(&motion.size)), &ties)?;
    let [i1, _, i3] = motion.moments.each_ref().map(limit);
    // As the first two axes follow each other, the spin circles the third the way that sn and cn exchange.
    let rate = limit(&motion.rate) * Fraction::from(direction);
    let scope = Scope::default().with_all([(r"\Omega", rate), (r"\omega_3", limit(&motion.omega[2]))]);
    Ok(scope.with_all([("I_1", i1), ("I_3", i3)]).under(ties))
}

fn separatrix(sign: i64) -> Result<Scope, Residue> {
    let motion = motion(1, Change::None)?;
    let over_p = Fraction::one() / Fraction::variable("p");
    let values = [("h", over_p), ("dn", Fraction::variable("cn") * Fraction::from(sign))];
    let limit = |x: &Fraction| put(x, &values);
    obeys(&motion, 1, limit, &motion.relations)?;
    // dn² = cn², and their rates are the same.
    let rates = ["cn", "dn"].map(|name| limit(&motion.time.of(&Fraction::variable(name))));
    same_under(&motion.relations, "cn' and dn'", &rates[0], &rates[1])?;
    // Now e² = x3² + x1² q²/p² is x2² r²/p².
    let [x2, r, p] = variables(["x2", "r", "p"]);
    let at_rest = [("e", x2 * r / p), ("cn", Fraction::zero())];
    let settled = |x: &Fraction| put(&limit(x), &at_rest);
    let energy = settled(&motion.twice_energy) / Fraction::from(2);
    let [momentum, turning] = [&motion.momentum, &motion.turning].map(settled);
    let scope = Scope::default().with_all([("L", momentum), ("E", energy), (r"\psi'", turning)]);
    let scope = scope.with("I_2", motion.moments[1].clone()).with(r"\sigma", Fraction::variable("sigma"));
    Ok(scope.under(motion.relations))
}

fn steady(order: i64, change: Change) -> Result<Scope, Residue> {
    let motion = motion(order, change)?;
    let sense = if change == Change::None { 1 } else { -1 };
    let values = [("h", Fraction::zero()), ("dn", Fraction::one()), ("e", Fraction::variable("x3"))];
    let limit = |x: &Fraction| put(x, &values);
    obeys(&motion, order, limit, &motion.relations)?;
    let scope = Scope::default().with_each("b", &motion.product.each_ref().map(limit));
    let scope = scope.with(r"\dot{\psi}", limit(&motion.turning));
    let q = Quaternion::from_vector(motion.quaternion().coords.map(|x| limit(&x)));
    let about = rate(&q, &motion.arranged(&motion.omega.each_ref().map(limit), order)).coords.x.clone();
    let spin = about / q.coords.w.clone() * Fraction::from(2 * sense);
    Ok(scope.with(r"\omega_3", spin).under(motion.relations))
}
