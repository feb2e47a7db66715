"""Writes sympy_tables.txt: operations on random polynomials and fractions, done by sympy.

    pip install sympy==1.14.0
    python sympy_tables.py > sympy_tables.txt

Each line is `operation | argument | ... | result`, in the plain notation that the crate reads. The seed is
fixed, so the same sympy writes the same table.
"""
import random
import sympy as sp

random.seed(20261121)
X = sp.symbols("x y z")


def number():
    return sp.Rational(random.randint(-9, 9), random.randint(1, 7))


def polynomial(terms=4, top=3):
    p = sum((number() * sp.prod(v ** random.randint(0, top) for v in X) for _ in range(terms)), sp.S.Zero)
    return sp.expand(p)


def nonzero(**how):
    while True:
        p = polynomial(**how)
        if p != 0:
            return p


def write(operation, *parts):
    print(" | ".join([operation] + [str(p).replace("**", "^") for p in parts]))


for _ in range(25):
    p, q, r = polynomial(), polynomial(), nonzero(terms=2, top=1)
    v, w = random.sample(X, 2)
    write("sum", p, q, sp.expand(p + q))
    write("product", p, q, sp.expand(p * q))
    write("quotient", sp.expand(p * r), r, p)
    write("derivative", p, v, sp.expand(sp.diff(p, v)))
    a, b = polynomial(2, 1).subs(v, w), number()
    write("integral", p, v, a, b, sp.expand(sp.integrate(p, (v, a, b))))
    write("substitute", p, v, q, sp.expand(p.subs(v, q)))
    write("remainder", p, v, a, sp.expand(sp.rem(p, v**2 - a, v)))
    f, g = nonzero(terms=2, top=2) / nonzero(terms=2, top=1), polynomial(2, 2) / nonzero(terms=2, top=1)
    write("fraction sum", f, g, sp.cancel(sp.together(f + g)))
    write("fraction quotient", g, f, sp.cancel(g / f))
    write("fraction derivative", f, v, sp.cancel(sp.diff(f, v)))
for _ in range(10):
    h = sp.symbols("h")
    top = polynomial(3, 1) + h * polynomial(2, 1) + h**2 * number()
    bottom = random.randint(1, 5) + h * polynomial(2, 1) + h**3 * polynomial(1, 1)
    expansion = sp.series(top / bottom, h, 0, 5).removeO()
    write("series", sp.expand(top), sp.expand(bottom), *(sp.expand(expansion.coeff(h, n)) for n in range(5)))
