"""Functions over many sets of arguments by numba and JAX, in double precision.

Every function here returns a call without arguments, which computes all sets, and a function that returns the results
as rows. They raise ImportError if their compiler is not installed.
"""

import math

import numpy as np

import emitters


def by_numba(task, columns, count):
    """numba: a loop over columns, compiled without fast-math, of the common subexpressions that SymPy finds."""
    import numba

    namespace = {"math": math}
    exec(text_for_numba(task), namespace)
    loop = numba.njit(fastmath=False, error_model="numpy")(namespace["loop"])
    outputs = np.empty((task.outputs, columns.shape[1]))
    return lambda: loop(columns, outputs, count), lambda: outputs[:, :count].T


def text_for_numba(task):
    """The loop in Python."""
    from sympy import pycode

    steps, results = emitters.common_subexpressions(task)
    lines = [f"{argument} = columns[{i}, row]" for i, argument in enumerate(task.names)]
    lines += [f"{left} = {pycode(right)}" for left, right in steps]
    lines += [f"outputs[{i}, row] = {pycode(result)}" for i, result in enumerate(results)]
    head = "def loop(columns, outputs, count):\n    for row in range(count):\n"
    return head + "\n".join("        " + line for line in lines)


def by_jax(task, rows):
    """JAX: a row of arguments gives a row of results."""
    import jax

    jax.config.update("jax_enable_x64", True)
    function, arguments = jax.jit(jax.vmap(formula_for_jax(task))), jax.device_put(rows)
    return lambda: function(arguments).block_until_ready(), lambda: np.asarray(function(arguments))


def by_jax_over_columns(task, rows):
    """JAX: arrays of arguments give a tuple of arrays of results."""
    import jax
    import jax.numpy as jnp

    jax.config.update("jax_enable_x64", True)
    formula = formula_for_jax(task)
    function = jax.jit(jax.vmap(lambda *arguments: tuple(formula(jnp.stack(arguments)))))
    arguments = [jax.device_put(np.ascontiguousarray(column)) for column in rows.T]
    return lambda: jax.block_until_ready(function(*arguments)), lambda: np.stack(function(*arguments), axis=1)


def formula_for_jax(task):
    """Values and derivatives in forward mode of one set of arguments, one after another."""
    import jax
    import jax.numpy as jnp
    from jax.scipy.special import erf

    class Operations:
        pi = jnp.pi
        atan2 = staticmethod(jnp.arctan2)

        def __getattr__(self, name):
            return erf if name == "erf" else getattr(jnp, name)

    def values(variables, others):
        return jnp.stack(task.formula(Operations(), *variables, *others))

    def with_derivatives(arguments):
        variables, others = arguments[: task.differentiated], arguments[task.differentiated :]
        value = values(variables, others)
        if not task.differentiated:
            return value
        return jnp.concatenate([value, jax.jacfwd(values)(variables, others).ravel()])

    return with_derivatives
