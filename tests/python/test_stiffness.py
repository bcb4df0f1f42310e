# SPDX-License-Identifier: GPL-2.0-or-later
"""The stiffness of a 6208 is compared with values computed independently of this package.

The reference values use the stiffness of each contact at zero angle, whereas the package uses the
stiffness at the actual angle, which differs by up to 5e-4. Printed values are accurate to half a
unit in the last digit.
"""

import numpy as np
import pytest
from bearings import B6208
from raceway import static

X, Y, Z, RX, RY = range(5)
RADIAL = {(X, X): 1.8050e8, (Y, Y): 8.3389e7, (Z, Z): 6.5565e6, (Z, RY): -1.7417e5}
RADIAL |= {(RX, RX): 1406.5, (RY, RY): 4713.4}
COMBINED = {(X, X): 2.9766e8, (Y, Y): 2.9904e8, (Z, Z): 8.1202e7, (X, Z): 1.2203e7}
COMBINED |= {(X, RY): -2.9894e6, (Y, RX): 3.0064e6, (Z, RY): -2.0605e5}
COMBINED |= {(RX, RX): 37952, (RY, RY): 37844}


@pytest.mark.parametrize(
    "loads, clearance, shift, entries",
    [
        ((3000, 0), 10e-6, (30.773e-6, 0.0), RADIAL),
        ((1500, 2500), 20e-6, (5.016e-6, 166.76e-6), COMBINED),
    ],
    ids=["radial", "combined"],
)
def test_matrix(loads, clearance, shift, entries):
    rest = static.equilibrium(B6208, *loads, clearance=clearance)
    assert rest.shift[[0, 2]] == pytest.approx(shift, rel=5e-4, abs=1e-12)
    assert rest.stiffness == pytest.approx(rest.stiffness.T, rel=1e-6, abs=1e-3)
    for (row, column), want in entries.items():
        found = rest.stiffness[row, column]
        # the coupling terms are small differences of large sums
        within = 5e-4 if row == column else 2e-3
        assert found == pytest.approx(want, rel=within), (row, column)


def test_over_a_ball_pass():
    """The smallest, mean and largest values along and perpendicular to the load are found over 16
    phases of a ball pass."""
    phases = np.arange(16) / 16 * 2 * np.pi / 9
    found = np.array(
        [np.diag(static.equilibrium(B6208, 3000.0, phase=p).stiffness)[:2] for p in phases]
    )
    assert found[:, 0].mean() == pytest.approx(1.8183e8, rel=5e-4)
    assert found[:, 0].min() == pytest.approx(1.8141e8, rel=1e-3)
    assert found[:, 0].max() == pytest.approx(1.8219e8, rel=1e-3)
    assert found[:, 1].mean() == pytest.approx(1.2220e8, rel=5e-4)
    assert found[:, 1].min() == pytest.approx(1.1142e8, rel=1e-3)
    assert found[:, 1].max() == pytest.approx(1.3538e8, rel=1e-3)
