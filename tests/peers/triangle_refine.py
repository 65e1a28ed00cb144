"""Triangle behind a pipe, through PyPI's package `triangle`: an opponent in refinement.

In: requests as those of cgal.cpp, of two kinds:
  refine DEGREES SIZE N M    then N lines  x y, then M lines  i j    (SIZE is not looked at)
  conform gabriel N M        the same lines; what no segment is around is left out
Out: `triangle`, when it is ready; for each request `counted VERTICES CELLS SECONDS`. After ten seconds the program ends.
"""

import os
import signal
import struct
import sys
import time

import numpy
import triangle


def double(digits):
    return struct.unpack(">d", bytes.fromhex(digits))[0]


print("triangle", flush=True)
for line in sys.stdin:
    what, *words, n, m = line.split()
    switches = "pq" + words[0] if what == "refine" else "pD"
    points = [[double(x) for x in sys.stdin.readline().split()] for _ in range(int(n))]
    segments = [[int(i) for i in sys.stdin.readline().split()] for _ in range(int(m))]
    given = {
        "vertices": numpy.array(points, dtype=float).reshape(-1, 2),
        "segments": numpy.array(segments, dtype=numpy.int32).reshape(-1, 2),
    }
    signal.alarm(int(os.environ.get("DELONE_PATIENCE", 10)))
    start = time.perf_counter()
    made = triangle.triangulate(given, switches)
    seconds = time.perf_counter() - start
    signal.alarm(0)
    print("counted", len(made["vertices"]), len(made.get("triangles", ())), seconds, flush=True)
