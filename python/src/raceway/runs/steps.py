# SPDX-License-Identifier: GPL-2.0-or-later
"""The host steps of a run's samples: strictly and evenly rising, the same in every file."""

from collections.abc import Sequence

import numpy as np

from raceway.errors import RunError
from raceway.files import FilePath


class Steps:
    """The steps of the samples in the file `path`, taken a block at a time.

    `first` is the step of the first sample, `spacing` the steps between two, `count` how many
    samples were taken. `first` and `spacing` may be given, where another file has said them.
    """

    def __init__(
        self, path: FilePath, first: int | None = None, spacing: int | None = None
    ) -> None:
        self.path, self.first, self.spacing = path, first, spacing
        self.count, self.last = 0, None

    def take(self, steps: Sequence[int]) -> None:
        """Take the next steps. Raises `RunError` where one is there twice, missing or out of
        order, or belongs to another run than the other files of the folder."""
        if len(steps) == 0:
            return
        steps = np.asarray(steps, dtype=np.int64)
        if self.count == 0 and self.first is not None and steps[0] != self.first:
            raise RunError(
                f"{self.path}: the first sample is of step {steps[0]}, that of the other files of"
                f" step {self.first}"
            )
        self.first = int(steps[0]) if self.first is None else self.first
        known = steps if self.last is None else np.concatenate([[self.last], steps])
        apart = np.diff(known)
        if self.spacing is None and len(apart):
            self.spacing = int(apart[0])
        wrong = np.flatnonzero((apart <= 0) | (apart != self.spacing))
        if len(wrong):
            at = wrong[0]
            what = (
                "is there twice or out of order"
                if apart[at] <= 0
                else f"is not the next one: samples are {self.spacing} steps apart"
            )
            raise RunError(
                f"{self.path}: after the sample of step {known[at]}, that of step {known[at + 1]}"
                f" {what}"
            )
        self.count += len(steps)
        self.last = int(steps[-1])
