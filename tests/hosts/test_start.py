# SPDX-License-Identifier: GPL-2.0-or-later
"""Programs that are started alone start Open MPI quickly; programs that a launcher starts follow
the rules of Open MPI. In both cases, the user's settings take precedence."""

import re
from concurrent.futures import ThreadPoolExecutor

import pytest
from host import ENVIRONMENT, call, command, deck_file, run

OURS = {"ess_singleton_isolated": "true", "pml": "ob1", "orte_create_session_dirs": "false"}


def settings(host, tmp_path, deck="", ranks=1, **environment):
    """Return a dict {name: value} of the settings that Open MPI finds in the environment when the
    host runs `deck`."""
    path = deck_file(tmp_path, deck + "\n")
    words = command(path, host=host, ranks=ranks, extra=["-screen", "none"])
    environment = dict(ENVIRONMENT, OMPI_MCA_mpi_show_mca_params="enviro", **environment)
    done = call(words, env=environment, cwd=tmp_path, timeout=60)
    assert done.returncode == 0, done.stderr
    return dict(re.findall(r"(\w+)=(\S*) \(environment\)", done.stdout + done.stderr))


@pytest.mark.parametrize("host", ["liggghts", "lammps"])
def test_alone(host, tmp_path):
    """Without a launcher, Open MPI neither starts a daemon nor searches for networks."""
    assert settings(host, tmp_path).items() >= OURS.items()


def test_launcher(tmp_path):
    """Under mpirun, the programs do not set any Open MPI parameters."""
    found = settings("liggghts", tmp_path, ranks=2)
    assert found["ess"] == "pmi"
    assert not OURS.keys() & found.keys()


@pytest.mark.parametrize("name", ["PMIX_RANK", "PMI_RANK", "SLURM_STEP_ID", "FLUX_TASK_RANK"])
def test_other_launchers(name, tmp_path):
    """Open MPI's settings stay unchanged if even a single variable of a launcher is set."""
    assert "ess_singleton_isolated" not in settings("liggghts", tmp_path, **{name: "0"})


def test_settings_of_the_user_win(tmp_path):
    """A user's setting takes precedence, even if the user sets only one of the two parameters."""
    found = settings("liggghts", tmp_path, OMPI_MCA_ess_singleton_isolated="0")
    assert (found["ess_singleton_isolated"], found["pml"]) == ("false", "ob1")
    found = settings("liggghts", tmp_path, OMPI_MCA_pml="^cm")
    assert (found["ess_singleton_isolated"], found["pml"]) == ("true", "^cm")


def test_programs_that_a_deck_starts(tmp_path):
    """Child processes receive the user's original environment, because `shell mpirun ...` must not
    inherit the singleton settings."""
    settings("liggghts", tmp_path, "shell env > seen", OMPI_MCA_pml="^cm")
    seen = (tmp_path / "seen").read_text().splitlines()
    assert "OMPI_MCA_pml=^cm" in seen
    assert not [line for line in seen if "ess_singleton_isolated" in line]
    settings("liggghts", tmp_path, "shell env > seen")
    assert not [line for line in (tmp_path / "seen").read_text().splitlines() if "pml" in line]


def test_devices_of_the_machine(tmp_path, monkeypatch):
    """Programs that a deck starts may look for them again, as the user has set."""
    for name in ("HWLOC_COMPONENTS", "HWLOC_SYNTHETIC"):
        monkeypatch.delitem(ENVIRONMENT, name, raising=False)
    for own in ({}, {"HWLOC_COMPONENTS": "-gl"}):
        settings("liggghts", tmp_path, "shell env > seen", **own)
        seen = (tmp_path / "seen").read_text().splitlines()
        found = [line for line in seen if line.startswith("HWLOC_")]
        assert found == [f"{name}={value}" for name, value in own.items()]


def test_many_starts_at_once(tmp_path):
    """Without isolation, ten of 400 starts (eight at a time) failed in MPI_Init, because processes
    that were ending removed the session folder of processes that were starting."""
    deck = deck_file(tmp_path, "units si\n")

    def start(_):
        return run(deck).code

    with ThreadPoolExecutor(8) as pool:
        assert sum(code != 0 for code in pool.map(start, range(200))) == 0
