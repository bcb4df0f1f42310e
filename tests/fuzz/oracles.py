# SPDX-License-Identifier: GPL-2.0-or-later
"""Relations between runs that are valid for every scene. Each function receives the scene, its
results and the lab, and raises a Finding if its relation is violated."""

import json
import re
from dataclasses import replace

import numpy as np
from fuzz import child, figures, statics
from fuzz.deck import deck, has_cage_ring
from fuzz.lab import HOSTS, Finding, same
from fuzz.pose import MIRRORS, TURNS, UPRIGHT
from fuzz.rewrites import REWRITES

# Rounding errors depend on the orientation; they are amplified by the solver's tolerance and by
# contacts that open and close.
POSED = 1e-3
EXTRA = (
    "compute extra balls bearing/ball azimuth inner_load outer_load",
    "compute most balls reduce max c_extra[2]",
    "fix watch all bearing/timestep 7 exceed ignore",
    "fix table all bearing/record {every} ${{out}}/record overwrite yes",
)


def turn(scene, first, lab, draw):
    """Changing the directions of the bearing's axis and of its first ball does not change the
    results."""
    _posed(scene, first, lab, draw.choice(TURNS), "turned")


def mirror(scene, first, lab, draw):
    _posed(scene, first, lab, draw.choice(MIRRORS), "mirrored")


def move(scene, first, lab, draw):
    centre = tuple(draw.uniform(-1, 1) for _ in range(3))
    _posed(scene, first, lab, replace(UPRIGHT, centre=centre), "moved")


def split(scene, first, lab, draw):
    """Two runs of N and M steps give the same results as one run of N + M steps."""
    steps = draw.randint(1, scene["every"] * scene["samples"] - 1)
    _near(scene, first, lab, f"split at step {steps}", lambda _: {"split": steps})


def _posed(scene, first, lab, pose, name):
    _near(scene, first, lab, name, lambda _: {"pose": pose})


def _near(scene, first, lab, what, changes):
    """Check that the results do not change with the options `changes(scene)` for a run. Two types
    of difference are allowed: one that a change of the scene at rounding level also causes, for
    balls at the limit of contact; and one that is caused by rounding, is as large as the
    integrator's error, and vanishes as the tolerance is reduced."""
    other = lab.figures(scene, "changed", **changes(scene))
    if not figures.differences(first, other, POSED):
        return
    for k, share in enumerate((1e-13, -1e-12, 1e-11)):
        inner = scene["inner"] | {
            "force": [value * (1 + share) for value in scene["inner"]["force"]]
        }
        grooves = [[radius * (1 + share / 100), *rest] for radius, *rest in scene["grooves"]]
        near = lab.figures(scene | {"inner": inner, "grooves": grooves}, f"near{k}")
        if figures.differences(first, near, 0.1 * POSED):
            return
    if scene["implicit"] is not None and "solve" not in scene["implicit"]:
        for tolerance in ("1e-10", "1e-11"):
            words = re.sub(r"tolerance \S+", "", scene["implicit"])
            fine = scene | {"implicit": f"{words} tolerance {tolerance}".strip()}
            pair = (
                lab.figures(fine, f"at_{tolerance}"),
                lab.figures(fine, f"changed_at_{tolerance}", **changes(fine)),
            )
            if not figures.differences(*pair, POSED):
                return
    same(first, other, POSED, what)


def restart(scene, first, lab, draw):
    """A run that is restarted at a sample with write_restart and read_restart is bitwise identical
    to a run that is split there."""
    steps = scene["every"] * draw.randint(1, scene["samples"] - 1)
    whole = lab.figures(scene, "split", split=steps, restart="write")
    (lab.folder / "resumed").mkdir()
    (lab.folder / "split" / "half.restart").rename(lab.folder / "resumed" / "half.restart")
    after = lab.figures(scene, "resumed", restart="read")
    # velocity Verlet evaluates forces at half-step velocities, except at the start of a run, where
    # it uses full-step velocities
    count = scene["samples"] - steps // scene["every"] + (scene["implicit"] is not None)
    tails = [
        # there is no row of the cage before the first step
        {
            name: (columns, table[-min(count, len(after[name][1])) :])
            for name, (columns, table) in run.items()
        }
        for run in (whole, after)
    ]
    same(*tails, 0, f"restart at step {steps}")


def observe(scene, first, lab, draw):
    """Adding computes, a record and a step check leaves the results bitwise identical."""
    more = [words.format(every=scene["every"]) for words in EXTRA]
    more = draw.sample(more, draw.randint(1, len(more)))
    if "compute most" in str(more):
        more = sorted({*more, EXTRA[0]}, key=lambda words: "most" in words)
    same(first, lab.figures(scene, "observed", more=more), 0, f"observed by {more}")


def ranks(scene, first, lab, draw):
    count = draw.choice([2, 4])
    same(first, lab.figures(scene, "ranks", ranks=count), 0, f"{count} ranks")


def hosts(scene, first, lab, draw):
    other = draw.choice([name for name in HOSTS if name not in (lab.host, "sanitized")])
    same(first, lab.figures(scene, "other", host=other), 0, f"host {other}")


def rewrite(scene, first, lab, draw):
    name = draw.choice(list(REWRITES))
    lines = REWRITES[name](deck(scene).splitlines(), draw)
    if lines:
        same(first, lab.figures(scene, "rewritten", text="\n".join([*lines, ""])), 0, name)


def neighbour(scene, first, lab, draw):
    """Adding a second, identical bearing that is displaced along the axis leaves the results
    bitwise identical."""
    lines, width = deck(scene).splitlines(), 3 * scene["diameter"]
    at = next(k for k, line in enumerate(lines) if line.startswith("create_bearing"))
    words = re.sub("centre 0 0 0", f"centre 0 0 {width:.17g}", lines[at])
    lines.insert(at + 1, words)
    count = scene["balls"] * (2 if scene["cage"] else 1) + 2 + has_cage_ring(scene)
    half = float(next(line for line in lines if line.startswith("region box")).split()[4])
    lines = [
        f"region box block {f'-{half} {half} ' * 2}-{half} {half + width} units box"
        if line.startswith("region box")
        else re.sub(r"^group (\w+) type (.*)", r"group \1 type \2", line)
        for line in lines
    ]
    # dumps and the capacitance refer only to the first bearing, whereas forces act on both
    lines = [re.sub(r"^(dump atoms) all", r"\1 first", line) for line in lines]
    lines = [
        re.sub(r"^(compute contacts|dump contacts|fix cap) balls", r"\1 first_balls", line)
        for line in lines
    ]
    lines = [
        re.sub(r"^(compute rings|dump rings) rings", r"\1 first_rings", line) for line in lines
    ]
    at = next(k for k, line in enumerate(lines) if line.startswith("group rings"))
    last = count - has_cage_ring(scene)  # the cage follows the rings
    lines[at + 1 : at + 1] = [f"group first_rings id {last - 1} {last}"]
    at = next(k for k, line in enumerate(lines) if line.startswith("group balls"))
    lines[at:at] = [f"group first id 1:{count}", f"group first_balls id 1:{scene['balls']}"]
    two = lab.figures(scene, "two", text="\n".join([*lines, ""]))
    first = {name: table for name, table in first.items() if name != "cage"}  # sums over all cages
    same(first, two, 0, "a second bearing")


def shaft(scene, first, lab, draw):
    """A shaft with a single ring behaves like that ring."""
    if "unbalance" in deck(scene) or scene["gravity"]:
        return
    ring, shaft = (f"fix ring_inner inner bearing/{word}" for word in ("ring", "shaft"))
    _near(
        scene,
        first,
        lab,
        "a shaft of one ring",
        lambda scene: {"text": deck(scene).replace(ring, shaft)},
    )


def rest(scene, first, lab, draw):
    statics.check(scene, lab)


# Quantities in the summary of a record that do not depend on the orientation; the directions of
# force and shift rotate with it.
SCALARS = (
    "ring_shift_m load_parameter q_max_N q_inner_max_N q_outer_max_N p_max_inner_Pa p_max_outer_Pa "
    "entrainment_speed_m_s h_min_m h_c_m lambda capacitance_F capacitance_top_F "
    "friction_torque_N_m losses_W capacitance_total_F asperity_share "
    "cage_slip cage_slip_angle cage_slip_groove cage_slip_play cage_orbit_m pocket_play_m "
    "pocket_force_max_N pocket_force_mean_N"
).split()


def read(scene, first, lab, draw):
    """`raceway summary` of a record gives the same results in every orientation."""
    columns, table = first["contacts"]
    load, side = (table[..., columns.index(name)] for name in ("load", "raceway"))
    if not all(load[side == k].max(initial=0) > 1e-12 for k in (0, 1)):
        return  # N; below this load, rounding decides which balls touch
    record = f"fix table all bearing/record {scene['every']} ${{out}}/record overwrite yes"
    pose = draw.choice([*TURNS, *MIRRORS])
    told = []
    for name, place in (("upright", UPRIGHT), ("posed", pose)):
        other = lab.figures(scene, name, place, more=[record])
        end = child.raceway(["summary", str(lab.folder / name / "record"), "--json"], lab.folder)
        told.append(json.loads(end.out) if end.code == 0 else {"error": "refused"})
    if figures.differences(first, other, POSED, start=0):
        return
    for key in ("error", *SCALARS):
        a, b = (value.get(key) for value in told)
        if not _alike(a, b):
            raise Finding(f"summary: {key} is {a} upright but {b} with {pose}")


def _alike(a, b):
    if isinstance(a, dict) and isinstance(b, dict):
        return a.keys() == b.keys() and all(_alike(a[key], b[key]) for key in a)
    if isinstance(a, float | int) and isinstance(b, float | int):
        return abs(a - b) <= 1e-2 * max(abs(a), abs(b)) + 1e-12
    return a == b


def energy(scene, first, lab, draw):
    """Work, dissipation and storage balance to within 1e-3, or approach a balance as the substeps
    are made shorter."""
    jumps = any("position" in str(scene[ring]) for ring in ("inner", "outer"))  # no work defined
    if scene["implicit"] is None or "solve" in scene["implicit"] or jumps:
        return
    share = 1.0
    for parts in (4, 32, 256):
        control = f"tolerance 1e-10 energy yes largest {scene['step'] / parts:.17g}"
        text = deck(scene | {"implicit": control}).splitlines()
        terms = [f"variable e{k} equal f_move[{k}]" for k in range(7, 11)]
        values = " ".join(f"${{e{k}}}" for k in range(7, 11))
        steps = scene["every"] * scene["samples"]
        terms.append(f'fix account all print {steps} "{values}" file ${{out}}/energy.txt screen no')
        end = lab.start("\n".join([*text[:-1], *terms, text[-1], ""]), "energy")
        if end.code:
            raise Finding(f"the run is rejected when energy is added: {end.error.splitlines()[0]}")
        rows = np.loadtxt(lab.folder / "energy" / "energy.txt", comments="#", ndmin=2)
        before, (*account, own) = share, abs(rows[-1])
        share = own / (max(account) + 1e-12)
        if share <= 1e-3:
            return
    raise Finding(f"energy: a fraction {share:.2g} is missing, {before:.2g} with longer substeps")


ORACLES = {
    f.__name__: f
    for f in (turn, mirror, move, split, restart, observe, ranks, hosts)
    + (rewrite, neighbour, shaft, rest, read, energy)
}
