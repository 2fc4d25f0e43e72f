"""Exchange between polygons: the logarithm of the distance by its integral, the density by exact fractions."""

from fractions import Fraction
from random import Random

from mpmath import log, mpf, pi

from .table import integral, row
from .vectors import cross, dot, real

OWN = Random(12)


def potential():
    def case(start, direction, length, why=""):
        a, e = ([Fraction(x) for x in v] for v in (start, direction))
        foot, square = dot(a, e), dot(cross(a, e), cross(a, e))
        foot, square = real([foot, square])

        def log_distance(t):
            return log(square + (foot + t) ** 2) / 2

        marks = [mpf(0), mpf(length)]
        if 0 < -foot < length:
            marks.append(-foot)
        names = ("ax", "ay", "az", "ex", "ey", "ez", "length")
        args = dict(zip(names, [*start, *direction, length]))
        formula = "The logarithm of the distance, integrated along the edge."
        row("edge_potential", formula, args, integral(log_distance, marks), hard=bool(why), why=why)

    for _ in range(6):
        way = [OWN.uniform(-1, 1) for _ in range(3)]
        size = sum(x * x for x in way) ** 0.5
        case([OWN.uniform(-3, 3) for _ in range(3)], [x / size for x in way], OWN.uniform(0.1, 4))
    case([0.0, 0.0, 0.0], [1.0, 0.0, 0.0], 2.0, "from the point on")
    case([-2.0, 0.0, 0.0], [1.0, 0.0, 0.0], 2.0, "to the point")
    case([-0.75, 0.0, 0.0], [1.0, 0.0, 0.0], 2.0, "through the point")
    case([-0.75, 1e-9, 0.0], [1.0, 0.0, 0.0], 2.0, "almost through the point")
    case([1e6, 3.0, -2.0], [1.0, 0.0, 0.0], 1.0, "far away in line")
    case([2.0, 1e7, 5e6], [0.0, 0.0, 1.0], 1e-3, "short and far")


def density():
    def case(way, n, m, why=""):
        r, n_exact, m_exact = ([Fraction(x) for x in v] for v in (way, n, m))
        value = -dot(n_exact, r) * dot(m_exact, r) / dot(r, r) ** 2
        names = ("rx", "ry", "rz", "nx", "ny", "nz", "mx", "my", "mz")
        formula = "cos cos'/(pi r**2), the cosines by exact fractions."
        row(
            "exchange_density",
            formula,
            dict(zip(names, [*way, *n, *m])),
            real([value])[0] / pi,
            hard=bool(why),
            why=why,
        )

    for _ in range(8):
        case(*([OWN.uniform(-1, 1) for _ in range(3)] for _ in range(3)))
    case([1e9, -2e9, 3e8], [0.0, 0.0, 1.0], [0.5, 0.5, -0.5], "far")
    case([1e-9, 2e-9, -3e-9], [1.0, 1.0, 1.0], [0.5, 0.5, -0.5], "close")
    case([1.0, 1e-8, 0.0], [1e-8, -1.0, 0.0], [-1.0, 0.0, 0.0], "in one plane: the cosine vanishes")
    case([1.0, 1.0, 1e-12], [1.0, -1.0, 1.0], [-1.0, 0.0, 0.0], "almost in one plane")


PARTS = (potential, density)
