"""Random scenes: rooms, open or closed, with lamps, obstacles and a receiver of any kind.

`written(FOLDER, COUNT)` writes them. The scene of a number is always the same. All surfaces are diffuse in half of the scenes;
the others have a mirror, a body of glass, or haze.
"""

import math
import random

SIDES = [
    "[[0,0,0], [{x},0,0], [{x},{y},0], [0,{y},0]]",
    "[[0,0,{z}], [0,{y},{z}], [{x},{y},{z}], [{x},0,{z}]]",
    "[[0,0,0], [0,{y},0], [0,{y},{z}], [0,0,{z}]]",
    "[[{x},0,0], [{x},0,{z}], [{x},{y},{z}], [{x},{y},0]]",
    "[[0,0,0], [0,0,{z}], [{x},0,{z}], [{x},0,0]]",
    "[[0,{y},0], [{x},{y},0], [{x},{y},{z}], [0,{y},{z}]]",
]


def written(folder, count):
    """Writes the scenes of the numbers below `count`, and returns their files."""
    files = [folder / f"random_{number:03}.toml" for number in range(count)]
    for number, file in enumerate(files):
        file.write_text(scene(number))
    return files


def scene(number):
    """Returns the text of the scene of this number."""
    chance = random.Random(number)
    special = chance.choice(["none", "none", "none", "mirror", "glass", "haze"])
    size = [round(chance.uniform(2, 6), 2) for _ in "xyz"]
    parts = [*materials(chance, special), *walls(chance, size), *lamps(chance, size, special), *obstacles(chance, size)]
    if special in ("mirror", "glass"):
        parts.append(body(chance, size, special, special))
    parts.append(receiver(chance, size))
    if special == "haze":
        parts.append('[ambient]\nmedium = "haze"')
    elif chance.random() < 0.2:
        parts.append("[ambient]\nradiance = 0.3")
    tolerance = chance.choice([1e-1, 3e-2, 1e-2])
    return "\n\n".join(parts) + f"\n\n[solve]\ntolerance = {tolerance}\n"


def materials(chance, special):
    """Returns three diffuse materials, and the special one."""
    for name in ("white", "grey", "dark"):
        reflectance = {"white": 0.75, "grey": 0.4, "dark": 0.0}[name] * chance.uniform(0.7, 1.1)
        yield f'[[material]]\nname = "{name}"\nkind = "diffuse"\nreflectance = {reflectance:.3f}'
    if special == "mirror":
        yield '[[material]]\nname = "mirror"\nkind = "mirror"\nreflectance = 0.9'
    if special == "glass":
        yield '[[medium]]\nname = "glass"\nn = 1.5'
        yield '[[material]]\nname = "glass"\nkind = "dielectric"\ninside = "glass"'
    if special == "haze":
        yield '[[medium]]\nname = "haze"\nsigma_a = 0.02\nsigma_s = 0.04'


def walls(chance, size):
    """Returns the floor, and some of the other sides of a room."""
    is_closed = chance.random() < 0.4
    for index, side in enumerate(SIDES):
        if index == 0 or is_closed or chance.random() < 0.4:
            polygon = side.format(**dict(zip("xyz", size)))
            material = chance.choice(["white", "grey"])
            name = "floor" if index == 0 else f"side {index}"
            yield f'[[surface]]\nname = "{name}"\nmaterial = "{material}"\npolygon = {polygon}'


def place(chance, size, low, high):
    """Returns a point at some part of the height of a room, not close to its walls."""
    x, y, z = size
    return [chance.uniform(0.25, 0.75) * x, chance.uniform(0.25, 0.75) * y, chance.uniform(low, high) * z]


def shown(values):
    return "[" + ", ".join(f"{value:.4f}" for value in values) + "]"


def lamps(chance, size, special):
    """Returns one or two lamps: flat ones that face down, spheres, and points, whose light no round mirror or glass can pass on."""
    kinds = ["polygon", "polygon", "sphere"] + ([] if special in ("mirror", "glass") else ["point"])
    for index in range(chance.choice([1, 1, 2])):
        centre = place(chance, size, 0.85, 0.95)
        kind = chance.choice(kinds)
        if kind == "point":
            yield f'[[light]]\nkind = "point"\nposition = {shown(centre)}\nintensity = 20'
            continue
        if kind == "sphere":
            shape = f"sphere = {{ center = {shown(centre)}, radius = 0.08 }}"
        else:
            shape = f"polygon = {rectangle(centre, chance.uniform(0.1, 0.4), chance.uniform(0.1, 0.4), -1)}"
        yield f'[[surface]]\nname = "lamp {index}"\nmaterial = "dark"\nradiance = {chance.uniform(5, 30):.2f}\n{shape}'


def rectangle(centre, a, b, facing):
    """Returns a level rectangle that faces up or down."""
    x, y, z = centre
    corners = [(x - a, y - b, z), (x + a, y - b, z), (x + a, y + b, z), (x - a, y + b, z)]
    return "[" + ", ".join(shown(corner) for corner in corners[::facing]) + "]"


def obstacles(chance, size):
    """Returns up to three obstacles: tilted triangles, spheres, disks, and boards."""
    for index in range(chance.randrange(4)):
        centre = place(chance, size, 0.25, 0.65)
        kind = chance.choice(["triangle", "board", "sphere", "disk"])
        if kind == "triangle":
            corners = [[value + chance.uniform(-0.5, 0.5) for value in centre] for _ in range(3)]
            shape = "polygon = [" + ", ".join(map(shown, corners)) + "]\ntwo_sided = true"
        elif kind == "board":
            shape = f"polygon = {rectangle(centre, chance.uniform(0.2, 0.6), 0.3, 1)}\ntwo_sided = true"
        elif kind == "sphere":
            shape = f"sphere = {{ center = {shown(centre)}, radius = {chance.uniform(0.1, 0.35):.3f} }}"
        else:
            normal = shown([chance.uniform(-1, 1), chance.uniform(-1, 1), 1])
            shape = f"disk = {{ center = {shown(centre)}, normal = {normal}, radius = 0.35 }}\ntwo_sided = true"
        material = chance.choice(["white", "grey", "dark"])
        yield f'[[surface]]\nname = "obstacle {index}"\nmaterial = "{material}"\n{shape}'


def body(chance, size, name, material):
    """Returns a sphere of a special material, above all obstacles."""
    centre = place(chance, size, 0.74, 0.74)
    return f'[[surface]]\nname = "{name}"\nmaterial = "{material}"\nsphere = {{ center = {shown(centre)}, radius = 0.12 }}'


def receiver(chance, size):
    """Returns one receiver: several would each have a scale of errors of their own."""
    kind = chance.choice(["point", "surface", "map", "ray", "camera", "sphere"])
    x, y, z = size
    if kind == "point":
        text = f'kind = "point"\nposition = {shown([0.3 * x, 0.6 * y, 1e-3])}\nnormal = [0, 0, 1]'
    elif kind == "surface":
        text = 'kind = "surface"\nsurface = "floor"'
    elif kind == "map":
        text = 'kind = "surface"\nsurface = "floor"\ngrid = [8, 8]'
    elif kind == "ray":
        angle = chance.uniform(0, 2 * math.pi)
        direction = shown([math.cos(angle), math.sin(angle), -0.8])
        text = f'kind = "ray"\norigin = {shown([0.5 * x, 0.5 * y, 0.7 * z])}\ndirection = {direction}'
    elif kind == "sphere":
        text = f'kind = "sphere"\nposition = {shown([0.4 * x, 0.45 * y, 0.12 * z])}'
    else:
        text = (
            f'kind = "camera"\norigin = {shown([0.1 * x, 0.1 * y, 0.6 * z])}\ntarget = {shown([0.6 * x, 0.7 * y, 0])}\n'
            "up = [0, 0, 1]\nfov = 60\nresolution = [24, 18]"
        )
    return f'[[receiver]]\nname = "{kind}"\n{text}'
