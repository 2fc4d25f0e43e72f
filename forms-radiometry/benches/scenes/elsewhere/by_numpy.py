"""The closed form of a rectangle that is parallel to the floor, and of what a parallel plate leaves of it, by numpy.

In units of the height, and with a corner above the receiver, F = (A' atan(B/√(1 + A²)) + B' atan(A/√(1 + B²)))/(2π) with
A' = A/√(1 + A²) (Howell C-8). All that depends on one axis alone is computed once for each column or row.
"""

import numpy as np

import scene


class Grid:
    """Columns and rows of the receivers, which a lamp above them is parallel to."""

    def __init__(self, name):
        here = scene.scene(name)
        receivers, lamp = here.points, here.polygons["lamp"]
        self.x, self.y = np.unique(receivers[:, 0]), np.unique(receivers[:, 1])
        self.lamp = ends(lamp)
        self.height = lamp[0, 2] - receivers[0, 2]
        if "plate" in here.polygons:
            plate = here.polygons["plate"]
            self.plate, self.clearance = ends(plate), plate[0, 2] - receivers[0, 2]


def ends(rectangle):
    return [(rectangle[:, axis].min(), rectangle[:, axis].max()) for axis in (0, 1)]


def corner_sum(a, b):
    """The sum over the four corners with the coordinates a[i] of the columns and b[j] of the rows."""
    root_a, root_b = np.sqrt(1 + a * a), np.sqrt(1 + b * b)
    sine_a, sine_b = a / root_a, b / root_b
    total = 0.0
    for i in (0, 1):
        for j in (0, 1):
            term = sine_a[i] * np.arctan(b[j][:, None] / root_a[i]) + sine_b[j][:, None] * np.arctan(a[i] / root_b[j][:, None])
            total = total + term if i == j else total - term
    return total


def free(here):
    (left, right), (low, high) = here.lamp
    a = np.stack([left - here.x, right - here.x]) / here.height
    b = np.stack([low - here.y, high - here.y]) / here.height
    # E = π F L with L = 1
    return 0.5 * corner_sum(a, b)


def occluded(here):
    """The lamp without the part in the plate's shadow, which is a rectangle too."""
    stretch = here.height / here.clearance
    shadows = []
    for (left, right), (lamp_left, lamp_right), places in zip(here.plate, here.lamp, (here.x, here.y)):
        start = np.clip(places + stretch * (left - places), lamp_left, lamp_right)
        end = np.clip(places + stretch * (right - places), lamp_left, lamp_right)
        shadows.append(np.stack([start - places, end - places]) / here.height)
    return free(here) - 0.5 * corner_sum(*shadows)


for name, work in (("lamp", free), ("occluded_lamp", occluded)):
    here = Grid(name)
    error = scene.relative_error(work(here).ravel(), scene.reference(name))
    scene.told(f"numpy {np.__version__}", name, scene.seconds(lambda: work(here)), error, "closed form; one thread")
