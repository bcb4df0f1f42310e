# SPDX-License-Identifier: GPL-2.0-or-later
"""Run `in.shaft`, a shaft on two 6208s, and provide the functions that its tests share.

The shaft lies along z, with bearings at 0 and 0.2 m. The `data` of a run have columns for the shaft
(x, rx, ...) and for its rings (x1, f2y, ...).
"""

import re

import numpy as np
import xarray
from host import box, columns, deck_file, succeed

DECK = "tests/scenarios/in.shaft"
TILTING = "x free y free rx free ry free spin speed"


def data_of(folder):
    return columns(folder / "shaft.dat")


def swing(folder, **variables):
    """Run the deck, and return the columns keyed by name and the energies in J keyed by name."""
    text = succeed(DECK, out=folder, **variables).text
    names = ("work", "dissipated", "stored", "lost")
    numbers = numbers_of(text, "ENERGY") if "\nENERGY " in text else [np.nan] * 4
    return data_of(folder), dict(zip(names, numbers, strict=True))


def numbers_of(text, word="END"):
    """Return the numbers that a run prints after `word`."""
    return [float(one) for one in re.search(rf"^{word} (.*)$", text, re.M)[1].split()]


def rows_of(folder):
    """Return the lines of the table that a run has written."""
    return (folder / "shaft.dat").read_text().splitlines()


def frequencies_of(signals, step, count):
    """Return the frequencies in Hz, in ascending order, of `count` free vibrations in `signals`
    (channels, samples). A linear map from each instant to the next, fitted to delayed copies of the
    signals, determines the frequencies. A real vibration has two frequencies, one of which is
    negative. For x + i y, the negative frequencies are those of backward whirl."""
    copies, length = 12, signals.shape[1]
    signals = signals - signals.mean(axis=1, keepdims=True)
    delayed = np.vstack([signals[:, k : length - copies + k] for k in range(copies)])
    main = np.linalg.svd(delayed, full_matrices=False)[2][:count]
    forward = main[:, 1:] @ np.linalg.pinv(main[:, :-1])
    return np.sort(np.log(np.linalg.eigvals(forward)).imag / step) / (2 * np.pi)


def rings_follow(folder):
    """Check that the accelerations of the inner rings in a record are derivatives of their
    velocities, and return the columns (samples, 2) for both rings, keyed by name."""
    with xarray.open_dataset(folder / "record.nc") as record:
        inner = record["ring_raceway"].values == 0
        names = ("x", "y", "tilt_2", "vx", "ax")
        ring = {name: record[f"ring_{name}"].values[:, inner] for name in names}
        time = record["time"].values
    slope = (ring["vx"][2:] - ring["vx"][:-2]) / (time[2:] - time[:-2])[:, None]
    # velocities are linear within an internal step, and every sample has a separate internal step
    apart = np.median(np.abs(ring["ax"][1:-1] - slope), axis=0)
    assert slope.shape[1] == 2 and np.all(apart < 2e-2 * np.abs(slope).max(axis=0))
    return ring


# variables for comparing ranks and hosts, in which all parts move
BITS = dict(
    cage=1,
    speed=200,
    second=0.2,
    law="friction constant 0.05",
    freedoms=f"{TILTING} 200 z free",
    clearance=1e-5,
    skin=4e-4,
    control="tolerance 1e-8",
)
# variables for runs that output an energy balance
ENERGY = dict(
    control="tolerance 1e-10 largest 2e-6 energy yes",
    clearance=1e-5,
    speed=200,
    law="friction constant 0.05",
    steps=80,
    every=80,
)
WITHIN = dict(
    control="tolerance 1e-11 largest 5e-6", freedoms=f"{TILTING} 200", steps=40, within=10
)


# a box with two bearings whose axes are along x, without a fix that moves them
SMALL = f"""{box("-0.03 0.23 -0.06 0.06 -0.06 0.06")}
pair_style bearing/hertz axis x friction none
pair_coeff 1 3 inner 24.0e-3 6.552e-3
pair_coeff 1 4 outer 37.1e-3 6.552e-3
create_bearing 1 none 3 4 balls 9 diameter 12.6e-3 speed 0 0
create_bearing 1 none 3 4 balls 9 diameter 12.6e-3 speed 0 0 centre 0.2 OFF 0
group balls type 1
group inner type 3
"""


def small_deck(tmp_path, text, off="0"):
    """Return a deck of the box with `text` after it."""
    return deck_file(tmp_path, SMALL.replace("OFF", off) + text)


def small(tmp_path, text):
    return succeed(small_deck(tmp_path, text))
