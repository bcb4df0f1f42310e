# SPDX-License-Identifier: GPL-2.0-or-later
"""Compute the expected results of runs from kinematics and from the static solver, which is written
independently of the C++ code."""

import numpy as np
from raceway import hertz, kinematics, static
from raceway.theory.bearing import INNER, OUTER


def shaft_speed(settings):
    """Return the shaft speed in rad/s."""
    return settings["rpm"] * np.pi / 30


def equilibrium(run, sample, film=None):
    """Return the static equilibrium for the ball positions in a sample of the run. If `film`, a
    `FilmInGap`, is given, the equilibrium includes the film in the gap."""
    settings, balls = run.settings, run.balls
    now = balls[(balls["sample"] == sample) & (balls["type"] == 1)].sort_values("id")
    orbit = kinematics.frequencies(run.geometry).cage * shaft_speed(settings)
    return static.equilibrium(
        run.geometry,
        settings["load_N"],
        clearance=settings["clearance_m"],
        load_azimuth=settings["load_azimuth_rad"],
        finite_shift=True,
        orbital_speed=orbit,
        phase=np.arctan2(now["y"], now["x"]).to_numpy(),
        film=film,
    )


def ball_loads(run, samples, sides=(INNER, OUTER)):
    """Yield (loads in the run, loads in statics) of the nine balls on each raceway in the samples,
    in N."""
    for sample in samples:
        state = equilibrium(run, sample)
        rows = run.contacts[run.contacts["sample"] == sample]
        for side in sides:
            found = rows[rows["raceway"] == side].set_index("ball")["load"]
            theory = state.inner if side == INNER else state.outer
            yield found.reindex(range(1, 10)).fillna(0).to_numpy(), theory.load


def _all(run):
    samples = sorted(run.contacts["sample"].unique())
    return [equilibrium(run, sample) for sample in samples[::4]]


def static_shift(run, _):
    """Return the mean displacement of the inner ring along the load in m."""
    azimuth = run.settings["load_azimuth_rad"]
    return np.mean(
        [state.shift[0] * np.cos(azimuth) + state.shift[1] * np.sin(azimuth) for state in _all(run)]
    )


def static_largest_load(run, _):
    """Return the largest contact load within a ball pass in N."""
    return max(state.inner.load.max() for state in _all(run))


def cage_speed(run, _):
    """Return the kinematic cage speed in rad/s."""
    return kinematics.frequencies(run.geometry).cage * shaft_speed(run.settings)


def entrainment(run, _):
    """Return the kinematic entrainment speed in m/s."""
    return kinematics.entrainment(run.geometry, shaft_speed(run.settings))


def _pressure(run, side, load):
    bearing = run.geometry
    ellipse = hertz.exact(*bearing.effective_radii(side, 0.0, run.settings["clearance_m"]))
    return hertz.pressure(ellipse, bearing.effective_modulus, load)


def pressure_inner(run, summary):
    """Return the Hertz pressure in Pa at the largest load on the inner raceway."""
    return _pressure(run, INNER, summary["q_inner_max_N"])


def pressure_outer(run, summary):
    """Return the Hertz pressure in Pa at the largest load on the outer raceway."""
    return _pressure(run, OUTER, summary["q_outer_max_N"])
