"""Lagrange's top from starts next to the vertical, upright and hanging, with a spin across the axis: like `top.json`, by the same two
methods with more digits.

`top-vertical.py` prints the table; each lean is there with both signs.
"""
import json, sys
from fractions import Fraction as Fr
import mpmath as mp
import top

mp.mp.dps = 150
top.ROOTS = 300
LEANS = [0.0, 1e-4, 1e-10, 1e-16, 1e-20, 1e-40]
# A, C, arm, weight; the spin; how the axis lies and the body stands; times.
TOPS = [
    ([1.0, 0.5, 1.0, 2.0], [0.4, -1.1, 1.0], (0.0, 0.0), [1.3, -20.0]),
    ([0.7, 1.1, 0.3, 1.9], [-0.9, 0.2, -2.3], (0.4, 1.9), [-2.1, 300.0]),
    ([1.9, 0.3, 0.6, 0.8], [0.7, 0.6, 12.0], (-2.2, 0.7), [0.9, 1e4]),
]

def attitude(lean, hanging, phi, psi):
    small, large = mp.sin(mp.mpf(lean) / 2), mp.cos(mp.mpf(lean) / 2)
    alpha, beta = (small, large) if hanging else (large, small)
    a, b = alpha * mp.expj((mp.mpf(phi) + psi) / 2), beta * mp.expj((mp.mpf(phi) - psi) / 2)
    return [float(x) for x in (a.real, b.real, b.imag, a.imag)]

def digits(x): return mp.nstr(x, 20, min_fixed=-4, max_fixed=20) if x else '0'

def main():
    rows, worst = [], mp.mpf(0)
    for B, w, place, times in TOPS:
        for hanging in (False, True):
            for lean in LEANS:
                for sign in (1, -1) if lean else (1,):
                    q = attitude(sign * lean, hanging, *place)
                    exact = [[Fr(x) for x in v] for v in (B, q, w)]
                    closed, answers = top.Closed(*exact), []
                    for k, t in enumerate(times):
                        here = closed.at(t)
                        if k == 0:
                            there = top.taylor(*exact, t)
                            off = max(top.norm([x - y for x, y in zip(a, b)]) for a, b in zip(here, there))
                            worst = max(worst, off)
                        kappa = [float(mp.nstr(x, 3)) for x in top.kappas(*exact, t, here)]
                        answers.append([repr(t), *[[digits(x) for x in v] for v in here], *kappa])
                    name = 'hanging' if hanging else 'upright'
                    rows.append([f'{name} {sign * lean:g}', *[[repr(x) for x in v] for v in (B, q, w)], answers])
    print('two methods differ by at most', mp.nstr(worst, 3), 'in', len(rows), 'cases', file=sys.stderr)
    print('[\n' + ',\n'.join(json.dumps(row, separators=(',', ':')) for row in rows) + '\n]')

if __name__ == '__main__': main()
