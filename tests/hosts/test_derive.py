# SPDX-License-Identifier: GPL-2.0-or-later
"""bearing_derive: a deck's variables from others have the numbers of Python's laws."""

import math

import pytest
from host import ROOT, run
from raceway import friction_torque, inputs, makers, oil_supply
from raceway.theory import kinematics

BEARINGS, OILS = ROOT / "inputs/bearings", ROOT / "inputs/lubricants"
DATA = "variable inputs index inputs\ninclude ${inputs}/modules/bearing_data\n"


def derived(tmp_path, deck, names, host="liggghts", **values):
    """{name: value} of variables after a deck."""
    path = tmp_path / "in.deck"
    path.write_text(deck + "".join(f'print "IS {name} ${{{name}}}"\n' for name in names))
    done = run(path, host=host, **values)
    assert done.code == 0, done.text[-1000:]
    return dict(line.split(None, 2)[1:] for line in done.text.splitlines() if line[:3] == "IS ")


@pytest.mark.parametrize("host", ["liggghts", "lammps"])
@pytest.mark.parametrize("name", ["7208", "6303"])
def test_usual_data(tmp_path, host, name):
    radii = ("inner_radius", "outer_radius", "inner_groove", "outer_groove")
    ring = ("inner_mass", "inner_inertia", "inner_inertia_t")
    found = derived(tmp_path, DATA, (*radii, *ring), host, bearing=name)
    found = {key: float(value) for key, value in found.items()}
    data, file = inputs.bearing(BEARINGS / name), inputs.values(BEARINGS / name)
    for key in radii:
        assert found[key] == pytest.approx(getattr(data, key), rel=2e-15), key
    bore, width = float(file["bore_diameter"]) / 2, float(file["bearing_width"])
    shoulder = data.inner_radius + 0.18 * data.ball_diameter
    mass = 7800 * math.pi * (shoulder**2 - bore**2) * width
    squares = shoulder**2 + bore**2
    ring = {
        "inner_mass": mass,
        "inner_inertia": mass * squares / 2,
        "inner_inertia_t": mass * (3 * squares + width**2) / 12,
    }
    assert found == pytest.approx(found | ring, rel=1e-14)


def test_what_is_given_outright_stays(tmp_path):
    found = derived(
        tmp_path, DATA, ("inner_mass", "inner_inertia"), bearing="7208", inner_mass="0.250"
    )
    own = derived(tmp_path, DATA, ("inner_mass", "inner_inertia"), bearing="7208")
    assert found["inner_mass"] == "0.250"
    share = 0.25 / float(own["inner_mass"])
    assert float(found["inner_inertia"]) == pytest.approx(
        share * float(own["inner_inertia"]), rel=1e-14
    )


def test_four_point(tmp_path):
    deck = DATA + "variable b_outer_raceway equal ${outer_radius}+0.5*${clearance}\n"
    deck += "bearing_derive four_point\n"
    names = [f"b_{side}_{what}" for side in ("inner", "outer") for what in ("raceway", "arch")]
    found = derived(tmp_path, deck, names, bearing=6208, four_point=35, clearance=4e-6)
    bearing = inputs.bearing(BEARINGS / "6208", four_point=math.radians(35))
    for side, play in (("inner", 0.0), ("outer", 2e-6)):
        radius = getattr(bearing, f"{side}_radius")
        assert float(found[f"b_{side}_raceway"]) == pytest.approx(radius + play, rel=2e-15)
        word, offset = found[f"b_{side}_arch"].split()
        assert word == "gothic_arch"
        assert float(offset) == pytest.approx(max(getattr(bearing.layout, side)[0]), rel=4e-15)
    plain = derived(tmp_path, deck, names[::2], bearing=6208, four_point=0)
    assert plain["b_inner_raceway"] == inputs.values(BEARINGS / "6208")["inner_radius"]


@pytest.mark.parametrize("rpm", [477.5, 9549])
def test_starvation(tmp_path, rpm):
    deck = DATA + "bearing_input inputs/lubricants vg46\nbearing_derive lubrication\n"
    names = ["b_phi_rs", "b_inlet", "b_oil_share"]
    found = derived(tmp_path, deck, names, bearing=6205, temperature=20, rpm=rpm)
    oil = inputs.fluid(OILS / "vg46", 20.0)
    wanted = makers.skf(inputs.boundary(BEARINGS / "6205"), 1.0, 0.0, rpm, oil.kinematic).starvation
    assert wanted < 0.99
    assert float(found["b_phi_rs"]) == pytest.approx(float(wanted), rel=1e-14)
    body = inputs.bearing(BEARINGS / "6205")
    supplied = oil_supply.numbers(oil_supply.Supply(), body, oil.density)
    assert float(found["b_inlet"]) == supplied.inlet == 3
    assert float(found["b_oil_share"]) == pytest.approx(supplied.share, rel=1e-13)


@pytest.mark.parametrize("kind", ["jet", "mist", "grease", "minimal"])
def test_kinds_of_lubrication(tmp_path, kind):
    deck = DATA + "bearing_input inputs/lubricants vg46\nbearing_derive lubrication\n"
    names = ["b_phi_rs", "b_inlet", "b_oil_share"]
    given = dict(bearing="7208B", temperature=40, rpm=3000, lubrication=kind)
    found = derived(tmp_path, deck, names, **given)
    path, oil = BEARINGS / "7208B", inputs.fluid(OILS / "vg46", 40.0)
    supply = oil_supply.Supply(kind)
    wanted = friction_torque.surfaces(
        inputs.bearing(path), inputs.size(path), oil, 100 * math.pi, supply=supply
    )
    assert float(found["b_phi_rs"]) == pytest.approx(wanted.starvation, rel=1e-13)
    assert float(found["b_inlet"]) == wanted.inlet
    assert float(found["b_oil_share"]) == pytest.approx(wanted.oil_share, rel=1e-13)


@pytest.mark.parametrize("name, four_point, ramp", [("7208", 0, 3e-3), ("6208", 35, 0.2)])
def test_ball_pass(tmp_path, name, four_point, ramp):
    """Balls roll without slip. A run settles for 10 ms before that, or for a longer ramp."""
    deck = DATA + "variable b_outer_raceway equal ${outer_radius}+0.5*${clearance}\n"
    deck += "variable b_omega equal 2*PI*${rpm}/60\nbearing_derive ball_pass\n"
    given = dict(bearing=name, four_point=four_point, rpm=1500, settle=2, ramp=ramp)
    found = derived(tmp_path, deck, ("b_pass_time", "b_settle_time"), **given)
    data = inputs.bearing(BEARINGS / name)
    angle = math.radians(four_point) + inputs.nominal_angle(BEARINGS / name)
    passed = 2 * math.pi / (50 * math.pi * kinematics.frequencies(data, angle).outer)
    assert float(found["b_pass_time"]) == pytest.approx(passed, rel=1e-13)
    assert float(found["b_settle_time"]) == pytest.approx(2 * passed + max(0.01, ramp), rel=1e-13)


@pytest.mark.parametrize(
    "samples, step, within, wanted",
    [
        *((200, 0, 0, 10), (210, 0, 0, 10), (205, 0, 0, 5), (202, 0, 0, 2), (203, 0, 0, 1)),
        *((190, 0, 0, 5), (98, 0, 0, 2), (38, 0, 0, 1), (200, 1e-5, 0, 1), (200, 1e-5, 4, 4)),
    ],
)
def test_samples_within(tmp_path, samples, step, within, wanted):
    """As many as divide a pass, with at least twenty steps a pass."""
    given = dict(samples=samples, step=step, within=within)
    found = derived(tmp_path, "bearing_derive samples_within\n", ["b_within"], **given)
    assert found == {"b_within": str(wanted)}


@pytest.mark.parametrize(
    "contact_angle, four_point, axial, seat",
    [
        *((0, 0, 0, "none"), (0, 0, 9, "none"), (40, 0, 0, "plus"), (40, 0, 9, "plus")),
        *((40, 0, -9, "minus"), (0, 35, 0, "none"), (0, 35, 9, "plus"), (0, 35, -9, "minus")),
    ],
)
def test_start(tmp_path, contact_angle, four_point, axial, seat):
    """A thrust decides the side; four points without one are concentric."""
    given = dict(contact_angle=contact_angle, four_point=four_point, axial=axial, rpm=1500)
    given |= {"bearing": "mine", "b_usual": "mine"}
    found = derived(tmp_path, "bearing_derive start\n", ("b_omega", "b_seat"), **given)
    assert found["b_seat"] == seat
    assert float(found["b_omega"]) == pytest.approx(50 * math.pi, rel=1e-14)


@pytest.mark.parametrize("host", ["liggghts", "lammps"])
@pytest.mark.parametrize(
    "azimuth, axial, moment, held",
    [(-math.pi / 2, 0, 0, ("fixed", "fixed")), (2.2, -5, 3, ("free", "free"))],
)
def test_loads(tmp_path, host, azimuth, axial, moment, held):
    given = dict(load=2000, load_azimuth=azimuth, axial=axial, moment_x=0, moment_y=moment)
    names = ("b_load_x", "b_load_y", "b_z", "b_tilt")
    found = derived(tmp_path, "bearing_derive loads\n", names, host, **given)
    force = 2000 * math.cos(azimuth), 2000 * math.sin(azimuth)
    assert [float(found[key]) for key in names[:2]] == pytest.approx(force, rel=1e-14, abs=2e-12)
    assert (found["b_z"], found["b_tilt"]) == held
    if not axial:
        assert found["b_load_x"] == "0"  # along -y nothing is left along x


def test_measurement(tmp_path):
    given = dict(passes=3, samples=40, keep=7, b_within=2, b_every=5, housing="none")
    names = ("b_samples", "b_steps", "b_keep_steps", "b_rows")
    notes = ("b_sampling", "b_housing")
    found = derived(tmp_path, "bearing_derive measurement\n", (*names, *notes), **given)
    assert [int(found[name]) for name in names] == [120, 300, 20, 15]
    assert [found[name] for name in notes] == ["samples=40", "housing=none"]
    own = derived(tmp_path, "bearing_derive measurement\n", names, b_samples=8, **given)
    assert own["b_steps"] == "20"  # an integrator that counts samples itself


@pytest.mark.parametrize(
    "samples, within, says",
    [
        (41, 3, "host steps of the measurement is 13.6667, must be a whole number from 1 to 2e+09"),
        (10**10, 1, "is 1e+10, must be a whole number from 1 to 2e+09 (fewer passes or samples;"),
    ],
)
def test_steps_that_are_no_steps(tmp_path, samples, within, says):
    path = tmp_path / "in.deck"
    path.write_text("bearing_derive measurement\n")
    done = run(path, passes=1, samples=samples, keep=0, b_within=within, b_every=1, housing="none")
    assert done.code != 0 and says in done.error, done.text[-1000:]


@pytest.mark.parametrize(
    "only, wanted", [(0, (1, 1, 1)), (1, (1, 0, 0)), (5, (0, 1, 0)), (6, (0, 0, 1))]
)
def test_kind(tmp_path, only, wanted):
    """Lubricants take turns: bearing 5 of three kinds has the second."""
    names = [f"b_t{k}" for k in (1, 2, 3, 4)]
    for q, built in enumerate(wanted, start=1):
        given = dict(b_q=q, kinds=3, only=only)
        found = derived(tmp_path, "bearing_derive kind\n", (*names, "b_wanted"), **given)
        assert [int(found[name]) for name in names] == [4 * q - 3, 4 * q - 2, 4 * q - 1, 4 * q]
        assert int(found["b_wanted"]) == built


@pytest.mark.parametrize(
    "deck, says",
    [
        (
            "bearing_derive archimedes",
            "law is 'archimedes', must be one of: ball_pass",
        ),
        ("bearing_derive vogel now", "unknown keyword or one argument too many: 'now'"),
        ("bearing_derive four_point", "has no variable four_point that is one number"),
        (
            "variable contact_angle index 30\nvariable bearing index 6208\n"
            "variable b_usual index 7208\nbearing_derive start",
            "contact_angle is 30, must be from 0 to 0 (needs a bearing by its usual data, as 7208)",
        ),
        (
            "variable kinematic_viscosity_100 index 50\nbearing_input inputs/lubricants vg46",
            "bearing_derive: kinematic viscosity 46 mm2/s at 40 C and 50 at 100 C: must fall",
        ),
        (
            "variable oil_density_40 index 8k\nbearing_input inputs/lubricants vg100",
            "bearing_derive: oil_density_40 must be a number, not '8k'",
        ),
        (
            "variable bearing index 7208\nvariable four_point index 35\n"
            + DATA
            + "bearing_derive four_point",
            "contact_angle (degrees) is 40, must be from 0 to 0 (four_point has its own)",
        ),
    ],
)
def test_refused(tmp_path, deck, says):
    path = tmp_path / "in.deck"
    path.write_text(f"variable inputs index inputs\n{deck}\n")
    done = run(path)
    assert done.code != 0 and says in done.error, done.text[-1000:]
