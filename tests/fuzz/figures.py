# SPDX-License-Identifier: GPL-2.0-or-later
"""Read the output of a run, in the frame of the bearing."""

import numpy as np
from fuzz.deck import ATOMS, CAGE, contact_columns, has_cage_ring, ring_columns
from host import tables

AXIAL = {"omegax", "tilt_1", "mx"}  # first components of axial vectors
VECTORS = ("x", "vx", "omegax", "fx", "mx", "ax")


def read(folder, scene, pose):
    """Return a dict that maps each table to (columns, array (samples, rows, columns)), in the frame
    and the order of the scene."""
    balls, cage = scene["balls"], bool(scene["cage"])
    # the number of contacts varies, so there is one row for every ball, raceway and groove, which
    # contains 0 if there is no contact
    columns = contact_columns(scene)
    contacts, steps = [], []
    for step, rows in tables(folder / "contacts.dump"):
        steps.append(step)
        full = np.zeros((2 * balls, 2, len(columns)))
        for row in rows:
            row = _contact(row, columns, pose, scene)
            full[2 * int(row[0] - 1) + int(row[1]), int(row[2])] = row
        contacts.append(full.reshape(-1, len(columns)))
    order = _order(balls, cage, has_cage_ring(scene), pose)
    atoms = np.array([rows[np.argsort(rows[:, 0])] for _, rows in tables(folder / "atoms.dump")])
    atoms = _vectors(atoms[:, order], ATOMS, pose, ("x", "vx", "omegax"))
    atoms[..., 0] = np.arange(1, len(order) + 1)
    names = ring_columns()
    rings = np.array([rows[np.argsort(rows[:, 0])] for _, rows in tables(folder / "rings.dump")])
    rings = _vectors(rings, names, pose, ("x", "vx", "fx", "mx", "ax"))
    for name in ("spin", "angle", "torque"):
        rings[..., names.index(name)] *= pose.sense
    _tilts(rings, names, pose)
    cage_sums = {}
    if has_cage_ring(scene):
        rows = np.loadtxt(folder / "cage.txt", comments="#", ndmin=2)
        # only LAMMPS prints a row before the first step of a run
        rows = rows[(rows[:, 0] > steps[0]) & (rows[:, 0] > np.append(-1, rows[:-1, 0]))]
        cage_sums["cage"] = (CAGE, rows[:, None, 1:])
    return {
        "contacts": (columns, np.array(contacts)),
        "atoms": (ATOMS, atoms),
        "rings": (names, rings),
        **cage_sums,
    }


def _order(balls, cage, ring, pose):
    """Return the index in the lab frame of every atom, in the order of the scene."""
    step = np.arange(balls)
    if pose.sense < 0:
        own_balls, own_cage = (-step) % balls, (-step - 1) % balls
    else:
        own_balls = own_cage = step
    parts = [own_balls, balls + own_cage] if cage else [own_balls]
    count = balls * (2 if cage else 1)
    return np.concatenate([*parts, count + np.arange(3 if ring else 2)])


def _contact(row, columns, pose, scene):
    row = row.copy()
    if pose.sense < 0:
        row[0] = (1 - row[0]) % scene["balls"] + 1
    if pose.signs[2] < 0:
        row[columns.index("angle")] *= -1
        if scene["grooves"][int(row[1])][2]:
            row[2] = 1 - row[2]
    azimuth = row[columns.index("azimuth")]
    own = pose.sense * (azimuth - pose.azimuth(0))
    row[columns.index("azimuth")] = np.mod(own + np.pi, 2 * np.pi) - np.pi
    return row


def _vectors(table, names, pose, firsts):
    table = table.copy()
    for first in firsts:
        at = slice(names.index(first), names.index(first) + 3)
        vectors = table[..., at]
        if first == "x" and names is ATOMS:
            vectors = vectors - pose.centre
        table[..., at] = pose.back(vectors, axial=first in AXIAL)
    return table


def _tilts(rings, names, pose):
    at = names.index("tilt_1")
    lab = np.zeros((*rings.shape[:2], 3))
    lab[..., (pose.axis + 1) % 3] = rings[..., at]
    lab[..., (pose.axis + 2) % 3] = rings[..., at + 1]
    rings[..., at : at + 2] = pose.back(lab, axial=True)[..., :2]


def differences(first, second, tolerance, start=1):
    """Return a list of (relative difference, table, column, sample) for columns that differ by more
    than `tolerance` times their largest value, in order of decreasing difference."""
    found = []
    for name, (columns, a) in first.items():
        b = second[name][1]
        if name == "contacts" and tolerance:
            a, b = _loaded(columns, a, b)
            at = columns.index("azimuth")
            b[..., at] -= 2 * np.pi * np.round((b[..., at] - a[..., at]) / (2 * np.pi))
        if tolerance:  # at the start, rounding decides whether balls that just touch are in contact
            a, b = a[start:], b[start:]
        if a.shape != b.shape:
            found.append((np.inf, name, f"shape {a.shape} {b.shape}", 0))
            continue
        for group in _groups(columns):
            scale = np.abs(a[..., group]).max(initial=0) + FLOOR.get(columns[group[0]], 1e-12)
            share = np.abs(a[..., group] - b[..., group]).max(axis=(1, 2), initial=0) / scale
            if not (share.max(initial=0) <= tolerance):
                worst = int(np.nanargmax(share)) if not np.isnan(share).all() else 0
                found.append((float(share[worst]), name, columns[group[0]], worst))
    return sorted(found, reverse=True)


def _loaded(columns, a, b):
    """Return the contact tables of two runs in a form that can be compared. Rounding opens and
    closes contacts near zero load, so only the loads of these contacts are kept, and all other
    columns are set to 0."""
    load = columns.index("load")
    light = np.minimum(a[..., load], b[..., load]) < 1e-2 * a[..., load].max(initial=0)
    kept = np.arange(len(columns)) == load
    return [np.where(light[..., None] & ~kept, 0, table) for table in (a, b)]


# values below these limits are treated as zero
FLOOR = {
    "x": 1e-9,
    "vx": 1e-4,
    "omegax": 1e-1,
    "fx": 1e-2,
    "mx": 1e-4,
    "ax": 1.0,
    "azimuth": 1e-3,
    "angle": 1e-4,
    "tilt_1": 1e-7,
    "load": 1e-2,
    "normal": 1e-2,
    "friction": 1e-2,
    "torque": 1e-4,
    "overlap": 1e-9,
    "friction_power": 1e-3,
    "damping_power": 1e-3,
    "pocket_max": 1e-2,
    "pocket_sum": 1e-2,
    "loss": 1e-3,
    "eccentricity": 1e-3,
}


def _groups(columns):
    at = 0
    while at < len(columns):
        size = 3 if columns[at] in VECTORS else 2 if columns[at] == "tilt_1" else 1
        yield list(range(at, at + size))
        at += size


def finite(figures):
    """Return the columns that contain NaN or infinite values."""
    return [
        f"{name} {column}"
        for name, (columns, table) in figures.items()
        for number, column in enumerate(columns)
        if not np.isfinite(table[..., number]).all()
    ]
