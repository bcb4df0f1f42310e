# SPDX-License-Identifier: GPL-2.0-or-later
"""Implementation of `raceway shaft` for a ROSS rotor: bending and rigid-body properties."""

import argparse
import math
from typing import Any

import numpy as np

from raceway import bending_file, ross_file
from raceway.commands import output, shaft
from raceway.errors import RacewayError
from raceway.theory import beam_motion, rotor_matrices, shaft_bending
from raceway.units import prefixed


def run(arguments: argparse.Namespace) -> None:
    """Print the properties of the rotor and write the file `arguments.reduced`.

    Raise `RacewayError` if the options or the file cannot be used.
    """
    if arguments.out:
        raise RacewayError("--out draws a shaft at rest on its bearings, but a ROSS rotor has none")
    rotor, bearings = ross_file.read(arguments.file)
    if arguments.reduced:
        kept = arguments.kept or bearings
        if not kept:
            raise RacewayError(
                f"{arguments.file} has no bearings: give their positions with --kept Z ..."
            )
        try:
            found = rotor_matrices.bending(
                rotor,
                kept,
                modes=arguments.modes,
                damping=arguments.damping,
                places=arguments.places,
            )
            bending_file.write(arguments.reduced, found)
        except (ValueError, OSError) as error:
            raise RacewayError(f"{arguments.file}: {error}") from None
    result = figures(rotor, bearings)
    output.show(arguments, result, table)


def figures(rotor: rotor_matrices.Rotor, bearings: list[float]) -> dict[str, Any]:
    """Return the properties of the rotor in SI units, keyed by name.

    They are the positions of nodes and omitted bearings, the rigid-body properties, and the bending
    frequencies of the free rotor in one plane without spin.
    """
    import scipy.linalg

    plane = shaft_bending.planes(len(rotor.z))[0]
    mass, stiffness = (plane.T @ one @ plane for one in (rotor.whole.mass, rotor.whole.stiffness))
    squares = scipy.linalg.eigh(stiffness, mass, eigvals_only=True)[2:]  # without rigid-body modes
    return dict(
        nodes_m=rotor.z.tolist(),
        bearings_m=bearings,
        rigid=shaft.rigid_figures(beam_motion.rigid(rotor.z, rotor.whole)),
        frequencies_Hz=(np.sqrt(squares) / (2 * math.pi)).tolist(),
    )


def table(result: dict[str, Any]) -> str:
    """Return the result of `figures` as text."""
    z = result["nodes_m"]
    left_out = ", ".join(prefixed(one, "m") for one in result["bearings_m"])
    first = ", ".join(prefixed(one, "Hz") for one in result["frequencies_Hz"][: shaft.SHOWN])
    return "\n".join(
        [
            f"Rotor: {len(z)} nodes from {prefixed(z[0], 'm')} to {prefixed(z[-1], 'm')}"
            + (f", without its bearings at {left_out}" if left_out else ""),
            f"Free-free bending frequencies at standstill: {first}",
            shaft.rigid_line(result["rigid"]),
        ]
    )
