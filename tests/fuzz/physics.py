# SPDX-License-Identifier: GPL-2.0-or-later
"""Check signs, sums and balances in the results of one run."""

import numpy as np
from fuzz.deck import LOSSES, SUMS
from fuzz.lab import Finding


def check(scene, figures, folder):
    columns, contacts = figures["contacts"]
    of = {name: contacts[..., columns.index(name)] for name in columns}
    touching = of["ball"] > 0
    names, rings = figures["rings"]
    ring = {name: rings[..., names.index(name)] for name in names}
    law = set(scene["law"].split())
    gap = law & {"gap", "gap_film"}  # with these keywords, contacts begin before the surfaces touch
    springs = scene["implicit"] is None or law & {"heathcote", "slices"}
    for name in ("a", "b", "pressure", "h_min", "lambda", *([] if gap else ["overlap"])):
        if name in of and (of[name][touching] < 0).any():
            raise Finding(f"negative {name}")
    # a tangential spring can return energy that it has stored
    for name in ("load", "normal", *([] if springs else ["friction_power"])):
        if (of[name][touching] < -1e-9 * abs(of[name]).max(initial=0)).any():
            raise Finding(f"negative {name} of a contact: {of[name].min()}")
    slack = 1e-9 + 1e-9 * of["normal"].max(initial=0)
    if (of["friction"] > of["mu"] * of["normal"] * (1 + 1e-9) + slack).any():
        raise Finding("friction above mu times the normal force")
    if "cage" in figures:
        _cage(*figures["cage"])
    _sums(scene, of, touching, ring)
    _totals(of, touching, folder)


def _cage(names, table):
    of = {name: table[..., names.index(name)] for name in names}
    for name in ("pocket_max", "loss", "eccentricity"):
        if of[name].min() < -1e-20:  # rounding in a bearing at rest
            raise Finding(f"negative {name} of the cage")
    if (of["pocket_max"] > of["pocket_sum"] * (1 + 1e-9)).any():
        raise Finding("the largest force on a pocket exceeds the sum of these forces")


def _sums(scene, of, touching, ring):
    """Check that the force on every ring is the sum over its contacts."""
    inner = ring["ring"].argmin(axis=1)
    for side in (0, 1):
        pick = inner if side == 0 else 1 - inner
        mine = touching & (of["raceway"] == side)
        rows = np.arange(len(pick))
        for name in LOSSES.split():
            if name in of:
                total = np.where(mine, of[name], 0).sum(axis=1)
                _close(total, ring[name][rows, pick], f"sum of {name} of ring {side}")
        most = np.where(mine, of["load"], 0).max(axis=1, initial=0)
        _close(most, ring["load"][rows, pick], f"largest load of ring {side}")
        if side and (scene["cage"] or "drag" in scene["law"]):
            continue  # rails and drag also exert forces on the ring
        if ("inner", "outer")[side] in str(scene.get("cage_ring")):
            continue  # and so does a cage that the ring guides
        radial = np.where(mine, of["normal"] * np.cos(of["angle"]), 0)
        sign = -1 if side == 0 else 1
        axial = np.where(mine, of["normal"] * np.sin(of["angle"]), 0).sum(axis=1)
        across = ring["tilt_2"][rows, pick], -ring["tilt_1"][rows, pick]  # axis of a tilted ring
        force = [
            sign * ((radial * f(of["azimuth"])).sum(axis=1) + axial * e)
            for f, e in zip((np.cos, np.sin), across, strict=True)
        ]
        slack = (
            np.where(mine, of["friction"], 0).sum(axis=1) + 2e-2 * abs(radial).sum(axis=1) + 1e-6
        )
        for axis, value in zip("xy", force, strict=True):
            off = abs(value - ring[f"f{axis}"][rows, pick]) - slack
            if (off > 0).any():
                raise Finding(
                    f"f{axis} of ring {side} differs from the sum over its contacts by "
                    f"{off.max():.3g} N more than allowed"
                )


def _totals(of, touching, folder):
    rows = np.loadtxt(folder / "sums.txt", comments="#", ndmin=2)
    found = dict(zip(("now", *SUMS), rows.T, strict=True))
    missing = len(touching) - len(rows)  # LIGGGHTS prints no row before the first step
    touching = touching[missing:]
    of = {name: values[missing:] for name, values in of.items()}
    counts = touching.sum(axis=1)
    if len(counts) != len(rows):
        raise Finding(f"{len(rows)} rows of sums for {len(counts)} samples of contacts")
    _close(counts, found["contacts"], "contacts of compute total")
    for side, name in enumerate(("load_inner", "load_outer")):
        mine = np.where(touching & (of["raceway"] == side), of["load"], 0).max(axis=1, initial=0)
        _close(mine, found[name], name, 1e-6)
    _close(np.where(touching, of["pressure"], 0).max(axis=1), found["pressure"], "pressure", 1e-6)


def _close(first, second, what, share=1e-9):
    scale = max(abs(np.asarray(first)).max(initial=0), abs(np.asarray(second)).max(initial=0))
    off = abs(first - second).max(initial=0)
    if off > share * scale + 1e-12:
        raise Finding(f"{what}: differs by {off:.3g}, largest value {scale:.3g}")
