# SPDX-License-Identifier: GPL-2.0-or-later
"""Every value in the summary equals the value recomputed from the rows of the run."""

import json
import re

import numpy as np
import pytest
import raceway
import synthetic
from raceway import clearance, kinematics, life, makers
from raceway.errors import RunError
from raceway.runs.summary import summary
from raceway.runs.summary_table import table
from raceway.runs.tables import RunTables

# the keys of the table in INTERFACE.md in their order, repeated here because users rely on them
PROMISED = """bearing lubricant host integrator models temperature_C load_N rpm clearance_m
step_s passes
viscosity_Pa_s pressure_viscosity_per_Pa permittivity roughness_m ring_shift_m load_parameter
q_max_N q_inner_max_N q_outer_max_N p_max_inner_Pa p_max_outer_Pa loaded_balls_mean
cage_speed_rad_s entrainment_speed_m_s h_min_m h_c_m lambda capacitance_F capacitance_top_F
capacitance_total_F wall_s simulated_s real_time_factor processor_s evaluations force_x_N
force_y_N force_z_N moment_x_N_m moment_y_N_m shift_z_m tilt_x_rad tilt_y_rad axial_N rpm_inner
rpm_outer
rpm_least rpm_most rpm_top
friction_torque_N_m power_loss_W losses_W torque_skf_N_m torque_palmgren_N_m asperity_share
settled_torque settled_load settled_cage_speed settled_spin_axis_rad
remaining_torque remaining_load remaining_cage_speed remaining_spin_axis_rad
equivalent_load_N dynamic_rating_N life_reference_Mrev life_reference_h
absent warnings model_ranges""".split()
WORDS = ("bearing", "lubricant", "host", "integrator", "models")
TYPES = dict.fromkeys(WORDS, str) | {"warnings": list}
TYPES |= dict.fromkeys(("losses_W", "model_ranges", "absent"), dict)
# the paper's model provides none of these
LOST = {"friction_torque_N_m", "power_loss_W", "losses_W", "asperity_share"}
ABSENT = {*LOST, "capacitance_total_F"}
DRY_NULL = set(
    (
        "temperature_C viscosity_Pa_s pressure_viscosity_per_Pa permittivity roughness_m"
        " h_min_m h_c_m lambda capacitance_F capacitance_top_F torque_skf_N_m"
        " torque_palmgren_N_m model_ranges"
    ).split()
)


def test_promised_keys(folder, dry_folder):
    for where, null in ((folder, ABSENT), (dry_folder, ABSENT | DRY_NULL)):
        figures = summary(RunTables(where))
        assert list(figures) == PROMISED
        assert {key for key, value in figures.items() if value is None} == null
        assert all(isinstance(figures[key], TYPES.get(key, float)) for key in set(PROMISED) - null)
        assert json.loads(json.dumps(figures, allow_nan=False)) == figures


def test_rating_life(folder, lubricated, bearing, small_blocks):
    """The life computed block by block equals the life computed from all contacts of the record at
    once. There is no life if the outer ring rotates or the record has no contacts."""
    figures, run = summary(RunTables(folder)), raceway.open(folder)
    loads = [run.contacts.Q.sel(raceway=side).fillna(0).to_numpy() for side in ("inner", "outer")]
    rated = figures["dynamic_rating_N"]
    life_ = life.reference(bearing, rated, *loads)
    assert rated == 32500 and figures["life_reference_Mrev"] == pytest.approx(life_, rel=1e-12)
    assert figures["equivalent_load_N"] == pytest.approx(rated / life_ ** (1 / 3), rel=1e-12)
    hours = life_ * 1e6 / (60 * lubricated["settings"]["rpm"])
    assert figures["life_reference_h"] == pytest.approx(hours, rel=1e-12)


def test_figures(folder, lubricated, bearing):
    figures, settings = summary(RunTables(folder)), lubricated["settings"]
    for key in (
        "load_N rpm clearance_m step_s passes viscosity_Pa_s pressure_viscosity_per_Pa"
        " permittivity roughness_m wall_s processor_s evaluations simulated_s"
    ).split():
        assert figures[key] == settings[key]
    column = {name: i for i, name in enumerate(synthetic.LUBRICATED)}
    rows = [dict(zip(column, row)) for frame in lubricated["contacts"] for row in frame]
    top = [
        max((row for row in rows if row["raceway"] == side), key=lambda row: row["load"])
        for side in (0, 1)
    ]
    assert figures["q_inner_max_N"] == top[0]["load"]
    assert figures["q_outer_max_N"] == top[1]["load"]
    assert figures["q_max_N"] == max(top[0]["load"], top[1]["load"])
    assert figures["p_max_inner_Pa"] == top[0]["pressure"]
    assert figures["p_max_outer_Pa"] == top[1]["pressure"]
    assert figures["entrainment_speed_m_s"] == top[0]["entrainment"]
    assert (figures["h_min_m"], figures["h_c_m"], figures["lambda"]) == (
        top[0]["h_min"],
        top[0]["h_c"],
        top[0]["lambda"],
    )

    # the load points to -y; the initial state is not part of the measured window
    shift = np.mean([-ring[3] for ring in lubricated["rings"][1:]])
    assert figures["ring_shift_m"] == pytest.approx(shift, rel=1e-12)
    assert figures["load_parameter"] == pytest.approx(
        clearance.load_parameter(1e-5, shift), rel=1e-12
    )
    spin = 477.5 * np.pi / 30
    assert figures["cage_speed_rad_s"] == pytest.approx(
        spin * kinematics.frequencies(bearing).cage, rel=1e-12
    )
    assert figures["real_time_factor"] == pytest.approx(settings["simulated_s"] / 2.5, rel=1e-15)

    singles, loaded = [], 0
    for frame in lubricated["contacts"]:
        side = [{row[0]: row[-1] for row in frame if row[2] == raceway} for raceway in (0, 1)]
        both = side[0].keys() & side[1].keys()
        loaded += len(both)
        singles.append([1 / (1 / side[0][ball] + 1 / side[1][ball]) for ball in both])
    assert figures["loaded_balls_mean"] == loaded / len(singles)
    assert figures["capacitance_F"] == pytest.approx(
        np.mean([sum(one) for one in singles]), rel=1e-12
    )
    assert figures["capacitance_top_F"] == pytest.approx(
        max(max(one) for one in singles), rel=1e-12
    )


def full(folder, data):
    """Return the results of the run `data` with models full, which include the friction torque."""
    own = synthetic.changed(data, models="full")
    return summary(RunTables(synthetic.write(folder, own)))


@pytest.mark.parametrize("models, lost", [("paper", LOST), ("film", LOST), ("mine", set())])
def test_what_a_model_leaves_out(folder, lubricated, models, lost):
    """In the paper's model, friction does not give a friction torque, and the summary states this
    reason instead of a number. For a user-defined model, the summary reports those losses that its
    contacts have."""
    own = synthetic.changed(lubricated, models=models)
    figures = summary(RunTables(synthetic.write(folder, own)))
    assert figures["absent"] == dict.fromkeys(figures["absent"], f"not in models {models}")
    assert set(figures["absent"]) == lost and all(figures[key] is None for key in lost)
    assert (figures["friction_torque_N_m"] is None) == bool(lost)
    said = [text for text in figures["warnings"] if f"not in models {models}" in text]
    assert len(said) == bool(lost)
    text = table(figures)
    assert bool(re.search(rf"of the inner ring +not in models {models}", text)) == bool(lost)
    assert "nan" not in text


def test_friction(folder, lubricated):
    """The shaft torque, the losses by component and the makers' torques equal values computed from
    the contacts."""
    figures = full(folder, lubricated)
    column = synthetic.LUBRICATED.index("load")
    loads = [sum(row[column] for row in frame) for frame in lubricated["contacts"][1:]]
    spin = 477.5 * np.pi / 30
    friction, damping = (part * np.mean(loads) for part in synthetic.LOSS)
    torque = figures["power_loss_W"] / spin
    assert figures["friction_torque_N_m"] == pytest.approx(torque, rel=1e-12)
    losses = figures["losses_W"]
    assert {part for part, loss in losses.items() if loss} == {"slip", "film"}
    assert (losses["slip"], losses["film"]) == pytest.approx((friction, damping), rel=1e-3)
    assert figures["power_loss_W"] == losses["slip"] + losses["film"]
    boundary = makers.Boundary(40, 80, 18, "62", 19e3)
    nu = 1e6 * 0.04 / 870
    radial = np.mean([np.hypot(ring[9], ring[10]) for ring in lubricated["rings"][1:]])
    assert 1e3 * figures["torque_skf_N_m"] == pytest.approx(
        makers.skf(boundary, radial, 0.0, 477.5, nu, level=6.3).total, rel=1e-12
    )
    assert 1e3 * figures["torque_palmgren_N_m"] == pytest.approx(
        sum(makers.palmgren(boundary, radial, 477.5, nu)), rel=1e-12
    )


@pytest.mark.parametrize("speed, has_one", [(0.0, False), (-1e-9, False), (-1e-6, True)])
def test_rings_that_stand_still_have_no_torque(folder, lubricated, speed, has_one):
    rings = [[*ring[:8], speed, *ring[9:]] for ring in lubricated["rings"]]
    figures = full(folder, dict(lubricated, rings=rings))
    assert (figures["friction_torque_N_m"] is not None) == has_one
    assert any("no friction torque" in one for one in figures["warnings"]) != has_one
    assert figures["power_loss_W"] > 0


def test_makers_see_a_load_that_turns(folder, lubricated):
    """The mean vector of a rotating load is almost zero, but the mean of its magnitude is not."""
    turning = forced(
        folder, lubricated, lambda k: (3e3 * np.sin(0.3 * k), 3e3 * np.cos(0.3 * k), 0)
    )
    steady = forced(folder, lubricated, lambda k: (0.0, 3e3, 0.0))
    assert turning["torque_skf_N_m"] == pytest.approx(steady["torque_skf_N_m"], rel=1e-12)


def test_makers_know_no_bearing_of_the_user_s(folder, lubricated):
    own = synthetic.changed(lubricated, bearing="mine", models="full")
    figures = summary(RunTables(synthetic.write(folder, own)))
    assert figures["torque_skf_N_m"] is None and figures["friction_torque_N_m"] > 0


def test_unmoved_ring_has_no_load_parameter(folder, lubricated):
    still = [[*ring[:2], 0.0, 0.0, *ring[4:]] for ring in lubricated["rings"]]
    assert (
        summary(RunTables(synthetic.write(folder, dict(lubricated, rings=still))))["load_parameter"]
        is None
    )


@pytest.mark.parametrize(
    "moved, gap, why",
    [
        (0.4, 1e-5, "the ring has moved by less than half the clearance"),
        (-0.4, 1e-5, "the ring has moved against the load"),
        (-2.0, -1e-5, "the ring has moved against the load"),
        (0.6, 1e-5, None),
        (0.4, -1e-5, None),
    ],
)
def test_load_distribution_factor_of_a_ring_that_is_not_in_equilibrium(
    folder, lubricated, moved, gap, why
):
    """Balls are loaded only if the ring has moved along the load by more than half the clearance.
    In an unsettled run its mean position may be nearer to the centre, where the factor would not be
    positive."""
    rings = [[*ring[:2], 0.0, -moved * abs(gap), *ring[4:]] for ring in lubricated["rings"]]
    changed = synthetic.changed(dict(lubricated, rings=rings), clearance_m=gap)
    figures = summary(RunTables(synthetic.write(folder, changed)))
    assert figures["absent"].get("load_parameter") == why
    if why is None:
        assert figures["load_parameter"] == pytest.approx((1 - gap / abs(gap) / 2 / moved) / 2)
    else:
        assert figures["load_parameter"] is None and not any(
            why in one for one in figures["warnings"]
        )
        assert re.search(f"load distribution factor +{why}", table(figures))


def forced(folder, data, force):
    """Return the results of the run `data` when `force(sample)` (3 numbers) is the force of the
    balls on the inner ring."""
    rings = [[*ring[:9], *force(k), *ring[12:]] for k, ring in enumerate(data["rings"])]
    return summary(RunTables(synthetic.write(folder, dict(data, rings=rings))))


def test_files_are_shown_by_their_names(folder, lubricated):
    own = synthetic.changed(lubricated, bearing="some/where/mine", lubricant="/any/oil")
    figures = summary(RunTables(synthetic.write(folder, own)))
    assert figures["bearing"] == "some/where/mine"
    text = table(figures)
    assert re.search(r"bearing +mine\n +lubricant +oil\n", text) and "where" not in text


def test_the_measured_force_stands_beside_the_set_load(folder, lubricated):
    figures = forced(folder, lubricated, lambda k: (30.0, 4000.0 + k % 2, -100.0))
    assert figures["force_x_N"] == 30.0 and figures["force_z_N"] == -100.0
    assert figures["force_y_N"] == pytest.approx(4000.5, abs=0.02) and figures["load_N"] == 5000.0
    text = table(figures)
    assert re.search(r"force of the balls along y +4 kN", text)
    assert "along x" not in text and re.search(r"along z +-100 N", text)
    assert figures["axial_N"] == 100.0 and re.search(r"axial load +100 N", text)


@pytest.mark.parametrize("axial, measured", [(300.0, -300.0), (0.0, -9.0), (0.0, -300.0)])
def test_axial_load(folder, lubricated, axial, measured):
    """An axial load that the deck records is given instead of the measured force, which is that of
    a support if the ring is held. Palmgren's formula, which is for radial loads, is absent with the
    reason if balls push the ring along its axis."""
    own = synthetic.changed(lubricated, axial_N=axial)
    figures = forced(folder, own, lambda k: (0.0, 5000.0, measured))
    assert figures["axial_N"] == axial and ("axial load" in table(figures)) == bool(axial)
    pushed = measured == -300
    assert (figures["torque_palmgren_N_m"] is None) == pushed
    assert figures["absent"].get("torque_palmgren_N_m") == (
        "the formula is for radial loads" if pushed else None
    )


@pytest.mark.parametrize(
    "force, has_one",
    [
        (lambda k: (0.0, 5000.0, 0.0), True),
        (lambda k: (0.0, 5000.0, 200.0), True),
        (lambda k: (0.0, 5000.0, 300.0), False),  # an axial load
        (lambda k: (5000 * np.sin(0.3 * k), 5000 * np.cos(0.3 * k), 0.0), False),  # a rotating load
        (lambda k: (300 * (-1) ** k, 5000.0, 0.0), True),  # ripple due to passing balls
    ],
)
def test_load_distribution_factor_only_under_a_steady_radial_load(
    folder, lubricated, force, has_one
):
    factor = forced(folder, lubricated, force)["load_parameter"]
    assert (factor is not None) == has_one


def test_a_speed_that_changes_is_shown(folder, lubricated):
    rings = [
        [*ring[:8], ring[8] * (1 + 0.01 * k), *ring[9:]]
        for k, ring in enumerate(lubricated["rings"])
    ]
    figures = summary(RunTables(synthetic.write(folder, dict(lubricated, rings=rings))))
    assert figures["rpm_least"] == pytest.approx(477.5 * 1.01)
    assert figures["rpm_most"] == pytest.approx(477.5 * (1 + 0.01 * (len(rings) - 1)))
    assert "highest" in table(figures)
    assert "highest" not in table(summary(RunTables(synthetic.write(folder, lubricated))))


def test_warnings(folder, lubricated):
    """The warnings defined in core/raceway/validity.h appear when their bounds are exceeded."""
    pressure, ratio = (synthetic.LUBRICATED.index(name) for name in ("pressure", "lambda"))

    def warned(change):
        contacts = [
            [change([*row[:ratio], 2.0, *row[ratio + 1 :]]) for row in frame]
            for frame in lubricated["contacts"]
        ]
        figures = summary(RunTables(synthetic.write(folder, dict(lubricated, contacts=contacts))))
        assert all(text in table(figures) for text in figures["warnings"])
        return [one for one in figures["warnings"] if "not in models" not in one]

    def put(place, value):
        def change(row):
            row[place] = value
            return row

        return change

    assert warned(put(ratio, 1.0)) == [] == warned(put(pressure, 4.2e9))
    (one,) = warned(put(ratio, 0.99))
    assert one.startswith("lambda ratio beside a capacitance is down to 0.99; ")
    (one,) = warned(put(pressure, 4.3e9))
    assert one == "Hertz pressure is up to 4.3 GPa; ISO 76 allows ball bearings 4.2 GPa"


def test_no_contact_at_all(folder, lubricated):
    nothing = [[] for _ in lubricated["contacts"]]
    with pytest.raises(RunError, match="no ball touches the inner raceway"):
        summary(RunTables(synthetic.write(folder, dict(lubricated, contacts=nothing))))


def test_table(folder, dry_folder):
    text = table(summary(RunTables(folder)))
    assert re.search(r"radial load +5 kN  \(as set, or measured\)", text)
    assert re.search(r"minimum film thickness +[0-9.]+ nm  \(eq 6\)", text)
    assert re.search(r"plates +[0-9.]+ pF  \(contact ellipses, eq 12, mean\)", text)
    text = table(summary(RunTables(dry_folder)))
    assert "Film" not in text and "Capacitance" not in text and "None" not in text
