//! The inertia of the solids, from its definition as an integral over the body.

mod integrals;

use crate::number::Fraction;
use crate::symbols::Vector;
use integrals::{
    ball, capsule, cone, cuboid, cylinder, ellipsoid, hollow_sphere, mesh_of_a_box, mesh_of_a_tetrahedron,
    tetrahedron, thin, triangle_inequality, tube,
};
use nalgebra::Vector3;
use num_traits::Zero;
use tumbling::laws::tetrahedron_moments;
use tumbling::solid::{
    Ball, Capsule, Cone, Cuboid, Cylinder, Ellipsoid, MassMoments, Shape, ThinDisk, ThinPlate, ThinRod,
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

proofs! {
    "solid" {
        "box": cuboid(cuboid_moments),
            r"The integrals over every box are its moments $I_1 = \tfrac{1}{12} m (b^2 + c^2)$, $I_2 = \tfrac{1}{12} m (c^2 + a^2)$ and $I_3 = \tfrac{1}{12} m (a^2 + b^2)$; its products vanish.";
            but "edges a and b swapped": cuboid(|m, a, b, c| cuboid_moments(m, b, a, c)),
        "ellipsoid": ellipsoid(ellipsoid_moments),
            r"The integrals over every ellipsoid are its moments $I_1 = \tfrac{1}{5} m (b^2 + c^2)$, $I_2 = \tfrac{1}{5} m (c^2 + a^2)$ and $I_3 = \tfrac{1}{5} m (a^2 + b^2)$; its products vanish.";
            but "axes b and c swapped": ellipsoid(|m, a, b, c| ellipsoid_moments(m, a, c, b)),
        "ball": ball(ball_moments),
            r"The integrals over every ball are its moments $I_1 = I_2 = I_3 = \tfrac{2}{5} m r^2$; its products vanish.";
            but "2/5 becomes 2/3, that of a shell": ball(|m, r| ball_moments(&times(m, 5, 3), r)),
        "hollow-sphere": hollow_sphere(hollow_sphere_moments),
            r"The moments of every hollow sphere are those of a ball less those of its hole, for the mass that is left, $I_1 = I_2 = I_3$ with $I_1 (o^3 - i^3) = \tfrac{2}{5} m (o^5 - i^5)$; with equal radii each is $I = \tfrac{2}{3} m i^2$.";
            but "the hole filled": hollow_sphere(|m, _, o| ball_moments(m, o)),
        "cylinder": cylinder(cylinder_moments),
            r"The integrals over every full cylinder are its moments $I_1 = I_2 = \tfrac{1}{12} m (3 r^2 + h^2)$ and $I_3 = \tfrac{1}{2} m r^2$; its products vanish.";
            but "axis along x, not z": cylinder(|m, r, h| turned_about_y(&cylinder_moments(m, r, h))),
        "tube": tube(tube_moments),
            r"The moments of every tube are those of a cylinder less those of its hole, for the mass that is left, $I_1 = I_2 = \tfrac{1}{12} m (3 o^2 + 3 i^2 + h^2)$ and $I_3 = \tfrac{1}{2} m (o^2 + i^2)$.";
            but "the hole filled": tube(|m, _, o, h| cylinder_moments(m, o, h)),
        "cone": cone(cone_moments, 4),
            r"The centre of every full cone is a quarter of the way up, $C = (0, 0, \tfrac{1}{4} h)$; by integrating over it, its moments about that centre are $I_1 = I_2 = \tfrac{3}{80} m (4 r^2 + h^2)$ and $I_3 = \tfrac{3}{10} m r^2$. That the library puts its centre there is tested, and no part of it.";
            but "the centre a third of the way up": cone(cone_moments, 3),
            but "radius and height swapped": cone(|m, r, h| cone_moments(m, h, r), 4),
        "capsule": capsule(capsule_moments),
            r"The integrals over the cylinder and the two half balls of every capsule are $I_1 = I_2$ and $I_3$ with $I_3 (3 l + 4 r) = m r^2 (\tfrac{3}{2} l + \tfrac{8}{5} r)$ and $I_1 (3 l + 4 r) = m (\tfrac{1}{4} l^3 + r l^2 + \tfrac{9}{4} r^2 l + \tfrac{8}{5} r^3)$.";
            but "the caps' 3/8 l r left out": {
                capsule(|m, r, l| {
                    let whole = Fraction::from(3) * l + Fraction::from(4) * r;
                    let part = Fraction::ratio(3, 2) * r * r * l.clone() * m / whole;
                    capsule_moments(m, r, l) - Vector3::new(part.clone(), part, Fraction::zero())
                })
            },
        "thin-bodies": thin(rod_moments, plate_moments, disk_moments),
            r"The integrals over box and cylinder, with one or two of their sizes set to zero after the division by the volume, are those of the rod, $S = \tfrac{1}{12} m (c^2, c^2, 0)$, the plate, $P = \tfrac{1}{12} m (b^2, a^2, a^2 + b^2)$, and the disk, $D = \tfrac{1}{4} m (r^2, r^2, 2 r^2)$.";
            but "the rod along x": thin(|m, l| turned_about_y(&rod_moments(m, l)), plate_moments, disk_moments),
            but "the plate's edges swapped": thin(rod_moments, |m, a, b| plate_moments(m, b, a), disk_moments),
        "tetrahedron": tetrahedron(tetrahedron_moments),
            r"By integrating over it, every tetrahedron has the centre $C = \tfrac{1}{4} (p_1 + p_2 + p_3 + p_4)$, wherever its corners are, and, with these counted from the centre, the tensor $I n = \frac{m}{20} (r_1\times (n\times r_1) + r_2\times (n\times r_2) + r_3\times (n\times r_3) + r_4\times (n\times r_4))$.";
            but "a twentieth becomes a quarter, as if all mass sat at the corners": {
                tetrahedron(|m, v| {
                    let body = tetrahedron_moments(m, v);
                    MassMoments { inertia: body.inertia.map(|x| x * Fraction::from(5)), ..body }
                })
            },
        "mesh-of-a-box": mesh_of_a_box(false, cuboid_moments),
            r"The mesh formula on the twelve triangles of a box of any sides along the axes, wherever its corner $p$ is, gives that box, whatever point it counts from: $V = a b c$, $C = p + \tfrac{1}{2} (a, b, c)$, $I_1 = \tfrac{1}{12} V (b^2 + c^2)$, $I_2 = \tfrac{1}{12} V (c^2 + a^2)$ and $I_3 = \tfrac{1}{12} V (a^2 + b^2)$, without products.";
            but "one triangle turned inside out": mesh_of_a_box(true, cuboid_moments),
            but "edges a and c swapped in the box": mesh_of_a_box(false, |m, a, b, c| cuboid_moments(m, c, b, a)),
        "mesh-of-a-tetrahedron": mesh_of_a_tetrahedron([0, 2, 1]),
            r"The mesh formula on the four faces of any tetrahedron with a corner at the origin gives that tetrahedron, whatever point it counts from: its volume, $6 V = (p_1\times p_2)\cdot p_3$, its centre, $4 C = p_1 + p_2 + p_3$, and its tensor.";
            but "one face turned inside out": mesh_of_a_tetrahedron([0, 1, 2]),
        "triangle-inequality": triangle_inequality(cuboid_moments),
            r"Of eleven shapes, from box to disk, the sum of two moments less the third has no negative term in positive sizes, so that no moment exceeds the sum of the other two; of plate and disk $A + B = C$.";
            but "a box whose first moment has b² + 3 c²": triangle_inequality(|m, a, b, c| cuboid_moments(m, a, b, c) + along(0, m * c * c.clone() / Fraction::from(6))),
    }
}

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
