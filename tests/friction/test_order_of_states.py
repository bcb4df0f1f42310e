# SPDX-License-Identifier: GPL-2.0-or-later
"""The errors in the contact states (film branch and tangential springs) of a rotating bearing
decrease with the order of the implicit step."""

import numpy as np
import raceway
from host import succeed

CASE = dict(
    law=(
        "gap 1 film_damping branch friction mixed 0.12 0.05 heathcote 1.0e-4 rolling 0.047 0.134 1"
        " rolling_hysteresis 0.01 spin 1 drag 870 0.1"
    ),
    start=1000,
    inner="x free y free spin speed 1000 force 0 -3000 0 ramp 3.0e-4",
    clearance=-20e-6,
    samples=40,
    sample=4e-5,
)
NAMES = ("load", "film_force", "friction_t")


def contacts(folder, step):
    control = f"order 2 tolerance 1e-6 largest {step}"
    succeed("tests/friction/in.case", out=folder, control=control, **CASE)
    run = raceway.open(folder)
    return {name: np.nan_to_num(run.contacts[name].to_numpy()) for name in NAMES}


def test_second_order(tmp_path):
    """A load of 3 kN is applied within 0.3 ms at 1000 rad/s. The largest error in any contact is
    determined by comparison with a run at an eighth of the smallest step. Reducing the step to a
    quarter reduces this error to a sixteenth."""
    truth = contacts(tmp_path / "truth", 1.25e-7)
    errors = {name: [] for name in NAMES}
    for step in (4e-6, 2e-6, 1e-6):
        found = contacts(tmp_path / "found", step)
        for name in NAMES:
            off = np.abs(found[name] - truth[name]).max()
            errors[name].append(off / np.abs(truth[name]).max())
    print(errors)
    for coarse, _, fine in errors.values():
        assert 12 < coarse / fine < 21
