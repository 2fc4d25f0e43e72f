"""Writes `by_sympy.rs` and `by_wrenfold.rs`: the kernels of the bench `kernels` as two other generators emit them.

    pip install sympy wrenfold
    python3 forms-competitors/generate.py [FOLDER [FILE]]

The files, or one of them, go to FOLDER, by default `forms-competitors/generated`, from which the crate takes them when it is built.
Each formula is stated once, in the operations of whichever generator runs; both get it as a text book has it, and each
does what it does by itself (SymPy: common subexpressions and its printer for Rust; wrenfold: its optimiser and its
generator for Rust). A generator that is not installed is reported and its file left as it is.
"""

import pathlib
import sys
from types import SimpleNamespace

FOLDER = pathlib.Path(__file__).parent / "generated"


def dot(a, b):
    return sum((x * y for x, y in zip(a[1:], b[1:])), a[0] * b[0])


def cross(a, b):
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


def difference(a, b):
    return [x - y for x, y in zip(a, b)]


def solid_angle_density_patch(m, u, v, ax, ay, az, bx, by, bz, cx, cy, cz, dx, dy, dz):
    """The pullback of the solid angle by a bilinear patch: p . (p_u x p_v)/|p|^3."""
    corners = zip((ax, ay, az), (bx, by, bz), (cx, cy, cz), (dx, dy, dz))
    p = [(1 - u) * (1 - v) * a + u * (1 - v) * b + (1 - u) * v * c + u * v * d for a, b, c, d in corners]
    normal = cross([m.diff(q, u) for q in p], [m.diff(q, v) for q in p])
    return dot(p, normal) / m.sqrt(dot(p, p)) ** 3


def solid_angle_triangle(m, px, py, pz, ax, ay, az, bx, by, bz, cx, cy, cz):
    """Van Oosterom and Strackee."""
    p = [px, py, pz]
    a, b, c = (difference(corner, p) for corner in ([ax, ay, az], [bx, by, bz], [cx, cy, cz]))
    la, lb, lc = (m.sqrt(dot(x, x)) for x in (a, b, c))
    return 2 * m.atan2(dot(a, cross(b, c)), la * lb * lc + dot(a, b) * lc + dot(b, c) * la + dot(c, a) * lb)


def form_factor_point_rectangle(m, px, py, pz, nx, ny, nz, ox, oy, oz, ux, uy, uz, vx, vy, vz):
    """Lambert's sum over the edges of what stands above the horizon."""
    n = [nx, ny, nz]
    o = [ox - px, oy - py, oz - pz]
    corners = [o, [o[0] + ux, o[1] + uy, o[2] + uz]]
    corners.append([corners[1][0] + vx, corners[1][1] + vy, corners[1][2] + vz])
    corners.append([o[0] + vx, o[1] + vy, o[2] + vz])
    heights = [dot(n, corner) for corner in corners]

    def edge(a, b):
        c = cross(a, b)
        length = m.sqrt(dot(c, c))
        return m.where(length > 0, dot(n, c) * m.atan2(length, dot(a, b)) / length, m.zero)

    def either(condition, a, b):
        return [m.where(condition, x, y) for x, y in zip(a, b)]

    total, enters, leaves = m.zero, [m.zero] * 3, [m.zero] * 3
    for i in range(4):
        a, b = corners[i], corners[(i + 1) % 4]
        ha, hb = heights[i], heights[(i + 1) % 4]
        crossing = [m.abs(ha) * y + m.abs(hb) * x for x, y in zip(a, b)]
        part = edge(either(ha > 0, a, crossing), either(hb > 0, b, crossing))
        total = total + m.where(ha > 0, part, m.where(hb > 0, part, m.zero))
        enters = either(ha > 0, enters, either(hb > 0, crossing, enters))
        leaves = either(ha > 0, either(hb > 0, leaves, crossing), leaves)
    return m.abs(total + edge(leaves, enters)) / (2 * m.pi * m.sqrt(dot(n, n)))


def henyey_greenstein(m, g, cos_theta):
    """The phase function of the mean cosine g."""
    return (1 - g**2) / (4 * m.pi * m.sqrt(1 + g**2 - 2 * g * cos_theta) ** 3)


def henyey_greenstein_sample(m, g, u):
    """The cosine whose distribution function is u."""
    return (1 + g**2 - ((1 - g**2) / (1 - g + 2 * g * u)) ** 2) / (2 * g)


def ggx_visible_pdf(m, alpha, wx, wy, wz, x, y, z):
    """Heitz: G1(w) max(0, w.h) D(h)/w_z."""
    masking = 2 / (1 + m.sqrt(1 + alpha**2 * (wx**2 + wy**2) / wz**2))
    density = 1 / (m.pi * alpha**2 * ((x**2 + y**2) / alpha**2 + z**2) ** 2)
    facing = wx * x + wy * y + wz * z
    return masking * m.where(facing > 0, facing, m.zero) * density / wz


def transmittance_with_emission(m, L0, sigma, t, j):
    """The radiance behind a homogeneous medium that absorbs and emits."""
    left = m.exp(-sigma * t)
    return L0 * left + j * (1 - left) / sigma


def form_factor_integrand(m, x0, x1, x2, n0, n1, n2, y0, y1, y2, m0, m1, m2):
    """cos cos/(pi r^2) of two points with unit normals."""
    d = difference([y0, y1, y2], [x0, x1, x2])
    r = m.sqrt(dot(d, d))
    return dot([n0, n1, n2], d) / r * -dot([m0, m1, m2], d) / r / (m.pi * r**2)


KERNELS = [
    solid_angle_density_patch,
    solid_angle_triangle,
    form_factor_point_rectangle,
    henyey_greenstein,
    henyey_greenstein_sample,
    ggx_visible_pdf,
    transmittance_with_emission,
    form_factor_integrand,
]


def arguments(kernel):
    return kernel.__code__.co_varnames[1 : kernel.__code__.co_argcount]


def sympy_printer():
    """SymPy's printer for Rust, with products, sums and whole numbers by its general printer.

    Those of its printer for Rust lose parentheses around sums and mix integers with floats (SymPy 1.14).
    """
    from sympy.printing.codeprinter import CodePrinter
    from sympy.printing.rust import RustCodePrinter

    class Printer(RustCodePrinter):
        _print_Mul = CodePrinter._print_Mul
        _print_Add = CodePrinter._print_Add

        def _print_Integer(self, number):
            return f"{number.p}.0"

        def _print_Rational(self, number):
            return f"{number.p}.0/{number.q}.0"

        def _print_Pow(self, power):
            if power.exp.is_Integer:
                return f"{self.parenthesize(power.base, 1000)}.powi({power.exp})"
            return super()._print_Pow(power)

    return Printer()


def by_sympy():
    import sympy

    zero = sympy.Integer(0)
    operations = SimpleNamespace(
        sqrt=sympy.sqrt, atan2=sympy.atan2, exp=sympy.exp, abs=sympy.Abs, pi=sympy.pi, zero=zero, diff=sympy.diff,
        where=lambda condition, a, b: sympy.Piecewise((a, condition), (b, True)),
    )

    emit = sympy_printer().doprint

    def emitted(kernel):
        names = arguments(kernel)
        value = kernel(operations, *sympy.symbols(names, real=True))
        steps, (value,) = sympy.cse(value)
        lines = [f"    let {name} = {emit(step)};" for name, step in steps]
        parameters = ", ".join(f"{name}: f64" for name in names)
        body = "\n".join([*lines, f"    {emit(value)}"])
        return f"pub(crate) fn {kernel.__name__}({parameters}) -> f64 {{\n{body}\n}}\n"

    return f"SymPy {sympy.__version__}", "use std::f64::consts::PI;\n\n", emitted


def by_wrenfold():
    import importlib.metadata

    from wrenfold import code_generation, sym, type_info

    operations = SimpleNamespace(
        sqrt=sym.sqrt, atan2=sym.atan2, exp=sym.exp, abs=sym.abs, pi=sym.pi, zero=sym.zero, diff=lambda f, x: f.diff(x),
        where=sym.where,
    )

    def emitted(kernel):
        names = arguments(kernel)
        description = code_generation.FunctionDescription(kernel.__name__)
        number = type_info.ScalarType(type_info.NumericType.Float)
        description.set_return_value(kernel(operations, *(description.add_input_argument(name, number) for name in names)))
        return code_generation.RustGenerator().generate(definition=code_generation.transpile(description))

    return f"wrenfold {importlib.metadata.version('wrenfold')}", "", emitted


def write(path, generator):
    try:
        name, header, emitted = generator()
    except ImportError as missing:
        print(f"{path.name} is left as it is: {missing}")
        return
    path.write_text(f"// Written by `generate.py` with {name}.\n\n{header}" + "\n".join(map(emitted, KERNELS)))
    print(f"{path.name}: {name}")


if __name__ == "__main__":
    folder = pathlib.Path(sys.argv[1]) if len(sys.argv) > 1 else FOLDER
    folder.mkdir(parents=True, exist_ok=True)
    generators = {"by_sympy.rs": by_sympy, "by_wrenfold.rs": by_wrenfold}
    for name in sys.argv[2:] or generators:
        write(folder / name, generators[name])
