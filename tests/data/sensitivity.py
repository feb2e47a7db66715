"""Derivatives of free motions by the spin at the start and by the six entries of the tensor, to 20 digits.

    python3 sensitivity.py > sensitivity.json

Symmetric differences of the closed form (oracle.py). The distance is 1e-35 of the smallest scale there is (a component
of the spin, a moment, a difference of two moments), and so many digits are carried that 40 or more of the difference
are left. A product of inertia turns two principal axes: the closed form is that of the tensor's own moments, seen from
the axes turned back. The turn is the rotation vector in the world, twice the imaginary part of dq conj(q)."""
import json, math, itertools, random
from fractions import Fraction as Fr
from multiprocessing import Pool
import mpmath as mp
from mpmath import mpf
from oracle import Closed, F, M, qmul, qconj

def distances(I, w, t, on_separatrix):
    "for a component of the spin and for a moment"
    J, v = [F(x) for x in I], [F(x) for x in w]
    lengths = [abs(a-b) for a, b in itertools.combinations(J, 2)] + J
    spins = [abs(x) for x in v if x]
    power = lambda x: Fr(10)**(math.floor(mp.log10(M(x))) - 35)
    least = min(spins) if spins else Fr(1)
    ratio = least/max(spins) if spins else Fr(1)
    # a neighbour of the separatrix leaves it as the square of what a change grows by
    near = Fr(10)**-int(0.9*Closed(I, w, 30).rate*abs(t)) if on_separatrix and ratio > 1e-50 else Fr(1)
    # so close to the separatrix, a moment must not move the motion across it
    return power(least)*near, power(min(x for x in lengths if x)*ratio**2)*near

PRODUCTS = ((0, 1), (0, 2), (1, 2))

def rational(x):
    "the exact value of an mpf"
    sign, man, exp, _ = x._mpf_
    return Fr((-1)**sign*int(man))*Fr(2)**exp

def with_product(J, v, pair, h, t, digits):
    "the motion of diag(J) with this product of inertia"
    i, j = pair
    k = 3-i-j
    if (j-i) % 3 == 2: i, j = j, i # i, j, k cyclic
    mean, half = (M(J[i])+M(J[j]))/2, (M(J[i])-M(J[j]))/2
    angle = mp.atan2(M(h), half)/2 # of the axis of the larger moment from i to j
    root = mp.sqrt(half*half+M(h)**2)
    back = [mpf(0)]*4
    back[0], back[1+k] = mp.cos(angle/2), -mp.sin(angle/2)
    turned = list(v)
    c, s = mp.cos(angle), mp.sin(angle)
    turned[i], turned[j] = rational(c*M(v[i])+s*M(v[j])), rational(c*M(v[j])-s*M(v[i]))
    own = list(J)
    own[i], own[j] = rational(mean+root), rational(mean-root)
    W, q = Closed(own, turned, digits).at(t)
    W = list(W)
    W[i], W[j] = c*W[i]-s*W[j], c*W[j]+s*W[i]
    return W, list(qmul(qmul(qconj(back), q), back))

def derivatives(case):
    family, I, w, t = case
    h_spin, h_moment = distances(I, w, t, family == 'separatrix')
    digits = 160 + 3*max(0, int(-mp.log10(M(min(h_spin/max([abs(F(x)) for x in w] + [h_spin]), h_moment/F(max(I)))))))
    with mp.workdps(digits):
        Q = Closed(I, w, digits).at(t)[1]
        columns = []
        for k in range(9):
            h, ends = (h_spin if k < 3 else h_moment), []
            for sign in (1, -1):
                J, v = [F(x) for x in I], [F(x) for x in w]
                if k < 3: v[k] += sign*h
                elif k < 6: J[k-3] += sign*h
                if k < 6: W, q = Closed(J, v, digits).at(t)
                else: W, q = with_product(J, v, PRODUCTS[k-6], sign*h, t, digits)
                if sum(a*b for a, b in zip(q, Q)) < 0: q = [-x for x in q]
                ends.append((W, q))
            (wa, qa), (wb, qb) = ends
            dq = [(a-b)/(2*M(h)) for a, b in zip(qa, qb)]
            turn = [2*x for x in qmul(dq, qconj(Q))[1:]]
            columns.append([mp.nstr(x, 20) for x in [(a-b)/(2*M(h)) for a, b in zip(wa, wb)] + turn])
    return dict(family=family, inertia=[repr(x) for x in I], w0=[repr(x) for x in w], t=repr(t), columns=columns)

def cases():
    box = [1.0, 2.0, 2.5]
    for k, order in enumerate(itertools.permutations(range(3))):
        signs = [(-1)**(k >> j & 1) for j in range(3)]
        at = lambda v: [v[i] for i in order]
        for spin, t in (([0.3, -0.7, 1.4], 3.7), ([1.3, 0.7, -0.4], -12.0)):
            yield 'box', at(box), [s*x for s, x in zip(signs, at(spin))], t
    yield 'box', box, [0.3, -0.7, 0.4], -120.0
    yield 'box', box, [0.3, -0.7, 0.4], 1e3
    yield 'box, long', box, [0.3, -0.7, 0.4], 1e6
    yield 'box, long', box, [0.3, -0.7, 0.4], 1e12
    yield 'box, short', box, [0.3, -0.7, 0.4], 1e-15
    yield 'box, short', box, [0.3, -0.7, 0.4], 1e-3
    yield 'box, short', box, [0.3, -0.7, 0.4], -0.4
    yield 'box, short', box, [0.3, -0.7, 0.4], 0.9
    yield 'size', [3e-200, 2e-200, 4e-200], [3e80, -1e80, 1e80], 2e-80
    yield 'size', [3e100, 2e100, 4e100], [3e-90, -1e-90, 1e-90], -5e90
    book = [10/12, 13/12, 5/12]
    yield 'push', book, [1.0, 0.01, 0.02], 6.0
    for push, times in ((1e-3, (3.0, 11.2, 14.0, 22.0, 500.0)), (1e-9, (10.0, 33.7, 40.0, -60.0)),
                        (1e-30, (5.0, 107.0, 140.0)), (1e-300, (0.5, 40.0, 1010.0, 1035.0, 1300.0))):
        for t in times:
            yield 'push', book, [1.0, push, 0.3*push], t
    yield 'push', book, [-1.0, 1e-9, -3e-9], 36.0
    yield 'push', book, [-1.0, 0.0, -1e-9], 30.0
    yield 'push', book, [1.0, 1e-9, 0.0], 30.0
    for t in (0.1, 1.5, -3.0, 30.0, 500.0):
        yield 'separatrix', [3.0, 4.0, 6.0], [2.0, 1.0, 1.0], t
    yield 'separatrix', [3.0, 4.0, 6.0], [2e-9, 1.0, 1e-9], 60.0
    yield 'separatrix', [3.0, 4.0, 6.0], [2*2.0**-500, 1.0, 2.0**-500], 800.0
    yield 'wobble', box, [1e-9, 2e-9, 1.0], 7.0
    yield 'wobble', box, [1.0, 3e-9, -2e-9], 70.0
    yield 'wobble', box, [1e-200, -1e-200, 1.0], 7.0
    yield 'wobble', box, [1e-3, -1e-3, 1.0], 1e5
    for e in (1e-3, 1e-6, 1e-12):
        for t in (2.0, -50.0):
            yield 'needle', [e, 1.0, 1.0+e/2], [0.5, 0.3, 0.8], t
            yield 'needle', [1.0, 1.0+e/4, e], [0.02, -0.01, 1.5], t
    for e in (1e-6, 1e-12):
        for t in (0.1, 20.0, 1e4):
            yield 'sleeping needle', [e, 1.0, 1.0+e/2], [1.0, 1e-4, 2e-4], t
    for e in (1e-9, 2.0**-43):
        for t in (0.1, 5.0, 0.3/e, 40.0/e):
            yield 'near-sphere', [1.0, 1.0+e, 1.0+3*e], [0.5, -0.3, 0.8], t
    yield 'near-top', [1.0, 1.0+2.0**-43, 1.5], [0.5, -0.3, 0.8], 9.0
    yield 'near-top', [1.0, 1.0+2.0**-43, 1.5], [0.5, -0.3, 1e-9], 1e5
    yield 'near-top', [1.0, 1.5, 1.5+2.0**-43], [1e-9, -0.3, 0.4], 3.0
    for body in ([1.0, 1.0, 1.5], [2.0, 0.5, 2.0], [1e-6, 1.0, 1.0], [1.0, 1.0+2.0**-40, 1.0]):
        for t in (0.2, 4.0, -300.0):
            yield 'top', body, [0.5, 0.2, 1.0], t
    yield 'top', [1.0, 1.0, 1.5], [0.5, 0.2, 1e-6], 4.0
    yield 'in the plane', [1.0, 1.0, 1.5], [0.5, 0.2, 0.0], 4.0
    yield 'sphere', [2.0, 2.0, 2.0], [0.3, 0.4, -0.5], 3.0
    yield 'sphere', [2.0, 2.0, 2.0], [0.3, 0.4, -0.5], 1e4
    for spin in ([0.0, 0.0, 1.3], [0.0, -2.0, 0.0], [1.1, 0.0, 0.0]):
        for t in (0.1, 5.0, -40.0):
            yield 'steady', box, spin, t
    yield 'steady', [1.0, 1.0, 1.5], [0.0, 1.0, 0.0], 5.0
    yield 'steady', [1.0, 1.0, 1.5], [0.0, 0.0, 1.0], 5.0
    yield 'rest', box, [0.0, 0.0, 0.0], 3.0
    # the moments' columns are small remainders of terms as large as those of the products
    yield 'needle', [2.0480602991468083e-12, 1.0, 1.0000000000014146], [-0.620805568227754, 0.6923344921187007, -0.1152329970619832], 0.8119336625998433
    yield 'needle', [1.0000000119736943, 4.5184663616796454e-8, 1.0], [0.09051529306118544, -0.3603579112541493, 0.8063566284465731], -0.9425014746095595
    yield 'needle', [1.1805812655885705e-6, 1.0, 1.000000307787929], [0.5937148589526784, 0.0859688884216685, 0.2193984299341678], -1.9199198290434394
    yield 'needle', [1.0, 1.000004433731358, 7.586501207093613e-6], [1.0978716530769054e-6, 0.061519755635106144, 3.5800821529415897e-6], -14.476383831188668

def drawn(seed, count):
    "motions at random, hard ones above all"
    draw = random.Random(seed)
    size = lambda low, high: 10**draw.uniform(low, high)
    for _ in range(count):
        kind, share = draw.randrange(6), draw.uniform(0.05, 0.95)
        a, b = draw.uniform(0.2, 1.0), draw.uniform(0.2, 1.0)
        if kind == 0: family, I = 'box', [a, b, abs(a-b) + share*2*min(a, b)]
        if kind == 1: e = size(-12, -1); family, I = 'needle', [e, 1.0, 1.0+e*share]
        if kind == 2: e = size(-14, -2); family, I = 'near-sphere', [1.0, 1.0+e*share, 1.0+e]
        if kind == 3: family, I = 'near-top', [1.0, 1.0+size(-14, -2), 0.5+1.4*share]
        if kind == 4: family, I = 'top', [1.0, 1.0, 0.1+1.8*share]
        if kind == 5: family, I = 'plate', [a, b, (a+b)*(1-size(-14, -2))]
        w = [draw.gauss(0, 1) for _ in range(3)]
        near = draw.randrange(4)
        if near < 3:
            for k in range(3):
                if k != near: w[k] *= size(-12, 0) if draw.random() < 0.8 else size(-40, 0)
        low, mid, high = sorted(I)
        rate = math.sqrt((high-mid)*(mid-low)/(low*high))*max(map(abs, w))
        t = size(-3, 2.5) if draw.random() < 0.5 else size(-2, 2)/max(rate, 1e-16)
        order = draw.sample(range(3), 3)
        yield family + ', drawn', [I[k] for k in order], [w[k] for k in order], draw.choice((t, -t))

if __name__ == '__main__':
    with Pool() as pool:
        rows = pool.map(derivatives, list(cases()) + list(drawn(1, 120)), chunksize=1)
    print(json.dumps(dict(schema="columns: by w0[0..3], by inertia[0..3], by the products Ixy, Ixz, Iyz; each: change of w (body), then of the turn (world)",
                          cases=rows), indent=0))
