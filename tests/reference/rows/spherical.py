"""Warps to the solid angle of rectangles and triangles: the place that cuts off a share is found as a root."""

from mpmath import acos, cos, fabs, mpf, sin, sqrt, workdps

from .polygons import spherical_area
from .table import exact, row, rows, uniform
from .vectors import cross, dot, minus, named, plus, rational, times, unit, vector


def bisected(function, low, high):
    """The root of an increasing function, which the interval contains."""
    for _ in range(220):
        middle = (low + high) / 2
        low, high = (middle, high) if function(middle) < 0 else (low, middle)
    return (low + high) / 2


def rectangle_area(x0, x1, y0, y1, h):
    corners = [[x0, y0, h], [x1, y0, h], [x1, y1, h], [x0, y1, h]]
    return spherical_area(*corners[:3]) + spherical_area(corners[0], corners[2], corners[3])


def of_rectangle(x0, x1, y0, y1, h, u, v):
    """u: share of the area up to x; v: share of the sine of the elevation (Urena et al. 2013)"""
    whole = rectangle_area(x0, x1, y0, y1, h)
    x = bisected(lambda x: rectangle_area(x0, x, y0, y1, h) - u * whole, x0, x1)
    low, high = (y / sqrt(x**2 + y**2 + h**2) for y in (y0, y1))
    elevation = (1 - v) * low + v * high
    level = sqrt(1 - elevation**2) / sqrt(x**2 + h**2)
    return (level * x, elevation, level * h), whole


def rectangles():
    cases = [
        (*(uniform(*ends) for ends in ((-2, 0), (0.1, 2), (-2, 0), (0.1, 2), (0.2, 3), (0, 1), (0, 1))), "")
        for _ in range(6)
    ]
    cases += [
        (1.0, 2.0, 3.0, 5.0, 0.5, 0.3, 0.8, "aside"),
        (-1.0, 1.0, -1.0, 1.0, 1e-6, 0.25, 0.5, "close"),
        (1.0, 1.001, 2.0, 2.001, 1.0, 0.5, 0.5, "small"),
        (-1.0, 2.0, -2.0, 1.0, 1e4, 0.7, 0.2, "far"),
        (-3.0, -1.0, 2.0, 4.0, 1.0, 0.0, 1.0, "a corner"),
    ]
    for *numbers, why in cases:
        with workdps(60):
            point, whole = of_rectangle(*exact(numbers))
        x0, x1, y0, y1, h, u, v = numbers
        args = {"x0": x0, "x1": x1, "y0": y0, "y1": y1, "h": h}
        said = {"hard": bool(why), "why": why}
        rows("spherical_rectangle_sample", of_rectangle.__doc__, args | {"u": u, "v": v}, point, **said)
        inside = args | {"x": x0 + 0.5 * (x1 - x0), "y": y0 + 0.25 * (y1 - y0), "z": h}
        row("spherical_rectangle_pdf", "1/area", inside, 1 / whole, **said)
        row("spherical_rectangle_pdf", "0 outside", inside | {"x": x1 + 1}, 0, **said)


def of_triangle(a, b, c, u, v):
    """u: share of the area cut off at a; v: share of one less the cosine from b (Arvo 1995)"""
    tangent = unit(minus(c, times(dot(a, c), a)))

    def side(turn):
        return plus(times(cos(turn), a), times(sin(turn), tangent))

    share = u * fabs(spherical_area(a, b, c))
    end = side(bisected(lambda turn: fabs(spherical_area(a, b, side(turn))) - share, mpf(0), acos(dot(a, c))))
    cosine = 1 - v * (1 - dot(end, b))
    along = unit(minus(end, times(dot(end, b), b)))
    return plus(times(cosine, b), times(sqrt(1 - cosine**2), along))


def triangles():
    cases = [([vector(), vector(), vector()], uniform(0, 1), uniform(0, 1), "") for _ in range(8)]
    cases += [
        ([[1, 0, 0], [0, 1, 0], [0, 0, 1]], 0.5, 0.5, "an octant"),
        ([[1.0, 2.0, 3.0], [1.0 + 1e-6, 2.0, 3.0], [1.0, 2.0 + 1e-6, 3.0]], 0.3, 0.6, "small"),
        ([[1, 0, 1e-8], [0, 1, 1e-8], [-1, -1, 1e-8]], 0.4, 0.7, "nearly a hemisphere"),
        ([[1e30, 0, 1e30], [0, 1e30, 2e30], [1e30, 1e30, 5e30]], 0.2, 0.9, "scaled"),
    ]
    for corners, u, v, why in cases:
        with workdps(60):
            point = of_triangle(*(unit(exact(corner)) for corner in corners), *exact((u, v)))
        args, said = named("abc", *corners), {"hard": bool(why), "why": why}
        rows("spherical_triangle_sample", of_triangle.__doc__, args | {"u": u, "v": v}, point, **said)
        centre = [sum(corner[axis] for corner in corners) for axis in range(3)]
        area = fabs(spherical_area(*(rational(corner) for corner in corners)))
        if is_inside(centre, corners):
            row("spherical_triangle_pdf", "1/area", args | dict(zip("xyz", centre)), 1 / area, **said)
        opposite = dict(zip("xyz", times(-1, centre)))
        row("spherical_triangle_pdf", "0 outside", args | opposite, 0, **said)


def is_inside(direction, corners):
    """Whether the direction is beside every side like the third corner, in rational numbers."""
    a, b, c = (rational(corner) for corner in corners)
    volume = dot(a, cross(b, c))
    return all(dot(rational(direction), cross(s, t)) * volume > 0 for s, t in ((a, b), (b, c), (c, a)))


PARTS = (rectangles, triangles)
