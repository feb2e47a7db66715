"""Random free motions, hard ones above all, in the format of free-motion.json.

    python3 sweep.py SEED COUNT > cases.json

Computed with mpmath by oracle.py (closed form), each with the relative condition numbers that an error is
measured by: one-sided differences with a relative step of 1e-60, of each input by itself (kappa_*), and of a
common shift of the moments and of their two differences instead of the moments (kappas_*)."""
import sys, json, random, math
from fractions import Fraction as Fr
import mpmath as mp
from oracle import Closed, F, M, fmt

STEP = Fr(1, 10**60)

def digits(I, w):
    "enough digits for the closed form: twice what the complement takes, and room for the differences"
    I, w = [F(x) for x in I], [F(x) for x in w]
    lo, mid, hi = sorted(range(3), key=lambda i: I[i])
    size = [I[lo]*(I[mid]-I[lo])*w[lo]**2, I[mid]*(I[hi]-I[lo])*w[mid]**2, I[hi]*(I[hi]-I[mid])*w[hi]**2]
    small = [abs(x) for x in size + [size[2]-size[0]] if x]
    if not small: return 160
    spread = Fr(max(small))/min(small)
    return int(170 + 1.2*(spread.numerator.bit_length()-spread.denominator.bit_length())*0.30103)

def vec(x): return mp.sqrt(mp.fsum(a*a for a in x))

def case(name, I, w, turns, rng):
    If, wf = [F(x) for x in I], [F(x) for x in w]
    dps = digits(I, w)
    c = Closed(I, w, dps)
    with mp.workdps(dps):
        if c.kind == 'const': unit = 2*mp.pi/(vec(c.w0) or 1)
        elif c.kind == 'sep': unit = 4/c.rate
        else: unit = c.period
        ts = [float(unit*mp.mpf(k)) for k in turns]
        ts = [t for t in ts if math.isfinite(t) and t]
        perturbed, structured = [], []
        for k in range(6):
            J, v = list(If), list(wf)
            if k < 3: J[k] *= 1+STEP
            else: v[k-3] *= 1+STEP
            perturbed.append(Closed(J, v, dps))
        order = sorted(range(3), key=lambda i: If[i]); lo, mid, hi = order
        for k in range(3):
            J = list(If)
            if k == 0: J = [x + STEP*If[lo] for x in J]
            elif k == 1: J[mid] += STEP*(If[mid]-If[lo])
            else: J[hi] += STEP*(If[hi]-If[mid])
            structured.append(Closed(J, wf, dps))
        out = dict(name=name, inertia=[repr(float(x)) for x in I], w0=[repr(float(x)) for x in w],
                   t=[repr(t) for t in ts], kind=c.kind, period=fmt(c.period, 20), m1=fmt(c.m1, 20),
                   w=[], q=[], kappa_w=[], kappa_q=[], kappa_wc=[], kappas_w=[], kappas_q=[])
        for t in ts:
            W, Q = c.at(t); n = vec(W) or mp.mpf(1)
            step = M(STEP)
            def change(o, tt=None):
                a, b = o.at(F(t) if tt is None else tt)
                d = [(x-y)/step for x, y in zip(a, W)]
                e = min(vec([x-y for x, y in zip(b, Q)]), vec([x+y for x, y in zip(b, Q)]))/step
                return d, e
            time = change(c, F(t)*(1+STEP))
            plain = [change(o) for o in perturbed] + [time]
            tight = [change(o) for o in structured] + plain[3:]
            out['w'].append([fmt(x) for x in W]); out['q'].append([fmt(x) for x in Q])
            out['kappa_w'].append(fmt(max(vec(d)/n for d, _ in plain), 6))
            out['kappa_q'].append(fmt(max(e for _, e in plain), 6))
            out['kappa_wc'].append([fmt(max(abs(d[i]) for d, _ in plain), 6) for i in range(3)])
            out['kappas_w'].append(fmt(max(vec(d)/n for d, _ in tight), 6))
            out['kappas_q'].append(fmt(max(e for _, e in tight), 6))
    return out

def body(rng, kind):
    u = rng.uniform
    if kind == 'needle':
        a = 10**u(-12, -1); I = [a, 1.0, 1.0 + a*u(0.05, 0.95)]
    elif kind == 'plate':
        a, b = u(0.2, 1), u(0.2, 1); I = [a, b, a+b]
        while F(I[2]) > F(I[0])+F(I[1]): I[2] = math.nextafter(I[2], 0)
    elif kind == 'sphere':
        e = 10**u(-15, -1); I = [1.0, 1.0 + e*u(0.1, 1), 1.0 - e*u(0.1, 1)]
    elif kind == 'top':
        e = 10**u(-15, -1); I = [u(0.6, 1.9), 1.0, 1.0 + e]
    elif kind == 'disc':
        e = 10**u(-12, -1); I = [0.5, 0.5 + e, 1.0]
    else:
        x, y, z = u(0.05, 1), u(0.05, 1), u(0.05, 1); I = [x+y, y+z, z+x]
    s = sorted(range(3), key=lambda i: I[i])
    if F(I[s[2]]) > F(I[s[0]])+F(I[s[1]]): return body(rng, kind)
    return I

def spin(rng, kind, I):
    u = rng.uniform; sign = lambda: rng.choice([-1, 1])
    lo, mid, hi = sorted(range(3), key=lambda i: I[i])
    w = [sign()*u(0.05, 1) for _ in range(3)]
    if kind in ('flip', 'tiny', 'subnormal', 'stable'):
        p = {'flip': lambda: 10**u(-16, -1), 'tiny': lambda: 10**u(-300, -16), 'stable': lambda: 10**u(-300, -1),
             'subnormal': lambda: rng.choice([5e-324, 1e-320, 3e-310])}[kind]
        main = mid if kind != 'stable' else rng.choice([lo, hi])
        w = [sign()*p()*(1 if i != main else 0) for i in range(3)]
        drop = rng.choice([i for i in range(3) if i != main] + [None]*2)
        if drop is not None: w[drop] = 0.0
        w[main] = sign()*u(0.3, 1)
    elif kind == 'near-separatrix':
        r = mp.sqrt(mp.mpf(I[lo])*(mp.mpf(I[mid])-I[lo])/(mp.mpf(I[hi])*(mp.mpf(I[hi])-I[mid])))
        w[hi] = sign()*float(abs(w[lo])*r*(1+sign()*10**u(-17, -2)))
    elif kind == 'plane': w[rng.randrange(3)] = 0.0
    return w

def main():
    rng = random.Random(int(sys.argv[1])); cases = []
    bodies = ['generic', 'generic', 'needle', 'plate', 'sphere', 'top', 'disc']
    spins = ['generic', 'generic', 'flip', 'tiny', 'subnormal', 'stable', 'near-separatrix', 'plane']
    for n in range(int(sys.argv[2])):
        kb, ks = rng.choice(bodies), rng.choice(spins)
        I = body(rng, kb); p = rng.sample(range(3), 3); I = [I[i] for i in p]
        w = spin(rng, ks, I)
        a = rng.choice([0, 0, 0, -200, 150, 100, -100]); b = rng.choice([0, 0, 0, -200, 150, 100, -100])
        if ks in ('tiny', 'subnormal', 'stable'): b = 0
        I = [math.ldexp(x, int(a*3.3)) for x in I]; w = [math.ldexp(x, int(b*3.3)) for x in w]
        turns = [rng.choice([-1, 1])*x for x in (10**rng.uniform(-12, -2), rng.uniform(0.01, 1), rng.uniform(1, 30), 10**rng.uniform(2, 9))]
        cases.append(case('%s-%s-%d' % (kb, ks, n), I, w, turns, rng))
        print(n, kb, ks, file=sys.stderr)
    json.dump(dict(cases=cases), sys.stdout, indent=0)

if __name__ == '__main__': main()
