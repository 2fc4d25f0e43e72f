#!/usr/bin/env python3
"""Time of each scene with an effect off, relative to the time with it on.

    cargo build --release
    python3 forms-radiometry/benches/effects_off.py [SCENE.toml ...]
    python3 forms-radiometry/benches/effects_off.py --random 40

Without arguments: the scenes of the gallery; with `--random`: as many scenes of random_scenes.py. For each effect that a plan has on, the scene runs with the effect as planned
and off, in turns. The table has the processor time of both (the least of the runs), and their ratio. Where the answers become
smaller without the effect, the same relative tolerance asks for smaller errors than before: the last column is the ratio at the
tolerance that allows the errors of the run with the effect.
"""

import json
import pathlib
import resource
import statistics
import subprocess
import sys
import tempfile
import tomllib

import random_scenes

ROOT = pathlib.Path(__file__).resolve().parents[2]
FORMS = ROOT / "target" / "release" / "forms"
RUNS = 3
LONGEST = 120
# Largest ratio that is no loss.
MARGIN = 1.05


def run(scene, *options):
    """Returns the processor time of a run, or why there is none, and the rows that it prints."""
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    try:
        done = subprocess.run(
            [FORMS, "simulate", scene, "--json", *options], capture_output=True, text=True, timeout=LONGEST
        )
    except subprocess.TimeoutExpired:
        return f"longer than {LONGEST} s", []
    if done.returncode not in (0, 3):
        return "refused", []
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    rows = [json.loads(line) for line in done.stdout.splitlines()]
    return after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime, rows


def values(rows):
    """Returns the answers of a run by receiver, quantity, band and bin."""
    answers = [row for row in rows if "value" in row and "receiver" in row]
    return {tuple(row.get(key) for key in ("receiver", "quantity", "band", "bin")): row["value"] for row in answers}


def weaker(with_effect, without):
    """Returns by which factor all answers are weaker without an effect, at least 1."""
    ratios = [abs(value / without[key]) for key, value in with_effect.items() if without.get(key)]
    return max(1.0, min(ratios, default=1.0))


def main():
    if sys.argv[1:2] == ["--random"]:
        with tempfile.TemporaryDirectory() as folder:
            measure(random_scenes.written(pathlib.Path(folder), int(sys.argv[2])))
    else:
        measure([pathlib.Path(name) for name in sys.argv[1:]] or sorted((ROOT / "scenes").glob("*.toml")))


def measure(scenes):
    """Prints the rows of some scenes, and how the ratios are distributed."""
    print(f"{'scene':24} {'effect off':16} {'on s':>8} {'off s':>8} {'off/on':>7} {'same error':>11}")
    ratios = []
    for scene in scenes:
        _, rows = run(scene)
        tolerance = tomllib.loads(scene.read_text()).get("solve", {}).get("tolerance", 1e-3)
        for effect in [row["effect"] for row in rows if row.get("effect") and row.get("on")]:
            ratio = compare(scene, effect, rows, tolerance)
            ratios += [ratio] if ratio else []
    slower = sum(ratio > MARGIN for ratio in ratios)
    middle = statistics.median(ratios)
    print(f"{len(ratios)} ratios to the same error: median {middle:.2f}, largest {max(ratios):.2f}; {slower} above {MARGIN}")


def compare(scene, effect, rows, tolerance):
    """Prints a row of the table, and returns the ratio to the same error, if there is one."""
    off = ("--effects", f"{effect}=off")
    time, rows_off = run(scene, *off)
    if isinstance(time, str):
        print(f"{scene.stem:24} {effect:16} {time}", flush=True)
        return None
    allowed = ("--tolerance", f"{tolerance * weaker(values(rows), values(rows_off)):.3e}")
    times = [[run(scene)[0], run(scene, *off)[0], run(scene, *off, *allowed)[0]] for _ in range(RUNS)]
    missing = next((time for row in times for time in row if isinstance(time, str)), None)
    if missing:
        print(f"{scene.stem:24} {effect:16} {missing}", flush=True)
        return None
    with_effect, without, same = (min(column) for column in zip(*times))
    print(
        f"{scene.stem:24} {effect:16} {with_effect:8.3f} {without:8.3f} {without / with_effect:7.2f} {same / with_effect:11.2f}",
        flush=True,
    )
    return same / with_effect


if __name__ == "__main__":
    main()
