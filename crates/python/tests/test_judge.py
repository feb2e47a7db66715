"""The judge: a record of MuJoCo made on the spot, single precision, frames, the kit's stories."""

import json

import mujoco
import numpy as np
import pytest
import tumbling
from scipy.spatial.transform import Rotation

MOMENTS, SPIN, DT = [1.0, 2.0, 2.5], [2.0, 4.0, -2.0], 1 / 60


def of_mujoco(integrator, moments=MOMENTS, spin=SPIN, rows=600):
    inertia = " ".join(map(str, moments))
    model = mujoco.MjModel.from_xml_string(
        f"""<mujoco><option gravity="0 0 0" timestep="{DT!r}" integrator="{integrator}"/><worldbody><body>
        <freejoint/><inertial pos="0 0 0" mass="1" diaginertia="{inertia}"/></body></worldbody></mujoco>"""
    )
    data = mujoco.MjData(model)
    data.qvel[3:6] = spin
    t, q, w = np.empty(rows), np.empty((rows, 4)), np.empty((rows, 3))
    for row in range(rows):
        t[row], q[row], w[row] = data.time, data.qpos[3:7], data.qvel[3:6]
        mujoco.mj_step(model, data)
    return t, q, w


@pytest.mark.parametrize("integrator", ["Euler", "implicitfast", "RK4"])
def test_a_record_of_mujoco_is_judged_to_be_mujocos_rule(integrator):
    t, q, w = of_mujoco(integrator)
    verdict = tumbling.judge(t, q, w, inertia=MOMENTS, frame="body", scalar_first=True, engine="MuJoCo")
    assert any(f"MuJoCo 4" in engine for engine in verdict.engines), verdict
    assert verdict.passed == (integrator == "RK4")


def test_spins_in_the_world_are_those_in_the_body_turned():
    t, q, w = of_mujoco("Euler")
    turned = Rotation.from_quat(q, scalar_first=True)
    there = tumbling.judge(t, turned, turned.apply(w), inertia=MOMENTS, frame="world")
    here = tumbling.judge(t, turned, w, inertia=MOMENTS, frame="body")
    mistaken = tumbling.judge(t, turned, w, inertia=MOMENTS, frame="world")
    assert there.rule == here.rule and there.rule is not None
    assert "world" in json.loads(mistaken.json())["file_mistakes"][0]


def test_single_precision_is_judged_as_single_precision():
    step = lambda state, dt: tumbling.FreeMotion(MOMENTS, state[1], unit(state[0])).at(dt)
    unit = lambda q: np.float64(q) / np.linalg.norm(np.float64(q))
    q, w, rows = np.float32([0, 0, 0, 1]), np.float32(SPIN), []
    for row in range(400):
        rows.append((q, w))
        q, w = (np.float32(x) for x in step((q, w), DT))
    q, w = (np.array(x) for x in zip(*rows))
    assert q.dtype == w.dtype == np.float32
    data = json.loads(tumbling.judge(DT, q, w, inertia=MOMENTS, frame="body").json())
    assert data["rounding"] == np.finfo(np.float32).eps and data["diagnosis"]["single"]
    assert data["diagnosis"]["confidence"] == "to rounding" and data["outcome"] == "passed"
    t = np.arange(400) * DT
    exact = tumbling.judge(t, *tumbling.FreeMotion(MOMENTS, SPIN).at(t), inertia=MOMENTS, frame="body")
    assert json.loads(exact.json())["rounding"] == np.finfo(np.float64).eps


def test_a_verdict_is_an_object_with_words_json_and_a_picture():
    t, q, w = of_mujoco("Euler")
    verdict = tumbling.judge(t, q, w, inertia=tumbling.Inertia(MOMENTS), frame="body", scalar_first=True)
    data = json.loads(verdict.json())
    assert data["outcome"] == verdict.outcome == "failed" and not verdict.passed
    assert str(verdict).upper().startswith(data["report"][0]["title"].upper()) and verdict.advice
    assert data["diagnosis"]["best"]["rule"] == verdict.rule
    page = verdict._repr_html_()
    assert page.count("<polyline") == 6 and "<table>" in page and "NaN" not in page
    for section in data["report"]:
        assert section["title"] in page


def test_a_verdict_has_its_laws_as_a_list():
    t, q, w = of_mujoco("Euler")
    verdict = tumbling.judge(t, q, w, inertia=MOMENTS, frame="body", scalar_first=True)
    energy = next(law for law in verdict.laws if law["law"] == "energy")
    kinetic = np.sum(MOMENTS * w**2, axis=1)
    assert energy["most"] == pytest.approx(abs(kinetic / kinetic[0] - 1).max()) and energy["allowed"] == 0.01
    assert json.loads(verdict.json())["version"] == 3 and tumbling.__version__.count(".") == 2


def test_one_object_in_two_descriptions_is_compared():
    t, q, w = of_mujoco("Euler")
    turn = Rotation.from_euler("xyz", [0.3, -0.8, 1.1])
    first, turned = Rotation.from_quat(q, scalar_first=True), Rotation.from_quat(q, scalar_first=True) * turn
    records = {"one": (t, first, w), "turned": (t, turned, turn.inv().apply(w))}
    found = tumbling.compare(records, frame="body")
    assert found.passed and "one, turned are one motion" in str(found)
    other = records | {"other": (t, *of_mujoco("RK4")[1:])}
    found = tumbling.compare(other, frame="body", scalar_first=True)
    data = json.loads(found.json())
    assert not found.passed and [one["name"] for one in data["others"]] == ["other"]
    assert data["others"][0]["spin"]["since"] is not None and tumbling.compare(other, frame="body", scalar_first=True, threshold=10).passed
    for wrong, words in [({"a": (t,)}, "neither attitudes nor spins"), ({}, "no record")]:
        with pytest.raises(tumbling.Error, match=words):
            tumbling.compare(wrong, frame="body")


def test_thresholds_are_those_of_the_laws():
    t, q, w = of_mujoco("RK4")
    judged = lambda threshold: tumbling.judge(t, q, w, inertia=MOMENTS, frame="body", scalar_first=True, threshold=threshold)
    assert judged(None).passed and judged(0.5).passed and judged({"energy": 0.1}).passed
    assert judged({"energy": 1e-15}).outcome == "failed"
    with pytest.raises(tumbling.Error, match="enrgy"):
        judged({"enrgy": 1})


def test_what_cannot_be_judged_says_where():
    t, q, w = of_mujoco("Euler", rows=50)
    judged = lambda t=t, q=q, w=w, **more: tumbling.judge(t, q, w, **{"inertia": MOMENTS, "frame": "body"} | more)
    for call, words in [
        (lambda: judged(t=t[::-1]), "time does not increase"),
        (lambda: judged(t=t[:-1]), "(50,)"),
        (lambda: judged(w=w[:-1]), "of 49"),
        (lambda: judged(w=np.where(np.arange(3) == 1, np.nan, w)), "NaN"),
        (lambda: judged(q=None, frame="world"), "without an attitude"),
        (lambda: judged(frame="bdy"), "'world' or 'body'"),
        (lambda: judged(q=None, w=None), "neither attitudes nor spins"),
        (lambda: judged(inertia=[1, 2, 3.5]), "3.5"),
    ]:
        with pytest.raises(tumbling.Error, match=words.replace("(", r"\(").replace(")", r"\)")):
            call()
    assert tumbling.judge(DT, q, inertia=MOMENTS, scalar_first=True).outcome == "failed"  # attitudes alone
    assert tumbling.judge(t, w=w, inertia=MOMENTS, frame="body").rule is not None  # spins alone


def test_the_exact_motion_passes_each_story(tumbling_story):
    """In either frame and either order."""
    step = lambda state, dt: tumbling.FreeMotion(tumbling_story.moments, state[1], unit(state[0])).at(dt)
    unit = lambda q: q / np.linalg.norm(q)
    verdict = tumbling_story.run(step, dt=1 / 30)
    # Of a ball the spin is constant, and nothing can be wrong with it.
    assert verdict.passed or tumbling_story.name == "sphere-5", verdict


@pytest.mark.tumbling_stories("turned-5", "box-5")
def test_a_step_in_the_worlds_axes_and_single_precision_is_run(tumbling_story):
    def step(state, dt):
        q, w = state
        assert q.dtype == w.dtype == np.float32
        turn = Rotation.from_quat(q, scalar_first=True)
        motion = tumbling.FreeMotion(tumbling_story.moments, turn.inv().apply(w), turn, scalar_first=True)
        q, w = motion.at(dt)
        return np.float32(q), np.float32(Rotation.from_quat(q, scalar_first=True).apply(w))

    verdict = tumbling_story.run(step, dt=DT, frame="world", scalar_first=True, dtype=np.float32)
    assert verdict.passed, verdict


@pytest.mark.tumbling_stories("box-5")
def test_a_spin_that_stands_still_fails(tumbling_story):
    def step(state, dt):
        q, w = state
        return (Rotation.from_quat(q) * Rotation.from_rotvec(w * dt)).as_quat(), w

    verdict = tumbling_story.run(step, dt=DT)
    assert not verdict.passed and verdict.rule == "no gyroscopic term"


def test_arrays_are_read_by_rows_however_they_stand_in_memory():
    t = np.arange(600) / 60
    q, w = tumbling.FreeMotion([1, 2, 3], [0.5, 4, 0.7], attitude=[0.5, 0.5, 0.5, 0.5]).at(t)
    by_columns = [np.asfortranarray, lambda x: np.array(list(x.T)).T, lambda x: x.copy("F")[::-1][::-1]]
    for turned in by_columns:
        assert tumbling.judge(t, turned(q), turned(w), inertia=[1, 2, 3], frame="body").passed
    first = q[:, [3, 0, 1, 2]]
    assert not first.flags.c_contiguous
    assert tumbling.judge(t, first, w, inertia=[1, 2, 3], frame="body", scalar_first=True).passed
    spins, moments = np.array([[0.5, 4, 0.7], [3, 0.2, 1]]), np.array([[1, 2, 3], [2, 2.5, 3.0]])
    plain = tumbling.Batch(moments, spins).at(t)
    again = tumbling.Batch(np.asfortranarray(moments), np.asfortranarray(spins)).at(t)
    assert all(np.array_equal(a, b) for a, b in zip(plain, again))
    times = np.asfortranarray(t.reshape(20, 30))
    assert np.array_equal(tumbling.FreeMotion([1, 2, 3], [0.5, 4, 0.7]).at(times)[1][7, 3], w[7 * 30 + 3])


def test_a_tensor_about_other_axes_is_judged_in_its_principal_ones():
    turn = Rotation.from_euler("xyz", [0.3, -0.8, 1.1])
    tensor = turn.as_matrix() @ np.diag(MOMENTS) @ turn.as_matrix().T
    t = np.arange(600) / 60
    q, w = tumbling.FreeMotion(tensor, spin=[2, 4, -2]).at(t)
    assert tumbling.judge(t, q, w, inertia=tensor, frame="body").passed
    in_world = Rotation.from_quat(q).apply(w)
    assert tumbling.judge(t, q, in_world, inertia=tensor, frame="world").passed
    single = tumbling.judge(t, np.float32(q), np.float32(w), inertia=tensor, frame="body")
    assert json.loads(single.json())["rounding"] < 1e-6 and single.passed
    assert not tumbling.judge(t, q, w, inertia=MOMENTS, frame="body").passed
