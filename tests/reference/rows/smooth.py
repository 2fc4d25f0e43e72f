"""What paths need of smooth and round things: directions in a cone, and the reflectance of metals."""

from mpmath import fabs, mpc, mpf, pi, sqrt

from .square import circle, direction, squares, turns_of
from .table import exact, row, rows, uniform


def cones():
    heights = (0.5, 1.0, 2.0, 1e-3, 1e-12, 0.1, 1.5, 0.25, 1e-30, 0.75, 1e-6, 0.3, 1.25, 1e-300)
    for height, (u, v, why) in zip(heights, squares()):
        h, p, q = exact((height, u, v))
        below = p * h
        point = circle(sqrt(below * (2 - below)), q) + (1 - below,)
        said = {"hard": bool(why) or height < 1e-2, "why": why or ("narrow" if height < 1e-2 else "")}
        args = {"h": height, "u": u, "v": v}
        rows("uniform_cone_sample", "z = 1 - u h, azimuth 2 pi v", args, point, **said)
        x, y, z = direction(float(1 - uniform(0, min(height, 1)) / 2))
        args = {"h": height, "x": x, "y": y, "z": z}
        row("uniform_cone_pdf", "1/(2 pi h)", args, 1 / (2 * pi * h), **said)
        # on the axis there is no azimuth
        found = ((1 - mpf(z)) / h,) + ((turns_of(x, y),) if x or y else ())
        rows("uniform_cone_inverse", "((1 - z)/h, share of a turn)", args, found, **said)


def metal(eta, k, c):
    """mean of the squares of both amplitudes of Fresnel, of a complex index"""
    n = mpc(eta, k)
    bent = sqrt(1 - (1 - c**2) / n**2)
    s, p = (c - n * bent) / (c + n * bent), (n * c - bent) / (n * c + bent)
    return (fabs(s) ** 2 + fabs(p) ** 2) / 2


def metals():
    cases = [(uniform(0.1, 4), uniform(0.5, 8), uniform(0, 1), "") for _ in range(10)]
    cases += [
        (0.2, 3.9, 1.0, "straight on"),
        (0.2, 3.9, 0.0, "grazing"),
        (1.5, 0.0, 0.5, "no metal"),
        (1e-3, 10.0, 0.3, "nearly perfect"),
        (30.0, 60.0, 1e-3, "nearly grazing"),
    ]
    for eta, k, c, why in cases:
        args = {"eta": eta, "k": k, "c": c}
        row("fresnel_conductor", metal.__doc__, args, metal(*exact((eta, k, c))), hard=bool(why), why=why)


PARTS = (cones, metals)
