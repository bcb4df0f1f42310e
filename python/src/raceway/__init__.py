# SPDX-License-Identifier: GPL-2.0-or-later
"""Analysis of ball bearing runs, one topic a module. See the README for the list."""

__version__ = "0.1.0"


def open(folder, samples=slice(None)):
    """The run in `folder` as one object, `raceway.datasets.Datasets`; `samples`, a slice, keeps to
    some of them.

    Raises `raceway.errors.RunError` when the folder is not that of a run.
    """
    # xarray takes longer to load than a static bearing to solve
    from raceway.datasets import Datasets

    return Datasets(folder, samples)
