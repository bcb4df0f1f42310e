# SPDX-License-Identifier: GPL-2.0-or-later
"""Distribute the tests among processes by file, because the tests in a file share runs. The
examples on the documentation pages are distributed one by one.

Python's garbage collector is off while pytest collects the tests, because it finds hardly anything
to free, and it ignores these objects afterwards. The collection takes three quarters of the time,
in every process.

MPI libraries do not look for the caches of the machine, which would take a third of the time in
which a host starts.
"""

import gc
import os

import pytest
from host import ROOT
from xdist.scheduler import LoadFileScheduling

os.environ.update(HWLOC_COMPONENTS="synthetic", HWLOC_SYNTHETIC=f"core:{os.cpu_count()} pu:1")


@pytest.fixture
def in_the_tree(monkeypatch):
    """Make the root of the repository the current folder."""
    monkeypatch.chdir(ROOT)


class Scheduling(LoadFileScheduling):
    def _split_scope(self, nodeid):
        file = super()._split_scope(nodeid)
        return nodeid if file.endswith("docs/test_examples.py") else file


def pytest_xdist_make_scheduler(config, log):
    return Scheduling(config, log)


@pytest.hookimpl(wrapper=True)
def pytest_collection():
    gc.disable()
    try:
        return (yield)
    finally:
        gc.freeze()
        gc.enable()
