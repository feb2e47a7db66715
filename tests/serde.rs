//! What is written with serde is read back the same, and what no body has is not read.

use nalgebra::{Quaternion, UnitQuaternion, Vector3};
use tumbling::body::named::NamedBody;
use tumbling::{Body, Inertia, MassProperties, State};

fn there_and_back<T: serde::Serialize + serde::de::DeserializeOwned + PartialEq + std::fmt::Debug>(
    value: &T,
) {
    let text = serde_json::to_string(value).unwrap();
    assert_eq!(&serde_json::from_str::<T>(&text).unwrap(), value, "{text}");
}

fn turned() -> Inertia {
    let q = UnitQuaternion::from_euler_angles(0.5, -0.6, 2.7);
    Inertia::from_moments(0.003, 0.1, 0.102).unwrap().turned(q).unwrap()
}

#[test]
fn tensors_bodies_and_states_come_back_to_the_last_bit() {
    there_and_back(&turned());
    for body in NamedBody::ALL {
        there_and_back(&body.properties().unwrap());
    }
    let attitude = UnitQuaternion::from_euler_angles(-0.1, 2.0, 0.3);
    let body = Body::spinning(turned(), attitude, &Vector3::new(0.1, 10.0, -1e-9)).unwrap();
    there_and_back(&body);
    there_and_back(&State { attitude: attitude.into_inner(), momentum: body.momentum_body() });
}

#[test]
fn a_tensor_that_no_body_has_is_refused_with_the_margin_wherever_it_is_read() {
    let bad = r#"{"moments": [1.0, 2.0, 3.5], "products": [0.0, 0.0, 0.0]}"#;
    let refused = |error: serde_json::Error| error.to_string().contains("2 + 1 >= 3.5 fails by 0.5");
    assert!(serde_json::from_str::<Inertia>(bad).is_err_and(refused));
    let body = format!(r#"{{"mass": 1.0, "centre": [0.0, 0.0, 0.0], "inertia": {bad}}}"#);
    assert!(serde_json::from_str::<MassProperties>(&body).is_err_and(refused));
    let attitude = r#"{"w": 1.0, "x": 0.0, "y": 0.0, "z": 0.0}"#;
    let flight =
        format!(r#"{{"inertia": {bad}, "attitude": {attitude}, "momentum_world": [1.0, 0.0, 0.0]}}"#);
    assert!(serde_json::from_str::<Body>(&flight).is_err_and(refused));
    let state = r#"{"attitude": {"w": 0.5, "x": 0.0, "y": 0.0, "z": 0.0}, "momentum": [1.0, 0.0, 0.0]}"#;
    let state = serde_json::from_str::<State<f64>>(state).unwrap_err().to_string();
    assert!(state.contains("the attitude quaternion has length 0.5"), "{state}");
    let massless = body
        .replace(bad, r#"{"moments": [1.0, 2.0, 2.5], "products": [0.1, 0.0, 0.0]}"#)
        .replace("1.0, \"centre", "-1.0, \"centre");
    let massless = serde_json::from_str::<MassProperties>(&massless).unwrap_err().to_string();
    assert!(massless.contains("the mass is -1.0"), "{massless}");
}

#[test]
fn a_quaternion_is_written_by_the_names_of_its_components() {
    let state =
        State { attitude: Quaternion::new(0.6, 0.8, 0.0, 0.0), momentum: Vector3::new(1.0, 2.0, 3.0) };
    let text = r#"{"attitude":{"w":0.6,"x":0.8,"y":0.0,"z":0.0},"momentum":[1.0,2.0,3.0]}"#;
    assert_eq!(serde_json::to_string(&state).unwrap(), text);
}
