//! Shared by the tests of solids: mass sampled point by point, and summed by the definition.

use nalgebra::{Matrix3, Vector3};
use proptest::prelude::*;
use tumbling::MassProperties;
use tumbling::solid::Compound;

/// Weighted points that integrate a shape: what they weigh together is its measure.
#[derive(Default, Clone)]
pub struct Cloud(pub Vec<(f64, Vector3<f64>)>);

impl Cloud {
    pub fn measure(&self) -> f64 {
        self.0.iter().map(|p| p.0).sum()
    }

    pub fn centre(&self) -> Vector3<f64> {
        self.0.iter().map(|p| p.1 * p.0).sum::<Vector3<f64>>() / self.measure()
    }

    /// The definition: `sum w (|d|^2 1 - d d^T)`, scaled to `mass`.
    pub fn tensor(&self, mass: f64) -> Matrix3<f64> {
        let centre = self.centre();
        let add = |sum: Matrix3<f64>, (w, p): &(f64, Vector3<f64>)| {
            let d = p - centre;
            sum + (Matrix3::identity() * d.norm_squared() - d * d.transpose()) * *w
        };
        self.0.iter().fold(Matrix3::zeros(), add) * (mass / self.measure())
    }

    pub fn and(mut self, sign: f64, other: &Self) -> Self {
        self.0.extend(other.0.iter().map(|(w, p)| (sign * w, *p)));
        self
    }
}

/// Nodes and weights of Gauss-Legendre quadrature with eight nodes on `[from, to]`: exact for polynomials to
/// degree 15. The nodes are found by Newton's method from the recurrence of the polynomials.
pub fn gauss(from: f64, to: f64) -> Vec<(f64, f64)> {
    const N: usize = 8;
    (0..N)
        .map(|i| {
            let mut x = (std::f64::consts::PI * (i as f64 + 0.75) / (N as f64 + 0.5)).cos();
            let mut derivative = 1.0;
            for _ in 0..20 {
                let (mut p, mut before) = (x, 1.0);
                for k in 2..=N {
                    let k = k as f64;
                    (p, before) = (((2.0 * k - 1.0) * x * p - (k - 1.0) * before) / k, p);
                }
                derivative = N as f64 * (x * p - before) / (x * x - 1.0);
                x -= p / derivative;
            }
            let weight = 2.0 / ((1.0 - x * x) * derivative * derivative);
            (0.5 * (from + to) + 0.5 * (to - from) * x, 0.5 * (to - from) * weight)
        })
        .collect()
}

/// A solid cut into elliptic slices across z: `semi(z)` are the squares of the semi-axes and `hole` is the
/// part of them that is empty. Round the ellipse by equal steps, outward and along z by Gauss: exact where
/// the squares of the semi-axes are polynomials.
pub fn slices(along: [f64; 2], hole: f64, semi: impl Fn(f64) -> [f64; 2]) -> Cloud {
    let mut cloud = Cloud::default();
    for (z, dz) in gauss(along[0], along[1]) {
        let [p, q] = semi(z).map(f64::sqrt);
        for (r, dr) in gauss(hole, 1.0) {
            for step in 0..12 {
                let angle = std::f64::consts::TAU * f64::from(step) / 12.0;
                let weight = p * q * r * dr * dz * std::f64::consts::TAU / 12.0;
                cloud.0.push((weight, Vector3::new(p * r * angle.cos(), q * r * angle.sin(), z)));
            }
        }
    }
    cloud
}

/// Mass properties against an integral: measure, centre and the whole tensor to rounding.
pub fn assert_integrates(what: &str, solid: MassProperties, measure: f64, cloud: &Cloud) {
    let size = cloud.measure();
    assert!((measure - size).abs() <= 1e-12 * size, "{what}: measure {measure}, integral {size}");
    let expected = cloud.tensor(solid.mass());
    let extent = cloud.0.iter().map(|p| p.1.norm()).fold(0.0, f64::max);
    let off = (solid.centre() - cloud.centre()).norm();
    assert!(off <= 1e-12 * extent, "{what}: centre {} integral {}", solid.centre(), cloud.centre());
    let off = (solid.inertia().matrix() - expected).amax();
    assert!(off <= 1e-12 * expected.amax(), "{what}: {} integral {expected}", solid.inertia().matrix());
}

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
