"""Disks and spheres, seen from a point."""

from mpmath import acos, asin, cos, fabs, mpf, pi, sin, sqrt, workdps

from .table import exact, integral, over_scales, row, uniform


# radius, height and lateral offset of disks, and what is hard of them
HARD_DISKS = [
    (1.0, 1e7, 2.0, "far above"),
    (1.0, 2.0, 1e7, "far aside"),
    (1.0, 1e-9, 1.5, "grazing"),
    (1.0, 1e-9, 0.5, "close"),
    (1.0, 1e-7, 1.0, "above the rim"),
    (1.0, 1e-7, 1 + 2.0**-30, "beside the rim"),
    (1.0, 0.0, 0.5, "on the disk"),
]


def on_the_axis():
    cases = [(over_scales(-1, 1), over_scales(-1, 1)) for _ in range(5)]
    cases += [
        (1e-9, 1.0),
        (1e9, 1.0),
        (1e-160, 1e-10),
        (1e30, 1e31),
        (1.0, 3e5),
        (2.0**-200, 2.0**-190),
        (1.0, 1 + 2.0**-52),
    ]
    for r, d in cases:
        hard = not 1e-3 < r / d < 1e3
        with workdps(700):
            slope, near = mpf(d) / mpf(r), mpf(min(r, d)) / mpf(max(r, d))
            disk = 2 * pi * (1 - slope / sqrt(slope**2 + 1))
            sphere = 2 * pi * (1 - sqrt(1 - near**2))
        row("solid_angle_disk", "2 pi (1 - d/sqrt(d**2 + r**2))", {"r": r, "d": d}, disk, hard=hard)
        formula = "(1 - h/sqrt(h**2 + r2**2))/2"
        row("view_factor_sphere_disk", formula, {"r2": r, "h": d}, disk / (4 * pi), hard=hard)
        args = {"R": min(r, d), "d": max(r, d)}
        row("solid_angle_sphere", "2 pi (1 - sqrt(1 - (R/d)**2))", args, sphere, hard=hard)
    row("solid_angle_disk", "a half-space", {"r": 1, "d": 0}, 2 * pi, hard=True, why="at the disk")


def parallel_disks():
    formula = "(1 - (h**2 + a**2 - r**2)/sqrt((h**2 + a**2 - r**2)**2 + 4 h**2 r**2))/2 (Hamilton and Morgan 1952)"
    cases = [(over_scales(-1, 1), over_scales(-1, 1), over_scales(-1, 1), "") for _ in range(6)]
    cases += [
        *HARD_DISKS,
        (1.0, 0.0, 1.5, "in its plane"),
        (1e-8, 1.0, 0.0, "tiny"),
        (1e30, 1e31, 1e30, "scaled"),
        (1.0, 1.0, 1.0, "above the rim"),
    ]
    for r, h, a, why in cases:
        args = {"r": r, "h": h, "a": a}
        r, h, a = exact((r, h, a))
        difference = h**2 + a**2 - r**2
        value = (1 - difference / sqrt(difference**2 + 4 * h**2 * r**2)) / 2
        row("form_factor_point_disk", formula, args, value, hard=bool(why), why=why)


def cosine_over_cap(d, R, cosine):
    """The integral of the cosine over the part of the cap above the horizon, over pi, by rings about the normal."""
    half, tilt = asin(R / d), acos(cosine)
    if tilt + half <= pi / 2:
        return cosine * (R / d) ** 2
    if tilt - half >= pi / 2:
        return mpf(0)

    def ring(angle):
        over = (cos(half) - cos(angle) * cosine) / (sin(angle) * sin(tilt))
        return 2 * acos(min(max(over, -1), 1)) * sin(angle) * cos(angle)

    low, high = fabs(tilt - half), pi / 2
    inner = pi * sin(half - tilt) ** 2 if half > tilt else mpf(0)
    return (integral(ring, [low, (low + high) / 2, high]) + inner) / pi


def spheres():
    cases = [(uniform(1, 3), uniform(0.1, 0.9), uniform(-0.4, 1), "") for _ in range(6)]
    cases += [
        (1e6, 1.0, 0.5, "far"),
        (1e6, 1.0, 1e-7, "far, cut by the horizon"),
        (1.0, 1.0 - 2.0**-20, 0.1, "close"),
        (2.0, 1.0, 0.5, "touches the horizon"),
        (2.0, 1.0, -0.5, "below the horizon"),
        (2.0, 1.0, 0.0, "cut in half"),
        (2.0, 1.0, -0.49999, "just above the horizon"),
        (3.0, 1.0, -1.0, "behind"),
    ]
    for d, R, cosine, why in cases:
        args = {"d": d, "R": R, "cos_theta": cosine}
        value = cosine_over_cap(*exact((d, R, cosine)))
        row("form_factor_point_sphere", cosine_over_cap.__doc__, args, value, hard=bool(why), why=why)


def beside_disks():
    formula = "h r/pi int cos(phi)/(h**2 + a**2 + r**2 - 2 a r cos(phi)), phi = 0..pi: Lambert's potential along the rim"
    cases = [
        (0.75, 1.25, 0.5, ""),
        (3.0, 0.3, 4.7, ""),
        (0.2, 6.5, 1.1, ""),
        *HARD_DISKS,
        (1.0, 0.5, 0.0, "on the axis"),
        (1.0, 0.5, 1e-160, "beside the axis"),
        (1e30, 1e31, 1e30, "scaled"),
    ]
    for r, h, a, why in cases:
        args = {"r": r, "h": h, "a": a}
        r, h, a = exact((r, h, a))

        def along(phi):
            # the nearest point of the rim is where the denominator is small
            return cos(phi) / (h**2 + (a - r) ** 2 + 4 * a * r * sin(phi / 2) ** 2)

        with workdps(400 if 0 < a < 1e-100 else 90):
            near = sqrt(h**2 + (a - r) ** 2) / max(a, r)
            marks = [0] + [mark for mark in (near * 8**power for power in range(16)) if 0 < mark < pi / 2] + [pi / 2, pi]
            value = h * r / pi * integral(along, marks) if a > 0 and h > 0 else mpf(0)
        row("form_factor_beside_disk", formula, args, value, hard=bool(why), why=why)


PARTS = (on_the_axis, parallel_disks, spheres, beside_disks)
