"""The motion of a rigid body under torques by Taylor series, in integers.

q' = q w / 2, L' = L x w + torque, with w = L / I along the principal axes. A number x is the integer x 2^BITS, so that a product costs one
multiplication and one shift; 260 bits are 78 digits. The step follows from the last coefficients.

A body is a dictionary: moments (kg m2), omega (rad/s), and what acts on it, all of it optional:
  arm, weight     gravity along the world's -z on a centre of mass at `arm` (body axes, m), N
  damping         -c w along each axis, N m s
  world           a constant torque in the world's axes, N m
  gradient        k n x I n, k in 1/s2, n = (cos(orbit t), sin(orbit t), 0) in the world's axes; orbit in rad/s
  push, rate      push cos(rate t) in body axes, N m
  phases          a list of [seconds, torque in body axes]; without it one of t seconds and no torque
"""

from fractions import Fraction
from math import log
from operator import mul

from mpmath import mp, mpf

BITS = 260
ONE = 1 << BITS


def fixed(x):
    """A double, or a fraction, as an integer."""
    return int(Fraction(x) * ONE)


def number(x):
    return mpf(x) / ONE


def momentum_of(body):
    """The product as a double rounds it: what the program starts from."""
    return [i * w for i, w in zip(body["moments"], body["omega"])]


class Law:
    def __init__(self, body, order):
        self.order = order
        # The unit of time, a power of two: about what the body takes for a radian, so that no coefficient runs out of digits.
        speed = sum(x * x for x in body["omega"]) ** 0.5
        self.unit = unit = Fraction(2) ** round(-log(speed, 2)) if speed else Fraction(1)

        def vector(key, unit):
            return [fixed(Fraction(x) * unit) for x in body.get(key, [0.0] * 3)]

        def scalar(key):
            return fixed(Fraction(body.get(key, 0.0)) * unit)

        self.moments, self.arm, self.damping = vector("moments", 1), vector("arm", 1), vector("damping", 1)
        self.inverse = [int(unit * ONE * ONE / i) for i in self.moments]
        self.world, self.push = vector("world", unit), vector("push", unit)
        self.weight, self.gradient, self.orbit, self.rate = map(scalar, ("weight", "gradient", "orbit", "rate"))

    def series(self, state, torque):
        """Coefficients of q, L, and the cosines and sines of orbit and push, about a state."""
        y = [[x] for x in state]
        q, l, circles = y[:4], y[4:7], y[7:]
        w, axes = [[], [], []], [[[], [], []] for _ in range(3)]
        n = 0

        def p(a, b):
            return sum(map(mul, a[: n + 1], b[n::-1])) >> BITS

        def times(c, x):
            return c * x >> BITS

        level = any(self.world) or self.gradient
        seen = level, level, self.weight or any(self.world)
        for n in range(self.order):
            for i in range(3):
                w[i].append(times(self.inverse[i], l[i][n]))
            s, x, y_, z = q
            one = ONE if n == 0 else 0
            # The world's axes in body axes: the rows of the rotation matrix.
            if seen[0]:
                row = one - 2 * (p(y_, y_) + p(z, z)), 2 * (p(x, y_) - p(s, z)), 2 * (p(x, z) + p(s, y_))
                for a, value in zip(axes[0], row):
                    a.append(value)
            if seen[1]:
                row = 2 * (p(x, y_) + p(s, z)), one - 2 * (p(x, x) + p(z, z)), 2 * (p(y_, z) - p(s, x))
                for a, value in zip(axes[1], row):
                    a.append(value)
            if seen[2]:
                row = 2 * (p(x, z) - p(s, y_)), 2 * (p(y_, z) + p(s, x)), one - 2 * (p(x, x) + p(y_, y_))
                for a, value in zip(axes[2], row):
                    a.append(value)
            pull = self.torque(n, p, times, axes, circles, torque)
            dq = [
                -(p(x, w[0]) + p(y_, w[1]) + p(z, w[2])) // 2,
                (p(s, w[0]) + p(y_, w[2]) - p(z, w[1])) // 2,
                (p(s, w[1]) + p(z, w[0]) - p(x, w[2])) // 2,
                (p(s, w[2]) + p(x, w[1]) - p(y_, w[0])) // 2,
            ]
            dl = []
            for i in range(3):
                j, k = (i + 1) % 3, (i + 2) % 3
                dl.append(p(l[j], w[k]) - p(l[k], w[j]) + pull[i] - times(self.damping[i], w[i][n]))
            (c, s_), (c2, s2) = circles[:2], circles[2:]
            dc = [-times(self.orbit, s_[n]), times(self.orbit, c[n]), -times(self.rate, s2[n]), times(self.rate, c2[n])]
            for a, d in zip(y, dq + dl + dc):
                a.append(d // (n + 1))
        return y

    def torque(self, n, p, times, axes, circles, constant):
        """The coefficient of all but the damping."""
        pull = [(x if n == 0 else 0) for x in constant]
        if any(self.push):
            pull = [a + times(b, circles[2][n]) for a, b in zip(pull, self.push)]
        for row, strength in zip(axes, self.world):
            if strength:
                pull = [a + times(strength, b[n]) for a, b in zip(pull, row)]
        if self.weight:
            up = axes[2]
            for i in range(3):
                j, k = (i + 1) % 3, (i + 2) % 3
                pull[i] -= times(self.weight, times(self.arm[j], up[k][n]) - times(self.arm[k], up[j][n]))
        if self.gradient:
            # n in body axes, kept from coefficient to coefficient.
            if n == 0:
                self.toward = [[], [], []]
            for i in range(3):
                self.toward[i].append(p(circles[0], axes[0][i]) + p(circles[1], axes[1][i]))
            for i in range(3):
                j, k = (i + 1) % 3, (i + 2) % 3
                lever = times(self.gradient, self.moments[k] - self.moments[j])
                pull[i] += times(lever, p(self.toward[j], self.toward[k]))
        return pull

    def run(self, phases, digits, share):
        """The state after the phases, by steps whose last terms are below 10^-digits of the largest."""
        state = [ONE, 0, 0, 0] + self.start + [ONE, 0, ONE, 0]
        for seconds, torque in phases:
            left, torque = fixed(Fraction(seconds) / self.unit), [fixed(Fraction(x) * self.unit) for x in torque]
            while left > 0:
                # What has come to rest to all digits stays where it is.
                if not any(torque) and self.losing and max(map(abs, state[4:7])) < max(map(abs, self.start)) >> 190:
                    break
                y = self.series(state, torque)
                h = min(left, int(share * self.step(y, digits)))
                state = [horner(c, h) for c in y]
                left -= h
        return state

    def step(self, y, digits):
        """The length at which the last two coefficients are small relative to the largest of their kind."""
        best = None
        for group in (y[:4], y[4:7], y[7:9], y[9:]):
            size = max(max(abs(c[k]) for c in group) for k in (0, 1))
            for k in (self.order - 1, self.order):
                last = max(abs(c[k]) for c in group)
                if last and size:
                    # log of (10^-digits size / last)^(1/k), with sizes beyond a double's
                    h = (digits * -log(10) + big_log(size) - big_log(last)) / k
                    best = h if best is None else min(best, h)
        return ONE * 10 ** 6 if best is None else int(Fraction(2.718281828459045 ** best) * ONE)


def big_log(x):
    shift = max(x.bit_length() - 1000, 0)
    return log(x >> shift) + shift * log(2.0)


def horner(c, h):
    value = 0
    for x in reversed(c):
        value = x + (value * h >> BITS)
    return value


def end(body, digits=42, order=50):
    """Attitude and momentum at the end, and what two step sizes differ by."""
    phases = body.get("phases") or [[body["t"], [0.0] * 3]]
    law = Law(body, order)
    law.start = [fixed(x) for x in momentum_of(body)]
    law.losing = all(law.damping) and not (law.weight or any(law.world) or law.gradient or any(law.push))
    first = law.run(phases, digits, Fraction(1))
    second = law.run(phases, digits, Fraction(2, 3))
    scale = max(max(map(abs, second[4:7])), max(map(abs, law.start)), 1)
    apart = max([number(abs(a - b)) for a, b in zip(first[:4], second[:4])]
                + [mpf(abs(a - b)) / scale for a, b in zip(first[4:7], second[4:7])])
    return [number(x) for x in second[:4]], [number(x) for x in second[4:7]], apart
