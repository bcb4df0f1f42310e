# SPDX-License-Identifier: GPL-2.0-or-later
"""Compare the vibration of a perfect bearing with that of a bearing with a waviness of 0.01 um on
its inner raceway, both with the integrator `vibration`, and write build/bench/noise_floor.rst.

    .venv/bin/python tests/bench/noise_floor.py [--print]     --print: do not write the page

The exit code is 1 if the amplitude of the perfect bearing exceeds a tenth of the line that the
waviness causes.
"""

import sys
import tempfile
from pathlib import Path

import numpy as np
from deck_runs import MAIN, succeed
from machine import csv_table, publish
from raceway import sensor, spectrum
from raceway.runs.run import Run

SCENE = dict(bearing=6205, load=500, rpm=1797, lubricant="vg46", passes=80, settle=10)
MODE = dict(integrator="vibration", housing="springs", record="summary")
RATE = 48e3  # Hz
BAND = (20.0, 0.4 * RATE)  # Hz, frequency range in which the noise floor is determined
WAVE = 1e-8  # m
# {number Z - 1 or Z + 1 of waves on the inner raceway: shaft order to add to BPFI}
WAVES = {8: -1, 10: 1}
ENDS = 100  # number of samples at each end that the filter distorts
PAGE = """\
A perfect bearing is not silent: its stiffness varies as balls pass, at BPFO and its harmonics. All
other lines in its spectrum are numerical noise. Here this noise is compared with the lines of a
bearing with waves of {wave:g} µm on its inner raceway. The bearing is a 6205 at {rpm} rpm under
{load} N with VG 46. Signals are sampled at {rate:g} kHz, with ``-var integrator vibration`` and
``-var housing springs``. The record is {seconds:.2f} s long.

Accelerations of the perfect bearing along the load, in m/s²:

{perfect}

* *rms*: root mean square of the whole signal, nearly all of which is at BPFO and its harmonics.
* *median*: median amplitude between {low:g} Hz and {high:g} kHz, i.e. the noise floor for a
  line.

Lines caused by waves on the inner raceway, in m/s², and the amplitude of the perfect bearing at the
same frequency:

{waves}

Waves of order :math:`Z - 1` cause a line at BPFI - shaft, and waves of order :math:`Z + 1` a line
at BPFI + shaft. The acceleration of the housing is small at these lines, because the housing is a
mass of 2 kg on stiff springs that is excited only by the inertia of the inner ring.
"""


def run(folder, **words):
    """Run the scene with additional variables, and return the `Run`."""
    succeed(MAIN, out=folder, timeout=1200, **SCENE, **MODE, **words)
    return Run(folder)


def of_ring(run, ring):
    """Return (spectrum of a ring's acceleration along the load in m/s^2, rms of the
    acceleration)."""
    heard = sensor.of_run(run, "ay", ring, RATE).to_numpy()[ENDS:-ENDS]
    return spectrum.spectrum(heard, 1 / RATE), float(heard.std())


def line(found, run, shift):
    """Return the amplitude (m/s^2) at BPFI plus `shift` times the shaft frequency. BPFI follows
    from the cage speed of the run."""
    order, hertz = spectrum.places(run, harmonics=1)["BPFI", 1]
    hertz += shift * hertz / order
    return float(found.sel(frequency=hertz, method="nearest"))


def main() -> int:
    """Compute the results and write the page."""
    with tempfile.TemporaryDirectory() as place:
        perfect = run(Path(place) / "perfect")
        wavy = {
            order: run(Path(place) / str(order), flaw_inner=f"wave {order} {WAVE} 0")
            for order in WAVES
        }
        still, waves, shares = [], [], []
        for ring, name in (("inner", "inner ring"), ("outer", "housing")):
            quiet, rms = of_ring(perfect, ring)
            inside = quiet.sel(frequency=slice(*BAND))
            still.append([name, *(f"{v:.2g}" for v in (rms, float(np.median(inside))))])
            for order, shift in WAVES.items():
                loud = line(of_ring(wavy[order], ring)[0], wavy[order], shift)
                floor = line(quiet, perfect, shift)
                shares.append(floor / loud)
                where = f"BPFI {'+' if shift > 0 else '-'} shaft"
                waves.append(
                    [name, str(order), where, f"{loud:.2g}", f"{floor:.2g}", f"{loud / floor:.0f}"]
                )
        seconds = perfect.rings.sizes["time"] * perfect.settings["sample_s"]
    publish(
        "Noise floor of vibration",
        PAGE,
        wave=1e6 * WAVE,
        rpm=SCENE["rpm"],
        load=SCENE["load"],
        rate=RATE / 1e3,
        seconds=seconds,
        low=BAND[0],
        high=BAND[1] / 1e3,
        perfect=csv_table(["acceleration of", "rms", "median"], still),
        waves=csv_table(["acceleration of", "order", "line", "waves", "perfect", "ratio"], waves),
    )
    return max(shares) > 0.1


if __name__ == "__main__":
    sys.exit(main())
