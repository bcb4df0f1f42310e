# SPDX-License-Identifier: GPL-2.0-or-later
"""Runs with the models `film` agree with statics that include the film in the gap, which is
implemented independently in Python. Light loads, both integrators and the longest explicit step are
tested."""

import re

import numpy as np
import pytest
from host import BOX, ROOT, deck_file, run, succeed
from raceway import contact_law, inputs
from raceway.runs.summary import summary
from raceway.runs.tables import RunTables
from raceway.theory.bearing import INNER

from scenarios import closed_forms

# bounds on the mean differences, over balls and samples, between the quasi-static run and statics:
# relative to the effect of the film, and relative to the total value
OF_THE_EFFECT, OF_THE_WHOLE = 0.1, 3e-4


def film_of(tables):
    fluid = inputs.fluid(ROOT / "inputs/lubricants" / tables.settings["lubricant"])
    return contact_law.FilmInGap(fluid, closed_forms.shaft_speed(tables.settings))


@pytest.mark.parametrize("rpm, every", [(48, 8), (477.5, 40), (1910, 40), (9549, 40)])
def test_displacement_and_loads(tmp_path, rpm, every):
    """The mean radial displacement agrees with statics, and so do the means over samples of the
    largest and the third largest load."""
    succeed("inputs/in.6208", out=tmp_path, rpm=rpm, models="film", tolerance=1e-8, passes=2)
    tables = RunTables(tmp_path)
    film = film_of(tables)
    found, thin, dry = [], [], []
    for sample in range(0, 401, every):
        rows = tables.contacts[
            (tables.contacts["sample"] == sample) & (tables.contacts["raceway"] == INNER)
        ]
        loads = np.sort(rows["load"].to_numpy())[::-1]
        ring = tables.rings.iloc[sample]
        found.append([-ring["y"], loads[0], loads[2]])
        for list_, law in ((thin, film), (dry, None)):
            state = closed_forms.equilibrium(tables, sample, law)
            loads = np.sort(state.inner.load)[::-1]
            list_.append([-state.shift[1], loads[0], loads[2]])
    found, thin, dry = (np.mean(values, axis=0) for values in (found, thin, dry))
    effect = thin - dry
    allowed = np.maximum(OF_THE_EFFECT * np.abs(effect), OF_THE_WHOLE * np.abs(dry))
    assert np.all(np.abs(found - thin) <= allowed), (found / thin - 1, effect / dry)
    assert effect[0] < 0 and effect[2] > 0  # less displacement, more load on outer balls


@pytest.mark.parametrize("gap_film", ["power", "moes"])
def test_light_load_rolls(tmp_path, gap_film):
    """Under 50 N at 9549 rpm, the centrifugal force lifts the balls off the inner raceway, and they
    are driven by the film in the gap."""
    case = {"load": 50, "rpm": 9549, "models": "film", "gap_film": gap_film}
    succeed("inputs/in.6208", out=tmp_path, settle=4, passes=3, **case)
    tables = RunTables(tmp_path)
    rolling = closed_forms.cage_speed(tables, None)
    found = summary(tables)["cage_speed_rad_s"]
    assert found == pytest.approx(rolling, rel=2e-3)


def test_both_integrators(tmp_path):
    """With the film branch and the film in the gap, velocity Verlet and the implicit integrator
    give the same mean displacement and the same largest load, although one uses friction with a
    tangential spring and the other smoothed Coulomb friction."""
    figures = []
    for integrator in ("verlet", "implicit"):
        case = {"integrator": integrator, "rpm": 5000, "passes": 1, "models": "film"}
        succeed("inputs/in.6208", out=tmp_path / integrator, **case)
        tables = RunTables(tmp_path / integrator)
        figures.append([tables.rings["y"].mean(), tables.contacts["load"].max()])
    assert figures[0] == pytest.approx(figures[1], rel=1e-3)


LONGEST = (
    BOX
    + """
include inputs/bearings/6208
pair_style bearing/ehd lubricant 0.04 22e-9 roughness 1.0e-7 0 gap 1 film_damping branch &
  hysteresis 0 ${friction}
pair_coeff 1 3 inner ${inner_radius} ${inner_groove}
pair_coeff 1 4 outer ${outer_radius} ${outer_groove}
variable omega equal 2*PI*${rpm}/60
create_bearing 1 none 3 4 balls ${balls} diameter ${ball_diameter} density ${ball_density} &
  speed ${omega} 0
group balls type 1
group inner type 3
fix move balls nve/sphere
variable y equal -${shift}*step/4000
fix inner inner bearing/ring y position v_y spin speed ${omega}
fix limit all bearing/timestep 1 exceed ignore
variable load equal c_total[3]
compute total all bearing/total
variable power equal c_total[9]
thermo_style custom step v_load f_limit v_power
timestep 5.0e-7
thermo 4000
run 4000
variable y equal -${shift}
timestep ${step}
thermo 1
run ${steps}
"""
)


FULL = (
    "friction mixed 0.12 0.05 heathcote 1.0e-4 rolling 0.047 0.134 1.0 "
    "rolling_hysteresis 0.01 spin 1 drag 870 0.1"
)


@pytest.fixture
def fixed_step(tmp_path):
    """Return a function that runs a deck with a fixed step and returns (exit code, rows (step
    number, largest load, limit of the step, friction power))."""
    deck = deck_file(tmp_path, LONGEST)

    def rows_of(step, rpm, friction="friction none", steps=400):
        case = {"rpm": rpm, "shift": 3.4e-5, "friction": friction}
        done = run(deck, step=step, steps=steps, **case)
        rows = re.findall(r"^ +(\d+) +(\S+) +(\S+) +(\S+) *$", done.text, re.MULTILINE)
        rows = np.array([[float(v) for v in row] for row in rows])
        return done.code, rows[rows[:, 0] > 4000]

    return rows_of


@pytest.mark.parametrize("rpm", [48, 477.5, 1910])
def test_longest_explicit_step(fixed_step, rpm):
    """With a step of 98 % of the limit of fix bearing/timestep, the loads stay bounded; with 125 %,
    they do not. The ring is held at a position where one ball carries about 2.4 kN; friction and
    other dampers are off."""
    _, rows = fixed_step(1e-7, rpm)
    limit = rows[:, 2].min()
    assert limit > 4e-6  # with the film damper of eq 5, it would be 0.02 to 0.9 us
    code, rows = fixed_step(0.98 * limit, rpm)
    assert code == 0 and rows[:, 1].max() < 2 * rows[0, 1]
    code, rows = fixed_step(1.25 * limit, rpm)
    assert code != 0 or rows[:, 1].max() > 2 * rows[0, 1]


@pytest.mark.parametrize("rpm, within", [(48, 5e-3), (477.5, 1e-3), (1910, 1e-3)])
def test_longest_explicit_step_with_all_parts(fixed_step, rpm, within):
    """At the limit of fix bearing/timestep, the friction loss is the same as with 1 us steps. At
    125 % of the limit, the tangential springs oscillate until they slide. At 48 rpm the initial
    oscillation lasts for some milliseconds, and a longer step makes it larger: during the second 2
    ms the difference is 2e-3 with 4 us steps and 4e-3 at the limit."""

    def power(step):
        code, rows = fixed_step(step, rpm, FULL, int(4e-3 / step))
        assert code == 0
        rows = rows[len(rows) // 2 :]
        return rows[:, 3].mean(), rows[:, 2].min(), rows[:, 1].max()

    found, limit, load = power(1e-6)
    assert limit > 4e-6
    at_limit = power(limit)
    assert at_limit[0] == pytest.approx(found, rel=within)
    assert at_limit[2] < 1.01 * load
    assert power(1.25 * limit)[0] > 1.5 * found
