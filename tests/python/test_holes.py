# SPDX-License-Identifier: GPL-2.0-or-later
"""Files that were once read without complaint, or that caused a traceback, are now rejected or
cause a warning."""

import json
import re
import struct

import numpy as np
import pytest
import raceway
from commands import reply
from raceway import yaml_file
from raceway.electric.films import of_run
from raceway.errors import RacewayError
from raceway.report.of_sweep import page
from raceway.runs.record import Record
from raceway.sweeps.gather import gather, write_results
from raceway.sweeps.point_run import run_point, state
from raceway.sweeps.points import TableError, deck_variables, read_points
from scipy.io import netcdf_file
from test_run import spoil

# ---- sweeps ------------------------------------------------------------------------------------


@pytest.fixture
def points(tmp_path):
    """Return a sweep of three points: one has finished, one has failed, and one is to be
    damaged."""
    for name, load in (("a", "1"), ("b", "2"), ("c", "3")):
        (tmp_path / name).mkdir()
        (tmp_path / name / "point.yaml").write_text(f"load: '{load}'\n")
    (tmp_path / "a" / "summary.json").write_text(json.dumps({"load_N": 1.0}))
    (tmp_path / "b" / "failed.json").write_text(json.dumps({"message": "why"}))
    return tmp_path


@pytest.mark.parametrize(
    "content", [b"", b"[1, 2]", b"text", b"\xff\xfe", b"? [1]\n: 2", 900 * b"[", b"a: [", None]
)
def test_a_broken_point(points, content):
    path = points / "c" / "point.yaml"
    if content is None:
        path.unlink()
        path.mkdir()
    else:
        path.write_bytes(content)
    table = gather(points).set_index("point")
    assert table.loc["a", "load_N"] == 1.0 and table.loc["b", "message"] == "why"
    assert (
        table.loc["c", "status"] == "failed" and "point.yaml is broken" in table.loc["c", "message"]
    )
    assert state(points / "c", {"load": "3"}) == ("pending", "")


@pytest.mark.parametrize("content", [b"[1]", b"text", b'"text"', b"3", b"\xff", 9000 * b"["])
@pytest.mark.parametrize("name", ["summary.json", "failed.json"])
def test_broken_figures(points, name, content):
    """A point without results is run again."""
    (points / "c" / name).write_bytes(content)
    assert state(points / "c", {"load": "3"}) == ("pending", "")
    assert gather(points).set_index("point").loc["c", "status"] == "pending"


@pytest.mark.parametrize("name", ["point.yaml", "summary.json"])
def test_a_loss_of_power(folder, name):
    """It may leave an empty file. Without results, they are computed again; without variables, the
    point is run again."""
    variables, command = {"load": "5000"}, ["false", "inputs/in.6208"]
    (folder / "point.yaml").write_text(yaml_file.dump(variables))
    assert run_point(folder, variables, command) == ("finished", "")
    (folder / name).write_bytes(b"")
    assert state(folder, variables) == ("pending", "")
    status, _ = run_point(folder, variables, command)
    assert status == ("finished" if name == "summary.json" else "failed")
    assert (folder / "record.nc").exists() == (name == "summary.json")


def test_numbers_in_the_table(tmp_path):
    """A variable of which all values are numbers is sorted by value, and each value is kept. A
    result of the same name replaces what was asked for."""
    asked = ({"rpm": "477.5", "oil": "b"}, {"rpm": "1e3", "oil": "7"}, {"rpm": "60", "load": "5"})
    for k, variables in enumerate(asked):
        (tmp_path / str(k)).mkdir()
        (tmp_path / str(k) / "point.yaml").write_text(yaml_file.dump(variables))
    (tmp_path / "0" / "summary.json").write_text(json.dumps({"rpm": 477.5, "balls": 9}))
    table = gather(tmp_path)
    assert table["rpm"].to_list() == [60.0, 477.5, 1000.0]
    assert table["oil"].fillna("").to_list() == ["", "b", "7"]
    path, counts = write_results(tmp_path)
    assert counts == {"finished": 1, "pending": 2}
    assert path.read_text() == (
        "point,status,message,rpm,oil,load,balls\n2,pending,,60.0,,5,\n0,finished,,477.5,b,,9\n"
        "1,pending,,1000.0,7,,\n"
    )


def test_a_failure_without_a_message(points):
    (points / "c" / "failed.json").write_text("{}")
    assert state(points / "c", {"load": "3"}) == ("pending", "")


@pytest.mark.parametrize("finished", [True, False])
def test_a_point_that_was_stopped_in_its_measurement(folder, finished):
    """The point's run.yaml is complete except for its end. Such a point used to count as finished,
    and its evaluation always failed."""
    (folder / "point.yaml").write_text("load: '5000'\n")
    if not finished:
        spoil(folder, "^step_s: .*\n", "")
    run_point(folder, {"load": "5000"}, ["true", "inputs/in.6208"])
    assert (folder / "log.txt").exists() != finished  # written by the program if it was started


@pytest.fixture
def table(tmp_path):
    path = tmp_path / "t.csv"
    path.write_text("load\n5000\n")
    return path


@pytest.mark.parametrize(
    "words, message",
    [
        (["--program", "'"], 'program "\'": No closing quotation'),
        (["--program", "true", "--out", "{file}"], "cannot make the folder"),
        (["--program", "true", "--slurm", "{job}", "--out", "a\n#SBATCH --x"], "line break"),
    ],
)
def test_the_command_says_why(tmp_path, table, words, message, capsys):
    names = {"file": str(table), "job": str(tmp_path / "job.sh")}
    assert message in reply(
        capsys, ["sweep", table, *(word.format(**names) for word in words)], code=1
    )
    assert not (tmp_path / "job.sh").exists()


def test_many_unknown_columns_in_one_message(tmp_path):
    table = tmp_path / "t.csv"
    table.write_text(",".join(f"x{k}" for k in range(1000)) + "\n1\n")
    with pytest.raises(TableError) as error:
        read_points(table, deck_variables("inputs/in.6208"))
    assert len(str(error.value)) < 3000 and "and 980 more" in str(error.value)
    assert (
        isinstance(error.value, RacewayError)
        and len(re.findall(r"\bclearance\b", str(error.value))) == 1
    )


def test_the_page_of_points_with_other_variables(points):
    """For a sweep as written by `raceway needs`, the page contains a separate table for each kind
    of point, and no nan."""
    (points / "d").mkdir()
    (points / "d" / "point.yaml").write_text("models: full\nwithout: gap+drag\n")
    text = page(points).write(points / "page.html").read_text()
    assert "nan" not in re.sub("<script.*", "", text, flags=re.DOTALL)
    assert "models,without\nfull,gap+drag" in text and "For each of these tables" in text


def test_a_record_that_lost_a_variable(folder):
    """Either the films agree, or a message states how much they differ."""
    path = folder / "record.nc"
    variables, content = Record(folder).variables, path.read_bytes()
    names = [n for n, d in variables.items() if "raceway" not in d and not n.startswith("bearing_")]
    films = of_run(raceway.open(folder))
    refused = 0
    for name in names:
        head = struct.pack(">i", len(name)) + name.encode()
        at = content.rindex(head, 0, 60_000) + 4
        path.write_bytes(content[:at] + b"Q" + content[at + 1 :])
        try:
            found = of_run(raceway.open(folder))
        except RacewayError:
            refused += 1
            continue
        for own in ("time", "capacitance", "from_load_line"):
            np.testing.assert_array_equal(getattr(found, own), getattr(films, own), name)
    assert 10 < refused < len(names)


@pytest.mark.parametrize("name", ["inner_groove", "ball_diameter", "balls", "outer_radius"])
@pytest.mark.parametrize("value", [float("nan"), float("-inf"), 0.0, -1.0, 1e300])
def test_a_record_with_a_bearing_that_is_none(folder, capsys, name, value):
    (folder / "run.yaml").unlink()
    with netcdf_file(folder / "record.nc", "a") as file:
        file.variables[name][:] = value
    assert reply(capsys, ["export", folder, "--format", "vtk"], code=1).startswith("raceway: ")
