"""Free motions of bodies from the whole triangle of moments, for the figure `exact-errors`.

    PYTHONPATH=tests/data python3 crates/measure/data/errors.py > crates/measure/record/errors.json

The triangle of all bodies (I1/I3 across, I2/I3 up) is cut into SIDE² equal small ones. Of each, the body at its
centre; of those along an edge, also one a hair inside the edge (a plate, a top); of those in a corner, also one
a hair inside the corner (a needle, a disk, a ball). Each is spun three ways, and asked at two times.
The truth is computed with mpmath by tests/data/oracle.py, its conditioning as in sweep.py there."""
import json, random, sys
from fractions import Fraction as Fr
import sweep

SIDE = 10
CORNERS = [(Fr(0), Fr(1)), (Fr(1, 2), Fr(1, 2)), (Fr(1), Fr(1))]  # needle, disk, ball

def blend(weights):
    "the pair of ratios with these shares of the three corners"
    total = sum(weights)
    return [sum(w*c[k] for w, c in zip(weights, CORNERS))/total for k in range(2)]

def cells():
    "place (row, column, up or down) and the shares of the corners at the centre, in thirds of 1/SIDE"
    for row in range(SIDE):
        for column in range(SIDE - row):
            yield (row, column, 0), [3*row + 1, 3*column + 1, 3*(SIDE - row - column) - 2]
            if row + column < SIDE - 1:
                yield (row, column, 1), [3*row + 2, 3*column + 2, 3*(SIDE - row - column) - 4]

def bodies(rng):
    for place, centre in cells():
        yield place, blend(centre)
        if place[2] == 1: continue
        sides = [k for k in range(3) if centre[k] == 1]
        hair = lambda: Fr(10**rng.uniform(-15, -3))
        for k in sides:
            yield place, blend([hair() if j == k else Fr(c) for j, c in enumerate(centre)])
        if len(sides) == 2:
            yield place, blend([hair() if j in sides else Fr(1) for j in range(3)])

def possible(x, y):
    "rounded so that it is still a body, with three different moments"
    I = [float(x), float(y), 1.0]
    s = [Fr(v) for v in I]
    return I if 0 < s[0] < s[1] < s[2] and s[0] + s[1] > s[2] else None

def main():
    rng = random.Random(4)
    out = []
    for place, (x, y) in bodies(rng):
        I = possible(x, y)
        if I is None: continue
        for kind in ('generic', 'flip', 'near-separatrix'):
            w = sweep.spin(rng, kind, I)
            turns = [rng.choice([-1, 1])*t for t in (rng.uniform(0.1, 1), rng.uniform(1, 30))]
            c = sweep.case(kind, I, w, turns, rng)
            out.append(dict(cell=list(place), spin=kind, inertia=c['inertia'], w0=c['w0'], t=c['t'],
                            w=[[short(v) for v in r] for r in c['w']], q=[[short(v) for v in r] for r in c['q']],
                            kappa_w=c['kappas_w'], kappa_q=c['kappas_q']))
        print(place, file=sys.stderr)
    rows = ',\n'.join(json.dumps(c, separators=(',', ':')) for c in out)
    print('{"about":"errors.py: SIDE %d, 20 digits","side":%d,"cases":[\n%s\n]}' % (SIDE, SIDE, rows))

def short(text):
    with sweep.mp.workdps(50): return sweep.mp.nstr(sweep.mp.mpf(text), 20)

if __name__ == '__main__': main()
