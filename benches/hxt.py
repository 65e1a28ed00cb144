"""Times Delaunay triangulation in space beside gmsh's HXT on the same sites: rows for records/triangulations.md.

    cargo build --release
    pip install gmsh numpy
    python3 benches/hxt.py [WORKLOAD:N ..]           # uniform-3d:100000 uniform-3d:1000000

Rounds are interleaved: ours, HXT, and again; wall-clock seconds on one thread, from sites in memory to the triangulation, sorting
included, by each one's own clock; each program is a new process a turn, builds twice, and its better time counts. HXT has no program and answers no mesh that
could be judged: cells are counted. Environment: ROUNDS (5).
"""

import os
import re
import statistics
import subprocess
import sys
import tempfile
import time
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
OURS = ROOT / "target/release/delone"
HXT = """
import sys, time, gmsh, numpy
points = numpy.loadtxt(sys.argv[1])
gmsh.initialize()
gmsh.option.setNumber("General.Verbosity", 0)
gmsh.option.setNumber("General.NumThreads", 1)
tetrahedralize = gmsh.algorithm.tetrahedralize if hasattr(gmsh, "algorithm") else gmsh.model.mesh.tetrahedralize
flat = points.ravel()
for _ in range(2):
    start = time.perf_counter()
    tags = tetrahedralize(flat)
    print("seconds", time.perf_counter() - start)
tags = tags[0] if isinstance(tags, tuple) else tags
print("cells", len(tags) // 4)
"""


def seconds_of(words):
    """The better of its times, and what it printed."""
    text = subprocess.run(words, check=True, capture_output=True, text=True).stdout
    return min(float(s) for s in re.findall(r"^seconds (\S+)", text, re.M)), text


def compare(workload, n, folder):
    path = Path(folder) / "sites.xyz"
    cells = Path(folder) / "cells.ele"
    subprocess.run([OURS, "gen", workload, "-n", n, "--seed", "1", "-o", path], check=True)
    pairs = []
    for _ in range(int(os.environ.get("ROUNDS", "5"))):
        mine, _ = seconds_of([OURS, "engine", "delaunay", path, cells, "2"])
        theirs, text = seconds_of([sys.executable, "-c", HXT, path])
        pairs.append((mine, theirs))
    with open(cells) as lines:
        count = next(lines).split()[0]
    print(f"{workload}, {n} sites: {count} cells, HXT {text.split('cells')[1].strip()}")
    for name, times in zip(("ours", "HXT"), zip(*pairs)):
        print(f"  {name:5} {statistics.median(times):.3f} s  ({' '.join(f'{x:.3f}' for x in times)})")
    ratios = [theirs / mine for mine, theirs in pairs]
    print(f"  HXT over ours {statistics.median(ratios):.2f}  ({' '.join(f'{x:.2f}' for x in ratios)})")
    sys.stdout.flush()


def main():
    print(time.strftime("%Y-%m-%d"), "python", sys.version.split()[0])
    for word in sys.argv[1:] or ["uniform-3d:100000", "uniform-3d:1000000"]:
        workload, n = word.split(":")
        with tempfile.TemporaryDirectory() as folder:
            compare(workload, n, folder)


main()
