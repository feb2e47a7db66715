"""A body's inertia from a gyroscope's record."""

import numpy as np
import pytest
import tumbling
from scipy.spatial.transform import Rotation

MOMENTS, TIMES = np.array([1.0, 2.0, 2.6]), np.arange(2000) / 100
TURNED = Rotation.from_rotvec(np.radians(30) * np.array([2.0, -1.0, 2.0]) / 3)

STEADY = "the spin is steady|does not determine the moments"


def record(moments, spin, noise=0.0, seed=1):
    """What a sensor turned by 30 degrees in the body would say."""
    spins = TURNED.apply(tumbling.FreeMotion(moments, spin).at(TIMES)[1])
    return spins + noise * np.random.default_rng(seed).standard_normal(spins.shape)


def across(axes):
    """How far the axes are from the true ones, whichever way each points."""
    return abs(abs(np.sum(axes * TURNED.as_matrix(), axis=0)) - 1).max()


@pytest.mark.parametrize("spin", [[0.3, 2.0, 0.1], [1.5, 0.2, 0.3], [0.2, 0.4, 5.0]])
def test_a_clean_record_gives_moments_and_axes(spin):
    fitted = tumbling.fit_inertia(TIMES, record(MOMENTS, spin))
    assert abs(fitted.moments / (MOMENTS / MOMENTS.sum()) - 1).max() < 1e-6
    assert across(fitted.axes) < 1e-9 and np.linalg.det(fitted.axes) > 0
    assert fitted.residual < 1e-9


@pytest.mark.parametrize("seed", range(5))
def test_noise_moves_moments_by_a_few_standard_errors(seed):
    fitted = tumbling.fit_inertia(0.01, record(MOMENTS, [0.3, 2.0, 0.1], 1e-3, seed))
    assert (abs(fitted.moments - MOMENTS / MOMENTS.sum()) < 4 * fitted.stderr).all()
    assert fitted.stderr.max() < 1e-3 and across(fitted.axes) < 1e-5
    assert fitted.residual == pytest.approx(1e-3, rel=0.05)


def test_a_guess_serves_rows_far_apart():
    times, guess = TIMES[::150], TURNED.as_matrix() @ np.diag([1.0, 2.1, 2.5]) @ TURNED.as_matrix().T
    fitted = tumbling.fit_inertia(times, record(MOMENTS, [0.3, 2.0, 0.1])[::150], guess)
    assert abs(fitted.moments - MOMENTS / MOMENTS.sum()).max() < 1e-6


@pytest.mark.parametrize("noise", [0.0, 1e-3])
@pytest.mark.parametrize(
    "moments,spin,said",
    [
        (MOMENTS, [0, 0, 3.0], STEADY),
    ],
)
def test_motions_that_do_not_determine_the_body_are_refused(moments, spin, said, noise):
    with pytest.raises(tumbling.Error, match=said):
        tumbling.fit_inertia(TIMES, record(moments, spin, noise))


@pytest.mark.parametrize("noise", [0.0, 1e-3])
@pytest.mark.parametrize("moments,free", [([2.0, 2.0, 3.0], "0 and 1"), ([1.0, 2.5, 2.5], "1 and 2")])
def test_of_a_symmetric_body_the_moments_are_found_and_the_free_axes_named(moments, free, noise):
    fitted = tumbling.fit_inertia(TIMES, record(moments, [0.5, 0.7, 1.2], noise))
    assert abs(fitted.moments - np.array(moments) / sum(moments)).max() < 1e-3
    assert f"axes {free} free in their plane" in repr(fitted)


def test_records_that_are_none_are_refused():
    spins = record(MOMENTS, [0.3, 2.0, 0.1])
    broken = np.where(np.arange(2000)[:, None] == 6, np.nan, spins)
    wrong = [(TIMES, broken, "row 7: a value is NaN"), (TIMES[::-1], spins, "row 2: time does not increase")]
    wrong += [(TIMES[:3], spins[:3], "four rows"), (TIMES, spins[:9], "the shape")]
    wrong += [(TIMES, np.zeros((2000, 3)), STEADY)]
    for size in [1e-3, 1.0]:  # of noise alone
        wrong += [(TIMES, size * np.random.default_rng(2).standard_normal((2000, 3)), "no free motion comes near")]
    for times, w, said in wrong:
        with pytest.raises(tumbling.Error, match=said):
            tumbling.fit_inertia(times, w)
