"""Scenes of many surfaces, by Forms and by other programs, in one run: seconds, their ratio, and how far the values differ.

    cargo build --release
    python3 forms-radiometry/benches/large/compare.py target/release/forms [--families FOLDER] [--view3d PROGRAM]

FOLDER holds the verification meshes of OpenViewFactor (github.com/OpenViewFactor/verification-meshes), PROGRAM is View3D. What is
not there is left out, and so is Mitsuba where the package `mitsuba` is not installed. Seconds are those of whole programs, which start,
read and answer; `samples` are those of Mitsuba's samples alone. Both have the same standard error: 1e-3 of a view factor, 1e-2 of an
irradiance or a pixel; what Forms finds without samples is far more accurate. Forms has that error in every cell of a map and every
pixel of an image, relative to the mean, Mitsuba as the root mean square: the last column says what its pixels with the largest errors
take.
"""

import argparse
import json
import os
import platform
import signal
import subprocess
import tempfile
import time
from pathlib import Path

import numpy as np

import works

try:
    import by_mitsuba
except ImportError as error:
    by_mitsuba = None
    print(f"Mitsuba is left out: {error}\n")

# seconds after which a run of Forms is ended
LONGEST = 120


def forms(program, *arguments):
    """Seconds, records and largest memory [MiB] of a call; None instead of seconds where it took too long."""
    with tempfile.TemporaryFile("w+") as output:
        start = time.perf_counter()
        run = subprocess.Popen([program, *map(str, arguments), "--json"], stdout=output, stderr=subprocess.DEVNULL)
        has_ended, seconds = 0, 0.0
        while not has_ended:
            time.sleep(0.001)
            seconds = time.perf_counter() - start
            if seconds > LONGEST:
                os.kill(run.pid, signal.SIGKILL)
            has_ended, _, used = os.wait4(run.pid, 0 if seconds > LONGEST else os.WNOHANG)
        run.returncode = 0
        output.seek(0)
        records = [json.loads(line) for line in output] if seconds <= LONGEST else []
    return seconds if seconds <= LONGEST else None, records, used.ru_maxrss / 1024


def row(work, own, name, samples, other, remark):
    shown = lambda seconds: f"> {LONGEST}" if seconds is None else f"{seconds:.3g}"
    ratio = f"{other / own:.2g}" if own and other else ""
    of_other = [name, f"{samples:.3g}" if samples is not None else "", f"{other:.3g}" if other else ""]
    print(f"| {work} | {shown(own)} | {' | '.join(of_other)} | {ratio} | {remark} |", flush=True)


def street(program, folder, view3d):
    works.street(folder)

    def factors(tolerance):
        seconds, records, _ = forms(program, "view-factors", folder / "street.toml", "--tolerance", tolerance)
        count = int(len(records) ** 0.5)
        return seconds, np.array([r["value"] for r in records]).reshape(count, count)

    _, exact = factors(1e-4)
    seen = exact > 1e-4
    worst = lambda found: f"{np.max(np.abs(found - exact)[seen] / exact[seen]):.1g}"
    seconds, remark = None, ""
    if view3d:
        # it writes a log into the folder in which it runs
        files = [folder / "street.vs3", folder / "street.out"]
        start = time.perf_counter()
        subprocess.run([Path(view3d).resolve(), *files], cwd=folder, capture_output=True, check=True)
        seconds = time.perf_counter() - start
        lines = (folder / "street.out").read_text().splitlines()[2:]
        count = len(exact)
        theirs = np.array([[float(x) for x in line.split()[:count]] for line in lines[:count]])
        remark = f", of View3D {worst(theirs)}"
    for tolerance in (1e-3, 1e-2):
        own, found = factors(tolerance)
        work = f"street, 545 quads, to {tolerance:.0e}"
        row(work, own, "View3D" if view3d else "", None, seconds, f"largest relative error above 1e-4: {worst(found)}{remark}")


def families(program, folder, meshes):
    for number, (name, one, other) in enumerate(works.families(meshes, folder)):
        own, records, _ = forms(program, "view-factors", folder / f"family-{number}.toml")
        found = next(r for r in records if (r["from"], r["to"]) == ("one", "other")) if records else None
        said = f"{found['value']:.6f} ± {found['error']:.1e} ({found['kind']})" if found else ""
        if not by_mitsuba:
            row(name, own, "", None, None, said)
            continue
        run = by_mitsuba.view_factor(works.stl(one), works.stl(other))
        seconds, _, value = by_mitsuba.time_to(run, by_mitsuba.FIRST["factor"], 1e-3)
        whole = seconds + by_mitsuba.rest("factor", one, other)
        row(name, own, by_mitsuba.PROGRAM, seconds, whole, f"{said}; theirs {value[0]:.6f}")


def triangles(program, folder, count):
    for kind in ("forest", "city", "tubes"):
        corners = works.triangles(kind, count)
        for reflectance in (0.0, 0.5):
            name = works.lit(kind, corners, reflectance, folder)
            lit = by_mitsuba and by_mitsuba.Lit(folder / f"{name}.obj", reflectance)
            for asked in ("points", "map", "camera"):
                if asked == "camera" and reflectance == 0.0:
                    continue
                work = f"{kind}, {len(corners)} triangles of reflectance {reflectance}, {asked}"
                own, _, memory = forms(program, "simulate", folder / f"{name}-{asked}.toml")
                if not lit:
                    row(work, own, "", None, None, f"{memory:.0f} MiB")
                    continue
                run = getattr(lit, asked)(len(corners))
                seconds, each, _ = by_mitsuba.time_to(run, by_mitsuba.FIRST[asked], 1e-2)
                whole = seconds + by_mitsuba.rest(asked, folder / f"{name}.obj", reflectance, len(corners))
                said = "" if asked == "points" else f"; its worst {each:.3g} s"
                row(work, own, by_mitsuba.PROGRAM, seconds, whole, f"{memory:.0f} MiB{said}")


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("program", help="the program `forms`")
    parser.add_argument("--families", type=Path, metavar="FOLDER")
    parser.add_argument("--view3d", metavar="PROGRAM")
    parser.add_argument("--triangles", type=int, default=100_000, metavar="COUNT")
    parser.add_argument("--only", choices=("street", "families", "triangles"))
    asked = parser.parse_args()
    print(f"Processor: {processor()}\n")
    print("| work | Forms [s] | other | samples [s] | [s] | ratio | |\n|---|---|---|---|---|---|---|")
    with tempfile.TemporaryDirectory() as folder:
        folder = Path(folder)
        if asked.only in (None, "street"):
            street(asked.program, folder, asked.view3d)
        if asked.only in (None, "families") and asked.families:
            families(asked.program, folder, asked.families)
        if asked.only in (None, "triangles"):
            triangles(asked.program, folder, asked.triangles)


def processor():
    try:
        lines = Path("/proc/cpuinfo").read_text().splitlines()
        return next(line.split(":")[1].strip() for line in lines if line.startswith("model name"))
    except (OSError, StopIteration):
        return platform.processor()


if __name__ == "__main__":
    main()
