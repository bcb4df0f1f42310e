# SPDX-License-Identifier: GPL-2.0-or-later
"""The friction torque of one bearing under combined loads, in a settled run and in statics."""

from typing import NamedTuple

import numpy as np
import xarray
from host import ROOT
from raceway.theory.ball_pass import places
from raceway.theory.operating_point import figures

BEARING = """variable balls index {balls}
variable ball_diameter index 8.731e-3
variable pitch_diameter index 65e-3
variable inner_conformity index 0.52
variable outer_conformity index 0.53
variable contact_angle index {angle}
variable bore_diameter index 50e-3
variable outside_diameter index 80e-3
variable bearing_width index 16e-3
"""
OIL = "vg46"


class Scene(NamedTuple):
    """Contact angle (degrees), number of balls, loads (N), moment about y (N m), speed and
    temperature."""

    angle: float
    balls: int
    load: float
    axial: float
    moment: float
    rpm: float
    temperature: float

    def file(self, folder):
        """Write the data of the bearing to `folder` and return the path of the file."""
        path = folder / "bearing"
        path.write_text(BEARING.format(angle=self.angle, balls=self.balls))
        return path

    def variables(self, folder):
        """Return the variables of the main deck for a run in `folder`."""
        words = dict(bearing=self.file(folder), lubricant=OIL, temperature=self.temperature)
        words |= dict(load=self.load, axial=self.axial, moment_y=self.moment, rpm=self.rpm)
        words |= dict(models="full", load_azimuth=0, settle="auto", samples=40)
        return words | dict(passes=2 * self.balls, out=folder / "run")

    def statics(self, folder, cage, phases=4):
        """Return the results of statics at `phases` places of the balls."""
        return [
            figures(
                str(self.file(folder)),
                OIL,
                ROOT / "inputs",
                load=self.load,
                axial=self.axial,
                moment=(0.0, self.moment),
                held={} if self.moment else {"rx": 0.0, "ry": 0.0},
                rpm=self.rpm,
                temperature=self.temperature,
                phase=phase,
                exact_circle=True,
                cage=cage,
            )
            for phase in places(self.balls, phases)
        ]


def run_torque(folder):
    """Return the mean torque (N m) of the run in `folder`, whose inner ring turns forward."""
    with xarray.open_dataset(folder / "run/record.nc") as data:
        return -float(data["ring_torque"].isel(ring=0, time=slice(1, None)).mean())


def mean_torque(found):
    """Return the mean torque (N m) of several results of statics."""
    return np.mean([one["friction_torque_N_m"] for one in found])
