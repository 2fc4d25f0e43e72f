"""Code in C and C++ that the generators emit for one task.

Every function here returns the texts of one file or two. The first has `void NAME(const double *in, double *out)` for
one set of arguments; the second, of Forms alone, has `void NAME_columns(in, out, stride, count)`, where columns are
`stride` numbers apart. Emitted code stands in these files unchanged. ImportError is raised if a generator is missing.
"""

import shutil
import subprocess
import sys
from types import SimpleNamespace

ONE = "void {name}(const double *__restrict in, double *__restrict out)"
COLUMNS = "void {name}_columns(const double *__restrict in, double *__restrict out, size_t stride, size_t count)"


# the loops of Forms call vector functions of the C library
VECTOR_LIBRARY = "#define FORMS_VECTOR_LIBRARY\n"


def by_forms(program, task, name, folder, sources, tier="stable"):
    """Forms: `forms emit`, with the chosen forms if they are among the sources.

    The function over columns has a file of its own, which calls vector functions.
    """
    folder.mkdir()
    for source in sources:
        shutil.copy(source, folder)
    command = [program, "emit", "--target", "c", "--tier", tier, "--kernel", task.kernel, folder / sources[0].name]
    run = subprocess.run(command, capture_output=True, text=True)
    if run.returncode:
        sys.exit(f"{program} emit failed:\n{run.stderr}")
    one, columns = ONE.format(name=name), COLUMNS.format(name=name)
    return [
        f"{run.stdout}{one} {{ {call_of_forms(task)} }}\n",
        f"{VECTOR_LIBRARY}{run.stdout}{columns} {{ {batch_of_forms(task)} }}\n",
    ]


def call_of_forms(task):
    """Call of a kernel: pointers to arrays, numbers, then the results."""
    starts = [sum(task.sizes[:i]) for i in range(len(task.sizes))]
    arguments = [f"in + {start}" if size > 1 else f"in[{start}]" for start, size in zip(starts, task.sizes)]
    if task.outputs == 1:
        return f"out[0] = {task.kernel}({', '.join(arguments)});"
    return f"{task.kernel}({', '.join(arguments)}, out);"


def batch_of_forms(task):
    """Call of the function over columns."""
    columns = [f"in + {i}*stride" for i in range(task.inputs)] + [f"out + {i}*stride" for i in range(task.outputs)]
    return f"{task.kernel}_batch({', '.join(columns)}, count);"


def by_wrenfold(task, name):
    """wrenfold: its optimiser and its generator for C++."""
    from wrenfold import code_generation, external_functions, sym, type_annotations, type_info

    scalar = type_annotations.FloatScalar
    erf = external_functions.declare_external_function("erf", [("x", scalar)], scalar)
    functions = {f: getattr(sym, f) for f in ("sqrt", "atan2", "sin", "cos", "exp", "log", "pi")}
    description = code_generation.FunctionDescription(f"emitted_{name}")
    number = type_info.ScalarType(type_info.NumericType.Float)
    arguments = [description.add_input_argument(argument, number) for argument in task.names]
    values = task.formula(SimpleNamespace(erf=erf, **functions), *arguments)
    results = with_derivatives(values, arguments[: task.differentiated], lambda value, x: value.diff(x))
    for i, result in enumerate(results):
        description.add_output_argument(f"b{i}", False, result)
    code = code_generation.CppGenerator().generate(code_generation.transpile(description))
    passed = [f"in[{i}]" for i in range(task.inputs)] + [f"out[{i}]" for i in range(task.outputs)]
    call = f"emitted_{name}<double>({', '.join(passed)});"
    return [f"#include <cmath>\n{code}\nextern \"C\" {ONE.format(name=name)} {{ {call} }}\n"]


def with_derivatives(values, variables, derivative):
    """Values, followed by their derivatives, row by row."""
    return [*values, *(derivative(value, x) for value in values for x in variables)]


def by_sympy(task, name):
    """SymPy: common subexpressions, whole powers as products, and its printer for C99."""
    from sympy import ccode

    steps, results = common_subexpressions(task)
    lines = [f"    const double {argument} = in[{i}];" for i, argument in enumerate(task.names)]
    lines += [f"    const double {left} = {ccode(right, standard='c99')};" for left, right in steps]
    lines += [f"    out[{i}] = {ccode(result, standard='c99')};" for i, result in enumerate(results)]
    return ["#include <math.h>\n" + ONE.format(name=name) + " {\n" + "\n".join(lines) + "\n}\n"]


def common_subexpressions(task):
    """Steps that SymPy finds, and the results in terms of them."""
    import sympy
    from sympy.codegen.rewriting import create_expand_pow_optimization, optimize

    arguments = sympy.symbols(task.names, real=True)
    values = task.formula(sympy, *arguments)
    steps, results = sympy.cse(with_derivatives(values, arguments[: task.differentiated], sympy.diff))
    products = [create_expand_pow_optimization(8)]
    return [(left, optimize(right, products)) for left, right in steps], [optimize(r, products) for r in results]


def by_casadi(task, name):
    """CasADi: scalar expressions, its common subexpressions and its generator for C."""
    import casadi

    arguments = casadi.SX.sym("a", task.inputs)
    values = casadi.vertcat(*task.formula(casadi, *casadi.vertsplit(arguments)))
    if task.differentiated:
        derivatives = casadi.densify(casadi.jacobian(values, arguments)[:, : task.differentiated])
        values = casadi.vertcat(values, casadi.vec(derivatives.T))
    generator = casadi.CodeGenerator(f"emitted_{name}.c")
    generator.add(casadi.Function(f"emitted_{name}", [arguments], [values], {"cse": True}))
    call = f"const double *from[] = {{in}}; double *to[] = {{out}}; emitted_{name}(from, to, 0, 0, 0);"
    return [f"{generator.dump()}\n{ONE.format(name=name)} {{ {call} }}\n"]
