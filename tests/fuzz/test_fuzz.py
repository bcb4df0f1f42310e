# SPDX-License-Identifier: GPL-2.0-or-later
"""Run a few cases of the fuzzer (run.py runs more) and all its past findings."""

from pathlib import Path
from types import SimpleNamespace

import pytest
from fuzz import files, lab, run, scene

CASES = {"liggghts": 60, "lammps": 16, "plugin": 12}
FOUND = sorted((Path(__file__).parent / "found").glob("*.yaml"))


@pytest.fixture(scope="module")
def runs(tmp_path_factory):
    """Return the runs that the commands read."""
    return files.runs(tmp_path_factory.mktemp("runs"))


@pytest.mark.parametrize("host", CASES)
def test_a_slice(host, runs):
    """There are no findings, and at least a third of the cases pass."""
    count, found = run.series(range(1, CASES[host] + 1), host, runs=runs)
    assert not found, "\n".join(found)
    assert count["passed"] >= CASES[host] / 3, count


@pytest.mark.parametrize("file", FOUND, ids=lambda file: file.stem)
def test_what_it_found(file):
    verdict, message = run.replay(file)
    assert verdict == "passed", message


@pytest.mark.parametrize(
    "end, verdict",
    [
        (
            "ball 3 on inner ring 1 at step 9: force 5 N on the far side of the groove, at",
            "refused",
        ),
        ("overlapping balls: atoms 3 and 15 are 0.0048 m apart", "refused"),
        ("fix c bearing/timestep: step 1e-06 s exceeds what the film allows, 5e-07 s", "refused"),
        ("fix c bearing/timestep: unknown keyword", "finding"),
    ],
)
def test_ends_that_a_longer_run_may_have(tmp_path, monkeypatch, end, verdict):
    """In the second run of a case, an error that a longer run may cause is not a finding, whereas
    any other error is."""
    ended = lab.Lab(tmp_path)
    outcome = SimpleNamespace(code=1, text=end, error=end)
    monkeypatch.setattr(lab, "run", lambda *words, **options: outcome)
    with pytest.raises(lab.Refused if verdict == "refused" else lab.Finding):
        ended.figures(scene.scene(1), "second")
