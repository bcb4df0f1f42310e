# SPDX-License-Identifier: GPL-2.0-or-later
"""Runs as files for other programs: ParaView (`vtk`) and OVITO (`xyz`). Bearings for
rotor dynamics programs: `ross` and the other functions of `rotor`."""

from typing import Any


def ross(*arguments: Any, **options: Any) -> dict[str, float | list[float]]:
    """`rotor.ross`: keyword arguments of ROSS's `BearingElement`."""
    # the other exports need no scipy
    from raceway.export import rotor

    return rotor.ross(*arguments, **options)
