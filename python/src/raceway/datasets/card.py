# SPDX-License-Identifier: GPL-2.0-or-later
"""Card of a data set, which describes its contents, physics, assumptions and noise floor."""

from textwrap import fill

import pandas as pd

from raceway import __version__
from raceway.datasets.spec import OVERSAMPLING, Spec

TEXT = """\
# {title}

Simulated vibration of a {bearing} bearing, with labels. The data set was made by `raceway dataset`,
version {version}. It contains {there} of {wanted} records of {seconds:g} s.

## Files

- `labels.csv`: one row for each record. Lengths are in m, loads in N, speeds in rpm.
- {folders}: the signals, {kinds}.
- `dataset.json`: the specification.
- `runs/`: variables and results of each run.

The `.mat` file of record 12, for example, contains `X012_DE_time` (N x 1) and `X012RPM`, which are
named as in the data of the bearing data center of Case Western Reserve University, and `fault`,
`fault_size_m`, `load_N`, `sampling_Hz` and `unit`. A `.parquet` file contains `time_s` and
`acceleration_m_s2`. The signal is the acceleration of the housing along {axis}, in m/s^2. The load
points along -y unless `load_azimuth` is set.

| class | records | rms, smallest to largest (m/s^2) |
|---|---|---|
{classes}

`size_m` is the length of a notch in the rolling direction, or the amplitude of waves. `flaw_place`
is given as a position on a clock, with the load at 6. Lines (`BPFO_Hz` ...) follow from the cage
speed of the run.

## What is simulated

Every ball, the cage and both rings move in three dimensions under contact forces. Contacts have
elliptical Hertz elasticity, an oil film, film damping and friction. A flaw is a change of the
shape of the raceway. Because a ball is round, it reaches only part of a flaw. Impacts, load zones,
slip and sidebands are results of the simulation. No impact, line, jitter or sideband was added by
hand.

## What is assumed

- The housing is one mass on springs and dampers along x and y{housing}. Its parameters are
  estimates. Real structures have many modes and transmission paths.
- Notches have rounded edges (`flaw_edge`) and no raised rim. They do not grow.
- Rings are rigid except at their contacts. Shaft, seals and other machines do not vibrate.
- Raceways and balls are perfect except for the flaw. The bearing data are those of {bearing} in
  `inputs/bearings`.
- Waviness has the orders Z - 1 and Z + 1 on both raceways.
- Speed and load are constant. A seed determines the initial positions of balls and rotating flaws.
- {noise}
- Runs are recorded at {oversampling} times the highest sampling rate and then filtered. The filter
  is flat up to 0.4 times the rate of a file, and 80 dB down above half of this rate.

## Noise floor

{floor}
"""

KINDS = {"mat": "MATLAB version 5 (`.mat`)", "parquet": "Apache Parquet (`.parquet`)"}


def card(spec: Spec, table: pd.DataFrame, wanted: int) -> str:
    """Return the text of README.md for the records in `table` (rows of labels.csv).

    `wanted` is the total number of records of the data set.
    """
    classes, floor = [], "There is no record without a flaw, so the noise floor is not known."
    if len(table):
        for kind, some in table.groupby("class", sort=False)["rms_m_s2"]:
            classes.append(f"| {kind} | {len(some)} | {some.min():.3g} to {some.max():.3g} |")
        quiet = table.loc[table["class"] == "none", "rms_m_s2"]
        if len(quiet):
            floor = (
                f"Records without a flaw have an rms of {quiet.min():.3g} to {quiet.max():.3g}"
                f" m/s^2 at {max(spec.rates) / 1000:g} kHz"
                + (", including noise." if spec.noise else ", which is due only to passing balls.")
                + " Fainter signals in other records are not due to their flaws."
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
            f"White noise of {spec.noise:g} m/s^2 (standard deviation) was added, using the seed."
            if spec.noise
            else "No noise was added."
        ),
        oversampling=OVERSAMPLING,
        floor=fill(floor, 100),
    )
