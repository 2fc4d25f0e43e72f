"""The irradiance below the lamp nearby, and of the map under the lamp, by `rtrace -I` of Radiance.

    pip install pyradiance

Once with the options that rtrace has by default, and once with the lamp divided more finely (-ds 0.01 -dj 0): the time is that of the
whole program, which reads the scene too.
"""

import subprocess
import tempfile
import time
from pathlib import Path

import numpy as np
import pyradiance

import scene

BINARIES = Path(pyradiance.__file__).parent / "bin"
OPTIONS = (("default", []), ("-ds 0.01 -dj 0", ["-ds", "0.01", "-dj", "0"]))


def described(here):
    """Lamps are lights of their radiance; all else is plastic without colour."""
    text = ""
    for name, polygon in here.polygons.items():
        rho, radiance = here.reflectance[name], here.radiance[name]
        kind = ("light", [radiance] * 3) if radiance > 0 else ("plastic", [rho] * 3 + [0, 0])
        numbers = " ".join(map(repr, kind[1]))
        corners = "\n".join(" ".join(map(repr, corner)) for corner in polygon.tolist())
        text += f"void {kind[0]} of_{name}\n0\n0\n{len(kind[1])} {numbers}\n"
        text += f"of_{name} polygon {name}\n0\n0\n{polygon.size}\n{corners}\n"
    return text


def traced(octree, here, options):
    rays = "\n".join(" ".join(map(repr, row)) for row in np.hstack([here.points, here.normals]).tolist())
    command = [BINARIES / "rtrace", "-h", "-I", "-ab", "0", *options, octree]
    lines = subprocess.run(command, input=rays.encode(), capture_output=True, check=True).stdout.decode()
    return np.array([float(line.split()[1]) for line in lines.split("\n") if line.strip()])


for name in ("lamp", "occluded_lamp", "near_lamp"):
    here = scene.scene(name)
    with tempfile.TemporaryDirectory() as folder:
        source, octree = Path(folder) / "scene.rad", Path(folder) / "scene.oct"
        source.write_text(described(here))
        octree.write_bytes(subprocess.run([BINARIES / "oconv", source], capture_output=True, check=True).stdout)
        for title, options in OPTIONS:
            start = time.perf_counter()
            found = traced(octree, here, options)
            taken = time.perf_counter() - start
            error = scene.relative_error(found, scene.reference(name))
            scene.told(f"Radiance ({title})", name, taken, error)
