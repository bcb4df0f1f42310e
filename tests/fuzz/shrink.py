# SPDX-License-Identifier: GPL-2.0-or-later
"""Remove parts of a scene for as long as the failure persists, and write it without what it has in
common with a plain scene."""

from itertools import combinations

PLAIN = {
    "flaws": [],
    "outer": None,
    "gravity": None,
    "capacitance": None,
    "cage": None,
    "cage_ring": None,
    "phase": 0,
    "seat": 0,
    "implicit": "",
    "law": "",
    "film": False,
    "speed": [0, 0],
    "samples": 2,
    "every": 2,
}
PLAIN_RING = {
    "rotating": None,
    "unbalance": None,
    "supports": {},
    "ramp": 0,
    "moment": [0, 0],
    "spin": 0,
}
FIXED = {name: ["fixed"] for name in ("x", "y", "z", "rx", "ry")}


def slim(scene):
    """Return the scene without what `whole` adds."""

    def ring(one):
        freedoms = {name: mode for name, mode in one["freedoms"].items() if mode != FIXED[name]}
        return _differs(one | {"freedoms": freedoms}, PLAIN_RING)

    scene = scene | {which: scene[which] and ring(scene[which]) for which in ("inner", "outer")}
    return _differs(scene, PLAIN)


def whole(scene):
    """Return the scene with all that it has in common with a plain scene."""

    def ring(one):
        return PLAIN_RING | one | {"freedoms": FIXED | one["freedoms"]}

    scene = PLAIN | scene
    return scene | {which: scene[which] and ring(scene[which]) for which in ("inner", "outer")}


def _differs(found, plain):
    return {
        name: value for name, value in found.items() if name not in plain or plain[name] != value
    }


def shrink(scene, fails):
    """Return the smallest scene that was found for which `fails(scene)` is true."""
    again = True
    while again:
        again = False
        for smaller in _smaller(scene):
            if smaller != scene and fails(smaller):
                scene, again = smaller, True
                break
    return scene


def _smaller(scene):
    for name, value in PLAIN.items():
        if scene.get(name) != value and not (name == "film" and scene["law"]):
            yield scene | {name: value}
    for name in sorted({*(scene.get("cage_ring") or {})} - {"play", "mass", "inertia"}):
        ring = {key: value for key, value in scene["cage_ring"].items() if key != name}
        yield scene | {"cage_ring": ring}
    for k in range(len(scene["flaws"])):
        yield scene | {"flaws": scene["flaws"][:k] + scene["flaws"][k + 1 :]}
    for which in ("inner", "outer"):
        ring = scene[which]
        if not ring:
            continue
        for name, value in PLAIN_RING.items():
            if ring[name] != value:
                yield scene | {which: ring | {name: value}}
        for name, mode in ring["freedoms"].items():
            if mode != ["fixed"]:
                fixed = ring["freedoms"] | {name: ["fixed"]}
                kept = {at: of for at, of in ring["supports"].items() if at != name}
                yield scene | {which: ring | {"freedoms": fixed, "supports": kept}}
    words = scene["law"].split()
    starts = [k for k, word in enumerate(words) if word[0].isalpha()] + [len(words)]
    for a, b in combinations(starts, 2):
        yield scene | {"law": " ".join(words[:a] + words[b:])}
