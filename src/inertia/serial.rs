//! The form in which a tensor is written and read with serde, feature `serde`. What is read goes through the
//! constructor.

use super::Inertia;
use crate::error::Error;
use serde::{Deserialize, Serialize};

/// Moments `[ixx, iyy, izz]` and products `[ixy, ixz, iyz]`, kg m², with the sign that makes `L = I w` hold.
#[derive(Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct Tensor {
    moments: [f64; 3],
    products: [f64; 3],
}

impl From<Inertia> for Tensor {
    fn from(inertia: Inertia) -> Self {
        let m = inertia.matrix();
        Self { moments: m.diagonal().into(), products: [m.m12, m.m13, m.m23] }
    }
}

impl TryFrom<Tensor> for Inertia {
    type Error = Error;

    fn try_from(tensor: Tensor) -> Result<Self, Error> {
        Self::new(tensor.moments, tensor.products)
    }
}
