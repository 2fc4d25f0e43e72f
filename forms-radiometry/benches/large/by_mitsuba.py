"""What Mitsuba 3 (llvm_ad_mono, all processors) takes for the works: the time until the standard error is reached.

    pip install mitsuba numpy
    python3 by_mitsuba.py factor ONE.stl OTHER.stl               # a whole program with few samples: it starts, reads and compiles
    python3 by_mitsuba.py points|map|camera MESH.obj REFLECTANCE COUNT

Compiling is not in the times of samples, and neither is reading. DRJIT_LIBLLVM_PATH names a library of LLVM 15 or newer.
"""

import math
import statistics
import subprocess
import sys
import time

import drjit as dr
import mitsuba as mi
import numpy as np

import works

mi.set_variant("llvm_ad_mono")

PROGRAM = f"Mitsuba {mi.__version__}"
# runs with other seeds, whose spread is the error; and the time of one after which the rest is extrapolated
RUNS, LONGEST = 8, 3.0
# the part of all pixels or cells that have the largest errors
WORST = 0.01
# how far a ray starts from its surface
OFF = 1e-5


def time_to(run, first, target):
    """Seconds until the root mean square of the relative errors is `target`; the same for the pixels with the largest errors,
    relative to the mean of all; and the mean values. `run` takes samples and a seed."""
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
            worst = largest(values) / mean.mean()
            return seconds * (error / target) ** 2, seconds * (worst / target) ** 2, mean
        samples *= 4


def largest(values):
    """The error of the pixels with the largest errors: half of the runs finds which these are, and the other half their error."""
    one, other = values[: RUNS // 2].var(axis=0, ddof=1), values[RUNS // 2 :].var(axis=0, ddof=1)
    count = max(1, int(WORST * len(one)))
    both = [other[np.argsort(one)[-count:]], one[np.argsort(other)[-count:]]]
    return math.sqrt(np.mean(both))


def rest(*arguments):
    """Seconds of a whole program with few samples, once its kernels are compiled and stored."""
    for _ in range(2):
        start = time.perf_counter()
        subprocess.run([sys.executable, __file__, *map(str, arguments)], check=True, capture_output=True)
    return time.perf_counter() - start


def mesh(corners):
    found = mi.Mesh("mesh", 3 * len(corners), len(corners))
    parameters = mi.traverse(found)
    parameters["vertex_positions"] = mi.Float(corners.astype(np.float32).ravel())
    parameters["faces"] = mi.UInt32(np.arange(3 * len(corners), dtype=np.uint32))
    parameters.update()
    return found


def view_factor(one, other):
    """What samples the view factor from the triangles `one` to the triangles `other`."""
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

    return run


# samples of the first run
FIRST = {"factor": 1 << 12, "points": 256, "map": 64, "camera": 16}


class Lit:
    """Triangles under the lamp."""

    def __init__(self, file, reflectance):
        diffuse = lambda value: {"type": "diffuse", "reflectance": value}
        frame = mi.ScalarTransform4f
        wide = [works.HALF, works.HALF, 1]
        down = frame().translate([0, 0, works.HIGH]).rotate([1, 0, 0], 180).scale(wide)
        things = {"type": "twosided", "both": diffuse(reflectance)}
        self.scene = mi.load_dict({
            "type": "scene",
            "things": {"type": "obj", "filename": str(file), "face_normals": True, "bsdf": things},
            "ground": {"type": "rectangle", "to_world": frame().scale(wide), "bsdf": diffuse(reflectance)},
            "lamp": {"type": "rectangle", "to_world": down, "bsdf": diffuse(0.0),
                     "emitter": {"type": "area", "radiance": 1.0}},
        })  # fmt: skip
        self.integrator = mi.load_dict({"type": "path", "max_depth": -1 if reflectance > 0 else 2})

    def irradiance(self, positions):
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

        return run

    def points(self, count):
        return self.irradiance(works.places(count))

    def map(self, count):
        along = (np.arange(16) + 0.5) / 16 * 2 * works.HALF - works.HALF
        return self.irradiance([[x, y, 0.0] for y in along for x in along])

    def camera(self, count):
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

        return run


def main(asked, *arguments):
    if asked == "factor":
        run = view_factor(*map(works.stl, arguments))
    else:
        file, reflectance, count = arguments
        run = getattr(Lit(file, float(reflectance)), asked)(int(count))
    print(run(FIRST[asked], 1))


if __name__ == "__main__":
    main(*sys.argv[1:])
