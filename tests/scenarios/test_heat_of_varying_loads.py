# SPDX-License-Identifier: GPL-2.0-or-later
"""fix bearing/heat under a load whose period is not a ball pass: the temperatures become steady,
and they do not depend on the phase of the load."""

import numpy as np
import pytest
from host import deck_file, named_bearing, succeed

OMEGA, PERIOD = 300.0, 1.3e-2  # rad/s, s; a ball pass takes 5.8 ms


def steady(folder, phase):
    """Return the last temperatures of the parts (C) and the number of jumps."""
    text = (
        named_bearing("6205")
        + f"""
create_bearing b speed {OMEGA} 0
variable load equal -2000*(1+0.3*sin(2*PI*time/{PERIOD}+{phase}))
fix inner inner bearing/ring mass 0.2 x free y free spin speed {OMEGA} force 0 v_load 0 ramp 2e-3
fix cage cage bearing/cage b
fix move all bearing/implicit
fix heat balls bearing/heat cooling 0.5 warm_change 5 file ${{out}}/heat.txt
run_bearing settle 1 passes 1
"""
    )
    folder.mkdir()
    succeed(deck_file(folder, text), out=folder)
    rows = np.loadtxt(folder / "heat.txt", ndmin=2)
    return rows[-1, 1:4], len(rows)


@pytest.fixture(scope="module")
def found(tmp_path_factory):
    folder = tmp_path_factory.mktemp("varying")
    return [steady(folder / str(k), phase) for k, phase in enumerate((0.0, 1.0, 2.5))]


def test_temperatures_become_steady(found):
    """With losses of single ball passes, a similar run had not ended after 3268 jumps."""
    assert all(count < 100 for _, count in found)


def test_the_phase_does_not_matter(found):
    """The mean losses are accurate to some thousandths, and so are the rises of temperature."""
    first, *others = [temperatures for temperatures, _ in found]
    assert (first > 40).all()  # C; 20 at the start
    for one in others:
        assert one == pytest.approx(first, abs=0.5)
