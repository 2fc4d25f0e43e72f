"""The same irradiance by Mitsuba 3 (llvm_ad_mono, all processors).

    pip install mitsuba

Direct light is sampled at the receivers themselves, one point of the lamp a sample. Reflected light is the radiance that the
path integrator finds in a ray onto the receiver, times π/ρ; its roulette is the default one. Each sampler is tried.
"""

import math
import tempfile
import time

import drjit as dr
import mitsuba as mi
import numpy as np

import scene
from with_mitsuba import PROGRAM, SAMPLERS, difference, passes_of, shape, time_to


def load(here):
    with tempfile.TemporaryDirectory() as folder:
        shapes = {
            name: shape(polygon, here.reflectance[name], here.radiance[name], folder, name)
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
        passes = passes_of(samples, self.count)
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


def told(name, target, arriving_of):
    receivers = Receivers(name)
    exact = scene.reference(name)
    arriving = arriving_of(receivers)
    for sampler in SAMPLERS:
        run = lambda samples, seed: receivers.run(arriving, sampler, samples, seed)
        taken, error, how, found = time_to(run, exact, target)
        scene.told(f"{PROGRAM} ({sampler})", name, taken, error, f"{how}; {difference(found, exact)}")


def of_orders(depth):
    return lambda receivers: receivers.reflected(mi.load_dict({"type": "path", "max_depth": depth}))


for name, target in (("lamp", 1e-3), ("occluded_lamp", 1e-3), ("near_lamp", 1e-2), ("cornell_direct", 1e-2)):
    told(name, target, lambda receivers: receivers.direct)
for name, depth in (("cornell_1", 3), ("cornell_2", 4), ("cornell_all", -1)):
    told(name, 1e-2, of_orders(depth))
