//! The inertia of every solid, from its definition as an integral over the body.

use crate::number::{Derivation, Fraction, Polynomial, Relations};
use crate::proof::{Mutant, Outcome, Proof, not_negative, same, same_matrices, same_vectors};
use crate::region::{Region, Sums};
use crate::symbols::{Matrix, Vector, diagonal, variables};
use nalgebra::Vector3;
use num_traits::{One, Zero};
use tumbling::inertia::point_mass;
use tumbling::solid::{
    Ball, Capsule, Cone, Cuboid, Cylinder, Ellipsoid, MassMoments, Shape, ThinDisk, ThinPlate, ThinRod,
    mesh_moments, tetrahedron_moments,
};

/// The law of a shape as a function of its mass and each of its sizes.
macro_rules! laws {
    ($($law:ident: $Shape:ident($($size:ident),+);)+) => {$(
        fn $law(mass: &Fraction, $($size: &Fraction),+) -> Vector {
            $Shape::moments(mass, [$($size),+])
        }
    )+};
}
laws! {
    ball_moments: Ball(r);
    hollow_sphere_moments: Ball(inner, outer);
    ellipsoid_moments: Ellipsoid(a, b, c);
    cuboid_moments: Cuboid(a, b, c);
    plate_moments: ThinPlate(a, b);
    rod_moments: ThinRod(length);
    disk_moments: ThinDisk(r);
    cylinder_moments: Cylinder(r, h);
    tube_moments: Cylinder(inner, outer, h);
    cone_moments: Cone(r, h);
    capsule_moments: Capsule(r, l);
}

pub(super) const PROOFS: &[Proof] = &[
    Proof {
        name: "box",
        part: "solid",
        statement: "The moments of every box are the integrals of y² + z² and so on over it; its products vanish.",
        check: || cuboid(cuboid_moments),
        mutants: &[
            Mutant {
                change: "edges a and b swapped",
                check: || cuboid(|m, a, b, c| cuboid_moments(m, b, a, c)),
            },
            Mutant {
                change: "12 becomes 8",
                check: || cuboid(|m, a, b, c| cuboid_moments(&times(m, 3, 2), a, b, c)),
            },
            Mutant {
                change: "b² + c² becomes b² - c²",
                check: || {
                    cuboid(|m, a, b, c| {
                        cuboid_moments(m, a, b, c) - along(0, m * c * c.clone() / Fraction::from(6))
                    })
                },
            },
        ],
    },
    Proof {
        name: "ellipsoid",
        part: "solid",
        statement: "The moments of every ellipsoid, by integrating over it; its products vanish.",
        check: || ellipsoid(ellipsoid_moments),
        mutants: &[
            Mutant {
                change: "axes b and c swapped",
                check: || ellipsoid(|m, a, b, c| ellipsoid_moments(m, a, c, b)),
            },
            Mutant {
                change: "5 becomes 4",
                check: || ellipsoid(|m, a, b, c| ellipsoid_moments(&times(m, 5, 4), a, b, c)),
            },
        ],
    },
    Proof {
        name: "ball",
        part: "solid",
        statement: "The moment of every ball about any axis through its centre is 2/5 m r².",
        check: || ball(ball_moments),
        mutants: &[Mutant {
            change: "2/5 becomes 2/3, that of a shell",
            check: || ball(|m, r| ball_moments(&times(m, 5, 3), r)),
        }],
    },
    Proof {
        name: "hollow-sphere",
        part: "solid",
        statement: "The moment of every hollow sphere is that of a ball less that of its hole, for the mass that is left; \
                    with equal radii it is 2/3 m r².",
        check: || hollow_sphere(hollow_sphere_moments),
        mutants: &[Mutant {
            change: "the hole filled",
            check: || hollow_sphere(|m, _, o| ball_moments(m, o)),
        }],
    },
    Proof {
        name: "cylinder",
        part: "solid",
        statement: "The moments of every full cylinder, by integrating over it; its products vanish.",
        check: || cylinder(cylinder_moments),
        mutants: &[
            Mutant {
                change: "axis along x, not z",
                check: || cylinder(|m, r, h| turned_about_y(&cylinder_moments(m, r, h))),
            },
            Mutant {
                change: "the height doubled",
                check: || cylinder(|m, r, h| cylinder_moments(m, r, &times(h, 2, 1))),
            },
        ],
    },
    Proof {
        name: "tube",
        part: "solid",
        statement: "The moments of every tube are those of a cylinder less those of its hole, for the mass that is left.",
        check: || tube(tube_moments),
        mutants: &[Mutant {
            change: "i² + o² becomes o²",
            check: || tube(|m, _, o, h| cylinder_moments(m, o, h)),
        }],
    },
    Proof {
        name: "cone",
        part: "solid",
        statement: "The centre of every full cone is a quarter of the way up; its moments about that centre, by \
                    integrating over it.",
        check: || cone(cone_moments, 4),
        mutants: &[
            Mutant { change: "the centre a third of the way up", check: || cone(cone_moments, 3) },
            Mutant {
                change: "radius and height swapped",
                check: || cone(|m, r, h| cone_moments(m, h, r), 4),
            },
        ],
    },
    Proof {
        name: "capsule",
        part: "solid",
        statement: "The moments of every capsule, by integrating over its cylinder and its two half balls.",
        check: || capsule(capsule_moments),
        mutants: &[Mutant {
            change: "the caps' 3/8 l r left out",
            check: || {
                capsule(|m, r, l| {
                    let whole = Fraction::from(3) * l + Fraction::from(4) * r;
                    let part = Fraction::ratio(3, 2) * r * r * l.clone() * m / whole;
                    capsule_moments(m, r, l) - Vector3::new(part.clone(), part, Fraction::zero())
                })
            },
        }],
    },
    Proof {
        name: "thin-bodies",
        part: "solid",
        statement: "Rod, plate and disk are what remains of box and cylinder as a size goes to zero.",
        check: || thin(rod_moments, plate_moments, disk_moments),
        mutants: &[
            Mutant {
                change: "the rod along x",
                check: || thin(|m, l| turned_about_y(&rod_moments(m, l)), plate_moments, disk_moments),
            },
            Mutant {
                change: "the plate's edges swapped",
                check: || thin(rod_moments, |m, a, b| plate_moments(m, b, a), disk_moments),
            },
            Mutant {
                change: "the disk twice as heavy",
                check: || thin(rod_moments, plate_moments, |m, r| disk_moments(&times(m, 2, 1), r)),
            },
        ],
    },
    Proof {
        name: "tetrahedron",
        part: "solid",
        statement: "Centre and inertia of every tetrahedron, wherever its corners are, by integrating over it.",
        check: || tetrahedron(tetrahedron_moments),
        mutants: &[Mutant {
            change: "a twentieth becomes a quarter, as if all mass sat at the corners",
            check: || {
                tetrahedron(|m, v| {
                    let body = tetrahedron_moments(m, v);
                    MassMoments { inertia: body.inertia.map(|x| x * Fraction::from(5)), ..body }
                })
            },
        }],
    },
    Proof {
        name: "mesh-of-a-box",
        part: "solid",
        statement: "The mesh formula on the twelve triangles of a box with any sides, standing anywhere, gives that box, \
                    whatever point it counts from.",
        check: || mesh_of_a_box(false, cuboid_moments),
        mutants: &[
            Mutant {
                change: "one triangle turned inside out",
                check: || mesh_of_a_box(true, cuboid_moments),
            },
            Mutant {
                change: "edges a and c swapped in the box",
                check: || mesh_of_a_box(false, |m, a, b, c| cuboid_moments(m, c, b, a)),
            },
        ],
    },
    Proof {
        name: "mesh-of-a-tetrahedron",
        part: "solid",
        statement: "The mesh formula on the four faces of any tetrahedron gives that tetrahedron: the solid into which every \
                    other with flat faces is cut.",
        check: || mesh_of_a_tetrahedron([0, 2, 1]),
        mutants: &[Mutant {
            change: "one face turned inside out",
            check: || mesh_of_a_tetrahedron([0, 1, 2]),
        }],
    },
    Proof {
        name: "triangle-inequality",
        part: "solid",
        statement: "No moment of any solid exceeds the sum of the other two: I1 + I2 - I3 has no negative term; for flat \
                    bodies it is zero.",
        check: || triangle_inequality(cuboid_moments),
        mutants: &[Mutant {
            change: "a box whose first moment has b² + 3 c²",
            check: || {
                triangle_inequality(|m, a, b, c| {
                    cuboid_moments(m, a, b, c) + along(0, m * c * c.clone() / Fraction::from(6))
                })
            },
        }],
    },
];

/// `x n / d`.
fn times(x: &Fraction, n: i64, d: i64) -> Fraction {
    x * &Fraction::ratio(n, d)
}

fn along(axis: usize, x: Fraction) -> Vector {
    Vector::from_fn(|i, _| if i == axis { x.clone() } else { Fraction::zero() })
}

fn turned_about_y(moments: &Vector) -> Vector {
    Vector3::new(moments.z.clone(), moments.y.clone(), moments.x.clone())
}

fn symbol(name: &str) -> Polynomial {
    Polynomial::variable(name)
}

fn half(p: &Polynomial) -> Polynomial {
    p.exact_quotient(&Polynomial::from(2)).unwrap_or_default()
}

/// That a body evenly filled with mass `m` has this mass, centre and inertia.
fn has_moments(solid: &Sums, body: &MassMoments<Fraction>) -> Outcome {
    let density = &body.mass / &solid.volume;
    same_vectors("centre", &body.centre, &solid.first.map(|x| x / solid.volume.clone()))?;
    let about_origin = &body.inertia + point_mass(&body.mass, &body.centre);
    same_matrices("inertia", &about_origin, &solid.inertia.map(|x| x * density.clone()))
}

fn centred(mass: &Fraction, moments: &Vector) -> MassMoments<Fraction> {
    MassMoments { mass: mass.clone(), centre: Vector::zeros(), inertia: diagonal(moments) }
}

fn box_sums() -> Result<Sums, crate::proof::Residue> {
    let mut region = Region::new(Vector::from(variables(["x", "y", "z"])), Relations::none());
    for (name, edge) in [("x", "a"), ("y", "b"), ("z", "c")] {
        let half = half(&symbol(edge));
        region = region.between(name, &-half.clone(), &half);
    }
    region.sums()
}

fn cuboid(law: impl Fn(&Fraction, &Fraction, &Fraction, &Fraction) -> Vector) -> Outcome {
    let [m, a, b, c] = variables(["m", "a", "b", "c"]);
    has_moments(&box_sums()?, &centred(&m, &law(&m, &a, &b, &c)))
}

/// The part of an ellipsoid with semi-axes `axes` between the relative heights `from` and `to`, its middle
/// raised by `lift`. At the relative height `t` each section is an ellipse smaller by `k`, `k² = 1 - t²`.
fn ellipsoid_part(axes: &Vector, lift: &Fraction, from: i64, to: i64) -> Result<Sums, crate::proof::Residue> {
    let [rho, k, cos, sin, t] = variables(["rho", "k", "cos", "sin", "t"]);
    let t_squared = symbol("t").pow(2);
    let circles = vec![
        ("cos".into(), Polynomial::one() - symbol("sin").pow(2)),
        ("k".into(), Polynomial::one() - t_squared),
    ];
    let relations =
        Relations::new(circles).map_err(|rule| crate::proof::Residue::Missing { claim: rule.to_string() })?;
    let across = &rho * &k;
    let position =
        Vector3::new(&axes.x * &across * cos, &axes.y * &across * sin, &axes.z * &t + lift.clone());
    let slope = -t / k;
    Region::new(position, relations)
        .between("rho", &Polynomial::zero(), &Polynomial::one())
        .around("cos", "sin")
        .between_with("t", &from.into(), &to.into(), Derivation::new([("k", slope)]))
        .sums()
}

fn ball_sums(radius: &Fraction) -> Result<Sums, crate::proof::Residue> {
    ellipsoid_part(&Vector::repeat(radius.clone()), &Fraction::zero(), -1, 1)
}

fn ellipsoid(law: impl Fn(&Fraction, &Fraction, &Fraction, &Fraction) -> Vector) -> Outcome {
    let [m, a, b, c] = variables(["m", "a", "b", "c"]);
    let moments = law(&m, &a, &b, &c);
    has_moments(&ellipsoid_part(&Vector3::new(a, b, c), &Fraction::zero(), -1, 1)?, &centred(&m, &moments))
}

fn ball(law: impl Fn(&Fraction, &Fraction) -> Vector) -> Outcome {
    let [m, r] = variables(["m", "r"]);
    has_moments(&ball_sums(&r)?, &centred(&m, &law(&m, &r)))
}

fn hollow_sphere(law: impl Fn(&Fraction, &Fraction, &Fraction) -> Vector) -> Outcome {
    let [m, i, o] = variables(["m", "i", "o"]);
    let solid = ball_sums(&o)?.without(&ball_sums(&i)?);
    has_moments(&solid, &centred(&m, &law(&m, &i, &o)))?;
    same("a thin shell", &law(&m, &o, &o).x, &(Fraction::ratio(2, 3) * &m * &o * &o))
}

/// A cylinder of the given radius about z, between two heights.
fn cylinder_part(radius: &str, from: &Polynomial, to: &Polynomial) -> Result<Sums, crate::proof::Residue> {
    let [rho, cos, sin, z] = variables(["rho", "cos", "sin", "z"]);
    Region::new(Vector3::new(&rho * &cos, rho * sin, z), Relations::circle("cos", "sin"))
        .between("rho", &Polynomial::zero(), &symbol(radius))
        .around("cos", "sin")
        .between("z", from, to)
        .sums()
}

fn cylinder_sums(radius: &str, height: &str) -> Result<Sums, crate::proof::Residue> {
    let half = half(&symbol(height));
    cylinder_part(radius, &-half.clone(), &half)
}

fn cylinder(law: impl Fn(&Fraction, &Fraction, &Fraction) -> Vector) -> Outcome {
    let [m, r, h] = variables(["m", "r", "h"]);
    has_moments(&cylinder_sums("r", "h")?, &centred(&m, &law(&m, &r, &h)))
}

fn tube(law: impl Fn(&Fraction, &Fraction, &Fraction, &Fraction) -> Vector) -> Outcome {
    let [m, i, o, h] = variables(["m", "i", "o", "h"]);
    let solid = cylinder_sums("o", "h")?.without(&cylinder_sums("i", "h")?);
    has_moments(&solid, &centred(&m, &law(&m, &i, &o, &h)))
}

/// A cone whose centre is one `part`-th of the way up.
fn cone(law: impl Fn(&Fraction, &Fraction, &Fraction) -> Vector, part: i64) -> Outcome {
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

fn capsule(law: impl Fn(&Fraction, &Fraction, &Fraction) -> Vector) -> Outcome {
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

fn thin(
    rod: impl Fn(&Fraction, &Fraction) -> Vector,
    plate: impl Fn(&Fraction, &Fraction, &Fraction) -> Vector,
    disk: impl Fn(&Fraction, &Fraction) -> Vector,
) -> Outcome {
    let [m, a, b, c, r] = variables(["m", "a", "b", "c", "r"]);
    let cuboid = box_sums()?;
    same_matrices("rod", &diagonal(&rod(&m, &c)), &limit(&cuboid, &["a", "b"]))?;
    same_matrices("plate", &diagonal(&plate(&m, &a, &b)), &limit(&cuboid, &["c"]))?;
    same_matrices("disk", &diagonal(&disk(&m, &r)), &limit(&cylinder_sums("r", "h")?, &["h"]))
}

/// Four corners, the first at the origin or anywhere.
fn corners() -> [Vector; 4] {
    [1, 2, 3, 4].map(|n| Vector::from(["x", "y", "z"].map(|axis| Fraction::variable(&format!("{axis}{n}")))))
}

fn tetrahedron(law: impl Fn(&Fraction, &[Vector; 4]) -> MassMoments<Fraction>) -> Outcome {
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
    has_moments(&solid, &law(&m, &corners))
}

/// A box of edges a, b, c with one corner anywhere, cut into triangles, all seen counter-clockwise from
/// outside; or one of them not.
fn mesh_of_a_box(
    inside_out: bool,
    law: impl Fn(&Fraction, &Fraction, &Fraction, &Fraction) -> Vector,
) -> Outcome {
    let [a, b, c] = variables(["a", "b", "c"]);
    let at = Vector::from(variables(["x", "y", "z"]));
    let edges = [&a, &b, &c];
    let corner =
        |n: usize| Vector::from_fn(|i, _| if n >> i & 1 == 1 { &at[i] + edges[i] } else { at[i].clone() });
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
    let volume = &a * &b * &c;
    same("volume", &found.mass, &volume)?;
    let middle = Vector::from_fn(|i, _| &at[i] + &(edges[i] / &Fraction::from(2)));
    same_vectors("centre", &found.centre, &middle)?;
    same_matrices("inertia", &found.inertia, &diagonal(&law(&volume, &a, &b, &c)))
}

fn mesh_of_a_tetrahedron(base: [usize; 3]) -> Outcome {
    // One corner at the origin, and the point that the formula counts from anywhere: only their distance matters.
    let mut corners = corners();
    corners[0] = Vector::zeros();
    let triangles = [base, [0, 3, 2], [0, 1, 3], [1, 2, 3]].map(|face| face.map(|n| &corners[n]));
    let reference = Vector::from(variables(["u", "v", "w"]));
    let found = mesh_moments(triangles, &reference);
    // At density one its mass is its volume, a sixth of the box on its edges.
    let volume = corners[1].cross(&corners[2]).dot(&corners[3]) / Fraction::from(6);
    same("mass", &found.mass, &volume)?;
    let expected = tetrahedron_moments(&volume, &corners);
    same_vectors("centre", &found.centre, &expected.centre)?;
    same_matrices("inertia", &found.inertia, &expected.inertia)
}

fn triangle_inequality(cuboid: impl Fn(&Fraction, &Fraction, &Fraction, &Fraction) -> Vector) -> Outcome {
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
            not_negative(name, &(one + other - third))?;
        }
    }
    for (name, flat) in [("plate", plate_moments(&m, &a, &b)), ("disk", disk_moments(&m, &r))] {
        same(name, &(&flat.x + &flat.y), &flat.z)?;
    }
    Ok(())
}
