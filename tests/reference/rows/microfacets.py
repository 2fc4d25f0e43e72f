"""Normals of rough surfaces."""

from mpmath import cos, exp, log, pi, sin, sqrt

from .square import circle, squares, turns_of
from .table import exact, row, rows, uniform
from .vectors import dot, minus, norm, plus, times, unit

ROUGHNESS = (0.5, 0.1, 1.0, 1e-3, 0.7, 0.3, 2.0, 0.05, 1e-6, 0.25, 0.9, 0.4, 0.6, 1e-2)


def samples():
    for alpha, (u, v, why) in zip(ROUGHNESS, squares()):
        a, p, q = exact((alpha, u, v))
        args, said = {"alpha": alpha, "u": u, "v": v}, {"hard": bool(why) or alpha < 1e-2, "why": why}
        for kernel, tangent, formula in (
            ("ggx_sample", a * sqrt(p / (1 - p)), "tan = alpha sqrt(u/(1 - u)), azimuth 2 pi v"),
            ("beckmann_sample", a * sqrt(-log(1 - p)), "tan = alpha sqrt(-log(1 - u)), azimuth 2 pi v"),
        ):
            cosine = 1 / sqrt(1 + tangent**2)
            rows(kernel, formula, args, circle(tangent * cosine, q) + (cosine,), **said)
        view = [uniform(-1, 1), uniform(-1, 1), uniform(0.1, 1)]
        formula = "half vector of the stretched view and a direction of its cap, stretched (Dupuy and Benyoub 2023)"
        args |= dict(zip(("wx", "wy", "wz"), view))
        rows("ggx_visible_sample", formula, args, visible_normal(a, exact(view), p, q), **said)


def stretched(alpha, v):
    return [alpha * v[0], alpha * v[1], v[2]]


def visible_normal(alpha, view, u, v):
    e = unit(stretched(alpha, view))
    z = 1 - u * (1 + e[2])
    half = plus([*circle(sqrt(1 - z**2), v), z], e)
    return unit(stretched(alpha, half))


def numbers_of(alpha, view, normal):
    """The share of the cap above the direction that the stretched view is reflected to, and its turns."""
    e, m = unit(stretched(alpha, view)), unit(stretched(1 / alpha, normal))
    reflected = minus(times(2 * dot(e, m), m), e)
    return (1 - reflected[2]) / (1 + e[2]), turns_of(*reflected[:2])


def densities_and_inverses():
    for alpha in ROUGHNESS:
        tangent, turn = alpha * uniform(0.1, 2), uniform(0, 6.25)
        place = [tangent * float(cos(turn)), tangent * float(sin(turn)), 1.0]
        args, said = {"alpha": alpha} | dict(zip("xyz", place)), {"hard": alpha < 1e-2}
        a, normal = exact([alpha])[0], exact(place)
        cosine, ratio = 1 / norm(normal), (normal[0] ** 2 + normal[1] ** 2) / a**2
        turns = turns_of(*place[:2])
        ggx = 1 / (pi * a**2 * cosine**4 * (1 + ratio) ** 2)
        row("ggx_pdf", "D cos", args, ggx * cosine, **said)
        rows("ggx_inverse", "u = tan**2/(alpha**2 + tan**2), turns", args, (ratio / (1 + ratio), turns), **said)
        beckmann = exp(-ratio) / (pi * a**2 * cosine**4)
        row("beckmann_pdf", "D cos", args, beckmann * cosine, exponent=ratio, **said)
        found = (1 - exp(-ratio), turns)
        rows("beckmann_inverse", "u = 1 - exp(-tan**2/alpha**2), turns", args, found, **said)
        view = [uniform(-1, 1), uniform(-1, 1), uniform(0.5, 2)]
        seen, args = exact(view), args | dict(zip(("wx", "wy", "wz"), view))
        if dot(seen, normal) > 0:
            rows("ggx_visible_inverse", numbers_of.__doc__, args, numbers_of(a, seen, normal), **said)
            g1 = 2 * seen[2] / (seen[2] + norm(stretched(a, seen)))
            value = g1 * dot(seen, normal) * cosine * ggx / seen[2]
            row("ggx_visible_pdf", "G1 (w.m) D/w_z", args, value, **said)


PARTS = (samples, densities_and_inverses)
