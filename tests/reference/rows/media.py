"""Light on its way through media, and at their boundaries."""

from mpmath import cos, cot, exp, expint, log, mp, mpf, pi, sin, sqrt, workdps

from .table import exact, integral, over_scales, row, uniform


def absorption():
    cases = [(over_scales(-2, 1), over_scales(-2, 1)) for _ in range(8)]
    cases += [(1e-300, 1.0), (1e-20, 3.0), (0.0, 5.0), (3.0, 0.0), (300.0, 2.0), (1e200, 1e-200), (1e-9, 1.0)]
    for sigma, t in cases:
        args, depth = {"sigma": sigma, "t": t}, mpf(sigma) * mpf(t)
        row("transmittance", "exp(-sigma t)", args, exp(-depth), exponent=depth)
        with workdps(700):
            emitted = (1 - exp(-depth)) / mpf(sigma) if sigma > 0 else mpf(t)
        row("emission_integral", "integral of exp(-sigma s) over s from 0 to t", args, emitted, hard=depth < 1e-6)


def optical_depth():
    cases = [(uniform(0, 5), uniform(0, 20), uniform(1, 10), over_scales(-3, 0), "") for _ in range(8)]
    cases += [
        (1.0, 1.0 + 2.0**-40, 8.0, 0.1, "short"),
        (3.0, 3.0, 8.0, 0.1, "no path"),
        (0.0, 1e4, 8.0, 0.1, "out of the atmosphere"),
        (1e3, 2e3, 8.0, 1.0, "high up"),
        (5.0, 0.0, 8.0, 0.2, "downwards"),
    ]
    for z0, z1, H, s0, why in cases:
        low, high, scale = exact((z0, z1, H))
        value = mpf(s0) * scale * (exp(-low / scale) - exp(-high / scale))
        args = {"z0": z0, "z1": z1, "H": H, "s0": s0}
        formula = "integral of s0 exp(-z/H) over z from z0 to z1"
        row("optical_depth_exponential", formula, args, value, exponent=min(low, high) / scale, hard=bool(why), why=why)


def slabs():
    for tau in [over_scales(-3, 1) for _ in range(8)] + [0.0, 1e-12, 1e-300, 50.0, 300.0, 1.0]:
        value = 2 * expint(3, mpf(tau)) if tau > 0 else 1
        formula = "integral of 2 exp(-tau w)/w**3 over w from 1 on"
        row("slab_transmittance", formula, {"tau": tau}, value, exponent=tau, hard=tau < 1e-6 or tau > 20)


def single_scattering():
    cases = [(uniform(0, 1), over_scales(-2, 1), uniform(0.05, 1), uniform(0.05, 1), "") for _ in range(6)]
    cases += [
        (0.9, 1e-12, 0.5, 0.7, "thin"),
        (1.0, 1.0, 0.5, 0.5, "along the beam"),
        (1.0, 1.0, 0.5, 0.5 + 2.0**-50, "nearly along the beam"),
        (1.0, 2.0, 0.3, 0.3 - 2.0**-40, "nearly along the beam"),
        (1.0, 1.0, 1e-3, 1.0, "grazing beam"),
        (1.0, 0.5, 1.0, 1e-3, "grazing view"),
        (0.5, 0.0, 0.5, 0.25, "no depth"),
        (0.8, 1e-300, 1.0, 1.0, "thin"),
        (0.8, 600.0, 1.0, 0.5, "thick"),
    ]
    for omega, tau, mu0, mu, why in cases:
        args = {"omega": omega, "tau": tau, "mu0": mu0, "mu": mu}
        with workdps(700):
            albedo, depth, steep, flat = exact((omega, tau, mu0, mu))
            a, b = 1 / steep, 1 / flat
            back = albedo / 4 * b * (1 - exp(-depth * (a + b))) / (a + b)
            difference = (exp(-depth * a) - exp(-depth * b)) / (b - a) if a != b else depth * exp(-depth * a)
            through = albedo / 4 * b * difference
        formula = "integral of omega/(4 mu) exp(-s/mu0 - s/mu) over s from 0 to tau"
        row("single_scatter_reflected", formula, args, back, exponent=min(depth * (a + b), 1), hard=bool(why), why=why)
        formula = "integral of omega/(4 mu) exp(-s/mu0 - (tau - s)/mu) over s from 0 to tau"
        exponent = depth * min(a, b) + 1
        row("single_scatter_transmitted", formula, args, through, exponent=exponent, hard=bool(why), why=why)


def scattered_on_the_way(beta, h, s, end):
    """The integral of beta/(4 pi) exp(-beta (way + x))/way**2, in pieces about the source."""
    beta, h, s, end = exact((beta, h, s, end))

    def density(x):
        way = sqrt(h**2 + (x - s) ** 2)
        return beta / (4 * pi) * exp(-beta * (way + x)) / way**2

    marks = {s} | {s + sign * h * mpf(2) ** step for step in range(-3, 24) for sign in (-1, 1)}
    return integral(density, {mark for mark in marks if 0 < mark < end} | {mpf(0), end})


def airlight():
    cases = [(over_scales(-2, 0), over_scales(-1, 1), uniform(-5, 10), over_scales(-1, 1.5), "") for _ in range(6)]
    cases += [
        (0.2, 1e-3, 3.0, 10.0, "near the source"),
        (0.2, 1e-6, 3.0, 10.0, "very near the source"),
        (0.2, 0.0, -1.0, 5.0, "away from the source on its line"),
        (0.2, 0.0, 8.0, 5.0, "towards the source on its line"),
        (1e-9, 1.0, 3.0, 10.0, "thin"),
        (0.5, 2.0, 1.0, 1e-9, "short"),
        (2.0, 0.5, 0.0, 40.0, "thick"),
    ]
    formula = "integral of beta/(4 pi) exp(-beta (way + x))/way**2 over x from 0 to D"
    for beta, h, s, end, why in cases:
        with workdps(40):
            value = scattered_on_the_way(beta, h, s, end)
        args = {"beta": beta, "h": h, "s": s, "D": end}
        row("airlight", formula, args, value, exponent=beta * (h * h + s * s) ** 0.5 + 2, hard=bool(why), why=why)


def half_space():
    """Stibbs and Weir: ln H = -mu/pi int_0^(pi/2) ln(1 - omega x cot x)/(cos(x)**2 + mu**2 sin(x)**2) dx."""

    def reflected(omega, mu):
        # x cot x = 1 - x**2/3 - x**4/45 - 2 x**6/945 - …, where 1 - omega x cot x would cancel
        def density(x):
            less = x**2 / 3 + x**4 / 45 + 2 * x**6 / 945 if x < mpf(10) ** -6 else 1 - x * cot(x)
            return log(1 - omega + omega * less) / (cos(x) ** 2 + mu**2 * sin(x) ** 2)

        # the denominator falls to mu**2 within about mu of pi/2
        marks = [pi / 2 - mu * mpf(4) ** step for step in range(-1, 8)]
        return exp(-mu / pi * integral(density, [mpf(0), pi / 4, pi / 2] + [x for x in marks if pi / 4 < x]))

    cases = [(uniform(0.05, 0.95), uniform(0.1, 1)) for _ in range(6)]
    cases += [(0.5, 1.0), (1.0, 1.0), (0.999, 0.5), (1.0, 0.25), (0.9, 0.0), (0.0, 0.5), (1e-9, 1.0)]
    # where the boundary value of 1 - omega z artanh(1/z) turns round within 1e-9 of 1, and near there
    cases += [(0.0946, 0.85), (0.0942, 0.48), (0.0921, 0.51), (0.12, 0.41), (0.5, 1e-3), (0.499, 0.3)]
    for omega, mu in cases:
        with workdps(40):
            value = reflected(*exact((omega, mu))) if omega and mu else 1
        row("chandrasekhar_h", half_space.__doc__, {"omega": omega, "mu": mu}, value, hard=omega > 0.99)


def boundaries():
    def reflected(n, c):
        square = 1 - (1 - c**2) / n**2
        if square <= 0:
            return mpf(1)
        t = sqrt(square)
        return (((c - n * t) / (c + n * t)) ** 2 + ((n * c - t) / (n * c + t)) ** 2) / 2

    cases = [(uniform(0.5, 2.5), uniform(0, 1), "") for _ in range(8)]
    cases += [
        (1 + 2.0**-30, 0.7, "nearly equal"),
        (1 - 2.0**-40, 0.3, "nearly equal"),
        (1.5, 0.0, "grazing"),
        (1.5, 1e-9, "grazing"),
        (1.5, 1.0, "normal"),
        (1 + 2.0**-52, 1.0, "nearly equal, normal"),
        (0.5, 0.75, "near the critical angle"),
        (1 + 1e-9, 1e-5, "nearly equal, grazing"),
    ]
    for n, c, why in cases:
        args, formula = {"n": n, "cos_i": c}, "mean of the squares of both amplitudes"
        row("fresnel_dielectric", formula, args, reflected(*exact((n, c))), hard=bool(why), why=why)
    cases = [(over_scales(-5, 5), uniform(1, 3), uniform(1, 3), "") for _ in range(10)]
    for L, n1, n2, why in cases + [(2.0, 1e-160, 1e-155, "squares underflow")]:
        value = mpf(L) * mpf(n2) ** 2 / mpf(n1) ** 2
        row("basic_radiance", "L n2**2/n1**2", {"L": L, "n1": n1, "n2": n2}, value, hard=bool(why), why=why)


def black_bodies():
    h, c, k = mpf("6.62607015e-34"), mpf(299792458), mpf("1.380649e-23")
    cases = [(over_scales(-7, -4), over_scales(2, 4)) for _ in range(8)]
    for wavelength, T in cases + [(1.0, 300.0), (1e3, 1e4), (1e-7, 300.0), (2e-8, 1e3), (5e-7, 5772.0)]:
        x = h * c / (mpf(wavelength) * mpf(T) * k)
        value = 2 * h * c**2 / mpf(wavelength) ** 5 / (exp(x) - 1)
        args, formula = {"lambda": wavelength, "T": T}, "2 h c**2/lambda**5/(exp(h c/(lambda k T)) - 1)"
        row("planck", formula, args, value, exponent=x + 4, hard=x > 50 or x < 1e-3)


PARTS = (absorption, optical_depth, slabs, single_scattering, airlight, half_space, boundaries, black_bodies)
