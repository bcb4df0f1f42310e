# SPDX-License-Identifier: GPL-2.0-or-later
"""The share of clipped samples is compared with the share by which a signal exceeds the limits;
signals that are quantised coarsely, repeat themselves or come to rest are not clipped."""

import math

import numpy as np
import pytest
from commands import answer, reply
from raceway.recordings import clipping
from scipy import signal, special

COUNT = 50000
TIME = np.arange(COUNT) / 12000
NOISE = np.random.default_rng(5).normal(size=COUNT)
SINE = np.sin(2 * np.pi * 137.31 * TIME)
# impacts that excite a resonance, as a flaw does
RINGING = signal.lfilter([1], [1, -1.2, 0.96], (np.arange(COUNT) % 113 == 0) + 0.01 * NOISE)


def quantised(values, bits, full=None):
    """Return the values rounded as by a converter whose range, -`full` to `full`, they may fill."""
    step = (full or np.abs(values).max()) / (2 ** (bits - 1) - 1)
    return step * np.round(values / step)


def synchronous(number):
    """Return a sine with a whole number of samples per period, which repeats its peak exactly."""
    return np.sin(2 * np.pi * np.arange(COUNT) / number)


WHOLE = {
    **{f"sine, {n} bits": quantised(SINE, n) for n in (5, 6, 8, 10, 12, 16)},
    **{f"noise, {n} bits": quantised(NOISE, n) for n in (5, 8, 12, 16)},
    **{f"flaw, {n} bits": quantised(RINGING, n) for n in (5, 8, 12)},
    **{f"slow sine, {n} bits": quantised(np.sin(TIME), n) for n in (5, 8, 12)},
    **{f"sine of {n} samples": synchronous(n) for n in (4, 20, 21, 400)},
    **{f"sine of {n} samples, 8 bits": quantised(synchronous(n), 8) for n in (20, 21, 400)},
    "sine and noise, 8 bits": quantised(SINE + 0.02 * NOISE, 8),
    "sine": SINE,
    "noise": NOISE,
    "ramp": TIME,
    "temperature that becomes steady": np.round(20 + 30 * np.minimum(TIME, 2), 1),
    "pulses of a tachometer": (SINE > 0.9).astype(float),
    "constant": np.ones(100),
}


@pytest.mark.parametrize("name", WHOLE)
def test_signals_that_are_not_clipped(name):
    assert clipping.share(WHOLE[name]) == 0


@pytest.mark.parametrize("bits", [8, 12, 16, None])
@pytest.mark.parametrize("limit", [0.3, 0.6, 0.9])
@pytest.mark.parametrize("sides", [1, 2])
def test_clipped_sine(bits, limit, sides):
    """A sine exceeds the limit c for arccos(c)/pi of the time on each side."""
    cut = np.clip(SINE, -limit if sides == 2 else -1, limit)
    share = clipping.share(cut if bits is None else quantised(cut, bits))
    step = 0 if bits is None else np.abs(cut).max() / 2**bits
    assert share == pytest.approx(sides * math.acos(limit - step) / math.pi, rel=0.02)


@pytest.mark.parametrize("bits", [8, 12, None])
@pytest.mark.parametrize("limit", [1.5, 2.0, 2.5])
def test_clipped_noise(bits, limit):
    """Normal noise exceeds c standard deviations for erfc(c/sqrt 2) of the time."""
    cut = np.clip(NOISE, -limit, limit)
    share = clipping.share(cut if bits is None else quantised(cut, bits))
    step = 0 if bits is None else limit / 2**bits
    assert share == pytest.approx(special.erfc((limit - step) / math.sqrt(2)), rel=0.06)


def test_command(tmp_path, capsys):
    """The share is printed in a warning and as JSON; a signal within its limits has none."""
    signal = SINE + RINGING
    cut = np.minimum(signal, np.quantile(signal, 0.98))
    np.savez(tmp_path / "a.npz", good=signal, bad=cut)
    words = ["measured", str(tmp_path / "a.npz"), "--bearing", "6205", "--rate", "12000"]
    words += ["--rpm", "1797"]
    said = answer(capsys, words)
    good, bad = (one["clipped_share"] for one in said["channels"])
    assert good == 0 and bad == pytest.approx(0.02, rel=1e-3)
    (warning,) = said["warnings"]
    assert warning.startswith("bad is clipped: 0.02 of its values are at a limit of the recorder")
    assert f"Warnings\n  {warning}\n" in reply(capsys, words)
