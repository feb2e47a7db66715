"""Where the body of each story truly is at its last instant, to 30 digits.

With torque: Taylor series of q' = q w / 2, L' = L x w + torque, with w = L / I in body axes, at 60 digits: order 50, twice, with
the step and with two thirds of it. What the two differ by bounds the error of both; it stands in the table.
Free: the closed form at 220 digits by the library's oracle, tests/data/oracle.py.

    PYTHONPATH=tests/data python3 crates/measure/data/truth.py > crates/measure/data/truth.json

Needs Python 3 and mpmath. The inputs are the very doubles that the program uses: the moments, and the momentum at the start.
"""

import json
import sys
from fractions import Fraction

from mpmath import mp, mpf

import oracle

mp.dps = 60
ORDER = 50

FREE = {
    # The document's box at its document's push: 100 flips, and half the time to the next.
    "box": dict(moments=[10.0 / 12.0, 13.0 / 12.0, 5.0 / 12.0], omega=[1.0, 0.01, 0.01], t=2555.0),
    "wobble": dict(moments=[1.0, 2.0, 3.0], omega=[0.5, 0.5, 10.0], t=64.0),
    "racket": dict(moments=[0.00121, 0.01638, 0.01748], omega=[0.125, 10.0, 0.125], t=64.0),
    "needle": dict(moments=[0.001, 1.0, 1.0005], omega=[8.0, 1.0, 0.5], t=80.0),
    "near sphere": dict(moments=[1.0, 1.01, 1.02], omega=[0.5, 10.0, 0.5], t=640.0),
}
TORQUE = {
    "heavy top": dict(
        moments=[1.0, 1.5, 0.75], omega=[0.25, 0.5, 8.0], t=16.0, step=0.05,
        arm=[0.125, 0.0, 0.5], weight=4.0, damping=[0.0, 0.0, 0.0]),
    "damped spin": dict(
        moments=[1.0, 2.0, 2.5], omega=[0.25, 5.0, 0.125], t=32.0, step=0.05,
        arm=[0.0, 0.0, 0.0], weight=0.0, damping=[0.03125, 0.0625, 0.046875]),
}


def digits(v):
    return [mp.nstr(x, 30) for x in v]


def momentum_of(story):
    """The product as a double rounds it: what the program starts from."""
    return [i * w for i, w in zip(story["moments"], story["omega"])]


def free(name, story):
    omega = [Fraction(l) / Fraction(i) for l, i in zip(momentum_of(story), story["moments"])]
    with mp.workdps(220):
        closed = oracle.Closed([Fraction(i) for i in story["moments"]], omega)
        w, q = closed.at(Fraction(story["t"]))
        return dict(story, name=name, attitude=digits(q),
                    momentum=digits([mpf(i) * x for i, x in zip(story["moments"], w)]),
                    energy=mp.nstr(closed.E2 / 2, 30), period=mp.nstr(closed.period, 30))


def series(story, q0, l0):
    """Coefficients of q and L about a state."""
    inverse = [1 / mpf(i) for i in story["moments"]]
    arm, damping = [mpf(x) for x in story["arm"]], [mpf(x) for x in story["damping"]]
    weight = mpf(story["weight"])
    q, l, w, up = [[x] for x in q0], [[x] for x in l0], [[], [], []], [[], [], []]
    for n in range(ORDER):
        def p(a, b):
            return mp.fsum(a[k] * b[n - k] for k in range(n + 1))

        for i in range(3):
            w[i].append(inverse[i] * l[i][n])
        s, x, y, z = q
        # The world's z in body axes, the last row of the rotation matrix.
        if weight != 0:
            up[0].append(2 * (p(x, z) - p(s, y)))
            up[1].append(2 * (p(y, z) + p(s, x)))
            up[2].append((1 if n == 0 else 0) - 2 * (p(x, x) + p(y, y)))
        else:
            for u in up:
                u.append(mpf(0))
        dq = [
            -(p(x, w[0]) + p(y, w[1]) + p(z, w[2])) / 2,
            (p(s, w[0]) + p(y, w[2]) - p(z, w[1])) / 2,
            (p(s, w[1]) + p(z, w[0]) - p(x, w[2])) / 2,
            (p(s, w[2]) + p(x, w[1]) - p(y, w[0])) / 2,
        ]
        dl = []
        for i in range(3):
            j, k = (i + 1) % 3, (i + 2) % 3
            pull = -weight * (arm[j] * up[k][n] - arm[k] * up[j][n])
            dl.append(p(l[j], w[k]) - p(l[k], w[j]) + pull - damping[i] * w[i][n])
        for a, d in zip(q + l, dq + dl):
            a.append(d / (n + 1))
    return q, l


def energy(story, q, l):
    s, x, y, z = q
    up = [2 * (x * z - s * y), 2 * (y * z + s * x), 1 - 2 * (x * x + y * y)]
    kinetic = sum(a * a / mpf(i) for a, i in zip(l, story["moments"])) / 2
    return kinetic + mpf(story["weight"]) * sum(mpf(a) * u for a, u in zip(story["arm"], up))


def end(story, step):
    q, l = [mpf(1), mpf(0), mpf(0), mpf(0)], [mpf(x) for x in momentum_of(story)]
    count = int(mp.ceil(mpf(story["t"]) / step))
    h = mpf(story["t"]) / count
    for _ in range(count):
        a, b = series(story, q, l)
        q, l = [mp.polyval(c[::-1], h) for c in a], [mp.polyval(c[::-1], h) for c in b]
    return q, l


def with_torque(name, story):
    q, l = end(story, mpf(story["step"]))
    q2, l2 = end(story, mpf(story["step"]) * 2 / 3)
    apart = max(abs(a - b) for a, b in zip(q + l, q2 + l2))
    assert apart < mpf(10) ** -35, apart
    entry = {k: story[k] for k in ("moments", "omega", "arm", "weight", "damping", "t")}
    entry.update(name=name, attitude=digits(q2), momentum=digits(l2), apart=mp.nstr(apart, 3),
                 unit=mp.nstr(abs(sum(x * x for x in q2) - 1), 3), energy=mp.nstr(energy(story, q2, l2), 30))
    if not any(story["damping"]):
        moved = abs(energy(story, q2, l2) - energy(story, [1, 0, 0, 0], [mpf(x) for x in momentum_of(story)]))
        assert moved < mpf(10) ** -35, moved
        entry["energy_moved"] = mp.nstr(moved, 3)
    return entry


def main():
    out = [free(name, story) for name, story in FREE.items()]
    out += [with_torque(name, story) for name, story in TORQUE.items()]
    schema = ("SI units. attitude: quaternion body to world, scalar first, the identity at time 0, of either sign; momentum: body "
              "axes. Gravity pulls along the world's -z at `arm` (body axes) with `weight`; damping is -c w. apart: what two step "
              "sizes differ by; unit: what the quaternion's square lacks of 1.")
    print(json.dumps({"schema": schema, "stories": out}, indent=1))


main()
