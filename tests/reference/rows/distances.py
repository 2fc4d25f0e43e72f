"""Warps to distances along a ray, and measures and Jacobians."""

from mpmath import atan, exp, log, mpf, pi, tan

from .table import exact, over_scales, row, uniform
from .vectors import cross, dot, minus, named, norm, plus, times, vector


def equiangular():
    cases = [(over_scales(-1, 1), uniform(-5, 0), uniform(0.1, 5), uniform(0, 1), "") for _ in range(7)]
    cases += [
        (1e-6, -1.0, 2.0, 0.5, "near the light"),
        (1e6, 1.0, 2.0, 0.3, "far from the light"),
        (1.0, 3.0, 3.0 + 2.0**-40, 0.5, "short"),
        (1e-3, 5.0, 9.0, 0.25, "beyond the light"),
        (0.5, -9.0, -5.0, 0.75, "before the light"),
        (1.0, 1e8, 2e8, 0.5, "far away"),
    ]
    for h, t0, t1, u, why in cases:
        a, low, high, p = exact((h, t0, t1, u))
        covered = atan(high / a) - atan(low / a)
        args, said = {"h": h, "t0": t0, "t1": t1}, {"hard": bool(why), "why": why}
        value = a * tan(atan(low / a) + p * covered)
        row("equiangular_sample", "h tan of the angle that u divides", args | {"u": u}, value, **said)
        place = t0 + u * (t1 - t0)
        value = a / ((a**2 + mpf(place) ** 2) * covered)
        row("equiangular_pdf", "h/((h**2 + t**2) angle)", args | {"t": place}, value, **said)


def free_flight():
    cases = [(over_scales(-3, 3), uniform(0, 1)) for _ in range(8)]
    for sigma, u in cases + [(1.0, 1e-15), (2.0, 1 - 2.0**-53), (1e-300, 0.5)]:
        s, p = exact((sigma, u))
        row("free_flight_sample", "-log(1 - u)/sigma", {"sigma": sigma, "u": u}, -log(1 - p) / s, hard=u < 1e-9)
        t = float(-log(1 - p) / s)
        args, depth = {"sigma": sigma, "t": t}, s * mpf(t)
        row("free_flight_pdf", "sigma exp(-sigma t)", args, s * exp(-depth), exponent=depth)
        row("free_flight_inverse", "1 - exp(-sigma t)", args, 1 - exp(-depth), hard=u < 1e-9)


def jacobians():
    for _ in range(10):
        r2, c = over_scales(-6, 6), uniform(0.01, 1)
        args = {"r2": r2, "cos_theta": c}
        row("measure_area_to_solid_angle", "cos/r**2", args, mpf(c) / mpf(r2))
        row("measure_solid_angle_to_area", "r**2/cos", args, mpf(r2) / mpf(c))
        row("half_vector_jacobian", "1/(4 cos)", {"cos_oh": c}, 1 / (4 * mpf(c)))
        new, cosine = over_scales(-6, 6), uniform(0.01, 1)
        args = {"r2_old": r2, "cos_old": c, "r2_new": new, "cos_new": cosine}
        value = mpf(cosine) / mpf(new) / (mpf(c) / mpf(r2))
        row("reconnection_jacobian", "(cos_new/r2_new)/(cos_old/r2_old)", args, value)
        factor, radiance = uniform(0, 1), over_scales(-20, 20)
        args = {"form_factor": factor, "radiance": radiance}
        row("irradiance", "pi F L", args, pi * mpf(factor) * mpf(radiance))


def densities():
    for _ in range(10):
        u, v = over_scales(-3, 3), -over_scales(-3, 3)
        value = (1 + mpf(u) ** 2 + mpf(v) ** 2) ** mpf(-1.5)
        row("solid_angle_density_plane", "(1 + u**2 + v**2)**(-3/2)", {"u": u, "v": v}, value)
        corners = [plus([x, y, 2.0], vector(0.3)) for x, y in ((0, 0), (1, 0), (0, 1), (1, 1))]
        u, v = uniform(0, 1), uniform(0, 1)
        p, q, r, s = (exact(corner) for corner in corners)
        a, b = exact((u, v))
        by_u = plus(times(1 - b, minus(q, p)), times(b, minus(s, r)))
        by_v = plus(times(1 - a, minus(r, p)), times(a, minus(s, q)))
        place = plus(plus(times(1 - b, p), times(b, r)), times(a, by_u))
        value = dot(place, cross(by_u, by_v)) / norm(place) ** 3
        args = named("pqrs", *corners) | {"u": u, "v": v}
        row("solid_angle_density_patch", "p.(dp/du x dp/dv)/|p|**3", args, value)


PARTS = (equiangular, free_flight, jacobians, densities)
