# SPDX-License-Identifier: GPL-2.0-or-later
"""Write a scene, in a given orientation, as a deck for any host."""

from fuzz.pose import LAB, UPRIGHT

ATOMS = "id type x y z vx vy vz omegax omegay omegaz".split()
RINGS = "ring x y z vx vy vz spin angle tilt_1 tilt_2 fx fy fz mx my mz torque ax ay az".split()
CONTACTS = (
    "ball raceway groove azimuth angle overlap load normal a b pressure mu friction "
    "friction_power damping_power entrainment"
).split()
FILM = ["h_min", "lambda"]
LOSSES = "friction_power damping_power rolling_power hysteresis_power spin_power drag_power"
CAGE = "pocket_max pocket_sum loss eccentricity".split()
SUMS = "contacts loaded load_inner load_outer pressure".split()


def deck(scene, pose=UPRIGHT, split=None, cuts="* * *", more=(), restart=None):
    """Return the text of the deck. `split` is the number of steps in the first of two runs. `more`
    are commands that must not affect the motion. `restart` is "write" to write a file after the
    first run, or "read" to start from this file."""
    total = scene["every"] * scene["samples"]
    lines = [*_world(scene, pose, cuts)]
    if restart == "read":
        lines = [
            line for line in lines if not line.startswith(("region", "create_box", "boundary"))
        ]
        lines += ["read_restart ${out}/half.restart"]
    else:
        lines += [*_contacts(scene, pose), *_create(scene, pose)]
    lines += [
        "neighbor %g bin" % (0.3 * scene["diameter"]),
        "neigh_modify delay 0 every 1 check yes",
    ]
    lines += [*_fixes(scene, pose), *more, *_output(scene), f"timestep {scene['step']:g}"]
    if restart == "read":
        return "\n".join([*lines, f"run {total} upto", ""])
    runs = [total] if split is None else [split, total - split]
    between = ["write_restart ${out}/half.restart"] if restart == "write" else []
    lines += [f"run {runs[0]}", *between, *(f"run {steps}" for steps in runs[1:])]
    return "\n".join([*lines, ""])


def _words(values):
    return " ".join(f"{value:.17g}" if isinstance(value, float) else str(value) for value in values)


def _world(scene, pose, cuts):
    half = 1.5 * scene["grooves"][1][0]
    box = " ".join(f"{c - half:.17g} {c + half:.17g}" for c in pose.centre)
    return [
        "shell mkdir ${out}",
        "units si",
        "atom_style sphere",
        "atom_modify map array sort 0 0.0",
        "boundary f f f",
        "newton off",
        f"processors {cuts}",
        f"region box block {box} units box",
        "create_box 4 box",
    ]


def _contacts(scene, pose):
    style = "ehd" if scene["film"] else "hertz"
    axis = f"axis {LAB[pose.axis]}"
    limit = scene["overlap_limit"]
    yield f"pair_style bearing/{style} {axis} overlap_limit {limit} {scene['law']}".strip()
    for type_, name, (radius, groove, arch) in zip(
        (3, 4), ("inner", "outer"), scene["grooves"], strict=True
    ):
        words = f" gothic_arch {arch:.17g}" if arch else ""
        yield f"pair_coeff 1 {type_} {name} {radius:.17g} {groove:.17g}{words}"
    if has_cage_ring(scene):
        yield "pair_coeff 1 2 cage"
    else:
        yield f"pair_coeff 1 {2 if scene['cage'] else 1} sphere 210e9 0.3 3.3e9 0.41"


def _create(scene, pose):
    cage = scene["cage"]
    speed = [pose.sense * value for value in scene["speed"]]
    seat = {0: "none", 1: "plus", -1: "minus"}[scene["seat"] * pose.signs[2]]
    yield (
        f"create_bearing 1 {2 if cage else 'none'} 3 4 balls {scene['balls']} "
        f"diameter {scene['diameter']:.17g} density {scene['density']:.17g} "
        + (f"cage {cage:.17g} " if cage else "")
        + ("cage_ring 2 " if has_cage_ring(scene) else "")
        + f"centre {_words(pose.centre)} phase {pose.azimuth(scene['phase']):.17g} "
        f"speed {_words(speed)} seat {seat}"
    )


def _fixes(scene, pose):
    moving = "1" if has_cage_ring(scene) else "1 2"
    yield from ("group balls type 1", f"group moving type {moving}", "group inner type 3")
    yield from ("group outer type 4", "group cage type 2")
    if scene["cage"]:
        yield "fix rails cage bearing/cage 4"
    if has_cage_ring(scene):
        yield f"fix cage cage bearing/cage/ring 1 {_cage_ring(scene, pose)}"
    for number, (ring, kind, azimuth, *rest) in enumerate(scene["flaws"]):
        # in a wave, the order takes the position of the azimuth, and the last word is the phase at
        # azimuth 0
        if kind == "wave":
            order, (amplitude, phase) = azimuth, rest
            # cos(n phi + p), where phi = sense (lab - offset)
            phase = pose.sense * phase - order * pose.azimuth(0)
            rest = [order, amplitude, phase]
        else:
            rest = [pose.azimuth(azimuth), *rest]
        if scene["grooves"][ring == "outer"][2] and pose.signs[2] < 0:
            rest = [*rest, "groove", 1]  # the first groove in the direction of the lab axis
        yield f"fix flaw{number} {ring} bearing/profile {kind} {_words(rest)}"
    if scene["implicit"] is None:
        yield "fix move moving nve/sphere"
    else:
        yield f"fix move all bearing/implicit {scene['implicit']}".strip()
    for name in ("inner", "outer"):
        if scene[name]:
            yield f"fix ring_{name} {name} bearing/ring {_ring(scene[name], pose)}"
    if scene["gravity"]:
        strength = sum(value**2 for value in scene["gravity"]) ** 0.5
        direction = _words(pose.polar(scene["gravity"]))
        yield f"fix weight all gravity {strength:.17g} vector {direction}"
    if scene["capacitance"]:
        yield f"fix cap balls bearing/capacitance {scene['every']} {scene['capacitance']}"


def _cage_ring(scene, pose):
    words = [f"pockets {scene['balls']} phase {pose.azimuth(scene['phase']):.17g}"]
    for name, value in scene["cage_ring"].items():
        words.append(f"{name} {_words(value if isinstance(value, list) else [value])}")
    return " ".join(words)


def _ring(ring, pose):
    words = [f"mass {ring['mass']:.17g} inertia {_words(ring['inertia'])}"]
    for own, (name, mode) in enumerate(ring["freedoms"].items()):
        tilt = name.startswith("r")
        lab = pose.axes[own - 3 if tilt else own]
        sign = pose.signs[own - 3 if tilt else own] * (pose.hand if tilt else 1)
        words.append(f"{'r' * tilt}{LAB[lab]} " + _words([mode[0], *(sign * v for v in mode[1:])]))
    words.append(f"spin speed {pose.sense * float(ring['spin']):.17g}")
    if any(ring["force"]):
        words.append(f"force {_words(pose.polar(ring['force']))}")
    if any(ring["moment"]):
        words.append(f"moment {_words(pose.axial([*ring['moment'], 0]))}")
    if ring["rotating"]:
        force, speed, phase = ring["rotating"]
        words.append(f"rotating {_words([force, pose.sense * speed, pose.azimuth(phase)])}")
    if ring["unbalance"]:
        moment, phase = ring["unbalance"]
        words.append(f"unbalance {_words([moment, pose.azimuth(phase)])}")
    for name, values in ring["supports"].items():
        lab = LAB[pose.axes["xyz".index(name[-1])]]
        words.append(f"support {name[:-1]}{lab} {_words(values)}")
    if ring["ramp"]:
        words.append(f"ramp {ring['ramp']:g}")
    return " ".join(words)


def has_cage_ring(scene):
    return scene.get("cage_ring") is not None


def contact_columns(scene):
    return [*CONTACTS, *(FILM if scene["film"] else [])]


def ring_columns():
    return [*RINGS, "load", *LOSSES.split()]


def _output(scene):
    every = scene["every"]
    for name, group, style, columns in (
        ("contacts", "balls", "contact", contact_columns(scene)),
        ("rings", "rings", "ring", ring_columns()),
    ):
        if name == "rings":
            yield "group rings type 3 4"
        yield f"compute {name} {group} bearing/{style} {' '.join(columns)}"
        values = " ".join(f"c_{name}[{k + 1}]" for k in range(len(columns)))
        yield f"dump {name} {group} local {every} ${{out}}/{name}.dump {values}"
        yield f'dump_modify {name} ${{dump_format}} "{" ".join(["%.17g"] * len(columns))}"'
    yield f"dump atoms all custom {every} ${{out}}/atoms.dump {' '.join(ATOMS)}"
    yield f'dump_modify atoms ${{dump_format}} "%d %d{" %.17g" * 9}" sort id'
    yield "compute total all bearing/total"
    for number, name in enumerate(SUMS):
        yield f"variable t_{name} equal c_total[{number + 1}]"
    if has_cage_ring(scene):
        for number, name in enumerate(CAGE):
            yield f"variable c_{name} equal f_cage[{27 + number}]"
        values = " ".join(f"${{c_{name}}}" for name in ("now", *CAGE))
        yield "variable c_now equal step"
        yield f'fix cage_sums all print {every} "{values}" file ${{out}}/cage.txt screen no'
    yield "variable t_now equal step"
    values = " ".join(f"${{t_{name}}}" for name in ("now", *SUMS))
    yield f'fix sums all print {every} "{values}" file ${{out}}/sums.txt screen no'
    yield "thermo_style custom step atoms"
    yield "thermo_modify lost error"
    yield "thermo 1000"
