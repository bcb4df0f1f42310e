# SPDX-License-Identifier: GPL-2.0-or-later
"""Runs of `in.shaft`, a shaft on two 6208s, and what their tests share.

The shaft lies along z, its bearings at 0 and 0.2 m. `data` of a run are columns of the shaft (x, rx
...) and of its rings (x1, f2y ...).
"""

import re

import numpy as np
from host import run, succeed
from raceway.theory.bearing import Bearing

DECK = "tests/scenarios/in.shaft"
B6208 = Bearing(9, 12.6e-3, 24.0e-3, 36.6e-3, 6.552e-3, 6.552e-3)
TILTING = "x free y free rx free ry free spin speed"


def data_of(folder):
    file = folder / "shaft.dat"
    names = file.read_text().splitlines()[0].split()[1:]
    return dict(zip(names, np.loadtxt(file, ndmin=2).T, strict=True))


def swing(folder, **variables):
    """(columns, energies in J by name) of a run of the deck."""
    text = succeed(DECK, out=folder, **variables).text
    energy = re.search(r"^ENERGY (.*)$", text, re.M)
    names = ("work", "dissipated", "stored", "lost")
    numbers = map(float, energy[1].split()) if energy else [np.nan] * 4
    return data_of(folder), dict(zip(names, numbers, strict=True))


def frequencies_of(signals, step, modes=4):
    """Hz, rising, of free vibrations (channels, samples): a linear map from each instant to the
    next, from delayed copies."""
    copies, count = 12, signals.shape[1]
    signals = signals - signals.mean(axis=1, keepdims=True)
    delayed = np.vstack([signals[:, k : count - copies + k] for k in range(copies)])
    main = np.linalg.svd(delayed, full_matrices=False)[2][: 2 * modes]
    forward = main[:, 1:] @ np.linalg.pinv(main[:, :-1])
    return np.sort(np.abs(np.log(np.linalg.eigvals(forward)).imag / step))[::2] / (2 * np.pi)


# a box with two bearings along x and nothing that moves them
SMALL = """
units si
bearing_host host host_name
include inputs/modules/host.${host}
atom_modify map array sort 0 0.0
boundary f f f
newton off
region box block -0.03 0.23 -0.06 0.06 -0.06 0.06 units box
create_box 4 box
neighbor 2.0e-3 bin
pair_style bearing/hertz axis x friction none
pair_coeff 1 3 inner 24.0e-3 6.552e-3
pair_coeff 1 4 outer 37.1e-3 6.552e-3
create_bearing 1 none 3 4 balls 9 diameter 12.6e-3 speed 0 0
create_bearing 1 none 3 4 balls 9 diameter 12.6e-3 speed 0 0 centre 0.2 OFF 0
group balls type 1
group inner type 3
"""


def small(tmp_path, text, *, off="0", **variables):
    deck = tmp_path / "in.small"
    deck.write_text(SMALL.replace("OFF", off) + text)
    return run(deck, **variables)
