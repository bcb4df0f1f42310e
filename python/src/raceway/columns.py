# SPDX-License-Identifier: GPL-2.0-or-later
"""What the columns of a run's files are: meaning, unit, and what a ball has that touches no
raceway."""

from typing import NamedTuple


class Column(NamedTuple):
    """`unit` in SI, "" for a plain number. `apart`: the value of a contact that is not: 0 for what
    vanishes with the contact, NaN for what it does not have."""

    meaning: str
    unit: str
    apart: float = float("nan")


CONTACT = {
    "ball": Column("atom number of the ball", ""),
    "ring": Column("atom number of the ring", ""),
    "raceway": Column("0 inner, 1 outer", ""),
    "azimuth": Column("azimuth of the ball about the ring's axis, from the lab's x", "rad"),
    "angle": Column("contact angle", "rad"),
    "overlap": Column("elastic approach", "m"),
    "load": Column("elastic contact load", "N", 0.0),
    "normal": Column("normal force with damping", "N", 0.0),
    "stiffness": Column("slope of load over overlap", "N/m", 0.0),
    "damping": Column("normal damping", "N s/m", 0.0),
    "a": Column("semi-axis of the contact ellipse across the groove", "m", 0.0),
    "b": Column("semi-axis of the contact ellipse along rolling", "m", 0.0),
    "pressure": Column("largest Hertz pressure", "Pa", 0.0),
    "entrainment": Column("entrainment speed along rolling", "m/s"),
    "sliding": Column("speed of the ball's surface against the ring's", "m/s"),
    "mu": Column("friction coefficient", ""),
    "friction": Column("tangential force", "N", 0.0),
    "friction_t": Column("tangential force along rolling", "N", 0.0),
    "friction_w": Column("tangential force across rolling", "N", 0.0),
    "friction_power": Column("power lost to the tangential force", "W", 0.0),
    "damping_power": Column("power lost to normal damping", "W", 0.0),
    "h_min": Column("smallest film thickness", "m"),
    "h_c": Column("central film thickness", "m"),
    "lambda": Column("film parameter", ""),
    "regime": Column("0 boundary, 1 mixed, 2 full film", ""),
    "capacitance": Column("capacitance of the Hertz area", "F", 0.0),
}
ATOM = {
    "id": Column("atom number", ""),
    "type": Column("1 ball, 2 cage ball, 3 inner ring, 4 outer ring", ""),
    **{x: Column(f"position along {x}", "m") for x in "xyz"},
    **{f"v{x}": Column(f"velocity along {x}", "m/s") for x in "xyz"},
    **{f"omega{x}": Column(f"spin about {x}", "rad/s") for x in "xyz"},
}
RING = {
    "step": Column("host step", ""),
    "time": Column("time since the start of the measured window", "s"),
    **{x: Column(f"displacement of the inner ring along {x}", "m") for x in "xyz"},
    **{f"v{x}": Column(f"velocity of the inner ring along {x}", "m/s") for x in "xyz"},
    "spin": Column("spin of the inner ring about its axis", "rad/s"),
    **{f"f{x}": Column(f"force of the balls on the inner ring along {x}", "N") for x in "xyz"},
    **{f"m{x}": Column(f"moment of the balls on the inner ring about {x}", "N m") for x in "xyz"},
    "capacitance": Column("capacitance of the bearing", "F"),
    "shift": Column("displacement of the inner ring along the load", "m"),
}
BEARING = {
    "contacts": Column("contacts of balls with raceways", ""),
    "loaded_balls": Column("balls loaded on both raceways", ""),
    "load_inner": Column("largest load on the inner raceway", "N"),
    "load_outer": Column("largest load on the outer raceway", "N"),
    "pressure": Column("largest Hertz pressure", "Pa"),
    "h_min": Column("thinnest film", "m"),
    "lambda": Column("smallest film parameter", ""),
    "capacitance": Column("capacitance of the bearing, without background", "F"),
    "friction_power": Column("power lost to tangential forces", "W"),
    "damping_power": Column("power lost to normal damping", "W"),
}
