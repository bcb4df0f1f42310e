# SPDX-License-Identifier: GPL-2.0-or-later
"""Runs with the models `full` agree with statics in positions, loads, losses, stiffness and steady
temperature. They have one groove per ring, four-point contact or two rows, with and without
unloaded balls. Both runs and statics compute spin with slices."""

import numpy as np
import pytest
import raceway
from host import ROOT, frames, succeed
from raceway import catalogue, contact_friction, friction_torque, inputs, lubrication, steady_heat
from raceway.theory.bearing import DoubleRow
from raceway.theory.cage_drag import CageRing
from raceway.theory.contact_law import FilmInGap
from raceway.theory.operating_point import figures

LAWS = {"spin_law": "slices"}
OIL = {"lubricant": "vg46", "rpm": 1910}
FULL = {"models": "full", "cage": CageRing()}  # as in the main deck
HELD = {"rx": 0.0, "ry": 0.0}
# loads in N and clearances in m: two contacts per ball, four contacts, four contacts under a thrust
CASES = {"thrust": (2000.0, 0.0), "preload": (200.0, -20e-6), "both": (1500.0, -20e-6)}
PHASES = np.arange(4) * np.pi / 18  # positions of the balls over a ball pass


def over_a_pass(lubricant, **point):
    """Return (torque, losses) from statics, averaged over a ball pass."""
    found = [
        figures("6208", lubricant, ROOT / "inputs", phase=phase, **FULL | point) for phase in PHASES
    ]
    parts = {
        part: np.mean([one["losses_W"][part] for one in found]) for part in found[0]["losses_W"]
    }
    return np.mean([one["friction_torque_N_m"] for one in found]), parts


FOUR = {"four_point": np.radians(35)}


def four_point(folder, **words):
    """Return the summary of a run of the main deck under a thrust with four-point contact."""
    common = {"load": 0.001, "four_point": 35, "passes": 1, "spin_law": "slices", "models": "full"}
    succeed("inputs/in.6208", out=folder, **OIL, **common, **words)
    return raceway.open(folder).summary()


@pytest.mark.parametrize("name", CASES)
def test_four_points(tmp_path, name):
    axial, clearance = CASES[name]
    run = four_point(tmp_path, axial=axial, clearance=clearance)
    point = {"axial": axial, "clearance": clearance, "held": HELD, **FULL}
    still = figures("6208", "vg46", ROOT / "inputs", rpm=1910.0, **point, **LAWS, **FOUR)
    for key in ("shift_z_m", "q_inner_max_N", "q_outer_max_N", "h_c_m", "friction_torque_N_m"):
        assert run[key] == pytest.approx(still[key], rel=1e-2), key
    for part in ("rolling", "spin", "hysteresis", "drag"):
        assert run["losses_W"][part] == pytest.approx(still["losses_W"][part], rel=1e-2), part


@pytest.mark.parametrize("rpm", [477.5, 1910.0])
def test_unloaded_balls(tmp_path, rpm):
    """Unloaded balls skid; if they rolled, the rolling loss would be about 5 % higher. With a ring,
    the cage slip would increase the sliding loss by 1 %."""
    point = {"load": 5000.0, "rpm": rpm, "lubricant": "mineral"}
    succeed("inputs/in.6208", out=tmp_path, models="full", cage="chain", passes=1, **point)
    run, (torque, parts) = raceway.open(tmp_path).summary(), over_a_pass(**point, cage=None)
    assert run["friction_torque_N_m"] == pytest.approx(torque, rel=5e-3)
    for part in ("rolling", "slip", "hysteresis", "drag"):
        assert run["losses_W"][part] == pytest.approx(parts[part], rel=1e-2), part


def test_unloaded_balls_of_four_points(tmp_path):
    point = {"load": 2000.0, "rpm": 1910.0, "lubricant": "vg46"}
    words = {"four_point": 35, "passes": 1, "models": "full", **LAWS}
    succeed("inputs/in.6208", out=tmp_path, **words, **point)
    run, (torque, parts) = raceway.open(tmp_path).summary(), over_a_pass(**point, **LAWS, **FOUR)
    assert run["friction_torque_N_m"] == pytest.approx(torque, rel=1e-2)
    for part in ("spin", "hysteresis"):
        assert run["losses_W"][part] == pytest.approx(parts[part], rel=1e-2), part
    assert run["losses_W"]["rolling"] == pytest.approx(parts["rolling"], rel=1.5e-2)


@pytest.mark.parametrize("name", ["thrust", "preload"])
def test_stiffness_of_four_points(tmp_path, name):
    """The displacement changes from one thrust to the next by the same amount as in statics."""
    axial, clearance = CASES[name]
    step = 40.0
    ends = [
        four_point(tmp_path / str(way), axial=axial + way * step, clearance=clearance)
        for way in (-1, 1)
    ]
    found = 2 * step / (ends[1]["shift_z_m"] - ends[0]["shift_z_m"])
    point = {"axial": axial, "clearance": clearance, "models": "full", "held": HELD}
    still = figures("6208", "vg46", ROOT / "inputs", rpm=1910.0, **point, **FOUR)
    assert found == pytest.approx(still["stiffness_z_N_m"], rel=1e-2)


def test_heat_of_four_points(tmp_path):
    """At the steady temperature from statics, a run generates as much heat as the cooling
    removes."""
    cooling = {"conductance": 0.6, "ambient": 20.0}
    point = {"axial": 2000.0, "rpm": 1910.0, "cage": CageRing()}
    steady = steady_heat.figures(
        "6208", "vg46", ROOT / "inputs", **point, **cooling, **LAWS, **FOUR
    )
    warm = steady["temperature_C"]
    run = four_point(tmp_path, axial=2000.0, temperature=warm)
    assert warm > 50
    assert run["power_loss_W"] == pytest.approx(0.6 * (warm - 20), rel=1e-2)


# ---- double row
ROWS = DoubleRow(0.018, 8e-6)
SPIN = 20 * np.pi
COLUMNS = "friction_power rolling_power hysteresis_power spin_power drag_power"
LOADS = {"across": 400.0, "thrust": 300.0, "moment": 4.0}


def double_row(folder, fluid, **changes):
    """Return ((y in m, z in m, tilt in rad), {part: loss in W}), as means over the last 30 ms of a
    run of the deck with the models `full` and changed loads."""
    folder.mkdir(exist_ok=True)
    loads = LOADS | changes
    film = f"{fluid.temperature_viscosity} {fluid.conductivity}"
    path = catalogue.find("bearings", "7208")
    of = contact_friction.surfaces(inputs.bearing(path), inputs.size(path), fluid, SPIN)
    words = (
        f"lubricant {fluid.viscosity} {fluid.pressure_viscosity} roughness 1.0e-7 0"
        f" friction mixed 0.12 0.05 asperity_law clarke slices 1.0e-4 1 rolling {film}"
        f" {of.starvation} rolling_inlet {of.inlet} rolling_hysteresis 0.016"
        f" drag {fluid.density} {of.oil_share} gap 1 gap_film power film_damping branch"
        f" inlet_shear murch {film}"
    )
    text = (ROOT / "docs/decks/in.double_row").read_text()
    old = "lubricant 0.03969 22.57e-9 roughness 1.0e-7 0 friction stribeck 0.12 0.05"
    some = " ".join(f"c_each[{k}]" for k in range(1, 6))
    for before, after in {
        old: words,
        "preload index 5.0e-6": f"preload index {ROWS.preload}",
        "equal -1000*v_on": f"equal -{loads['across']}*v_on",
        "equal 300*v_on": f"equal {loads['thrust']}*v_on",
        "equal 10*v_on": f"equal {loads['moment']}*v_on",
        "run 1000": (
            f"compute each all bearing/contact {COLUMNS}\n"
            f"dump each all local 20 ${{out}}/each.dump {some}\nrun 1600"
        ),
    }.items():
        assert text.count(before) == 1, before
        text = text.replace(before, after)
    folder.joinpath("in.deck").write_text(text)
    succeed(folder / "in.deck", out=folder)
    late = list(frames(folder / "each.dump").values())[-30:]
    powers = np.mean([np.array([r.split() for r in one], float).sum(0) for one in late], axis=0)
    parts = dict(zip(("slip", "rolling", "hysteresis", "spin", "drag"), powers))
    return np.loadtxt(folder / "line.dat")[-30:, 1:].mean(axis=0), parts


def of_statics(fluid):
    """Return the results that `double_row` returns, computed by statics as means over a ball pass,
    and the stiffness along z."""
    path = catalogue.find("bearings", "7208")
    bearing = inputs.bearing(path, double_row=ROWS)
    oil = inputs.Oil(fluid.viscosity, fluid.pressure_viscosity, fluid.permittivity, 1e-7)
    surfaces = contact_friction.surfaces(bearing, inputs.size(path), fluid, SPIN)
    film, places, powers, stiff = FilmInGap(fluid, SPIN), [], [], []
    for phase in np.arange(2) * np.pi / 13:
        options = {"load_azimuth": -np.pi / 2, "moment": (LOADS["moment"], 0.0), "phase": phase}
        loads = LOADS["across"], LOADS["thrust"]
        state, orbit = lubrication.turning(bearing, SPIN, *loads, film=film, **options)
        assert (state.inner.load > 0).all()
        films = lubrication.lubricate(bearing, state, oil, SPIN, factor=film.factor)
        lost = friction_torque.losses(
            bearing, state, films, fluid, SPIN, orbit, surfaces=surfaces, **LAWS
        )
        places.append([*state.shift[1:], state.tilt[0]])
        powers.append([*lost.parts.values()])
        stiff.append(1 / np.linalg.inv(state.stiffness)[2, 2])
    parts = dict(zip(lost.parts, np.mean(powers, axis=0)))
    return np.mean(places, axis=0), parts, np.mean(stiff)


def test_double_row(tmp_path):
    fluid = inputs.fluid(catalogue.find("lubricants", "vg46"))
    place, parts = double_row(tmp_path / "one", fluid)
    want, losses, stiffness = of_statics(fluid)
    assert place == pytest.approx(want, rel=1e-2)
    assert sum(parts.values()) == pytest.approx(sum(losses.values()), rel=1e-2)
    for part in ("rolling", "spin", "hysteresis", "drag"):
        assert parts[part] == pytest.approx(losses[part], rel=1e-2), part
    more, _ = double_row(tmp_path / "more", fluid, thrust=LOADS["thrust"] + 40.0)
    assert 40.0 / (more[1] - place[1]) == pytest.approx(stiffness, rel=1e-2)


def test_heat_of_a_double_row(tmp_path):
    """At the steady temperature from statics, a run generates as much heat as the cooling
    removes."""
    cooling = {"conductance": 0.2, "ambient": 20.0}
    point = {"load": 400.0, "axial": 300.0, "rpm": 600.0, "double_row": ROWS}
    steady = steady_heat.figures("7208", "vg46", ROOT / "inputs", **point, **cooling, **LAWS)
    warm = steady["temperature_C"]
    path = catalogue.find("lubricants", "vg46")
    _, parts = double_row(tmp_path, inputs.fluid(path, warm), moment=0.0)
    assert sum(parts.values()) == pytest.approx(0.2 * (warm - 20), rel=1e-2)
