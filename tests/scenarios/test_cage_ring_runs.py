# SPDX-License-Identifier: GPL-2.0-or-later
"""Tests of a one-piece cage in the main deck: its results, its pictures, its parts, its whirl, and
the regular motion that squeeze films give it. The results agree with records, closed forms and
statics."""

import meshio
import numpy as np
import pytest
from host import liggghts, succeed
from raceway.export import paraview
from raceway.pictures.scene import scene as drawn
from raceway.runs.cage import pockets, pockets_around, whirl, whirl_order
from raceway.runs.run import Run
from raceway.theory.operating_point import figures as statics

BALL = 6.3e-3  # m, radius


def test_a_run_tells_slip_orbit_and_pocket_forces(tmp_path):
    """The results for a run of the deck in inputs agree with the samples in the record of this
    run."""
    succeed("inputs/in.cage_ring", out=tmp_path, settle=4, passes=4, cage_play=2e-4)
    run = Run(tmp_path)
    record = run.tables.record
    side, spin = record.fixed("ring_raceway").tolist(), record.read(["ring_spin"])["ring_spin"]
    assert side == [0, 1, 2]
    ball, inner, outer = (
        record.fixed(name)[0] for name in ("ball_diameter", "inner_radius", "outer_radius")
    )
    figures = run.summary()
    rolling = spin[:, 0].mean() / 2 * (1 - ball / (inner + outer))
    assert figures["cage_slip"] == pytest.approx(1 - spin[:, 2].mean() / rolling, rel=1e-9)
    assert 1e-3 < figures["cage_slip"] < 1e-2
    assert 5e-6 < figures["cage_orbit_m"] < 1.5e-4  # at most the play
    force = record.read(["ball_pocket_force"])["ball_pocket_force"]
    assert figures["pocket_force_max_N"] == np.nanmax(force) > 0.1
    assert figures["pocket_force_mean_N"] == pytest.approx(np.nanmean(force))
    assert np.isfinite(force).any(axis=1).sum() > 50
    causes = [figures[f"cage_slip_{cause}"] for cause in ("angle", "groove", "play")]
    assert sum(causes) == pytest.approx(figures["cage_slip"], rel=1e-12)
    assert causes[0] == 0  # the load is radial
    # free rolling by Heathcote at the contacts of the run, weighted by their loads
    contact = record.read(["load", "a"])
    # in the rolling direction, 1/R_x = 1/R_b + 1/r at the inner and 1/R_b - 1/r at the outer
    # raceway
    r_x = 1 / (1 / BALL + np.array([1 / inner, -1 / outer])[:, None])
    r_d = 2 * 6.552e-3 * BALL / (6.552e-3 + BALL)
    both = (contact["load"] > 0).all(axis=1)
    e = 0.120615 * contact["a"] ** 2 / (2 * r_d * r_x)
    load = np.where(both, contact["load"].sum(axis=1), 0)
    gain = (
        (1 - 0.5 * (1 - ball / (inner + outer))) * (load * (e[:, 0] - e[:, 1])).sum() / load.sum()
    )
    assert causes[1] == pytest.approx(-gain, rel=1e-3)
    assert figures["pocket_play_m"] == 2e-4
    found = pockets_around(run.tables, 12)
    assert found["samples"].sum() == np.isfinite(force).sum()
    assert float(found["largest"].max()) == figures["pocket_force_max_N"]
    mean = float((found["mean"] * found["samples"]).sum() / found["samples"].sum())
    assert mean == pytest.approx(figures["pocket_force_mean_N"])
    # the user gave the play; whether the play frees the cage remains open
    ranges = figures["model_ranges"]
    assert "pocket_force_max_N" not in ranges
    arc = np.pi * (inner + outer) * figures["loaded_balls_mean"] / 9
    assert ranges["cage_slip_play"]["low"] == pytest.approx(min(causes[2], -2.2e-4 / arc))
    assert ranges["cage_slip_play"]["high"] == pytest.approx(max(causes[2], 4.4e-4 / arc))


def test_pockets_are_drawn_around_their_balls(tmp_path):
    """In the samples of a run without squeeze films, each ball stays within the play of its own
    spherical pocket, and touches the wall if the pocket exerts a force on it. ParaView and the
    pictures show the same pockets."""
    play, phase = 2e-4, 0.3
    words = dict(cage_play=play, phase=phase, cage_without="film")
    succeed("inputs/in.cage_ring", out=tmp_path, passes=2, **words)
    run = Run(tmp_path).tables
    samples = len(run.record)
    found = pockets(run, 0, samples)
    data = run.record.read(["ball_x", "ball_y", "ball_pocket_force"])
    off = np.hypot(data["ball_x"] - found.centre[..., 0], data["ball_y"] - found.centre[..., 1])
    force = np.nan_to_num(data["ball_pocket_force"])
    assert found.play == play and off.max() < play / 2 + 5e-6
    assert (force > 0).sum() > 50 and off[force > 0].min() > play / 2
    picture = drawn(run, np.arange(samples), factor=1.0)
    assert np.abs(picture.pockets - found.centre).max() < 1e-15
    # pictures magnify displacements in such a way that each pocket stays at its ball
    magnified = drawn(run, np.arange(samples)).pockets
    away = np.abs(np.hypot(magnified[..., 0], magnified[..., 1]) - run.geometry.pitch_radius)
    assert away.max() < 0.2 * run.geometry.ball_radius
    paraview.write(run, tmp_path / "vtk", every=10)
    for number in range(0, samples, 10):
        mesh = meshio.read(tmp_path / f"vtk/pockets_{number // 10:05d}.vtu")
        middle = mesh.points.astype(float).reshape(9, -1, 3).mean(axis=1)
        assert middle == pytest.approx(found.centre[number], abs=1e-8)
        assert mesh.point_data["force"].reshape(9, -1)[:, 0] == pytest.approx(
            data["ball_pocket_force"][number], nan_ok=True
        )


@pytest.mark.parametrize(
    "order, name",
    [
        (1.0, "with the cage"),
        (2.53, "with the inner ring"),
        (0.5, "half the speed of the cage"),
        (-1.7, "backward"),
        (1.7, "forward"),
    ],
)
def test_a_whirl_has_its_speed_and_name(order, name):
    """The centre of the cage moves on a circle with a radius of 20 um, plus some noise, for 10
    turns."""
    turn, noise = 2 * np.pi / 200, np.random.default_rng(1).normal(size=(2, 2000))
    place = 2e-5 * np.exp(1j * order * turn * np.arange(2000)) + 1e-6 * (noise[0] + 1j * noise[1])
    found = whirl_order(place - place.mean(), turn, 2e-4)
    assert found == pytest.approx(order, abs=0.02)
    assert whirl(found, {"cage": 1.0, "inner ring": 2.53}) == name
    assert whirl_order(place[:300], turn, 2e-4) is None
    assert whirl(whirl_order(1e-2 * place, turn, 2e-4), {}) == "none"
    assert whirl(whirl_order(noise[0] + 1j * noise[1], turn, 2e-4), {}) == "irregular"


@pytest.mark.parametrize("part", ["shear", "land", "churning"])
def test_parts_of_a_cage_can_be_left_out(tmp_path, part):
    """If the other parts are omitted, the power loss due to one part equals its closed-form value
    in those samples in which no ball strikes its pocket. The other samples are excluded because the
    damping of the walls is never below 0."""
    out = sorted({"friction", "shear", "film", "land", "churning"} - {part})
    land = dict(cage_guide="outer", cage_land=34e-3, cage_clearance=2e-4, cage_width=2e-3)
    succeed(
        "inputs/in.cage_ring",
        out=tmp_path,
        cage_without="+".join(out),
        cage_play=3e-4,
        settle=0,
        passes=1,
        samples=20,
        oil_level=1,
        **land,
    )
    record = Run(tmp_path).tables.record
    names = ["bearing_cage_power", "ring_spin", "ring_x", "ring_y", "ball_omegaz"]
    found = record.read(names)
    ball, pitch = record.fixed("ball_diameter")[0], 60.6e-3
    cage = found["ring_spin"][:, 2]
    couple = 0.3 * np.pi * 0.04 * (ball / 2) ** 3 * 0.35 * ball / 1.5e-4
    share = np.minimum(np.hypot(found["ring_x"], found["ring_y"])[:, 2] / 2e-4, 0.99)
    radius = pitch / 2 + 0.3 * ball
    # drag on a disc; the oil fraction X follows from the level of the oil bath
    disc = 0.5 * 870 * cage**3 * radius**5 * 3.87 / np.sqrt(870 * cage * radius**2 / 0.04)
    power = dict(
        shear=couple * ((found["ball_omegaz"] - cage[:, None]) ** 2).sum(axis=1),
        land=0.3 * 2 * np.pi * 0.04 * 34e-3**3 * 4e-3 / 2e-4 / np.sqrt(1 - share**2) * cage**2,
        churning=disc * share_below(1.0, pitch / ball),
    )[part]
    assert (found["bearing_cage_power"][:, 0] / power).min() == pytest.approx(1, rel=1e-2)


def film_damping(ball, clearance, oil):
    """Return the damping constant (N s/m) of the film around a centred ball with the radius `ball`
    (m) in a spherical pocket: pi/2 eta R L^3/c^3, with the effective width L of pocket_film.h."""
    band, spheres = (0.7 * ball) ** 3, 16 / np.sqrt(2) * ball**3
    width = band * spheres / (band + spheres + 0.7 * np.sqrt(band * spheres))
    return np.pi / 2 * oil * ball * width / clearance**3


def whirling(tables, mass=4060 * (2 * BALL) ** 2 * 60.6e-3, filled=0.3):
    """Return the place z (complex) of the cage of a run in units of half its play, and the unstable
    root (1/s) of m z'' + C (z' - i w z) = 0 for pockets with the films of a centred cage."""
    place = tables.record.read(["ring_x", "ring_y", "ring_spin"])
    clearance = float(tables.record.fixed("ring_pocket_play")[2]) / 2
    C = 9 * film_damping(BALL, clearance, filled * tables.settings["viscosity_Pa_s"])
    w = place["ring_spin"][1:, 2].mean()
    root = (np.sqrt(C**2 + 4j * mass * w * C) - C) / (2 * mass)
    return (place["ring_x"][1:, 2] + 1j * place["ring_y"][1:, 2]) / clearance, root


@pytest.mark.parametrize(
    "words, passes",
    [
        (dict(rpm=6000), 40),
        (dict(rpm=6000, tolerance=1e-11, cage_tolerance=1e-9), 40),
        (dict(rpm=3000), 60),
        (dict(rpm=12000, cage_filled=1), 50),
        (dict(rpm=6000, cage_mass=0.01), 50),
        (dict(rpm=6000, cage_play=4.5e-4), 50),
        (dict(rpm=6000, integrator="verlet", step=4e-7), 40),
    ],
    ids=["main", "fine", "slow", "fast", "light", "play", "verlet"],
)
def test_a_cage_that_nothing_holds_whirls_as_computed(tmp_path, words, passes):
    """All balls carry the same load, and the cage is subject only to the films in its pockets. They
    resist its motion relative to the pockets, which rotate at the speed w, so that its centre z
    obeys m z'' + C (z' - i w z) = 0, which is unstable at any speed. Its growth and its whirl are
    those of the unstable root."""
    scene = dict(load=1, clearance=-10e-6, lubricant="vg46", temperature=70)
    scene |= dict(models="full", cage="ring", cage_without="friction+shear+churning", **words)
    succeed("inputs/in.6208", out=tmp_path, settle=0, passes=passes, samples=50, **scene)
    tables = Run(tmp_path).tables
    own = {name: words[f"cage_{name}"] for name in ("mass", "filled") if f"cage_{name}" in words}
    z, root = whirling(tables, **own)
    small = (np.abs(z) > 1e-3) & (np.abs(z) < 0.05)
    assert small.sum() > 150 and np.abs(z[0]) < 1e-3
    time = tables.settings["sample_s"] * np.flatnonzero(small)
    log = np.log(np.abs(z)) + 1j * np.unwrap(np.angle(z))
    found = np.polyfit(time, log[small].real, 1)[0] + 1j * np.polyfit(time, log[small].imag, 1)[0]
    assert abs(found - root) < 0.02 * abs(root)


@pytest.mark.parametrize(
    "load, clearance, settle, grows",
    [(1, -1e-5, 52, True), (1, -1e-5, 10, False), (5000, 1e-5, 52, False)],
)
def test_a_whirl_that_grows_is_reported(tmp_path, load, clearance, settle, grows):
    """In a preloaded bearing, the whirl begins at a tiny amplitude and reaches the pockets after
    some 60 ball passes. The change of its mean amplitude between the last two ball passes is in the
    results; a whirl that is still small, and not reported, grows like the unstable root. In a
    bearing with clearance, a radial load holds the cage, whose orbit repeats."""
    scene = dict(load=load, clearance=clearance, rpm=6000, lubricant="vg46", temperature=70)
    scene |= dict(models="full", cage="ring")
    if load == 1:
        scene["cage_without"] = "friction+shear+churning"
    done = succeed("inputs/in.6208", out=tmp_path, settle=settle, passes=4, **scene)
    assert ("The orbit of the cage has not settled: it changes by" in done.text) == grows
    run = Run(tmp_path)
    assert (run.settings["rest_cage_orbit"] > 0.1) == grows
    if load == 1:
        z, root = whirling(run.tables)
        *_, before, last = np.abs(z).reshape(4, -1).mean(axis=1)
        change = run.summary()["settled_cage_orbit"]
        assert change == pytest.approx(last - before, rel=1e-9) and change > 0
        if not grows:
            time = run.settings["sample_s"] * len(z) / 4
            assert change == pytest.approx(last * (1 - np.exp(-root.real * time)), rel=0.02)


@pytest.mark.parametrize("rpm", [47.75, 477.5, 9549])
def test_films_keep_the_motion_of_a_cage_regular(tmp_path, rpm):
    """With squeeze films, balls do not strike their pockets, so the means over four ball passes do
    not depend on rounding or tolerances. They agree within 1e-3 with those of a tenth of the
    tolerance."""
    found = []
    for k, words in enumerate(({}, dict(tolerance=1e-10, relative_tolerance=2e-5))):
        out = tmp_path / str(k)
        succeed("inputs/in.cage_ring", out=out, load=5000, rpm=rpm, passes=4, settle=4, **words)
        found.append(Run(out).summary())
    for name in ("friction_torque_N_m", "cage_speed_rad_s", "q_max_N", "h_c_m"):
        assert found[0][name] == pytest.approx(found[1][name], rel=1e-3), name


def share_below(level, pitch):
    """Return the mean submerged fraction of a ball if the oil level is `level` ball diameters above
    the lowest point of the raceway; `pitch` is the ratio of the pitch radius to the ball radius."""
    turn = np.linspace(0, 2 * np.pi, 3601)[:-1]
    depth = np.clip(pitch * (np.cos(turn) - 1) - 1 + 2 * level, -1, 1)
    return ((1 + depth) ** 2 * (2 - depth) / 4).mean()


def test_a_cage_under_moments_bears_what_statics_estimates(tmp_path):
    """Balls that would run ahead by ten times the play press on the cage with a force that is
    limited by their traction. The largest force also includes impacts. The load is along -y in the
    run and along x in statics."""
    point = dict(load=3500.0, axial=5000.0, rpm=1500.0)
    found = dict(bearing="7208B", moment_x=25, moment_y=15, settle=1, passes=2)
    succeed("inputs/in.cage_ring", out=tmp_path, **found, **point)
    figures = Run(tmp_path).summary()
    estimate = statics("7208B", "mineral", moment=(-15.0, 25.0), **point)
    assert estimate["ball_excursion_m"] > 10 * figures["pocket_play_m"]
    assert 0.5 < figures["pocket_force_max_N"] / estimate["pocket_force_N"] < 2
    assert figures["cage_slip_angle"] < -0.01


def test_an_unknown_part_of_a_cage_is_refused(tmp_path):
    outcome = liggghts("inputs/in.cage_ring", out=tmp_path, cage_without="oil")
    known = "friction shear film land churning"
    assert f"there is no part 'oil' to leave out in 'oil'; there is: {known}" in outcome.error
