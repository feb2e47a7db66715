"""Runs the stories of the kit with your step: a test with the fixture `tumbling_story` runs once for each story.

    def test_my_engine_turns_bodies(tumbling_story):
        engine = MyEngine(tumbling_story.moments)
        verdict = tumbling_story.run(engine.step, dt=1 / 60)  # step((attitude, spin), dt) -> (attitude, spin)
        assert verdict.passed, verdict

`@pytest.mark.tumbling_stories("box-5", "needle-5")` selects these stories only.
"""

import pytest

from tumbling import Story


def pytest_configure(config):
    config.addinivalue_line("markers", "tumbling_stories(*names): the stories for `tumbling_story`; all stories without this marker")


def pytest_generate_tests(metafunc):
    if "tumbling_story" in metafunc.fixturenames:
        mark = metafunc.definition.get_closest_marker("tumbling_stories")
        stories = [Story.named(name) for name in mark.args] if mark else Story.all()
        metafunc.parametrize("tumbling_story", stories, ids=[story.name for story in stories])
