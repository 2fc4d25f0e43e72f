"""Vectors of rational or of real numbers."""

from fractions import Fraction

from mpmath import mpf, sqrt

from .table import uniform


def minus(a, b):
    return [p - q for p, q in zip(a, b)]


def plus(a, b):
    return [p + q for p, q in zip(a, b)]


def times(k, a):
    return [k * p for p in a]


def dot(a, b):
    return sum((p * q for p, q in zip(a, b)), mpf(0) if isinstance(a[0], mpf) else 0)


def cross(a, b):
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


def norm(a):
    return sqrt(dot(a, a))


def real(a):
    """A vector of rational numbers as one of reals."""
    return [mpf(p.numerator) / p.denominator if isinstance(p, Fraction) else mpf(p) for p in a]


def unit(a):
    return times(1 / norm(a), a)


def rational(a):
    return [Fraction(p) for p in a]


def vector(scale=1.0, offset=0.0):
    return [offset + scale * uniform(-1, 1) for _ in range(3)]


def named(names, *vectors):
    """Arguments ax, ay, az, bx, …"""
    return {f"{name}{axis}": p for name, v in zip(names, vectors) for axis, p in zip("xyz", v)}
