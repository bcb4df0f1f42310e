# SPDX-License-Identifier: GPL-2.0-or-later
"""A scene consists of one bearing, the degrees of freedom and loads of its rings, flaws, and time
steps. It is described in its own frame (x and y across its axis z); deck.py places it in the lab
frame."""

import math

from fuzz import law
from fuzz.draw import Draw, grammar

FREEDOMS = ("x", "y", "z", "rx", "ry")


def scene(seed):
    """Return the scene for a seed as plain data, from which shrink.py can remove parts one by
    one."""
    draw = Draw(seed)
    film = draw.chance(0.65)
    bearing = _bearing(draw)
    implicit = draw.chance(0.75)
    spins = [_speed(draw), _speed(draw) if draw.chance(0.15) else 0]
    made = bearing | {
        "film": film,
        "law": law.words(draw, film),
        "speed": spins,
        "implicit": _implicit(draw) if implicit else None,
        **_time(draw, implicit, bearing),
        "inner": _ring(draw, bearing, spins[0]),
        "outer": _ring(draw, bearing, spins[1], outer=True)
        if spins[1] or draw.chance(0.2)
        else None,
        "gravity": draw.maybe(0.15, lambda: [draw.uniform(-50, 50) for _ in range(3)]),
        "flaws": [_flaw(draw, bearing) for _ in range(draw.choice([0, 0, 0, 1, 2]))],
        "capacitance": draw.maybe(0.5, lambda: _capacitance(draw)) if film else None,
    }
    ring = draw.maybe(0.35, lambda: _cage_ring(draw, bearing, implicit))
    return made | ({"cage": None, "cage_ring": ring} if ring else {"cage_ring": None})


def _bearing(draw):
    ranges = grammar("scene")["bearing"]
    number = lambda key: draw.number(ranges[key])  # noqa: E731
    diameter, balls = number("ball_diameter"), number("balls")
    pitch = max(balls * diameter * number("fill") / (2 * math.pi), 1.2 * diameter)
    kind = draw.choice(["radial", "radial", "angular", "arch", "inner arch", "outer arch"])
    angle = 0 if kind == "radial" else math.radians(number("contact_angle"))
    rings = []
    for side, name in ((1, "inner"), (-1, "outer")):
        groove = float(f"{diameter * number('conformity'):.6g}")
        gap = groove - diameter / 2
        raised = gap * math.cos(angle) if kind in ("angular", "arch", f"{name} arch") else gap
        arch = gap * math.sin(angle) if kind in ("arch", f"{name} arch") else 0
        rings.append([pitch - side * (groove - raised), groove, arch])
    play = number("clearance") * diameter * (0.1 if kind != "radial" else 1)
    rings[1][0] += play / 2 if kind != "angular" else 0
    room = 2 * (2 * pitch * math.sin(math.pi / 2 / balls) - diameter / 2)
    return {
        "balls": balls,
        "diameter": diameter,
        "grooves": rings,
        "density": float(number("density")),
        "cage": draw.maybe(0.4, lambda: room * number("cage")),
        "phase": draw.choice([0, draw.uniform(-math.pi, math.pi)]),
        "seat": draw.choice([0, 1, -1]) if kind in ("angular", "arch") else 0,
        "overlap_limit": 0.2,
    }


def _cage_ring(draw, bearing, implicit):
    ranges = grammar("scene")["cage_ring"]
    number = lambda key: draw.number(ranges[key])  # noqa: E731
    diameter = bearing["diameter"]
    (inner, groove, _), (outer, _, _) = bearing["grooves"]
    pitch = (inner + outer) / 2
    play = number("play") * diameter
    balls = bearing["balls"] * bearing["density"] * math.pi / 6 * diameter**3
    mass = balls * number("mass")
    thick = mass * (pitch**2 + diameter**2 / 12)
    words = {
        "play": play,
        "mass": mass,
        "inertia": [mass * pitch**2, thick / 2],
        "young": [2.08e11, number("young")],
        "friction": draw.choice([0, number("friction")]),
    }
    if draw.chance(0.4):
        words["across"] = play * number("across")
    if draw.chance(0.3):
        words["shape"] = draw.choice(["cylinder", "sphere"])
    if draw.chance(0.3):
        words["wall"] = number("wall")
    guide = draw.choice(["balls", "balls", "inner", "outer"])
    if guide != "balls":
        off = (1 if guide == "outer" else -1) * number("land") * diameter
        gap, width = number("clearance") * diameter, number("width") * diameter
        words["guide"] = [guide, pitch + off, gap, width, draw.choice([1, 2])]
    if draw.chance(0.7):
        oil, filled = number("oil"), number("filled")
        words["oil"] = [oil, filled, draw.choice([0, number("height") * diameter])]
        # velocity Verlet would need much shorter steps with a squeeze film
        film = draw.maybe(0.2, lambda: draw.choice([0, number("height") * diameter]))
        if film is not None or not implicit:
            words["film"] = film if implicit else 0
        if not implicit or draw.chance(0.2):
            words["land_oil"] = 0 if not implicit else number("filled")
        if draw.chance(0.3):
            words["churning"] = [number("filled"), 870, oil, pitch + 0.4 * diameter]
    if draw.chance(0.5):
        words["planar"] = draw.choice(["yes", "no"])
    return words


def _speed(draw):
    if draw.chance(0.1):
        return 0
    return draw.choice([1, 1, -1]) * draw.number(grammar("scene")["motion"]["speed"])


def _implicit(draw):
    words = []
    if draw.chance(0.2):
        words += ["solve", "damping"]
    elif draw.chance(0.3):
        words += ["tolerance", draw.choice(["1e-8", "1e-10", "1e-9"])]
    if draw.chance(0.2):
        words += ["order", "1"]
    if draw.chance(0.2):
        words += ["energy", "yes"]
    if draw.chance(0.1):
        words += ["largest", "5e-6"]
    return " ".join(words)


def _time(draw, implicit, bearing):
    ranges = grammar("scene")["motion"]
    every, samples = draw.number(ranges["steps"]), draw.number(ranges["samples"])
    if implicit:
        return {"step": draw.number(ranges["step"]), "every": every, "samples": samples}
    # this step is short enough for velocity Verlet, so more steps are needed
    step = 1.0e-7 * bearing["diameter"] / 12.6e-3
    return {"step": float(f"{step:.3g}"), "every": 20 * every, "samples": samples}


def _ring(draw, bearing, spin, outer=False):
    diameter, balls = bearing["diameter"], bearing["balls"]
    ranges = grammar("scene")
    load = draw.number(ranges["motion"]["load"]) * diameter**2 * balls
    radius = bearing["grooves"][1][0]
    mass = 0.2 * (diameter / 12.6e-3) ** 3 * draw.uniform(0.5, 3)
    freedoms = {name: ["fixed"] for name in FREEDOMS}
    axial = draw.chance(0.4)
    for name in ("x", "y"):
        freedoms[name] = ["free"] if draw.chance(0.85) else _driven(draw, diameter)
    if axial:
        freedoms["z"] = ["free"] if draw.chance(0.8) else _driven(draw, diameter)
    if draw.chance(0.3):
        freedoms["rx"] = freedoms["ry"] = ["free"]
    elif draw.chance(0.15):
        freedoms["rx"] = _driven(draw, 0.1)
    azimuth = draw.choice([-math.pi / 2, draw.uniform(-math.pi, math.pi)])
    thrust = load * draw.uniform(-1, 1) if freedoms["z"] == ["free"] else 0
    force = [load * math.cos(azimuth), load * math.sin(azimuth), thrust]
    ring = {
        "mass": mass,
        "inertia": [mass * radius**2 * 0.6, mass * radius**2 * 0.4],
        "freedoms": freedoms,
        "spin": spin,
        "force": [0, 0, 0] if outer else force,
        "moment": [load * diameter * draw.uniform(-0.5, 0.5) for _ in range(2)]
        if freedoms["rx"] == ["free"]
        else [0, 0],
        "ramp": draw.choice([0, 1.0e-4, 1.0e-3]),
        "rotating": draw.maybe(
            0.15, lambda: [0.2 * load, draw.uniform(-500, 500), draw.uniform(-3, 3)]
        ),
        "unbalance": draw.maybe(0.15 if spin else 0, lambda: [mass * 1e-4, draw.uniform(-3, 3)]),
        "supports": {},
    }
    if outer or draw.chance(0.2):
        for name in FREEDOMS[: 3 if draw.chance(0.3) else 2]:
            if freedoms[name] == ["free"]:
                k = draw.number(ranges["support"]["stiffness"])
                ring["supports"][name] = [k, draw.number(ranges["support"]["damping"])]
    return ring


def _driven(draw, length):
    kind = draw.choice(["speed", "position", "fixed"])
    return {
        "fixed": ["fixed"],
        "speed": ["speed", length * draw.uniform(-0.05, 0.05)],
        "position": ["position", length * draw.uniform(-2e-4, 2e-4)],
    }[kind]


def _flaw(draw, bearing):
    ranges = grammar("scene")["flaw"]
    ring, azimuth = draw.choice(["inner", "outer"]), draw.uniform(-math.pi, math.pi)
    depth = draw.number(ranges["depth"])
    if draw.chance(0.3):
        return [ring, "wave", draw.randint(2, 20), min(depth, 1e-7), azimuth]
    length = draw.number(ranges["length"]) * bearing["diameter"]
    width = draw.choice(["full", length])
    edge = min(length / 10, 0.3 * math.sqrt(bearing["diameter"] * depth))
    return [ring, "notch", azimuth, length, width, depth, edge]


def _capacitance(draw):
    words = ["permittivity", "2.25"]
    if draw.chance(0.4):
        words += ["surroundings", draw.choice(["flooded", "dry", "cavitated"])]
    if draw.chance(0.2):
        words += ["resistivity", "1e9", "strength", "3e7"]
    return " ".join(words)
