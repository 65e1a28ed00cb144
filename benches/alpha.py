"""Times alpha filtrations and persistence beside Gudhi and CGAL on the same sites, and writes the rows of records/alpha.md.

    cargo build --release -p delone-alpha --example time_alpha
    cargo xtask setup                                # for CGAL; left out if it is not built
    python3 benches/alpha.py [WORKLOAD:N ..]         # a Python with numpy and gudhi

Rounds are interleaved: each program once, then again; medians. All times are wall-clock seconds on one thread, of construction alone:
ours from validated sites' construction to the last rank (the triangulation included), Gudhi's of AlphaComplex and
create_simplex_tree, then of compute_persistence over Z/2 on that tree; CGAL's of triangulation and Alpha_shape, by its own clock.
Ours tells the most memory that its process had held when the filtration was there, input and triangulation included.
Environment: ROUNDS (3), EXACT_ROUNDS (1) of Gudhi's exact complex, which is slow.
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
OURS = ROOT / "target/release/examples/time_alpha"
CGAL = ROOT / "target/peers/cgal_alpha"
GUDHI = """
import sys, time, gudhi, numpy
path, dimension, precision, wants_persistence = sys.argv[1:]
points = numpy.fromfile(path).reshape(-1, int(dimension))
start = time.perf_counter()
tree = gudhi.AlphaComplex(points=points, precision=precision).create_simplex_tree()
built = time.perf_counter()
persisted = built
if wants_persistence == "1":
    tree.compute_persistence(homology_coeff_field=2)
    persisted = time.perf_counter()
print(tree.num_simplices(), built - start, persisted - built)
"""


def ours(workload, n, path):
    words = [OURS, workload, str(n), path]
    text = subprocess.run(words, check=True, capture_output=True, text=True).stdout
    numbers = re.findall(r"(\d+) simplices|(\d+\.\d+) s|peak (\d+) KiB", text)
    simplices, delaunay, filtration, persistence, kib = (float("".join(found)) for found in numbers)
    return {
        "filtration": delaunay + filtration,
        "persistence": persistence,
        "simplices": int(simplices),
        "bytes": kib * 1024 / simplices,
    }


def gudhi(path, dimension, precision, wants_persistence):
    words = [sys.executable, "-c", GUDHI, path, str(dimension), precision, str(int(wants_persistence))]
    text = subprocess.run(words, check=True, capture_output=True, text=True).stdout
    simplices, built, persistence = text.split()
    return int(simplices), float(built), float(persistence)


def cgal(path, dimension):
    import numpy

    bits = numpy.fromfile(path, dtype="<u8").reshape(-1, dimension)
    lines = "\n".join(" ".join(f"{x:016x}" for x in row) for row in bits.tolist())
    request = f"time{dimension} {len(bits)}\n{lines}\n"
    text = subprocess.run([CGAL], input=request, check=True, capture_output=True, text=True).stdout
    return float(text.split()[3])


def compare(workload, n, path):
    dimension = 3 if workload.endswith("-3d") else 2
    times = {}
    for turn in range(int(os.environ.get("ROUNDS", "3"))):
        mine = ours(workload, n, path)
        times.setdefault("ours", []).append(mine["filtration"])
        times.setdefault("ours, persistence", []).append(mine["persistence"])
        simplices, built, persistence = gudhi(path, dimension, "fast", True)
        times.setdefault("Gudhi fast", []).append(built)
        times.setdefault("Gudhi, persistence", []).append(persistence)
        if CGAL.exists():
            times.setdefault("CGAL Alpha_shape", []).append(cgal(path, dimension))
        if turn < int(os.environ.get("EXACT_ROUNDS", "1")):
            times.setdefault("Gudhi exact", []).append(gudhi(path, dimension, "exact", False)[1])
    print(f"\n{workload}, {n} sites: {mine['simplices']} simplices, Gudhi fast {simplices}; "
          f"ours {mine['bytes']:.0f} bytes a simplex at most\n")
    print("| what | seconds | all rounds | over ours |\n|---|---|---|---|")
    for name, rounds in times.items():
        base = "ours, persistence" if name.endswith("persistence") else "ours"
        pairs = zip(rounds, times[base])
        ratio = statistics.median(theirs / own for theirs, own in pairs)
        print(f"| {name} | {statistics.median(rounds):.2f} | {' '.join(f'{x:.2f}' for x in rounds)} | {ratio:.1f} |")
    sys.stdout.flush()


def main():
    print(time.strftime("%Y-%m-%d"), "python", sys.version.split()[0])
    inputs = sys.argv[1:] or ["uniform-3d:100000", "uniform:1000000"]
    for word in inputs:
        workload, n = word.split(":")
        with tempfile.TemporaryDirectory() as folder:
            compare(workload, int(n), str(Path(folder) / "sites"))


main()
