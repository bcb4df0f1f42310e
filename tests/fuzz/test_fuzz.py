# SPDX-License-Identifier: GPL-2.0-or-later
"""A few cases of the fuzzer (run.py makes more), and all that it found."""

from pathlib import Path

import pytest
from fuzz import files, run

CASES = {"liggghts": 60, "lammps": 16, "plugin": 12}
FOUND = sorted((Path(__file__).parent / "found").glob("*.yaml"))


@pytest.fixture(scope="module")
def runs(tmp_path_factory):
    """Runs for the commands to read."""
    return files.runs(tmp_path_factory.mktemp("runs"))


@pytest.mark.parametrize("host", CASES)
def test_a_slice(host, runs):
    """No failures, and most cases of each grammar are accepted."""
    count, found = run.series(range(1, CASES[host] + 1), host, runs=runs)
    assert not found, "\n".join(found)
    assert count["passed"] >= CASES[host] / 3, count


@pytest.mark.parametrize("file", FOUND, ids=lambda file: file.stem)
def test_what_it_found(file):
    verdict, message = run.replay(file)
    assert verdict == "passed", message
