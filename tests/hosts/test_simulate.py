# SPDX-License-Identifier: GPL-2.0-or-later
"""The results of `raceway.simulate` are bitwise identical to those of the deck that it writes when
the deck is run by hand, and the errors are the same."""

import os
import pickle
import re
import signal
import subprocess
import sys
from concurrent.futures import ProcessPoolExecutor, ThreadPoolExecutor
from multiprocessing import get_context
from pathlib import Path

import pytest
import raceway
from host import ENVIRONMENT, ROOT, run, succeed, wait_for
from raceway.errors import RacewayError, RunError

POINT = {"bearing": "6306", "load": 1234.5678901234567, "rpm": 1000, "models": "paper"}
POINT |= {"passes": 1, "settle": 0.5}
OIL = {"lubricant": "vg46", "viscosity": 0.05}
TWO = ROOT / "docs/decks/in.two_bearings"  # has no variable resume
LONG = {"load": 3000, "rpm": 2000, "passes": 60, "keep": 25, "models": "full"}


@pytest.fixture(autouse=True)
def environment(monkeypatch):
    """Set up the environment in which all tests start a host program."""
    for name, value in ENVIRONMENT.items():
        monkeypatch.setenv(name, value)


def record(folder):
    return (Path(folder) / "record.nc").read_bytes()


@pytest.mark.parametrize(
    "host, ranks", [("liggghts", 1), ("liggghts", 2), ("lammps", 1), ("wheel", 2)]
)
def test_bits_of_the_deck_run_by_hand(tmp_path, monkeypatch, host, ranks):
    """The record of a call is bitwise identical to that of the deck that it wrote, run by hand, and
    to that of the main deck run with -var, even from a folder without inputs."""
    monkeypatch.chdir(tmp_path)
    name = None if host == "wheel" else host
    if host == "wheel":  # as if raceway had no source tree
        monkeypatch.setitem(raceway.sweeps.host_program.BUILT, "liggghts", Path("build/none"))
    found = raceway.simulate(**POINT, **OIL, out="one", host=name, ranks=ranks)
    written = Path("one/in.6208")
    hand = run(tmp_path / written, host=host, cwd=tmp_path, out="hand", resume="no")
    assert hand.code == 0, hand.text
    succeed("inputs/in.6208", host=host, out=tmp_path / "var", **POINT, **OIL)
    assert record("one") == record("hand") == record("var")
    assert found.settings["load_N"] == POINT["load"]
    given = [raceway.open(name).settings["given_data"] for name in ("one", "hand", "var")]
    assert given == ["viscosity=0.05"] * 3
    assert re.search(r"^variable load +index 1234.5678901234567 ", written.read_text(), re.M)
    assert pickle.loads(pickle.dumps(found)).summary() == found.summary()
    # with the defaults, a second call makes no steps; with overwrite it repeats all steps
    for overwrite in (False, True):
        raceway.simulate(**POINT, **OIL, out="one", host=name, overwrite=overwrite)
        assert ("Settling" in Path("one/log.txt").read_text()) == overwrite
        assert record("one") == record("hand")


@pytest.mark.parametrize(
    "wrong",
    [{"load": -1}, {"models": "half"}, {"bearing": "6299"}, {"lubricant": "pao8", "passes": 2}],
)
def test_errors_of_the_command_line(tmp_path, wrong):
    """The message of the host is the same as when the main deck is run with -var."""
    folder = tmp_path / "run"
    if "passes" in wrong:  # the folder contains a finished run with other settings
        raceway.simulate(out=folder, passes=1)
    own = {"models": None, "settle": None, **wrong}
    shown = run("inputs/in.6208", out=folder, resume="yes", **own).error
    with pytest.raises(RacewayError) as error:
        raceway.simulate(out=folder, **wrong)
    assert str(error.value) and str(error.value) in shown


def test_errors_before_anything_runs(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    for wrong, says in (
        ({"lode": 3}, "no variable 'lode'; did you mean load"),
        ({"load": [1, 2]}, r"load is \[1, 2\], must be a number, a string, True or False"),
        ({"bearing": "a$b"}, r"bearing is 'a\$b', must be a text without quotes"),
        ({"ranks": 0}, "ranks is 0, must be a whole number from 1"),
        ({"host": "gromacs"}, "host is 'gromacs', must be one of liggghts, lammps"),
        ({"host": "lammps", "program": "lmp"}, "host 'lammps' and program 'lmp': give one"),
        ({"program": "no_such_program"}, "there is no program 'no_such_program'"),
        ({"deck": "in.none"}, "cannot read deck in.none"),
        ({"deck": TWO, "resume": True}, "in.two_bearings has no variable 'resume', so its runs"),
        ({"deck": TWO, "overwrite": True}, "in.two_bearings has no variable 'overwrite'"),
        ({"out": "two words"}, "out is 'two words': a deck's folder must not contain blanks"),
    ):
        with pytest.raises(RacewayError, match=says):
            raceway.simulate(**wrong)
    assert not list(tmp_path.iterdir())


def test_a_deck_without_resume(tmp_path):
    """The deck runs anew, with results that are bitwise identical to those of the deck by hand."""
    done = run(TWO, out=tmp_path / "hand", models=None, settle=None)
    assert done.code == 0, done.text
    for words in ({}, {"resume": False}):
        raceway.simulate(deck=TWO, out=tmp_path / "run", **words)
        assert record(tmp_path / "run") == record(tmp_path / "hand")


def _max_load(load):
    return float(raceway.simulate(load=load, passes=1, progress=False).contacts.Q.max())


@pytest.mark.parametrize(
    "pool", [ThreadPoolExecutor, lambda n: ProcessPoolExecutor(n, get_context("spawn"))]
)
def test_side_by_side(tmp_path, monkeypatch, pool):
    """Each point has a separate folder, which is named after its values."""
    monkeypatch.chdir(tmp_path)
    loads = [1000, 2000.0, 4000]
    with pool(2) as workers:
        found = list(workers.map(_max_load, loads))
    assert found == sorted(found) and found[0] < 0.3 * found[2]
    assert sorted(p.name for p in (tmp_path / "run").iterdir()) == [
        f"load={load:g}_passes=1" for load in loads
    ]


def test_folder_in_use(tmp_path):
    """If two runs write to the same folder, the second is rejected, as on the command line."""
    code = "import sys, raceway; raceway.simulate(out=sys.argv[1], **eval(sys.argv[2]))"
    first = subprocess.Popen([sys.executable, "-c", code, tmp_path, repr(LONG)], cwd=ROOT)
    try:
        _wait(tmp_path / "record.nc", first)
        with pytest.raises(RacewayError, match="another run|in use|writes"):
            raceway.simulate(out=tmp_path, **LONG)
    finally:
        first.send_signal(signal.SIGINT)
        first.wait()


@pytest.mark.parametrize("whom", ["caller", "host", "mpirun", "rank"])
def test_stopped_and_continued(tmp_path, whom):
    """On Ctrl-C, the host stops and leaves a restart file. If the host, mpirun or a rank is killed,
    the call raises an error. After another call, the results are bitwise identical to those of an
    uninterrupted run."""
    raceway.simulate(out=tmp_path / "whole", **LONG)
    words = LONG | {"ranks": 2 if whom in ("mpirun", "rank") else 1}
    code = "import sys, raceway; raceway.simulate(out=sys.argv[1], **eval(sys.argv[2]))"
    out = tmp_path / "run"
    process = subprocess.Popen(
        [sys.executable, "-c", code, out, repr(words)], cwd=ROOT, stderr=subprocess.PIPE, text=True
    )
    _wait(out / "record.nc", process)
    (host,) = _children(process.pid)
    ranks = _children(host)
    if whom == "caller":
        process.send_signal(signal.SIGINT)
    else:
        os.kill(ranks[0] if whom == "rank" else host, signal.SIGKILL)
    said = process.communicate(timeout=60)[1]
    assert process.returncode != 0
    assert {"caller": "KeyboardInterrupt", "rank": "exited on signal 9"}.get(
        whom, "killed by signal SIGKILL"
    ) in said
    assert not Path(f"/proc/{host}").exists()
    with pytest.raises(RunError):
        raceway.open(out).tables.need_finished()
    wait_for(lambda: not any(Path(f"/proc/{rank}").exists() for rank in ranks))
    assert raceway.simulate(out=out, **words).tables.finished
    assert record(out) == record(tmp_path / "whole")


def _children(pid):
    return [int(n) for n in Path(f"/proc/{pid}/task/{pid}/children").read_text().split()]


def _wait(path, process):
    """Wait until the run has written some samples to `path`."""

    def grown():
        assert process.poll() is None
        return path.exists() and path.stat().st_size > 1_500_000

    wait_for(grown)
