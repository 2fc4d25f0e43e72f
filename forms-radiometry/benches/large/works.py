"""The works of this comparison: scenes of many surfaces, written as files for Forms and for the other programs.

street     quads of two rows of houses and of the road between them: all view factors
families   surfaces of the verification meshes of OpenViewFactor (a folder of STL files): two view factors of each pair
forest     small triangles at random, a lamp above, the ground below
city       boxes of random heights on a grid
tubes      a bundle of tubes, as in a heat exchanger
"""

import random
from pathlib import Path

import numpy as np

BLACK = '[[material]]\nname = "black"\nkind = "diffuse"\nreflectance = 0\n'
HALF, HIGH = 10.0, 20.0


def surface(name, material, shape, more=""):
    return f'[[surface]]\nname = "{name}"\nmaterial = "{material}"\n{shape}\n{more}'


# view factors


def street(folder):
    """The quads of the street, and the files for Forms (.toml) and View3D (.vs3)."""
    chance, quads = random.Random(3), []

    def wall(corner, along, up, columns, rows):
        corner, along, up = map(np.array, (corner, along, up))
        for i in range(columns):
            for j in range(rows):
                at = lambda a, b: corner + (i + a) / columns * along + (j + b) / rows * up
                quads.append([at(0, 0), at(1, 0), at(1, 1), at(0, 1)])

    for place in range(9):
        for y in (0.0, 21.0):
            x, wide, deep, high = 14.0 * place, 11.0, 9.0, 6 + 8 * chance.random()
            wall((x, y, 0), (wide, 0, 0), (0, 0, high), 2, 2)
            wall((x + wide, y, 0), (0, deep, 0), (0, 0, high), 2, 2)
            wall((x + wide, y + deep, 0), (-wide, 0, 0), (0, 0, high), 2, 2)
            wall((x, y + deep, 0), (0, -deep, 0), (0, 0, high), 2, 2)
            wall((x, y, high), (wide, 0, 0), (0, deep, 0), 2, 2)
    wall((0, 9.01, 0), (126, 0, 0), (0, 11.98, 0), 37, 5)
    quads = np.round(np.array(quads), 9)
    of = lambda i, quad: surface(f"q{i + 1}", "black", f"polygon = {quad.tolist()}")
    text = BLACK + "".join(of(i, quad) for i, quad in enumerate(quads)) + "[solve]\ntolerance = 1e-3\n"
    (folder / "street.toml").write_text(text)
    lines = ["T street", "C encl=0 out=0 emit=0 eps=1e-3", "F 3"]
    lines += [f"V {i + 1} {x!r} {y!r} {z!r}" for i, (x, y, z) in enumerate(quads.reshape(-1, 3).tolist())]
    lines += [f"S {i + 1} {4 * i + 1} {4 * i + 2} {4 * i + 3} {4 * i + 4} 0 0 1.0 q{i + 1}" for i in range(len(quads))]
    (folder / "street.vs3").write_text("\n".join(lines + ["End of Data", ""]))
    return quads


def families(meshes, folder, levels=("L1", "L2", "L3", "L4")):
    """Writes a scene for each pair of the families, and returns their names with both files."""
    pairs = []

    def add(name, one, other):
        if one.exists() and other.exists():
            pairs.append((name, one, other))

    for level in levels:
        cylinders, spheres = meshes / "coaxial-cylinders" / level, meshes / "concentric-spheres" / level
        for inner, outer in (("0.125", "0.25"), ("0.5", "0.75"), ("1", "2"), ("10", "32")):
            name = f"cylinders {inner} in {outer}, {level}"
            add(name, cylinders / f"inner-r={inner}-h=1.stl", cylinders / f"outer-r={outer}-h=1.stl")
        for inner, outer in (("1", "1.5"), ("2", "3")):
            name = f"spheres {inner} in {outer}, {level}"
            add(name, spheres / f"inner_sphere_r={inner}.stl", spheres / f"outer_sphere_r={outer}.stl")
        plates, corner = meshes / "parallel-plates" / level, meshes / "perpendicular-plates" / level
        for size in ("0.1", "1", "10"):
            name = f"plates {size}, {level}"
            add(name, plates / f"bottom-xDim={size}-yDim={size}.stl", plates / f"top-xDim={size}-yDim={size}-sep=1.stl")
        for size in ("0.1", "1", "10"):
            name = f"perpendicular plates {size}, {level}"
            add(name, corner / f"horizontal-horzDim={size}-shrdDim=1.stl", corner / f"vertical-vertDim={size}-shrdDim=1.stl")
    for number, (name, one, other) in enumerate(pairs):
        text = BLACK + "[solve]\ntolerance = 1e-3\n"
        for part, file in (("one", one), ("other", other)):
            (folder / f"{number}-{part}.stl").write_bytes(file.read_bytes())
            text += surface(part, "black", f'mesh = "{number}-{part}.stl"')
        (folder / f"family-{number}.toml").write_text(text)
    return pairs


def stl(file):
    """The triangles of a binary STL file."""
    data = Path(file).read_bytes()
    count = int.from_bytes(data[80:84], "little")
    kind = np.dtype([("normal", "<3f4"), ("corners", "<9f4"), ("more", "<u2")])
    return np.frombuffer(data[84 : 84 + 50 * count], kind)["corners"].reshape(-1, 3, 3).astype(float)


# many triangles


def triangles(kind, count):
    """So many triangles of a kind, and points of the ground that something is above."""
    chance = np.random.default_rng(7)
    if kind == "forest":
        middles = chance.uniform([-HALF, -HALF, 0.5], [HALF, HALF, 4], (count, 3))
        return middles[:, None, :] + chance.normal(0, 0.05 * (1e5 / count) ** (1 / 3), (count, 3, 3))
    if kind == "city":
        side = int((count / 12) ** 0.5)
        cell = 2 * HALF / side
        corners = [[x, y] for x in range(side) for y in range(side)]
        low = -HALF + cell * (np.array(corners) + 0.15)
        heights = cell * chance.uniform(0.3, 3, len(low))
        unit = np.array([[i >> a & 1 for a in range(3)] for i in range(8)], float)
        faces = [[0, 2, 3], [0, 3, 1], [4, 5, 7], [4, 7, 6], [0, 1, 5], [0, 5, 4], [2, 6, 7], [2, 7, 3],
                 [0, 4, 6], [0, 6, 2], [1, 3, 7], [1, 7, 5]]  # fmt: skip
        size = np.stack([np.full(len(low), 0.7 * cell)] * 2 + [heights], axis=1)
        base = np.concatenate([low, np.full((len(low), 1), 1e-3)], axis=1)
        boxes = base[:, None, :] + size[:, None, :] * unit
        return boxes[:, np.array(faces)].reshape(-1, 3, 3)
    side, around = int((count / 64) ** 0.5), 32
    turn = 2 * np.pi * np.arange(around + 1) / around
    ring = 0.3 * 6 / side * np.stack([np.cos(turn), np.zeros(around + 1), np.sin(turn)], axis=1)
    found = []
    for i in range(side):
        for j in range(side):
            middle = np.array([-8 + 16 * (i + 0.5) / side, 0, 1 + 6 * (j + 0.5) / side])
            front, back = ring + middle - [0, 8, 0], ring + middle + [0, 8, 0]
            found += [[front[k], back[k + 1], front[k + 1]] for k in range(around)]
            found += [[front[k], back[k], back[k + 1]] for k in range(around)]
    return np.array(found)


def places(count):
    """Six points of the ground, between the boxes of a city of so many triangles."""
    side, chance = int((count / 12) ** 0.5), random.Random(1)
    along = [-HALF + 2 * HALF * round(side * (0.1 + 0.8 * chance.random())) / side for _ in range(6)]
    return [[x, chance.uniform(-8, 8), 0.0] for x in along]


POINT = '[[receiver]]\nname = "p{}"\nkind = "point"\nposition = {}\nnormal = [0, 0, 1]\n'
MAP = '[[receiver]]\nname = "map"\nkind = "surface"\nsurface = "ground"\ngrid = [16, 16]\n'
EYE = {"origin": [-14, -14, 12], "target": [0, 0, 1], "fov": 45, "resolution": [64, 64]}
CAMERA = (
    f'[[receiver]]\nname = "camera"\nkind = "camera"\norigin = {EYE["origin"]}\ntarget = {EYE["target"]}\n'
    f'up = [0, 0, 1]\nfov = {EYE["fov"]}\nresolution = {EYE["resolution"]}\n'
)


def lit(kind, corners, reflectance, folder):
    """Writes the scenes of six points, a map and a camera in front of triangles."""
    name = f"{kind}-{reflectance}"
    lines = [f"v {x!r} {y!r} {z!r}" for x, y, z in corners.reshape(-1, 3).tolist()]
    lines += [f"f {3 * i + 1} {3 * i + 2} {3 * i + 3}" for i in range(len(corners))]
    (folder / f"{name}.obj").write_text("\n".join(lines) + "\n")
    square = lambda z: [[-HALF, -HALF, z], [HALF, -HALF, z], [HALF, HALF, z], [-HALF, HALF, z]]
    base = BLACK + f'[[material]]\nname = "grey"\nkind = "diffuse"\nreflectance = {reflectance}\n'
    base += surface("things", "grey", f'mesh = "{name}.obj"', "two_sided = true\n")
    base += surface("ground", "grey", f"polygon = {square(0.0)}")
    base += surface("lamp", "black", f"polygon = {square(HIGH)[::-1]}", "radiance = 1\n")
    points = "".join(POINT.format(i, place) for i, place in enumerate(places(len(corners))))
    for asked, receivers in (("points", points), ("map", MAP), ("camera", CAMERA)):
        text = base + receivers + "[solve]\ntolerance = 1e-2\n"
        (folder / f"{name}-{asked}.toml").write_text(text)
    return name
