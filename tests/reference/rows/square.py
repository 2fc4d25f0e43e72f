"""Points of the unit square, and warps of it to the sphere, hemisphere, disk and triangle."""

from mpmath import atan2, cos, mpf, pi, sin, sqrt

from .table import exact, row, rows, uniform

# the last place at most off a turn, where a sine or cosine nearly vanishes
CORNERS = (
    (0.3, 0.25, "a quarter turn"),
    (0.7, 0.5, "a half turn"),
    (0.4, 0.75, "three quarters"),
    (1e-12, 0.1, "near the axis"),
    (1 - 2.0**-40, 0.3, "near the end"),
    (0.5, 0.25 + 2.0**-40, "nearly a quarter turn"),
    (0.5, 0.5 - 2.0**-50, "nearly a half turn"),
    (0.2, 1 - 2.0**-45, "nearly a whole turn"),
    (2.0**-300, 2.0**-300, "tiny"),
)


def squares():
    """(u, v, why) of the unit square."""
    return [(uniform(0, 1), uniform(0, 1), "") for _ in range(5)] + list(CORNERS)


def circle(radius, turns):
    """Radius and turns as coordinates, 0 at quarter turns."""
    across = mpf(0) if turns in (0.25, 0.75) else cos(2 * pi * turns)
    along = mpf(0) if turns in (0, 0.5) else sin(2 * pi * turns)
    return radius * across, radius * along


def turns_of(x, y):
    """The turns of a point, from 0 to 1."""
    return atan2(mpf(y), mpf(x)) / (2 * pi) % 1


def direction(u):
    """A direction as doubles, with z = 2 u - 1."""
    z, turn = 2 * u - 1, uniform(0, 6.25)
    s = float(sqrt(1 - mpf(z) ** 2))
    return s * float(cos(turn)), s * float(sin(turn)), z


def samples():
    for u, v, why in squares():
        p, q = exact((u, v))
        found = (
            ("uniform_sphere", "z = 1 - 2 u, azimuth 2 pi v", circle(2 * sqrt(p * (1 - p)), q) + (1 - 2 * p,)),
            ("uniform_hemisphere", "z = u, azimuth 2 pi v", circle(sqrt(1 - p**2), q) + (p,)),
            ("cosine_hemisphere", "sin**2 = u, azimuth 2 pi v", circle(sqrt(p), q) + (sqrt(1 - p),)),
            ("uniform_disk", "radius sqrt(u), azimuth 2 pi v", circle(sqrt(p), q)),
            ("uniform_triangle", "(1 - sqrt(u), v sqrt(u))", (1 - sqrt(p), q * sqrt(p))),
        )
        for warp, formula, values in found:
            rows(f"{warp}_sample", formula, {"u": u, "v": v}, values, hard=bool(why), why=why)


def densities_and_inverses():
    for _ in range(10):
        x, y, z = direction(uniform(0, 1))
        upper = {"x": x, "y": y, "z": abs(z)}
        p = uniform(0, 0.9)
        corner = {"p": p, "q": uniform(0, 1 - p)}
        height, turns, radius = mpf(z), turns_of(x, y), mpf(x) ** 2 + mpf(y) ** 2
        triangle = ((1 - mpf(p)) ** 2, mpf(corner["q"]) / (1 - mpf(p)))
        for warp, args, density, inverse in (
            ("uniform_sphere", {"x": x, "y": y, "z": z}, 1 / (4 * pi), ((1 - height) / 2, turns)),
            ("uniform_hemisphere", upper, 1 / (2 * pi), (abs(height), turns)),
            ("cosine_hemisphere", upper, abs(height) / pi, (radius, turns)),
            ("uniform_disk", {"p": x, "q": y}, 1 / pi, (radius, turns)),
            ("uniform_triangle", corner, mpf(2), triangle),
        ):
            row(f"{warp}_pdf", "share of the whole per unit", args, density)
            rows(f"{warp}_inverse", "shares before the point, in both directions", args, inverse)


PARTS = (samples, densities_and_inverses)
