"""Writes elementary-functions.csv: elementary functions to 600 digits, by mpmath 1.3.

    python3 elementary-functions.py [NUMBER] > elementary-functions.csv

A line has the function's name, its arguments and its value as bits of binary64 in hexadecimal, and what the value's
rounding left off, in units in the last place.
"""
import math
import random
import struct
import sys

import mpmath
from mpmath import mpf

mpmath.mp.dps = 600  # of which the largest angles lose 308 to whole turns
random.seed(14)
NUMBER = int(sys.argv[1]) if len(sys.argv) > 1 else 15


def bits(x):
    return struct.pack(">d", x).hex()


def rounded(value):
    """The nearest binary64, also among subnormal numbers, and the rest in units in the last place."""
    if value == 0:
        return 0.0, 0.0
    _, exponent = mpmath.frexp(value)
    unit = mpf(2) ** max(exponent - 53, -1074)
    number = mpmath.nint(value / unit) * unit
    if abs(number) >= mpf(2) ** 1024:
        return math.copysign(math.inf, value), 0.0
    number = float(number)
    return number, float((value - number) / mpf(math.ulp(number)))


def signed(x):
    return random.choice([-1, 1]) * x


def any_size(low=-1074, high=1023):
    return math.ldexp(random.uniform(1, 2), random.randint(low, high))


def near_multiples():
    """Numbers of 53 bits next to multiples of a quarter turn: denominators of the continued fraction of their unit in quarter turns."""
    for power in range(0, 971, 31):
        ratio = mpmath.pi / 2 / mpf(2) ** power
        rest = 1 / ratio
        p0, p1, q0, q1 = 0, 1, 1, 0
        for _ in range(200):
            whole = int(mpmath.floor(rest))
            p0, p1 = p1, whole * p1 + p0
            q0, q1 = q1, whole * q1 + q0
            if q1 >= 2**53:
                break
            if q1 >= 2**40:
                yield math.ldexp(q1, power)
            rest = 1 / (rest - whole)


HARD = [6381956970095103.0 * 2.0**797, 5.0e-324, 2.2e-308, 0.5, 1.0, math.pi, math.pi / 2, math.pi / 4, 1.7976931348623157e308]


def angles():
    yield from HARD
    for k in range(1, 12):
        yield k * math.pi / 4
    yield from near_multiples()
    for _ in range(NUMBER):
        yield signed(random.uniform(0, 1))
        yield signed(random.uniform(0, 100))
        yield signed(any_size())


def exponents():
    yield from [0.34657, -0.34657, 0.3466, 709.7827128933840, 709.78271289338403, 710.4, -708.4, -744.44, -745.13, -746.0, 5e-324, 1e-300]
    for _ in range(NUMBER):
        yield signed(random.uniform(0, 1))
        yield signed(random.uniform(0, 745))
        yield signed(any_size(-60, 9))


def positive():
    yield from [1.0, 2.0, 31.999999999999996, 32.0, 5e-324, 2.2e-308, 1.7976931348623157e308]
    for _ in range(NUMBER):
        yield random.uniform(1, 32)
        yield any_size()


def pairs():
    yield from [(1.0, 1.0), (5e-324, 5e-324), (1.7e308, 1.7e308), (1e-300, 1e300), (1e300, -1e-300), (3e-324, 1e308)]
    for _ in range(NUMBER):
        yield signed(random.uniform(0, 1)), signed(random.uniform(0, 1))
        size = any_size()
        yield signed(size * random.uniform(0, 1)), signed(size)
        yield signed(any_size()), signed(any_size())


def line(name, arguments, value):
    number, rest = rounded(value)
    print(name, *map(bits, [*arguments, number]), f"{rest:.4f}", sep=",")


for x in angles():
    line("sin", [x], mpmath.sin(mpf(x)))
    line("cos", [x], mpmath.cos(mpf(x)))
for x in [*(y for y in (abs(a) for a in angles()) if y < 1), 0.6, 0.6168, 0.617]:
    root = mpmath.sqrt(mpf(x))
    line("cos_of_root", [x], mpmath.cos(root))
    line("sinc_of_root", [x], mpmath.sin(root) / root)
for x in exponents():
    for name in ["exp", "expm1", "sinh", "cosh"]:
        line(name, [x], getattr(mpmath, name)(mpf(x)))
for y, x in pairs():
    line("atan2", [y, x], mpmath.atan2(mpf(y), mpf(x)))
    line("hypot", [y, x], mpmath.hypot(mpf(y), mpf(x)))
