"""What the scripts that run Mitsuba 3 share (llvm_ad_mono, all processors): shapes, and the time until an error is reached.

    pip install mitsuba

Samples are taken fourfold until the error is reached; after a run of some length the rest is extrapolated by
error ~ 1/√samples, and the remark says so. Compiling is not in the times.

On processors with AVX-512 the path integrator needs LLVM 19 (16 ends in an error): DRJIT_LIBLLVM_PATH names its library.
"""

import math
import statistics
from pathlib import Path

import mitsuba as mi
import numpy as np

import scene

mi.set_variant("llvm_ad_mono")

PROGRAM = f"Mitsuba {mi.__version__}"
# the first one is Mitsuba's default; the others spread samples more evenly
SAMPLERS = ("independent", "multijitter", "ldsampler")
# so many runs with other seeds are the error of few numbers
SEEDS = 32
# samples of one pass, all numbers together
WAVEFRONT = 1 << 24
# seconds; after a run that takes longer the rest is extrapolated
LONGEST = 0.7


def shape(polygon, reflectance, radiance, folder, name):
    """A rectangle where it emits, else a mesh."""
    bsdf = {"type": "diffuse", "reflectance": reflectance}
    if radiance > 0:
        middle = polygon.mean(axis=0)
        along, across = (polygon[1] - polygon[0]) / 2, (polygon[3] - polygon[0]) / 2
        frame = np.eye(4)
        frame[:3, 0], frame[:3, 1], frame[:3, 3] = along, across, middle
        frame[:3, 2] = np.cross(along, across) / np.linalg.norm(np.cross(along, across))
        emitter = {"type": "area", "radiance": radiance}
        return {"type": "rectangle", "to_world": mi.ScalarTransform4f(frame), "bsdf": bsdf, "emitter": emitter}
    path = Path(folder) / f"{name}.obj"
    corners = "".join(f"v {x!r} {y!r} {z!r}\n" for x, y, z in polygon.tolist())
    triangles = "".join(f"f 1 {i} {i + 1}\n" for i in range(2, len(polygon)))
    path.write_text(corners + triangles)
    return {"type": "obj", "filename": str(path), "face_normals": True, "bsdf": bsdf}


def passes_of(samples, count):
    """In how many passes so many samples of each number are taken, a power of four."""
    passes = 1
    while samples // passes * count > WAVEFRONT and samples // passes > 1:
        passes *= 4
    return passes


def measured(run, samples, exact):
    """The error of so many samples and their seconds, the median of three runs; and what was found. `run` takes the samples and a
    seed and returns values and seconds."""
    run(samples, 1)
    runs = [run(samples, seed) for seed in range(2, 5 if len(exact) > SEEDS else 2 + SEEDS)]
    errors = [scene.relative_error(found, exact) for found, _ in runs]
    taken = statistics.median(seconds for _, seconds in runs)
    return math.sqrt(np.mean(np.square(errors))), taken, np.mean([found for found, _ in runs], axis=0)


def time_to(run, exact, target, first=16):
    """Seconds until the error is reached, that error, how it was reached, and what was found by then. `first` are the first samples."""
    samples, before = first, None
    while True:
        error, taken, found = measured(run, samples, exact)
        if error <= target:
            if before is not None:
                # between the last two runs, on a line through both in logarithms
                share = math.log(before[1] / target) / math.log(before[1] / error)
                taken, error = before[0] * (taken / before[0]) ** share, target
            return taken, error, f"at most {samples} samples per receiver", found
        if taken > LONGEST or samples >= first << 18:
            how = f"extrapolated from {error:.1e} after {samples} samples per receiver"
            return taken * (error / target) ** 2, target, how, found
        # powers of four: no sampler rounds them
        samples, before = samples * 4, (taken, error)


def difference(found, exact):
    """How far the mean of what was found is from that of the reference, as a remark says it."""
    known = np.isfinite(exact)
    return f"means differ by {found[known].mean() / exact[known].mean() - 1:+.1e}"
