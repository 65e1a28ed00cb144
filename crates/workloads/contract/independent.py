"""The pinned numbers of the tests, by a second route: plain Python, written from the papers and the documentation alone.

python3 contract/independent.py prints the first outputs of the generator for seed 0, and `name fingerprint` for the
workloads that are short enough to write twice. `src/pinned.rs` must agree.
"""
import struct
from math import isqrt, sqrt

MASK = 2**64 - 1


def fnv(data):
    h = 0xCBF29CE484222325
    for byte in data:
        h = ((h ^ byte) * 0x100000001B3) & MASK
    return h


def rotl(x, k):
    return ((x << k) | (x >> (64 - k))) & MASK


class Rng:
    def __init__(self, seed):
        self.s = []
        for i in range(1, 5):
            z = (seed + i * 0x9E3779B97F4A7C15) & MASK
            z = ((z ^ (z >> 30)) * 0xBF58476D1CE4E5B9) & MASK
            z = ((z ^ (z >> 27)) * 0x94D049BB133111EB) & MASK
            self.s.append(z ^ (z >> 31))

    def next(self):
        s = self.s
        out = (rotl((s[1] * 5) & MASK, 7) * 9) & MASK
        t = (s[1] << 17) & MASK
        s[2] ^= s[0]
        s[3] ^= s[1]
        s[1] ^= s[2]
        s[0] ^= s[3]
        s[2] ^= t
        s[3] = rotl(s[3], 45)
        return out

    def unit(self):
        return (self.next() >> 11) / 2**53

    def below(self, m):
        while True:  # Lemire: reject the low products that would favour some results
            wide = self.next() * m
            if wide % 2**64 >= 2**64 % m:
                return wide >> 64

    def coin(self):
        return self.next() >> 63 == 1

    def shuffle(self, items):
        for last in range(len(items) - 1, 0, -1):
            k = self.below(last + 1)
            items[last], items[k] = items[k], items[last]


def fingerprint(points, segments=()):
    data = b"".join(struct.pack("<d", float(x)) for p in points for x in p)
    return fnv(data + b"".join(struct.pack("<I", v) for s in segments for v in s))


def square(n):
    k = isqrt(n - 1) + 1
    return [(i % k, i // k) for i in range(n)]


def ladder(n):
    m = n // 2
    points = [p for i in range(m) for p in ((0, i), (max(1, m // 4), i + m // 2))]
    return points, [(2 * i, 2 * i + 1) for i in range(m)]


def nested(n):
    ring = [(5, 0), (4, 3), (3, 4), (0, 5), (-3, 4), (-4, 3), (-5, 0), (-4, -3), (-3, -4), (0, -5), (3, -4), (4, -3)]
    sizes = ([(1, n % 12)] if n % 12 else []) + [(k + 2, 12) for k in range(n // 12)]
    points, segments = [], []
    for scale, corners in sizes:
        first = len(points)
        points += [(scale * x, scale * y) for x, y in ring[:corners]]
        segments += [(first + i, first + i + 1) for i in range(corners - 1)] + [(first + corners - 1, first)]
    return points, segments


def soup(n, rng):
    points = [(rng.unit(), rng.unit()) for _ in range(n // 2 * 2)]
    return points, [(i, i + 1) for i in range(0, len(points), 2)]


def kuzmin(n, rng):
    points = []
    for _ in range(n):
        rest = 1.0 - rng.unit()
        r = sqrt(1.0 / (rest * rest) - 1.0)
        while True:
            x, y = -1.0 + 2.0 * rng.unit(), -1.0 + 2.0 * rng.unit()
            if 1e-6 < x * x + y * y <= 1.0:
                break
        d = sqrt(x * x + y * y)
        points.append((r * (x / d), r * (y / d)))
    return points


def shuttle(n):
    strip, points = -(-n // 2), []
    for i in range(strip):
        points.append((i // 2, i % 2))
    for j in range(n // 2):
        points.append((-(1 + j // 2), 0.5) if j % 2 == 0 else (strip + 1 + j // 2, 0.5))
    return points


def column(n, rng):
    places = list(range(n))
    rng.shuffle(places)
    return [(x, i * n) for i, x in enumerate(places)]


def beach(n, rng):
    row, places = -(-n // 2), list(range(n // 2))
    rng.shuffle(places)
    return [(i, 0) for i in range(row)] + [(x + 0.5, 1 + j / n) for j, x in enumerate(places)]


def wheel(n, rng):
    # Gaussian integers of one norm: for each prime 1 mod 4 a square, the norm, or the conjugate's square.
    rim = [1, 1j, -1, -1j]
    for z in (1 + 2j, 2 + 3j, 1 + 4j, 2 + 5j, 1 + 6j, 4 + 5j, 2 + 7j, 5 + 6j, 3 + 8j, 5 + 8j):
        if len(rim) >= n - 1:
            break
        factors = (z * z, z * z.conjugate(), z.conjugate() * z.conjugate())
        rim = [p * f for p in rim for f in factors]
    rng.shuffle(rim)
    return [(0, 0)] + [(p.real + 0.0, p.imag + 0.0) for p in rim[: n - 1]]


def independent(name, n, rng):
    s = square(n)
    return {
        "uniform": lambda: ([(rng.unit(), rng.unit()) for _ in range(n)],),
        "uniform-3d": lambda: ([(rng.unit(), rng.unit(), rng.unit()) for _ in range(n)],),
        "kuzmin": lambda: (kuzmin(n, rng),),
        "grid": lambda: (s,),
        "grid-tilted": lambda: ([((3 * x - 4 * y) / 5, (4 * x + 3 * y) / 5) for x, y in s],),
        "grid-tilted-exact": lambda: ([(3 * x - 4 * y, 4 * x + 3 * y) for x, y in s],),
        "hexagonal": lambda: ([(x + y % 2 / 2, y * (sqrt(3) / 2)) for x, y in s],),
        "line-inexact": lambda: ([(x, x / 3 + 0.1) for x in (rng.unit() for _ in range(n))],),
        "parabola": lambda: ([(i - n // 2, (i - n // 2) ** 2) for i in range(n)],),
        "moment-curve": lambda: ([(i, i * i, i**3) for i in range(n)],),
        "falling-sites": lambda: (
            [(i - n // 4, 0) for i in range(-(-n // 2))] + [(0, 4 * n - j) for j in range(n // 2)],
        ),
        "shuttle": lambda: (shuttle(n),),
        "shuffled-column": lambda: (column(n, rng),),
        "beach": lambda: (beach(n, rng),),
        "wheel": lambda: (wheel(n, rng),),
        "scaled-tiny": lambda: ([(rng.unit() * 2.0**-900, rng.unit() * 2.0**-900) for _ in range(n)],),
        "crossing-soup": lambda: soup(n, rng),
        "ladder": lambda: ladder(n),
        "nested-polygons": lambda: nested(n),
    }


if __name__ == "__main__":
    rng = Rng(0)
    print("stream", *(hex(rng.next()) for _ in range(4)))
    for name in sorted(independent("", 100, rng)):
        made = independent(name, 100, Rng(fnv(name.encode()) ^ 7))[name]()
        print(name, f"{fingerprint(*made):#018x}")
