"""Polygons: solid angles as angles between arcs, form factors by Lambert after clipping in rational numbers."""

from fractions import Fraction

from mpmath import acos, atan2, fabs, mpf, pi

from .table import exact, row, uniform
from .vectors import cross, dot, minus, named, norm, plus, rational, real, times, unit, vector

TRIANGLE = "signed area of the spherical triangle: the angles between its arcs less pi (Girard)"
LAMBERT = "F = sum of n.(a x b)/|a x b| angle(a, b)/(2 pi |n|) over the edges clipped by the horizon (Lambert 1760)"


def arc_angle(a, b, c):
    """The angle at a between the arcs to b and c."""
    p, q = cross(a, b), cross(a, c)
    return atan2(norm(cross(p, q)), dot(p, q))


def spherical_area(a, b, c):
    """Girard: the angles less a half-turn, with the sign of a.(b x c); rational corners."""
    volume = dot(a, cross(b, c))
    if volume == 0:
        return mpf(0)
    a, b, c = real(a), real(b), real(c)
    area = arc_angle(a, b, c) + arc_angle(b, c, a) + arc_angle(c, a, b) - pi
    return area if volume > 0 else -area


def clipped(corners, height):
    """The part of a polygon where the linear function `height` is not negative (Sutherland and Hodgman), rational."""
    part = []
    for a, b in zip(corners, corners[1:] + corners[:1]):
        p, q = height(a), height(b)
        if p >= 0:
            part.append(a)
        if (p > 0 > q) or (p < 0 < q):
            part.append(plus(times(q / (q - p), a), times(p / (p - q), b)))
    return part


def lambert(corners, normal):
    """Lambert: the form factor of a polygon at the origin, clipped by its horizon, in rational numbers."""
    part = clipped(corners, lambda a: dot(normal, a))
    if len(part) < 3 or dot(corners[0], cross(corners[1], corners[2])) == 0:
        return mpf(0)
    n = unit(real(normal))
    total = mpf(0)
    for a, b in zip(part, part[1:] + part[:1]):
        moment = real(cross(a, b))
        if any(moment):
            angle = atan2(norm(moment), dot(real(a), real(b)))
            total += dot(n, moment) / norm(moment) * angle
    return fabs(total) / (2 * pi)


def triangles():
    """(why, p, a, b, c) of triangles seen from p."""
    for _ in range(4):
        yield "", vector(), vector(3), vector(3), vector(3)
    for scale in (1e-4, 1e-9):
        c = vector(2)
        yield "tiny", vector(), plus(c, vector(scale)), plus(c, vector(scale)), plus(c, vector(scale))
    for scale in (1e5, 1e30, 1e-30, 1e120, 1e-120):
        yield "all lengths scaled", vector(scale), vector(scale), vector(scale), vector(scale)
    c = vector(1e6)
    yield "far", vector(), plus(c, vector()), plus(c, vector()), plus(c, vector())
    for offset in (1e6, 2.0**40):
        yield "huge offset", vector(1, offset), vector(1, offset), vector(1, offset), vector(1, offset)
    for height in (1e-6, 1e-12):
        yield "nearly in its plane", *nearly_coplanar(height, [0.25, 0.5, 0.25])
        yield "nearly in its plane, beside it", *nearly_coplanar(height, [2.5, -1.0, -0.5])
    yield "a needle", vector(), [1.0, 2.0, 3.0], [1.001, 2.0, 3.0], [1.0005, 2.0, 3.0 + 1e-10]
    yield "in its plane, beside it", [0, 0, 0], [1, 0, 0], [2, 1, 0], [3, -1, 0]
    yield "on the line of an edge", [0, 0, 0], [1, 0, 0], [2, 0, 0], [1, 1, 1]
    yield "near a corner", [1e-9, 1e-9, 1e-9], [0, 0, 0], [1, 0, 0.25], [0, 1, 0.5]
    yield "close above it", [0.25, 0.25, 1e-12], [0, 0, 0], [1, 0, 0], [0, 1, 0]


def nearly_coplanar(height, weights):
    """A random triangle, and a place before it so high above the one with these weights of the corners."""
    corners = [vector(), vector(), vector()]
    normal = cross(minus(corners[1], corners[0]), minus(corners[2], corners[0]))
    place = [sum(w * corner[axis] for w, corner in zip(weights, corners)) for axis in range(3)]
    return plus(place, times(height, normal)), *corners


def solid_angles():
    for why, p, *corners in triangles():
        seen = [minus(rational(corner), rational(p)) for corner in corners]
        args = named("pabc", p, *corners)
        row("solid_angle_triangle", TRIANGLE, args, spherical_area(*seen), hard=bool(why), why=why)
    for why, p, o, u, v in rectangles():
        seen = rectangle_corners(p, o, u, v)
        value = spherical_area(*seen[:3]) + spherical_area(seen[0], seen[2], seen[3])
        row("solid_angle_rectangle", TRIANGLE, named("pouv", p, o, u, v), value, hard=bool(why), why=why)


def rectangle_corners(p, o, u, v):
    p, o, u, v = rational(p), rational(o), rational(u), rational(v)
    o = minus(o, p)
    return [o, plus(o, u), plus(plus(o, u), v), plus(o, v)]


def rectangles():
    """(why, p, o, u, v) of rectangles seen from p, their edges at right angles but for rounding."""
    for _ in range(3):
        x, y, z = vector()
        yield "", vector(), vector(2), [x, y, 0.0], [-y, x, 0.0]
        yield "", vector(), vector(2), [x, y, 0.0], [0.0, 0.0, z]
    yield "tiny", vector(), vector(), [1e-9, 0, 0], [0, 2e-9, 0]
    yield "far", vector(), vector(1e7), [1, 0, 0], [0, 0.6, 0.8]
    yield "huge offset", vector(1, 1e8), vector(1, 1e8), [1, 2, 0], [-2, 1, 0]
    yield "scaled up", vector(1e40), vector(1e40), [1e40, 0, 0], [0, 1e39, 0]
    yield "scaled down", vector(1e-40), vector(1e-40), [1e-40, 0, 0], [0, 1e-39, 0]
    yield "in its plane, beside it", [0, 0, 0], [1, 1, 0], [1, 0, 0], [0, 1, 0]
    yield "close above it", [0.5, 0.5, 1e-10], [0, 0, 0], [1, 0, 0], [0, 1, 0]
    yield "grazing", [0, 0, 1e-8], [1, 1, 0], [1, 0, 0], [0, 1, 0]
    yield "nearly in a tilted plane", [0.5, 0.5, 1.0 + 1e-11], [0, 0, 0], [1, 0, 1], [0, 1, 1]


def normal_for(why):
    return [0, 0, 1] if "plane" in why or why in ("close above it", "grazing") else vector()


def form_factors():
    for why, p, *corners in triangles():
        n = normal_for(why)
        value = lambert([minus(rational(corner), rational(p)) for corner in corners], rational(n))
        args = named("pnabc", p, n, *corners)
        row("form_factor_point_triangle", LAMBERT, args, value, hard=bool(why), why=why)
    for why, p, o, u, v in rectangles():
        n = normal_for(why)
        value = lambert(rectangle_corners(p, o, u, v), rational(n))
        args = named("pnouv", p, n, o, u, v)
        row("form_factor_point_rectangle", LAMBERT, args, value, hard=bool(why), why=why)


def at_the_horizon():
    here, up = [0, 0, 0], [0, 0, 2]
    for heights, why in (
        ((0, 1, 2), "a corner on the horizon"),
        ((0, -1, 2), "a corner on the horizon, the triangle cut by it"),
        ((0, 0, 1), "an edge on the horizon"),
        ((0, 0, -1), "below, but for an edge on the horizon"),
        ((1e-9, 1, -1), "a corner just above the horizon"),
        ((-1, -2, 1e-9), "a sliver above the horizon"),
        ((-1, -1, -3), "below the horizon"),
    ):
        corners = [[2, 1, heights[0]], [-1, 2, heights[1]], [-0.5, -3, heights[2]]]
        value = lambert([rational(corner) for corner in corners], rational(up))
        args = named("pnabc", here, up, *corners)
        row("form_factor_point_triangle", LAMBERT, args, value, hard=True, why=why)
    for heights, why in (
        ((-1, 2, 1), "one corner below"),
        ((0, 2, -1), "a corner on the horizon"),
        ((-1e-9, 1, 1), "a corner just below the horizon"),
    ):
        o, u, v = [-1, -2, heights[0]], [3, 0, heights[1]], [0, 4, heights[2]]
        value = lambert(rectangle_corners(here, o, u, v), rational(up))
        row("form_factor_point_rectangle", LAMBERT, named("pnouv", here, up, o, u, v), value, hard=True, why=why)


def edges():
    for _ in range(12):
        a, b, n = vector(), vector(), vector(2)
        moment = cross(exact(a), exact(b))
        angle = acos(dot(exact(a), exact(b)) / norm(exact(a)) / norm(exact(b)))
        terms = [mpf(p) * q * angle / (2 * pi * norm(moment)) for p, q in zip(n, moment)]
        size = sum(fabs(term) for term in terms)
        formula = "n.(a x b)/|a x b| angle(a, b)/(2 pi)"
        row("edge_form_factor", formula, named("abn", a, b, n), sum(terms), terms=size)
    args = named("abn", [1, 2, 3], [2, 4, 6], [0, 0, 1])
    row("edge_form_factor", "0 in line with the receiver", args, 0, hard=True, why="in line with the receiver")


PARTS = (solid_angles, form_factors, at_the_horizon, edges)
