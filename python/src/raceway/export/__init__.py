# SPDX-License-Identifier: GPL-2.0-or-later
"""Export runs to files for ParaView (`vtk`) and OVITO (`xyz`), and bearings to rotor dynamics
programs (`ross` and the other functions of `rotor`)."""

from typing import Any


def ross(*arguments: Any, **options: Any) -> dict[str, float | list[float]]:
    """Return the keyword arguments of ROSS's `BearingElement`; see `rotor.ross`."""
    # imported here because the other exports do not need scipy
    from raceway.export import rotor

    return rotor.ross(*arguments, **options)
