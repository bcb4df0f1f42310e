# SPDX-License-Identifier: GPL-2.0-or-later
"""A bearing is defined by its standard data: pitch diameter, conformities, contact angle or
clearance, pocket play, bore and width."""

import contextlib
import io
import json
import math

import numpy as np
import pytest
import raceway
import xarray
from host import ROOT, succeed
from raceway import cli, inputs

SHORT = {"passes": 1, "samples": 50, "dumps": "yes"}
# the play is that of inputs/bearings/6208, whose cage balls have 33 um of play on each side
USUAL = {
    "balls": 9,
    "ball_diameter": 12.6e-3,
    "pitch_diameter": 60.6e-3,
    "inner_conformity": 0.52,
    "outer_conformity": 0.52,
    "pocket_play": 2 * (60.6e-3 * math.sin(math.pi / 18) - 6.3e-3 - 4.19e-3),
    "bore_diameter": 40e-3,
    "bearing_width": 18e-3,
}


def folder(tmp_path, usual):
    """Return an inputs folder that contains the bearing `mine`."""
    own = tmp_path / "inputs"
    own.mkdir()
    (own / "lubricants").symlink_to(ROOT / "inputs" / "lubricants")
    (own / "bearings").mkdir()
    lines = [f"variable {name} index {value!r}" for name, value in usual.items()]
    (own / "bearings" / "mine").write_text("\n".join(lines) + "\n")
    return own


def test_6208_by_its_usual_data(tmp_path):
    own = folder(tmp_path, USUAL)
    scene = {**SHORT, "clearance": 2e-5}
    succeed("inputs/in.6208", out=tmp_path / "as_it_is", **scene)
    succeed(
        "inputs/in.6208",
        **{**scene, "out": tmp_path / "usual", "inputs": own, "bearing": "mine", "inner_mass": 0.2},
    )
    one, other = (raceway.open(tmp_path / name) for name in ("as_it_is", "usual"))
    for name in ("load", "pressure"):
        wanted = one.contacts[name].values
        found = other.contacts[name].values
        np.testing.assert_allclose(found, wanted, rtol=1e-6, atol=1e-6 * np.nanmax(wanted))
    known = inputs.bearing(ROOT / "inputs" / "bearings" / "6208")
    mine = inputs.bearing(own / "bearings" / "mine")
    for name in ("inner_radius", "outer_radius", "inner_groove", "outer_groove", "young"):
        assert getattr(mine, name) == pytest.approx(getattr(known, name), rel=1e-12)


def settings(out):
    return dict(line.split(": ", 1) for line in (out / "run.yaml").read_text().splitlines())


def test_angular_contact(tmp_path):
    """The deck and Python use the same geometry: the contact angle without load is the nominal
    angle, the balls are on the pitch circle, and the loads agree with statics."""
    load = {"load": 2000, "axial": 4000, "lubricant": "vg46"}
    succeed("inputs/in.6208", bearing=7208, out=tmp_path, rpm=300, passes=2, **load)
    said = settings(tmp_path)
    data = inputs.bearing(ROOT / "inputs" / "bearings" / "7208")
    gap = data.inner_groove + data.outer_groove - data.ball_diameter
    play = 2 * (data.outer_radius - data.inner_radius - data.ball_diameter)
    assert math.degrees(math.acos(1 - play / (2 * gap))) == pytest.approx(40.0, rel=1e-12)
    cosine = math.cos(math.radians(40))
    inner = data.inner_radius + data.inner_groove - (data.inner_groove - data.ball_radius) * cosine
    assert 2 * inner == pytest.approx(60e-3, rel=1e-12)
    assert float(said["clearance_m"]) == pytest.approx(play, rel=1e-9)
    loads = raceway.open(tmp_path).contacts["load"]
    static = statics("--load", "2000", "--axial", "4000", "--rpm", "300")
    most = float(loads.sel(raceway="inner").max("ball").mean())
    assert most == pytest.approx(static["q_inner_max_N"], rel=0.01)


def statics(*words):
    """Return the output of `raceway static` for a 7208."""
    said = io.StringIO()
    with contextlib.redirect_stdout(said):
        assert cli.main(["static", "--bearing", "7208", "--json", "--exact-circle", *words]) == 0
    return json.loads(said.getvalue())


def test_deck_with_combined_load(tmp_path):
    """Displacement and tilt in docs/decks/in.combined agree with statics, where x is the deck's -y
    and y is the deck's x. The displacement along z is measured from the position of first
    contact."""
    succeed("docs/decks/in.combined", out=tmp_path)
    static = statics(*"--load 2000 --axial 4000 --moment 0 20 --rpm 1500".split())
    with xarray.open_dataset(tmp_path / "record.nc") as data:
        names = ("ring_y", "ring_z", "ring_tilt_1", "ring_fx", "ring_fy", "ring_fz")
        ring = data.isel(ring=0)[list(names)].mean("time")
        touch = (0.02 + 0.03) * 11.9e-3 * math.sin(math.radians(40))
        assert -float(ring["ring_y"]) == pytest.approx(static["shift_x_m"], rel=0.01)
        assert touch + float(ring["ring_z"]) == pytest.approx(static["shift_z_m"], rel=0.01)
        assert float(ring["ring_tilt_1"]) == pytest.approx(static["tilt_y_rad"], rel=0.01)
        assert float(ring["ring_fx"]) == pytest.approx(0.0, abs=20)
        assert float(ring["ring_fy"]) == pytest.approx(2000, rel=0.01)
        assert float(ring["ring_fz"]) == pytest.approx(-4000, rel=0.01)


def test_deck_with_an_unbalanced_shaft(tmp_path):
    """In docs/decks/in.unbalance, the centre of the shaft orbits once per revolution, and the
    contacts carry the weight and the unbalance."""
    succeed("docs/decks/in.unbalance", out=tmp_path)
    speed, force = 3000 * math.pi / 30, 2e-3 * (3000 * math.pi / 30) ** 2
    with xarray.open_dataset(tmp_path / "record.nc") as data:
        ring = data.isel(ring=0)
        turn = np.exp(-1j * speed * data["time"])
        whirl = complex((2 * ring["ring_x"] * turn).mean())
        met = complex((2 * ring["ring_fx"] * turn).mean())
        # the contact force is opposite in phase to the displacement, so it is force + M w^2 r
        assert abs(met) == pytest.approx(force + 4 * speed**2 * abs(whirl), rel=0.01)
        assert math.cos(np.angle(met) - np.angle(whirl)) < -0.99
    words = "--bearing 6208 --load 500 --clearance -20e-6".split()
    stiff = np.array(statics(*words)["stiffness"])[:2, :2].diagonal().mean()
    assert abs(whirl) == pytest.approx(force / (stiff - 4 * speed**2), rel=0.05)
