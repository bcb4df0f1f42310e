# SPDX-License-Identifier: GPL-2.0-or-later
"""Runs as files that other programs open: ParaView (`vtk`) and OVITO (`xyz`). Bearings for
programs of rotor dynamics: `ross`, and what else `rotor` has."""

from typing import Any


def ross(*arguments: Any, **options: Any) -> dict[str, float | list[float]]:
    """`rotor.ross`: keyword arguments of ROSS's `BearingElement`."""
    # the other exports need no scipy
    from raceway.export import rotor

    return rotor.ross(*arguments, **options)
