# SPDX-License-Identifier: GPL-2.0-or-later
"""Tests of specification files for data sets: the records that they request, and files that are
rejected."""

import numpy as np
import pytest
import yaml
from commands import reply
from raceway.datasets.spec import SpecError, azimuth, read_spec, records
from raceway.sweeps.points import deck_variables
from test_packaging import ROOT

KNOWN = deck_variables(ROOT / "inputs/in.6208")
GOOD = {
    "title": "a set",
    "bearing": 6205,
    "deck": {"settle": 2},
    "flaws": {"none": None, "outer": {"length": [5e-4, 1e-3], "place": [6, 3]}},
    "conditions": {"load": [500, 1000], "rpm": 1797, "seed": [1, 2]},
    "record": {"seconds": 0.5, "rates": [12000, 48000]},
}


def changed(section, **values):
    return {**GOOD, section: {**GOOD[section], **values}}


def read(tmp_path, data):
    path = tmp_path / "spec.yaml"
    path.write_text(data if isinstance(data, str) else yaml.safe_dump(data))
    return read_spec(path, KNOWN)


def test_every_flaw_under_all_conditions(tmp_path):
    found = records(read(tmp_path, GOOD))
    assert len(found) == (1 + 2 * 2) * 2 * 2
    assert [one.number for one in found] == list(range(1, len(found) + 1))
    assert len({one.point.name for one in found}) == len(found)
    last = found[-1]
    assert last.labels["flaw"] == "outer" and last.labels["seed"] == 2
    assert last.point.variables["flaw_outer"] == "notch 0 0.001 0.001 0.0003 5e-05"
    assert last.point.variables["load"] == "1000" and last.point.variables["settle"] == "2"
    # half a second plus the length of the filter, converted to ball passes
    assert int(last.point.variables["passes"]) == np.ceil((0.5 + 128 / 12000) * 107.365)
    assert "flaw_outer" not in found[0].point.variables


def test_a_seed_is_what_it_says(tmp_path):
    one, two = (records(read(tmp_path, GOOD)) for _ in range(2))
    assert one == two
    phases = [float(r.point.variables["phase"]) for r in one]
    assert len(set(phases)) == len(phases) and 0 <= min(phases) < max(phases) < 2 * np.pi / 9


def test_pits_of_balls_need_one_groove(tmp_path):
    four = {**GOOD, "bearing": "QJ208"}
    assert len(records(read(tmp_path, four))) == 20
    with pytest.raises(SpecError, match="QJ208 has four-point contact, which a pit"):
        records(read(tmp_path, {**four, "flaws": {"ball": {"length": 1e-3}}}))


def test_places_on_the_clock():
    assert azimuth(6) == pytest.approx(-np.pi / 2) and azimuth(9) == pytest.approx(-np.pi, abs=1e-9)


def test_waves_of_both_raceways(tmp_path):
    data = {**GOOD, "flaws": {"waviness": {"amplitude": 1e-8}}}
    words = records(read(tmp_path, data))[0].point.variables
    for name in ("flaw_inner", "flaw_outer"):
        parts = words[name].split()
        assert parts[:3] == ["wave", "8", "1e-08"] and parts[4:7] == ["wave", "10", "1e-08"]
    assert words["flaw_inner"] != words["flaw_outer"]


def test_a_pit_of_one_ball(tmp_path):
    data = {**GOOD, "flaws": {"ball": {"length": 7e-4}}}
    found = [one.point.variables for one in records(read(tmp_path, data))]
    for words in found:
        kind, azimuth, *rest = words["flaw_ball"].split()
        assert kind == "pit" and abs(float(azimuth)) <= np.pi
        assert rest == ["0", "0.0007", "0.0007", "0.0003", "5e-05"]
        assert 1 <= int(words["flawed_ball"]) <= 9
    assert len({words["flaw_ball"] for words in found}) == len(found) == 4


def test_examples_can_be_used(capsys):
    for name, count in (("small", 4), ("spalls", 40), ("classes", 40), ("classes_elsewhere", 14)):
        path = ROOT / f"inputs/datasets/{name}.yaml"
        assert len(records(read_spec(path, KNOWN))) == count
        assert f"{count} records" in reply(
            capsys, ["dataset", path, "--deck", ROOT / "inputs/in.6208", "--check"]
        )


@pytest.mark.parametrize(
    "data, says",
    [
        ("- 1", "the file must contain names with values"),
        ("a: [", "cannot read"),
        ({**GOOD, "speed": 1}, "'speed' is unknown"),
        ({k: v for k, v in GOOD.items() if k != "flaws"}, "needs 'flaws'"),
        ({**GOOD, "flaws": {}}, "must name one or more of none, inner"),
        ({**GOOD, "flaws": {"cage": None}}, "'cage' is unknown"),
        ({**GOOD, "flaws": {"inner": None}}, "flaw inner: needs 'length'"),
        (
            {**GOOD, "flaws": {"inner": {"length": 1}}},
            "flaw inner: length is 1, must be from 1e-05 to 0.01",
        ),
        ({**GOOD, "flaws": {"inner": {"length": "wide"}}}, "is wide, must be a number"),
        ({**GOOD, "flaws": {"inner": {"length": 1e-3, "place": 6}}}, "'place' is unknown"),
        ({**GOOD, "flaws": {"inner": {"length": 1e-3, "width": 2}}}, "must be round or full"),
        ({**GOOD, "flaws": {"ball": {"length": 1e-3, "width": "full"}}}, "'width' is unknown"),
        (changed("record", rates=[44100, 48000]), "must divide 4 times the largest"),
        (changed("record", rates=[]), "an empty list"),
        (changed("record", seconds=0), "seconds is 0, must be from 0.001 to 10000"),
        (changed("record", axis="z"), "axis is 'z', must be x or y"),
        (changed("record", noise=-1), "noise (m/s^2) is -1"),
        (changed("conditions", lod=1), "variable 'lod' cannot be set"),
        (changed("conditions", passes=1), "variable 'passes' cannot be set: set it in `record`"),
        (changed("conditions", settle=1), "is in both deck and conditions"),
        (changed("conditions", load=[5, 5]), "a value is repeated"),
        (changed("conditions", load="5 6"), "load is '5 6', must be one word or number"),
        (changed("conditions", rpm="fast"), "rpm is fast, must be a number"),
        (changed("deck", integrator="verlet"), "variable 'integrator' cannot be set"),
    ],
)
def test_mistakes(tmp_path, data, says):
    with pytest.raises(SpecError) as caught:
        read(tmp_path, data)
    assert says in str(caught.value) and "spec.yaml" in str(caught.value)


def test_commands_without_a_folder(capsys):
    assert "give a folder for the data set with --out" in reply(
        capsys,
        ["dataset", ROOT / "inputs/datasets/small.yaml", "--deck", ROOT / "inputs/in.6208"],
        code=2,
    )
