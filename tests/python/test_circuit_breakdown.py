# SPDX-License-Identifier: GPL-2.0-or-later
"""Tests of the breakdown of films in a circuit: redistribution of charges, thresholds and
events."""

import dataclasses
import warnings

import numpy as np
import pytest
from circuits import MOTOR, PICO, WEAK, steady, turning
from raceway import core
from raceway.electric import circuit
from raceway.electric.breakdown import ROW, Breakdown
from raceway.electric.films import series
from raceway.electric.outer import Floating, Source
from raceway.electric.waveforms import Constant
from raceway.errors import RunWarning


def redistribute(capacitance, outer, ball_charge, ring_charge, broken):
    """Return the voltages of the balls and the voltage of the ring; `outer` is (parallel, coupling,
    driving)."""
    ball, ring = np.empty(len(ball_charge)), np.empty(1)
    core.library().call(
        "film_redistribution",
        balls=len(ball),
        capacitance=capacitance,
        **dict(zip(("beside", "coupling", "driving"), outer)),
        ball_charge=ball_charge,
        ring_charge=ring_charge,
        broken=broken,
        ball=ball,
        ring=ring,
    )
    return ball, ring[0]


def test_a_film_that_fails_by_hand():
    """At 10 V on two balls, only the inner film of ball 1 fails; its outer film remains intact."""
    thickness = np.array([[100e-9, 400e-9], [500e-9, 400e-9]])
    given = steady([20 * PICO, 60 * PICO], [30 * PICO, 60 * PICO], thickness=thickness)
    result = circuit.run(given, Floating(10.0, 10 * PICO), Breakdown(50e6))
    (event,) = result.events.itertuples()
    # two balls of 12 and 30 pF and 10 pF in parallel hold a charge of 520 pC on the ring
    assert (event.ball, event.raceway, event.order) == (1, "inner", 1)
    assert event.film_voltage == pytest.approx(6.0)  # the breakdown voltage is 5 V
    assert event.bearing_voltage_after == pytest.approx(520 / (30 + 30 + 10))
    assert event.film_energy == pytest.approx(0.5 * 20 * PICO * 36)
    before, after = 0.5 * 52 * PICO * 100, 0.5 * 520**2 / 70 * PICO
    assert event.energy == pytest.approx(before - after)
    end = result.data.isel(time=-1)
    np.testing.assert_allclose(end.film_voltage[:, 0], [0, 520 / 70], atol=1e-14)
    np.testing.assert_allclose(end.ball_charge, [30 * PICO * 520 / 70, 0], atol=1e-24)


def test_the_second_film_follows_and_discharges_the_bearing():
    thickness = np.array([[100e-9, 400e-9], [130e-9, 400e-9]])
    given = steady([20 * PICO, 60 * PICO], [30 * PICO, 60 * PICO], thickness=thickness)
    result = circuit.run(given, Floating(10.0), Breakdown(50e6))
    assert result.events.raceway.tolist() == ["inner", "outer"]
    assert result.events.order.tolist() == [1, 2] and result.events.discharge.tolist() == [1, 1]
    assert result.events.bearing_voltage_after.iloc[-1] == 0
    assert result.events.energy.sum() == pytest.approx(0.5 * 42 * PICO * 100)
    assert not result.data.ball_voltage.any() and not result.data.bearing_voltage.any()


def test_other_balls_keep_their_charge():
    """If an earlier discharge charged a ball, the ball stays charged when another ball shorts the
    rings."""
    capacitance = np.array([[20.0, 60.0], [30.0, 60.0]]) * PICO
    limit = np.array([[1.0, 99.0], [2.0, 99.0]])
    charge = np.array([0.0, 120 * PICO])
    none = np.zeros((2, 2), bool)
    ball, ring = redistribute(capacitance, (0.0, 0.0, 0.0), charge, 420 * PICO, none)
    rows, work = np.empty((4, len(ROW))), np.empty(1)
    left, on_ring, ring = charge.copy(), np.array([420 * PICO]), np.array([ring])
    count = core.library().call(
        "film_discharge",
        balls=2,
        capacitance=capacitance,
        limit=limit,
        beside=0.0,
        coupling=0.0,
        driving=0.0,
        ball_charge=left,
        ring_charge=on_ring,
        ball=ball,
        ring=ring,
        work=work,
        failures=rows,
    )
    assert count == 2 and rows[:2, ROW.index("ball")].tolist() == [0, 0] and work[0] == 0
    assert left.tolist() == [0, charge[1]] and ring[0] == 0
    assert ball.tolist() == [0, 1.0]
    assert on_ring[0] == pytest.approx(-60 * PICO)


@pytest.mark.parametrize("seed", range(6))
def test_charges_redistribute_as_a_network_of_conductors(seed):
    """The result equals that of a dense system of equations whose unknowns include the charge
    through every broken film."""
    rng = np.random.default_rng(seed)
    z = 5
    capacitance, charge = rng.uniform(10, 90, (2, z)) * PICO, rng.normal(0, 100, z) * PICO
    broken = np.zeros((2, z), bool)
    broken[rng.integers(0, 2, 3), [0, 2, 3]] = True
    (beside, coupling, driving), ring_charge = (70 * PICO, 40 * PICO, 200.0), 500 * PICO
    ball, ring = redistribute(capacitance, (beside, coupling, driving), charge, ring_charge, broken)
    inner, outer = capacitance / PICO
    places = np.argwhere(broken)
    matrix = np.zeros((z + 1 + len(places),) * 2)
    matrix[range(z), range(z)] = inner + outer
    matrix[:z, z] = matrix[z, :z] = -inner
    matrix[z, z] = inner.sum() + (beside + coupling) / PICO
    for row, (side, k) in enumerate(places, z + 1):
        matrix[[k, row], [row, k]] = 1  # the charge enters the ball; the film has no voltage
        if side == 0:
            matrix[[z, row], [row, z]] = -1
    right = np.zeros(len(matrix))
    right[: z + 1] = [*charge / PICO, (ring_charge + coupling * driving) / PICO]
    dense = np.linalg.solve(matrix, right)
    np.testing.assert_allclose([*ball, ring], dense[: z + 1], rtol=1e-12, atol=1e-12)


def test_threshold_is_where_it_fails():
    """Just below the threshold voltage computed from the samples, no film fails; just above it, one
    film fails."""
    given = turning()
    least = circuit.run(given, Source(Constant(0.0), 1.0), WEAK).data.threshold_voltage
    share = series(given.capacitance).ball[:, None] / given.capacitance
    np.testing.assert_allclose(least, (30e6 * given.thickness / share).min(axis=(1, 2)), rtol=1e-12)
    # at the first point the source has not yet delivered any charge
    for factor, failures in ((1 - 1e-9, 0), (1 + 1e-9, 1)):
        outer = Source(Constant(float(least[1:].min()) * factor), 1e-9)
        assert bool(len(circuit.run(given, outer, WEAK).events)) == bool(failures)


def test_local_thickness():
    given = steady([PICO], [PICO], thickness=100e-9, roughness=20e-9)
    assert Breakdown(1e6).local_thickness(given)[0, 0, 0] == pytest.approx(40e-9)
    assert Breakdown(1e6, "smooth").local_thickness(given)[0, 0, 0] == 100e-9
    assert Breakdown(1e6, roughness=40e-9).local_thickness(given)[0, 0, 0] == 1e-9
    data = circuit.run(given, Source(Constant(2.0), 1e3), Breakdown(1e9)).data.isel(time=-1)
    assert float(data.field[0, 0]) == pytest.approx(1 / 100e-9)
    assert float(data.local_field[1, 0]) == pytest.approx(1 / 40e-9)


def test_events_have_units_and_places():
    result = circuit.run(turning(), MOTOR, WEAK)
    events = result.events
    assert set(events.attrs["units"]) == set(events)
    assert (np.abs(events.film_voltage) > 30e6 * events.local_thickness * (1 - 1e-12)).all()
    assert (events.energy > 0).all() and (events.film_energy <= events.energy * (1 + 1e-9)).all()
    np.testing.assert_allclose(events.field * events.local_thickness, events.film_voltage)
    for row in events.itertuples():
        at = result.data.sel(time=row.time, ball=row.ball)
        assert float(at.azimuth) == row.azimuth
        assert float(at.film_voltage.sel(raceway=row.raceway)) == pytest.approx(0, abs=1e-12)
    for name, variable in result.data.data_vars.items():
        assert variable.attrs["units"] and variable.attrs["long_name"], name


def test_current_of_a_failure():
    """If the inner film of one ball fails, the film's own capacitance discharges, together with
    that of the outer film in series with the remaining capacitance."""
    inner, outer, rest, arc = 60 * PICO, 40 * PICO, 25 * PICO, 3.0
    given = steady([inner], [outer], thickness=np.array([[[100e-9], [900e-9]]]))
    events = circuit.run(given, Floating(10.0, rest), Breakdown(35e6, "smooth", arc=arc)).events
    one = events.iloc[0]
    assert len(events) == 1 and one.raceway == "inner"
    behind = inner + outer * rest / (outer + rest)
    assert one.film_voltage == pytest.approx(4.0)
    assert one.current == pytest.approx(4.0 / arc)
    assert one.duration == pytest.approx(arc * behind, rel=1e-12)
    assert np.isnan(one.current_density)  # the contact ellipse is unknown
    known = dataclasses.replace(given, hertz_area=np.full(3, 5e-6))
    (density,) = circuit.run(
        known, Floating(10.0, rest), Breakdown(35e6, "smooth", arc=arc)
    ).events.current_density
    assert density == pytest.approx(4.0 / arc / 5e-6)
    plain = circuit.run(given, Floating(10.0, rest), Breakdown(35e6, "smooth")).events
    assert plain[["current", "duration", "current_density"]].isna().all(axis=None)
    with pytest.raises(ValueError, match="arc = 0 ohm must be positive"):
        Breakdown(35e6, arc=0.0)


def test_steps_too_long_for_the_voltage_have_a_warning():
    """If the source charges the bearing within a single step, films fail at the voltage of the
    source instead of their breakdown voltage, and there is a warning."""
    given = turning()
    limit = WEAK.limit(given).min()
    slow = Source(Constant(12 * limit), 1e7)
    stiff = dataclasses.replace(slow, resistance=1e3)
    with pytest.warns(RunWarning, match="fail late, at up to .* times their strength"):
        events = circuit.run(given, stiff, WEAK).events
    assert events.field.abs().max() > circuit.LATE * WEAK.strength
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        assert (
            circuit.run(given, slow, WEAK).events.field.abs().max() < circuit.LATE * WEAK.strength
        )
        assert len(circuit.run(given, Floating(12 * limit), WEAK).events)  # from the first point on
