"""The functions of one task that were emitted as C and C++, compiled into a library, and the time that they take.

All files are compiled with the same flags. A function for one set of arguments is called through a pointer from another
file, so that nothing of it is inlined into the loop over the sets.
"""

import ctypes
import re
import subprocess
import sys

import numpy as np

from emitters import VECTOR_LIBRARY

FLAGS = ["-O3", "-march=native", "-fno-math-errno"]
# for loops that call vector functions: these two would be merged into one call, which has no such version
VECTORS = ["-fno-builtin-sin", "-fno-builtin-cos"]
# a function of a shared library is inlined in its file as in a program
SHARED = ["-fPIC", "-fno-semantic-interposition"]

LOOP = """
#include <stddef.h>
#include <time.h>
typedef void (*function)(const double *, double *);
double seconds(
    function compute, const double *in, double *out, size_t inputs, size_t outputs, size_t count, size_t passes) {
    struct timespec start, end;
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &start);
    for (size_t pass = 0; pass < passes; pass++)
        for (size_t i = 0; i < count; i++)
            compute(in + i * inputs, out + i * outputs);
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &end);
    return (double)(end.tv_sec - start.tv_sec) + 1e-9 * (double)(end.tv_nsec - start.tv_nsec);
}
"""


class Library:
    """Compiled functions of a task, by the names of their generators."""

    def __init__(self, task, texts, folder):
        self.task, self.folder, self.names = task, folder, list(texts)
        objects = [compiled(folder, "loop", LOOP)]
        for name, files in texts.items():
            objects += [compiled(folder, file, text) for file, text in zip((name, f"{name}_columns"), files)]
        run("cc", "-shared", "-o", folder / "all.so", *objects, "-lm")
        self.library = ctypes.CDLL(str(folder / "all.so"))
        self.library.seconds.restype = ctypes.c_double

    def call(self, name, rows):
        """The function for one set of arguments: seconds of a number of passes over rows, and its results as rows."""
        results = np.empty((len(rows), self.task.outputs))
        function, pointers = getattr(self.library, name), [address(rows), address(results)]
        sizes = [ctypes.c_size_t(size) for size in (self.task.inputs, self.task.outputs, len(rows))]
        seconds = lambda passes: self.library.seconds(function, *pointers, *sizes, ctypes.c_size_t(passes))
        return seconds, lambda: results

    def batch(self, name, columns, count):
        """The function over columns: a call without arguments, and its results as rows."""
        results = np.empty((self.task.outputs, columns.shape[1]))
        function = getattr(self.library, f"{name}_columns")
        arguments = [address(columns), address(results), *map(ctypes.c_size_t, (columns.shape[1], count))]
        return lambda: function(*arguments), lambda: results[:, :count].T

    def operations(self, name):
        """Divisions, roots and calls in the machine code for one set of arguments, those of rare branches included."""
        text = run("objdump", "-d", "-r", "--no-show-raw-insn", self.folder / f"{name}.o")
        bodies = dict(re.findall(r"^[0-9a-f]+ <([^>]+)>:\n(.*?)(?=\n\n|\Z)", text, re.DOTALL | re.MULTILINE))
        counts, reached = [0, 0, 0], [name]
        for function in reached:
            body = bodies[function]
            reached += sorted(set(re.findall(r"<([\w.]+)>", body)) & set(bodies) - set(reached))
            called = re.findall(r"R_X86_64_PLT32\s+(\w+)", body)
            reached += sorted(set(called) & set(bodies) - set(reached))
            found = [re.findall(rf"\sv?{kind}[sp]d\s", body) for kind in ("div", "sqrt")]
            found.append([function for function in called if function not in bodies])
            counts = [count + len(operations) for count, operations in zip(counts, found)]
        return ", ".join(map(str, counts))


def compiled(folder, name, text):
    """Compiles a file of C, or of C++ where it includes a header of C++; returns the object file."""
    ending, program = (".cpp", "c++") if "<cmath>" in text else (".c", "cc")
    source, target = folder / f"{name}{ending}", folder / f"{name}.o"
    source.write_text(text)
    vectors = VECTORS if text.startswith(VECTOR_LIBRARY) else []
    run(program, *FLAGS, *vectors, *SHARED, "-c", "-o", target, source)
    return target


def run(program, *arguments):
    """Output of a program; ends the bench if the program fails."""
    done = subprocess.run([program, *map(str, arguments)], capture_output=True, text=True)
    if done.returncode:
        sys.exit(f"{program} failed:\n{done.stderr}")
    return done.stdout


def address(array):
    return array.ctypes.data_as(ctypes.c_void_p)
