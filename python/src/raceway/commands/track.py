# SPDX-License-Identifier: GPL-2.0-or-later
"""`raceway track FILE`: track the state of a bearing over hours from a series of readings."""

import argparse

from raceway.commands import options
from raceway.commands.identify import NAMES

HELP = "track clearance, loads, oil temperature and cooling over a series of readings"
DESCRIPTION = """\
Applies an unscented Kalman filter to a series of readings. It estimates the same quantities as
`raceway identify`, but for a state that drifts. Each row of a CSV file contains a time in s, the
speed, and the readings at that time; empty cells are allowed. The columns are time_s, rpm, load,
axial, load_more, axial_more, at (temperature of the oil), FTF, BPFO, BPFI, BSF (orders),
capacitance (F), temperature (C).

The model's error of the cage speed, including the unknown lag of a cage some of whose balls are
unloaded, counts as the same in all rows, so it does not average out over many rows.

FILE has the format of `raceway identify` with three keys instead of `readings`: `series` is the
name of the CSV file, `within` the standard deviation of each quantity, and `drift` the standard
deviation by which each unknown may drift in an hour (default: 0, i.e. constant)."""
EXAMPLES = """\
examples:
  raceway track hours.yaml
  raceway track hours.yaml --out hours.png --csv state.csv

hours.yaml:
  bearing: 6205
  lubricant: vg68
  known: {load: 10, axial: 60}
  unknown: {clearance: 0 15e-6, temperature: 20 90}
  series: hours.csv
  within: {BPFO: 1e-4, capacitance: 0.2e-12}
  drift: {clearance: 1e-6, temperature: 10}

Exit codes: 0 done, 1 the files are invalid or no state carries the loads, 2 wrong command line."""


def add(one: argparse.ArgumentParser) -> None:
    one.add_argument("file", metavar="FILE", help="YAML file of known quantities and the series")
    options.inputs(one)
    one.add_argument("--out", metavar="PNG", help="plot the state against time")
    one.add_argument(
        "--csv", metavar="FILE", help="write the table to this file instead of the terminal"
    )


def run(arguments: argparse.Namespace) -> None:
    import pandas as pd

    from raceway import files
    from raceway.recordings import readings
    from raceway.recordings.track import Row, track

    given = readings.series(arguments.file, arguments.inputs)
    try:
        found = track(given.readings, [Row(*one) for one in given.rows], given.drift)
    except ValueError as error:
        raise readings.ReadingsError(f"{arguments.file}: {error}") from None
    columns = {"time_s": found.time}
    for k, name in enumerate(found.names):
        columns |= {name: found.best[:, k]}
        columns |= {f"{name}_low": found.low[:, k], f"{name}_high": found.high[:, k]}
    table = pd.DataFrame(columns | {"surprise": found.surprise})
    if arguments.out:
        # loading matplotlib takes longer than running a filter
        from raceway.pictures.track import picture

        picture(found, NAMES, arguments.out)
    if arguments.csv:
        files.whole(arguments.csv, lambda part: table.to_csv(part, index=False))
    else:
        whole = {"time_s": "{:.10g}".format}
        print(table.to_string(index=False, float_format="{:.4g}".format, formatters=whole))
