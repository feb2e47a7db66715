"""Makes stories.json: `stories.py`, beside this file. `stories.py --check` writes nothing, and says whether the file is what it makes.

Needs Python 3.11 or newer and mpmath. Independent of the library: Euler's equations and the attitude's, by power series in time, in
fixed point with 200 bits; the spin is held against Jacobi's elliptic functions with 40 digits (mpmath).
"""

import json
import os
import sys
from operator import mul

import mpmath

BITS = 200
ONE = 1 << BITS
ORDER = 44
# The relative change of an input whose effect is measured, for the sensitivities.
NUDGE = 60
STEPS = ["1/30", "1/60", "1/240", "1/1000"]
BOX = (5 / 6, 13 / 12, 5 / 12)
RACKET = (0.00121, 0.01638, 0.01748)
PLAIN = (1.0, 2.0, 3.0)
IDENTITY = (1.0, 0.0, 0.0, 0.0)

MIDDLE = "The middle axis is unstable: the spin turns over, again and again, without a touch."
LARGEST = "The spin about the largest axis is stable: the wobble stays as it is. To drift until it flips is a known fault."
SMALLEST = "The spin about the smallest axis is stable: the wobble stays as it is. To drift until it flips is a known fault."
# Name, what it tests, moments, spin, attitude, seconds.
STORIES = [
    ("box-0.1", MIDDLE + " The book's box, slowly.", BOX, (0.1, 0.001, 0.001), IDENTITY, 600),
    ("box-1", MIDDLE + " The book's box.", BOX, (1.0, 0.01, 0.01), IDENTITY, 60),
    ("box-5", MIDDLE + " The book's box, thrown.", BOX, (5.0, 0.05, 0.05), IDENTITY, 20),
    ("box-30", MIDDLE + " The book's box, fast.", BOX, (30.0, 0.3, 0.3), IDENTITY, 5),
    ("racket-5", MIDDLE + " A tennis racket, whose two greater moments are near each other.", RACKET, (0.05, 5.0, 0.05), IDENTITY, 20),
    ("push-1e-1", MIDDLE + " After a push of a tenth of the spin.", PLAIN, (0.0, 5.0, 0.5), IDENTITY, 10),
    ("push-1e-2", MIDDLE + " After a push of a hundredth of the spin.", PLAIN, (0.0, 5.0, 0.05), IDENTITY, 10),
    ("push-1e-3", MIDDLE + " After a push of a thousandth of the spin.", PLAIN, (0.0, 5.0, 0.005), IDENTITY, 10),
    ("largest-0.1", LARGEST + " Slowly.", PLAIN, (0.005, 0.005, 0.1), IDENTITY, 300),
    ("largest-1", LARGEST, PLAIN, (0.05, 0.05, 1.0), IDENTITY, 60),
    ("largest-5", LARGEST + " Faster.", PLAIN, (0.25, 0.25, 5.0), IDENTITY, 60),
    ("largest-30", LARGEST + " Fast.", PLAIN, (1.5, 1.5, 30.0), IDENTITY, 10),
    ("smallest-0.1", SMALLEST + " Slowly.", PLAIN, (0.1, 0.005, 0.005), IDENTITY, 300),
    ("smallest-1", SMALLEST, PLAIN, (1.0, 0.05, 0.05), IDENTITY, 60),
    ("smallest-5", SMALLEST + " Faster.", PLAIN, (5.0, 0.25, 0.25), IDENTITY, 60),
    ("smallest-30", SMALLEST + " Fast.", PLAIN, (30.0, 1.5, 1.5), IDENTITY, 10),
    ("prolate-5", "A long body with two equal moments: the spin circles its axis evenly.", (3.0, 3.0, 1.0), (1.5, 2.0, 4.0), IDENTITY, 20),
    ("oblate-5", "A flat body with two equal moments: the spin circles its axis evenly.", (1.0, 1.0, 1.75), (1.5, 2.0, 4.0), IDENTITY, 20),
    ("sphere-5", "A sphere: the spin stays as it is, and only the attitude can be wrong.", (0.4, 0.4, 0.4), (3.0, -2.0, 3.5), IDENTITY, 20),
    ("needle-5", "A needle: its smallest moment is a hundredth of the others.", (0.01, 1.0, 1.005), (5.0, 0.5, 0.25), IDENTITY, 20),
    ("plate-5", "A plate: the largest moment is the sum of the others, " + MIDDLE[0].lower() + MIDDLE[1:], (1.0, 2.25, 3.25), (0.0625, 5.0, 0.0625), IDENTITY, 20),
    ("turned-5", "A start that is not along the world's axes, with a spin about no axis.", (1.0, 2.0, 2.5), (2.0, 4.0, -2.0), (0.8, 0.2, -0.4, 0.4), 20),
]


def fixed(x):
    """A double, exactly, in fixed point (cut off below the last bit, of which ours have none)."""
    over, under = x.as_integer_ratio()
    return over * ONE // under


def real(x):
    return mpmath.mpf(x) / ONE


def root(x):
    """The square root of a number in fixed point."""
    from math import isqrt

    return isqrt(x << BITS)


class Run:
    """A motion, carried from time to time by power series, in units of the first spin's length."""

    def __init__(self, moments, spin, attitude):
        a, b, c = moments
        self.unit = root(sum(x * x for x in spin) >> BITS)
        self.ratios = [((b - c) << BITS) // a, ((c - a) << BITS) // b, ((a - b) << BITS) // c]
        self.spin = [(x << BITS) // self.unit for x in spin]
        length = root(sum(x * x for x in attitude) >> BITS)
        self.attitude = [(x << BITS) // length for x in attitude]
        # Where the series of all such bodies still fall fast: the spin's own scale in radians.
        self.reach = ONE // 4
        self.time = 0

    def series(self, length):
        """Coefficients of spin and attitude about now, in powers of the share of a step so long."""
        w, q = [[x] for x in self.spin], [[x] for x in self.attitude]
        for k in range(ORDER):
            d = []
            for i in range(3):
                u, v = w[(i + 1) % 3], w[(i + 2) % 3]
                product = sum(map(mul, u, reversed(v))) >> BITS
                d.append((self.ratios[i] * product >> BITS) * length // (k + 1) >> BITS)
            dot = lambda m, n: sum(map(mul, q[m], reversed(w[n])))
            e = [
                -dot(1, 0) - dot(2, 1) - dot(3, 2),
                dot(0, 0) + dot(2, 2) - dot(3, 1),
                dot(0, 1) + dot(3, 0) - dot(1, 2),
                dot(0, 2) + dot(1, 1) - dot(2, 0),
            ]
            for i in range(3):
                w[i].append(d[i])
            for i in range(4):
                q[i].append((e[i] >> BITS + 1) * length // (k + 1) >> BITS)
        return w, q

    def to(self, time, middle=None):
        """Moves to a time (s, fixed point); the times at which the spin along axis `middle` is zero on the way, if asked."""
        zeros = []
        end = time * self.unit >> BITS
        while self.time < end:
            length = min(self.reach, end - self.time)
            w, q = self.series(length)
            if middle is not None and (w[middle][0] < 0) != (sum(w[middle]) < 0):
                zeros.append(((self.time + (length * zero(w[middle]) >> BITS)) << BITS) // self.unit)
            self.spin, self.attitude = [sum(x) for x in w], [sum(x) for x in q]
            self.time += length
        return zeros

    def omega(self):
        return [x * self.unit >> BITS for x in self.spin]


def zero(series):
    """Where a series is zero, in parts of the step: Newton's method, from the middle, kept inside by halving."""
    low, high, x = 0, ONE, ONE // 2
    sign = series[0] < 0
    for _ in range(300):
        value = slope = 0
        for c in reversed(series):
            slope = (slope * x >> BITS) + value
            value = (value * x >> BITS) + c
        low, high = (x, high) if (value < 0) == sign else (low, x)
        step = -((value << BITS) // slope) if slope else ONE
        if abs(step) < 1 << 20:
            return x
        x = x + step if low < x + step < high else (low + high) // 2
    raise ArithmeticError("no zero found")


def closed(moments, spin, time):
    """The spin by Jacobi's functions, for three different moments."""
    I = [mpmath.mpf(x) for x in moments]
    w = [mpmath.mpf(x) for x in spin]
    order = sorted(range(3), key=lambda i: I[i])
    # An odd order of the axes turns right-handed axes into left-handed ones: the spin then runs backward.
    odd = order in ([1, 0, 2], [0, 2, 1], [2, 1, 0])
    T = 2 * sum(i * x * x for i, x in zip(I, w)) / 2
    M = sum((i * x) ** 2 for i, x in zip(I, w))
    A, B, C = (I[i] for i in order)
    # Landau and Lifshitz, Mechanics, section 37: about the largest moment's axis if M > T B.
    if M < T * B:
        A, C = C, A
        order = order[::-1]
        odd = not odd
    rate = mpmath.sqrt((C - B) * (M - T * A) / (A * B * C))
    m = (B - A) * (T * C - M) / ((C - B) * (M - T * A))
    top = [mpmath.sqrt((T * C - M) / (A * (C - A))), mpmath.sqrt((T * C - M) / (B * (C - B))), mpmath.sqrt((M - T * A) / (C * (C - A)))]
    x, y, z = (w[i] for i in order)
    # With signs (s1, s2, s3) the functions solve the equations if s1 s2 s3 is as the handedness says.
    sx, sz = (-1 if x < 0 else 1), (-1 if z < 0 else 1)
    # Of the equation for the middle axis, whose factor is (C - A) with A < C.
    forward = (1 if not odd else -1) * sx * sz * (1 if C > A else -1)
    phase = mpmath.ellipf(mpmath.atan2(forward * y / top[1], abs(x) / top[0]), m)
    u = rate * time + phase
    sn, cn, dn = (mpmath.ellipfun(f, u, m=m) for f in ("sn", "cn", "dn"))
    out = [0, 0, 0]
    out[order[0]], out[order[1]], out[order[2]] = sx * top[0] * cn, forward * top[1] * sn, sz * top[2] * dn
    return out


def length(v):
    return mpmath.sqrt(sum(x * x for x in v))


def apart(p, q):
    """The angle between two attitudes, rad."""
    w = sum(a * b for a, b in zip(p, q))
    v = [p[0] * q[i] - q[0] * p[i] - (p[j] * q[k] - p[k] * q[j]) for i, j, k in ((1, 2, 3), (2, 3, 1), (3, 1, 2))]
    return 2 * mpmath.atan2(length(v), abs(w))


def exactly(moments, spin, attitude, asked, middle):
    run, answers, flips = Run(moments, spin, attitude), [], []
    for time in asked:
        flips += run.to(time, middle)
        answers.append(([real(x) for x in run.omega()], [real(x) for x in run.attitude]))
    return answers, [real(x) for x in flips]


def digits(x):
    return float(x)


def two(x, most):
    """A tolerance, two digits, rounded up; none where it is no bound at all."""
    if x >= most:
        return None
    place = mpmath.mpf(10) ** (mpmath.floor(mpmath.log10(x)) - 1)
    return float(mpmath.nstr(mpmath.ceil(x / place) * place, 2))


def story(name, tests, moments, spin, attitude, seconds):
    asked = [t / 10 for t in sorted({1, 10 * seconds // 60, 10 * seconds // 10, 10 * seconds // 3, 10 * seconds * 2 // 3, 10 * seconds} - {0})]
    exact = [round(10 * t) * ONE // 10 for t in asked]
    distinct = len(set(moments)) == 3
    middle = sorted(range(3), key=lambda i: moments[i])[1] if distinct else None
    start = [[fixed(x) for x in part] for part in (moments, spin, attitude)]
    answers, flips = exactly(*start, exact, middle)
    if distinct:
        for t, (w, _) in zip(exact, answers):
            off = length([a - b for a, b in zip(w, closed(moments, spin, real(t)))]) / length(w)
            assert off < mpmath.mpf(10) ** -33, (name, off)
    # What each input's relative change does, summed over the inputs. The attitude's own four components turn it by twice as much at most.
    of_spin, of_attitude, of_flips = [0] * len(asked), [2] * len(asked), [0] * len(flips)
    for part in (0, 1):
        for i in range(3):
            if not start[part][i]:
                continue
            nudged = [list(x) for x in start]
            nudged[part][i] += nudged[part][i] >> NUDGE
            others, times = exactly(*nudged, exact, middle)
            assert len(times) == len(flips)
            scale = mpmath.mpf(2) ** NUDGE
            for k, ((w, q), (v, p)) in enumerate(zip(answers, others)):
                of_spin[k] += scale * length([a - b for a, b in zip(w, v)]) / length(w)
                of_attitude[k] += scale * apart(q, p)
            for k, (s, t) in enumerate(zip(flips, times)):
                of_flips[k] += scale * abs(s - t)
    # The most that the body's energy and momentum ever let it spin.
    I, w = [mpmath.mpf(x) for x in moments], [mpmath.mpf(x) for x in spin]
    top = fastest(I, w)
    parts = {"f64": mpmath.mpf(2) ** -53, "f32": mpmath.mpf(2) ** -24}
    for step in STEPS:
        parts[step] = (top / int(step[2:])) ** 2 / 12
    within = lambda k: {key: [two(of_spin[k] * u, 1), two(of_attitude[k] * u, 1)] for key, u in parts.items()}
    q = [mpmath.mpf(x) / length([mpmath.mpf(y) for y in attitude]) for x in attitude]
    angular = [i * x for i, x in zip(I, w)]
    return {
        "name": name,
        "tests": tests,
        "moments": moments,
        "spin": spin,
        "attitude": attitude,
        "duration": seconds,
        "fastest": two(top, 1e9),
        "energy": digits(sum(l * x for l, x in zip(angular, w)) / 2),
        "momentum": digits(length(angular)),
        "momentum_world": [digits(x) for x in turned(q, angular)],
        "flips": None if middle is None else [digits(t) for t in flips],
        "flips_within": None if not flips else {key: [two(s * u, mpmath.inf) for s in (of_flips[0], of_flips[-1])] for key, u in parts.items()},
        "answers": [
            {"t": t, "spin": [digits(x) for x in w], "attitude": [digits(x) for x in q], "within": within(k)}
            for k, (t, (w, q)) in enumerate(zip(asked, answers))
        ],
    }


def fastest(I, w):
    """The greatest spin on the way: at one of the points where two axes' planes are crossed, or the start of a spin that is steady."""
    T, M = sum(i * x * x for i, x in zip(I, w)), sum((i * x) ** 2 for i, x in zip(I, w))
    best = length(w)
    for i, j in ((0, 1), (1, 2), (0, 2)):
        if I[i] == I[j]:
            continue
        # I x^2 + J y^2 = T and I^2 x^2 + J^2 y^2 = M.
        x = (M - T * I[j]) / (I[i] * (I[i] - I[j]))
        y = (M - T * I[i]) / (I[j] * (I[j] - I[i]))
        if x >= 0 and y >= 0:
            best = max(best, mpmath.sqrt(x + y))
    return best


def turned(q, v):
    w, u = q[0], q[1:]
    cross = lambda a, b: [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
    t = [2 * x for x in cross(u, v)]
    return [a + w * b + c for a, b, c in zip(v, t, cross(u, t))]


def written(stories):
    """JSON with a line for each answer."""
    text = json.dumps({"about": ABOUT, "steps": STEPS, "stories": "HERE"}, indent=1)
    parts = []
    for story in stories:
        lines = [f"   {json.dumps(key)}: {json.dumps(value)}" for key, value in story.items() if key != "answers"]
        answers = ",\n".join("    " + json.dumps(answer) for answer in story["answers"])
        lines.append(f'   "answers": [\n{answers}\n   ]')
        parts.append("  {\n" + ",\n".join(lines) + "\n  }")
    return text.replace('"HERE"', "[\n" + ",\n".join(parts) + "\n ]") + "\n"


ABOUT = "Standard stories of a free rigid body, with the exact answers. SI units; the spin in body axes, rad/s; attitudes as quaternions w, x, y, z, body to world. See README.md."


def main():
    mpmath.mp.dps = 40
    text = written([story(*x) for x in STORIES])
    path = os.path.join(os.path.dirname(os.path.abspath(__file__)), "stories.json")
    if "--check" in sys.argv:
        same = open(path).read() == text
        print("stories.json is what this makes" if same else "stories.json differs from what this makes")
        sys.exit(not same)
    open(path, "w").write(text)


if __name__ == "__main__":
    main()
