"""Finds the coefficients of src/power.rs and prints them with their errors.

    log2 z    = s P(s^2),    s = (z - 1)/(z + 1),   z in [2/3, 4/3],    P of degree 3
    2^(1 + r) = 2 + r Q(r),                         r in [-1/2, 1/2],   Q of degree 5

Each is a minimax polynomial by Lawson's iteration: weighted least squares, each point's weight multiplied
by its error until the error is level. Its coefficients are then rounded to f32 one after the other, the rest
fitted anew after each, both neighbours tried. Of these candidates the one is kept whose error, when
computed in f32 with every rounding, is least. Needs numpy alone; takes a few seconds.
"""
import numpy as np

F = np.float32
U = 2.0**-24
TWO_THIRDS = 0x3F2AAAAB


def horner(p, x):
    total = p[-1]
    for c in p[-2::-1]:
        total = c + x * total
    return total


def fit(x, y, weight, degree, rounds=60):
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
    v = (1 + np.cos(np.linspace(0, np.pi, 800))) / 50 + 1e-9  # s^2, from 0 to 1/25
    y = 2 / np.log(2) * np.arctanh(np.sqrt(v)) / np.sqrt(v)
    z = np.arange(TWO_THIRDS, TWO_THIRDS + (1 << 23), 3, dtype=np.uint32).view(F)
    z = z[z != 1]
    s, exponent = (z - F(1)) / (z + F(1)), np.where(z < 1, F(0), F(-1))
    true = np.log2(z.astype(float)) + exponent

    def computed(p):
        return np.abs((exponent + s * horner(p, s * s)) / true - 1).max()

    search("log2, relative", v, y, 1 / y, degree, computed)


def exponential(degree):
    """The absolute error of 2^y, for y <= 0: a positive r has an integer of -1 or less beside it."""
    def part(r):
        return np.where(r < 0, 0.5, 0.25)  # of 2^(1 + r)

    r = np.cos(np.linspace(0, np.pi, 1200)) / 2
    grid = np.linspace(-0.5, 0.5, 400_001).astype(F)
    true = 2 * np.exp2(grid.astype(float))

    def computed(p):
        return np.abs(part(grid) * (F(2) + grid * horner(p, grid) - true)).max()

    search("exp2, absolute", r, 2 * np.expm1(r * np.log(2)) / r, part(r) * np.abs(r), degree, computed)


for d in (2, 3):
    logarithm(d)
for d in (4, 5):
    exponential(d)
