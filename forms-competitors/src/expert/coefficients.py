"""Prints the coefficients in `elementary.rs`: polynomials through Chebyshev's nodes, by mpmath.

    python3 coefficients.py

An interpolant at Chebyshev's nodes is within a small factor of the best polynomial of its degree. The number of
coefficients is the least that keeps the error of the function below a tenth of the rounding of an f64.
"""

import mpmath

mpmath.mp.dps = 60
ROUNDING = mpmath.mpf(2) ** -53


def exponential(r):
    """(e^r - 1 - r)/r^2"""
    return mpmath.nsum(lambda n: r**n / mpmath.factorial(n + 2), [0, 40], method="direct")


def arc_tangent(z):
    """(atan(t)/t - 1)/t^2 with z = t^2"""
    return mpmath.nsum(lambda n: (-1) ** (n + 1) * z**n / (2 * n + 3), [0, 80], method="direct")


def fit(name, function, interval, weight):
    """Prints the fewest coefficients, from the constant one on; `weight` takes their error to that of the function."""
    count = 2
    while True:
        coefficients, error = mpmath.chebyfit(function, interval, count, error=True)
        if error * weight < ROUNDING / 10:
            break
        count += 1
    print(f"/// Relative error below {mpmath.nstr(error * weight / ROUNDING, 2)} · 2⁻⁵³.")
    print(f"const {name}: [f64; {count}] = [")
    for coefficient in reversed(coefficients):
        print(f"    {float(coefficient)!r},")
    print("];")


half = mpmath.log(2) / 2 * (1 + mpmath.mpf(2) ** -20)
fit("EXPONENTIAL", exponential, [-half, half], half)
steep = mpmath.tan(mpmath.pi / 8) ** 2 * (1 + mpmath.mpf(2) ** -20)
fit("ARC_TANGENT", arc_tangent, [0, steep], steep)
high = mpmath.mpf(int(mpmath.log(2) * 2**32)) / 2**32
print(f"const LN_2_HIGH: f64 = {float(high)!r};")
print(f"const LN_2_LOW: f64 = {float(mpmath.log(2) - high)!r};")
