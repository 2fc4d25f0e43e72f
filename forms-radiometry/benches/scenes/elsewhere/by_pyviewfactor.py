"""View factors of the same squares by pyviewfactor: its semi-analytic contour integral, compiled by numba.

    pip install pyviewfactor numba

The time is the processor time of the compiled integral alone, over vertices that are arrays already.
"""

import csv
import time
from importlib.metadata import version

import numpy as np

import scene
from pyviewfactor.pvf_geometry_preprocess import polygon_area
from pyviewfactor.pvf_integrators import compute_viewfactor_sa30


def view_factor(from_square, to_square):
    """Not a number where its area of a square is zero."""
    area = polygon_area(from_square)
    return compute_viewfactor_sa30(to_square, from_square, 4 * np.pi * area) if area > 0 else np.nan


with open(scene.FOLDER / "squares.csv") as lines:
    rows = list(csv.reader(lines))[1:]
pairs = [np.array(row[3:], float).reshape(2, 4, 3) for row in rows]
program = f"pyviewfactor {version('pyviewfactor')}"

errors = {}
for (title, _, exact, *_), pair in zip(rows, pairs):
    error = abs(view_factor(*pair) - float(exact)) / float(exact)
    errors[title] = np.maximum(errors.get(title, 0.0), error)
general = [(b, a, 4 * np.pi * polygon_area(a)) for row, (a, b) in zip(rows, pairs) if row[1] == "1"]
taken = scene.seconds(lambda: [compute_viewfactor_sa30(*pair) for pair in general], clock=time.thread_time) / len(general)
for title, error in errors.items():
    scene.told(program, title, taken if title == rows[0][0] else float("nan"), error)
