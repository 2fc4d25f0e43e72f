"""Warps about an axis: the phase function of Henyey and Greenstein, the distribution of von Mises and Fisher."""

from mpmath import exp, log, mpf, pi, sqrt, workdps

from .square import circle, direction, squares, turns_of
from .table import exact, row, rows, uniform


def phase(g, cosine):
    return (1 - g**2) / (4 * pi * (1 + g**2 - 2 * g * cosine) ** mpf(1.5))


def warped(g, u):
    """(1 + g**2 - ((1 - g**2)/(1 - g + 2 g u))**2)/(2 g), 2 u - 1 where g = 0"""
    return (1 + g**2 - ((1 - g**2) / (1 - g + 2 * g * u)) ** 2) / (2 * g) if g else 2 * u - 1


def share_before(g, cosine):
    """The share of the phase function from -1 to the cosine."""
    if not g:
        return (1 + cosine) / 2
    return ((1 - g**2) / sqrt(1 + g**2 - 2 * g * cosine) - 1 + g) / (2 * g)


def henyey_greenstein():
    cases = [(uniform(-0.9, 0.95), uniform(0, 1), "") for _ in range(8)]
    cases += [
        (0.0, 0.3, "even"),
        (1e-9, 0.7, "nearly even"),
        (-1e-300, 0.7, "nearly even"),
        (1 - 2.0**-40, 1.0, "forward"),
        (1 - 2.0**-40, 0.0, "away from the peak"),
        (2.0**-40 - 1, 0.25, "backward"),
        (0.999999, 1 - 2.0**-50, "near the peak"),
        (-0.999999, 0.5, "backward"),
        (1e-4, 0.5, "small cosine"),
    ]
    density = "(1 - g**2)/(4 pi (1 + g**2 - 2 g cos)**(3/2))"
    for g, u, why in cases:
        x, y, z = direction(u)
        v, said = uniform(0, 1), {"hard": bool(why), "why": why}
        with workdps(700):
            at, cosine = phase(mpf(g), mpf(z)), warped(mpf(g), mpf(u))
            point = circle(sqrt(1 - cosine**2), mpf(v)) + (cosine,)
            share = share_before(mpf(g), mpf(z))
        row("henyey_greenstein", density, {"g": g, "cos_theta": z}, at, **said)
        row("henyey_greenstein_sample", warped.__doc__, {"g": g, "u": u}, cosine, **said)
        if 0 < u < 1:
            args = {"g": g, "u": u, "v": v}
            rows("henyey_greenstein_direction_sample", "inverse of the distribution", args, point, **said)
        args = {"g": g, "x": x, "y": y, "z": z}
        row("henyey_greenstein_direction_pdf", density, args, at, **said)
        # on the axis there is no azimuth
        found = (share, turns_of(x, y)) if x or y else (share,)
        rows("henyey_greenstein_direction_inverse", share_before.__doc__, args, found, **said)


def von_mises_fisher():
    widths = (1.0, 5.0, 0.1, 100.0, 1e-6, 1e4, 3.0, 0.5, 2.0, 20.0, 1e-12, 1.0, 700.0, 1e6)
    for kappa, (u, v, why) in zip(widths, squares()):
        z = float(1 - min(2, uniform(0, 3) / kappa)) if kappa > 2 else uniform(-1, 1)
        x, y, _ = direction(0.5 + z / 2)
        said = {"hard": bool(why) or not 0.01 < kappa < 50, "why": why}
        with workdps(400):
            k, p, q, t = exact((kappa, u, v, z))
            below = -log(p + (1 - p) * exp(-2 * k)) / k
            point = circle(sqrt(below * (2 - below)), q) + (1 - below,)
            density = k * exp(k * (t - 1)) / (2 * pi * (1 - exp(-2 * k)))
            share = (exp(k * (t - 1)) - exp(-2 * k)) / (1 - exp(-2 * k))
        args = {"kappa": kappa, "u": u, "v": v}
        formula = "exp(-kappa (1 - z)) = u + (1 - u) exp(-2 kappa), azimuth 2 pi v"
        rows("von_mises_fisher_sample", formula, args, point, **said)
        args, exponent = {"kappa": kappa, "x": x, "y": y, "z": z}, k * (1 - t)
        formula = "kappa exp(kappa z)/(4 pi sinh(kappa))"
        row("von_mises_fisher_pdf", formula, args, density, exponent=exponent, **said)
        found = (share, turns_of(x, y))
        rows("von_mises_fisher_inverse", "share from -1 to z, turns", args, found, exponent=exponent, **said)


PARTS = (henyey_greenstein, von_mises_fisher)
