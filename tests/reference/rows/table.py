"""The table: rows in the format of visible.json, and random inputs from a fixed seed."""

import random

from mpmath import fabs, mp, mpf, quad

mp.dps = 90
DIGITS = 30
ULP = 2.0**-53
# 16 units of rounding, and one unit for each unit of the exponent of an exponential
BASE = 16 * ULP

RANDOM = random.Random(20261122)
ROWS = []


def row(kernel, formula, args, value, exponent=0, terms=0, hard=False, why="", output=None):
    """Adds a row: `args` are doubles by name, `exponent` bounds the exponent of an exponential in the value, and `terms`
    the terms of a sum of which no figures are promised where they cancel."""
    assert mp.isfinite(value), (kernel, args, value)
    count = sum(1 for known in ROWS if known["kernel"] == kernel)
    new = {
        "id": f"{kernel}-{count}",
        "group": kernel,
        "formula": formula,
        "value": mp.nstr(mpf(value), DIGITS, min_fixed=1, max_fixed=0),
        "digits": DIGITS,
        "hard": hard,
        "why": why,
        "kernel": kernel,
        "args": {name: float(value) for name, value in args.items()},
        "rtol": float(f"{BASE + 2 * ULP * float(exponent):.2g}"),
        "atol": float(f"{max(BASE * float(terms), 5e-324):.2g}"),
    }
    if output is not None:
        new["output"] = output
    ROWS.append(new)


def rows(kernel, formula, args, values, **more):
    """A row for each of several outputs."""
    for output, value in enumerate(values):
        row(kernel, formula, args, value, output=output, **more)


def integral(function, marks):
    """The integral over the pieces between the marks, halved once more as a check."""
    marks = sorted(set(marks))
    halves = [(a + b) / 2 for a, b in zip(marks, marks[1:])]
    value, finer = quad(function, marks), quad(function, sorted(marks + halves))
    assert fabs(value - finer) <= fabs(finer) * mpf(10) ** -25, (value, finer)
    return finer


def exact(numbers):
    return [mpf(number) for number in numbers]


def uniform(low, high):
    return RANDOM.uniform(low, high)


def over_scales(low, high):
    """A double whose logarithm is uniform."""
    return 10 ** RANDOM.uniform(low, high)
