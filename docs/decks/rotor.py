# SPDX-License-Identifier: GPL-2.0-or-later
"""Compute the whirl of a rotor on two 6208s with our beam and, if it is installed, with ROSS.

python docs/decks/rotor.py
"""

import math

import numpy as np
from raceway import beam_motion, shaft, shaft_file, shaft_motion
from raceway.export import rotor
from raceway.units import prefixed

RPM = 3000.0
SPEEDS = (1000.0, RPM)  # speeds in the tables; ROSS does not smooth tables of up to four speeds
OIL = dict(lubricant="vg46", temperature=70.0, models="paper", phases=2)
PIECES = 8  # elements of the shaft between the bearings


def frequencies_here(case, rest, tables):
    """Return natural frequencies (Hz) at RPM of our beam on the bearings' mean 5 x 5 stiffness."""
    z, whole = shaft_motion.nodes(case.shaft, rest)
    springs = np.zeros_like(whole.stiffness)
    for one, table in zip(rest.bearings, tables):
        first = 5 * int(np.argmin(np.abs(z - one.seat.at)))
        at = slice(first, first + 5)
        springs[at, at] += table[SPEEDS.index(RPM)].over.mean.stiffness
    found = beam_motion.frequencies(whole, springs, RPM * math.pi / 30)
    return found[:6] / (2 * math.pi)


def modes_of_ross(case, tables):
    """Return the modes from ROSS at RPM; entries that its elements lack are added to K0 and C0."""
    import ross

    steel, (section,), (disc,) = case.shaft.steel, case.shaft.sections, case.shaft.discs
    material = ross.Material(
        "bearing_steel",
        rho=steel.density,
        E=steel.young,
        G_s=steel.young / (2 * (1 + steel.poisson)),
    )
    pieces = [
        ross.ShaftElement(section.length / PIECES, 0.0, section.diameter, material=material)
        for _ in range(PIECES)
    ]
    discs = [ross.DiskElement(PIECES // 2, disc.mass, disc.transverse, disc.axial)]
    nodes = (0, PIECES)
    bearings = [
        ross.BearingElement(node, **rotor.ross_of(table)) for node, table in zip(nodes, tables)
    ]
    whole = ross.Rotor(pieces, discs, bearings)
    for node, table in zip(nodes, tables):
        rotor.add_rest(whole, node, table[SPEEDS.index(RPM)])
    return whole.run_modal(RPM * math.pi / 30, num_modes=24)


def main():
    case = shaft_file.read("inputs/shafts/rotor")
    rest = shaft.rest(case.shaft, case.seats, case.loads, speed=RPM * math.pi / 30)
    tables = [rotor.at_rest(one, SPEEDS, **OIL) for one in rest.bearings]
    named = rotor.ross_of(tables[0])
    for name, unit in (("kxx", "N/m"), ("kyy", "N/m"), ("kzz", "N/m"), ("cxx", "N s/m")):
        print(name, *(prefixed(value, unit) for value in named[name]), sep="  ")
    print("here", *(f"{one:.2f}" for one in frequencies_here(case, rest, tables)), "Hz", sep="  ")
    try:
        modes = modes_of_ross(case, tables)
    except ImportError as error:
        print(f"ROSS is not run: {error}")
        return
    order = np.argsort(modes.wd)[:6]
    print("ROSS", *(f"{one:.2f}" for one in modes.wd[order] / (2 * math.pi)), "Hz", sep="  ")
    print("logarithmic decrements", *(f"{one:.2g}" for one in modes.log_dec[order]), sep="  ")


if __name__ == "__main__":
    main()
