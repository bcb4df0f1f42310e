# SPDX-License-Identifier: GPL-2.0-or-later
"""A user's deck with two bearings whose axis is along x, a bearing and an oil that are not in any
table, and deck variables whose names have another meaning in the package."""

import pytest
import raceway
from host import ROOT, box, deck_file, refuses, succeed
from raceway.cli import main

BEARING = {
    **{"balls": 8, "ball_diameter": 6.35e-3, "pitch_diameter": 28.5e-3, "pocket_play": 2e-4},
    **{"inner_conformity": 0.515, "outer_conformity": 0.53},
    **{"bore_diameter": 17e-3, "outside_diameter": 40e-3, "bearing_width": 12e-3},
}
OIL = {"kinematic_viscosity_40": 100, "kinematic_viscosity_100": 11.2, "oil_density_40": 880}
DECK = """variable load index 400
variable speed index 9000
variable oil index DIR/oil
variable out index DIR/run
OWN
variable w equal 2*PI*${speed}/60
bearing a DIR/bearing types 1 2 3 4 clearance 10e-6
bearing z 6208 types 5 6 7 8BOX
pair_style bearing axis x oil ${oil} temperature 50
pair_coeff * * a
pair_coeff * * z
create_bearing a speed $w 0
create_bearing z centre 0.2 0 0 speed $w 0
group inner_a type 3
group inner_z type 7
fix inner_z inner_z bearing/ring spin speed $w
fix inner_a inner_a bearing/ring free loaded spin speed $w load ${load} vars ramp
fix outer outer bearing/ring
group rails_a type 2
group rails_z type 6
fix rails_a rails_a bearing/cage a
fix rails_z rails_z bearing/cage z
fix move all bearing/implicit
fix record all bearing/record pass/20 ${out} overwrite yes
run_bearing settle 0 passes 1
""".replace("BOX", box("-0.05 0.3 -0.1 0.1 -0.1 0.1", 8, "${a_skin} nsq"))


def words(values):
    return "".join(f"variable {name} index {value}\n" for name, value in values.items())


@pytest.fixture
def deck(tmp_path):
    """Return a function that writes the deck with the user's lines `own` and returns the deck's
    path."""
    (tmp_path / "bearing").write_text(words(BEARING))
    (tmp_path / "oil").write_text(words(OIL))

    def write(own="", text=DECK):
        path = deck_file(tmp_path, text.replace("OWN\n", own).replace("DIR", str(tmp_path)))
        return path

    return write


@pytest.mark.parametrize("host", ["liggghts", "lammps", "wheel"])
def test_names_of_another_meaning(deck, tmp_path, host):
    """A variable that is not passed to a command has no range, and bearing data that a deck sets by
    accident are reported."""
    own = {"step": 5, "keep": "left", "time": "noon", "rpm": -30, "load_azimuth": "up"}
    quiet = succeed(deck(words(own)), host=host).text
    assert "by variables of the deck" not in quiet
    assert raceway.open(tmp_path / "run").select(1).bearing is not None
    told = succeed(deck(words({"balls": 7})), host=host).text
    assert "balls 7 instead of 8. Rename a variable that has another meaning" in told
    assert "balls 7 instead of 9. Rename a variable that has another meaning" in told


def test_names_that_a_command_gets(deck):
    for own, name in ((words({"ramp": "up"}), "ramp"), ("variable load delete\n", "load")):
        more = words({"load": -400}) if name == "load" else ""
        says = f"It is variable {name} of the deck: rename it if it has another meaning"
        refuses(deck(own + more), says)
    assert "rename" not in refuses(deck(), "load (N) is -400", load=-400).error


def test_data_in_another_format(deck, tmp_path):
    path = deck()
    (tmp_path / "bearing").write_text("balls: 8\nball_diameter: 6.35e-3\n")
    refuses(path, "a line of data is 'variable NAME index VALUE', not 'balls: 8'")


def test_sweep(deck, tmp_path, monkeypatch):
    """In a sweep, values may be file paths, and the deck need not support resuming."""
    monkeypatch.chdir(ROOT)
    lines = [line for line in DECK.splitlines() if " z" not in line and "_z" not in line]
    path = deck(text="\n".join(lines).replace("create_box 8", "create_box 4") + "\n")
    (tmp_path / "other").mkdir()
    (tmp_path / "other" / "oil").write_text(words({**OIL, "oil_density_40": 900}))
    table = tmp_path / "t.csv"
    table.write_text(f"oil,load\n{tmp_path}/oil,400\n{tmp_path}/other/oil,400\n")
    out = tmp_path / "sweep"
    assert main(["sweep", str(table), "--deck", str(path), "--out", str(out)]) == 0
    folders = sorted(found for found in out.iterdir() if found.is_dir())
    assert len(folders) == 2
    assert all(found.name.startswith("load=400_oil=oil_") for found in folders)
    viscosity = {float(raceway.open(one).tables.record.fixed("viscosity")[0]) for one in folders}
    assert len(viscosity) == 2
