# SPDX-License-Identifier: GPL-2.0-or-later
"""Statics and the main deck accept and reject the same data files."""

import re

import pytest
from host import BOX, ROOT, deck_file, run
from raceway import cli
from raceway.sweeps.variable_table import rows

REFUSED = [
    ("bearings/6208", {"balls": "8.5"}),
    ("bearings/6208", {"ball_young": "1e7"}),
    ("bearings/6208", {"ball_density": "50"}),
    ("bearings/6208", {"inner_groove": "0.025"}),
    ("bearings/6208", {"outer_groove": "9.5"}),
    ("bearings/7208", {"contact_angle": "61"}),
    ("bearings/7208", {"pitch_diameter": "60"}),
    ("bearings/7208", {"inner_conformity": "3e-3"}),
    ("bearings/7208", {"pocket_play": "-1e-4"}),
    ("bearings/7208", {"bearing_width": "18"}),
    ("bearings/7208", {"outer_shouldr_diameter": "0"}),  # a misspelt name would be ignored
    ("bearings/6208", {"four_point": "4"}),
    ("bearings/7208", {"clearance": "1e-5"}),
    ("bearings/6208", {"clearance": "-6e-4"}),
    ("lubricants/mineral", {"viscosity": "1e3"}),
    ("lubricants/mineral", {"permittivity": "0.5"}),
    ("lubricants/mineral", {"roughness": "1e-4"}),
    ("lubricants/mineral", {"ball_roughness": "nan"}),
]
TAKEN = [
    ("bearings/6208", {"four_point": "0", "inner_shoulder_diameter": "0"}),
    ("bearings/6208", {"clearance": "9e-5"}),
    ("bearings/6208", {"price": "12"}),
    # three letters differ, so this is assumed to be a name that the user chose
    ("bearings/7208", {"inner_conformities": "9"}),
]


def changed(folder, file, values):
    """Return an inputs folder in which some values in `file` are replaced by `values`."""
    kind, name = file.split("/")
    for one in (ROOT / "inputs").iterdir():
        if one.name != kind:
            (folder / one.name).symlink_to(one)
    (folder / kind).mkdir()
    text = (ROOT / "inputs" / file).read_text()
    for key, value in values.items():
        text = f"variable {key} index {value}\n" + re.sub(rf"variable {key} .*\n", "", text)
    (folder / kind / name).write_text(text)


STYLES = {
    "pair_style bearing/hertz young {0} 210e9": "of the ball",
    "pair_style bearing/hertz young 210e9 {0}": "of the ring",
    "pair_style bearing/hertz\npair_coeff 1 2 sphere {0} 0.3 210e9 0.3": "of the first type",
    "pair_style bearing/hertz\npair_coeff 1 2 sphere 210e9 0.3 {0} 0.3": "of the second type",
}


@pytest.mark.parametrize("words", STYLES)
def test_range_of_young(tmp_path, words):
    """Every style accepts values of Young's modulus in the range that is allowed for bearing data,
    and no others."""
    data = {one["name"]: one["range"] for one in rows() if "bearing data" in one["of"]}
    ends = [float(value) for value in data["ball_young"].split()]
    for value, code in ((ends[0], 0), (ends[1], 0), (0.9 * ends[0], 1), (1.1 * ends[1], 1)):
        deck = deck_file(tmp_path, BOX + words.format(value))
        end = run(deck)
        assert bool(end.code) == code, end.text
        wanted = f"Young's modulus {STYLES[words]} (Pa) is {value:g}, must be from 1e+08 to 1e+13"
        assert not code or wanted in end.error


@pytest.mark.parametrize(("file", "values"), REFUSED + TAKEN)
def test_same_data(tmp_path, capsys, file, values):
    inputs, kind = tmp_path / "inputs", file.split("/")[0][:-1]
    inputs.mkdir()
    play = values.get("clearance", "0")
    changed(inputs, file, {name: one for name, one in values.items() if name != "clearance"})
    names = {"bearing": "6208", "lubricant": "mineral", kind: file.split("/")[1]}
    words = {"load": 1000, "rpm": 500, "clearance": play, "inputs": inputs} | names
    options = [word for name, one in words.items() for word in (f"--{name}", str(one))]
    static = cli.main(["static", *options])
    deck = run("inputs/in.6208", out=tmp_path / "run", passes=1, samples=20, settle=0, **words)
    said = capsys.readouterr().err
    if (file, values) in TAKEN:
        assert (static, deck.code) == (0, 0), said + deck.text
        return
    name = next(iter(values))
    assert static == 1 and deck.code != 0, said + deck.text
    plain = name.replace("_groove", "").replace("_", " ")
    for text in (said, deck.error):
        assert name in text or plain in text, text
