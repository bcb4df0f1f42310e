# SPDX-License-Identifier: GPL-2.0-or-later
"""fix bearing/heat under a load or speed whose period is not a ball pass: the temperatures become
steady, and neither they nor the losses depend on the phase."""

import re

import numpy as np
import pytest
from host import deck_file, named_bearing, succeed

OMEGA = 300.0  # rad/s; a ball pass takes 5.8 ms
PHASES = (0.0, 1.0)


def heated(folder, varies, period, runs, phase=0.0, begin=""):
    """Run a heated bearing under a load or speed that oscillates by 30 %. `begin` replaces the
    commands that create the box. Return the rows of the heat fix and the output of the run."""
    wave = f"(1+0.3*sin(2*PI*time/{period}+{phase}))"
    load, speed = ("v_load", OMEGA) if varies == "load" else (-2000, "v_speed")
    text = (
        named_bearing("6205")
        + f"""
create_bearing b speed {OMEGA} 0
variable load equal -2000*{wave}
variable speed equal {OMEGA}*{wave}
fix inner inner bearing/ring mass 0.2 x free y free spin speed {speed} force 0 {load} 0 ramp 2e-3
fix cage cage bearing/cage b
fix move all bearing/implicit
fix heat balls bearing/heat cooling 0.5 warm_change 5 file ${{out}}/heat.txt
{runs}
"""
    )
    if begin:
        text = re.sub(r"(?m)^boundary.*\n|^region.*\n", "", text)
        text = re.sub(r"(?m)^create_box.*", begin, text)
    folder.mkdir(exist_ok=True)
    text = succeed(deck_file(folder, text), out=folder).text
    return np.loadtxt(folder / "heat.txt", ndmin=2), text


@pytest.fixture(
    scope="module",
    params=[("load", 1.3e-2), ("load", 6.1e-2), ("speed", 1.3e-2)],
    ids=["load", "slow load", "speed"],
)
def found(tmp_path_factory, request):
    folder = tmp_path_factory.mktemp("varying")
    runs = "run_bearing settle 1 passes 1"
    return [heated(folder / str(phase), *request.param, runs, phase)[0] for phase in PHASES]


def test_temperatures_become_steady(found):
    assert all(len(one) < 50 for one in found)


def test_the_phase_does_not_matter(found):
    """The mean losses are accurate to some thousandths, and so are the rises of temperature."""
    first, *others = [table[-1, 1:4] for table in found]
    assert (first > 40).all()  # C; 20 at the start
    for one in others:
        assert one == pytest.approx(first, abs=0.05)


def test_losses_follow_the_temperature(found):
    """The losses of a jump lie between those of its neighbours. Were one span averaged at a crest
    of the wave, they would be 10 % off."""
    for one in found:
        oil, losses = one[:, 5], one[:, 6]
        share = (oil[1:-1] - oil[:-2]) / (oil[2:] - oil[:-2])
        between = losses[:-2] + share * (losses[2:] - losses[:-2])
        assert losses[1:-1] == pytest.approx(between, rel=4e-3)


@pytest.mark.parametrize("step", [700, 980, 1450])
def test_a_restart(tmp_path, step):
    """The speed in the step in which a run is stopped changes neither the time over which losses
    are averaged nor that in which the clearance changes."""
    varies = ("speed", 1.3e-2)
    last = "timestep 4e-4\nrun 2000 upto"
    whole, _ = heated(tmp_path, *varies, f"restart {step} {tmp_path}/restart\n{last}")
    assert len(whole) > 1
    again, _ = heated(tmp_path, *varies, last, begin=f"read_restart {tmp_path}/restart.{step}")
    assert np.array_equal(again, whole)


@pytest.mark.parametrize(("period", "doubt"), [(1.3e-2, False), (2.0, True)])
def test_means_that_do_not_settle_are_reported(tmp_path, period, doubt):
    """A period of 345 ball passes is longer than the longest span."""
    table, text = heated(tmp_path, "load", period, "timestep 4e-4\nrun 2100")
    assert len(table) > 0
    assert ("mean losses of bearing b still change by" in text) == doubt
