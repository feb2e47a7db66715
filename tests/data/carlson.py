"""Carlson's R_F to 25 digits, by mpmath.

    python3 carlson.py > carlson.json
"""
import json, random
import mpmath as mp

mp.mp.dps = 60
rng = random.Random(4)
text = lambda x: mp.nstr(x, 25, min_fixed=-5, max_fixed=20)
carlson = []
for _ in range(40):
    x, y, z = [10**rng.uniform(-9, 3) for _ in range(3)]
    carlson.append([repr(x), repr(y), repr(z), text(mp.elliprf(x, y, z))])
carlson.append(['0.0', '1.0', '2.0', text(mp.elliprf(0, 1, 2))])
print(json.dumps(carlson, indent=0))
