# SPDX-License-Identifier: GPL-2.0-or-later
"""The card of a data set: contents, physics, assumptions and noise floor."""

from textwrap import fill

import pandas as pd

from raceway import __version__
from raceway.datasets.spec import OVERSAMPLING, Spec

TEXT = """\
# {title}

Simulated vibration of a {bearing} bearing, with labels. Made by `raceway dataset`, version
{version}. It has {there} of {wanted} records of {seconds:g} s.

## Files

- `labels.csv`: one row for each record. Lengths are in m, loads in N, speeds in rpm.
- {folders}: the signals, {kinds}.
- `dataset.json`: the specification.
- `runs/`: variables and figures of each run.

A `.mat` file of record 12 has `X012_DE_time`, N x 1, and `X012RPM`, with the names of the bearing
data center of Case Western Reserve University, and also `fault`, `fault_size_m`, `load_N`,
`sampling_Hz` and `unit`. A `.parquet` file has `time_s` and `acceleration_m_s2`. The signal is the
acceleration of the housing along {axis}, in m/s^2. The
load points along -y unless `load_azimuth` is set.

| class | records | rms, least to most (m/s^2) |
|---|---|---|
{classes}

`size_m` is the length of a notch along rolling, or the amplitude of waves. `flaw_place` is
given as on a clock, with the load at 6. Lines (`BPFO_Hz` ...) follow from the cage speed of the
run.

## What is physics

Every ball, the cage and both rings move by contact forces in three dimensions. Contacts have
elliptical Hertz elasticity, an oil film, film damping and friction. A flaw is a change of the
raceway's shape. Because a ball is round, it reaches only part of a flaw. Impacts, load zones, slip
and sidebands follow from that. No impact, line, jitter or sideband was added by hand.

## What is assumed

- The housing is one mass on springs and dampers along x and y{housing}. Its parameters are
  estimates. Real structures have many modes and paths.
- Notches have rounded edges (`flaw_edge`) and no raised rim. They do not grow.
- Rings are rigid between their contacts. Shaft, seals and other machines do not vibrate.
- Raceways and balls are perfect except for the flaw. Bearing data: {bearing} of `inputs/bearings`.
- Waviness has the orders Z - 1 and Z + 1 on both raceways.
- Speed and load are constant. A seed determines the initial positions of balls and rotating flaws.
- {noise}
- Runs are recorded at {oversampling} times the fastest rate, then filtered: flat up to 0.4 of the
  rate of a file, 80 dB down above half of it.

## Noise floor

{floor}
"""

KINDS = {"mat": "MATLAB version 5 (`.mat`)", "parquet": "Apache Parquet (`.parquet`)"}


def card(spec: Spec, table: pd.DataFrame, wanted: int) -> str:
    """Text of README.md for the records in `table` (rows of labels.csv), out of `wanted`."""
    classes, floor = [], "There is no record without a flaw, so the floor is not known here."
    if len(table):
        for kind, some in table.groupby("class", sort=False)["rms_m_s2"]:
            classes.append(f"| {kind} | {len(some)} | {some.min():.3g} to {some.max():.3g} |")
        quiet = table.loc[table["class"] == "none", "rms_m_s2"]
        if len(quiet):
            floor = (
                f"Records without a flaw have an rms of {quiet.min():.3g} to {quiet.max():.3g}"
                f" m/s^2 at {max(spec.rates) / 1000:g} kHz"
                + (", noise included." if spec.noise else ", from the passing balls alone.")
                + " Anything fainter in another record is not due to its flaw."
            )
    return TEXT.format(
        title=spec.title,
        bearing=spec.bearing,
        version=__version__,
        there=len(table),
        wanted=wanted,
        seconds=spec.seconds,
        folders=", ".join(f"`{rate / 1000:g}k/`" for rate in spec.rates),
        kinds=" and ".join(KINDS[kind] for kind in spec.files),
        axis=spec.axis,
        classes="\n".join(classes),
        housing="".join(
            f", {name.removeprefix('housing_')} {value}"
            for name, value in spec.deck.items()
            if name.startswith("housing_")
        ),
        noise=(
            f"White noise of {spec.noise:g} m/s^2 (standard deviation) was added, from the seed."
            if spec.noise
            else "No noise was added."
        ),
        oversampling=OVERSAMPLING,
        floor=fill(floor, 100),
    )
