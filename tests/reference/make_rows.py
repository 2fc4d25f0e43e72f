"""Reference rows of every kernel of the library, from high precision.

    definitions (rows/*.py) ── mpmath, inputs exact doubles ──▶ own.json ──▶ forms-cli/tests/reference.rs

Nothing is computed by the form that a kernel uses: polygons are clipped in rational numbers, solid angles are angles
of arcs less a half-turn, what has a definition as an integral is integrated, sampling warps are found as roots of the
share that they cover. Run `python3 tests/reference/make_rows.py` in the root of the repository; the seed is fixed.
"""

import json
from pathlib import Path

from rows import axis, distances, exchange, gathering, luminaire, media, microfacets, polygons, round, spherical, square
from rows import smooth, view_factors
from rows.table import ROWS

TOPICS = (polygons, luminaire, round, view_factors, media, axis, square, microfacets, distances, spherical, exchange)
TOPICS += (gathering, smooth)


def main():
    for topic in TOPICS:
        for part in topic.PARTS:
            part()
    about = (
        "Reference values by tests/reference/make_rows.py, in the format of visible.json; `output` counts the outputs of a "
        "kernel that has several."
    )
    cases = ",\n".join(json.dumps(case) for case in ROWS)
    text = f'{{"about": {json.dumps(about)}, "cases": [\n{cases}\n]}}\n'
    Path(__file__).with_name("own.json").write_text(text)


if __name__ == "__main__":
    main()
