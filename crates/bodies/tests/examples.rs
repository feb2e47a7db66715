//! The files in examples/bodies are read, and are what they say.

use tumbling_bodies::BodyModel;

fn model(file: &str) -> BodyModel {
    BodyModel::load(&format!("{}/../../examples/bodies/{file}", env!("CARGO_MANIFEST_DIR"))).unwrap()
}

#[test]
fn every_example_is_a_body_and_the_hammer_of_the_file_is_that_of_the_library() {
    assert_eq!(model("phone.toml").sides, Some([0.077, 0.0078, 0.16]));
    let racket = model("racket.toml");
    assert!(racket.question.is_none() && racket.surfaces.len() == 2);
    assert_eq!(racket.mass.map(|mass| (1e9 * mass).round() / 1e9), Some(0.303));
    assert_eq!(racket.principal().axis(tumbling::Axis::Middle).amax().round(), 1.0);
    assert_eq!(model("cubesat.toml").surfaces.len(), 1);
    assert_eq!(model("asteroid.toml").mass, Some(1e12));
    let (file, library) = (model("hammer.urdf#hammer"), BodyModel::load("hammer").unwrap());
    let off = (file.moments().unwrap().vector() - library.moments().unwrap().vector()).amax();
    assert!(off < 1e-5 * library.moments().unwrap().vector().amax(), "{off}");
    assert!((file.centre - library.centre).amax() < 1e-5);
    assert!((file.reach() / library.reach() - 1.0).abs() < 1e-4);
}
