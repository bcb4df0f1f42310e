# SPDX-License-Identifier: GPL-2.0-or-later
"""Write the text file that `fix bearing/shaft ... flexible` reads (docs/shaft.rst)."""

from raceway import files
from raceway.files import FilePath
from raceway.theory.shaft_bending import Bending

TITLE = "raceway-shaft 1"
EXPLAINED = """\
# A shaft as a rigid body with elastic modes, the same in both planes along it (docs/shaft.rst).
# inertia: about the axis, and across it through the centre. A mode's coordinate is a length.
# gyroscopic: rows of a symmetric matrix, times the spin; first the rigid tilt, then the modes.
# station: position, then displacement (1) and tilt (rad/m) of each mode.
"""


def write(path: FilePath, shaft: Bending) -> None:
    """Write `shaft` to `path`. Raises `RunError` if the file cannot be written."""
    body = shaft.body
    lines = [
        ("mass", [body.mass]),
        ("centre", [body.centre]),
        ("inertia", [body.axial, body.transverse]),
        ("modes", [len(shaft.mass)]),
        ("modal_mass", shaft.mass),
        ("modal_stiffness", shaft.stiffness),
        ("modal_damping", shaft.damping),
        *(("gyroscopic", row) for row in shaft.gyroscopic),
        *(("station", [z, *shaft.shape[:, k].ravel()]) for k, z in enumerate(shaft.z)),
    ]
    text = "".join(f"{name} {' '.join(f'{one:.17g}' for one in row)}\n" for name, row in lines)
    files.text(path, f"{TITLE}\n{EXPLAINED}units m kg s N rad\n{text}")
