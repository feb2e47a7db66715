//! Shared by the tests of solids: what bodies are drawn from, moved, joined and compared by.

use nalgebra::Vector3;
use proptest::prelude::*;
use tumbling::MassProperties;
use tumbling::solid::Compound;

/// That two bodies agree to `relative` rounding: mass, centre (against `extent`) and tensor.
pub fn assert_same(what: &str, a: &MassProperties, b: &MassProperties, relative: f64, extent: f64) {
    assert!((a.mass() - b.mass()).abs() <= relative * b.mass(), "{what}: mass {} {}", a.mass(), b.mass());
    let off = (a.centre() - b.centre()).amax();
    assert!(off <= relative * extent, "{what}: centre {} {}", a.centre(), b.centre());
    let (m, n) = (a.inertia().matrix(), b.inertia().matrix());
    assert!((m - n).amax() <= relative * n.amax(), "{what}: {m} {n}");
}

/// A body carried along by `offset`.
pub fn moved(body: &MassProperties, offset: &Vector3<f64>) -> Result<MassProperties, tumbling::Error> {
    Compound::new().at(*body, offset).properties()
}

/// Parts that stay where they are, as one body.
pub fn together(parts: &[MassProperties]) -> Result<MassProperties, tumbling::Error> {
    parts.iter().fold(Compound::new(), |whole, part| whole.at(*part, &Vector3::zeros())).properties()
}

/// A size or mass in sober range.
pub fn size() -> impl Strategy<Value = f64> + Clone {
    (-1.0..1.0_f64).prop_map(|e| 10.0_f64.powf(e))
}

/// A size or mass over many decades.
pub fn decades() -> impl Strategy<Value = f64> {
    (-75.0..75.0_f64).prop_map(|e| 10.0_f64.powf(e))
}

pub fn vector(component: impl Strategy<Value = f64> + Clone) -> impl Strategy<Value = Vector3<f64>> {
    [component.clone(), component.clone(), component].prop_map(Vector3::from)
}
