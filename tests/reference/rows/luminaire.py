"""A triangle of linearly varying radiance, in polar coordinates about the foot of the receiver.

With r**2 = rho**2 + h**2 an element of area gives L z h/r**4 rho drho dphi. L and z are linear in rho, so that the integral
over rho is elementary; that over phi along each edge is taken numerically.
"""

from fractions import Fraction

from mpmath import atan, fabs, log, mp, mpf, pi, sqrt, workdps

from .polygons import clipped, lambert
from .table import integral, row, uniform
from .vectors import cross, dot, minus, named, norm, plus, rational, real, times, unit


class Luminaire:
    """A triangle seen from the origin, with exact numbers, cut by the horizon."""

    def __init__(self, corners, radiance):
        a, b, c = (rational(corner) for corner in corners)
        la, lb, lc = (Fraction(value) for value in radiance)
        normal = cross(minus(b, a), minus(c, a))
        volume, square = dot(a, normal), dot(normal, normal)
        above = clipped([a, b, c], lambda corner: corner[2])
        self.part = above if volume and len(above) > 2 else []
        self.foot = times(volume / square, normal)
        self.distance = norm(real(self.foot))
        self.normal = unit(real(normal))
        slope = plus(times(lb - la, cross(minus(c, a), normal)), times(lc - la, cross(normal, minus(b, a))))
        slope = times(1 / square, slope)
        self.slope = real(slope)
        self.at_foot = real([la + dot(slope, minus(self.foot, a)), self.foot[2]])

    def irradiance(self):
        """The integral of L cos cos'/r**2 over the triangle above the horizon, in polar coordinates about the foot."""
        edges = zip(self.part, self.part[1:] + self.part[:1])
        return sum((self.along(u, v) for u, v in edges if u != v), mpf(0))

    def along(self, u, v):
        """What lies between the foot and an edge, by the length along it: phi = atan(l/p)."""
        start, stop = real(minus(u, self.foot)), real(minus(v, self.foot))
        along = unit(minus(stop, start))
        outward = cross(along, self.normal)
        p = dot(start, outward)
        if fabs(p) <= norm(start) * mpf(10) ** (10 - mp.dps):
            return mpf(0)

        def wedge(l):
            place = plus(times(p, outward), times(l, along))
            return self.between_foot_and(place) * p / (p**2 + l**2)

        ends = dot(start, along), dot(stop, along)
        marks = {*ends, mpf(0)}
        for scale in (fabs(p), sqrt(p**2 + self.distance**2)):
            marks |= {sign * scale * mpf(4) ** step for step in range(-1, 20) for sign in (-1, 1)}
        return integral(wedge, (mark for mark in marks if ends[0] <= mark <= ends[1]))

    def between_foot_and(self, place):
        """The integral of h L z/r**4 rho drho on the way to a place, where L and z are linear in rho."""
        h, rho = self.distance, norm(place)
        r2 = rho**2 + h**2
        first = (1 / h**2 - 1 / r2) / 2
        second = (atan(rho / h) / h - rho / r2) / 2
        third = (log(r2 / h**2) + h**2 / r2 - 1) / 2
        l0, z0 = self.at_foot
        l1, z1 = dot(self.slope, place) / rho, place[2] / rho
        return h * (l0 * z0 * first + (l0 * z1 + z0 * l1) * second + l1 * z1 * third)


def anywhere(lowest):
    corners = [[uniform(-2, 2), uniform(-2, 2), uniform(lowest, 2)] for _ in range(3)]
    return "", corners, [uniform(0, 3) for _ in range(3)]


LEVEL = [[-1.0, -1.0, 1.0], [2.0, -0.5, 1.0], [-0.5, 2.0, 1.0]]
TILTED = [[1.0, 0.5, 1.0], [2.0, -1.0, 3.0], [-0.5, 1.5, 2.0]]
RISING = [1.0, 2.0, 3.0]


def about(heights):
    """A triangle around the normal with corners at these heights."""
    return [[2.0, 1.0, heights[0]], [-1.0, 2.0, heights[1]], [0.5, -3.0, heights[2]]]


HARD = (
    ("parallel to the receiver", LEVEL, [1.0, 2.0, 4.0]),
    ("even radiance", TILTED, [2.0, 2.0, 2.0]),
    ("even radiance, cut", about([2.0, -1.0, -0.5]), [2.0, 2.0, 2.0]),
    ("one corner bright", TILTED, [0.0, 5.0, 0.0]),
    ("a corner on the horizon", about([0.0, 1.0, 2.0]), RISING),
    ("a corner on the horizon, cut", about([0.0, -1.0, 2.0]), RISING),
    ("an edge on the horizon", about([0.0, 0.0, 2.0]), RISING),
    ("an edge on the horizon, below", about([0.0, 0.0, -2.0]), RISING),
    ("two corners above", about([1.0, 0.5, -2.0]), RISING),
    ("a sliver above", about([-1.0, -0.5, 1e-6]), RISING),
    ("a corner just below", about([1.0, -1e-9, 0.5]), RISING),
    ("below", about([-1.0, -0.5, -0.25]), RISING),
    ("upright", [[1.0, -1.0, 0.5], [1.0, 1.0, 0.5], [1.0, 0.25, 2.0]], RISING),
    ("upright and cut", [[1.0, -1.0, -0.5], [1.0, 1.0, -0.5], [1.0, 0.25, 2.0]], RISING),
    ("small", [[1.0, 0.5, 2.0], [1.0 + 1e-4, 0.5, 2.0], [1.0, 0.5 + 1e-4, 2.0 + 5e-5]], RISING),
    ("tiny", [[1.0, 0.5, 2.0], [1.0 + 1e-9, 0.5, 2.0], [1.0, 0.5 + 1e-9, 2.0 + 5e-10]], RISING),
    ("far", [[1e4, 5e3, 2e4], [1e4 + 1, 5e3, 2e4], [1e4, 5e3 + 1, 2e4 + 0.5]], RISING),
    ("nearly in its plane, beside it", [[1.0, 0.5, 1.0], [2.0, 1.0, 3.0], [1.0, 0.5 + 1e-6, 2.0]], RISING),
    ("grazing", [[1.0, -0.5, 1e-9], [2.0, 1.0, 3e-9], [1.5, 2.0, 2e-9]], RISING),
    ("close above the receiver", [[-1.0, -1.0, 1e-6], [2.0, -0.5, 1e-6], [-0.5, 2.0, 2e-6]], RISING),
    ("very close above the receiver", [[-1.0, -1.0, 1e-12], [2.0, -0.5, 1e-12], [-0.5, 2.0, 1e-12]], RISING),
    ("in its plane", [[1.0, 0.0, 1.0], [2.0, 0.0, 1.0], [1.0, 0.0, 3.0]], RISING),
    ("foot on the line of an edge", [[1.0, 0.0, 1.0], [2.0, 0.0, 1.0], [1.0, 2.0, 1.0]], RISING),
    ("foot on an edge", [[-1.0, 0.0, 1.0], [2.0, 0.0, 1.0], [1.0, 2.0, 1.0]], RISING),
    ("foot at a corner", [[0.0, 0.0, 1.0], [2.0, 0.0, 1.0], [1.0, 2.0, 1.0]], RISING),
    ("large", [[-1e6, -1e6, 1.0], [2e6, -1e6, 1.0], [0.0, 2e6, 1.0]], RISING),
    ("scaled", [[1e20, 5e19, 1e20], [2e20, -1e20, 3e20], [-5e19, 1.5e20, 2e20]], RISING),
)


def luminaires():
    cases = [anywhere(0.2) for _ in range(6)] + [anywhere(-2) for _ in range(5)]
    for why, corners, radiance in (*cases, *HARD):
        with workdps(60):
            value = Luminaire(corners, radiance).irradiance()
            if radiance[0] == radiance[1] == radiance[2]:
                even = pi * mpf(radiance[0]) * lambert([rational(corner) for corner in corners], [0, 0, 1])
                assert fabs(value - even) < even * mpf(10) ** -40, (value, even)
        args = named("abc", *corners) | dict(zip(("la", "lb", "lc"), radiance))
        row("irradiance_linear_luminaire", Luminaire.irradiance.__doc__, args, value, hard=bool(why), why=why)


PARTS = (luminaires,)
