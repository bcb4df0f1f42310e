# SPDX-License-Identifier: GPL-2.0-or-later
"""A flexible shaft on two 6208s, for tests of runs.

The shaft extends along z from 0 to 0.3 m; its bearings are at 0 and 0.2 m.
"""

from typing import NamedTuple

import numpy as np
from raceway import beam, beam_motion, bending_file, shaft_bending
from raceway.theory.beam import Disc, Section

SECTIONS = [Section(0.2, 0.02), Section(0.1, 0.016)]
DISC = Disc(0.12, 3.0, 0.01, 0.006)
PLACES = (0.0, 0.12, 0.2, 0.3)  # m, positions of bearing, disc, bearing and overhung load
KEPT = (0.0, 0.2, 0.3)
PRELOAD = -20e-6  # m, diametral clearance


def beam_of(steel=beam.STEEL):
    z, pieces = beam.divided(SECTIONS, np.linspace(0.0, 0.3, 31))
    return z, beam_motion.matrices(z, pieces, [DISC], steel)


def node(z, place):
    return int(np.argmin(np.abs(z - place)))


def reduced(steel=beam.STEEL, damping=0.0):
    z, whole = beam_of(steel)
    centre = beam_motion.rigid(z, whole).centre
    z, pieces = beam.divided(SECTIONS, [*np.linspace(0.0, 0.3, 31), centre])
    whole = beam_motion.matrices(z, pieces, [DISC], steel)
    stations = sorted(node(z, one) for one in (*PLACES, centre))
    kept = [node(z, one) for one in KEPT]
    return shaft_bending.bending(z, whole, kept, 4, stations, damping)


def modes_file(folder, damping=0.0):
    """Write the file of the shaft to a folder, and return its path."""
    path = folder / "shaft.modes"
    bending_file.write(path, reduced(damping=damping))
    return path


class Support(NamedTuple):
    """A support at the centre of mass that acts equally in both planes."""

    stiffness: float = 0.0  # N/m
    damping: float = 0.0  # N s/m
    tilt_stiffness: float = 0.0  # N m/rad
    tilt_damping: float = 0.0  # N m s/rad

    def words(self, *names):
        """Return the keywords that define the support in a deck; `names` are the names of two
        displacements and two tilts."""
        pairs = [self[:2], self[:2], self[2:], self[2:]]
        return " ".join(f"support {name} {k} {c}" for name, (k, c) in zip(names, pairs))


ACROSS = Support(2e6, 100.0, 1e4, 5.0).words("x", "y", "rx", "ry")
HELD = f"{ACROSS} support z 1e6 10"
LOADED = "load 0.12 -100 -800 0 load 0.3 20 50 30 unbalance 0.12 1e-4 0.4 ramp 1e-3"
