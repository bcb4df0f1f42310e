# SPDX-License-Identifier: GPL-2.0-or-later
"""The statics of tests/bench/femto.py, which docs/measured_bearings.rst names."""

import importlib.util

import numpy as np
from host import ROOT


def test_losses_of_the_rig(monkeypatch):
    """The losses leave the bearing through both conductances of the page, in series, at the steady
    temperature of the page."""
    monkeypatch.syspath_prepend(ROOT / "tests/bench")
    spec = importlib.util.spec_from_file_location("femto", ROOT / "tests/bench/femto.py")
    femto = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(femto)
    sides, contacts = femto.losses().at(115.0)
    seat, housing, outer = 0.587, 1.288, 101.0  # W/K, W/K and C after four hours
    assert np.isclose(sum(sides), (outer - femto.AMBIENT) / (1 / seat + 1 / housing), rtol=0.1)
