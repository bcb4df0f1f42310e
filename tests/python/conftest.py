# SPDX-License-Identifier: GPL-2.0-or-later
"""Provide fixtures for the Python tests: a bearing, and run folders with known contents."""

import shutil

import pytest
import synthetic
from bearings import B6208


@pytest.fixture(scope="session")
def bearing():
    """Return the 6208 bearing of the paper."""
    return B6208


@pytest.fixture(scope="session")
def lubricated():
    """Return the data of a lubricated run."""
    return synthetic.run(clearance=1e-5)


@pytest.fixture(scope="session")
def dry():
    """Return the data of a dry run."""
    return synthetic.run(oil=None, passes=1)


@pytest.fixture(scope="session")
def written(tmp_path_factory, lubricated, dry):
    """Return a folder that contains both runs."""
    folder = tmp_path_factory.mktemp("written")
    synthetic.write(folder / "run", lubricated)
    synthetic.write(folder / "dry", dry)
    return folder


@pytest.fixture
def folder(tmp_path, written):
    """Return a copy of the lubricated run on disk, which a test may modify."""
    return shutil.copytree(written / "run", tmp_path / "run")


@pytest.fixture
def dry_folder(tmp_path, written):
    """Return a copy of the dry run on disk."""
    return shutil.copytree(written / "dry", tmp_path / "dry")


@pytest.fixture
def small_blocks(monkeypatch):
    """Read records in blocks of a few samples: the results must not depend on the block
    boundaries."""
    monkeypatch.setattr("raceway.runs.record.BLOCK", 60_000)


@pytest.fixture
def panels(monkeypatch):
    """Return a function that returns the panels of the last picture, keyed by title."""
    from raceway.pictures.style import plt  # loading matplotlib takes long

    kept, close = [], plt.close
    monkeypatch.setattr(plt, "close", kept.append)
    yield lambda: {panel.get_title(loc="left"): panel for panel in kept[-1].axes}
    for figure in kept:
        close(figure)
