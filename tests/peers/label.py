"""Compares labels of components with scipy.ndimage.label's.

In: for each case a line `axes side reach` (reach 1: through facets; axes: also at corners), then a line of labels, the last
axis fastest, 0 for white. Out: for each case `same n`, or `different ours theirs pairs`. Exit status 3 without scipy.
"""

import sys

try:
    import numpy
    from scipy import ndimage
except ImportError:
    sys.exit(3)

while header := sys.stdin.readline():
    axes, side, reach = map(int, header.split())
    ours = numpy.array(sys.stdin.readline().split(), dtype=int).reshape([side] * axes)
    structure = ndimage.generate_binary_structure(axes, reach)
    theirs, count = ndimage.label(ours > 0, structure)
    pairs = set(zip(ours[ours > 0].tolist(), theirs[ours > 0].tolist()))
    if len(pairs) == count == ours.max(initial=0):
        print("same", count)
    else:
        print("different", ours.max(initial=0), count, len(pairs))
