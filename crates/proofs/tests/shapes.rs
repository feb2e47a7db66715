//! What a shape answers is its proven law, on its own sizes in their order. The mass is such that nothing is
//! rounded on the way, so that fractions and floats must agree to the last bit.

use nalgebra::{Matrix3, Vector3};
use tumbling::Error;
use tumbling::solid::{Capsule, Cone, Cuboid, Cylinder, Ellipsoid, Shape, Solid, ThinPlate};
use tumbling_proofs::Rational;

fn answers(solid: &impl Solid, law: &Vector3<Rational>) -> Result<(), Error> {
    let moments = law.map(|x| x.to_f64());
    assert_eq!(solid.with_mass(240.0)?.inertia().matrix(), Matrix3::from_diagonal(&moments));
    Ok(())
}

#[test]
fn every_shape_answers_with_its_proven_law() -> Result<(), Error> {
    let [m, a, b, c] = [240, 2, 3, 5].map(Rational::from);
    answers(&Cuboid::new(2.0, 3.0, 5.0)?, &Cuboid::moments(&m, [&a, &b, &c]))?;
    answers(&Ellipsoid::new(2.0, 3.0, 5.0)?, &Ellipsoid::moments(&m, [&a, &b, &c]))?;
    answers(&Cylinder::hollow(2.0, 3.0, 5.0)?, &Cylinder::moments(&m, [&a, &b, &c]))?;
    answers(&Cylinder::new(2.0, 3.0)?, &Cylinder::moments(&m, [&a, &b]))?;
    answers(&Cone::new(2.0, 3.0)?, &Cone::moments(&m, [&a, &b]))?;
    answers(&Capsule::new(3.0, 4.0)?, &Capsule::moments(&m, [&b, &Rational::from(4)]))?;
    answers(&ThinPlate::new(2.0, 3.0)?, &ThinPlate::moments(&m, [&a, &b]))
}
