# SPDX-License-Identifier: GPL-2.0-or-later
"""Run the main deck for every bearing in inputs/bearings that has load ratings, under a radial load
of 0.1 C0 and, if the balls have a contact angle, an equal axial load. Compare the largest ball load
with the result of statics.

    .venv/bin/python tests/bench/all_bearings.py [NAME ...]

This takes a few minutes. The exit code is 1 if a run fails or deviates by more than `WITHIN`.
"""

import sys
import tempfile
from functools import partial
from pathlib import Path

import numpy as np
import raceway
from deck_runs import MAIN, ROOT, attempt
from raceway import inputs, listing, static

WITHIN = 0.01
PHASES = 16  # number of ball positions that are sampled within a ball pass


def run(name, load, axial, out):
    """Return (largest inner contact load (N) within a ball pass, output of the host)."""
    done = attempt(MAIN, bearing=name, load=load, axial=axial, out=out, passes=1)
    if done.returncode:
        return None, done.stdout[-300:]
    return raceway.open(out).summary()["q_inner_max_N"], ""


def expected(path, load, axial):
    """Return the largest inner contact load (N) within a ball pass, computed by statics."""
    bearing = inputs.bearing(path)
    rest = partial(static.equilibrium, bearing, load, axial, finite_shift=True)
    return max(
        rest(phase=phase).inner.load.max()
        for phase in np.arange(PHASES) * 2 * np.pi / (bearing.balls * PHASES)
    )


def main():
    rated = [one for one in listing.entries(ROOT / "inputs") if one.static_load_N]
    names = sys.argv[1:] or [one.name for one in rated]
    off = 0
    with tempfile.TemporaryDirectory() as folder:
        for one in rated:
            if one.name not in names:
                continue
            load = 0.1 * one.static_load_N
            axial = load if one.contact_angle_deg else 0.0
            found, said = run(one.name, load, axial, Path(folder) / one.name)
            wanted = expected(ROOT / "inputs" / "bearings" / one.name, load, axial)
            ratio = found / wanted if found else float("nan")
            good = abs(ratio - 1) <= WITHIN
            off += not good
            figures = f"{load:9.1f} N  {wanted:9.2f} N  run/statics {ratio:.5f}"
            print(f"{one.name:<9}{figures}", flush=True)
            if not good:
                print(said)
    print(f"{off} bearings deviate by more than {WITHIN:g} or failed")
    return off > 0


if __name__ == "__main__":
    sys.exit(main())
