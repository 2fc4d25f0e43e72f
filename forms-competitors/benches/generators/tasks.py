"""The five tasks of the bench for all generators but Forms, and the arguments at which they are timed.

A formula takes the operations of a generator, `m`, and numbers of that generator. `tasks.forms` has the same formulas.
Each generator differentiates by its own means.
"""

from dataclasses import dataclass
from typing import Callable

import numpy as np


@dataclass(frozen=True)
class Task:
    """A formula, the name of its kernel in `tasks.forms`, and the sizes of its arguments there, in order."""

    title: str
    kernel: str
    formula: Callable
    sizes: tuple
    # draws one set of arguments
    draw: Callable
    # number of leading arguments by which the values are differentiated
    differentiated: int = 0

    @property
    def inputs(self):
        """Number of all arguments."""
        return sum(self.sizes)

    @property
    def names(self):
        return [f"a{i}" for i in range(self.inputs)]

    def arguments(self, count):
        """Rows of typical arguments, the same in every run."""
        generator = np.random.default_rng(1)
        return np.array([np.hstack(self.draw(generator)) for _ in range(count)])

    @property
    def outputs(self):
        """Number of values and derivatives."""
        values = len(self.formula(Counting(), *[1.0] * self.inputs))
        return values * (1 + self.differentiated)


class Counting:
    """Operations that return 1: they serve to count the results of a formula."""

    pi = 1.0

    def __getattr__(self, name):
        return lambda *arguments: 1.0


def double_sphere(m, x, y, z, xi, alpha):
    """Usenko, Demmel and Cremers, 2018."""
    first = m.sqrt(x * x + y * y + z * z)
    shifted = xi * first + z
    second = m.sqrt(x * x + y * y + shifted * shifted)
    depth = alpha * second + (1 - alpha) * shifted
    return [x / depth, y / depth]


def kannala_brandt(m, x, y, z, k1, k2, k3, k4):
    """Kannala and Brandt, 2006."""
    r = m.sqrt(x * x + y * y)
    theta = m.atan2(r, z)
    distorted = theta * (1 + k1 * theta**2 + k2 * theta**4 + k3 * theta**6 + k4 * theta**8)
    return [distorted / r * x, distorted / r * y]


def so3(m, a, b, c):
    """Rodrigues, row by row."""
    square = a * a + b * b + c * c
    angle = m.sqrt(square)
    skew = [[0, -c, b], [c, 0, -a], [-b, a, 0]]
    squared = [[sum(skew[i][k] * skew[k][j] for k in range(3)) for j in range(3)] for i in range(3)]
    sine, cosine = m.sin(angle) / angle, (1 - m.cos(angle)) / square
    return [int(i == j) + sine * skew[i][j] + cosine * squared[i][j] for i in range(3) for j in range(3)]


CORNERS = [(-1, -1, -1), (1, -1, -1), (1, 1, -1), (-1, 1, -1), (-1, -1, 1), (1, -1, 1), (1, 1, 1), (-1, 1, 1)]


def hexahedron(m, xi, eta, zeta, *nodes):
    """det of the sum over the nodes of coordinates times derivatives of shape functions."""

    def derivative(corner, along):
        factors = [1 + sign * at for sign, at in zip(corner, (xi, eta, zeta))]
        first, second = (factors[i] for i in range(3) if i != along)
        return corner[along] * first * second / 8

    def entry(along, axis):
        return sum(derivative(corner, along) * nodes[3 * n + axis] for n, corner in enumerate(CORNERS))

    a, b, c = [[entry(along, axis) for axis in range(3)] for along in range(3)]
    cross = [b[1] * c[2] - b[2] * c[1], b[2] * c[0] - b[0] * c[2], b[0] * c[1] - b[1] * c[0]]
    return [a[0] * cross[0] + a[1] * cross[1] + a[2] * cross[2]]


def black_scholes(m, S, K, r, sigma, T):
    """Price of a call, delta, gamma, vega, theta, rho."""
    root = m.sqrt(T)
    d1 = (m.log(S / K) + (r + sigma**2 / 2) * T) / (sigma * root)
    d2 = d1 - sigma * root
    density = m.exp(-(d1**2) / 2) / m.sqrt(2 * m.pi)
    first, second = ((1 + m.erf(d / m.sqrt(2))) / 2 for d in (d1, d2))
    discounted = K * m.exp(-r * T)
    return [
        S * first - discounted * second,
        first,
        density / (S * sigma * root),
        S * density * root,
        -S * density * sigma / (2 * root) - r * discounted * second,
        T * discounted * second,
    ]


def point(generator, slope):
    """A point in front of a camera, by its largest slope to the axis."""
    z = generator.uniform(0.5, 5.0)
    return z * generator.uniform(-slope, slope), z * generator.uniform(-slope, slope), z


TASKS = [
    Task("double sphere, jacobian", "double_sphere_j", double_sphere, (3, 1, 1),
         lambda g: [*point(g, 1.0), g.uniform(-0.3, 0.3), g.uniform(0.4, 0.7)], 3),
    Task("Kannala–Brandt, jacobian", "kannala_brandt_j", kannala_brandt, (3, 4),
         lambda g: [*point(g, 2.0), *g.uniform(-0.02, 0.02, 4)], 3),
    Task("SO(3) exponential, jacobian", "so3_j", so3, (3,), lambda g: [g.uniform(-2.0, 2.0, 3)], 3),
    Task("hexahedron, determinant", "hexahedron", hexahedron, (1, 1, 1, 24),
         lambda g: [g.uniform(-1.0, 1.0, 3), (CORNERS + g.uniform(-0.3, 0.3, (8, 3))).ravel()]),
    Task("Black–Scholes, Greeks", "black_scholes", black_scholes, (1, 1, 1, 1, 1),
         lambda g: [*g.uniform(80.0, 120.0, 2), g.uniform(0.0, 0.08), g.uniform(0.1, 0.5), g.uniform(0.2, 2.0)]),
]
