"""View factors by the formulas of Howell's catalog as they are printed, and of spheres by the overlap of their shadows."""

from mpmath import acos, atan, fabs, log, mpf, pi, sin, sqrt, workdps

from .table import exact, integral, over_scales, row


def parallel_rectangles(a, b, c):
    x, y = a / c, b / c
    logarithm = log((1 + x**2) * (1 + y**2) / (1 + x**2 + y**2)) / 2
    aslant = x * sqrt(1 + y**2) * atan(x / sqrt(1 + y**2)) + y * sqrt(1 + x**2) * atan(y / sqrt(1 + x**2))
    return 2 / (pi * x * y) * (logarithm + aslant - x * atan(x) - y * atan(y))


def perpendicular_rectangles(h, w, l):
    h, w = h / l, w / l
    p, s = sqrt(h**2 + w**2), 1 + h**2 + w**2
    logarithms = log((1 + w**2) * (1 + h**2) / s)
    logarithms += w**2 * log(w**2 * s / ((1 + w**2) * p**2)) + h**2 * log(h**2 * s / ((1 + h**2) * p**2))
    return (w * atan(1 / w) + h * atan(1 / h) - p * atan(1 / p) + logarithms / 4) / (pi * w)


def coaxial_disks(r1, r2, a):
    q = r1**2 + r2**2 + a**2
    return (q - sqrt(q**2 - 4 * r1**2 * r2**2)) / (2 * r1**2)


def sphere_and_rectangle(d, l1, l2):
    x, y = d / l1, d / l2
    return atan(1 / sqrt(x**2 + y**2 + x**2 * y**2)) / (4 * pi)


CATALOG = (
    ("view_factor_parallel_rectangles", "C-11", ("a", "b", "c"), parallel_rectangles),
    ("view_factor_perpendicular_rectangles", "C-14", ("h", "w", "l"), perpendicular_rectangles),
    ("view_factor_coaxial_disks", "C-41", ("r1", "r2", "a"), coaxial_disks),
    ("view_factor_sphere_rectangle", "C-121", ("d", "l1", "l2"), sphere_and_rectangle),
)


def catalog():
    cases = [(over_scales(-1, 1), over_scales(-1, 1), over_scales(-1, 1), "") for _ in range(6)]
    cases += [
        (1.0, 2.0, 1e7, "far"),
        (1.0, 2.0, 1e-7, "close"),
        (1e-7, 1.0, 1.0, "a strip"),
        (1.0, 1e-7, 1.0, "a strip"),
        (1e7, 1.0, 1.0, "long"),
        (1.0, 1e7, 1e-3, "long"),
        (1e50, 1e50, 1e51, "scaled"),
        (1e-50, 3e-50, 1e-50, "scaled"),
    ]
    for kernel, number, names, value in CATALOG:
        for lengths in cases:
            with workdps(250):
                found = value(*exact(lengths[:3]))
            args, why = dict(zip(names, lengths)), lengths[3]
            row(kernel, f"Howell's catalog, {number}", args, found, hard=bool(why), why=why)
    for r1, r2, value in ((1, 2, 1), (2, 1, mpf(1) / 4)):
        args = {"r1": r1, "r2": r2, "a": 0}
        row("view_factor_coaxial_disks", "Howell's catalog, C-41", args, value, hard=True, why="in one plane")


def lines_through_both(r1, r2, distance):
    """The overlap of the shadows of two spheres on planes across a direction, over all directions, by the first area."""

    def overlap(s):
        p = acos((s**2 + r1**2 - r2**2) / (2 * s * r1))
        q = acos((s**2 + r2**2 - r1**2) / (2 * s * r2))
        return r1**2 * (p - sin(2 * p) / 2) + r2**2 * (q - sin(2 * q) / 2)

    def density(s):
        return overlap(s) * 2 * pi * s / (distance * sqrt(distance**2 - s**2))

    low, high = fabs(r1 - r2), r1 + r2
    inside = pi * min(r1, r2) ** 2 * 2 * pi * (1 - sqrt(1 - (low / distance) ** 2))
    return (inside + integral(density, [low, (low + high) / 2, high])) / (4 * pi**2 * r1**2)


def spheres():
    cases = [(1.0, 1.0, 3.0, ""), (0.5, 1.0, 2.0, ""), (2.0, 0.25, 2.5, ""), (1.0, 3.0, 7.0, "")]
    cases += [
        (0.1, 0.2, 1.0, ""),
        (3.0, 1.0, 4.5, ""),
        (1.0, 1.0, 2.0, "touching"),
        (1.0, 2.0, 3.0, "touching"),
        (1.0, 1.0, 1e5, "far"),
        (1e-3, 1.0, 2.0, "small"),
        (1.0, 1e-3, 2.0, "small"),
        (1.0, 1.0, 2.0 + 2.0**-20, "close"),
    ]
    for r1, r2, distance, why in cases:
        with workdps(60):
            value = lines_through_both(*exact((r1, r2, distance)))
        args = {"r1": r1, "r2": r2, "D": distance}
        row("view_factor_spheres", lines_through_both.__doc__, args, value, hard=bool(why), why=why)


PARTS = (catalog, spheres)
