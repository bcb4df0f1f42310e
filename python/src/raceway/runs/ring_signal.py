# SPDX-License-Identifier: GPL-2.0-or-later
"""Columns of a ring in a run as signals."""

from typing import TYPE_CHECKING

import numpy as np

from raceway.errors import RunError
from raceway.runs.columns import RING
from raceway.runs.source import Signal
from raceway.runs.summary_table import NAME
from raceway.theory.bearing import OUTER

if TYPE_CHECKING:
    from raceway.runs.run import Run


def of_run(run: "Run", name: str, ring: str = "inner") -> Signal:
    """Return the `Signal` of a column of the "inner" or "outer" `ring` of `run`.

    Raise `RunError` unless one bearing has been selected, if there is no such `ring`, if the run
    does not have the column, or if it has fewer than 32 samples.
    """
    run.tables.record.need_one()
    if ring not in NAME.values():
        raise RunError(f"ring is {ring!r}, must be one of {', '.join(NAME.values())}")
    values, where, known = (_of_inner if ring == "inner" else _of_outer)(run, name)
    if values is None:
        raise RunError(f"{where} has no column {name}; it has {', '.join(known)}")
    if len(values) < 32:
        raise RunError(f"{where} has {len(values)} samples: a spectrum needs 32")
    return Signal(values, run.settings["sample_s"], of_column(name, ring))


def of_column(name: str, ring: str = "inner") -> dict[str, str]:
    """Return the unit and the meaning of a column of a ring as attributes."""
    column = RING.get(name)
    meaning = column.meaning.replace("inner ring", f"{ring} ring") if column else name
    return {"units": column.unit if column else "", "long_name": meaning}


def _of_inner(run, name):
    rings = run.rings
    values = rings[name].to_numpy() if name in rings.data_vars else None
    return values, run.tables.record.path, rings.data_vars


def _of_outer(run, name):
    record = run.tables.record
    here = np.flatnonzero(record.fixed("ring_raceway") == OUTER)
    if not len(here):
        raise RunError(f"{record.path}: the bearing has no outer ring")
    known = [n for n, dims in record.variables.items() if dims == ("time", "ring")]
    values = None
    if f"ring_{name}" in known:
        read = record.read([f"ring_{name}"], run.tables.first, run.tables.stop)
        values = read[f"ring_{name}"][:, here[0]]
    return values, f"{record.path}, outer ring,", [n.removeprefix("ring_") for n in known]
