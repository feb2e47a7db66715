"""Jacobi's functions, K and Carlson's R_F to 25 digits, from k' (binary64, taken exactly).

    python3 elliptic.py > elliptic.json

mpmath; the digits lost in m = 1 - k'^2 are covered by working with 1400 of them."""
import json, random
import mpmath as mp

mp.mp.dps = 1400
rng = random.Random(4)
text = lambda x: mp.nstr(x, 25, min_fixed=-5, max_fixed=20)
rows, integrals = [], []
complements = [1e-300, 1e-160, 1e-50, 1e-17, 1e-8, 1e-3, 0.05, 0.2, 0.4, 0.47, 0.4917, 0.51, 0.6, 0.75, 0.9, 0.99, 1 - 1e-9, 1.0]
for kp in complements:
    m = 1 - mp.mpf(kp)**2
    K = mp.ellipk(m)
    # Near the flip, near the saddle, beyond both, negative.
    for part in (1e-9, 0.1, 0.3, 0.499, 0.6, 0.9, 0.9999, 1.0 + 1e-6, 1.7, 2.3, -0.7, -3.2, 5.5, 41.3):
        u = float(K*part)
        s, c, d = [mp.ellipfun(f, mp.mpf(u), m=m) for f in ('sn', 'cn', 'dn')]
        rows.append([repr(kp), repr(u), text(s), text(c), text(d)])
    integrals.append([repr(kp), text(K)])
carlson = []
for _ in range(40):
    x, y, z = [10**rng.uniform(-9, 3) for _ in range(3)]
    carlson.append([repr(x), repr(y), repr(z), text(mp.elliprf(x, y, z))])
carlson.append(['0.0', '1.0', '2.0', text(mp.elliprf(0, 1, 2))])
print(json.dumps(dict(schema="jacobi: k', u, sn, cn, dn; complete: k', K; carlson_rf: x, y, z, R_F",
                      jacobi=rows, complete=integrals, carlson_rf=carlson), indent=0))
