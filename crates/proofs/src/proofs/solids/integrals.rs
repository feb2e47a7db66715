//! The integrals with which the moments of solids are compared.

use super::{
    along, ball_moments, capsule_moments, cone_moments, cylinder_moments, disk_moments, ellipsoid_moments,
    hollow_sphere_moments, plate_moments, rod_moments, tube_moments,
};
use crate::number::{Derivation, Fraction, Polynomial, Relations};
use crate::proof::{Case, Residue, positive, same_entries};
use crate::region::{Region, Sums};
use crate::symbols::{Matrix, Vector, diagonal, square, variables, vector};
use crate::tex::Scope;
use nalgebra::Vector3;
use num_traits::{One, Zero};
use tumbling::inertia::point_mass;
use tumbling::laws::mesh_moments;
use tumbling::{laws::tetrahedron_moments, solid::MassMoments};

fn symbol(name: &str) -> Polynomial {
    Polynomial::variable(name)
}

fn half(p: &Polynomial) -> Polynomial {
    p.exact_quotient(&Polynomial::from(2)).unwrap_or_default()
}

/// Checks that a body uniformly filled with mass `m` has this mass, centre and inertia, and these further
/// equalities.
fn has_moments(solid: &Sums, body: &MassMoments<Fraction>) -> Case {
    let density = &body.mass / &solid.volume;
    same_entries("centre", &body.centre, &solid.first.map(|x| x / solid.volume.clone()))?;
    let about_origin = &body.inertia + point_mass(&body.mass, &body.centre);
    same_entries("inertia", &about_origin, &solid.inertia.map(|x| x * density.clone()))?;
    let scope = Scope::default().with_letters(["m", "a", "b", "c", "i", "o", "r", "h", "l"]);
    Ok(scope.with_each("I", &body.inertia.diagonal()).with("C", body.centre.clone()))
}

fn centred(mass: &Fraction, moments: &Vector) -> MassMoments<Fraction> {
    MassMoments { mass: mass.clone(), centre: Vector::zeros(), inertia: diagonal(moments) }
}

fn box_sums() -> Result<Sums, Residue> {
    let mut region = Region::new(Vector::from(variables(["x", "y", "z"])), Relations::none());
    for (name, edge) in [("x", "a"), ("y", "b"), ("z", "c")] {
        let half = half(&symbol(edge));
        region = region.between(name, &-half.clone(), &half);
    }
    region.sums()
}

pub(super) fn cuboid(law: impl Fn(&Fraction, &Fraction, &Fraction, &Fraction) -> Vector) -> Case {
    let [m, a, b, c] = variables(["m", "a", "b", "c"]);
    has_moments(&box_sums()?, &centred(&m, &law(&m, &a, &b, &c)))
}

/// The part of an ellipsoid with semi-axes `axes` between the relative heights `from` and `to`, its middle
/// raised by `lift`. At the relative height `t` each section is an ellipse smaller by `k`, `k² = 1 - t²`.
fn ellipsoid_part(axes: &Vector, lift: &Fraction, from: i64, to: i64) -> Result<Sums, Residue> {
    let [rho, k, cos, sin, t] = variables(["rho", "k", "cos", "sin", "t"]);
    let one = Polynomial::one;
    let relations = Relations::new(vec![("cos", one() - square("sin")), ("k", one() - square("t"))])?;
    let across = &rho * &k;
    let point = Vector3::new(&axes.x * &across * cos, &axes.y * &across * sin, &axes.z * &t + lift.clone());
    let slope = -t / k;
    Region::new(point, relations)
        .between("rho", &Polynomial::zero(), &Polynomial::one())
        .around("cos", "sin")
        .along("t", &from.into(), &to.into(), Derivation::new([("k", slope)]))
        .sums()
}

fn ball_sums(radius: &Fraction) -> Result<Sums, Residue> {
    ellipsoid_part(&Vector::repeat(radius.clone()), &Fraction::zero(), -1, 1)
}

pub(super) fn ellipsoid(law: impl Fn(&Fraction, &Fraction, &Fraction, &Fraction) -> Vector) -> Case {
    let [m, a, b, c] = variables(["m", "a", "b", "c"]);
    let moments = law(&m, &a, &b, &c);
    has_moments(&ellipsoid_part(&Vector3::new(a, b, c), &Fraction::zero(), -1, 1)?, &centred(&m, &moments))
}

pub(super) fn ball(law: impl Fn(&Fraction, &Fraction) -> Vector) -> Case {
    let [m, r] = variables(["m", "r"]);
    has_moments(&ball_sums(&r)?, &centred(&m, &law(&m, &r)))
}

pub(super) fn hollow_sphere(law: impl Fn(&Fraction, &Fraction, &Fraction) -> Vector) -> Case {
    let [m, i, o] = variables(["m", "i", "o"]);
    let solid = ball_sums(&o)?.without(&ball_sums(&i)?);
    let whole = has_moments(&solid, &centred(&m, &law(&m, &i, &o)))?;
    Ok(whole.with("I", law(&m, &i, &i).x.clone()))
}

/// A cylinder of the given radius about z, between two heights.
fn cylinder_part(radius: &str, from: &Polynomial, to: &Polynomial) -> Result<Sums, Residue> {
    let [rho, cos, sin, z] = variables(["rho", "cos", "sin", "z"]);
    Region::new(Vector3::new(&rho * &cos, rho * sin, z), Relations::circle("cos", "sin"))
        .between("rho", &Polynomial::zero(), &symbol(radius))
        .around("cos", "sin")
        .between("z", from, to)
        .sums()
}

fn cylinder_sums(radius: &str, height: &str) -> Result<Sums, Residue> {
    let half = half(&symbol(height));
    cylinder_part(radius, &-half.clone(), &half)
}

pub(super) fn cylinder(law: impl Fn(&Fraction, &Fraction, &Fraction) -> Vector) -> Case {
    let [m, r, h] = variables(["m", "r", "h"]);
    has_moments(&cylinder_sums("r", "h")?, &centred(&m, &law(&m, &r, &h)))
}

pub(super) fn tube(law: impl Fn(&Fraction, &Fraction, &Fraction, &Fraction) -> Vector) -> Case {
    let [m, i, o, h] = variables(["m", "i", "o", "h"]);
    let solid = cylinder_sums("o", "h")?.without(&cylinder_sums("i", "h")?);
    has_moments(&solid, &centred(&m, &law(&m, &i, &o, &h)))
}

/// A cone whose centre is one `part`-th of the way up.
pub(super) fn cone(law: impl Fn(&Fraction, &Fraction, &Fraction) -> Vector, part: i64) -> Case {
    let [m, r, h, rho, cos, sin, t] = variables(["m", "r", "h", "rho", "cos", "sin", "t"]);
    let across = rho * &r * (Fraction::one() - &t);
    let position = Vector3::new(&across * &cos, across * sin, &h * &t);
    let solid = Region::new(position, Relations::circle("cos", "sin"))
        .between("rho", &Polynomial::zero(), &Polynomial::one())
        .around("cos", "sin")
        .between("t", &Polynomial::zero(), &Polynomial::one())
        .sums()?;
    let centre = along(2, &h / &Fraction::from(part));
    has_moments(&solid, &MassMoments { centre, ..centred(&m, &law(&m, &r, &h)) })
}

pub(super) fn capsule(law: impl Fn(&Fraction, &Fraction, &Fraction) -> Vector) -> Case {
    let [m, r, l] = variables(["m", "r", "l"]);
    let end = &l / &Fraction::from(2);
    let round = Vector::repeat(r.clone());
    let top = ellipsoid_part(&round, &end, 0, 1)?;
    let bottom = ellipsoid_part(&round, &-end, -1, 0)?;
    has_moments(&cylinder_sums("r", "l")?.and(&top).and(&bottom), &centred(&m, &law(&m, &r, &l)))
}

/// The moments of a solid filled with mass `m`, after some of its sizes have gone to zero.
fn limit(solid: &Sums, sizes: &[&str]) -> Matrix {
    let m = Fraction::variable("m");
    let to_zero = |x: Fraction, size: &&str| x.substitute(&(*size).into(), &Fraction::zero());
    solid.inertia.map(|x| sizes.iter().fold(x * m.clone() / solid.volume.clone(), to_zero))
}

pub(super) fn thin(
    rod: impl Fn(&Fraction, &Fraction) -> Vector,
    plate: impl Fn(&Fraction, &Fraction, &Fraction) -> Vector,
    disk: impl Fn(&Fraction, &Fraction) -> Vector,
) -> Case {
    let names = ["m", "a", "b", "c", "r"];
    let ([m, a, b, c, r], cuboid) = (variables(names), box_sums()?);
    let [rod, plate, disk] = [rod(&m, &c), plate(&m, &a, &b), disk(&m, &r)];
    same_entries("rod", &diagonal(&rod), &limit(&cuboid, &["a", "b"]))?;
    same_entries("plate", &diagonal(&plate), &limit(&cuboid, &["c"]))?;
    same_entries("disk", &diagonal(&disk), &limit(&cylinder_sums("r", "h")?, &["h"]))?;
    Ok(Scope::default().with("S", rod).with("P", plate).with("D", disk).with_letters(names))
}

/// Four corners, the first at the origin or anywhere.
fn corners() -> [Vector; 4] {
    [1, 2, 3, 4].map(|n| Vector::from(["x", "y", "z"].map(|axis| Fraction::variable(&format!("{axis}{n}")))))
}

pub(super) fn tetrahedron(law: impl Fn(&Fraction, &[Vector; 4]) -> MassMoments<Fraction>) -> Case {
    let corners = corners();
    let [m, u, v, w] = variables(["m", "u", "v", "w"]);
    let edge = |n: usize, along: &Fraction| (&corners[n] - &corners[0]).map(|x| x * along.clone());
    let position = &corners[0] + edge(1, &u) + edge(2, &v) + edge(3, &w);
    let [u, v] = ["u", "v"].map(symbol);
    let rest = Polynomial::one() - u;
    let solid = Region::new(position, Relations::none())
        .between("u", &Polynomial::zero(), &Polynomial::one())
        .between("v", &Polynomial::zero(), &rest)
        .between("w", &Polynomial::zero(), &(rest - v))
        .sums()?;
    let body = law(&m, &corners);
    let scope = has_moments(&solid, &body)?.with("I", body.inertia).with("n", vector("n"));
    Ok((1..).zip(corners).fold(scope, |scope, (n, corner)| {
        scope.with(&format!("r_{n}"), &corner - &body.centre).with(&format!("p_{n}"), corner)
    }))
}

/// A box of edges a, b, c with one corner anywhere, cut into triangles, all seen counter-clockwise from
/// outside; or one of them not.
pub(super) fn mesh_of_a_box(
    inside_out: bool,
    law: impl Fn(&Fraction, &Fraction, &Fraction, &Fraction) -> Vector,
) -> Case {
    let [a, b, c] = variables(["a", "b", "c"]);
    let at = Vector::from(variables(["x", "y", "z"]));
    let edges = [&a, &b, &c];
    let far = |n: usize, i: usize| Fraction::from((n >> i & 1) as i64);
    let corner = |n: usize| Vector::from_fn(|i, _| &at[i] + edges[i] * far(n, i));
    let corners: Vec<Vector> = (0..8).map(corner).collect();
    // Each face as a square, its corners in order; bit i of a corner's number says whether it is at the far
    // end of edge i.
    let squares = [[0, 4, 6, 2], [1, 3, 7, 5], [0, 1, 5, 4], [2, 6, 7, 3], [0, 2, 3, 1], [4, 5, 7, 6]];
    let mut triangles = Vec::new();
    for [p, q, r, s] in squares {
        triangles.push([&corners[p], &corners[q], &corners[r]]);
        triangles.push([&corners[p], &corners[r], &corners[s]]);
    }
    if inside_out {
        triangles[3].swap(0, 1);
    }
    let reference = Vector::from(variables(["u", "v", "w"]));
    let found = mesh_moments(triangles, &reference);
    same_entries("inertia", &found.inertia, &diagonal(&law(&(&a * &b * &c), &a, &b, &c)))?;
    let scope = Scope::default().with("V", found.mass).with("C", found.centre).with("p", at);
    Ok(scope.with_each("I", &found.inertia.diagonal()).with_letters(["a", "b", "c"]))
}

pub(super) fn mesh_of_a_tetrahedron(base: [usize; 3]) -> Case {
    // One corner at the origin, and the point that the formula counts from anywhere: only their distance
    // matters.
    let mut corners = corners();
    corners[0] = Vector::zeros();
    let triangles = [base, [0, 3, 2], [0, 1, 3], [1, 2, 3]].map(|face| face.map(|n| &corners[n]));
    let reference = Vector::from(variables(["u", "v", "w"]));
    let found = mesh_moments(triangles, &reference);
    // At density one its mass is its volume, a sixth of the box on its edges.
    let volume = corners[1].cross(&corners[2]).dot(&corners[3]) / Fraction::from(6);
    let expected = tetrahedron_moments(&volume, &corners);
    same_entries("inertia", &found.inertia, &expected.inertia)?;
    let scope = Scope::default().with("V", found.mass).with("C", found.centre);
    Ok((0..).zip(corners).fold(scope, |scope, (n, corner)| scope.with(&format!("p_{n}"), corner)))
}

pub(super) fn triangle_inequality(
    cuboid: impl Fn(&Fraction, &Fraction, &Fraction, &Fraction) -> Vector,
) -> Case<Vec<Scope>> {
    let [m, a, b, c, r, h] = variables(["m", "a", "b", "c", "r", "h"]);
    // An outer radius is an inner one and something more.
    let outer = &r + &a;
    let all = [
        ("box", cuboid(&m, &a, &b, &c)),
        ("ellipsoid", ellipsoid_moments(&m, &a, &b, &c)),
        ("ball", ball_moments(&m, &r)),
        ("hollow sphere", hollow_sphere_moments(&m, &r, &outer)),
        ("cylinder", cylinder_moments(&m, &r, &h)),
        ("tube", tube_moments(&m, &r, &outer, &h)),
        ("cone", cone_moments(&m, &r, &h)),
        ("capsule", capsule_moments(&m, &r, &h)),
        ("rod", rod_moments(&m, &h)),
        ("plate", plate_moments(&m, &a, &b)),
        ("disk", disk_moments(&m, &r)),
    ];
    for (name, moments) in &all {
        for i in 0..3 {
            let [one, other, third] = [0, 1, 2].map(|j| &moments[(i + j) % 3]);
            let rest = one + other - third;
            if !rest.is_zero() {
                positive(name, &rest)?;
            }
        }
    }
    let flat = [plate_moments(&m, &a, &b), disk_moments(&m, &r)];
    Ok(flat
        .map(|flat| {
            Scope::default().with("A", flat.x.clone()).with("B", flat.y.clone()).with("C", flat.z.clone())
        })
        .into())
}
