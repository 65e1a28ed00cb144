"""Gudhi's alpha complexes behind a pipe: an opponent for the tests of alpha values. See src/gudhi.rs.

First it says `gudhi VERSION`. In: requests, until the end of input.
  alpha D N W   then N lines of D coordinates, and a weight if W is 1; each the 16 hexadecimal digits of the double's bits
Out: ok K, then K lines: the vertices of a simplex in order, and the bits of its value, by precision='exact'.
"""

import struct
import sys

import gudhi


def double(digits):
    return struct.unpack(">d", bytes.fromhex(digits))[0]


def bits(value):
    return struct.pack(">d", value).hex()


print("gudhi", gudhi.__version__, flush=True)
for request in sys.stdin:
    _, dimension, count, has_weights = request.split()
    rows = [[double(word) for word in sys.stdin.readline().split()] for _ in range(int(count))]
    points = [row[: int(dimension)] for row in rows]
    weights = [row[-1] for row in rows] if has_weights == "1" else None
    tree = gudhi.AlphaComplex(points=points, weights=weights, precision="exact").create_simplex_tree()
    simplices = [(sorted(simplex), value) for simplex, value in tree.get_simplices()]
    print("ok", len(simplices))
    for simplex, value in simplices:
        print(*simplex, bits(value))
    sys.stdout.flush()
