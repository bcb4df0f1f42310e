# SPDX-License-Identifier: GPL-2.0-or-later
"""Execute the runs of a data set and write its files.

The folder contains

    dataset.json     the specification; a folder with a different specification is rejected
    README.md        the card
    labels.csv       one row for each record
    48k/0001.mat     signals, one folder for each rate; or .parquet, or both
    runs/0001/       the run: its variables, its results, `label.json` once its files are written

A record is complete once `label.json` exists, which is written last.
"""

import importlib.util
import json
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

import numpy as np
import pandas as pd
from scipy import io, stats

from raceway import files
from raceway.datasets.card import card
from raceway.datasets.spec import FLAW_WORDS, GUARD, Record, Spec, SpecError, records
from raceway.errors import RacewayError
from raceway.files import FilePath
from raceway.runs import record as run_record
from raceway.runs import sensor, spectrum
from raceway.runs.run import Run
from raceway.sweeps.point_run import FINISHED, mapping, state
from raceway.sweeps.sweep import sweep

ASKED, LABELS, LABEL = "dataset.json", "labels.csv", "label.json"


def make(
    spec: Spec, folder: FilePath, command: Sequence[str], *, jobs: int = 1, keep: bool = False
) -> pd.DataFrame:
    """Make or resume the data set `spec` in `folder`, and return the table of labels.

    `command` is a list of program, options and deck. `keep` preserves the records of the runs,
    which are large. Raise `RacewayError` if the folder belongs to another data set or if runs fail.
    """
    folder, wanted = Path(folder), records(spec)
    if "parquet" in spec.files and importlib.util.find_spec("pyarrow") is None:
        raise SpecError("record: parquet files require pip install 'raceway[parquet]'")
    _claim(spec, folder)
    by_name = {one.point.name: one for one in wanted}
    missing = []
    for one in wanted:
        where = folder / "runs" / one.point.name
        if _whole(folder, one, spec):
            continue
        if state(where, one.point.variables)[0] == FINISHED:
            if (where / run_record.NAME).exists():  # interrupted between the run and its files
                _write(one, spec, folder, keep)
                continue
            (where / "summary.json").unlink()  # run again, because record and files are missing
            (where / "run.yaml").unlink(missing_ok=True)
        missing.append(one.point)
    counts, *_ = sweep(
        missing,
        folder / "runs",
        command,
        jobs=jobs,
        retry=True,
        finished=lambda point: _write(by_name[point.name], spec, folder, keep),
    )
    table = _labels(wanted, spec, folder)
    if failed := counts.get("failed"):
        raise RacewayError(
            f"{failed} of {len(wanted)} runs failed, see {folder}/runs/*/failed.json and log.txt"
        )
    return table


def _claim(spec, folder):
    """Check that the folder is new or belongs to this data set."""
    asked = json.dumps(spec._asdict(), indent=2, ensure_ascii=False) + "\n"
    path = folder / ASKED
    if path.exists():
        if path.read_text() != asked:
            raise SpecError(
                f"{folder} contains another data set: {path} differs; choose a new folder"
            )
        return
    if folder.exists() and any(folder.iterdir()):
        raise SpecError(f"{folder} contains other files: choose a new folder")
    files.folder(folder)
    files.text(path, asked)


def file_of(rate: int, record: Record, kind: str = "mat") -> str:
    """Return the path of the file of a record at a `rate`, relative to the folder of the data set.

    `kind` is the file format.

    >>> from raceway.sweeps.points import Point
    >>> file_of(48000, Record(7, Point("0007", {}), {}, 1797.0))
    '48k/0007.mat'
    """
    return f"{rate / 1000:g}k/{record.point.name}.{kind}"


def _whole(folder, one, spec):
    where = folder / "runs" / one.point.name
    return (
        state(where, one.point.variables)[0] == FINISHED
        and mapping(where / LABEL, json.loads) is not None
        and all(
            (folder / file_of(rate, one, kind)).exists()
            for rate in spec.rates
            for kind in spec.files
        )
    )


def _write(one: Record, spec: Spec, folder: Path, keep: bool) -> None:
    """Write the files and the label of a finished run."""
    where = folder / "runs" / one.point.name
    run = Run(where)
    name = f"a{spec.axis}"
    for rate in spec.rates:
        heard = sensor.of_run(
            run, name, "outer", rate, noise=spec.noise, seed=[one.labels["seed"], one.number, rate]
        ).to_numpy()
        first = round(GUARD * rate / min(spec.rates))
        values = heard[first : first + round(spec.seconds * rate)]
        if len(values) < round(spec.seconds * rate):
            raise RacewayError(f"{where}: {len(values)} samples at {rate} Hz are too few")
        for kind in spec.files:
            path = folder / file_of(rate, one, kind)
            files.folder(path.parent)
            write = {"mat": _save_matlab, "parquet": _save_parquet}[kind]
            files.whole(
                path,
                lambda part, write=write, rate=rate, values=values: write(part, one, rate, values),
            )
        if rate == max(spec.rates):
            label = _label(one, spec, run, values)
    files.text(where / LABEL, json.dumps(label, indent=2))
    if not keep:
        (where / run_record.NAME).unlink()
        (where / "restart").unlink(missing_ok=True)


def _save_matlab(path, one, rate, values):
    with open(path, "wb") as file:  # savemat would append .mat to a name
        io.savemat(file, _matlab(one, rate, values), oned_as="column", do_compression=True)


def _save_parquet(path, one, rate, values):
    table = pd.DataFrame({"time_s": np.arange(len(values)) / rate, "acceleration_m_s2": values})
    table.to_parquet(path, engine="pyarrow", index=False)


def _matlab(one: Record, rate: int, values: np.ndarray) -> Mapping[str, Any]:
    """Return the variables of a .mat file.

    `X001_DE_time` and `X001RPM` have the names that Case Western Reserve University uses for the
    drive end; the other variables describe the record.
    """
    stem = f"X{one.number:03d}"
    return {
        f"{stem}_DE_time": values,
        f"{stem}RPM": np.array([[one.rpm]]),
        "fault": one.labels["flaw"],
        "fault_size_m": np.array([[_size(one)]]),
        "load_N": np.array([[float(one.labels["load"])]]),
        "sampling_Hz": np.array([[float(rate)]]),
        "unit": "m/s^2",
    }


def _size(one):
    """Return the length of a notch or the amplitude of waves in m, or 0 if there is no flaw."""
    return float(one.labels.get("length", one.labels.get("amplitude", 0.0)))


def _label(one: Record, spec: Spec, run: Run, values: np.ndarray) -> dict[str, Any]:
    """Return a row of labels.csv."""
    places = spectrum.places(run, harmonics=1)
    return {
        "record": one.point.name,
        "class": one.labels["flaw"],
        "size_m": _size(one),
        **{f"flaw_{name}": one.labels.get(name) for name in FLAW_WORDS},
        **{name: value for name, value in one.labels.items() if name not in (*FLAW_WORDS, "flaw")},
        "words_inner": one.point.variables.get("flaw_inner", "none"),
        "words_outer": one.point.variables.get("flaw_outer", "none"),
        "words_ball": one.point.variables.get("flaw_ball", "none"),
        "flawed_ball": one.point.variables.get("flawed_ball"),
        "phase_rad": float(one.point.variables["phase"]),
        "cage_order": places["FTF", 1][0],
        **{f"{line}_Hz": places[line, 1][1] for line in ("FTF", "BPFO", "BPFI", "BSF")},
        "rms_m_s2": float(np.std(values)),
        "peak_m_s2": float(np.abs(values - values.mean()).max()),
        "kurtosis": float(stats.kurtosis(values, fisher=False)),
        **{f"file_{rate // 1000}k": file_of(rate, one, spec.files[0]) for rate in spec.rates},
    }


def _labels(wanted: Sequence[Record], spec: Spec, folder: Path) -> pd.DataFrame:
    """Write labels.csv and the card for the existing records, and return the table."""
    rows = [
        mapping(folder / "runs" / one.point.name / LABEL, json.loads)
        for one in wanted
        if _whole(folder, one, spec)
    ]
    table = pd.DataFrame(rows)
    files.whole(folder / LABELS, lambda part: table.to_csv(part, index=False))
    text = card(spec, table, len(wanted))
    files.text(folder / "README.md", text)
    return table
