"""Where the body of each story truly is at its last instant, to 30 digits.

With torque: Taylor series at 78 digits (taylor.py): order 50, twice, with the step and with two thirds of it. What the two differ by
bounds the error of both; it stands in the table. Free: the closed form at 220 digits by the library's oracle, tests/data/oracle.py.

    PYTHONPATH=tests/data python3 crates/measure/data/truth.py > crates/measure/data/truth.json

Needs Python 3 and mpmath. The inputs are the very doubles that the program uses: the moments, and the momentum at the start.
"""

import json
from fractions import Fraction

from mpmath import mp, mpf

import oracle
import taylor
from taylor import momentum_of

mp.dps = 60

FREE = {
    # The document's box at its document's push: 100 flips, and half the time to the next.
    "box": dict(moments=[10.0 / 12.0, 13.0 / 12.0, 5.0 / 12.0], omega=[1.0, 0.01, 0.01], t=2555.0),
    "wobble": dict(moments=[1.0, 2.0, 3.0], omega=[0.5, 0.5, 10.0], t=64.0),
    "racket": dict(moments=[0.00121, 0.01638, 0.01748], omega=[0.125, 10.0, 0.125], t=64.0),
    "needle": dict(moments=[0.001, 1.0, 1.0005], omega=[8.0, 1.0, 0.5], t=80.0),
    "near sphere": dict(moments=[1.0, 1.01, 1.02], omega=[0.5, 10.0, 0.5], t=640.0),
}
# What acts is named as in taylor.py.
TORQUE = {
    "heavy top": dict(
        moments=[1.0, 1.5, 0.75], omega=[0.25, 0.5, 8.0], t=16.0, arm=[0.125, 0.0, 0.5], weight=4.0),
    # Upright, and fast enough to stay so: (0.5 x 12)^2 > 4 x 1.25 x 2.
    "sleeping top": dict(
        moments=[1.0, 1.25, 0.5], omega=[0.125, 0.0625, 12.0], t=16.0, arm=[0.0, 0.0, 0.5], weight=4.0),
    "damped spin": dict(
        moments=[1.0, 2.0, 2.5], omega=[0.25, 5.0, 0.125], t=32.0, damping=[0.03125, 0.0625, 0.046875]),
    # Three rounds of the Earth 420 km up: 3 mu / r^3 is three times the square of the orbit's rate.
    "gravity gradient": dict(
        moments=[8.0, 12.0, 15.0], omega=[0.001, 0.002, 0.0005], t=16384.0, gradient=3.0 * 0.001127 * 0.001127, orbit=0.001127),
    "thruster pulses": dict(
        moments=[1.0, 1.5, 2.0], omega=[0.25, 2.0, 0.5], t=16.0,
        phases=[[1.0, [0.0, 0.0, 0.0]], [0.5, [0.5, 0.0, 0.0]], [2.5, [0.0, 0.0, 0.0]], [0.25, [0.0, -2.0, 0.0]],
                [3.25, [0.0, 0.0, 0.0]], [1.0, [0.0, 0.0, 0.25]], [3.5, [0.0, 0.0, 0.0]], [0.125, [-4.0, 0.0, 1.0]],
                [3.875, [0.0, 0.0, 0.0]]]),
    # The wobble turns at 4 sqrt(1 x 0.75 / 1.25) = 3.098 rad/s in the body.
    "resonant push": dict(
        moments=[1.0, 1.25, 2.0], omega=[0.0625, 0.03125, 4.0], t=32.0, push=[0.125, 0.0, 0.0], rate=3.09375),
    # One axis loses 512 e-folds a second, the others a thirtieth.
    "stiff damping": dict(
        moments=[1.0, 2.0, 2.5], omega=[2.0, 1.0, 3.0], t=8.0, damping=[0.03125, 1024.0, 0.0625]),
}


def digits(v):
    return [mp.nstr(x, 30) for x in v]


def free(name, story):
    omega = [Fraction(l) / Fraction(i) for l, i in zip(momentum_of(story), story["moments"])]
    with mp.workdps(220):
        closed = oracle.Closed([Fraction(i) for i in story["moments"]], omega)
        w, q = closed.at(Fraction(story["t"]))
        return dict(story, name=name, attitude=digits(q),
                    momentum=digits([mpf(i) * x for i, x in zip(story["moments"], w)]),
                    energy=mp.nstr(closed.E2 / 2, 30), period=mp.nstr(closed.period, 30))


def energy(story, q, l):
    """Kinetic, and that of the height."""
    s, x, y, z = q
    up = [2 * (x * z - s * y), 2 * (y * z + s * x), 1 - 2 * (x * x + y * y)]
    kinetic = sum(a * a / mpf(i) for a, i in zip(l, story["moments"])) / 2
    if "weight" not in story:
        return kinetic
    return kinetic + mpf(story["weight"]) * sum(mpf(a) * u for a, u in zip(story["arm"], up))


def with_torque(name, story):
    q, l, apart = taylor.end(story)
    assert apart < mpf(10) ** -35, (name, apart)
    entry = dict(story, name=name, attitude=digits(q), momentum=digits(l), apart=mp.nstr(apart, 3),
                 unit=mp.nstr(abs(sum(x * x for x in q) - 1), 3), energy=mp.nstr(energy(story, q, l), 30))
    if "weight" in story:
        moved = abs(energy(story, q, l) - energy(story, [1, 0, 0, 0], [mpf(x) for x in momentum_of(story)]))
        assert moved < mpf(10) ** -35, moved
        entry["energy_moved"] = mp.nstr(moved, 3)
    return entry


def main():
    out = [free(name, story) for name, story in FREE.items()]
    out += [with_torque(name, story) for name, story in TORQUE.items()]
    schema = ("SI units. attitude: quaternion body to world, scalar first, the identity at time 0, of either sign; momentum: body "
              "axes. What acts is named as in taylor.py. apart: what two step sizes differ by; unit: what the quaternion's square "
              "lacks of 1.")
    print(json.dumps({"schema": schema, "stories": out}, indent=1))


main()
