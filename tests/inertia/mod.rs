mod inverse;
mod moments;
mod nearest;
mod possible;
mod principal;
mod tensor;

use crate::common::{attitude, moments};
use proptest::prelude::*;
use tumbling::Inertia;

/// Of any principal moments along any axes.
pub fn any_tensor() -> impl Strategy<Value = Inertia> {
    (moments(), attitude())
        .prop_map(|(m, q)| Inertia::from_moments(m.x, m.y, m.z).unwrap().turned(&q).unwrap())
}
