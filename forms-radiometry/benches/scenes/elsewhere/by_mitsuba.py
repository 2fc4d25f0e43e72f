"""The same irradiance by Mitsuba 3 (llvm_ad_mono, all processors).

    pip install mitsuba

Direct light is sampled at the receivers themselves, one point of the lamp a sample. Reflected light is the radiance that the
path integrator finds in a ray onto the receiver, times π/ρ; its roulette is the default one. Each sampler is tried. Samples are
taken fourfold until the error is reached; after a run of some length the rest is extrapolated by error ~ 1/√samples, and the
remark says so. Compiling is not in the times.

On processors with AVX-512 the path integrator needs LLVM 16 or newer: DRJIT_LIBLLVM_PATH names its library.
"""

import math
import statistics
import tempfile
import time
from pathlib import Path

import drjit as dr
import mitsuba as mi
import numpy as np

import scene

mi.set_variant("llvm_ad_mono")

PROGRAM = f"Mitsuba {mi.__version__}"
# the first one is Mitsuba's default; the others spread samples more evenly
SAMPLERS = ("independent", "multijitter", "ldsampler")
# so many runs with other seeds are the error of few receivers
SEEDS = 32
# samples of one pass, all receivers together
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
    path = folder / f"{name}.obj"
    corners = "".join(f"v {x!r} {y!r} {z!r}\n" for x, y, z in polygon.tolist())
    triangles = "".join(f"f 1 {i} {i + 1}\n" for i in range(2, len(polygon)))
    path.write_text(corners + triangles)
    return {"type": "obj", "filename": str(path), "face_normals": True, "bsdf": bsdf}


def load(here):
    with tempfile.TemporaryDirectory() as folder:
        shapes = {
            name: shape(polygon, here.reflectance[name], here.radiance[name], Path(folder), name)
            for name, polygon in here.polygons.items()
        }
        return mi.load_dict({"type": "scene", **shapes})


class Receivers:
    """Points on surfaces, and the irradiance that samples give there."""

    def __init__(self, name):
        here = scene.scene(name)
        self.world = load(here)
        self.count = len(here.points)
        self.points, self.normals = here.points, here.normals
        self.extent = here.extent
        self.albedo = np.array([here.reflectance[surface] for surface in here.surface])

    def columns(self, values, index):
        return [dr.gather(mi.Float, mi.Float(np.ascontiguousarray(column, np.float32)), index) for column in values.T]

    def place(self, index):
        return mi.Point3f(*self.columns(self.points, index)), mi.Normal3f(*self.columns(self.normals, index))

    def direct(self, sampler, index):
        point, normal = self.place(index)
        seen = dr.zeros(mi.SurfaceInteraction3f)
        seen.p, seen.n, seen.t = point, normal, 0.0
        sampled, weight = self.world.sample_emitter_direction(seen, sampler.next_2d(), True)
        return weight[0] * dr.maximum(dr.dot(sampled.d, normal), 0)

    def reflected(self, integrator):
        def arriving(sampler, index):
            point, normal = self.place(index)
            ray = mi.RayDifferential3f(o=point + 1e-3 * self.extent * normal, d=-normal)
            radiance, _, _ = integrator.sample(self.world, sampler, ray)
            return math.pi * radiance[0] / dr.gather(mi.Float, mi.Float(self.albedo.astype(np.float32)), index)

        return arriving

    def run(self, arriving, sampler_type, samples, seed):
        """The mean of so many samples a receiver, and the seconds that it took."""
        passes = 1
        while samples // passes * self.count > WAVEFRONT and samples // passes > 1:
            passes *= 4
        each = samples // passes
        total = np.zeros(self.count)
        start = time.perf_counter()
        for number in range(passes):
            sampler = mi.load_dict({"type": sampler_type, "sample_count": each})
            sampler.set_samples_per_wavefront(each)
            sampler.seed(seed * 4096 + number, each * self.count)
            index = dr.arange(mi.UInt32, each * self.count) // each
            total += np.array(dr.block_sum(arriving(sampler, index), each))
        return total / (each * passes), time.perf_counter() - start


def measured(receivers, arriving, sampler, samples, exact):
    """The error of so many samples and their seconds, the median of three runs; and what was found."""
    receivers.run(arriving, sampler, samples, 1)
    runs = [receivers.run(arriving, sampler, samples, seed) for seed in range(2, 5 if receivers.count > SEEDS else 2 + SEEDS)]
    errors = [scene.relative_error(found, exact) for found, _ in runs]
    taken = statistics.median(seconds for _, seconds in runs)
    return math.sqrt(np.mean(np.square(errors))), taken, np.mean([found for found, _ in runs], axis=0)


def time_to(receivers, arriving, sampler, exact, target):
    """Seconds until the error is reached, that error, how it was reached, and what was found by then."""
    samples, before = 16, None
    while True:
        error, taken, found = measured(receivers, arriving, sampler, samples, exact)
        if error <= target:
            if before is not None:
                # between the last two runs, on a line through both in logarithms
                share = math.log(before[1] / target) / math.log(before[1] / error)
                taken, error = before[0] * (taken / before[0]) ** share, target
            return taken, error, f"at most {samples} samples a receiver", found
        if taken > LONGEST or samples >= 1 << 22:
            how = f"extrapolated from {error:.1e} after {samples} samples a receiver"
            return taken * (error / target) ** 2, target, how, found
        # powers of four: no sampler rounds them
        samples, before = samples * 4, (taken, error)


def told(name, target, arriving_of):
    receivers = Receivers(name)
    exact = scene.reference(name)
    known = np.isfinite(exact)
    for sampler in SAMPLERS:
        taken, error, how, found = time_to(receivers, arriving_of(receivers), sampler, exact, target)
        off = found[known].mean() / exact[known].mean() - 1
        scene.told(f"{PROGRAM} ({sampler})", name, taken, error, f"{how}; means differ by {off:+.1e}")


def of_orders(depth):
    return lambda receivers: receivers.reflected(mi.load_dict({"type": "path", "max_depth": depth}))


for name, target in (("lamp", 1e-3), ("occluded_lamp", 1e-3), ("near_lamp", 1e-2), ("cornell_direct", 1e-2)):
    told(name, target, lambda receivers: receivers.direct)
for name, depth in (("cornell_1", 3), ("cornell_2", 4), ("cornell_all", -1)):
    told(name, 1e-2, of_orders(depth))
