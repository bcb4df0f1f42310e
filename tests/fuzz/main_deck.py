# SPDX-License-Identifier: GPL-2.0-or-later
"""Run the main deck with a few of its variables set. The run is resumed, repeated in another host
or on several ranks, or read by `raceway summary`."""

import json
import math
import subprocess

import netCDF4
import numpy as np
from fuzz import child
from fuzz.draw import grammar
from fuzz.lab import CRASH, HOSTS, LATER, SECONDS, Finding, Refused
from host import run

# None: the models of the deck
SHORT = {"passes": 1, "samples": 20, "settle": 0.1, "models": None}
WAYS = ("resume", "hosts", "ranks", "summary")
# settings that describe the run rather than the bearing
TIMING = ("wall_s", "processor_s", "created", "ranks", "host", "program", "evaluations", "history")


def variables(draw):
    usual = grammar("main_deck")
    chosen = {}
    for name in draw.sample(list(usual), draw.randint(1, 6)):
        value = draw.choice(usual[name])
        chosen |= value if isinstance(value, dict) else {name: value}
    if draw.chance(0.15):
        chosen[draw.choice([*chosen])] = draw.choice(grammar("hostile")["numbers"])
    return chosen


def check(draw, folder, host):
    """Run one case and return the name of the check that was made. Raise Finding or Refused."""
    given, way = variables(draw), draw.choice(WAYS)
    first = _run(folder / "first", host, given, first=True)
    if way == "resume":
        longer = given | {"passes": 2}
        _run(folder / "first", host, longer | {"resume": "yes"})
        whole = _run(folder / "whole", host, longer)
        _same(_record(folder / "first"), whole, given, "resumed")
    elif way == "hosts":
        other = draw.choice([name for name in HOSTS if name not in (host, "sanitized")])
        _same(first, _run(folder / "other", other, given), given, f"host {other}")
    elif way == "ranks":
        count = draw.choice([2, 4])
        _same(first, _run(folder / "ranks", host, given, ranks=count), given, f"{count} ranks")
    else:
        _summary(folder, given)
    return way


def _run(folder, host, given, ranks=1, first=False):
    try:
        end = run(
            "inputs/in.6208",
            host=HOSTS[host],
            ranks=ranks,
            timeout=SECONDS,
            out=folder,
            **(SHORT | given),
        )
    except subprocess.TimeoutExpired:
        raise Finding(f"hang: {given}") from None
    if end.code < 0 or end.code > 128 or CRASH.search(end.text) or end.code and not end.error:
        raise Finding(f"crash: {given}: exit code {end.code}: {end.text[-300:]}")
    if end.code:
        message = end.error.splitlines()[0]
        if first or LATER.search(message):
            raise Refused(message)
        raise Finding(f"only run {folder.name} is rejected: {given}: {message}")
    return _record(folder)


def _record(folder):
    with netCDF4.Dataset(folder / "record.nc") as file:
        return {
            name: np.ma.filled(value[...], np.nan) if value.dtype.kind == "f" else value[...]
            for name, value in file.variables.items()
            if value.dtype.kind in "fi"
        }


def _same(first, second, given, what):
    for name in first:
        if name in TIMING:
            continue
        a, b = first[name], second.get(name)
        if b is None or a.shape != b.shape:
            shapes = f"{a.shape} and {getattr(b, 'shape', None)}"
            raise Finding(f"{what}: {given}: shapes of {name} differ: {shapes}")
        if not np.array_equal(a, b, equal_nan=a.dtype.kind == "f"):
            off = np.nanmax(abs(a - b)) if a.size else 0
            raise Finding(
                f"{what}: {given}: {name} differs by {off:.3g} of {np.nanmax(abs(a)):.3g}"
            )


def _summary(folder, given):
    end = child.raceway(["summary", str(folder / "first"), "--json"], folder)
    if end.code:
        raise Finding(f"summary rejects a finished run: {given}: {end.error[:300]}")
    for name, value in json.loads(end.out, parse_constant=float).items():
        if isinstance(value, float) and not math.isfinite(value):
            raise Finding(f"summary: {given}: {name} is {value}")
    values = json.loads(end.out)
    for name, value in (values.get("losses_W") or {}).items():
        if value is not None and value < -1e-9 and name not in ("slip", "film"):
            raise Finding(f"summary: {given}: loss {name} is {value}")
