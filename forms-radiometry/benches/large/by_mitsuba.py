"""What Mitsuba 3 (llvm_ad_mono, all processors) takes for the works: the time until the standard error is reached.

    pip install mitsuba numpy

Compiling is not in the times, and neither is reading. DRJIT_LIBLLVM_PATH names a library of LLVM 15 or newer.
"""

import math
import statistics
import time

import drjit as dr
import mitsuba as mi
import numpy as np

import works

mi.set_variant("llvm_ad_mono")

PROGRAM = f"Mitsuba {mi.__version__}"
# runs with other seeds, whose spread is the error; and the time of one after which the rest is extrapolated
RUNS, LONGEST = 6, 3.0
# how far a ray starts from its surface
OFF = 1e-5


def time_to(run, first, target):
    """Seconds until the root mean square of the relative errors is `target`; the mean values. `run` takes samples and a seed."""
    samples = first
    while True:
        run(samples, 1)
        values, taken = [], []
        for seed in range(2, 2 + RUNS):
            start = time.perf_counter()
            values.append(np.atleast_1d(run(samples, seed)))
            taken.append(time.perf_counter() - start)
        values, seconds = np.array(values), statistics.median(taken)
        mean = values.mean(axis=0)
        scale = np.maximum(mean, mean.mean())
        error = math.sqrt(np.mean(np.square(values.std(axis=0, ddof=1) / scale)))
        if error <= target or seconds > LONGEST:
            return seconds * (error / target) ** 2, mean
        samples *= 4


def mesh(corners):
    found = mi.Mesh("mesh", 3 * len(corners), len(corners))
    parameters = mi.traverse(found)
    parameters["vertex_positions"] = mi.Float(corners.astype(np.float32).ravel())
    parameters["faces"] = mi.UInt32(np.arange(3 * len(corners), dtype=np.uint32))
    parameters.update()
    return found


def view_factor(one, other, target):
    """The time of the view factor from the triangles `one` to the triangles `other`, and the factor."""
    scene = mi.load_dict({"type": "scene", "one": mesh(one), "other": mesh(other)})
    arrived = mi.ShapePtr(scene.shapes()[1])
    edges = one[:, 1] - one[:, 0], one[:, 2] - one[:, 0]
    normals = np.cross(*edges)
    lengths = np.linalg.norm(normals, axis=1)
    table = lambda vectors: mi.Point3f(*(mi.Float(column) for column in vectors.astype(np.float32).T.copy()))
    corner, along, across = table(one[:, 0]), table(edges[0]), table(edges[1])
    normal, chance = table(normals / lengths[:, None]), mi.DiscreteDistribution(mi.Float(lengths.astype(np.float32)))

    def run(samples, seed):
        numbers = mi.PCG32(size=samples, initstate=seed)
        place, u = chance.sample_reuse(numbers.next_float32())
        of = lambda vectors: dr.gather(mi.Point3f, vectors, place)
        root, v = dr.sqrt(u), numbers.next_float32()
        up = mi.Vector3f(of(normal))
        position = of(corner) + root * ((1 - v) * of(along) + v * of(across)) + OFF * up
        direction = mi.Point2f(numbers.next_float32(), numbers.next_float32())
        direction = mi.Frame3f(up).to_world(mi.warp.square_to_cosine_hemisphere(direction))
        met = scene.ray_intersect_preliminary(mi.Ray3f(position, direction), coherent=False)
        hit = met.is_valid() & (met.shape == arrived)
        return float(dr.mean(dr.select(hit, mi.Float64(1), mi.Float64(0)))[0])

    return time_to(run, 1 << 12, target)


class Lit:
    """Triangles under the lamp."""

    def __init__(self, file, reflectance):
        diffuse = lambda value: {"type": "diffuse", "reflectance": value}
        frame = mi.ScalarTransform4f
        wide = [works.HALF, works.HALF, 1]
        down = frame().translate([0, 0, works.HIGH]).rotate([1, 0, 0], 180).scale(wide)
        things = {"type": "twosided", "both": diffuse(reflectance)}
        start = time.perf_counter()
        self.scene = mi.load_dict({
            "type": "scene",
            "things": {"type": "obj", "filename": str(file), "face_normals": True, "bsdf": things},
            "ground": {"type": "rectangle", "to_world": frame().scale(wide), "bsdf": diffuse(reflectance)},
            "lamp": {"type": "rectangle", "to_world": down, "bsdf": diffuse(0.0),
                     "emitter": {"type": "area", "radiance": 1.0}},
        })  # fmt: skip
        self.loading = time.perf_counter() - start
        self.integrator = mi.load_dict({"type": "path", "max_depth": -1 if reflectance > 0 else 2})

    def irradiance(self, positions, first, target):
        positions = np.array(positions, np.float32)

        def run(samples, seed):
            count = len(positions) * samples
            sampler = mi.load_dict({"type": "independent", "sample_count": samples})
            sampler.set_samples_per_wavefront(samples)
            sampler.seed(seed, count)
            places = mi.Point3f(*(mi.Float(column) for column in positions.T.copy()))
            start = dr.gather(mi.Point3f, places, dr.arange(mi.UInt32, count) // samples) + mi.Vector3f(0, 0, OFF)
            direction = mi.warp.square_to_cosine_hemisphere(sampler.next_2d())
            ray = mi.RayDifferential3f(o=start, d=direction)
            radiance, _, _ = self.integrator.sample(self.scene, sampler, ray, None)
            return math.pi * np.array(dr.block_sum(radiance[0], samples)) / samples

        return time_to(run, first, target)

    def map(self, target):
        along = (np.arange(16) + 0.5) / 16 * 2 * works.HALF - works.HALF
        return self.irradiance([[x, y, 0.0] for y in along for x in along], 64, target)

    def camera(self, target):
        eye = works.EYE
        to_world = mi.ScalarTransform4f().look_at(origin=eye["origin"], target=eye["target"], up=[0, 0, 1])
        width, height = eye["resolution"]
        film = {"type": "hdrfilm", "width": width, "height": height, "rfilter": {"type": "box"},
                "pixel_format": "luminance"}  # fmt: skip

        def run(samples, seed):
            sensor = mi.load_dict({
                "type": "perspective", "fov": eye["fov"], "fov_axis": "y", "to_world": to_world, "film": film,
                "sampler": {"type": "independent", "sample_count": samples},
            })  # fmt: skip
            image = mi.render(self.scene, sensor=sensor, integrator=self.integrator, spp=samples, seed=seed)
            return np.array(image, float).reshape(-1)

        return time_to(run, 16, target)
