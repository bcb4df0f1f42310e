# SPDX-License-Identifier: GPL-2.0-or-later
"""Runs that are started by a server of the program (host/run_server.h) are those of the program."""

import os
import signal
import subprocess
import sys
import time

import pytest
from host import ENVIRONMENT, ROOT, run
from raceway.runs.tables import RunTables
from raceway.sweeps import host_run, run_server
from recorded_runs import differ

PROGRAM = str(ROOT / "build" / "liggghts")
QUICK = {"models": "paper", "settle": "1", "passes": "1", "samples": "20"}


@pytest.fixture(autouse=True)
def one_server(monkeypatch):
    """Each test has its own server, and ends it. pytest would change the environment during the
    test."""
    monkeypatch.chdir(ROOT)
    monkeypatch.delenv("PYTEST_CURRENT_TEST")
    yield
    run_server.forget()


def words(deck="inputs/in.6208", **variables):
    found = [PROGRAM, "-in", deck, "-log", "none"]
    for name, value in variables.items():
        found += ["-var", name, str(value)]
    return found


def served(log, deck="inputs/in.6208", **options):
    return host_run.execute(words(deck, **options), log, served=True)


def test_results_are_bitwise_those_of_the_program(tmp_path):
    """The second run of a server, too."""
    server = run_server.shared(PROGRAM)
    done = run("inputs/in.6208", out=tmp_path / "program", **QUICK)
    assert done.code == 0
    for name in ("first", "second"):
        assert served(tmp_path / "log", **QUICK, out=tmp_path / name) == 0
        assert differ(tmp_path / "program", tmp_path / name) == []
    assert server and server is run_server.shared(PROGRAM)


def test_a_run_has_its_own_command_line(tmp_path):
    """Data of bearings are not variables of the deck; a variable that is neither is rejected."""
    assert served(tmp_path / "log", **QUICK, out=tmp_path / "run", ball_poisson=0.1) == 0
    settings = RunTables(tmp_path / "run").settings
    assert settings["given_data"] == "ball_poisson=0.1" and settings["ball_poisson"] == 0.1
    assert served(tmp_path / "log", **QUICK, out=tmp_path / "next") == 0
    assert RunTables(tmp_path / "next").settings["given_data"] == "none"
    assert served(tmp_path / "log", **QUICK, out=tmp_path / "wrong", ball_poison=0.1) == 1
    assert "the deck has no such variable" in (tmp_path / "log").read_text(errors="replace")


def test_a_run_has_the_folder_and_the_environment_of_its_caller(tmp_path, monkeypatch):
    """Also if they have changed since the server was started."""
    (tmp_path / "in.said").write_text('shell sh -c "pwd; echo $SAID"\n')
    for said in ("one", "other"):
        folder = tmp_path / said
        folder.mkdir()
        monkeypatch.chdir(folder)
        monkeypatch.setenv("SAID", said)
        assert served(tmp_path / "log", "../in.said") == 0
        assert f"{folder}\n{said}\n" in (tmp_path / "log").read_text()


@pytest.mark.parametrize(
    "deck, load, said",
    [
        ("inputs/in.6208", "-5", "load (N) is -5, must be from 0.001 to 1e+06"),
        ("inputs/in.absent", "5", "Cannot open input script inputs/in.absent"),
    ],
)
def test_errors_are_those_of_the_program(deck, load, said, tmp_path):
    """A run that ends with an error does not affect later runs of the server."""
    wrong = words(deck, out=tmp_path / "run", load=load)
    code = host_run.execute(wrong, tmp_path / "program")
    assert host_run.execute(wrong, tmp_path / "served", served=True) == code == 1
    for name in ("program", "served"):
        assert said in (tmp_path / name).read_text(errors="replace")
    assert served(tmp_path / "log", **QUICK, out=tmp_path / "run") == 0


def test_a_killed_run_has_its_signal(tmp_path):
    server = run_server.shared(PROGRAM)
    with open(tmp_path / "log", "wb") as log:
        one = server.start(words(**QUICK | {"passes": 9999}, out=tmp_path / "run"), log, ())
    os.kill(one.pid, signal.SIGKILL)
    assert one.wait() == -signal.SIGKILL and host_run.stopped(-signal.SIGKILL)


def test_without_a_server_the_program_is_started(tmp_path):
    """The server was killed between two runs. The run after the next has a new server."""
    server = run_server.shared(PROGRAM)
    server._process.kill()
    server._process.wait()
    assert served(tmp_path / "log", **QUICK, out=tmp_path / "run") == 0
    assert server.closed and run_server.shared(PROGRAM) is not server
    assert served(tmp_path / "log", **QUICK, out=tmp_path / "next") == 0


def test_a_server_ends_with_its_process():
    code = "from raceway.sweeps import run_server as s; print(s.shared({!r})._process.pid)"
    said = subprocess.run(
        [sys.executable, "-c", code.format(PROGRAM)], capture_output=True, text=True, check=True
    )
    for _ in range(100):
        if not os.path.exists(f"/proc/{int(said.stdout)}"):
            return
        time.sleep(0.05)
    assert "Z" in open(f"/proc/{int(said.stdout)}/stat").read().split()[2]


def test_no_server_for_ranks_of_a_job(monkeypatch):
    """Other programs do not serve either."""
    for name, value in ENVIRONMENT.items():
        monkeypatch.setenv(name, value)
    assert run_server.shared("mpirun") is None
    monkeypatch.setenv("SLURM_PROCID", "0")
    assert run_server.shared(PROGRAM) is None
