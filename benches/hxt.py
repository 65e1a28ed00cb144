"""Times Delaunay triangulation in space beside gmsh's HXT on the same sites: rows for records/triangulations.md.

    cargo build --release
    pip install gmsh numpy
    python3 benches/hxt.py [WORKLOAD:N ..]           # uniform-3d:100000 uniform-3d:1000000

gmsh calls HXT for volumes only. So the sites are given as a surface, of triangles of any three of them, and what is timed is HXT's first step, the triangulation of the
surface's vertices: from "Creating an empty mesh" to "Empty mesh finished", by the clock of who reads these lines. Then the process is ended. Ours is from sites in memory to
the triangulation, the better of two builds, by its own clock. One thread each, sorting included, by turns. No mesh comes of HXT that could be judged.
Environment: ROUNDS (5).
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
import sys, gmsh, numpy
points = numpy.loadtxt(sys.argv[1])
n = len(points) // 3 * 3
gmsh.initialize()
gmsh.option.setNumber("General.Terminal", 1)
gmsh.option.setNumber("General.Verbosity", 99)
gmsh.option.setNumber("General.NumThreads", 1)
gmsh.option.setNumber("Mesh.MaxNumThreads3D", 1)
gmsh.option.setNumber("Mesh.Algorithm3D", 10)
gmsh.model.add("sites")
surface = gmsh.model.addDiscreteEntity(2)
gmsh.model.mesh.addNodes(2, surface, numpy.arange(1, n + 1), points[:n].ravel())
gmsh.model.mesh.addElementsByType(surface, 2, [], numpy.arange(1, n + 1))
gmsh.model.geo.addVolume([gmsh.model.geo.addSurfaceLoop([surface])])
gmsh.model.geo.synchronize()
gmsh.model.mesh.generate(3)
"""


def ours(path, cells):
    words = [OURS, "engine", "delaunay", path, cells, "2"]
    text = subprocess.run(words, check=True, capture_output=True, text=True).stdout
    return min(float(s) for s in re.findall(r"^seconds (\S+)", text, re.M))


def hxt(path):
    words = [sys.executable, "-u", "-c", HXT, path]
    start = None
    with subprocess.Popen(words, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True) as run:
        for line in run.stdout:
            if "Creating an empty mesh" in line:
                start = time.perf_counter()
            if "Empty mesh finished" in line and start is not None:
                seconds = time.perf_counter() - start
                run.kill()
                return seconds
    sys.exit("HXT did not tell of its first step")


def compare(workload, n, folder):
    path = Path(folder) / "sites.xyz"
    subprocess.run([OURS, "gen", workload, "-n", n, "--seed", "1", "-o", path], check=True)
    rounds = range(int(os.environ.get("ROUNDS", "5")))
    pairs = [(ours(path, Path(folder) / "cells.ele"), hxt(path)) for _ in rounds]
    print(f"{workload}, {n} sites")
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
