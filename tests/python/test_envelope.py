# SPDX-License-Identifier: GPL-2.0-or-later
"""Tests of envelopes of synthetic signals in which impacts at a known rate excite a known frequency
in noise."""

import numpy as np
import pytest
import raceway
import synthetic
import xarray as xr
from commands import answer, reply
from raceway import envelope, kinematics, spectrum
from raceway.errors import RunError

RATE = 48e3
RING = 7e3  # Hz
TIME = np.arange(2 * int(RATE)) / RATE


def blows(hertz, carrier=None, depth=0.0, loud=1.0):
    """Return a signal (N,) with `hertz` decaying 7 kHz bursts per second, whose amplitudes are
    modulated at `carrier` Hz."""
    total = np.zeros(len(TIME))
    for when in np.arange(0.3 / hertz, TIME[-1], 1 / hertz):
        size = loud * (1 + depth * np.cos(2 * np.pi * carrier * when)) if carrier else loud
        since = TIME - when
        first = int(np.ceil(when * RATE))
        last = min(first + 400, len(TIME))
        s = since[first:last]
        total[first:last] += size * np.exp(-2e3 * s) * np.sin(2 * np.pi * RING * s)
    return total


@pytest.fixture(scope="module")
def noisy():
    """Return a signal with impacts at 107.3 Hz, hum with ten times their amplitude and noise with
    half their amplitude."""
    noise = np.random.default_rng(3).normal(0, 0.5, len(TIME))
    return blows(107.3) + 10 * np.sin(2 * np.pi * 50 * TIME) + noise


def test_the_band_is_where_it_rings(noisy):
    found = envelope.best_band(xr.DataArray(noisy, dims="time"), 1 / RATE, narrowest=400)
    assert found == envelope.best_band(noisy, 1 / RATE, narrowest=400)
    low, high, kurtosis = found
    assert low < RING < high and high - low >= 400
    assert kurtosis > 10 * 2 / np.sqrt(len(TIME) * (high - low) / RATE)  # 10 times that of noise


def test_rate_of_the_blows(noisy):
    """Without noise, the rate is accurate to a thousandth of the resolution, which is 0.5 Hz; with
    noise, it is accurate to a few hundredths."""
    band = envelope.best_band(noisy, 1 / RATE, narrowest=400)
    one = spectrum.spectrum(envelope.of_values(noisy, 1 / RATE, *band[:2]), 1 / RATE)
    found = spectrum.find(one, 107.3)
    assert found[-1] == "" and found[0] == pytest.approx(107.3, abs=0.05)
    plain = spectrum.spectrum(noisy, 1 / RATE)
    assert spectrum.find(plain, 107.3)[-1] != ""


def test_sidebands_of_what_modulates():
    """A modulation 1 + d cos causes sidebands whose amplitude is d/2 times that of the line between
    them."""
    signal = blows(160.0, carrier=25.0, depth=0.6)
    one = spectrum.spectrum(envelope.of_values(signal, 1 / RATE, 5e3, 9e3), 1 / RATE)
    middle, below, above = (spectrum.find(one, hertz) for hertz in (160.0, 135.0, 185.0))
    for side in (below, above):
        assert side[-1] == "" and side[2] / middle[2] == pytest.approx(0.3, rel=0.05)


def test_noise_is_not_impulsive():
    """The kurtosis of N noise values scatters by 2/sqrt(N) and never reaches five times this
    value."""
    noise = np.random.default_rng(4).normal(size=len(TIME))
    for band in envelope.bands(noise, 1 / RATE):
        count = len(TIME) * (band.high - band.low) / RATE
        assert abs(band.kurtosis) < 10 / np.sqrt(count), band


def test_mistakes():
    with pytest.raises(ValueError, match="band 30000 to 40000 Hz must lie between 0 and 24000 Hz"):
        envelope.of_values(TIME, 1 / RATE, 3e4, 4e4)
    with pytest.raises(ValueError, match="100 values, .* too few to find a band"):
        envelope.best_band(TIME[:100], 1 / RATE)
    with pytest.raises(ValueError, match="band 4000 to 3000 Hz: the first must be below"):
        envelope.of_values(TIME, 1 / RATE, 4e3, 3e3)
    for value in (0.0, 5.1):
        with pytest.raises(ValueError, match="the signal is constant"):
            envelope.best_band(np.full(len(TIME), value), 1 / RATE)


@pytest.fixture(scope="module")
def struck(tmp_path_factory, lubricated, bearing):
    """Return a run whose ring vibrates at a third of the sampling rate. The vibration is excited at
    the ball pass frequency of the inner raceway, with an amplitude that depends on the shaft
    angle."""
    step, shaft = lubricated["settings"]["sample_s"] / 4, 477.5 / 60
    order = kinematics.frequencies(bearing).inner
    time = np.arange(1, 60 * 96 + 1) * step
    phase = (time * shaft * order) % 1 / (shaft * order)  # s since the last impact
    loud = 1 + 0.5 * np.cos(2 * np.pi * shaft * time)
    ring = 1e-7 * loud * np.exp(-phase / (8 * step)) * np.sin(2 * np.pi * phase / (3 * step))
    folder = tmp_path_factory.mktemp("struck") / "run"
    settings = dict(passes=60, samples_per_pass=96, sample_s=step)
    return synthetic.shaken(folder, lubricated, time, 0, -35e-6 - ring, 50.0, **settings)


def test_of_a_run(struck):
    run = raceway.open(struck)
    nyquist = 0.5 / run.settings["sample_s"]
    one = envelope.of_run(run, "y", (0.5 * nyquist, 0.9 * nyquist))
    assert one.attrs["units"] == "m" and one.attrs["long_name"].startswith("envelope of: ")
    found = {(line.name, line.harmonic): line for line in spectrum.lines(run, one, sidebands=True)}
    assert {"BPFI+shaft", "BPFI-shaft", "BSF+FTF", "BSF-FTF"} <= {name for name, _ in found}
    for name in ("BPFI", "BPFI+shaft", "BPFI-shaft"):
        assert found[name, 1].note == "" and abs(found[name, 1].difference) < 2e-3
    assert found["BPFO", 1].note and found["BSF", 2].note
    with pytest.raises(RunError, match="record.nc: band 1 to"):
        envelope.of_run(run, "y", (1.0, 10 * nyquist))


def test_command(struck, capsys, tmp_path):
    words = ["spectrum", str(struck), "--signal", "y", "--envelope"]
    said = reply(capsys, [*words, "--out", tmp_path / "x.png"]).splitlines()
    assert said[0].startswith("envelope of: ") and said[1].startswith("band ")
    assert (tmp_path / "x.png").stat().st_size > 10_000
    assert "BPFI-shaft" in {line["name"] for line in answer(capsys, words)}
    assert "--band applies to an envelope" in reply(
        capsys, ["spectrum", struck, "--band", "10", "20"], code=2
    )
