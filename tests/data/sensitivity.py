"""Derivatives of free motions by the spin at the start and by the moments, to 20 digits.

    python3 sensitivity.py > sensitivity.json

Symmetric differences of the closed form (oracle.py) at a distance of 1e-40, with 160 digits. The turn is the
rotation vector in the world, twice the imaginary part of dq conj(q)."""
import json
from fractions import Fraction as Fr
import mpmath as mp
from oracle import Closed, F, M, qmul, qconj

H = Fr(1, 10**40)
CASES = [([1.0, 2.0, 2.5], [0.3, -0.7, 0.4], 3.7), ([10/12, 13/12, 5/12], [1.0, 0.01, 0.02], 6.0),
         ([3.0, 4.0, 6.0], [2.0, 1.0, 1.0], 1.5), ([1.0, 1.0, 1.5], [0.5, 0.2, 1.0], 4.0),
         ([2.0, 2.0, 2.0], [0.3, 0.4, -0.5], 3.0), ([1.0, 2.0, 2.5], [0.0, 0.0, 1.3], 5.0),
         ([1.0, 2.0, 2.5], [0.0, 2.0, 0.0], 2.0), ([0.001, 1.0, 1.0005], [0.5, 0.3, 0.8], 2.0),
         ([1.0, 2.0, 2.5], [0.3, -0.7, 0.4], -120.0)]
rows = []
for I, w, t in CASES:
    base = Closed(I, w, 160)
    with mp.workdps(160):
        W, Q = base.at(t)
        columns = []
        for k in range(6):
            ends = []
            for sign in (1, -1):
                J, v = [F(x) for x in I], [F(x) for x in w]
                if k < 3: v[k] += sign*H
                else: J[k-3] += sign*H
                ends.append(Closed(J, v, 160).at(t))
            (wa, qa), (wb, qb) = ends
            if sum(a*b for a, b in zip(qa, qb)) < 0: qb = [-x for x in qb]
            if sum(a*b for a, b in zip(qa, Q)) < 0: qa, qb = [-x for x in qa], [-x for x in qb]
            h = 2*M(H)
            dq = [(a-b)/h for a, b in zip(qa, qb)]
            turn = [2*x for x in qmul(dq, qconj(Q))[1:]]
            columns.append([mp.nstr(x, 20) for x in [(a-b)/h for a, b in zip(wa, wb)] + turn])
        rows.append(dict(inertia=[repr(x) for x in I], w0=[repr(x) for x in w], t=repr(t), columns=columns))
print(json.dumps(dict(schema="columns: by w0[0..3], then by inertia[0..3]; each: change of w (body), then of the turn (world)",
                      cases=rows), indent=0))
