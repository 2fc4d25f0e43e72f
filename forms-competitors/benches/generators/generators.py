"""Code that Forms emits, next to code and programs of other generators: five tasks, in one run.

    pip install numpy sympy wrenfold casadi numba jax
    cargo build --release
    python3 forms-competitors/benches/generators/generators.py [--write] [--forms PROGRAM] [--keep FOLDER]

prints tables; with --write, those of `docs/benchmarks.md` are replaced. A generator that is not installed is reported.
All times are processor times: the functions of a row run in turn, in a random order, and the medians of the turns are
reported. All programs are compared before they are timed.
"""

import argparse
import importlib.metadata
import random
import statistics
import sys
import tempfile
import time
from pathlib import Path

import numpy as np

import batches
import emitters
from library import FLAGS, Library, run
from tasks import TASKS

HERE = Path(__file__).resolve().parent
ROOT = HERE.parents[2]
PAGE = ROOT / "docs" / "benchmarks.md"
# names of the functions in C, and headers of their columns
OWN = {"forms": "Forms", "plain": "as written", "stable": "stable form"}
SCALAR = OWN | {"wrenfold": "wrenfold", "sympy": "SymPy", "casadi": "CasADi"}
BATCH = OWN | {"numba": "numba", "jax": "JAX"}
PACKAGES = ["wrenfold", "sympy", "casadi", "numba", "jax"]
# number of sets of arguments in a loop, and in batches
COUNT, SIZES = 1024, (1024, 65536)
# unused rows between columns, so that columns do not all begin in one set of the first cache
PADDING = 136
TURNS = 101
# least time of a turn in seconds
TURN = 2e-4
# largest difference between programs, relative to a value, or to a thousandth of the largest value of its column
TOLERANCE = 1e-9


def emitted(task, program, folder):
    """Texts of the files that each installed generator emits."""
    source, stable = HERE / "tasks.forms", HERE / "tasks.stable"
    by = {
        "forms": lambda name: emitters.by_forms(program, task, name, folder / name, [source]),
        "plain": lambda name: emitters.by_forms(program, task, name, folder / name, [source], "plain"),
        "stable": lambda name: emitters.by_forms(program, task, name, folder / name, [source, stable]),
        "wrenfold": lambda name: emitters.by_wrenfold(task, name),
        "sympy": lambda name: emitters.by_sympy(task, name),
        "casadi": lambda name: emitters.by_casadi(task, name),
    }
    texts = {name: unless_missing(name, lambda: emit(name)) for name, emit in by.items()}
    if texts["stable"][0].replace("stable", "forms") == texts["forms"][0]:
        report(f"{stable.name} has no form for {task.kernel}: write one with `forms accuracy {source.name} --write`")
    return {name: text for name, text in texts.items() if text}


def unless_missing(name, action):
    """Result of an action; None, and a line, if the generator that it needs is not installed."""
    try:
        return action()
    except ImportError as missing:
        report(f"{name} is skipped: {missing}")
        return None


def report(line, reported=set()):
    """Prints a line the first time."""
    if line not in reported:
        print(line, file=sys.stderr, flush=True)
        reported.add(line)


def one_by_one(library):
    """Nanoseconds for one set of arguments by each function in C."""
    rows = library.task.arguments(COUNT)
    programs = {name: library.call(name, rows) for name in library.names}
    return nanoseconds(library.task, programs, COUNT)


def in_batches(library, count):
    """Nanoseconds for one set of arguments of a batch, by functions that are called from Python."""
    task, rows = library.task, library.task.arguments(count)
    columns = np.zeros((task.inputs, count + PADDING))
    columns[:, :count] = rows.T
    by = {
        "forms": lambda: library.batch("forms", columns, count),
        "plain": lambda: library.batch("plain", columns, count),
        "stable": lambda: library.batch("stable", columns, count),
        "numba": lambda: batches.by_numba(task, columns, count),
        "jax": lambda: batches.by_jax(task, rows),
        "jax over columns": lambda: batches.by_jax_over_columns(task, rows),
    }
    found = {name: unless_missing(name, program) for name, program in by.items()}
    programs = {name: (timed(name, pair[0]), pair[1]) for name, pair in found.items() if pair}
    return nanoseconds(task, programs, count)


def timed(name, call):
    """A function that returns the processor time of a number of calls.

    JAX computes in several threads, and they are not idle as soon as another program has its turn.
    """
    clock = time.process_time if name.startswith("jax") else time.thread_time

    def seconds(passes):
        start = clock()
        for _ in range(passes):
            call()
        return clock() - start

    return seconds


def nanoseconds(task, programs, count):
    """Median times for one set of arguments; in each turn the programs run in another order."""
    passes = {name: max(1, round(TURN / longest(seconds))) for name, (seconds, _) in programs.items()}
    compare(task, {name: results() for name, (_, results) in programs.items()})
    turns = {name: [] for name in programs}
    generator = random.Random(1)
    for _ in range(TURNS):
        # in a fixed order, one program would always find the cache that another one leaves
        for name in generator.sample(list(programs), len(programs)):
            seconds = programs[name][0]
            # the first pass brings arguments and code into the cache
            seconds(1)
            turns[name].append(seconds(passes[name]) / passes[name])
    return {name: statistics.median(times) / count * 1e9 for name, times in turns.items()}


def longest(seconds):
    """Time of one pass after one that compiles, at least a tenth of a microsecond."""
    seconds(1)
    return max(seconds(1), 1e-7)


def compare(task, values):
    """Reports the largest difference from Forms; ends the bench where it is too large."""
    own = values["forms"]
    scale = np.maximum(np.abs(own), 1e-3 * np.abs(own).max(axis=0))
    differences = {name: np.max(np.abs(found - own) / scale) for name, found in values.items() if name != "forms"}
    wrong = [name for name, difference in differences.items() if not difference <= TOLERANCE]
    if wrong:
        sys.exit(f"{task.title}: other values than those of Forms: {', '.join(wrong)}")
    largest = max(differences, key=differences.get)
    report(f"{task.title}, {len(own)} sets: the largest difference is {differences[largest]:.1e} ({largest})")


def table(head, rows):
    """A table in Markdown."""
    lines = [head, ["---"] * len(head), *rows]
    return "".join(f"| {' | '.join(cells)} |\n" for cells in lines)


def ratios(times, names):
    """Times of other programs over those of Forms."""
    return [f"{times[name] / times['forms']:.2f}" if name in times else "–" for name in names]


def row(start, times, names):
    return [*start, f"{times['forms']:.1f}", *ratios(times, names)]


def with_faster(times):
    """Times with the faster of the two layouts of JAX."""
    of_jax = [time for name, time in times.items() if name.startswith("jax")]
    return times | ({"jax": min(of_jax)} if of_jax else {})


def tables(program, folder):
    """The text between the marks of the page."""
    one, many, operations = [], [], []
    for task in TASKS:
        (place := folder / task.kernel).mkdir(parents=True)
        library = Library(task, emitted(task, program, place), place)
        one.append(row([task.title], one_by_one(library), list(SCALAR)[1:]))
        for count in SIZES:
            times = with_faster(in_batches(library, count))
            many.append(row([task.title, str(count)], times, list(BATCH)[1:]))
        counts = [library.operations(name) if name in library.names else "–" for name in SCALAR]
        operations.append([task.title, *counts])
    over = lambda names: [f"{name} / Forms" for name in list(names.values())[1:]]
    return "\n".join([
        f"Processor: {processor()}; {environment()}.\n",
        table(["one set of arguments", "Forms [ns]", *over(SCALAR)], one),
        table(["batch", "sets", "Forms [ns]", *over(BATCH)], many),
        table(["divisions, roots, calls", *SCALAR.values()], operations),
    ])


def processor():
    lines = Path("/proc/cpuinfo").read_text().splitlines()
    return next((line.split(":")[1].strip() for line in lines if line.startswith("model name")), "unknown")


def environment():
    """The compiler with its flags, and the versions of the other generators."""
    packages = [f"{name} {version}" for name in PACKAGES if (version := version_of(name))]
    return ", ".join([f"{run('cc', '--version').splitlines()[0]} `{' '.join(FLAGS)}`", *packages])


def version_of(package):
    try:
        return importlib.metadata.version(package)
    except importlib.metadata.PackageNotFoundError:
        return None


def write(text):
    """Replaces the tables of the page."""
    begin, end = "<!-- measured: generators -->\n", "<!-- end -->"
    head, rest = PAGE.read_text().split(begin)
    PAGE.write_text(head + begin + text + end + rest.split(end, 1)[1])


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("--write", action="store_true", help="replace the tables of docs/benchmarks.md")
    parser.add_argument("--forms", default=ROOT / "target" / "release" / "forms", metavar="PROGRAM")
    parser.add_argument("--keep", type=Path, metavar="FOLDER", help="a new folder that keeps the emitted files")
    asked = parser.parse_args()
    with tempfile.TemporaryDirectory() as temporary:
        text = tables(str(asked.forms), asked.keep or Path(temporary))
    print(text, end="")
    if asked.write:
        write(text)


if __name__ == "__main__":
    main()
