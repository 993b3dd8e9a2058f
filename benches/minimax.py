"""Finds the coefficients of the power in src/number/power.rs in single precision, and prints them with their errors; then
the errors of those that the file has in double precision, and the coefficients of the arctangent in src/number/elementary.rs.

    log2 z    = s P(s^2),              s = (z - 1)/(z + 1),   z in [sqrt(1/2), sqrt(2)],  P of degree 2
    2^(1 + r) = (2 + r) + r Q(r),                             r in [-1/2, 1/2],           Q of degree 5

Each is a minimax polynomial by Lawson's iteration: weighted least squares, each point's weight multiplied
by its error until the error is level. Its coefficients are then rounded to f32 one after the other, the rest
fitted anew after each, both neighbors tried. Of these candidates the one is kept whose error, when
computed in f32 with every rounding, is least. Needs numpy and mpmath; takes half a minute.
"""
import re
from pathlib import Path
from decimal import Decimal, getcontext

import mpmath
import numpy as np

F = np.float32
U = 2.0**-24
ROOT_HALF = 0x3F3504F3


def horner(p, x):
    total = p[-1]
    for c in p[-2::-1]:
        total = c + x * total
    return total


def fit(x, y, weight, degree, rounds=100):
    """The polynomial p, constant first, that makes max |weight (p(x) - y)| least, and that maximum."""
    powers = np.vander(x, degree + 1, increasing=True) * weight[:, None]
    scale = np.abs(powers).max(axis=0)
    powers, target = powers / scale, y * weight
    lawson, best = np.full(len(x), 1 / len(x)), (None, np.inf)
    for _ in range(rounds):
        root = np.sqrt(lawson)
        p = np.linalg.lstsq(powers * root[:, None], target * root, rcond=None)[0]
        error = np.abs(powers @ p - target)
        if error.max() < best[1]:
            best = (p / scale, error.max())
        lawson *= error + 1e-30
        lawson /= lawson.sum()
    return best


def candidates(x, y, weight, degree, fixed=()):
    """Every way of rounding the coefficients, in order, to one of the two neighbours in f32."""
    if degree < 0:
        yield fixed
        return
    c = fit(x, y, weight, degree)[0][0]
    below = F(c) if F(c) <= c else np.nextafter(F(c), F(-np.inf))
    for k in (below, np.nextafter(below, F(np.inf))):
        yield from candidates(x, (y - float(k)) / x, weight * x, degree - 1, fixed + (k,))


def search(name, x, y, weight, degree, computed):
    unrounded = fit(x, y, weight, degree, 300)[1]
    p = min(candidates(x, y, weight, degree), key=computed)
    rounded = np.abs(weight * (horner([float(c) for c in p], x) - y)).max()
    print(f"{name}, degree {degree}: error {unrounded / U:.3f} as found, {rounded / U:.3f} with rounded coefficients,"
          f" {computed(p) / U:.3f} computed in f32")
    for c in p:
        print(f"    {str(c):14} 0x{int(c.view(np.uint32)):08X}")


def logarithm(degree):
    """The relative error of log2 x, for x <= 1: above 1, z stands for x = z/2, whose log2 is log2 z - 1."""
    x = (3 - 2 * np.sqrt(2)) ** 2 * (1 + np.cos(np.linspace(0, np.pi, 800))) / 2 + 1e-9  # s^2
    s = np.sqrt(x)
    y = 2 / np.log(2) * np.arctanh(s) / s
    weight = s / np.minimum(s * y, 1 - s * y)  # of log2 z beside |log2 x|, below and above 1
    z = np.arange(ROOT_HALF, ROOT_HALF + (1 << 23), 3, dtype=np.uint32).view(F)
    z = z[z != 1]
    quotient, exponent = (z - F(1)) / (z + F(1)), np.where(z < 1, F(0), F(-1))
    true = np.log2(z.astype(float)) + exponent

    def computed(p):
        # by Horner's scheme, for which these were chosen; in pairs, as the source sums them, it is 5.8 u
        return np.abs((exponent + quotient * horner(p, quotient * quotient)) / true - 1).max()

    search("log2, relative", x, y, weight, degree, computed)


def exponential(degree):
    """The absolute error of 2^y, for y <= 0: a positive r has an integer of -1 or less beside it."""
    def part(r):
        return np.where(r < 0, 0.5, 0.25)  # of 2^(1 + r)

    r = np.cos(np.linspace(0, np.pi, 1500)) / 2
    r = r[np.abs(r) > 1e-4]
    y = (2 * np.exp2(r) - 2 - r) / r
    weight = part(r) * np.abs(r)
    grid = np.linspace(-0.5, 0.5, 2**20 + 1).astype(F)
    true = 2 * np.exp2(grid.astype(float))

    def computed(p):
        pairs = [p[k] + p[k + 1] * grid for k in (0, 2, 4)]
        q = pairs[0] + grid * grid * pairs[1] + grid * grid * (grid * grid) * pairs[2]
        return np.abs(part(grid) * ((F(2) + grid) + grid * q - true)).max()

    search("exp2, absolute", r, y, weight, degree, computed)


def double():
    """The relative errors of log2 c and of 2^(1 + r) = 2 + 4r/(Q(r^2) - r), with the coefficients of the source and no rounding."""
    mpmath.mp.prec = 160
    source = (Path(__file__).parent / "../src/number/power.rs").read_text()

    def coefficients(name):
        numbers = re.search(name + r": \[f64; \d\] = \[(.*?)\]", source, re.S)[1]
        return [mpmath.mpf(float(x.replace("_", ""))) for x in re.findall(r"[-\d._e]+", numbers)]

    def error_of_log(p, s):
        true = 2 / mpmath.log(2) * mpmath.atanh(s)
        return abs(s * horner(p, s * s) - true) / min(true, 1 - true)  # beside |log2 c| below and above 1

    def error_of_exp(q, r):
        return abs((2 + 4 * r / (horner(q, r * r) - r)) / (2 * mpmath.mpf(2) ** r) - 1)

    p, q = coefficients("LOG_DOUBLE"), coefficients("EXP_DOUBLE")
    largest = 3 - 2 * mpmath.sqrt(2)
    log = max(error_of_log(p, largest * k / 4000) for k in range(1, 4000))
    exp = max(error_of_exp(q, mpmath.mpf(k) / 8000) for k in range(-4000, 4001) if k != 0)
    print(f"double: log2 2^{float(mpmath.log(log, 2)):.2f}, exp2 2^{float(mpmath.log(exp, 2)):.2f}")


def arctangent(terms):
    """The coefficients of t, t^3, ... in the first terms of 2 sum (-1)^k tau^(2k + 1)/(2k + 1) T_(2k + 1)(t/s),
    where s = tan(pi/8) and tau = tan(pi/16)."""
    getcontext().prec = 60
    s = Decimal(2).sqrt() - 1
    tau = ((1 + s * s).sqrt() - 1) / s
    sums = [Decimal(0)] * (2 * terms)
    before, polynomial = [1], [0, 1]  # T_0 and T_1, constant first
    for n in range(1, 2 * terms):
        if n % 2 == 1:
            weight = 2 * (-1) ** (n // 2) * tau**n / n
            sums = [a + weight * b / s**i for i, (a, b) in enumerate(zip(sums, polynomial + [0] * (2 * terms)))]
        doubled = [0] + [2 * c for c in polynomial]
        following = [a - b for a, b in zip(doubled, before + [0, 0])]
        before, polynomial = polynomial, following
    print(f"arctan, {terms} terms:")
    for c in sums[1::2]:
        print(f"    {float(c)!r}")


logarithm(2)
exponential(5)
double()
arctangent(12)
