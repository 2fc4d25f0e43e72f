#!/usr/bin/env python3
"""Time of each scene with an effect off, relative to the time with it on.

    cargo build --release
    python3 forms-radiometry/benches/effects_off.py [SCENE.toml ...]

Without arguments: the scenes of the gallery. For each effect that a plan has on, the scene runs with the effect as planned
and off, in turns. The table has the processor time of both (the least of the runs), and their ratio.
"""

import json
import pathlib
import resource
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
FORMS = ROOT / "target" / "release" / "forms"
RUNS = 3
LONGEST = 120


def run(scene, *options):
    """Returns the processor time of a run, or why there is none, and the effects that are on."""
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
    effects = [row["effect"] for row in rows if row.get("effect") and row.get("on")]
    return after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime, effects


def main():
    scenes = [pathlib.Path(name) for name in sys.argv[1:]] or sorted((ROOT / "scenes").glob("*.toml"))
    print(f"{'scene':24} {'effect off':16} {'on s':>8} {'off s':>8} {'off/on':>7}")
    worst = 0.0
    for scene in scenes:
        _, effects = run(scene)
        for effect in effects:
            on, off = [], []
            for _ in range(RUNS):
                on.append(run(scene)[0])
                off.append(run(scene, "--effects", f"{effect}=off")[0])
            failure = next((run for run in on + off if isinstance(run, str)), None)
            if failure:
                print(f"{scene.stem:24} {effect:16} {failure}")
                continue
            ratio = min(off) / min(on)
            worst = max(worst, ratio)
            print(f"{scene.stem:24} {effect:16} {min(on):8.3f} {min(off):8.3f} {ratio:7.2f}", flush=True)
    print(f"largest ratio: {worst:.2f}")


if __name__ == "__main__":
    main()
