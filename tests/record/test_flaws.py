# SPDX-License-Identifier: GPL-2.0-or-later
"""A record stores the flaws of its rings, i.e. every fix bearing/profile with its arguments."""

import pytest
import raceway
from host import liggghts, succeed
from raceway.runs.summary_table import table
from recorded_runs import small
from smallest import SMALLEST

PROFILES = """\
group outer type 3
fix spall inner bearing/profile notch 0.3 1.0e-3 full 1e-4 5.0e-5
fix waves inner bearing/profile wave 8 1.0e-8 0.5
fix table outer bearing/profile file "{0}/a: #1 table.txt"
fix perfect outer bearing/profile none
"""
SHORT = SMALLEST.replace("run 20000", "run 200")


@pytest.fixture(scope="module")
def flawed(tmp_path_factory):
    folder = tmp_path_factory.mktemp("flaws")
    (folder / "a: #1 table.txt").write_text("".join(f"{0.785398163397 * k} 0\n" for k in range(8)))
    deck = SHORT.replace("fix inner", PROFILES.format(folder) + "fix inner")
    # a profile without a flaw may be added between two runs
    succeed(small(folder, deck=deck + "fix more inner bearing/profile none\nrun 100\n"))
    return folder


def test_words_by_raceway(flawed):
    run = raceway.open(flawed / "run")
    assert run.flaws == {
        "inner": "notch 0.3 1.0e-3 full 1e-4 5.0e-5 wave 8 1.0e-8 0.5",
        "outer": f'file "{flawed}/a: #1 table.txt"',
    }
    assert "inner raceway: notch 0.3" in repr(run)
    figures = run.summary()
    assert figures["flaws"] == run.flaws
    assert f"flaws, inner raceway {run.flaws['inner']}" in " ".join(table(figures).split())


def test_run_yaml_has_them_too(flawed):
    """run.yaml also contains flaws with a file name that YAML would misread."""
    import yaml

    said = yaml.safe_load((flawed / "run/run.yaml").read_text())["flaws"]
    assert said == raceway.open(flawed / "run").settings["flaws"]
    assert said.split("; ")[1] == "10 wave 8 1.0e-8 0.5"


def test_flaws_of_a_record_stay(tmp_path):
    profiles = "".join(PROFILES.splitlines(keepends=True)[:3])
    deck = SHORT.replace("fix inner", profiles + "fix inner") + "unfix waves\nrun 100\n"
    done = liggghts(small(tmp_path, deck=deck))
    assert done.code != 0
    assert "flaws of its raceways were '10 notch" in done.error
    assert "and are now '10 notch" in done.error


PIT = "bearing/profile flaw_ball pit 0 0 1.0e-3 1.0e-3 1.0e-5 5.0e-5 flawed_ball"


def test_flawed_balls_are_those_of_the_last_command(tmp_path):
    """A fix with the ID of an earlier one has its own balls, and only those of its group."""
    for before in ("", f"fix pit balls {PIT} 1 3\nunfix pit\n"):
        fix = f"group some id 2 3 4 5\n{before}fix pit some {PIT} 4 2 7\n"
        folder = tmp_path / str(len(before))
        folder.mkdir()
        succeed(small(folder, deck=SHORT.replace("fix inner", fix + "fix inner")))
        said = raceway.open(folder / "run").settings["flaws"].split("; ")
        assert [words.split()[0] for words in said] == ["2", "4"]
