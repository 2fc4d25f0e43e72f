"""What the scripts share: the scenes of this bench as plain numbers, the reference values, and how times are taken.

A script is run by `python3 by_NAME.py FOLDER`. FOLDER holds the reference values that `cargo bench --bench scenes -- --table`
writes. Each line that a script prints is `program,work,seconds,error,remark`: the time to the error, which is, as in the
bench, the root of the mean square error over the mean.
"""

import csv
import statistics
import sys
import time
import tomllib
from pathlib import Path

import numpy as np

HERE = Path(__file__).resolve().parent
CORNELL_BOX = HERE.parents[2] / "scenes" / "cornell_box.toml"
# the band of the Cornell box, and the surfaces with maps, as in work.rs
BAND = 8
SURFACES = ("floor", "back", "right", "short_top")
CELLS = (32, 32)
FOLDER = Path(sys.argv[1]) if len(sys.argv) > 1 else Path(".")


class Scene:
    """Polygons with names, one radiance and one reflectance each; receivers as points with normals."""

    def __init__(self, path):
        described = tomllib.loads(path.read_text())
        is_cornell = path == CORNELL_BOX
        number = lambda value: value[BAND] if isinstance(value, list) else value
        materials = {m["name"]: number(m["reflectance"]) for m in described["material"]}
        self.polygons = {s["name"]: np.array(s["polygon"], float) for s in described["surface"]}
        self.radiance = {s["name"]: number(s.get("radiance", 0.0)) for s in described["surface"]}
        self.reflectance = {s["name"]: materials[s["material"]] for s in described["surface"]}
        self.extent = max(np.ptp(p, axis=0).max() for p in self.polygons.values())
        points, normals, self.surface = [], [], []
        if is_cornell:
            maps = [(name, CELLS) for name in SURFACES]
        else:
            maps = [(r["surface"], r["grid"]) for r in described["receiver"] if r["kind"] == "surface"]
            single = [r for r in described["receiver"] if r["kind"] == "point"]
            points += [[r["position"]] for r in single]
            normals += [[r["normal"]] for r in single]
        for name, size in maps:
            cells, normal = grid(self.polygons[name], size)
            points.append(cells)
            normals.append(np.broadcast_to(normal, cells.shape))
            self.surface += [name] * len(cells)
        self.points, self.normals = np.concatenate(points), np.concatenate(normals).astype(float)


def grid(polygon, size):
    """The middles of the cells that divide the bounding rectangle of a polygon, row by row; its first edge is the first axis."""
    along = polygon[1] - polygon[0]
    along /= np.linalg.norm(along)
    normal = np.cross(polygon[1] - polygon[0], polygon[2] - polygon[0])
    normal /= np.linalg.norm(normal)
    across = np.cross(normal, along)
    places = [(polygon - polygon[0]) @ axis for axis in (along, across)]
    x, y = (p.min() + np.ptp(p) * (np.arange(n) + 0.5) / n for p, n in zip(places, size))
    x, y = np.meshgrid(x, y)
    return polygon[0] + np.outer(x.ravel(), along) + np.outer(y.ravel(), across), normal


def scene(name):
    """The scene of a work."""
    return Scene(CORNELL_BOX if name.startswith("cornell") else HERE.parent / "files" / f"{name}.toml")


def reference(name):
    """The values of the cells, map after map; where there is no map, the answers. A cell beside its surface is NaN."""
    with open(FOLDER / f"{name}.csv") as lines:
        rows = list(csv.DictReader(lines))
    cells = [row for row in rows if row["i"]]
    return np.array([float(row["value"]) for row in cells or rows])


def relative_error(found, exact):
    known = np.isfinite(exact)
    return float(np.sqrt(np.mean((found[known] - exact[known]) ** 2)) / exact[known].mean())


def seconds(work, clock=time.perf_counter, turns=11, least=5e-3):
    """The time of one call by a clock, that on the wall if none is named: the median over turns."""
    work()
    runs, taken = 1, 0.0
    while taken < least:
        start = clock()
        for _ in range(runs):
            work()
        taken = clock() - start
        runs *= 2
    runs = max(runs // 2, 1)
    measured = []
    for _ in range(turns):
        start = clock()
        for _ in range(runs):
            work()
        measured.append((clock() - start) / runs)
    return statistics.median(measured)


def told(program, work, time, error, remark=""):
    """Prints a line of fields with commas between them; a name that holds one stands in quotes."""
    program, work = (f'"{name}"' if "," in name else name for name in (program, work))
    print(f"{program},{work},{time:.6g},{error:.3g},{remark}", flush=True)
