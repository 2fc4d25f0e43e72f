"""What a receiver gathers: light of every kind in the directions it comes from, its sum by exact fractions."""

from fractions import Fraction
from random import Random

from mpmath import pi

from .table import row
from .vectors import real

OWN = Random(29)


def gathered():
    def case(emitted, open_part, outside, beams, reflected, why=""):
        # the radiance of all directions, weighted as the receiver weighs them; a beam and what is reflected are irradiances
        exact = [Fraction(x) for x in (emitted, open_part, outside, beams, reflected)]
        radiance, irradiance = real([exact[0] + exact[1] * exact[2], exact[3] + exact[4]])
        names = ("emitted", "open", "outside", "beams", "reflected")
        args = dict(zip(names, (emitted, open_part, outside, beams, reflected)))
        formula = "pi times the weighted radiance, and irradiances, by exact fractions."
        row("gathered_light", formula, args, pi * radiance + irradiance, hard=bool(why), why=why)

    for _ in range(8):
        case(*(OWN.uniform(0, 1) * 10 ** OWN.uniform(-3, 3) for _ in range(5)))
    case(2.5, 0.0, 0.0, 0.0, 0.0, "luminaires alone")
    case(0.0, 0.75, 10.0, 0.0, 0.0, "the sky alone")
    case(0.0, 0.0, 0.0, 3.0, 0.0, "beams alone")
    case(0.0, 0.0, 0.0, 0.0, 7.0, "reflected light alone")
    case(0.0, 0.0, 0.0, 0.0, 0.0, "no light")
    case(1e-300, 1e-200, 1e-100, 1e-300, 1e-300, "hardly any light")
    case(1e300, 1.0, 1e-300, 1e200, 1e280, "bright luminaires")
    case(1e-9, 2.0**-52, 1e9, 1e-7, 1e-8, "a chink of a bright sky")


PARTS = (gathered,)
