"""Derives the preprocessing of the discrete Moser-Veselov algorithm, in exact fractions.

Moser and Veselov's step turns the body by the unit quaternion (p0, p) that solves h y/2 = p0 K p + p x K p, with y the angular
momentum in body axes and K the moments it is given. Then h (y + y')/4 = p0 K p, with y' the momentum after the step. So the moments
for which the step IS the motion of a body with moments I follow from that motion: 1/K_j = 4 p0 p_j / (h (y + y')_j).
This program expands the motion in powers of h for many bodies with whole numbers, finds 1/K_j = a/I_j + b with the same a and b for
all three axes (it checks the third), and solves for the coefficients of a and b as polynomials in

    h^2,  C = y.y,  T = y.y/I (twice the energy),  and the elementary symmetric functions e1, e2, e3 of the 1/I_j,

checking them on bodies beyond those that settle them. Of a needle these sums cancel: its 1/I_1 is large, and a and b are not. So
they are put in numbers of the size of 1. With the mean of 1/I_2 and 1/I_3 for the unit of the 1/I_j, these are

    w = I_1,  1/I_2 = 1 - d,  1/I_3 = 1 + d,  s = (d/w)^2,  t = d^2,  T = C + w U,

in which all negative powers of w cancel (the program checks it). It prints the sums that src/step/methods/moser_veselov.rs holds.
Found first by McLachlan and Zanna (2005) and Hairer and Vilmart (2006); derived here afresh.

    python3 crates/proofs/programs/moser_veselov.py
"""

import math
import random
from fractions import Fraction as F

N = 12  # powers of h that are followed


def mul(a, b):
    c = [F(0)] * N
    for i, x in enumerate(a):
        if x:
            for j in range(N - i):
                c[i + j] += x * b[j]
    return c


def over(a, b):
    c = []
    for n in range(N):
        c.append((a[n] - sum(b[k] * c[n - k] for k in range(1, n + 1))) / b[0])
    return c


def add(*terms):
    return [sum(x) for x in zip(*terms)]


def neg(a):
    return [-x for x in a]


def motion(J, y0):
    """Momentum and relative attitude (w, x, y, z) from the identity, by powers of time."""
    y = [[F(v)] + [F(0)] * (N - 1) for v in y0]
    q = [[F(v)] + [F(0)] * (N - 1) for v in (1, 0, 0, 0)]
    cross = lambda a, b: [add(mul(a[(i + 1) % 3], b[(i + 2) % 3]), neg(mul(a[(i + 2) % 3], b[(i + 1) % 3]))) for i in range(3)]
    integral = lambda r, first: [F(first)] + [r[n] / (n + 1) for n in range(N - 1)]
    for _ in range(N):
        w = [[J[i] * x for x in y[i]] for i in range(3)]
        rate = cross(y, w)
        dot = add(*[mul(q[i + 1], w[i]) for i in range(3)])
        turn = cross(q[1:], w)
        qrate = [neg(dot)] + [add(mul(q[0], w[i]), turn[i]) for i in range(3)]
        y = [integral(rate[i], y0[i]) for i in range(3)]
        q = [integral([x / 2 for x in qrate[i]], 1 if i == 0 else 0) for i in range(4)]
    return y, q


def ab(J, y0):
    y, q = motion(J, y0)
    K = []
    for j in range(3):
        top = [4 * x for x in mul(q[0], q[j + 1])][1:] + [F(0)]
        total = [x for x in y[j]]
        total[0] += y0[j]
        K.append(over(top, total)[: N - 1])
    a = [(K[0][n] - K[1][n]) / (J[0] - J[1]) for n in range(N - 1)]
    b = [K[0][n] - a[n] * J[0] for n in range(N - 1)]
    assert all(K[2][n] == a[n] * J[2] + b[n] for n in range(N - 1)), "no such a and b"
    return a, b


def monomials(k, degree):
    """C^i T^j e1^p e2^q e3^r with i + j = k, of degree `degree` in 1/I in all (T counts one)."""
    found = []
    for j in range(k + 1):
        rest = degree - j
        for r in range(rest // 3 + 1):
            for q in range((rest - 3 * r) // 2 + 1):
                found.append((k - j, j, rest - 3 * r - 2 * q, q, r))
    return found


def value(m, s):
    v = F(1)
    for power, x in zip(m, s):
        v *= x**power
    return v


def solve(rows, right):
    n = len(rows[0])
    M = [r + [x] for r, x in zip(rows, right)]
    at = 0
    for c in range(n):
        pivot = next(i for i in range(at, len(M)) if M[i][c])
        M[at], M[pivot] = M[pivot], M[at]
        M[at] = [x / M[at][c] for x in M[at]]
        for i in range(len(M)):
            if i != at and M[i][c]:
                f = M[i][c]
                M[i] = [x - f * z for x, z in zip(M[i], M[at])]
        at += 1
    assert all(not r[-1] for r in M[at:]), "not a polynomial of this form"
    return [M[i][-1] for i in range(n)]


def main():
    random.seed(1)
    samples = []
    while len(samples) < 60:
        J = [F(random.randint(1, 12), random.randint(1, 3)) for _ in range(3)]
        y0 = [F(random.choice([-3, -2, -1, 1, 2, 3, 4]), random.randint(1, 2)) for _ in range(3)]
        if len(set(J)) == 3:
            s = (sum(y * y for y in y0), sum(j * y * y for j, y in zip(J, y0)), sum(J),
                 J[0] * J[1] + J[1] * J[2] + J[2] * J[0], J[0] * J[1] * J[2])
            samples.append((s, ab(J, y0)))
    for k in range(1, 5):
        for name, which, degree in (("a", 0, 2 * k), ("b", 1, 2 * k + 1)):
            ms = monomials(k, degree)
            c = solve([[value(m, s) for m in ms] for s, _ in samples], [r[which][2 * k] for _, r in samples])
            below = math.lcm(*[x.denominator for x in c])
            total = {}
            for m, x in zip(ms, c):
                for power, y in product([VARIABLES[i] for i, p in enumerate(m) for _ in range(p)]).items():
                    total[power] = total.get(power, 0) + x * below * y
            total = {power: x for power, x in total.items() if x}
            assert all(power[2] >= 0 for power in total), "a negative power of w is left"
            print(f"// {name}, h^{2 * k}, over {below}: by rising powers of U")
            for j in range(k + 1):
                terms = sorted((s, w, x) for (_, u, w, s), x in total.items() if u == j)
                print("[" + ", ".join(term(w, s, x) for s, w, x in terms) + "]")


# C, T, e1, e2 and e3 as sums of powers of C, U, w and s.
VARIABLES = [
    {(1, 0, 0, 0): 1},
    {(1, 0, 0, 0): 1, (0, 1, 1, 0): 1},
    {(0, 0, -1, 0): 1, (0, 0, 0, 0): 2},
    {(0, 0, -1, 0): 2, (0, 0, 0, 0): 1, (0, 0, 2, 1): -1},
    {(0, 0, -1, 0): 1, (0, 0, 1, 1): -1},
]


def product(factors):
    total = {(0, 0, 0, 0): F(1)}
    for factor in factors:
        new = {}
        for m, x in total.items():
            for n, y in factor.items():
                power = tuple(p + q for p, q in zip(m, n))
                new[power] = new.get(power, 0) + x * y
        total = new
    return total


def term(w, s, x):
    """x w^w s^s, with t for w^2 s as often as it is in it."""
    t = min(w // 2, s)
    return " ".join([str(x)] + ["w"] * (w - 2 * t) + ["s"] * (s - t) + ["t"] * t)


main()
