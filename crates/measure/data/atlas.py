"""Hard cases under torques, and where each body truly is at the end, to 20 digits.

By Taylor series at 78 digits (taylor.py), order 30, with two step sizes. Damping of one axis faster than 3000 e-folds a second goes by the
implicit method Radau of SciPy instead, to eleven digits, which is held against the series at 1000.

    python3 crates/measure/data/atlas.py > crates/measure/data/atlas.json

Needs Python 3, mpmath and SciPy.
"""

import json
from math import sqrt

from mpmath import mp, mpf

import taylor

mp.dps = 40
PLAIN, SPIN = [1.0, 2.0, 2.6], [0.4, 1.5, -0.3]
STEP = 0.05


def case(chart, name, moments=PLAIN, omega=SPIN, step=STEP, t=2.0, **acts):
    return dict(chart=chart, name=name, moments=moments, omega=omega, step=step, t=t, **acts)


def momentum(moments, omega):
    return [i * w for i, w in zip(moments, omega)]


def drag():
    for power in range(-6, 7):
        rate = 10.0 ** power
        yield case("drag", f"1e{power}", damping=[rate, rate, 2.0 * rate])


def one_axis():
    for power in range(-6, 7):
        yield case("one axis", f"1e{power}", damping=[0.02, 2.0 * 10.0 ** power, 0.05])


def weights():
    energy = sum(i * w * w for i, w in zip(PLAIN, SPIN)) / 2
    for power in range(-12, 13, 2):
        weight = energy * 10.0 ** power
        # The faster of the spin and of the swing.
        faster = max(1.0, sqrt(10.0 ** power))
        yield case("weight", f"1e{power}", arm=[0.6, 0.0, 0.8], weight=weight, step=STEP / faster, t=5.0 / faster)


def shapes():
    weight = dict(arm=[0.5, 0.0, 0.0], weight=0.5, t=10.0)
    for power in range(2, 13, 2):
        thin = 10.0 ** -power
        yield case("shapes", f"1e{power} to 1, needle", [thin, 1.0, 1.0 + 0.4 * thin], [0.8, 0.5, 0.33], **weight)
    for power in (2, 6, 12):
        thin = 10.0 ** -power
        yield case("shapes", f"1e{power} to 1, strip", [thin, 1.0, 1.0 + thin], [0.8, 0.5, 0.33], **weight)
    yield case("shapes", "flat plate", [1.0, 1.5, 2.5], [0.8, 1.5, 0.33], **weight)
    yield case("shapes", "coin", [1.0, 1.0, 2.0], [0.8, 1.5, 0.33], **weight)


def stops():
    # Opposite to the momentum, which keeps its direction in the world: at rest after two seconds, then back.
    against = [-0.5 * x for x in momentum(PLAIN, SPIN)]
    yield case("stop", "tumbling, at rest", world=against)
    yield case("stop", "tumbling, through rest", world=against, t=4.0)
    one = [0.0, 1.5, 0.0]
    yield case("stop", "about one axis, at rest", omega=one, phases=[[2.0, [0.0, -1.5, 0.0]]])
    yield case("stop", "about one axis, through rest", omega=one, phases=[[4.0, [0.0, -1.5, 0.0]]], t=4.0)
    still = [0.0, 0.0, 0.0]
    yield case("stop", "from rest, torque along an axis", omega=still, phases=[[2.0, [0.0, 0.0, 1.5]]])
    yield case("stop", "from rest, torque across the axes", omega=still, phases=[[4.0, [0.3, 1.0, -0.6]]], t=4.0)
    yield case("stop", "from rest, under a weight", omega=still, arm=[0.6, 0.0, 0.8], weight=1.0, t=8.0)


def resonance():
    # The wobble in the body: 4 sqrt(1 x 0.75 / 1.25) rad/s.
    wobble = 4.0 * sqrt(0.6)
    for share in (0.1, 0.5, 0.9, 0.99, 1.0, 1.01, 1.1, 2.0, 10.0):
        yield case("resonance", f"{share:g}", [1.0, 1.25, 2.0], [0.0625, 0.03125, 4.0], 0.0125, 20.0, push=[0.125, 0.0, 0.0],
                   rate=share * wobble)


def blows():
    for power in (0, 1, 2, 3, 4, 6, 8, 10, 12):
        width, torque = 10.0 ** -power, 10.0 ** power
        yield case("blow", f"1e-{power}" if power else "1", phases=[
            [0.5, [0.0] * 3], [width, [0.8 * torque, -1.5 * torque, 0.6 * torque]], [1.5, [0.0] * 3]], t=2.0 + width)


def radau(body):
    """For damping alone, at rates far beyond the spin's."""
    import numpy as np
    from scipy.integrate import solve_ivp

    moments, damping = np.array(body["moments"]), np.array(body["damping"])

    def rate(_, y):
        q, l = y[:4], y[4:]
        w = l / moments
        turn = [-q[1:] @ w, *(q[0] * w + np.cross(q[1:], w))]
        return np.concatenate([np.array(turn) / 2, np.cross(l, w) - damping * w])

    start = np.concatenate([[1.0, 0.0, 0.0, 0.0], taylor.momentum_of(body)])
    run = solve_ivp(rate, (0.0, body["t"]), start, method="Radau", rtol=1e-11, atol=1e-13)
    assert run.success
    return [mpf(float(x)) for x in run.y[:4, -1]], [mpf(float(x)) for x in run.y[4:, -1]]


def ended(body):
    if body["chart"] == "one axis" and body["damping"][1] > 6000.0:
        return *radau(body), mpf(10) ** -11
    q, l, apart = taylor.end(body, digits=28, order=30)
    if body["chart"] == "one axis" and body["name"] == "1e3":
        assert max(abs(a - b) for a, b in zip(q + l, sum(radau(body), []))) < mpf(10) ** -9
    return q, l, apart


def main():
    out = []
    for cases in (drag, one_axis, weights, shapes, stops, resonance, blows):
        for body in cases():
            q, l, apart = ended(body)
            assert apart < mpf(10) ** -10, (body["chart"], body["name"], apart)
            out.append(dict(body, attitude=[mp.nstr(x, 20) for x in q], momentum=[mp.nstr(x, 20) for x in l], apart=mp.nstr(apart, 3)))
    schema = ("SI units. attitude: quaternion body to world, scalar first, the identity at time 0, of either sign; momentum: body axes; "
              "both after t. step: that of the methods with a fixed step. What acts is named as in taylor.py. apart: what two step sizes "
              "differ by, or SciPy's tolerance.")
    lines = ",\n".join(json.dumps(entry) for entry in out)
    print(f'{{"schema": {json.dumps(schema)}, "cases": [\n{lines}\n]}}')


main()
