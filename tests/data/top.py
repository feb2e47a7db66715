"""Lagrange's top to 40 digits, by two independent methods.

Inputs are binary64 numbers taken exactly (as fractions). The body has the moments (A, A, C) about its fixed point,
the arm is along its third axis, the weight pulls along the world's -z, and the quaternion q = (w, x, y, z) takes
body to world (its direction alone counts).

  Closed: the lean by Jacobi's sn, precession and spin by Legendre's incomplete integral Pi (mpmath), exact
          cases (cusp, sleeping, separatrix, plane pendulum) found in rational numbers.
  Taylor: power series of Euler's equations and q' = q w/2 in integers; knows no integral of the motion.

`top.py SEED` prints the table: cases [regime, [A, C, arm, weight], q, w, [[t, w(t), q(t), kappa_w, kappa_q], ...]].
kappa is the largest |change of the answer| per relative change of one of the inputs (A, C, weight, q, w, t), by
differences of 1e-30; of the spin relative to its length. An error is judged in units of max(1, kappa) 2^-53.
"""
import json, operator, random, sys
from fractions import Fraction as Fr
import mpmath as mp
from mpmath import mpf, mpc

mp.mp.dps = 90
ROOTS = 200

def M(x): return mpf(x.numerator) / x.denominator

class Closed:
    def __init__(self, body, q, w):
        A, C, arm, weight = body
        n = sum(x * x for x in q)
        qw, qx, qy, qz = q
        g1, g2 = 2 * (qx * qz - qw * qy) / n, 2 * (qy * qz + qw * qx) / n
        s0, w0 = 2 * (qw * qw + qz * qz) / n, 2 * (qx * qx + qy * qy) / n
        self.u0 = u0 = 1 - w0
        b, beta = C * w[2] / A, 2 * arm * weight / A
        O2, d, ud = w[0]**2 + w[1]**2, g1 * w[0] + g2 * w[1], g1 * w[1] - g2 * w[0]
        self.b, self.beta, self.w3 = M(b), M(beta), M(w[2])
        root = mp.sqrt(M(n))
        self.al0, self.be0 = mpc(M(qw), M(qz)) / root, mpc(M(qx), M(qy)) / root
        self.Om0 = mpc(M(w[0]), M(w[1]))
        p, r = w[0], w[1]
        self.ald = mpc(M(-p * qx - r * qy - b * qz), M(r * qx - p * qy + b * qw)) / root / 2
        self.bed = mpc(M(p * qw - r * qz + b * qy), M(p * qz + r * qw - b * qx)) / root / 2
        De, de = d + b * s0, d - b * w0                      # l + b, l - b
        self.De, self.de, self.a = M(De), M(de), M(d + b * u0)
        if beta == 0:
            self.kind = 'free'; return
        if O2 == 0 and (s0 == 0 or w0 == 0):
            self.kind = 'vertical'; return
        f1 = -2 * u0 * O2 - beta * s0 * w0 + 2 * b * d
        f2 = -O2 + 2 * beta * u0 - b * b
        if ud == 0 and f1 == 0:
            self.kind = 'steady'; self.s0, self.w0 = M(s0), M(w0); return
        if de == 0 and O2 == beta * w0 and b * b < 2 * beta:
            self.kind = 'separatrix'
            self.w1 = M(2 - b * b / beta); self.s1 = 2 - self.w1
            self.lam = mp.sqrt(self.beta * self.w1) / 2
            self.v0 = mp.acosh(mp.sqrt(self.w1 / M(w0))) * (1 if ud >= 0 else -1)
            self.F0 = self._primitive(self.v0)
            return
        self.kind = 'general'
        with mp.workdps(ROOTS):
            # x = u - u0: ud^2 + f1 x + f2 x^2 + beta x^3.
            x = self._roots([ud * ud, f1, f2, beta], u0)
            x1, x2, x3 = x
            self.D, self.s1, self.w1 = x2 - x1, M(s0) + x1, M(w0) - x1
            self.s2, self.w2 = M(s0) + x2, M(w0) - x2
            if De == 0: self.s1 = mpf(0)
            if de == 0 and abs(self.w2) < mpf(10)**(-ROOTS // 3): self.w2 = mpf(0)
            self.lam = mp.sqrt(self.beta * (x3 - x1)) / 2
            self.m = self.D / (x3 - x1)
            s = mp.sqrt(max(mpf(0), min(mpf(1), -x1 / self.D)))
            c = mp.sqrt(max(mpf(0), min(mpf(1), x2 / self.D)))
        sign = 1 if ud >= 0 else -1
        phi = mp.atan2(sign * s, c)
        self.K = mp.ellipk(self.m)
        self.v0 = mp.ellipf(phi, self.m)
        self.na, self.nb = (-self.D / self.s1 if self.s1 else None), self.D / self.w1
        self.PaK = mp.ellippi(self.na, self.m) if self.s1 and self.De else None
        self.PbK = mp.ellippi(self.nb, self.m) if self.w2 and self.de else None
        self.start = self._at_phase(self.v0)

    def _roots(self, c, u0):
        "the three roots, sorted; those known exactly are taken out in fractions"
        for known in [Fr(0), 1 - u0, -1 - u0]:
            if c[0] + known * (c[1] + known * (c[2] + known * c[3])) == 0:
                q2, q1 = c[3], c[2] + known * c[3]
                q0 = c[1] + known * q1
                root = mp.sqrt(M(q1 * q1 - 4 * q0 * q2))
                return sorted([M(known), (-M(q1) - root) / (2 * M(q2)), (-M(q1) + root) / (2 * M(q2))])
        a, b, cc = [M(c[k]) / M(c[3]) for k in (2, 1, 0)]
        p, q = b - a * a / 3, 2 * a**3 / 27 - a * b / 3 + cc
        r = mp.sqrt(-p / 3)
        t = mp.acos(max(mpf(-1), min(mpf(1), 3 * q / (2 * p * r)))) / 3
        roots = sorted(2 * r * mp.cos(t - 2 * mp.pi * k / 3) - a / 3 for k in range(3))
        f = lambda x: ((x + a) * x + b) * x + cc
        g = lambda x: (3 * x + 2 * a) * x + b
        for _ in range(3):
            roots = [x - f(x) / g(x) if g(x) else x for x in roots]
        return roots

    def _primitive(self, v):
        T = mp.tanh(v)
        at = mp.atan(T * mp.sqrt(self.w1 / self.s1)) / mp.sqrt(self.s1 * self.w1) if self.s1 else mpf(0)
        return v / 2 + self.w1 / 2 * at

    def _at_phase(self, v):
        j = int(mp.nint(v / (2 * self.K))); r = v - 2 * self.K * j
        e = -1 if j & 1 else 1
        sn, cn, dn = [mp.ellipfun(k, r, m=self.m) for k in ('sn', 'cn', 'dn')]
        ph = mp.atan2(sn, cn)
        Pa = mp.ellippi(self.na, ph, self.m) + 2 * j * self.PaK if self.PaK is not None else mpf(0)
        Pb = mp.ellippi(self.nb, ph, self.m) + 2 * j * self.PbK if self.PbK is not None else mpf(0)
        return e * sn, e * cn, dn, Pa, Pb

    def at(self, t):
        t = M(Fr(t))
        al, be, Om = self._sphere(t)
        chi = (self.w3 - self.b) * t
        al, be, Om = al * mp.expj(chi / 2), be * mp.expj(-chi / 2), Om * mp.expj(-chi)
        return [Om.real, Om.imag, self.w3], [al.real, be.real, be.imag, al.imag]

    def _sphere(self, t):
        a0, b0 = self.al0, self.be0
        if self.kind == 'free':
            w = [self.Om0.real, self.Om0.imag, self.b]
            n = mp.sqrt(sum(x * x for x in w)); s = mp.sin(n * t / 2) / n if n else t / 2
            return a0 * mp.cos(n * t / 2) + 2 * self.ald * s, b0 * mp.cos(n * t / 2) + 2 * self.bed * s, self.Om0
        if self.kind == 'vertical':
            return a0 * mp.expj(self.b * t / 2), b0 * mp.expj(-self.b * t / 2), mpc(0)
        if self.kind == 'steady':
            al, be = a0 * mp.expj(self.De * t / (2 * self.s0)), b0 * mp.expj(self.de * t / (2 * self.w0))
            return al, be, self._spin(al, be, self.a - self.b * M(self.u0), mpf(0))
        if self.kind == 'separatrix':
            v = self.v0 + self.lam * t
            T, S = mp.tanh(v), mp.sech(v)
            if self.s1:
                al = a0 / abs(a0) * mp.sqrt(1 - self.w1 * S * S / 2)
                al *= mp.expj(self.De / (2 * self.lam) * (self._primitive(v) - self.F0))
            else:
                al = a0 * T / mp.tanh(self.v0) if self.v0 else self.ald / self.lam * T
            be = b0 * S / mp.sech(self.v0)
            return al, be, self._spin(al, be, self.a - self.b * (1 - self.w1 * S * S), 2 * self.w1 * S * S * T * self.lam)
        v = self.v0 + self.lam * t
        sn, cn, dn, Pa, Pb = self._at_phase(v)
        sn0, cn0, dn0, Pa0, Pb0 = self.start
        if self.s1:
            al = a0 / abs(a0) * mp.sqrt((self.s1 + self.D * sn * sn) / 2)
            if self.PaK is not None: al *= mp.expj(self.De / (2 * self.lam * self.s1) * (Pa - Pa0))
        else:
            al = a0 * sn / sn0 if a0 else self.ald / (self.lam * cn0 * dn0) * sn
        if self.w2:
            be = b0 / abs(b0) * mp.sqrt((self.w2 + self.D * cn * cn) / 2)
            if self.PbK is not None: be *= mp.expj(self.de / (2 * self.lam * self.w1) * (Pb - Pb0))
        else:
            be = b0 * cn / cn0 if b0 else -self.bed / (self.lam * sn0 * dn0) * cn
        u = M(self.u0) + self.D * (sn * sn - sn0 * sn0)
        return al, be, self._spin(al, be, self.a - self.b * u, 2 * self.lam * self.D * sn * cn * dn)

    def _spin(self, al, be, d, ud):
        G = 2j * mp.conj(al) * be
        return mpc(d, ud) / mp.conj(G)

P, N, SHIFT = 300, 64, 3

def taylor(body, q, w, t):
    "steps of an eighth of the fastest rate; the last is what is left"
    A, C, arm, weight = body
    k = Fr(weight * arm / A)
    scale = max([abs(x) for x in w] + [abs(C * w[2] / A), Fr(float(abs(k))**0.5), Fr(1, 10**9)])
    e = 0
    while Fr(2)**e < scale: e += 1
    while Fr(2)**(e - 1) > scale: e -= 1
    s = Fr(2)**e
    fx = lambda x: int((x * 2**(P + 1) + 1) // 2)
    W = [fx(x / s) for x in w]
    root = mp.sqrt(M(sum(x * x for x in q)))
    Q = [int(mp.nint(M(x) / root * mpf(2)**P)) for x in q]
    c, kk = fx((A - C) / A), fx(k / s / s)
    left = fx(Fr(t) * s)
    sign = 1 if left >= 0 else -1
    left = abs(left)
    dot = lambda x, y: sum(map(operator.mul, x, reversed(y))) >> P
    while left:
        h = min(left, 1 << (P - SHIFT)); left -= h; h *= sign
        a, b, q0, q1, q2, q3 = [W[0]], [W[1]], [Q[0]], [Q[1]], [Q[2]], [Q[3]]
        z = W[2]
        for n in range(N):
            mul = lambda x: ((x * h) >> P) // (n + 1)
            g1, g2 = 2 * (dot(q1, q3) - dot(q0, q2)), 2 * (dot(q2, q3) + dot(q0, q1))
            cz = (c * z) >> P
            na = ((cz * b[n]) >> P) + ((kk * g2) >> P)
            nb = -((cz * a[n]) >> P) - ((kk * g1) >> P)
            n0 = -dot(q1, a) - dot(q2, b) - ((q3[n] * z) >> P)
            n1 = dot(q0, a) + ((q2[n] * z) >> P) - dot(q3, b)
            n2 = dot(q0, b) - ((q1[n] * z) >> P) + dot(q3, a)
            n3 = ((q0[n] * z) >> P) + dot(q1, b) - dot(q2, a)
            for l, x in ((a, mul(na)), (b, mul(nb)), (q0, mul(n0) // 2), (q1, mul(n1) // 2), (q2, mul(n2) // 2), (q3, mul(n3) // 2)):
                l.append(x)
        W = [sum(a), sum(b), z]; Q = [sum(q0), sum(q1), sum(q2), sum(q3)]
    d = mpf(2)**(-P)
    return [x * d * M(s) for x in W], [x * d for x in Q]

def norm(x): return mp.sqrt(sum(abs(y)**2 for y in x))

def kappas(body, q, w, t, here):
    eps = Fr(1, 10**30)
    flat = list(body) + list(q) + list(w)
    worst = [mpf(0), mpf(0)]
    size = norm(here[0]) or mpf(1)
    for i in [0, 1, 3, 4, 5, 6, 7, 8, 9, 10, 'time']:
        if i != 'time' and flat[i] == 0: continue
        other, time = list(flat), Fr(t)
        if i == 'time': time *= 1 + eps
        else: other[i] *= 1 + eps
        there = Closed(other[:4], other[4:8], other[8:]).at(time)
        dw = norm([x - y for x, y in zip(there[0], here[0])]) / size
        dq = min(norm([x - y for x, y in zip(there[1], here[1])]), norm([x + y for x, y in zip(there[1], here[1])]))
        worst = [max(worst[0], dw * mpf(10)**30), max(worst[1], dq * mpf(10)**30)]
    return worst

def cases(seed):
    r = random.Random(seed)
    def tilt(theta, phi=None, psi=None):
        phi = r.uniform(-3, 3) if phi is None else phi
        psi = r.uniform(-3, 3) if psi is None else psi
        c, s = mp.cos(theta / 2), mp.sin(theta / 2)
        return [float(x) for x in (c * mp.cos((phi + psi) / 2), s * mp.cos((phi - psi) / 2),
                                   s * mp.sin((phi - psi) / 2), c * mp.sin((phi + psi) / 2))]
    def body(thin=None, pull=1.0):
        A = r.uniform(0.3, 2.0)
        C = A * (r.uniform(0.05, 1.9) if thin is None else thin)
        return [A, C, r.uniform(0.1, 1.0), pull * r.uniform(0.3, 2.0)]
    def across(size): 
        a = r.uniform(-3.1, 3.1)
        return [float(size * mp.cos(a)), float(size * mp.sin(a))]
    critical = lambda B: 2 * (B[0] * B[2] * B[3])**0.5 / B[1]
    theta = lambda: r.uniform(0.2, 2.9)
    def add(name, B, q, w, times): out.append((name, B, q, w, times))
    out = []
    for n in range(45):
        B = body(); c = critical(B)
        add('general', B, tilt(theta()), across(r.uniform(0.1, 3)) + [c * r.uniform(-2, 2)], [r.uniform(-20, 20), 10**r.uniform(2, 6)])
    for n in range(30):
        B = body(); c = critical(B); q = tilt(r.uniform(0.3, 1.5), 0.0, 0.0)
        add('looping', B, q, [r.uniform(-.1, .1), -r.uniform(0.5, 2), c * r.uniform(1, 4)], [r.uniform(0, 20), 10**r.uniform(2, 5)])
    for n in range(25):
        B = body(); c = critical(B)
        add('cusped', B, tilt(theta()), [0.0, 0.0, c * r.uniform(-4, 4)], [r.uniform(0, 15), 10**r.uniform(2, 5)])
    for n in range(20):
        B = body(); c = critical(B)
        add('fast', B, tilt(theta()), across(r.uniform(0, 2)) + [c * 10**r.uniform(1, 4)], [10**r.uniform(-2, 0), 10**r.uniform(0, 3)])
    for n in range(25):
        B = body()
        add('pendulum', B, tilt(theta()), across(10**r.uniform(-2, 1)) + [0.0], [r.uniform(-15, 15), 10**r.uniform(2, 5)])
    for n in range(20):
        B = body(); t = theta()
        q = [float(mp.cos(t / 2)), float(mp.sin(t / 2)), 0.0, 0.0]
        add('plane', B, q, [r.choice([0.0, r.uniform(-4, 4)]), 0.0, 0.0], [r.uniform(-15, 15), 10**r.uniform(2, 4)])
    for n in range(20):
        B = body(); e = 10**r.uniform(-12, -1); c = critical(B)
        add('hanging', B, tilt(mp.pi - e), across(e * r.uniform(0, 2)) + [c * r.uniform(-2, 2) * r.choice([0, 1, 1])], [r.uniform(-15, 15), 10**r.uniform(2, 5)])
    for n in range(25):
        B = body(); e = 10**r.uniform(-12, -1); c = critical(B)
        add('asleep', B, tilt(e), across(e * r.uniform(0, 2)) + [c * r.choice([-1, 1]) * r.uniform(1.02, 3)], [r.uniform(-15, 15), 10**r.uniform(2, 5)])
    for n in range(30):
        B = body(); e = 10**r.uniform(-12, -2); c = critical(B)
        add('falling', B, tilt(e), across(e * r.uniform(0, 2)) + [c * r.uniform(-0.97, 0.97)], [r.uniform(5, 40), r.uniform(40, 100)])
    for n in range(12):
        B = body(); e = 10**r.uniform(-8, -2); c = critical(B)
        add('critical', B, tilt(e), across(e * r.uniform(0, 2)) + [c * (1 + r.choice([-1, 1]) * 10**r.uniform(-12, -2))], [r.uniform(5, 20), r.uniform(40, 200)])
    # On the separatrix, in few bits: q = (1, x, 0, z)-like with w = 1 - u a fraction, moments 1, weight and arm in powers of two.
    for n in range(12):
        x, y = r.randint(1, 9), r.randint(-3, 9)
        z = r.choice([0, 1, 2])
        q = [Fr(4), Fr(x), Fr(y), Fr(z)]
        nn = sum(k * k for k in q); al2, be2 = q[0]**2 + q[3]**2, x * x + y * y
        # with O = k i conj-ish: spins across that keep O^2 = pull (1-u), l = b: take pull = nn/4 f^2, O = f sqrt(..)
        # Gamma = 2 i conj(al) be / nn; O = Gamma g (p + i s): O^2 = |Gamma|^2 g^2 (p^2+s^2), about = |Gamma|^2 g p.
        p, s = Fr(r.choice([0, 1, 1, 2, -1])), Fr(r.choice([1, 2, -1, -2]))
        G = (2 * (Fr(x) * z - 4 * y) / nn, 2 * (4 * Fr(x) + Fr(y) * z) / nn)
        g = nn / 8
        O = (g * (G[0] * p - G[1] * s), g * (G[0] * s + G[1] * p))
        G2, w0 = G[0]**2 + G[1]**2, 2 * Fr(be2) / nn
        b = G2 * g * p / w0                       # about = b w0
        pull = (O[0]**2 + O[1]**2) / w0           # O^2 = pull w0
        # A = 1, C = 1, arm = 1, weight = pull/2
        B = [1.0, 1.0, 1.0, float(pull / 2)]
        ok = Fr(B[3]) * 2 == pull and all(Fr(float(v)) == v for v in (*O, b)) and b * b < 2 * pull
        if ok:
            add('separatrix', B, [float(v) for v in q], [float(O[0]), float(O[1]), float(b)], [r.uniform(-3, 3), r.uniform(3, 30)])
    for n in range(20):
        # A lean and a rate of precession give the spin; to rounding, and off it by a little.
        B = body(); t = theta(); rate = r.uniform(0.2, 2) * r.choice([-1, 1])
        A, C, k = B[0], B[1], B[2] * B[3]
        w3 = (k + A * rate**2 * float(mp.cos(t))) / (C * rate)
        q = tilt(t, 0.4, 0.0)
        push = r.choice([0, 0, 1e-12, 1e-8, 1e-4]) 
        add('steady', B, q, [push, float(rate * mp.sin(t)) + push, w3], [r.uniform(-15, 15), 10**r.uniform(2, 5)])
    for n, (lean, spin) in enumerate([(0, 3.0), (0, 1.0), (0, 0.0), (1, 2.0), (1, 0.0), (0, -0.5)]):
        q = [0.6, 0.0, 0.0, 0.8] if lean == 0 else [0.0, 0.6, 0.8, 0.0]
        add('vertical', body(), q, [0.0, 0.0, spin], [7.3, 1e4])
    # Through the top and the bottom exactly.
    for n in range(8):
        q = [0.6, 0.0, 0.0, 0.8] if n % 2 else [0.0, 0.6, -0.8, 0.0]
        add('through', body(), q, across(r.uniform(0.1, 4)) + [r.uniform(-3, 3) * (n % 3)], [r.uniform(-15, 15), 300.0])
    for n in range(12):
        B = body(pull=0.0)
        add('free', B, tilt(theta()), across(r.uniform(0.1, 3)) + [r.uniform(-3, 3)], [r.uniform(-15, 15), 10**r.uniform(2, 5)])
    for n in range(16):
        B = body(pull=10**r.uniform(-16, -3))
        add('light', B, tilt(theta()), across(r.uniform(0.1, 3)) + [r.uniform(-3, 3)], [r.uniform(-15, 15), 10**r.uniform(2, 5)])
    for n in range(12):
        B = body(pull=10**r.uniform(3, 12))
        add('heavy', B, tilt(theta()), across(r.uniform(0.1, 3)) + [r.uniform(-3, 3)], [10**r.uniform(-7, -3), 10**r.uniform(-2, 1)])
    for n in range(16):
        B = body(thin=r.choice([1e-6, 1e-3, 1.0, 2.0, 1e-12])); c = critical(B)
        add('thin', B, tilt(theta()), across(r.uniform(0.1, 3)) + [c * r.uniform(-2, 2)], [r.uniform(-3, 3) / max(1.0, c), 10**r.uniform(-1, 2)])
    return out

def fmt(x): return mp.nstr(x, 40, strip_zeros=True, min_fixed=-4, max_fixed=20) if x else '0'

def main():
    seed = int(sys.argv[1]); only = sys.argv[2:] 
    rows, worst = [], mpf(0)
    for name, B, q, w, times in cases(seed):
        if only and name not in only: continue
        exact = [[Fr(x) for x in v] for v in (B, q, w)]
        try:
            closed = Closed(*exact)
            answers = []
            for k, t in enumerate(times):
                here = closed.at(t)
                rate = max(map(abs, w + [B[1] * w[2] / B[0], (B[2] * B[3] / B[0])**0.5]))
                if k == 0 and abs(t) * rate < 60:
                    other = taylor(*exact, t)
                    off = max(norm([x - y for x, y in zip(here[0], other[0])]) / (norm(here[0]) or 1),
                              min(norm([x - y for x, y in zip(here[1], other[1])]), norm([x + y for x, y in zip(here[1], other[1])])))
                    worst = max(worst, off)
                    if off > mpf(10)**-42: print('DIFFER', name, B, q, w, t, mp.nstr(off, 3), closed.kind, file=sys.stderr)
                kw, kq = kappas(*exact, t, here)
                answers.append([repr(t), [fmt(x) for x in here[0]], [fmt(x) for x in here[1]], float(mp.nstr(kw, 4)), float(mp.nstr(kq, 4))])
            rows.append([name, [repr(x) for x in B], [repr(x) for x in q], [repr(x) for x in w], answers])
        except Exception as error:
            print('FAILED', name, B, q, w, repr(error), file=sys.stderr)
    print('two methods differ by at most', mp.nstr(worst, 3), 'in', len(rows), 'cases', file=sys.stderr)
    print('[\n' + ',\n'.join(json.dumps(row) for row in rows) + '\n]')

if __name__ == '__main__': main()
