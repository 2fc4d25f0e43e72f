"""Computes the polynomials and constants of functions: run it from forms-math as

    python coefficients/lane.py > src/lane/coefficients.rs
    python coefficients/lane.py error_function > src/special/error_function/coefficients.rs
    python coefficients/lane.py double_double > src/double_double/error_function/coefficients.rs

A polynomial interpolates its function at the Chebyshev nodes of its interval, which is within a small factor of the best
approximation, and has the least degree whose error, times `weight` there, is below 2^-(precision + 4); its
coefficients are then rounded to the format. A constant in parts has so many bits in each part as its use needs.
"""

import sys

from mpmath import asin, atan, atanh, cos, cosh, erf, erfc, exp, hyp1f1, ln, lu_solve, matrix, mp, mpf, pi, polyval, sin, sinh, sqrt

mp.prec = 300


class Format:
    """A floating-point format: its precision in bits, and the numbers that its range and precision lead to."""

    def __init__(self, rust, precision, multiple_bits, scale_bits, half_pi_parts, erf_is_one, erfc_is_zero):
        self.rust = rust
        self.precision = precision
        self.multiple_bits = multiple_bits  # bits of the largest multiple of pi/2 that is taken off an angle
        self.scale_bits = scale_bits  # bits of the largest exponent of two
        self.half_pi_parts = half_pi_parts
        self.erf_is_one = erf_is_one  # from here on erf rounds to 1
        self.erfc_is_zero = erfc_is_zero  # from here on erfc rounds to 0


FORMATS = [Format("f64", 53, 20, 11, 4, 6, 28), Format("f32", 24, 12, 8, 5, 4, 10.5)]


def rounded(x, bits):
    """x to so many bits, to nearest."""
    with mp.workprec(bits):
        return +x


def literal(x, form):
    """The shortest decimal that reads back as x rounded to the format."""
    value = rounded(mpf(x), form.precision)
    for digits in range(1, 20):
        text = f"{float(value):.{digits}e}"
        if rounded(mpf(text), form.precision) == value:
            break
    mantissa, exponent = text.split("e")
    if -4 <= int(exponent) <= 6:
        text = f"{float(text):.{max(digits - int(exponent), 1)}f}"
        return text.rstrip("0") + "0" if text.rstrip("0").endswith(".") else text.rstrip("0")
    mantissa = mantissa.rstrip("0")
    return f"{mantissa + '0' if mantissa.endswith('.') else mantissa}e{int(exponent)}"


def parts(x, bits, form):
    """x as a sum of numbers with so many bits each; the last has what the format holds."""
    out = []
    for width in bits:
        out.append(rounded(x, width))
        x = x - out[-1]
    return out


def interpolate(function, low, high, degree):
    nodes = [(low + high) / 2 + (high - low) / 2 * cos(pi * (2 * i + 1) / (2 * degree + 2)) for i in range(degree + 1)]
    powers = matrix(degree + 1, degree + 1)
    values = matrix(degree + 1, 1)
    for row, node in enumerate(nodes):
        values[row] = function(node)
        for column in range(degree + 1):
            powers[row, column] = node**column
    return list(lu_solve(powers, values))


def fit_weighted(function, weight, low, high, degree):
    """Least squares of the weighted error at many Chebyshev nodes."""
    count = 4 * degree
    nodes = [(low + high) / 2 + (high - low) / 2 * cos(pi * (2 * i + 1) / (2 * count)) for i in range(count)]
    powers = matrix(count, degree + 1)
    values = matrix(count, 1)
    for row, node in enumerate(nodes):
        values[row] = function(node) * weight(node)
        for column in range(degree + 1):
            powers[row, column] = node**column * weight(node)
    return list(lu_solve(powers, values))


def polynomial(function, weight, low, high, form, fit=None):
    """The coefficients, constant term first, of the least degree that is good enough."""
    tolerance = mpf(2) ** -(form.precision + 4)
    for degree in range(2, 40):
        found = fit(degree) if fit else interpolate(function, low, high, degree)
        points = [low + (high - low) * mpf(i + mpf(1) / 3) / 100 for i in range(100)]
        if max(abs(polyval(found[::-1], x) - function(x)) * weight(x) for x in points) < tolerance:
            return found
    raise SystemExit("no degree is good enough")


def table(form):
    """Name, meaning, and value or values, of every entry."""
    half_ln2 = ln(2) / 2 * mpf("1.001")
    quarter_pi = pi / 4 * mpf("1.0001")
    half_pi_bits = [form.precision - form.multiple_bits] * (form.half_pi_parts - 1) + [form.precision]
    ln2_bits = [form.precision - form.scale_bits, form.precision]
    pair = [form.precision, form.precision]

    def of_square(function):
        return lambda z: function(sqrt(z))

    yield "erf_is_one", "From here on erf x rounds to 1", mpf(form.erf_is_one)
    last = mpf(form.erf_is_one) - 1
    log_erfc = lambda t: ln(erfc(1 + t))
    erfc_weight = lambda t: erfc(1 + t)
    fits = lambda degree: fit_weighted(log_erfc, erfc_weight, mpf(0), last, degree)
    tiny = mpf(2) ** -200
    yield "log2_e", "1/ln 2", 1 / ln(2)
    yield "ln_2", "ln 2, the first part times any exponent being exact", parts(ln(2), ln2_bits, form)
    yield "two_over_pi", "2/pi", 2 / pi
    yield "half_pi", "pi/2, all parts but the last times any multiple in reach being exact", parts(pi / 2, half_pi_bits, form)
    yield "quarters_pi", "pi/4, pi/2, 3 pi/4 and pi, each with what its rounding leaves", [
        part for k in range(1, 5) for part in parts(pi * k / 4, pair, form)]
    yield "two_over_root_pi", "2/sqrt pi with what its rounding leaves", parts(2 / sqrt(pi), pair, form)
    yield "two_thirds", "2/3 with what its rounding leaves", parts(mpf(2) / 3, pair, form)
    yield "exp", "(e^r - 1 - r)/r^2 of -(ln 2)/2 <= r <= ln(3/2)", polynomial(
        lambda r: hyp1f1(1, 3, r) / 2, abs, -half_ln2, ln(mpf(3) / 2) * mpf("1.001"), form)
    yield "sinh", "(sinh r - r)/r^3 in r^2, of |r| <= (ln 2)/2", polynomial(
        of_square(lambda r: (sinh(r) - r) / r**3), lambda z: z, tiny, half_ln2**2, form)
    yield "cosh", "(cosh r - 1 - r^2/2)/r^4 in r^2, of |r| <= (ln 2)/2", polynomial(
        of_square(lambda r: (cosh(r) - 1 - r**2 / 2) / r**4), lambda z: z * z, tiny, half_ln2**2, form)
    s = (sqrt(2) - 1) / (sqrt(2) + 1) * mpf("1.0001")
    yield "ln", "(2 artanh s - 2 s)/s^3 in s^2, of |s| <= (sqrt 2 - 1)/(sqrt 2 + 1)", polynomial(
        of_square(lambda s: (2 * atanh(s) - 2 * s) / s**3), lambda z: z, tiny, s**2, form)
    yield "ln_tail", "(2 artanh s - 2 s - 2 s^3/3)/s^5 in s^2, on the same interval", polynomial(
        of_square(lambda s: (2 * atanh(s) - 2 * s - 2 * s**3 / 3) / s**5), lambda z: 32 * z * z, tiny, s**2, form)
    yield "sin", "(sin r - r)/r^3 in r^2, of |r| <= pi/4", polynomial(
        of_square(lambda r: (sin(r) - r) / r**3), lambda z: z, tiny, quarter_pi**2, form)
    yield "cos", "(cos r - 1 + r^2/2)/r^4 in r^2, of |r| <= pi/4", polynomial(
        of_square(lambda r: (cos(r) - 1 + r**2 / 2) / r**4), lambda z: z * z, tiny, quarter_pi**2, form)
    steep = mpf("0.5464")
    yield "atan_limit", "Up to here angles are taken from an axis, beyond from the diagonal: the tangent of a little over 1/2", steep
    yield "atan", "(atan t - t)/t^3 in t^2, of |t| to that limit", polynomial(
        of_square(lambda t: (atan(t) - t) / t**3), lambda z: z, tiny, (steep * mpf("1.0001"))**2, form)
    yield "asin", "(asin t - t)/t^3 in t^2, of |t| <= 1/2", polynomial(
        of_square(lambda t: (asin(t) - t) / t**3), lambda z: z, tiny, mpf(1) / 4, form)
    yield "erf", "(erf x - 2 x/sqrt pi)/x^3 in x^2, of |x| <= 1", polynomial(
        of_square(lambda x: (erf(x) - 2 * x / sqrt(pi)) / x**3), lambda z: z, tiny, mpf(1), form)
    yield "ln_erfc", "ln erfc(1 + t) of t >= 0, to where erf rounds to 1", polynomial(
        log_erfc, erfc_weight, mpf(0), last, form, fits)
    yield "erfc_is_zero", "From here on erfc x rounds to 0", mpf(form.erfc_is_zero)
    end = (form.erfc_is_zero - SHIFT) / (form.erfc_is_zero + SHIFT)
    yield "erfc", "(x + 2) e^(x^2) erfc x in (x - 2)/(x + 2), of x >= 0, to where erfc rounds to 0", polynomial(
        scaled_erfc, lambda t: 1 / scaled_erfc(t), mpf(-1), end, form)


SHIFT = mpf(2)  # of the argument of erfc


def scaled_erfc(t):
    """(x + SHIFT) e^(x^2) erfc x with t = (x - SHIFT)/(x + SHIFT)."""
    x = SHIFT * (1 + t) / (1 - t)
    return (x + SHIFT) * exp(x * x) * erfc(x)


# what lanes and single values of `f64` have in common
SHARED = ("erf_is_one", "two_over_root_pi", "erf", "ln_erfc", "erfc_is_zero", "erfc")
APPROXIMATE = '#![allow(clippy::approx_constant, reason = "coefficients are as the search found them")]\n'


def numbers(values, form, indent):
    return "".join(f"{indent}{literal(x, form)},\n" for x in values)


def emit():
    tables = [list(table(form)) for form in FORMATS]
    print("//! The polynomials and constants of the functions of lanes; computed by `coefficients/lane.py`.")
    print(APPROXIMATE)
    print("use crate::special::error_function;\n")
    print("/// The numbers of one floating-point format; polynomials have their constant term first.")
    print("pub(crate) struct Coefficients<W: 'static> {")
    for name, meaning, value in tables[0]:
        kind = "&'static [W]" if isinstance(value, list) else "W"
        print(f"    /// {meaning}\n    pub(crate) {name}: {kind},")
    print("}")
    for form, rows in zip(FORMATS, tables):
        print(f"\n/// Of `{form.rust}`.")
        print(f"pub(crate) const {form.rust.upper()}: Coefficients<{form.rust}> = Coefficients {{")
        for name, _, value in rows:
            if form.rust == "f64" and name in SHARED:
                borrowed = "&" if isinstance(value, list) else ""
                print(f"    {name}: {borrowed}error_function::{name.upper()},")
            elif isinstance(value, list):
                print(f"    {name}: &[\n{numbers(value, form, ' ' * 8)}    ],")
            else:
                print(f"    {name}: {literal(value, form)},")
        print("};")


def emit_error_function():
    form = FORMATS[0]
    print("//! The polynomials and constants of erf and erfc in `f64`, with the constant term first; computed by `coefficients/lane.py`.")
    print(APPROXIMATE)
    for name, meaning, value in table(form):
        if name not in SHARED:
            continue
        print(f"/// {meaning}")
        if isinstance(value, list):
            print(f"pub(crate) const {name.upper()}: [f64; {len(value)}] = [\n{numbers(value, form, ' ' * 4)}];")
        else:
            print(f"pub(crate) const {name.upper()}: f64 = {literal(value, form)};")


def of_two_words(name, meaning, function, low, high):
    """Prints a polynomial for double-double."""
    form = FORMATS[0]
    points = [low + (high - low) * mpf(i + mpf(1) / 3) / 100 for i in range(100)]
    least = min(abs(function(x)) for x in points)
    for degree in range(10, 90):
        found = interpolate(function, low, high, degree)
        if max(abs(polyval(found[::-1], x) - function(x)) for x in points) < least * mpf(2) ** -112:
            break
    else:
        raise SystemExit("no degree is good enough")
    print(f"/// {meaning}")
    print(f"pub(super) const {name}: [[f64; 2]; {degree + 1}] = [")
    for c in found:
        print(f"    [{', '.join(literal(part, form) for part in parts(c, [form.precision] * 2, form))}],")
    print("];")


def emit_double_double():
    print("//! The polynomials of erf and erfc in double-double, with the constant term first; computed by `coefficients/lane.py`.")
    print(APPROXIMATE)
    tiny = mpf(2) ** -100
    of_two_words("ERF", "(erf x)/x in x^2, of |x| <= 1/2", lambda z: erf(sqrt(z)) / sqrt(z), tiny, mpf(1) / 4)
    end = (FORMATS[0].erfc_is_zero - SHIFT) / (FORMATS[0].erfc_is_zero + SHIFT)
    of_two_words("ERFC", "(x + 2) e^(x^2) erfc x in (x - 2)/(x + 2), of x >= 0, to where erfc rounds to 0", scaled_erfc, mpf(-1), end)


PARTS = {"error_function": emit_error_function, "double_double": emit_double_double}
PARTS.get("".join(sys.argv[1:]), emit)()
