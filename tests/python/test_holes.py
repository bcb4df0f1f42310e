# SPDX-License-Identifier: GPL-2.0-or-later
"""Files that were read without a word, or ended with a traceback: each is refused, or warned of."""

import json

import pytest
import raceway
from raceway.cli import main
from raceway.errors import RacewayError, RunError, RunWarning
from raceway.runs.tables import RunTables
from raceway.sweeps.gather import gather
from raceway.sweeps.point_run import run_point, state
from raceway.sweeps.points import TableError, deck_variables, read_points
from test_run import spoil

DUMPS = ("contacts", "balls")
HEAD = "ITEM: TIMESTEP\n"


def frames(path):
    return [HEAD + part for part in path.read_text().split(HEAD)[1:]]


def every_reading(folder, name):
    """The table as a whole and in blocks."""
    yield lambda: getattr(RunTables(folder), name)
    yield lambda: list(RunTables(folder).blocks(name))


# ---- steps and counts --------------------------------------------------------------------------


@pytest.mark.parametrize("name", DUMPS)
@pytest.mark.parametrize(
    "change",
    {
        "twice": lambda f: f[:9] + f[8:],
        "missing": lambda f: f[:9] + f[10:],
        "backwards": lambda f: f[::-1],
        "without the first": lambda f: f[1:],
        "two swapped": lambda f: f[:5] + [f[6], f[5]] + f[7:],
    }.items(),
    ids=lambda change: change[0],
)
def test_frames_out_of_step(folder, name, change):
    path = folder / f"{name}.dump"
    path.write_text("".join(change[1](frames(path))))
    for read in every_reading(folder, name):
        with pytest.raises(RunError, match=rf"{name}.dump: (after the sample|the first sample)"):
            read()


@pytest.mark.parametrize("name", DUMPS)
@pytest.mark.parametrize(
    "change", [lambda f: f[:-1], lambda f: f + [f[-1].replace("4800", "4900", 1)]]
)
def test_frames_short_of_a_finished_run(folder, name, change):
    path = folder / f"{name}.dump"
    path.write_text("".join(change(frames(path))))
    for read in every_reading(folder, name):
        with pytest.warns(RunWarning, match="samples, a finished run of 2 passes has 49"):
            read()


@pytest.mark.parametrize(
    "change",
    {
        "twice": lambda rows: rows[:9] + rows[8:],
        "missing": lambda rows: rows[:9] + rows[10:],
        "backwards": lambda rows: rows[::-1],
        "other steps": lambda rows: [
            f"{7 * k} {row.split(' ', 1)[1]}" for k, row in enumerate(rows)
        ],
        "endless": lambda rows: [*rows[:-1], "4800 inf " + rows[-1].split(" ", 2)[2]],
    }.items(),
    ids=lambda change: change[0],
)
def test_rows_out_of_step(folder, change):
    path = folder / "rings.dat"
    head, *rows = path.read_text().splitlines(keepends=True)
    path.write_text(head + "".join(change[1](rows)))
    with pytest.raises(
        RunError, match=r"rings.dat:? (after the sample|has not the steps|holds times)"
    ):
        RunTables(folder).rings


def test_a_table_short_of_a_finished_run(folder):
    path = folder / "rings.dat"
    path.write_text("".join(path.read_text().splitlines(keepends=True)[:-1]))
    with pytest.warns(RunWarning, match="rings.dat ends with sample 47, a finished run with 48"):
        RunTables(folder).rings


@pytest.mark.parametrize("row", [9, 12, 22], ids=["ring", "cage ball", "ball"])
def test_atoms_that_changed_places_over_samples(folder, row):
    path = folder / "balls.dump"
    parts = [part.split("\n") for part in frames(path)]
    parts[3][row], parts[7][row + 1] = parts[7][row + 1], parts[3][row]
    path.write_text("".join("\n".join(part) for part in parts))
    run = raceway.open(folder)
    with pytest.raises(RunError, match="not every sample has the same atoms"):
        assert run.balls and run.cage and run.rings


def test_a_whole_run_is_read_in_silence(folder):
    run = raceway.open(folder)
    assert len(run.contacts.time) == len(run.balls.time) == len(run.rings.time) == 49


# ---- run.yaml ----------------------------------------------------------------------------------

OUT_OF_DOMAIN = {
    "permittivity": -2,
    "balls": -9,
    "passes": -3,
    "viscosity_Pa_s": -1,
    "pressure_viscosity_per_Pa": 0,
    "roughness_m": -1e-7,
    "ball_diameter_m": 0,
    "inner_groove_m": -1,
    "rpm": 0,
    "load_N": -1,
    "inner_ring": 0.5,
    "simulated_s": 0,
    "step_s": -1,
}


@pytest.mark.parametrize("key", OUT_OF_DOMAIN)
def test_numbers_out_of_domain(folder, key):
    spoil(folder, f"^{key}: .*$", f"{key}: {OUT_OF_DOMAIN[key]}")
    with pytest.raises(RunError, match=rf"run.yaml: {key} = {OUT_OF_DOMAIN[key]} must be"):
        RunTables(folder)


def test_a_key_twice(folder):
    spoil(folder, "^load_N: .*$", r"\g<0>\nload_N: 1")
    with pytest.raises(RunError, match="run.yaml, line 7: load_N is there twice"):
        RunTables(folder)


@pytest.mark.parametrize("key", ["bearing", "lubricant", "host", "contact_columns"])
@pytest.mark.parametrize("value", ["[a, b]", "{a: b}"])
def test_lists_where_text_belongs(folder, key, value):
    spoil(folder, f"^{key}: .*$", f"{key}: {value}")
    with pytest.raises(RunError, match=f"run.yaml: {key} must be text"):
        RunTables(folder)


def test_nested_too_deeply(folder):
    (folder / "run.yaml").write_text("a: " + 9000 * "[" + 9000 * "]")
    with pytest.raises(RunError, match="is nested too deeply"):
        RunTables(folder)


def test_more_balls_than_there_are(folder):
    """A thousand million took 8 GB."""
    spoil(folder, "^balls: .*$", "balls: 1000000000")
    with pytest.raises(RunError, match="balls = 1000000000, but balls.dump has 9"):
        raceway.open(folder).contacts


# ---- numbers in dumps --------------------------------------------------------------------------


@pytest.mark.parametrize("count", ["-1", "9223372036854775808", "1_0", "+9"])
def test_numbers_of_rows(folder, count):
    spoil(folder, r"(?<=NUMBER OF ENTRIES\n)\d+", count, "contacts.dump")
    with pytest.raises(RunError, match="line 4: expected a whole number, found"):
        RunTables(folder).contacts


def cell(folder, column, value):
    """A cell of the first row of contacts.dump."""
    names = RunTables(folder).settings["contact_columns"].split()
    path = folder / "contacts.dump"
    lines = path.read_text().split("\n")
    words = lines[9].split()
    words[names.index(column)] = value
    lines[9] = " ".join(words)
    path.write_text("\n".join(lines))


@pytest.mark.parametrize(
    "column, value, message",
    [
        ("ball", "inf", "ball is inf, must be a whole number"),
        ("ball", "1.5", "ball is 1.5, must be a whole number"),
        ("ball", "-1", "ball is -1, must be a whole number"),
        ("raceway", "7", "raceway is 7, must be a whole number from 0 to 1"),
        ("load", "1_0", "line 10: load is not a number: '1_0'"),
    ],
)
def test_cells(folder, column, value, message):
    cell(folder, column, value)
    with pytest.raises(RunError, match=message):
        raceway.open(folder).contacts


def test_columns_swapped(folder):
    spoil(folder, "^contact_columns: ball ring raceway", "contact_columns: ball raceway ring")
    with pytest.raises(RunError, match=r"raceway is \d+, must be"):
        raceway.open(folder).contacts


# ---- sweeps ------------------------------------------------------------------------------------


@pytest.fixture
def points(tmp_path):
    """A sweep of three points, one finished, one failed, one to be spoilt."""
    for name, load in (("a", "1"), ("b", "2"), ("c", "3")):
        (tmp_path / name).mkdir()
        (tmp_path / name / "point.yaml").write_text(f"load: '{load}'\n")
    (tmp_path / "a" / "summary.json").write_text(json.dumps({"load_N": 1.0}))
    (tmp_path / "b" / "failed.json").write_text(json.dumps({"message": "why"}))
    return tmp_path


@pytest.mark.parametrize(
    "content", [b"", b"[1, 2]", b"text", b"\xff\xfe", b"1: 2", 900 * b"[", b"a: [", None]
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
    """No figures: the point is run again."""
    (points / "c" / name).write_bytes(content)
    assert state(points / "c", {"load": "3"}) == ("pending", "")
    assert gather(points).set_index("point").loc["c", "status"] == "pending"


def test_a_failure_without_a_message(points):
    (points / "c" / "failed.json").write_text("{}")
    assert state(points / "c", {"load": "3"}) == ("pending", "")


@pytest.mark.parametrize("finished", [True, False])
def test_a_point_that_was_stopped_in_its_measurement(folder, finished):
    """Its run.yaml says all but the end: it was taken for finished, and so failed for good."""
    (folder / "point.yaml").write_text("load: '5000'\n")
    if not finished:
        spoil(folder, "^step_s: .*\n", "")
    run_point(folder, {"load": "5000"}, ["true"])
    assert (folder / "log.txt").exists() != finished  # of the program that was started


@pytest.fixture
def table(tmp_path):
    path = tmp_path / "t.csv"
    path.write_text("load\n5000\n")
    return path


@pytest.mark.parametrize(
    "words, message",
    [
        (["--program", "'"], "--program"),
        (["--program", "true", "--out", "{file}"], "cannot make the folder"),
        (["--program", "true", "--slurm", "{job}", "--out", "a\n#SBATCH --x"], "line break"),
    ],
)
def test_the_command_says_why(tmp_path, table, words, message, capsys):
    names = {"file": str(table), "job": str(tmp_path / "job.sh")}
    assert main(["sweep", str(table), *(word.format(**names) for word in words)]) == 1
    assert message in capsys.readouterr().err
    assert not (tmp_path / "job.sh").exists()


@pytest.mark.parametrize("name", ["out", "resume", "overwrite"])
def test_columns_that_are_no_settings(tmp_path, name):
    table = tmp_path / "t.csv"
    table.write_text(f"{name}\n1\n")
    with pytest.raises(TableError, match=f"column '{name}' cannot be swept"):
        read_points(table, deck_variables("inputs/in.6208"))


def test_many_unknown_columns_in_one_message(tmp_path):
    table = tmp_path / "t.csv"
    table.write_text(",".join(f"x{k}" for k in range(10_000)) + "\n1\n")
    with pytest.raises(TableError) as error:
        read_points(table, deck_variables("inputs/in.6208"))
    assert len(str(error.value)) < 3000 and "and 9980 more" in str(error.value)
    assert isinstance(error.value, RacewayError) and str(error.value).count("clearance") == 1
