//! The inertia of every solid, from its definition as an integral over the body.

mod integrals;

use crate::number::Fraction;
use crate::proof::{Mutant, Proof};
use crate::symbols::Vector;
use integrals::{
    ball, capsule, cone, cuboid, cylinder, ellipsoid, hollow_sphere, mesh_of_a_box, mesh_of_a_tetrahedron,
    tetrahedron, thin, triangle_inequality, tube,
};
use nalgebra::Vector3;
use num_traits::Zero;
use tumbling::solid::{
    Ball, Capsule, Cone, Cuboid, Cylinder, Ellipsoid, MassMoments, Shape, ThinDisk, ThinPlate, ThinRod,
    tetrahedron_moments,
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
        statement: "The library's moments of every ball are the integrals over it.",
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
        statement: "Rod, plate and disk are the integrals over box and cylinder, with one or two of their sizes set to zero after \
                    the division by the volume.",
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
        statement: "The mesh formula on the twelve triangles of a box of any sides along the axes, wherever it stands, gives that \
                    box, whatever point it counts from.",
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
        statement: "The mesh formula on the four faces of any tetrahedron with a corner at the origin gives that tetrahedron, \
                    whatever point it counts from.",
        check: || mesh_of_a_tetrahedron([0, 2, 1]),
        mutants: &[Mutant {
            change: "one face turned inside out",
            check: || mesh_of_a_tetrahedron([0, 1, 2]),
        }],
    },
    Proof {
        name: "triangle-inequality",
        part: "solid",
        statement: "Of eleven shapes, from box to disk, I1 + I2 - I3 has no negative term in positive sizes, so that no moment \
                    exceeds the sum of the other two; of plate and disk it is zero.",
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
