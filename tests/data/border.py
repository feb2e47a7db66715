"""The constants and sums of both series next to the border K'/K = 0.775, to 40 digits, from whole theta series (mpmath).

    python3 border.py > border.json

Nomes and arguments are binary64, taken exactly. Sums are without the factors that the library leaves out, as in (C14), (C15), (C22),
(C23), (C28) and (C32) of the chapter on the closed form, but with all their terms. Jacobi's functions made of them are held to mpmath's own.
"""
import json
import mpmath as mp
from mpmath import mpf

mp.mp.dps = 60
BORDER, NOMES = mpf('0.775'), 24
whole = range(-12, 13)
half = range(0, 13)

def text(x): return mp.nstr(x, 40, strip_zeros=True) if x else '0'

def sign(n): return -1 if n % 2 else 1

def direct(q, c):
    "theta_3, theta_4, and theta_2, theta_1 over 2 q^(1/4) cos z and sin z; then what makes sn, cn, dn"
    def sums(z):
        even = [mp.fsum(s**n * q**(n * n) * mp.cos(2 * n * z) for n in whole) for s in (1, -1)]
        # As limits where cos z or sin z is zero.
        odd = lambda f, s, z: mp.fsum(s**n * q**(n * n + n) * f((2 * n + 1) * z) for n in half) / f(z)
        return even + [odd(mp.cos, 1, z), odd(mp.sin, -1, z) if z else mp.fsum((-1)**n * (2 * n + 1) * q**(n * n + n) for n in half)]
    third, fourth, second, _ = sums(mpf(0))
    return sums(mp.acos(c) / 2), [third / second, fourth / second, fourth / third]

def direct_pair(q, depth, z):
    "a and b of the theta zero, with b as long as a at the saddle; and the rate of the angle of a by z where z is 0"
    wave = lambda z: mp.fsum(sign(n) * q**(2 * n * n) * mp.expj(2 * n * z) for n in whole)
    # The first theta function, over a factor.
    other = lambda z: mp.fsum(sign(n) * q**(2 * n * (n + 1)) * mp.sin((2 * n + 1) * z) for n in half)
    at = lambda z: mp.mpc(z, -depth / 2)
    a, b = wave(at(z)), other(at(z))
    saddle = mp.pi / 2
    b *= abs(wave(at(saddle))) / abs(other(at(saddle)))
    rate = mp.fsum(sign(n) * q**(2 * n * n) * 2 * n * mp.exp(n * depth) for n in whole) / wave(at(mpf(0))).real
    return [a.real, a.imag, b.real, b.imag], rate

def complementary(root, x):
    "the four sums without their first exponential, then what makes sn, cn, dn near the crossing and near the saddle, for k' = 1"
    p, v = root * root, mp.exp(-2 * x)
    odd = lambda s: mp.fsum(s**n * p**(n * n + n) * v**(-n) * (1 + s * v**(2 * n + 1)) for n in half)
    even = lambda s: mp.fsum(s**n * p**(n * n) * v**n for n in whole)
    second = mp.fsum(p**(n * n + n) for n in half)
    third, fourth = [mp.fsum(s**n * p**(n * n) for n in whole) for s in (1, -1)]
    near = [third / fourth, second / fourth, second / third]
    far = [third / fourth, third**2 / (fourth * second), third / second]
    return [odd(-1), odd(1), even(-1), even(1)], near, far

def complementary_pair(p, phi, e):
    "a and b, with b as long as a at the saddle; the angle of a there, and its rate by x"
    def pair(e):
        c, d = [lambda n, f=f: f((2 * n + 1) * phi) for f in (mp.cos, mp.sin)]
        up, down = [lambda n, e=x: p**(n * n + n) * e(n) for x in (lambda n: e**-n, lambda n: e**(n + 1))]
        a = [mp.fsum(c(n) * (up(n) + down(n)) for n in half), -mp.fsum(d(n) * (up(n) - down(n)) for n in half)]
        b = [mp.fsum(sign(n) * c(n) * (up(n) - down(n)) for n in half), -mp.fsum(sign(n) * d(n) * (up(n) + down(n)) for n in half)]
        return mp.mpc(*a), mp.mpc(*b)
    (a, b), (sa, sb) = pair(e), pair(p)
    b *= abs(sa) / abs(sb)
    # By x = -log e.
    rate = mp.diff(lambda x: mp.arg(pair(mp.exp(-x))[0]), -mp.log(p))
    return [a.real, a.imag, b.real, b.imag], mp.arg(sa), rate

def jacobi_agree(q, z):
    "the sums make mpmath's sn, cn, dn"
    m = mp.mfrom(q=q)
    K, other = mp.ellipk(m), mp.ellipk(1 - m)
    u = 2 * K * z / mp.pi
    truth = [mp.ellipfun(f, u, m=m) for f in ('sn', 'cn', 'dn')]
    (third, fourth, second, first), f = direct(q, mp.cos(2 * z))
    ours = [f[0] * mp.sin(z) * first / fourth, f[1] * mp.cos(z) * second / fourth, f[2] * third / fourth]
    root, x = mp.exp(-mp.pi * K / (2 * other)), mp.pi * u / (2 * other)
    (sine, cosine, alternating, plain), near, _ = complementary(root, x)
    e = mp.exp(-x)
    theirs = [near[0] * sine / cosine, 2 * e * near[1] * alternating / cosine, 2 * e * near[2] * plain / cosine]
    assert max(abs(a - b) for t in (ours, theirs) for a, b in zip(t, truth)) < mpf(10)**-45

def main():
    table = {'direct': [], 'direct_pair': [], 'complementary': [], 'complementary_pair': []}
    for n in range(NOMES):
        # On either side, from the border on: a hundredth of its nome each.
        q = mpf(float(mp.exp(-mp.pi * BORDER) * (1 - mpf(n) / 100)))
        root = mpf(float(mp.exp(-mp.pi / (2 * BORDER)) * (1 - mpf(n) / 200)))
        jacobi_agree(q, mpf(n + 1) / 20)
        c = [mpf(1), mpf('0.3125'), mpf('-0.8125')][n % 3]
        table['direct'].append([q, c, *direct(q, c)])
        z, depth = mpf(float(mpf(n + 1) / 16)), mpf(float(mpf(n % 8 + 1) * mpf('0.28')))
        sin, cos = [mpf(float(f(z))) for f in (mp.sin, mp.cos)]
        table['direct_pair'].append([q, depth, sin, cos, *direct_pair(q, depth, mp.atan2(sin, cos))])
        x = mpf(float(-mp.log(root) * (n + 1) / 48))
        table['complementary'].append([root, x, *complementary(root, x)])
        phi, e = mpf(float(mpf(n % 8 + 1) * mpf('0.09'))), mpf(float(root ** (mpf(n + 1) / 24)))
        table['complementary_pair'].append([root, phi, e, *complementary_pair(root, phi, e)])
    flat = lambda x: [flat(y) for y in x] if isinstance(x, list) else text(x)
    print('{')
    print(',\n'.join(f'"{name}": [\n' + ',\n'.join(json.dumps(flat(row), separators=(',', ':')) for row in rows) + '\n]' for name, rows in table.items()))
    print('}')

if __name__ == '__main__': main()
