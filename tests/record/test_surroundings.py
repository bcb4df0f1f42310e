# SPDX-License-Identifier: GPL-2.0-or-later
"""Tests of fix bearing/capacitance ... surroundings: the total capacitance of a running bearing in
the record, in the output of the fix and in computes."""

import numpy as np
import pytest
import xarray as xr
from host import BOX, deck_file, liggghts, run, succeed

SHOULDERS = {"inner_shoulder_diameter": 52.6e-3, "outer_shoulder_diameter": 68.6e-3}  # 2.3 mm deep
OIL = {"viscosity": 0.03, "pressure_viscosity": 1.8e-8, "permittivity": 2.2}
COLUMNS = ["separation", "capacitance_outside", "capacitance_total"]
CASE = "tests/implicit/in.case"
MOTION = "x free y free spin speed 50 force 0 -5000 0 ramp 3.0e-3"
BALLS = """
compute balls balls bearing/ball inner_capacitance_total outer_capacitance_total outer_separation
dump caps balls custom {every} {out}/caps.dump id c_balls[1] c_balls[2] c_balls[3] f_cap[6]
dump_modify caps sort id {format} "%d %.17g %.17g %.17g %.17g"
compute ring inner bearing/ring capacitance capacitance_total
dump rings inner local {every} {out}/rings.dump c_ring[1] c_ring[2]
dump_modify rings {format} "%.17g %.17g"
variable s equal step
variable a equal f_cap
variable b equal f_cap[1]
variable c equal f_cap[7]
variable d equal f_cap[8]
fix sums all print {every} "${{s}} ${{a}} ${{b}} ${{c}} ${{d}}" file {out}/sums.txt screen no
"""


def main(folder, **variables):
    """Return the loaded record of a run of the main deck, and a mask of the existing contacts."""
    succeed("inputs/in.6208", out=folder, overwrite="yes", settle=1, passes=1, **variables)
    with xr.open_dataset(folder / "record.nc") as data:
        data = data.load()
    return data, data["load"].values > 0


def series(values):
    """Return the capacitance of both raceways of a ball in series, by sample and ball."""
    return 1 / (1 / values).sum(axis=1)


def azimuth(data):
    """Return the azimuth in rad from the load line, by sample and ball, in (-pi, pi]."""
    return np.angle(1j * (data["ball_x"].values + 1j * data["ball_y"].values))


@pytest.fixture(scope="module")
def loaded(tmp_path_factory):
    """Return records at 3 kN and 1500 rpm without clearance, for each kind of surroundings."""
    folder = tmp_path_factory.mktemp("loaded")
    named = {"load": 3000, "rpm": 1500} | OIL | SHOULDERS
    return {
        word: main(folder / word, surroundings=word, **named)
        for word in ("none", "flooded", "cavitated", "dry")
    }


def test_what_is_not_asked_for_is_as_it_was(loaded):
    plain, flooded = loaded["none"][0], loaded["flooded"][0]
    new = {*COLUMNS, "bearing_capacitance_total", "bearing_capacitance_total_top"}
    assert set(flooded.data_vars) - set(plain.data_vars) == new
    assert "capacitance_commands" not in plain.attrs
    assert "surroundings flooded" in flooded.attrs["capacitance_commands"]
    for name in set(plain.data_vars) - {"checksum"}:
        np.testing.assert_array_equal(plain[name], flooded[name], err_msg=name)


def test_every_ball_has_both_capacitors(loaded):
    data, live = loaded["flooded"]
    assert 0 < (~live).sum() < live.sum()
    for name in COLUMNS:
        assert (data[name].values > 0).all(), name
    plates, outside, total = (data[c].values for c in ("capacitance", *COLUMNS[1:]))
    np.testing.assert_array_equal(plates == 0, ~live)
    np.testing.assert_array_equal(total, plates + outside)
    np.testing.assert_array_equal(np.isnan(data["h_c"].values), ~live)
    # far from contact, the separation is the gap between the rigid surfaces; under light loads, it
    # is the film thickness
    separation = data["separation"].values
    assert separation[~live].max() > 5e-6
    np.testing.assert_array_equal((data["h_c"].values >= separation)[live], True)


def test_t6_the_bearing(loaded):
    """With a ball on the load line, the capacitances in pF are 124 for the plates, about 248 if
    flooded and about 214 if cavitated."""
    known = {"none": 124, "flooded": 248, "cavitated": 214}
    for word, truth in known.items():
        data, _ = loaded[word]
        name = "bearing_capacitance" + ("" if word == "none" else "_total")
        sample = np.abs(azimuth(data)).min(axis=1).argmin()
        assert data[name].values[sample, 0] * 1e12 == pytest.approx(truth, rel=0.005)


def test_t6_light_and_fast(tmp_path):
    """At 400 N and 6000 rpm with 12 um clearance, the capacitances in pF are 9.4 for the plates,
    101 if flooded and 77 if cavitated."""
    named = {"load": 400, "rpm": 6000, "clearance": 12e-6} | OIL | SHOULDERS
    found = {}
    for word in ("flooded", "cavitated"):
        data, _ = main(tmp_path / word, surroundings=word, **named)
        sample = np.abs(azimuth(data)).min(axis=1).argmin()
        found[word] = data["bearing_capacitance_total"].values[sample, 0] * 1e12
        found["plates"] = data["bearing_capacitance"].values[sample, 0] * 1e12
    assert found["plates"] == pytest.approx(9.4, rel=0.03)
    assert found["flooded"] == pytest.approx(101, rel=0.02)
    assert found["cavitated"] == pytest.approx(77, rel=0.02)


@pytest.mark.parametrize("rpm", [477.5, 9549])
@pytest.mark.parametrize("models", ["paper", "film"])
def test_t7_loss_and_return_of_contact(tmp_path, rpm, models):
    """With 12 um clearance, the largest change in a contact's capacitance over a sample in which
    contact is lost or regained falls to about a quarter when the sampling interval is quartered,
    because the capacitance is continuous there. The mean does not change."""
    steps, means = [], []
    for samples in (200, 800):
        data, live = main(
            tmp_path / str(samples),
            clearance=12e-6,
            rpm=rpm,
            samples=samples,
            surroundings="flooded",
            models=models,
        )
        total = data["capacitance_total"].values
        change = live[1:] != live[:-1]
        assert change.any()
        steps.append(np.abs(np.diff(np.log(total), axis=0))[change].max())
        means.append(data["bearing_capacitance_total"].values[:-1].mean())
    assert steps[1] < 0.65**2 * steps[0] and steps[0] < 0.1
    assert means[1] == pytest.approx(means[0], rel=1e-4)


def case(folder, fix, more="", host="liggghts", ranks=1, **variables):
    """Return the folder of a run of in.case with a clearance."""
    folder.mkdir(parents=True)
    every = variables.get("substeps", 1)
    commands = folder / "commands"
    word = "format line" if host == "wheel" else "format"
    commands.write_text(fix + more.format(out=folder, every=every, format=word))
    outcome = run(
        CASE, host=host, ranks=ranks, out=folder, more=commands, inner=MOTION, clearance=20e-6,
        **variables,
    )  # fmt: skip
    assert outcome.code == 0, outcome.text[-3000:]
    return folder


def recorded(folder, options="", **more):
    fix = (
        f"fix cap balls bearing/capacitance 1 permittivity 2.2 {options} surroundings flooded"
        f" file {folder}/sum contacts {folder}/rows\n"
        f"fix rec all bearing/record 1 {folder}/rec {options}\n"
    )
    case(folder, fix, **more)
    with xr.open_dataset(folder / "rec" / "record.nc") as data:
        return data.load()


def test_within_a_step(tmp_path):
    """The record and the fix share one evaluation. Values at the ends of steps do not depend on the
    number of instants, and finer steps give the same values."""
    coarse = recorded(tmp_path / "coarse", "within 4", sample=4e-4, samples=20)
    plain = recorded(tmp_path / "plain", sample=4e-4, samples=20)
    fine = recorded(
        tmp_path / "fine", sample=1e-4, samples=80, control="tolerance 1e-10 largest 2e-5"
    )
    n = coarse.sizes["ball"]
    names = (tmp_path / "coarse" / "rows").read_text().splitlines()[0].split()[1:]
    assert names[-3:] == COLUMNS
    rows = np.loadtxt(tmp_path / "coarse" / "rows").reshape(-1, n, 2, len(names))
    assert len(rows) == coarse.sizes["time"] == 81
    assert (~(coarse["load"].values > 0)).mean() > 0.1
    for k, name in enumerate(names[-3:], start=-3):
        truth = coarse[name].values.swapaxes(1, 2)
        np.testing.assert_allclose(rows[..., k], truth, rtol=1e-11, err_msg=name)
        np.testing.assert_array_equal(coarse[name][::4], plain[name], err_msg=name)
    sums = np.loadtxt(tmp_path / "coarse" / "sum")
    whole = coarse["bearing_capacitance_total"].values[:, 0]
    np.testing.assert_allclose(sums[:, 5], whole, rtol=1e-11)
    np.testing.assert_allclose(
        sums[:, 6], coarse["bearing_capacitance_total_top"].values[:, 0], rtol=1e-11
    )
    exact = fine["bearing_capacitance_total"].values[:, 0]
    assert np.abs(whole / exact - 1)[20:].max() < 5e-3


@pytest.mark.parametrize("integrator", ["implicit", "verlet"])
def test_computes_and_the_fix(tmp_path, integrator):
    """The computes and the fix provide values for each ball, for each ring and in total. Balls
    that do not touch a ring are included."""
    steps = {"implicit": 1, "verlet": 250}[integrator]
    fix = f"fix cap balls bearing/capacitance {steps} permittivity 2.2 surroundings dry\n"
    fix += f"fix rec all bearing/record {steps} {tmp_path}/run/rec\n"
    folder = case(tmp_path / "run", fix, BALLS, integrator=integrator, substeps=steps, samples=8)
    with xr.open_dataset(folder / "rec" / "record.nc") as data:
        data = data.load()
    live = data["load"].values > 0
    assert not live[-1].all() and live[-1].any()
    total = data["capacitance_total"].values
    text = (folder / "caps.dump").read_text().split("ITEM: ATOMS")[1:]
    balls = np.array([[row.split() for row in block.splitlines()[1:10]] for block in text], float)
    np.testing.assert_allclose(balls[..., 1], total[-len(balls) :, 0], rtol=1e-15)
    np.testing.assert_allclose(balls[..., 2], total[-len(balls) :, 1], rtol=1e-15)
    np.testing.assert_allclose(
        balls[..., 3], data["separation"].values[-len(balls) :, 1], rtol=1e-15
    )
    np.testing.assert_allclose(balls[..., 4], series(total)[-len(balls) :], rtol=1e-14)
    whole = data["bearing_capacitance_total"].values[:, 0]
    plates = data["bearing_capacitance"].values[:, 0]
    last = (folder / "rings.dump").read_text().split("ITEM: ENTRIES")[-1].splitlines()[1]
    np.testing.assert_allclose(np.array(last.split(), float), [plates[-1], whole[-1]], rtol=1e-13)
    sums = np.loadtxt(folder / "sums.txt")[-1]
    top = data["bearing_capacitance_total_top"].values[-1, 0]
    np.testing.assert_allclose(sums[1:], [whole[-1], plates[-1], whole[-1], top], rtol=1e-9)


@pytest.mark.parametrize("host, ranks", [("liggghts", 2), ("liggghts", 4), ("lammps", 2)])
def test_same_bits_with_velocity_verlet(tmp_path, host, ranks):
    """Velocities of rings on other ranks lag by half a step, so gaps are evaluated together with
    the contacts."""
    fix = "fix cap balls bearing/capacitance 250 permittivity 2.2 surroundings flooded\n"
    named = {"integrator": "verlet", "substeps": 250, "samples": 8}
    found = [
        case(
            tmp_path / name, fix + f"fix rec all bearing/record 250 {tmp_path / name}/rec\n", **more
        )
        for name, more in (("one", named), ("more", named | {"host": host, "ranks": ranks}))
    ]
    one, more = (xr.load_dataset(folder / "rec" / "record.nc") for folder in found)
    assert not (one["load"].values > 0).all()
    for name in [*COLUMNS, "bearing_capacitance_total"]:
        np.testing.assert_array_equal(one[name], more[name], err_msg=name)


FIX = "fix c balls bearing/capacitance 10 permittivity 2.2 "
MISTAKES = {
    "surroundings": ("surroundings wet", r"none, flooded, dry"),
    "outlet": ("surroundings cavitated 0.5", "outlet is 0.5"),
    "outlet by its word": ("surroundings cavitated outlet 11", "outlet is 11"),
    "outlet above the oil": ("surroundings cavitated 3", "outlet is 3, must be from 1 to the"),
    "permittivity_at": ("permittivity_at edge", "maximum, mean, two_thirds"),
    "roughness": ("roughness gauss", "none, gamma"),
    "shoulder missing": ("shoulders 0.05", "shoulder diameter of the outer ring"),
    "shoulder below": (
        "surroundings dry shoulders 0.0479 0.07",
        "shoulder diameter of the inner ring is 0.0479 m; it must lie between the raceway, 0.048 m,"
        " and the ball's centre, 0.0606 m",
    ),
    "shoulder above": (
        "surroundings dry shoulders 0.052 0.06",
        "shoulder diameter of the outer ring is 0.06 m; it must lie between the raceway, 0.0732 m,"
        " and the ball's centre, 0.0606 m",
    ),
    "no surroundings": (
        "\ncompute x balls bearing/contact separation",
        "compute x bearing/contact: attribute 'separation' needs a fix bearing/capacitance with"
        " 'surroundings'",
    ),
    "no surroundings for a ring": (
        "\ncompute x inner bearing/ring capacitance_total",
        "compute x bearing/ring: value 'capacitance_total' needs a fix bearing/capacitance with"
        " 'surroundings'",
    ),
}
FILM = """
pair_style bearing/ehd lubricant 0.04 22e-9 roughness 1e-7 0
pair_coeff 1 3 inner 24.0e-3 6.552e-3
pair_coeff 1 4 outer 36.6e-3 6.552e-3
pair_coeff 1 2 sphere 210e9 0.3 3.3e9 0.41
create_bearing 1 2 3 4 balls 9 diameter 12.6e-3 cage 8.38e-3 speed 50 0
group balls type 1
group inner type 3
timestep 1e-7
"""


@pytest.mark.parametrize("words, message", MISTAKES.values(), ids=MISTAKES)
def test_mistakes_are_named(words, message, tmp_path):
    deck = deck_file(tmp_path, BOX + FILM + FIX + words + "\nrun 0\n")
    outcome = liggghts(deck, timeout=60)
    assert outcome.code != 0 and message in outcome.error, outcome.text[-2000:]
