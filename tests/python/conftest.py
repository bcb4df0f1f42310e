# SPDX-License-Identifier: GPL-2.0-or-later
"""Fixtures of the Python tests: a bearing, and run folders with known content."""

import pytest
import synthetic


@pytest.fixture(scope="session")
def bearing():
    """The paper's 6208."""
    return synthetic.DEEP_GROOVE


@pytest.fixture(scope="session")
def lubricated():
    """A run with oil as data."""
    return synthetic.run(clearance=1e-5)


@pytest.fixture(scope="session")
def dry():
    """A run without, as data."""
    return synthetic.run(oil=None, passes=1)


@pytest.fixture
def folder(tmp_path, lubricated):
    """The lubricated run on disk, free to be modified."""
    return synthetic.write(tmp_path / "run", lubricated)


@pytest.fixture
def dry_folder(tmp_path, dry):
    """The dry run on disk."""
    return synthetic.write(tmp_path / "dry", dry)


@pytest.fixture
def small_blocks(monkeypatch):
    """A record is read in blocks of a few samples: results must not depend on where blocks end."""
    monkeypatch.setattr("raceway.runs.record.BLOCK", 60_000)
