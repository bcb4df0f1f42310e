# SPDX-License-Identifier: GPL-2.0-or-later
"""Check that a record and its `run.yaml` belong to the same run by comparing their settings."""

import math
from collections.abc import Mapping
from typing import Any

from raceway.errors import RunError
from raceway.runs.record import Record

DIGITS = 1e-14  # numbers in run.yaml have 15 digits
VARIABLES = "deck_variables"  # YAML may have removed quotation marks from other texts


def need_same_run(record: Record, said: Mapping[str, Any]) -> None:
    """Raise `RunError` if the `record` contradicts `said`, the contents of `run.yaml` as text.

    Compare all numbers, the variables of the deck and, for a finished run, its length.
    """
    # Differences in the deck's variables cause other differences, so they are checked first.
    for key in (VARIABLES, *record.attrs):
        if key not in said or key not in record.attrs:
            continue
        own = record.attrs[key]
        if key == VARIABLES and own != said[key]:
            own, other = own.split(","), str(said[key]).split(",")
            _refuse(record, key, *(_without(*two) for two in ((own, other), (other, own))))
        if isinstance(own, float) and not _close(own, said[key]):
            _refuse(record, key, f"{own:g}", said[key])
    # Before the run ends, its record may already be longer than stated in the run.yaml of an
    # earlier run of the deck.
    if "simulated_s" in said and record.fixed("finished") and len(record):
        last, known = float(record.pick("time", (len(record) - 1,))), float(said["simulated_s"])
        if abs(last - known) > 0.5 * record.attrs["sample_s"]:
            _refuse(record, "simulated_s", f"{last:g}", f"{known:g}")


def _close(own, text):
    try:
        return math.isclose(own, float(text), rel_tol=DIGITS) or math.isnan(own)
    except (TypeError, ValueError):
        return False


def _without(words, others):
    return ",".join(word for word in words if word not in others) or "another"


def _refuse(record, key, own, other):
    raise RunError(
        f"{record.path} belongs to a different run than run.yaml: {key} is {own} in the record,"
        f" but {other} in run.yaml"
    )
