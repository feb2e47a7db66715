"""Period, mean precession rate and lean of Lagrange's top to 25 digits, with condition numbers.

Of the motions of `top.py`, and of tops whose spin is up to 1e30 times the swing's or whose weight is down to 1e-130:
the mean rate of the azimuth by Legendre's complete integral Pi (mpmath, 300 digits), and where the axis does not pass
next to the vertical also by the mean over equal steps of Jacobi's argument, which knows no Pi.

`top-observables.py SEED` (the committed table: 19) prints the table: cases [regime, [A, C, arm, weight], q, w, [[value, kappa] of the period, the
rate, the highest and the lowest lean]]. kappa is the largest relative change of the value per relative change of
one of the inputs (A, C, weight, q, w), by differences of 1e-30. The period is "inf" where the lean is constant.
"""
import json, random, sys
from fractions import Fraction as Fr
import mpmath as mp
from mpmath import mpf
import top
from top import Closed, M

def lean(low, high): return 2 * mp.atan2(mp.sqrt(low), mp.sqrt(high))

def observables(body, q, w):
    c = Closed(body, q, w)
    if c.kind == 'free':
        n = sum(x * x for x in q); s0, w0 = 2 * (q[0]**2 + q[3]**2) / n, 2 * (q[1]**2 + q[2]**2) / n
        square = M(w[0]**2 + w[1]**2) + c.b**2
        cosine, about = (c.De - c.b) / mp.sqrt(square), c.b / mp.sqrt(square)
        tilt, cone = mp.acos(cosine), mp.acos(about)
        rate = mp.sqrt(square) * mp.sign(c.De) if c.De * c.de > 0 else mpf(0)
        return [2 * mp.pi / mp.sqrt(square), rate, abs(tilt - cone), min(tilt + cone, 2 * mp.pi - tilt - cone)]
    assert c.kind == 'general', c.kind
    rate = (c.De / c.s1 * c.PaK if c.PaK is not None else 0) + (c.de / c.w1 * c.PbK if c.PbK is not None else 0)
    return [2 * c.K / c.lam, rate / (2 * c.K), lean(c.w2, c.s2), lean(c.w1, c.s1)]

def mean_rate(body, q, w, steps=240):
    "the same mean by equal steps of Jacobi's argument; good where it does not depend on their number"
    c = Closed(body, q, w)
    def sum_of(n):
        total = mpf(0)
        for j in range(n):
            sn2 = mp.ellipfun('sn', 2 * c.K * j / n, m=c.m)**2
            total += (c.De / (c.s1 + c.D * sn2) + c.de / (c.w1 - c.D * sn2)) / 2
        return total / n
    return sum_of(steps), sum_of(steps + 33)

def kappas(body, q, w, here):
    flat, worst = list(body) + list(q) + list(w), [mpf(0)] * 4
    for i in [0, 1, 3, 4, 5, 6, 7, 8, 9, 10]:
        if flat[i] == 0: continue
        other = list(flat); other[i] *= 1 + Fr(1, 10**30)
        there = observables(other[:4], other[4:8], other[8:])
        worst = [max(k, abs((x - y) / y) * mpf(10)**30 if y else k) for k, x, y in zip(worst, there, here)]
    return worst

def cases(seed):
    taken = {}
    for name, B, q, w, _ in top.cases(seed):
        taken[name] = taken.get(name, 0) + 1
        if taken[name] <= 8 and name not in ('separatrix', 'vertical'): yield name, B, q, w
    r = random.Random(seed)
    def turned(theta):
        phi, psi = r.uniform(-3, 3), r.uniform(-3, 3)
        c, s = mp.cos(theta / 2), mp.sin(theta / 2)
        return [float(x) for x in (c * mp.cos((phi + psi) / 2), s * mp.cos((phi - psi) / 2),
                                   s * mp.sin((phi - psi) / 2), c * mp.sin((phi + psi) / 2))]
    def body(pull=1.0):
        A = r.uniform(0.3, 2.0)
        return [A, A * r.uniform(0.05, 1.9), r.uniform(0.1, 1.0), pull * r.uniform(0.3, 2.0)]
    for power in (5, 7, 9, 11, 13, 15, 20, 30):
        for wide in (0.0, 1.0, 10.0**(power - 1)):
            B, a = body(), r.uniform(-3, 3)
            spin = (2 * (B[0] * B[2] * B[3])**0.5 / B[1]) * r.choice([-1, 1]) * 10.0**power
            yield 'very fast', B, turned(r.uniform(0.2, 2.9)), [wide * float(mp.cos(a)), wide * float(mp.sin(a)), spin]
    for power in (20, 40, 80, 130):
        for _ in range(3):
            yield 'very light', body(10.0**-power), turned(r.uniform(0.2, 2.9)), [r.uniform(-2, 2), r.uniform(-2, 2), r.uniform(-3, 3)]
    for power in (-9, -5, -2, 2, 6):
        # In a plane but for a spin that is small: it goes round by that alone.
        t = r.uniform(0.4, 2.6)
        yield 'nearly plane', body(), [float(mp.cos(t / 2)), float(mp.sin(t / 2)), 0.0, 0.0], [20.0, 0.0, 10.0**power]

def main():
    mp.mp.dps, top.ROOTS = 300, 700
    show = lambda x: 'inf' if mp.isinf(x) else mp.nstr(x, 25, min_fixed=-4, max_fixed=20) if x else '0'
    rows, checked, off = [], 0, mpf(0)
    for name, B, q, w in cases(int(sys.argv[1])):
        exact = [[Fr(x) for x in v] for v in (B, q, w)]
        here = observables(*exact)
        if name in ('general', 'looping', 'cusped', 'fast', 'heavy', 'very fast') and here[1]:
            with mp.workdps(60 if name != 'very fast' else 160):
                one, other = mean_rate(*exact)
            if abs(one - other) < abs(one) * mpf(10)**-25:
                checked, off = checked + 1, max(off, abs(one - here[1]) / abs(one))
        found = zip(here, kappas(*exact, here))
        rows.append([name] + [[repr(x) for x in v] for v in (B, q, w)] + [[[show(x), float(mp.nstr(k, 4))] for x, k in found]])
    print('equal steps differ by at most', mp.nstr(off, 3), 'in', checked, 'of', len(rows), 'cases', file=sys.stderr)
    print('[\n' + ',\n'.join(json.dumps(row, separators=(',', ':')) for row in rows) + '\n]')

if __name__ == '__main__': main()
