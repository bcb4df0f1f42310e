# SPDX-License-Identifier: GPL-2.0-or-later
"""The sampling rates and the filter of a sensor are tested with signals of known response."""

import math

import numpy as np
import pytest
import raceway
import synthetic
from raceway import sensor

RATE = 192e3
TIME = np.arange(38400) / RATE


@pytest.mark.parametrize("rate", [11999.3, 12e3, 25.6e3, 47999.37, 48e3, 96e3, 96001.7, 191e3])
def test_passes_what_the_rate_holds(rate):
    """Amplitude and phase are preserved to 1e-4, and components that would alias are attenuated by
    80 dB."""
    inside = slice(60, -60)
    for share in (0.02, 0.2, 0.4):
        kept = sensor.decimated(np.sin(2 * np.pi * share * rate * TIME), 1 / RATE, rate)
        assert len(kept) == math.ceil(len(TIME) * rate / RATE)
        want = np.sin(2 * np.pi * share * np.arange(len(kept)))
        assert np.abs(kept - want)[inside].max() < 2e-4
    for share in (0.51, 0.6, 0.95):
        if share * rate < RATE / 2:
            gone = sensor.decimated(np.sin(2 * np.pi * share * rate * TIME), 1 / RATE, rate)
            assert np.abs(gone)[inside].max() < 2e-4


def test_leaves_a_mean_alone():
    assert sensor.decimated(np.full(4000, 7.0), 1 / RATE, 48e3) == pytest.approx(7.0, abs=1e-12)
    values = np.random.default_rng(1).normal(size=100)
    assert np.array_equal(sensor.decimated(values, 1 / RATE, RATE), values)


@pytest.mark.parametrize(
    "rate, says",
    [
        (2e5, "rate 200000 Hz must lie between 0 and 192000 Hz"),
        (0, "must lie between 0"),
        (
            100,
            "rate 100 Hz leaves 20 values of 0.2 s, fewer than the 50 at which the filter starts",
        ),
    ],
)
def test_rates_that_it_refuses(rate, says):
    with pytest.raises(ValueError, match=says):
        sensor.decimated(TIME, 1 / RATE, rate)


@pytest.fixture
def run(tmp_path, lubricated):
    synthetic.write(tmp_path, lubricated)
    return raceway.open(tmp_path)


def test_noise_is_of_its_seed(run):
    quiet = sensor.of_run(run, "fy", "inner")
    one, two, other = (sensor.of_run(run, "fy", "inner", noise=0.5, seed=k) for k in (1, 1, 2))
    assert np.array_equal(one, two) and not np.array_equal(one, other)
    assert 0.3 < float((one - quiet).std()) < 0.7
    assert quiet.attrs["units"] == "N" and quiet.attrs["sample_s"] == run.settings["sample_s"]
