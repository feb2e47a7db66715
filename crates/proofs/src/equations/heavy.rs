//! The meanings of the names where the book states a top's motion under its weight in closed form.

use crate::lattice::{THETA_1, THETA_2, THETA_4};
use crate::number::{Derivation, Fraction, Polynomial, Relations};
use crate::symbols::{Vector, attitude, diagonal, square, variables, vector};
use crate::tex::{Scope, Value};
use nalgebra::Quaternion;
use num_traits::{One, Zero};
use tumbling::attitude::{rate, rotation_matrix};
use tumbling::dynamics::{euler::angular_acceleration, observe::energy};

fn complex([re, im]: &[Fraction; 2]) -> Quaternion<Fraction> {
    Quaternion::new(re.clone(), im.clone(), Fraction::zero(), Fraction::zero())
}

/// The torque, about the fixed point, of a weight that pulls against this direction of the body.
fn torque(vertical: &Vector) -> Vector {
    let [weight, arm] = variables(["W", "h"]);
    Vector::new(Fraction::zero(), Fraction::zero(), arm).cross(&(vertical * -weight))
}

/// A quaternion's or a vector's components as complex numbers, with their rates.
struct Complex {
    alpha: [Fraction; 2],
    beta: [Fraction; 2],
    omega: [Fraction; 2],
}

impl Complex {
    fn new(q: &Quaternion<Fraction>, spin: &Vector) -> Self {
        let [x, y, z, w] = [0, 1, 2, 3].map(|n| q.coords[n].clone());
        Self { alpha: [w, z], beta: [x, y], omega: [spin.x.clone(), spin.y.clone()] }
    }

    fn all(&self) -> [(&str, &[Fraction; 2]); 3] {
        [(r"\alpha", &self.alpha), (r"\beta", &self.beta), (r"\omega", &self.omega)]
    }

    /// The rates of the angles.
    fn angles(&self, rates: &Self) -> [Fraction; 3] {
        let angle = |(_, z): (&str, &[Fraction; 2]), (_, rate): (&str, &[Fraction; 2])| growth(z, rate);
        let [alpha, beta, omega] = self.all();
        let [first, second, third] = rates.all();
        [angle(alpha, first), angle(beta, second), angle(omega, third)]
    }
}

/// The rate of the angle of a complex number.
fn growth([re, im]: &[Fraction; 2], rate: &[Fraction; 2]) -> Fraction {
    (re * &rate[1] - im * &rate[0]) / (re.pow(2) + im.pow(2))
}

/// Any attitude and spin of the top, and their rates by the library.
pub(super) fn turning() -> Scope {
    let (q, unit) = attitude();
    let [i1, i3, o3, weight, arm] = variables(["I1", "I3", "omega3", "W", "h"]);
    let (moments, omega) = (Vector::new(i1.clone(), i1.clone(), i3.clone()), vector("omega"));
    let rotation = rotation_matrix(&q);
    let vertical = rotation.row(2).transpose();
    let (turned, spun) = (rate(&q, &omega), angular_acceleration(&moments, &omega, &torque(&vertical)));
    let [x, y, z, w] = [0, 1, 2, 3].map(|n| turned.coords[n].clone());
    let time = Derivation::new([("w", w), ("x", x), ("y", y), ("z", z)]);
    let momentum = diagonal(&moments) * &omega;
    let level = torque(&Vector::new(Fraction::zero(), Fraction::one(), Fraction::zero()));
    let (height, two) = (rotation[(2, 2)].clone(), Fraction::from(2));
    let doubled = &two * energy(&omega, &momentum) + &two * &weight * &arm * &height - &i3 * o3.pow(2);
    let along = &momentum.z / &i1;
    let axis = [rotation[(0, 2)].clone(), rotation[(1, 2)].clone()];
    let (now, rates) = (Complex::new(&q, &omega), Complex::new(&turned, &spun));
    // The steady turn of the body beyond that of three equal moments.
    let added = (&o3 - &along) / &two;
    let [first, second, third] = now.angles(&rates);
    let scope = Scope::default()
        .with_all([("g", &level.x * &two / &i1), ("e", doubled / &i1), (r"\dot{c}", time.of(&height))])
        .with_all([("c", height), ("l", &(&rotation * &momentum).z / &i1), ("n", along)])
        .with_all([("P", growth(&axis, &axis.clone().map(|x| time.of(&x)))), ("W", weight), ("h", arm)])
        .with_all([(r"\dot{\phi}_1", first - &added), (r"\dot{\phi}_2", second + &added)])
        .with_all([(r"\dot{\phi}_3", third + added * two), ("I_1", i1), ("I_3", i3)])
        .with_each(r"\omega", &omega)
        .with_each("v", &vertical)
        .with("i", complex(&[Fraction::zero(), Fraction::one()]))
        .with("V", complex(&[vertical.x.clone(), vertical.y.clone()]))
        .under(unit);
    let conjugate = |[re, im]: &[Fraction; 2]| complex(&[re.clone(), -im.clone()]);
    let scope = now.all().into_iter().fold(scope, |scope, (name, z)| {
        scope.with(name, complex(z)).with(&format!(r"\bar{{{name}}}"), conjugate(z))
    });
    let dotted = |all: Scope, (name, z): (&str, &_)| all.with(&format!(r"\dot{{{name}}}"), complex(z));
    rates.all().into_iter().fold(scope, dotted)
}

/// The same, with the height as a complex number.
pub(super) fn leaning() -> Scope {
    turning().with("c", complex(&[rotation_matrix(&attitude().0)[(2, 2)].clone(), Fraction::zero()]))
}

/// The square of the rate of the height.
fn cubic(height: &Fraction) -> Fraction {
    let [n, g, l, e] = variables(["n", "g", "l", "e"]);
    (Fraction::one() - height.pow(2)) * (e - g * height) - (l - n * height).pow(2)
}

fn with_constants<const N: usize>(x: Fraction, constants: [(&str, Fraction); N]) -> Fraction {
    constants.into_iter().fold(x, |x, (name, value)| x.substitute(&name.into(), &value))
}

/// That square by a distance of this name, `x`, from a height.
fn near(name: &str, height: &Fraction) -> Scope {
    let [n, g, l, e, x] = variables(["n", "g", "l", "e", "x"]);
    let scope = Scope::default().with(r"\dot{c}", Value::Root(cubic(height)));
    scope.with_all([("n", n), ("g", g), ("l", l), ("e", e), (name, x)])
}

/// That square by the height above the start, with the constants of the start.
pub(super) fn from_the_start() -> Scope {
    let [v1, v2, o1, o2, c0, x, n, g] = variables(["v1", "v2", "omega1", "omega2", "c0", "x", "n", "g"]);
    let spin = o1.pow(2) + o2.pow(2);
    let momentum = &n * &c0 + &v1 * &o1 + &v2 * &o2;
    let constants = || [("l", momentum.clone()), ("e", &spin + &g * &c0)];
    let put = |height: &Fraction| with_constants(cubic(height), constants());
    let by_height = put(&x).derivative(&"x".into()).substitute(&"x".into(), &c0);
    let Ok(level) = Relations::new(vec![("c0", Polynomial::one() - square("v1") - square("v2"))]) else {
        return Scope::default();
    };
    Scope::default()
        .with(r"\dot{c}", Value::Root(put(&(&c0 + &x))))
        .with_all([(r"\dot{c}_0", &v1 * &o2 - &v2 * &o1), ("F", by_height), ("c_0", c0), (r"\delta", x)])
        .with_all([("n", n), ("g", g), ("v_1", v1), ("v_2", v2), (r"\omega_1", o1), (r"\omega_2", o2)])
        .under(level)
}

/// The same by the depth below the top.
pub(super) fn from_the_top() -> Scope {
    near(r"\epsilon", &(Fraction::one() - Fraction::variable("x")))
}

/// The same by the height above the bottom.
pub(super) fn from_the_bottom() -> Scope {
    near(r"\zeta", &(Fraction::variable("x") - Fraction::one()))
}

/// The roots by the lowest, the span to the third and the part of it that the second has; the constants by
/// the products of the roots.
fn roots() -> Result<(Scope, [Fraction; 5], Relations), crate::residue::Residue> {
    let [low, span, part, g, plus, minus] = variables(["c1", "a", "m", "g", "plus", "minus"]);
    let (two, one) = (Fraction::from(2), Fraction::one());
    let (high, third) = (&low + &part * &span, &low + &span);
    let product = |sign: i64| {
        let [low, span, part, g] = ["c1", "a", "m", "g"].map(Polynomial::variable);
        let from = |root: Polynomial| Polynomial::one() + root * Polynomial::from(sign);
        g * from(low.clone()) * from(&low + &part * &span) * from(low + span) * Polynomial::from(sign)
    };
    let [sn, m, weight, wide] = ["sn", "m", "g", "a"].map(Polynomial::variable);
    let quarter = Polynomial::from(crate::BigRational::new(1.into(), 4.into()));
    let relations = Relations::new(vec![
        ("plus", product(1)),
        ("minus", product(-1)),
        ("cn", Polynomial::one() - sn.pow(2)),
        ("dn", Polynomial::one() - m * sn.pow(2)),
        ("eta", weight * wide * quarter),
    ])?;
    let (l, n) = ((&plus + &minus) / &two, (&plus - &minus) / &two);
    let e = &g * (&low + &high + &third) - n.pow(2);
    let scope = Scope::default()
        .with_all([("l", l.clone()), ("n", n.clone()), ("e", e.clone())])
        .with_all([("g", g), ("c_1", low), ("c_2", high)])
        .with_all([("c_3", third), ("d_2", one), ("d_3", &e / Fraction::variable("g"))])
        .with("k", Value::Root(part.clone()))
        .with("k'", Value::Root(Fraction::one() - part))
        .under(relations.clone());
    let g = Fraction::variable("g");
    Ok((scope, [l, n, e, g, Fraction::variable("eta")], relations))
}

/// Any height, and the cubic there.
pub(super) fn any_height() -> Scope {
    let Ok((scope, [l, n, e, _, _], _)) = roots() else { return Scope::default() };
    let c = Fraction::variable("c");
    let square = with_constants(cubic(&c), [("l", l), ("n", n), ("e", e)]);
    scope.with(r"\dot{c}", Value::Root(square)).with("c", c)
}

/// The height as a function of time, if the square of its rate is the cubic; otherwise the names have no
/// meaning.
pub(super) fn swinging() -> Scope {
    let Ok((scope, [l, n, e, _, eta], relations)) = roots() else { return Scope::default() };
    let [low, span, m, sn] = variables(["c1", "a", "m", "sn"]);
    let c = &low + &m * &span * sn.pow(2);
    let rising = Derivation::elliptic(&eta).of(&c);
    let square = with_constants(cubic(&c), [("l", l), ("n", n), ("e", e)]);
    if !relations.reduce_fraction(&(rising.pow(2) - square)).is_zero() {
        return Scope::default();
    }
    let names = ["sn", "cn", "dn"];
    let scope = scope.with_functions(&names, "(u)").with_functions(&names, "(u_0)");
    scope.with_all([(r"\eta", eta), ("c_0", c.clone()), ("c", c)])
}

/// Squares of Jacobi's functions of a zero, with the complementary modulus, from that of its sn.
fn squares(scope: Scope, index: &str, sn: &Fraction) -> Scope {
    let root = |x: Fraction| Value::Root(x);
    let complement = Fraction::one() - Fraction::variable("m");
    scope
        .with(&format!("S_{index}"), root(sn.clone()))
        .with(&format!("C_{index}"), root(Fraction::one() - sn))
        .with(&format!("D_{index}"), root(Fraction::one() - complement * sn))
}

/// Where the height is -1: there sn at an imaginary argument is i times a quotient of these functions.
pub(super) fn lowest_zero() -> Scope {
    let Ok((scope, ..)) = roots() else { return Scope::default() };
    let [low, span, m] = variables(["c1", "a", "m"]);
    let quotient = (Fraction::one() + low) / (m * span);
    squares(scope, "1", &(&quotient / (Fraction::one() + &quotient)))
}

/// Where it is any height beyond the second root: a quarter period further sn is the inverse of the third.
pub(super) fn other_zero() -> Scope {
    let Ok((scope, ..)) = roots() else { return Scope::default() };
    let [low, span, m, d] = variables(["c1", "a", "m", "d"]);
    let third = &m * span / (&d - low);
    squares(scope.with("d_j", d), "j", &((Fraction::one() - third) / (Fraction::one() - m)))
}

/// The theta functions' sums, four terms each: at a zero, and in hyperbolic functions.
pub(super) fn sums() -> Scope {
    let ([q, other, s, x], one) = (variables(["q", "q'", "s", "x"]), Fraction::one());
    let both = |n: u32, sign: i64| (x.pow(n) + (&one / &x).pow(n) * Fraction::from(sign)) / Fraction::from(2);
    let [odd, even, down] = [THETA_1, THETA_4, THETA_2].map(|f| f.terms(-7..=7, &other, &x.pow(2)));
    let (mut scope, mut above, mut below) = (Scope::default(), Fraction::zero(), Fraction::zero());
    for n in [1, 3, 5, 7_u32] {
        let [sine, cosine] = ["sigma", "kappa"].map(|name| Fraction::variable(&format!("{name}{n}")));
        let size = q.pow((n * n - 1) / 4);
        above += &size * &sine * Fraction::from(i64::from(n));
        below += size * &cosine;
        scope = scope.with(&format!("H_{n}"), both(n, -1)).with(&format!("N_{n}"), both(n, 1));
        scope = scope.with(&format!("G_{}", n - 1), both(n - 1, 1));
        scope = scope.with(&format!(r"\sigma_{n}"), sine).with(&format!(r"\kappa_{n}"), cosine);
    }
    let half = &x / Fraction::from(2);
    scope
        .with_all([("A", odd * &half), ("B", even), ("N", down * half), (r"\rho_j", &s * above / below)])
        .with_all([("s_j", s), ("q", q), ("q'", other)])
}
