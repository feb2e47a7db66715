//! The engine's step, judged by stories of the kit; `Story::all()` has 22.

use judge_in_tests::step;
use tumbling_judge::{Story, assert_passes};

#[test]
fn a_free_body_turns_as_it_should() {
    for story in ["box-5", "needle-5", "sphere-5"].into_iter().filter_map(Story::named) {
        let moments = story.moments.map(|moment| moment as f32);
        assert_passes!(story.run(1.0 / 60.0, |q, w| step(q, w, moments, 1.0 / 60.0)));
    }
}
