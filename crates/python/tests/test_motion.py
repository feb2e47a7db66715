"""Motions: against SciPy, against each other, and bit for bit against the library called from Rust."""

import json
import os
import threading
import time

import numpy as np
import pytest
import tumbling
from scipy.integrate import solve_ivp
from scipy.spatial.transform import Rotation

MOMENTS, SPIN = np.array([1.0, 2.0, 2.6]), np.array([0.3, 2.0, 0.1])
TURNED = Rotation.from_rotvec([0.4, -1.1, 0.7])


def derivative(t, state, torque):
    """Euler's equations and the attitude's, with SciPy's conventions."""
    q, w = state[:4], state[4:]
    turn = Rotation.from_quat(q)
    spin = (torque(t, turn, w) - np.cross(w, MOMENTS * w)) / MOMENTS
    x, y, z, s = q
    rate = [[s, -z, y], [z, s, -x], [-y, x, s], [-x, -y, -z]] @ (0.5 * w)
    return np.concatenate([rate, spin])


def by_scipy(times, torque=lambda t, turn, w: np.zeros(3)):
    start = np.concatenate([TURNED.as_quat(), SPIN])
    found = solve_ivp(derivative, [0, times[-1]], start, "DOP853", times, args=[torque], rtol=1e-11, atol=1e-12)
    return Rotation.from_quat(found.y[:4].T), found.y[4:].T


def apart(one, other):
    return (one.inv() * other).magnitude().max()


def test_the_free_motion_is_that_of_scipys_integrator():
    times = np.linspace(0, 20, 9)
    attitude, spin = tumbling.FreeMotion(MOMENTS, SPIN, TURNED).at(times)
    turned, expected = by_scipy(times)
    assert apart(Rotation.from_quat(attitude), turned) < 1e-8
    assert abs(spin - expected).max() < 1e-8


def test_a_free_body_keeps_its_momentum_in_the_world():
    attitude, spin = tumbling.FreeMotion(MOMENTS, SPIN, TURNED).at([[0.0, 3.0], [1e3, -7.0]])
    assert attitude.shape == (2, 2, 4) and spin.shape == (2, 2, 3)
    momentum = Rotation.from_quat(attitude.reshape(-1, 4)).apply(MOMENTS * spin.reshape(-1, 3))
    assert abs(momentum - TURNED.apply(MOMENTS * SPIN)).max() < 1e-13


def test_the_scalar_stands_where_it_is_said_to():
    last, _ = tumbling.FreeMotion(MOMENTS, SPIN, TURNED.as_quat()).at(4.0)
    first, _ = tumbling.FreeMotion(MOMENTS, SPIN, TURNED.as_quat(scalar_first=True), scalar_first=True).at(4.0)
    assert np.array_equal(first, np.roll(last, 1))
    assert apart(Rotation.from_quat(first, scalar_first=True), Rotation.from_quat(last)) == 0


def test_a_tensor_in_other_axes_turns_the_same_body():
    frame = Rotation.from_rotvec([0.2, 0.5, -0.3])
    tensor = frame.as_matrix() @ np.diag(MOMENTS) @ frame.as_matrix().T
    attitude, spin = tumbling.FreeMotion(tensor, frame.apply(SPIN), TURNED * frame.inv()).at(9.0)
    plain, expected = tumbling.FreeMotion(MOMENTS, SPIN, TURNED).at(9.0)
    assert abs(frame.inv().apply(spin) - expected).max() < 1e-13
    assert apart(Rotation.from_quat(attitude) * frame, Rotation.from_quat(plain)) < 1e-13
    found = tumbling.Inertia(tensor)
    assert abs(found.axes @ np.diag(found.moments) @ found.axes.T - tensor).max() < 1e-15 * 8
    assert np.linalg.det(found.axes) > 0


def test_bodies_under_torques_move_as_scipys_integrator_says():
    times = np.linspace(0, 5, 6)
    arm, weight = np.array([0.02, 0.0, 0.1]), 9.81
    torques = [tumbling.Torque.aligning(arm, [0, 0, -weight]), tumbling.Torque.in_body([0, 0.3, 0]).during(1.0, 2.5)]

    def torque(t, turn, w):
        return np.cross(arm, turn.inv().apply([0, 0, -weight])) + np.array([0, 0.3, 0]) * (1.0 <= t < 2.5)

    turned, expected = by_scipy_in_pieces(times, torque)
    stepped = tumbling.Stepper(MOMENTS, SPIN, TURNED, torques=torques).run(times)
    attitude, spin = tumbling.Batch(MOMENTS, [SPIN, -SPIN], TURNED, torques=torques).at(times)
    for q, w in [stepped, (attitude[:, 0], spin[:, 0])]:
        assert apart(Rotation.from_quat(q), turned) < 1e-7
        assert abs(w - expected).max() < 1e-7


def by_scipy_in_pieces(times, torque):
    """With a step that ends where the torque leaps."""
    state, states = np.concatenate([TURNED.as_quat(), SPIN]), []
    for start, end in zip([0.0, 0.0, 1.0, 2.0, 2.5, 3.0, 4.0], [0.0, 1.0, 2.0, 2.5, 3.0, 4.0, 5.0]):
        inner = lambda t, turn, w, most=np.nextafter(end, 0): torque(min(max(t, start), most), turn, w)
        if end > start:
            state = solve_ivp(derivative, [start, end], state, "DOP853", args=[inner], rtol=1e-11, atol=1e-12).y[:, -1]
        if end in times:
            states.append(state)
    states = np.array(states)
    return Rotation.from_quat(states[:, :4]), states[:, 4:]


def test_flips_under_a_drag_like_the_tensor_are_those_of_a_slower_clock():
    drag, c, spins = tumbling.Torque.damping(0.02 * MOMENTS), 0.02, [[0.5, 2.0, 0.3], [0.3, 1.5, 0.2], [0, 0, 1]]
    end = (1 - np.exp(-c * 60.0)) / c
    alone = tumbling.Stepper(MOMENTS, spins[0], torques=[drag]).flips(60.0)
    batch = tumbling.Batch(MOMENTS, spins, torques=[drag]).flips(60.0)
    free = [tumbling.FreeMotion(MOMENTS, spin).flips(0, end) for spin in spins]
    for found, expected in zip([alone, *batch], [free[0], *free]):
        assert len(found) == len(expected)
        assert abs((1 - np.exp(-c * np.array(found))) / c - expected).max(initial=0) < 1e-8
    assert len(alone) > 3 and len(batch[2]) == 0


def test_the_state_transition_and_the_derivatives_by_the_tensor_are_difference_quotients():
    motion = tumbling.FreeMotion(MOMENTS, SPIN)
    by_start, by_tensor = motion.sensitivities(5.0)
    assert np.array_equal(by_start, motion.state_transition(5.0))
    by = 1e-6  # what is neglected is some 1e4 by²

    def change(of):
        (p, v), (q, w) = (tumbling.FreeMotion(*of(sign * by)).at(5.0) for sign in (-1, 1))
        turn = (Rotation.from_quat(p).inv() * Rotation.from_quat(q)).as_rotvec()
        return np.concatenate([turn, w - v]) / (2 * by)

    def altered(i, j, by):
        tensor = np.diag(MOMENTS)
        tensor[[i, j], [j, i]] += by
        return tensor

    for i in range(3):
        assert abs(change(lambda x: (MOMENTS, SPIN + x * np.eye(3)[i])) - by_start[:, 3 + i]).max() < 1e-7
    for column, (i, j) in enumerate([(0, 0), (1, 1), (2, 2), (0, 1), (0, 2), (1, 2)]):
        assert abs(change(lambda x: (altered(i, j, x), SPIN)) - by_tensor[:, column]).max() < 1e-7


def test_a_top_asleep_precesses_as_the_batch_under_gravity_does():
    moments, arm, weight = [2e-4, 2e-4, 5e-5], [0, 0, 0.04], 0.981
    spin, leaning = [0.1, 0, 150], Rotation.from_rotvec([0.4, 0, 0])
    top = tumbling.LagrangeTop(moments, spin, arm, weight, leaning)
    stepped = tumbling.Stepper(moments, spin, leaning, torques=[tumbling.Torque.gravity(arm, weight)]).run([0.1, 0.7])
    attitude, omega = top.at([0.1, 0.7])
    assert apart(Rotation.from_quat(attitude), Rotation.from_quat(stepped[0])) < 1e-8
    assert abs(omega - stepped[1]).max() < 1e-6
    lean = np.arccos(Rotation.from_quat(attitude).as_matrix()[:, 2, 2])
    assert (lean > top.lean[0] - 1e-12).all() and (lean < top.lean[1] + 1e-12).all()


def test_whole_numbers_are_numbers():
    top = tumbling.LagrangeTop([2, 2, 1], [0, 0, 9], [0, 0, 1], 1)
    assert top.at(1)[1][2] == pytest.approx(9, abs=1e-14)
    assert len(tumbling.Batch(np.array([[3, 0.5, 0], [0.5, 2, 0.1], [0, 0.1, 4]])[None], [0, 9, 1])) == 1


def test_a_mesh_of_a_box_has_the_tensor_of_the_box():
    corners = [[x, y, z] for x in (-1.0, 1.0) for y in (-0.5, 0.5) for z in (-1.5, 1.5)]
    square = lambda a, b, c, d: [[a, b, c], [a, c, d]]
    faces = square(0, 1, 3, 2) + square(4, 6, 7, 5) + square(0, 4, 5, 1) + square(2, 3, 7, 6) + square(0, 2, 6, 4) + square(1, 5, 7, 3)
    mesh, box = tumbling.Inertia.mesh(corners, np.array(faces), density=2), tumbling.Inertia.cuboid(2, 1, 3, density=2)
    assert mesh.mass == box.mass == 12
    assert abs(mesh.tensor - box.tensor).max() < 1e-14
    tip = [0.1, -0.2, 1.5]
    assert abs(box.about(tip).tensor - box.tensor - 12 * (np.dot(tip, tip) * np.eye(3) - np.outer(tip, tip))).max() < 1e-13


def test_what_is_refused_says_what_and_why():
    for call, kind, subject, words in [
        (lambda: tumbling.Inertia([1, 2, 3.5]), "Impossible", "", "3.5"),
        (lambda: tumbling.FreeMotion([1, 2, 3], [0, np.nan, 1]), "NotFinite", "the spin", "NaN"),
        (lambda: tumbling.FreeMotion([1, 2, 3], [0, 1, 1], [0, 0, 0, 1.1]), "OutOfBounds", "", "1.1"),
        (lambda: tumbling.FreeMotion([1, 2, 3], [0, 1]), "Shape", "spin", "(3,)"),
        (lambda: tumbling.FreeMotion([1, 2, 3], [0, 9, 1e-3]).flips(0, 1e14), "TooMany", "the times of flips", "memory"),
        (lambda: tumbling.Batch([1, 2, 3], [0, 9, 1]).flips(1e15), "Unattainable", "the accuracy", "body 0: "),
        (lambda: tumbling.Batch([[1, 2, 3], [1, 2, 3.5]], [0, 9, 1]), "Impossible", "", "body 1: "),
        (lambda: tumbling.Batch([1, 2, 3], [[0, 9, 1], [0, np.inf, 1]]).at([1.0]), "NotFinite", "the spin", "body 1: "),
        (lambda: tumbling.Batch([1, 2, 3], [0, 9, 1]).at([2.0, 1.0]), "OutOfBounds", "a time", "not be larger"),
        (lambda: tumbling.Stepper([1, 2, 3], [0, 9, 1], tolerance=0), "OutOfBounds", "the tolerance", "tolerance"),
        (lambda: tumbling.Batch([1, 2, 3], [[0, 9, 1], [0, np.nan, 1]]), "NotFinite", "the spin", "body 1: "),
        (lambda: tumbling.Batch([1, 2, 3], [0, 9, 1], accuracy=np.nan), "NotFinite", "the accuracy", "accuracy"),
        (lambda: tumbling.Torque.in_body([0, np.nan, 0]), "NotFinite", "", "NaN"),
        (lambda: tumbling.Torque.gravity([0, 0, 1], np.nan), "NotFinite", "", "NaN"),
        (lambda: tumbling.LagrangeTop([2, 2, 1], [0, 0, 9], [0, 0, 1], np.nan), "NotFinite", "", "NaN"),
        (lambda: tumbling.Inertia([np.nan, 1, 1]), "NotFinite", "", "NaN"),
        (lambda: tumbling.Inertia.cone(np.nan, 1, mass=1), "NotFinite", "", "NaN"),
        (lambda: tumbling.Batch([[3, 0.5, 0], [0.5, 2, 0.1], [0, 0.1, 4]], [0, 9, 1]), "Shape", "inertia", "T[None]"),
        (lambda: tumbling.Inertia.ball(1), "Undefined", "the mass", "either"),
        (lambda: tumbling.Batch(np.array([1, 2, 2.5 + 1j]), [0, 9, 1]), "Type", "numbers", "complex128"),
        (lambda: tumbling.Batch([1, 2, 2.5], np.ma.masked_less([0, 9.0, 1], 1)), "Type", "numbers", "masked"),
        (lambda: tumbling.FreeMotion([1, 2, 2.5], [0, 9, 1]).at(np.arange(3).astype("m8[s]")), "Type", "numbers", "timedelta64"),
    ]:
        with pytest.raises(tumbling.Error) as caught:
            call()
        error = caught.value
        assert error.kind == kind and subject in error.subject and words in str(error), (error.kind, error.subject, error)


def test_other_threads_run_while_many_bodies_are_answered():
    spins = np.random.default_rng(1).normal(size=(5_000, 3))
    batch, ticks = tumbling.Batch(MOMENTS, spins), []
    done = threading.Event()

    def tick():
        while not done.is_set():
            ticks.append(time.monotonic())
            time.sleep(1e-4)

    other = threading.Thread(target=tick)
    other.start()
    began = time.monotonic()
    batch.at(np.linspace(0, 10, 40))
    ended = time.monotonic()
    done.set()
    other.join()
    assert sum(began < tick < ended for tick in ticks) > 3


def test_every_bit_is_that_of_the_library_called_from_rust():
    """`examples/answers.rs` has the same calls in Rust and writes the bits of all numbers."""
    answers = json.loads(open(os.environ["TUMBLING_ANSWERS"]).read())
    times = np.array(answers["times"])
    tensor = [[3.0, 0.5, 0.0], [0.5, 2.0, 0.1], [0.0, 0.1, 4.0]]
    q, spin = [0.8, 0.2, -0.4, 0.4], [0.1, 2.0, 0.3]
    start = dict(spin=spin, attitude=q, scalar_first=True)
    drag = tumbling.Torque.gravity([0.1, 0.2, 0.3], 4.0)
    motion, stepper = tumbling.FreeMotion(tensor, **start), tumbling.Stepper(tensor, **start, torques=[drag])
    batch = tumbling.Batch(MOMENTS, np.outer(np.arange(1, 41), [0.3, 2.0, 0.1]) / 40)
    top = tumbling.LagrangeTop([2e-4, 2e-4, 5e-5], [0.1, 0, 150], [0, 0, 0.04], 0.981, q, scalar_first=True)
    found = {
        "free": [*motion.at(times), *motion.sensitivities(times[1:3]), motion.flips(0, 50)],
        "stepped": [*stepper.run(times[:3]), stepper.flips(40.0), stepper.step_with_transition(1.0)],
        "batch": [np.roll(batch.at(times)[0], 1, axis=-1), batch.at(times)[1]],
        "top": [*top.at(times), top.lean],
        "mesh": [tumbling.Inertia.mesh([[0, 0, 0], [4, 0, 0], [0.3, 4, 0], [0, 0.1, 6]], [[0, 2, 1], [0, 3, 2], [0, 1, 3], [1, 2, 3]], mass=1.7).tensor],
    }
    for name, arrays in found.items():
        bits = np.concatenate([np.ravel(array) for array in arrays]).view(np.uint64)
        expected = np.array([int(number, 16) for number in answers[name]], dtype=np.uint64)
        assert np.array_equal(bits, expected), name
