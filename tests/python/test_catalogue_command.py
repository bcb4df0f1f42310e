# SPDX-License-Identifier: GPL-2.0-or-later
"""Tests of `raceway catalogue`: its listing and the clearance classes."""

import csv
import io

import pytest
from commands import answer, reply
from host import ROOT
from raceway import catalogue, clearance_classes, inputs, listing
from raceway.cli import main
from raceway.inputs import InputError

pytestmark = pytest.mark.usefixtures("in_the_tree")


def found(capsys, *arguments):
    return answer(capsys, ["catalogue", *arguments])


def names(capsys, *arguments):
    return [row["name"] for row in found(capsys, *arguments)]


def test_one_bearing(capsys):
    """The data of the 6205 are those stated by SKF and CWRU, in SI units."""
    [row] = found(capsys, "6205")
    assert row == {
        "name": "6205",
        "title": (ROOT / "inputs/bearings/6205").read_text().splitlines()[0][2:],
        "bore_m": 0.025,
        "outside_m": 0.052,
        "width_m": 0.015,
        "contact_angle_deg": 0.0,
        "dynamic_load_N": 14800.0,
        "static_load_N": 7800.0,
        "fatigue_load_N": 335.0,
        "reference_speed_rpm": 28000.0,
        "limiting_speed_rpm": 18000.0,
        "mass_kg": 0.13,
        "balls": 9,
        "ball_diameter_m": 7.94e-3,
        "pitch_diameter_m": 39.04e-3,
        "balls_from": "CWRU",
        "ratings_from": "SKF",
    }


def test_all_are_listed_by_bore(capsys):
    rows = found(capsys)
    there = {path.name for path in (ROOT / "inputs/bearings").iterdir()} - {"catalogue.csv"}
    assert len(there) == 6 and len({row["name"] for row in rows}) == len(rows) == 122
    assert there < {row["name"] for row in rows}
    bores = [row["bore_m"] for row in rows if row["bore_m"]]
    assert bores == sorted(bores)
    # the file of Harris's 209 states no bore
    assert rows[-1]["name"] == "harris209" and rows[-1]["bore_m"] is None


def test_search(capsys):
    assert names(capsys, "--bore", "40", "--contact-angle", "0") == ["6008", "6208", "6308"]
    assert names(capsys, "--outside", "62", "--series", "6") == ["6305", "6206", "6007"]
    assert names(capsys, "--width", "27") == ["6310", "QJ310"]
    assert names(capsys, "angular", "JTEKT", "--series", "7208") == ["7208A", "7208B", "7208C"]
    assert names(capsys, "FARAH") == ["6208"]
    assert names(capsys, "--series", "63", "--dynamic-load-above", "55300") == ["6310"]
    assert names(capsys, "--series", "62", "--static-load-above", "21500") == ["6209", "6210"]


def test_table_and_csv(capsys):
    heading, line = reply(capsys, "catalogue --bore 40 --series 62").splitlines()
    assert (
        heading.split()
        == (
            "name bore mm outs. mm width mm angle C kN C0 kN Pu kN lim. rpm Z D mm pitch mm balls"
            " ratings"
        ).split()
    )
    assert line.split() == "6208 40 80 18 0 32.5 19 - - 9 12.6 60.6 Farah 2020 SKF".split()
    rows = list(csv.DictReader(io.StringIO(reply(capsys, "catalogue --csv"))))
    assert len(rows) == len(listing.entries()) and rows[0]["bore_m"] == "0.01"


def test_clearances(capsys):
    """According to ISO 5753, the C3 clearance of a bearing with a 40 mm bore is 15 to 33 um.
    Bearings with a contact angle have no clearance class."""
    rows = found(capsys, "--bore", "40", "--clearances")
    deep, angular = (next(r for r in rows if r["name"] == name) for name in ("6208", "7208B"))
    assert (deep["clearance_C3_least_m"], deep["clearance_C3_largest_m"]) == (15e-6, 33e-6)
    assert angular["clearance_C3_least_m"] is None and set(angular) == set(deep)
    assert main(["catalogue", "6208", "7208B", "--clearances"]) == 1
    assert reply(capsys, "catalogue 6208 --clearances").splitlines()[-1] == (
        "6208       C2 1 to 11  CN 6 to 20  C3 15 to 33  C4 28 to 46  C5 40 to 64"
    )


def test_clearance_classes():
    for bore in (6e-3, 6.1e-3, 10e-3, 30e-3, 30.01e-3, 0.12):
        ends = list(clearance_classes.of_bore(bore).values())
        assert len(ends) == (3 if bore == 6e-3 else 5)
        assert all(0 <= least < largest < 2e-4 for least, largest in ends)
        # consecutive classes overlap
        assert all(one[0] <= two[0] <= one[1] < two[1] for one, two in zip(ends, ends[1:]))
    assert clearance_classes.of_bore(30e-3)["C5"] == (30e-6, 53e-6)
    assert clearance_classes.of_bore(30.01e-3)["C5"] == (40e-6, 64e-6)
    for bore in (0.0, -0.01, 0.121):
        with pytest.raises(ValueError, match="known for 0 to 0.12 m"):
            clearance_classes.of_bore(bore)


def test_nothing_fits(capsys):
    assert "no bearing matches" in reply(capsys, "catalogue --bore 41", code=1)
    assert "no bearing matches" in reply(capsys, "catalogue 6208 --bore 50", code=1)
    near = "there is no ball bearing '7310B' in "
    assert near in (said := reply(capsys, "catalogue 7310B", code=1)) and "7210B, " in said
    assert "out of range" in reply(capsys, "catalogue --bore 0", code=2)


def test_own_folder(capsys, tmp_path):
    own = tmp_path / "bearings"
    own.mkdir()
    (own / "mine").write_text((ROOT / "inputs/bearings/6206").read_text())
    assert names(capsys, "--inputs", str(tmp_path)) == ["mine"]
    (own / "broken").write_text("variable balls index 9\n")
    assert "broken has no variable" in reply(capsys, ["catalogue", "--inputs", tmp_path], code=1)
    (own / "broken").write_text((own / "mine").read_text().replace("index 30e-3", "index thirty"))
    assert "thirty" in reply(capsys, ["catalogue", "--inputs", tmp_path], code=1)


@pytest.mark.parametrize("name", ["7205B", "6208"])
def test_file_to_edit(capsys, tmp_path, name):
    """A row or a file of the catalogue is written together with its sources, and existing files are
    not overwritten."""
    path = tmp_path / "new" / "mine"
    assert main(["catalogue", name, "--file", str(path)]) == 0
    known = catalogue.find("bearings", name)
    assert inputs.values(path) == inputs.values(known)
    assert inputs.bearing(path) == inputs.bearing(known)
    text = path.read_text()
    assert ("JTEKT (Koyo) catalogue" if name == "7205B" else "Farah") in text
    data = [line for line in text.splitlines() if line.startswith("variable")]
    for sign in ("index", "#"):
        assert len({line.find(sign) for line in data if sign in line}) == 1  # columns are aligned
    assert "already exists" in reply(capsys, ["catalogue", name, "--file", path], code=1)
    assert main(["catalogue", "--file", str(tmp_path / "other")]) == 1
    assert "there is no ball bearing '7205'" in reply(
        capsys, ["catalogue", "7205", "--file", tmp_path / "other"], code=1
    )


def test_message_of_many_names():
    with pytest.raises(InputError, match=r"there is: .*6209.*, \d+ in all \(raceway catalogue\)"):
        catalogue.find("bearings", "6299")
    with pytest.raises(InputError, match="there is: dry, grease110, "):
        catalogue.find("lubricants", "oil")
    for name in ("", "."):
        with pytest.raises(InputError, match=f"no lubricant '{name}' in .*: dry, grease110, "):
            catalogue.find("lubricants", name)


def test_page_shows_what_is_printed(capsys, tmp_path):
    """The table in docs/catalogue.rst is the table that the command prints. The last Python example
    on the page gives the stated balls, and the one-row table on the page can be read."""
    page = (ROOT / "docs" / "catalogue.rst").read_text()
    command, _, rest = page.partition("$ .venv/bin/raceway ")[2].partition("\n")
    shown = [line[3:] for line in rest.partition("\n\n*Z*")[0].splitlines()]
    assert reply(capsys, command.split()).splitlines() == shown
    example = page.rpartition(".. code-block:: python")[2].partition("\n\nFor several")[0]
    names = {}
    exec("\n".join(line[3:] for line in example.splitlines()), names)
    assert (names["number"], names["diameter"]) == (13, pytest.approx(25.4e-3 * 15 / 32))
    table = page.rpartition(".. code-block:: none\n\n")[2].partition("\n\n*")[0]
    (tmp_path / "own.csv").write_text("\n".join(line[3:] for line in table.splitlines()) + "\n")
    assert inputs.bearing(tmp_path / "mine").ball_diameter == 12.7e-3
    assert inputs.comments(tmp_path / "mine")["basic_dynamic_load"] == "N; C, a calliper"
