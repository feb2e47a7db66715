//! The engine's step, judged by every story of the kit.

use judge_in_tests::step;
use tumbling_judge::{Story, assert_passes};

#[test]
fn a_free_body_turns_as_it_should() {
    for story in Story::all() {
        let moments = story.moments.map(|moment| moment as f32);
        assert_passes!(story.run(1.0 / 60.0, |q, w| step(q, w, moments, 1.0 / 60.0)));
    }
}
