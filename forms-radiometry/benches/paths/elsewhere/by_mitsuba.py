"""The works of this bench by Mitsuba 3 (llvm_ad_mono, all processors).

    pip install mitsuba

A work is a file FOLDER/NAME.json that the bench writes: the scene in numbers, and what is right. Where a medium is everywhere the
integrator is `volpath`, else `path`. Roulette begins where it does by default, and late: by default paths go on with a probability of 0.95 at
most from the fifth vertex on, whatever their weight, and where less is lost weights grow for ever. An image is rendered; irradiance is π
times the mean radiance of directions by the cosine law.

Of an image whose pixels are known, 32 renderings with other seeds tell each pixel's mean and its standard error.
"""

import json
import math
import sys
import tempfile
import time
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "scenes" / "elsewhere"))

import drjit as dr
import mitsuba as mi
import numpy as np

import scene
from with_mitsuba import PROGRAM, SAMPLERS, SEEDS, difference, passes_of, shape, time_to

# the depth from which paths end at random: Mitsuba's default, and one at which little is left of the light
DEFAULT, LATE = 5, 512
# how far a receiver is before the surface that it is on, in units of the scene
OFF = 1e-6
# the first samples of a number and of a pixel
FIRST = {False: 1 << 12, True: 16}
# so many standard errors off, a pixel is an outlier
FAR = 5.0
# samples of each rendering by which outliers are counted
EACH = 4


class Work:
    """A scene, its medium if it has one, and what is asked for."""

    def __init__(self, path):
        here = json.loads(path.read_text())
        self.name, self.target, self.known = path.stem, here["target"], here["known"]
        self.exact = np.array(here["reference"])
        self.receiver = here["receiver"]
        self.medium = medium(here["medium"]) if here["medium"] else None
        with tempfile.TemporaryDirectory() as folder:
            shapes = {surface["name"]: self.shape(surface, folder) for surface in here["surfaces"]}
            self.world = mi.load_dict({"type": "scene", **shapes})
        self.is_image = "resolution" in self.receiver

    def shape(self, surface, folder):
        polygon = np.array(surface["polygon"], float)
        one = shape(polygon, surface["reflectance"], surface["radiance"], folder, surface["name"])
        if surface["is_mirror"]:
            one["bsdf"] = {"type": "conductor", "material": "none", "specular_reflectance": surface["reflectance"]}
        return {**one, "exterior": self.medium} if self.medium else one

    def variants(self):
        """Samplers with the depth of roulette: all of an image, and of a number those that are of use, after the default: `ldsampler` takes up
        to a thousand times as long as the others where light scatters. Of an image that is known only the default: what is looked for is how
        far off pixels are, in minutes for each variant."""
        if self.is_image and self.known is not None:
            return [(SAMPLERS[0], DEFAULT)]
        if self.is_image:
            return [(sampler, depth) for depth in (DEFAULT, LATE) for sampler in SAMPLERS]
        return [(SAMPLERS[0], DEFAULT)] + [(sampler, LATE) for sampler in SAMPLERS[:2]]

    def integrator(self, rr_depth):
        return mi.load_dict({"type": "volpath" if self.medium else "path", "max_depth": -1, "rr_depth": rr_depth})

    def run_of(self, integrator, sampler):
        """A function of samples and a seed that returns values and seconds."""
        one = self.render if self.is_image else self.trace
        return lambda samples, seed: one(integrator, sampler, samples, seed)

    def render(self, integrator, sampler, samples, seed):
        width, height = self.receiver["resolution"]
        passes = passes_of(samples, width * height)
        each = samples // passes
        sensor = self.sensor(sampler, each)
        start = time.perf_counter()
        total = 0.0
        for number in range(passes):
            image = mi.render(self.world, sensor=sensor, integrator=integrator, spp=each, seed=seed * 4096 + number)
            total = total + np.array(image, float).reshape(-1)
        return total / passes, time.perf_counter() - start

    def sensor(self, sampler, samples):
        origin, middle, top = (np.array(self.receiver[key]) for key in ("origin", "middle", "top"))
        width, height = self.receiver["resolution"]
        fov = 2 * math.degrees(math.atan(np.linalg.norm(top - middle) / np.linalg.norm(middle)))
        to_world = mi.ScalarTransform4f().look_at(
            origin=origin.tolist(), target=(origin + middle).tolist(), up=(top - middle).tolist()
        )
        film = {"type": "hdrfilm", "width": width, "height": height, "rfilter": {"type": "box"}, "pixel_format": "luminance"}
        return mi.load_dict({
            "type": "perspective", "fov": fov, "fov_axis": "y", "to_world": to_world, "film": film,
            "sampler": {"type": sampler, "sample_count": samples},
        })  # fmt: skip

    def trace(self, integrator, sampler_type, samples, seed):
        passes = passes_of(samples, 1)
        each = samples // passes
        total = 0.0
        start = time.perf_counter()
        for number in range(passes):
            sampler = mi.load_dict({"type": sampler_type, "sample_count": each})
            sampler.set_samples_per_wavefront(each)
            sampler.seed(seed * 4096 + number, each)
            radiance, _, _ = integrator.sample(self.world, sampler, self.rays(sampler, each), self.medium)
            total += float(dr.sum(mi.Float64(radiance[0]))[0])
        return np.array([total / (each * passes)]), time.perf_counter() - start

    def rays(self, sampler, count):
        along = self.receiver.get("direction") or self.receiver["normal"]
        start = mi.Point3f(*(np.array(self.receiver["origin"]) + OFF * np.array(along)).tolist())
        towards = mi.Vector3f(*along)
        if "normal" in self.receiver:
            towards = mi.Frame3f(towards).to_world(mi.warp.square_to_cosine_hemisphere(sampler.next_2d()))
        wide = dr.zeros(mi.Float, count)
        return mi.RayDifferential3f(o=start + wide, d=towards + wide)

    def measure(self):
        # irradiance is π times the mean radiance of directions by the cosine law
        factor = math.pi if "normal" in self.receiver else 1.0
        for sampler, rr_depth in self.variants():
            one = self.run_of(self.integrator(rr_depth), sampler)
            run = lambda samples, seed: scaled(factor, *one(samples, seed))
            taken, error, remark, found = time_to(run, self.exact, self.target, FIRST[self.is_image])
            remark += f"; {difference(found, self.exact)}"
            if self.is_image and self.known is not None:
                remark += f"; {outliers(one, self.known)}"
            how = "" if rr_depth == DEFAULT else ", late roulette"
            scene.told(f"{PROGRAM} ({sampler}{how})", self.name, taken, error, remark)


def medium(here):
    extinction = here["absorption"] + here["scattering"]
    albedo = here["scattering"] / extinction
    return mi.load_dict({"type": "homogeneous", "albedo": albedo, "sigma_t": extinction, "phase": {"type": "isotropic"}})


def scaled(factor, found, seconds):
    return factor * found, seconds


def outliers(run, known):
    """What there is to say of an image all of whose pixels have one known value, as the bench says it of its own."""
    found = np.array([run(EACH, seed)[0] for seed in range(1000, 1000 + SEEDS)])
    means = np.append(found.mean(axis=0), found.mean())
    errors = np.append(found.std(axis=0, ddof=1), found.mean(axis=1).std(ddof=1)) / math.sqrt(SEEDS)
    deviations = np.abs(means - known) / errors
    pixels = deviations[:-1]
    return (
        f"{(pixels > FAR).sum()} of {len(pixels)} pixels beyond {FAR:.0f} σ, largest deviation {pixels.max():.1f} σ, "
        f"brightest pixel {means[:-1].max() / known:.2f} times the true value; means deviate by {deviations[-1]:.1f} σ"
    )


for path in sorted(scene.FOLDER.glob("*.json")):
    Work(path).measure()
