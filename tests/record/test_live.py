# SPDX-License-Identifier: GPL-2.0-or-later
"""Records of runs that are still active or were killed, and their contents in other programs.

.venv/bin/python tests/record/test_live.py [N]     reads N times while runs are active and kills N
runs
"""

import random
import shutil
import signal
import subprocess
import sys
import tempfile
import time
from pathlib import Path

import numpy as np
import pytest
import raceway
import xarray as xr
from scipy.io import netcdf_file

sys.path.insert(0, str(Path(__file__).resolve().parents[1]))
from host import ENVIRONMENT, HOSTS, QUICK, ROOT, succeed  # noqa: E402

READERS, KILLS = 30, 8
CASE = {"passes": 600, "samples": 100, "within": 5}


def start(folder):
    """Start the main deck for a run of several seconds."""
    words = [HOSTS["liggghts"][0], "-in", "inputs/in.6208", "-log", "none", "-var", "out", folder]
    for name, value in {**QUICK, **CASE}.items():
        words += ["-var", name, str(value)]
    return subprocess.Popen(
        [str(word) for word in words],
        cwd=ROOT,
        env=ENVIRONMENT,
        stdin=subprocess.DEVNULL,
        stdout=subprocess.DEVNULL,
        stderr=subprocess.DEVNULL,
    )


def wait_for(path, process):
    while not path.exists() or path.stat().st_size < 100_000:
        assert process.poll() is None, "the run has ended without a record"
        time.sleep(0.005)


def look(folder):
    """Return the number of complete samples that can be read by xarray alone and by the package."""
    with xr.open_dataset(folder / "record.nc") as data:
        n = data.sizes["time"]
        steps, loads = data["step"].values, data["load"].max(("raceway", "ball")).values
        forces = data["ring_fy"].values[:, 0]
    assert np.allclose(np.diff(steps), 1 / CASE["within"]) and len(loads) == n
    assert (loads > 1500).all() and (np.abs(forces) > 4000).all()
    contacts = raceway.open(folder).contacts
    assert contacts.sizes["time"] >= n
    assert n == 0 or contacts.Q.max("ball").shape == (contacts.sizes["time"], 2)
    return n


def read_while_it_grows(folder, readers):
    """Return the numbers of samples seen by each reader; runs are restarted when they end."""
    seen, process = [], None
    while len(seen) < readers:
        if process is None or process.poll() is not None:
            shutil.rmtree(folder, ignore_errors=True)
            process = start(folder)
            wait_for(folder / "record.nc", process)
            last = 0
        n = look(folder)
        assert n >= last
        last = n
        seen.append(n)
    process.kill()
    process.wait()
    return seen


def kill(folder, whole, dice):
    """Return the number of samples left by a run that was killed at a random time, after checking
    that they equal the samples of a complete run."""
    process = start(folder)
    wait_for(folder / "record.nc", process)
    time.sleep(dice.uniform(0.0, 0.6))
    process.send_signal(signal.SIGKILL)
    process.wait()
    n = look(folder)
    part = xr.load_dataset(folder / "record.nc")
    for name, values in part.variables.items():
        truth = whole.variables[name]
        if "time" in truth.dims:
            truth = truth[:n]
        if name != "finished":
            np.testing.assert_array_equal(values.values, truth.values, err_msg=name)
    shutil.rmtree(folder)
    return n


@pytest.fixture(scope="module")
def whole(tmp_path_factory):
    folder = tmp_path_factory.mktemp("whole")
    succeed("inputs/in.6208", out=folder, **CASE)
    return folder, xr.load_dataset(folder / "record.nc")


def test_readers_of_a_run_that_is_going(tmp_path):
    seen = read_while_it_grows(tmp_path / "run", READERS)
    assert len(seen) == READERS and len({*seen}) > 3


def test_killed(whole, tmp_path):
    dice = random.Random(6208)
    left = [kill(tmp_path / str(k), whole[1], dice) for k in range(KILLS)]
    assert len({*left}) > 2


def test_programs_agree(whole):
    """The record of a run can be read by scipy, the netCDF reference library and its ncdump."""
    import netCDF4  # slow to import

    folder, data = whole
    path = folder / "record.nc"
    with netcdf_file(path, mmap=False) as mine, netCDF4.Dataset(path) as reference:
        assert reference.data_model == "NETCDF3_64BIT_OFFSET"
        assert set(mine.variables) == set(reference.variables) == set(data.variables)
        for name, variable in reference.variables.items():
            wanted = np.ma.filled(variable[...], b"" if variable.dtype == "S1" else np.nan)
            if variable.dtype == "S1":
                continue
            assert np.array_equal(mine.variables[name][...], wanted, equal_nan=True), name
            assert np.array_equal(data[name].values, wanted, equal_nan=True), name
            assert variable.units == data[name].attrs["units"]
    if ncdump := shutil.which("ncdump"):
        said = subprocess.run(
            [ncdump, "-v", "step", path], capture_output=True, text=True, check=True
        ).stdout
        assert f"({data.sizes['time']} currently)" in said
        steps = said.split("step =")[-1].split(";")[0].replace("\n", " ").split(",")
        np.testing.assert_allclose([float(step) for step in steps], data["step"].values)


if __name__ == "__main__":
    number = int(sys.argv[1]) if len(sys.argv) > 1 else 60
    with tempfile.TemporaryDirectory() as name:
        place = Path(name)
        print(f"{len(read_while_it_grows(place / 'run', number))} readers, no bad reads")
        succeed("inputs/in.6208", out=place / "whole", **CASE)
        truth_of_all = xr.load_dataset(place / "whole" / "record.nc")
        moments = random.Random(6208)
        left_by = [kill(place / str(k), truth_of_all, moments) for k in range(number)]
        print(f"{number} kills, each left {min(left_by)} to {max(left_by)} complete samples")
