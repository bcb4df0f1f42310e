# SPDX-License-Identifier: GPL-2.0-or-later
"""Tests of spall lengths: closed-form solutions for the flight of the ball, and detection of entry
and impact in synthetic signals of known length."""

import numpy as np
import pytest
import raceway as package
import synthetic
from raceway import hertz, kinematics, passages, spall, static
from raceway.errors import RunError
from raceway.theory.bearing import INNER, OUTER

SPIN, LOAD = 1500 * np.pi / 30, 2000.0
SAMPLE, PERIOD = 5e-6, 11.2e-3  # s
ROLLING = 7.6e-3  # m
HEAVY = 1e6  # kg, heavy enough that the ring does not follow the ball


@pytest.mark.parametrize("raceway", [INNER, OUTER])
def test_a_ball_that_keeps_its_load_strikes_half_way(bearing, raceway):
    lengths = np.array([0.2e-3, 0.5e-3])
    late = spall.seconds_to_blow(bearing, raceway, lengths, SPIN, LOAD, 0.2)
    assert kinematics.spall_length(bearing, SPIN, late) == pytest.approx(lengths, rel=1e-12)


@pytest.mark.parametrize("raceway", [INNER, OUTER])
def test_a_rounded_edge_is_heard_sooner(bearing, raceway):
    """A ball that keeps its load begins to rise half-way, or earlier by the radius of the edge. A
    ball that has lost its load flies to the far flank, whose position does not depend on the
    rounding of the edges."""
    edge, both = 5e-5, np.array([0.5e-3, 2.5e-3])
    sharp, rounded = (
        spall.seconds_to_blow(bearing, raceway, both, SPIN, LOAD, 0.2, edge=one)
        for one in (0.0, edge)
    )
    speed = kinematics.entrainment(bearing, SPIN)
    assert (sharp - rounded)[0] * speed == pytest.approx(edge, rel=1e-12)
    assert rounded[1] == pytest.approx(sharp[1], rel=0.01)
    found = spall.length(bearing, raceway, rounded, SPIN, LOAD, 0.2, edge=edge)
    assert found == pytest.approx(both, rel=5e-3)


@pytest.mark.parametrize("raceway", [INNER, OUTER])
def test_flight_of_a_ball_that_loses_its_load(bearing, raceway):
    """If the ring does not follow, and the ball is light enough to be in equilibrium until it
    leaves the raceway, its vertical speed at that moment is a known fraction of the drop rate. The
    centrifugal load curves its path."""
    orbit = SPIN * kinematics.frequencies(bearing).cage
    rest = static.equilibrium(bearing, LOAD, orbital_speed=orbit)
    approach = rest.inner.overlap[0] + rest.outer.overlap[0]
    radii = [bearing.effective_radii(side) for side in (INNER, OUTER)]
    soft = [
        hertz.stiffness(hertz.exact(*one), bearing.effective_modulus) ** (-2 / 3) for one in radii
    ]
    share = soft[1 - raceway] / sum(soft)  # fraction of the drop recovered there
    rolling, speed = radii[raceway][0], kinematics.entrainment(bearing, SPIN)
    lost = np.sqrt(2 * rolling * approach)  # m, measured from the entry
    on = np.linspace(1.3, 2.5, 5) * lost
    curve = (1 if raceway == OUTER else -1) * bearing.pitch_radius * (orbit / speed) ** 2
    drop = approach + share * lost / rolling * (on - lost) + 0.5 * curve * (on - lost) ** 2
    lengths = on + np.sqrt(2 * rolling * drop)
    found = spall.seconds_to_blow(bearing, raceway, lengths, SPIN, LOAD, HEAVY) * speed
    assert found == pytest.approx(on, rel=0.02)
    assert spall.length(bearing, raceway, on / speed, SPIN, LOAD, HEAVY) == pytest.approx(
        lengths, rel=0.01
    )


def test_the_other_ring_hears_it_later(bearing):
    own, other = (
        spall.seconds_to_blow(bearing, OUTER, 2e-3, SPIN, LOAD, 0.2, heard=heard)
        for heard in (OUTER, INNER)
    )
    assert 1.05 * own < other < 1.3 * own


@pytest.mark.parametrize(
    "words, says",
    [
        (dict(lengths=0.0), "lengths 0.0 m"),
        (dict(lengths=0.02), "must be at most 0.0102"),
        (dict(ring_mass=-1.0), "ring_mass -1.0 kg"),
        (dict(edge=-1e-5), "edge -1e-05 m must be from 0 to half the shortest length, 0.0005 m"),
        (dict(edge=6e-4), "edge 0.0006 m"),
    ],
)
def test_mistakes_of_a_spall(bearing, words, says):
    given = {"lengths": 1e-3, "speed": SPIN, "load": LOAD, "ring_mass": 0.2, **words}
    with pytest.raises(ValueError, match=says):
        spall.seconds_to_blow(bearing, OUTER, **given)


def test_times_of_no_spall(bearing):
    found = spall.length(bearing, OUTER, [np.nan, -1e-4, 0.0, 1.0], SPIN, LOAD, 0.2)
    assert np.isnan(found).all()


def path(length, speed=2.3, periods=6):
    """Return (time in s, drop of the centre of a rigid ball in m) for a spall with sharp edges that
    is passed once per period."""
    time = np.arange(int(periods * PERIOD / SAMPLE)) * SAMPLE
    way = speed * ((time - 0.123 * PERIOD) % PERIOD - 0.5 * PERIOD)
    return time, np.maximum(0.5 * length - np.abs(way), 0.0) ** 2 / (2 * ROLLING)


@pytest.mark.parametrize("length", [0.5e-3, 1e-3, 2e-3])
@pytest.mark.parametrize("noise", [0.0, 2e-4])
def test_known_length(length, noise):
    """With sharp edges and noise of 2e-4 of the drop, the length found is accurate to 1 % plus half
    the distance that corresponds to one sample at the impact."""
    _, drop = path(length)
    random = np.random.default_rng(1)
    values = 3.0 - drop / drop.max() + noise * random.normal(size=len(drop))
    found = passages.find(values, SAMPLE, PERIOD)
    assert len(found.entry) >= 4 and np.diff(found.blow) == pytest.approx(PERIOD, rel=2e-3)
    assert np.median(2 * 2.3 * found.seconds) == pytest.approx(
        length, abs=0.01 * length + 2.3 * SAMPLE
    )


@pytest.mark.parametrize("share, error", [(0.5, 0.04), (0.2, 0.02)])
def test_a_housing_that_rings(share, error):
    """The drop acts as a force on a mass on a spring (4 kHz, 4 % damping), which distorts the
    square root."""
    from scipy import signal

    _, drop = path(1e-3)
    omega = 2 * np.pi * 4000
    system = signal.StateSpace(
        *([[0, 1], [-(omega**2), -0.08 * omega]], [[0], [1]]),
        *([[-(omega**2), -0.08 * omega]], [[1]]),
    )
    _, heard, _ = signal.lsim(system, -drop / drop.max(), np.arange(len(drop)) * SAMPLE)
    found = passages.find(heard, SAMPLE, PERIOD, share=share)
    assert len(found.entry) >= 4
    assert np.median(2 * 2.3 * found.seconds) == pytest.approx(1e-3, rel=error)


def test_no_blow_no_passage():
    time, _ = path(1e-3)
    assert len(passages.find(np.sin(2 * np.pi * 90 * time), SAMPLE, PERIOD).entry) == 0
    noise = np.random.default_rng(2).normal(size=len(time))
    assert len(passages.find(noise, SAMPLE, PERIOD).entry) == 0


def test_strong_ones():
    _, drop = path(1e-3)
    values = drop * np.where(np.arange(len(drop)) * SAMPLE < 3.1 * PERIOD, 1.0, 0.3)
    found = passages.find(values, SAMPLE, PERIOD)
    assert 0 < len(found.strong.entry) < len(found.entry)
    assert (found.strong.blow < 3.1 * PERIOD).all()


@pytest.mark.parametrize(
    "words, says",
    [
        (dict(period_s=1e-4), "reach 5e-05 s must be from 16 samples"),
        (dict(reach_s=6e-3), "to half a period"),
        (dict(period_s=1.0, reach_s=1e-3), "must cover a period of 1 s"),
        (dict(share=1.0), "share is 1"),
    ],
)
def test_mistakes_of_a_signal(words, says):
    with pytest.raises(ValueError, match=says):
        passages.find(**{"values": path(1e-3)[1], "sample_s": SAMPLE, "period_s": PERIOD, **words})


def test_a_shaft_that_stands_still(tmp_path, lubricated):
    rings = [[*row[:8], 0.0, *row[9:]] for row in lubricated["rings"]]
    run = package.open(synthetic.write(tmp_path, dict(lubricated, rings=rings)))
    with pytest.raises(RunError, match="there are no ball passages, because the shaft is at rest"):
        passages.of_run(run, "outer", "vy", "inner")
