# SPDX-License-Identifier: GPL-2.0-or-later
"""The bearing in its circuit: closed forms, charge, energy, breakdown."""

import dataclasses

import numpy as np
import pytest
import raceway
from circuits import PICO, films, steady, turning
from raceway.electric import circuit, network
from raceway.electric.breakdown import Breakdown, Node, redistribute
from raceway.electric.films import of_dataset, of_run, series
from raceway.electric.leak import Leak, relaxation_time
from raceway.electric.outer import Floating, Motor, Source
from raceway.electric.waveforms import CommonMode, Constant, Sine, Table, read_table
from raceway.errors import RunError
from scipy.integrate import solve_ivp

MOTOR = Motor(Sine(300.0, 2000.0), 50 * PICO, 1000 * PICO, second=200 * PICO)
WEAK = Breakdown(30e6)


# ---- without breakdown -------------------------------------------------------------------------
def test_a_thick_film_takes_the_voltage():
    """C_i = 2 C_o: V_i = V/3."""
    data = circuit.run(steady([2 * PICO], [PICO]), Source(Constant(6.0))).data
    np.testing.assert_allclose(data.film_voltage[:, 0, 0], 2.0, rtol=1e-15)
    np.testing.assert_allclose(data.film_voltage[:, 1, 0], 4.0, rtol=1e-15)


def test_bearing_voltage_ratio():
    """C_wr 50 pF, C_rf 1 nF, C_b 200 pF twice."""
    outer = Motor(Constant(1.0), 50 * PICO, 1000 * PICO, second_factor=1.0)
    data = circuit.run(steady([100 * PICO] * 4, [100 * PICO] * 4), outer).data
    np.testing.assert_allclose(data.bearing_voltage_ratio, 50 / 1450, rtol=1e-14)
    np.testing.assert_allclose(data.bearing_voltage, 50 / 1450, rtol=1e-14)
    assert float(data.bearing_voltage_ratio[0]) == pytest.approx(0.03448, abs=5e-6)


def test_current_into_a_capacitance_that_changes():
    """C0 (1 + m cos W t) at constant voltage: |i| = V C0 m W."""
    n, mean, depth, speed = 2001, 100 * PICO, 0.3, 2 * np.pi * 50
    time = np.linspace(0, 0.04, n)
    one = 2 * mean * (1 + depth * np.cos(speed * time))  # two alike in series
    data = circuit.run(films(np.tile(one[:, None, None], (1, 2, 1)), time), Source(Constant(5.0)))
    middle = 0.5 * (time[1:] + time[:-1])
    expected = -5.0 * mean * depth * speed * np.sin(speed * middle)
    largest = 5.0 * mean * depth * speed
    # the mean over a step is sinc(W dt/2) of the value in its middle
    assert np.abs(data.data.current[1:] - expected).max() < largest * (speed * 2e-5) ** 2 / 20
    assert float(np.abs(data.data.current).max()) == pytest.approx(largest, rel=1e-5)


@pytest.mark.parametrize("outer", [MOTOR, Source(Sine(20.0, 900.0)), Floating(12.0)])
def test_without_breakdown_it_is_series_and_parallel(outer):
    given = turning()
    data = circuit.run(given, outer, points=1).data
    ball, bearing = series(given.capacitance)
    driving = outer.waveform(given.time)
    expected = {
        "Motor": driving * 50 * PICO / (1250 * PICO + bearing),
        "Source": driving,
        "Floating": 12.0 * bearing[0] / bearing,
    }[type(outer).__name__]
    scale = np.abs(expected).max()
    np.testing.assert_allclose(data.bearing_voltage, expected, rtol=1e-12, atol=1e-12 * scale)
    film = expected[:, None, None] * ball[:, None] / given.capacitance
    np.testing.assert_allclose(data.film_voltage, film, rtol=1e-12, atol=1e-12 * scale)


def test_both_ways_to_solve_agree():
    """A leak too small to matter takes the stages; the same points come out."""
    plain = circuit.run(turning(), MOTOR, WEAK)
    staged = circuit.run(turning(conductance=1e-30), MOTOR, WEAK)
    assert len(plain.events) > 10 and (plain.events.ball == staged.events.ball).all()
    np.testing.assert_allclose(staged.events.energy, plain.events.energy, rtol=1e-11)
    np.testing.assert_allclose(
        staged.data.ball_voltage, plain.data.ball_voltage, rtol=1e-11, atol=1e-11
    )


def test_points_are_points_of_a_finer_record():
    coarse = turning(n=41)
    fine = circuit.run(coarse.refined(5), MOTOR, points=1).data
    data = circuit.run(coarse, MOTOR, points=5).data
    assert data.sizes["time"] == 201
    np.testing.assert_array_equal(data.bearing_voltage, fine.bearing_voltage)
    np.testing.assert_array_equal(data.film_capacitance[::5], coarse.capacitance)
    np.testing.assert_allclose(
        data.film_capacitance[2::5],
        0.6 * coarse.capacitance[:-1] + 0.4 * coarse.capacitance[1:],
        rtol=1e-14,
    )


# ---- leak --------------------------------------------------------------------------------------
def test_a_film_relaxes_with_its_resistivity_times_permittivity():
    tau = relaxation_time(1e9, 2.25)
    given = steady([40 * PICO], [60 * PICO], n=401, time=np.linspace(0, 0.05, 401))
    leaky = films(given.capacitance, given.time, conductance=given.capacitance / tau)
    data = circuit.run(leaky, Floating(10.0)).data
    z = -given.time[1] / tau  # the method's growth of a step, and the exponential that it is near
    growth = (1 + (1 - 2 * network.STAGE) * z) / (1 - network.STAGE * z) ** 2
    np.testing.assert_allclose(data.bearing_voltage, 10 * growth ** np.arange(401), rtol=1e-12)
    np.testing.assert_allclose(data.bearing_voltage, 10 * np.exp(-given.time / tau), rtol=5e-6)
    assert (data.film_state == 1).all()


def exact(given, outer):
    """Voltages of the inner ring (n,) from scipy's integrator, charges as unknowns; C and G linear
    between points."""

    def voltages(t, charge):
        at = [
            np.array([[np.interp(t, given.time, one) for one in side.T] for side in values])
            for values in (
                given.capacitance.transpose(1, 0, 2),
                given.conductance.transpose(1, 0, 2),
            )
        ]
        (inner, outer_c), conductance = at
        z = len(inner)
        matrix = np.zeros((z + 1, z + 1))
        matrix[range(z), range(z)] = inner + outer_c
        matrix[:z, z] = matrix[z, :z] = -inner
        matrix[z, z] = inner.sum() + outer.capacitance
        return np.linalg.solve(matrix, charge), conductance

    def flow(t, charge):
        v, conductance = voltages(t, charge)
        leak = conductance * np.array([v[-1] - v[:-1], v[:-1]])
        driven = (outer.waveform(np.array([t]))[0] - v[-1]) / outer.resistance
        return [*(leak[0] - leak[1]), driven - leak[0].sum()]

    start, z = np.zeros(given.capacitance.shape[2] + 1), given.capacitance.shape[2]
    found = solve_ivp(
        flow, given.time[[0, -1]], start, "LSODA", given.time, rtol=1e-10, atol=1e-21, max_step=2e-4
    )
    return np.array([voltages(t, y)[0][z] for t, y in zip(found.t, found.y.T)])


def test_leak_and_resistance_are_of_second_order():
    """The error against an integrator of scipy falls fourfold where the step is halved."""
    outer = Source(Sine(10.0, 150.0), 2e7, 20 * PICO)
    coarse = turning(n=41, z=2)
    tau = np.array([4e-3, 7e-3]).reshape(1, 2, 1)
    coarse = films(coarse.capacitance, conductance=coarse.capacitance / tau)
    reference = exact(coarse, outer)
    errors = []
    for points in (2, 4, 8):
        data = circuit.run(coarse, outer, points=points).data
        errors.append(np.abs(data.bearing_voltage.to_numpy()[::points] - reference).max())
    assert errors[0] < 0.01 * np.abs(reference).max()
    # the kinks of C(t) are points, so nothing spoils the order
    assert [a / b for a, b in zip(errors, errors[1:])] == pytest.approx([4, 4], abs=0.6)


def test_a_metal_contact_shorts_its_film_without_ringing():
    """R C = 1 ps against steps of 50 us."""
    given = steady([50 * PICO] * 2, [80 * PICO] * 2, n=11)
    conductance = np.zeros((11, 2, 2))
    conductance[5:, 1, 0] = 10.0
    data = circuit.run(films(given.capacitance, conductance=conductance), Floating(10.0)).data
    film = data.film_voltage.to_numpy()
    assert (np.abs(film[5:, 1, 0]) < 1e-5).all() and (np.diff(np.abs(film[5:, 1, 0])) <= 0).all()
    # ball 2 keeps dividing by its capacitances
    np.testing.assert_allclose(film[:, 1, 1] / film[:, 0, 1], 50 / 80, rtol=1e-12)


# ---- charge and energy -------------------------------------------------------------------------
LEAKY = dict(conductance=2e-9)
CASES = {
    "motor": (turning(), MOTOR, WEAK),
    "motor, other bearing alike": (
        turning(),
        Motor(CommonMode(560.0, 2000.0, 50.0, 0.8), 50 * PICO, 1e-9, second_factor=1.0),
        WEAK,
    ),
    "leaking motor": (turning(**LEAKY), MOTOR, WEAK),
    "source": (turning(), Source(Sine(15.0, 900.0), 1e6), WEAK),
    "leaking source": (turning(**LEAKY), Source(Sine(15.0, 900.0), 1e6, 30 * PICO), WEAK),
    "stiff source": (turning(**LEAKY), Source(Sine(15.0, 900.0)), None),
    "charged ring": (turning(), Floating(5.5, 30 * PICO), WEAK),
}


@pytest.mark.parametrize("name", CASES)
def test_charge_is_conserved(name):
    """Charges that currents carried are those of the voltages, to rounding."""
    given, outer, breakdown = CASES[name]
    result = circuit.run(given, outer, breakdown, points=1)
    assert breakdown is None or len(result.events)
    film = result.data.film_voltage.to_numpy()
    largest = np.abs(given.capacitance * film).max() + 300 * 50 * PICO * isinstance(outer, Motor)
    assert float(result.data.charge_error.max()) < 1e-13 * largest


@pytest.mark.parametrize("name", CASES)
def test_energy_is_balanced(name):
    given, outer, breakdown = CASES[name]
    data = circuit.run(given, outer, breakdown, points=1).data
    assert float(np.abs(data.energy_error).max()) < 1e-13 * float(data.stored_energy.max())
    end = data.isel(time=-1)
    out = end.leak_heat + end.resistor_heat + end.discharge_energy + end.stored_energy
    into = float(end.source_work + end.mechanical_work)
    before = float(data.stored_energy[0] + data.discharge_energy[0] - data.source_work[0])
    assert float(out) == pytest.approx(into + before, rel=1e-9)
    if breakdown:
        assert float(end.discharge_energy) > 0
    if given.leaking:
        assert float(end.leak_heat) > 0


def test_each_term_of_the_energy_is_of_second_order():
    """Not by the balance, which is an identity: against a step 64 times as short."""
    given = turning(n=41, z=3, conductance=2e-9)
    outer = Source(Sine(10.0, 150.0), 1e6)
    names = ["source_work", "mechanical_work", "leak_heat", "resistor_heat"]
    ends = {
        m: circuit.run(given, outer, points=m).data[names].isel(time=-1).to_array()
        for m in (4, 8, 256)
    }
    error = {m: np.abs(ends[m] - ends[256]).to_numpy() for m in (4, 8)}
    assert (error[4] < 2e-3 * np.abs(ends[256])).all()
    np.testing.assert_allclose(error[4] / error[8], 4.0, atol=0.5)


def test_work_of_moving_plates():
    """A charged ring, isolated: the energy Q^2/2C grows by the work of who moves the plates."""
    given = turning()
    data = circuit.run(given, Floating(10.0)).data
    bearing = series(given.capacitance).bearing
    energy = 0.5 * (10 * bearing[0]) ** 2 / bearing
    np.testing.assert_allclose(data.stored_energy, energy, rtol=1e-12)
    np.testing.assert_allclose(data.mechanical_work, energy - energy[0], atol=1e-12 * energy.max())


# ---- breakdown ---------------------------------------------------------------------------------
def test_a_film_that_fails_by_hand():
    """Two balls, 10 V. The inner film of ball 1 fails alone; its outer one holds."""
    thickness = np.array([[100e-9, 400e-9], [500e-9, 400e-9]])
    given = steady([20 * PICO, 60 * PICO], [30 * PICO, 60 * PICO], thickness=thickness)
    result = circuit.run(given, Floating(10.0, 10 * PICO), Breakdown(50e6))
    (event,) = result.events.itertuples()
    # in series 12 and 30 pF, with 10 pF beside: 520 pC on the ring
    assert (event.ball, event.raceway, event.order) == (1, "inner", 1)
    assert event.film_voltage == pytest.approx(6.0)  # against 5 V
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
    """A ball that an earlier discharge charged stays charged when another one shorts the rings."""
    capacitance = np.array([[20.0, 60.0], [30.0, 60.0]]) * PICO
    limit = np.array([[1.0, 99.0], [2.0, 99.0]])
    charge = np.array([0.0, 120 * PICO])
    ball, ring = redistribute(
        capacitance, Node(0.0, 0.0, 0.0), charge, 420 * PICO, np.zeros((2, 2), bool)
    )
    found = network.discharge(
        capacitance, limit, Node(0.0, 0.0, 0.0), charge, 420 * PICO, (ball, ring)
    )
    assert [one.ball for one in found.failures] == [0, 0]
    assert found.ball_charge.tolist() == [0, charge[1]] and found.bearing_voltage == 0
    assert found.ball_voltage.tolist() == [0, 1.0]
    assert found.ring_charge == pytest.approx(-60 * PICO)


@pytest.mark.parametrize("seed", range(6))
def test_charges_redistribute_as_a_network_of_conductors(seed):
    """Against a dense system with the charge through every broken film as an unknown."""
    rng = np.random.default_rng(seed)
    z = 5
    capacitance, charge = rng.uniform(10, 90, (2, z)) * PICO, rng.normal(0, 100, z) * PICO
    broken = np.zeros((2, z), bool)
    broken[rng.integers(0, 2, 3), [0, 2, 3]] = True
    node, ring_charge = Node(70 * PICO, 40 * PICO, 200.0), 500 * PICO
    ball, ring = redistribute(capacitance, node, charge, ring_charge, broken)
    inner, outer = capacitance / PICO
    places = np.argwhere(broken)
    matrix = np.zeros((z + 1 + len(places),) * 2)
    matrix[range(z), range(z)] = inner + outer
    matrix[:z, z] = matrix[z, :z] = -inner
    matrix[z, z] = inner.sum() + (node.beside + node.coupling) / PICO
    for row, (side, k) in enumerate(places, z + 1):
        matrix[[k, row], [row, k]] = 1  # into the ball; no voltage across the film
        if side == 0:
            matrix[[z, row], [row, z]] = -1
    right = np.zeros(len(matrix))
    right[: z + 1] = [*charge / PICO, (ring_charge + node.coupling * node.driving) / PICO]
    dense = np.linalg.solve(matrix, right)
    np.testing.assert_allclose([*ball, ring], dense[: z + 1], rtol=1e-12, atol=1e-12)


def test_threshold_is_where_it_fails():
    """Just below the threshold voltage of the samples nothing fails, just above it something
    does."""
    given = turning()
    least = circuit.run(given, Source(Constant(0.0), 1.0), WEAK).data.threshold_voltage
    share = series(given.capacitance).ball[:, None] / given.capacitance
    np.testing.assert_allclose(least, (30e6 * given.thickness / share).min(axis=(1, 2)), rtol=1e-12)
    # at the first point the source has charged nothing yet
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


# ---- films without contact ---------------------------------------------------------------------
def test_an_open_film_carries_nothing():
    given = steady([50 * PICO, 0.0, 0.0], [50 * PICO, 40 * PICO, 0.0])
    data = circuit.run(given, Source(Constant(4.0))).data
    np.testing.assert_allclose(data.bearing_capacitance, 25 * PICO, rtol=1e-15)
    np.testing.assert_allclose(data.ball_voltage[-1], [2.0, 0.0, 0.0], atol=1e-15)


def test_charge_that_loses_its_films():
    thickness = np.array([[100e-9], [900e-9]])
    capacitance = np.full((5, 2, 1), 40 * PICO)
    capacitance[3:] = 0
    given = films(capacitance, thickness=thickness)
    message = "ball 1 has a charge of 2.66667e-10 C and no film at 0.0075 s"
    with pytest.raises(RunError, match=message):
        circuit.run(given, Floating(10.0, 20 * PICO), Breakdown(45e6))


# ---- runs --------------------------------------------------------------------------------------
def test_a_run(folder):
    run = raceway.open(folder)
    result = circuit.run(run, MOTOR, WEAK, Leak(1e9), points=24)
    data = result.data
    np.testing.assert_allclose(
        data.bearing_capacitance[::24], run.bearing["capacitance"], rtol=1e-12
    )
    np.testing.assert_array_equal(data.time[::24], run.contacts.time)
    np.testing.assert_allclose(data.azimuth[::24], run.balls.azimuth, atol=1e-14)
    assert float(data.charge_error.max()) < 1e-13 * 300 * 50 * PICO
    assert set(np.unique(data.film_state)) == {0, 1}


def test_total_capacitance_and_separation_come_first(folder):
    contacts = raceway.open(folder).contacts
    more = contacts.assign(
        capacitance_total=contacts.capacitance + 20 * PICO, separation=contacts.h_c * 0 + 3e-6
    )
    given = of_dataset(more)
    np.testing.assert_array_equal(given.capacitance, more.capacitance_total)
    assert np.nanmax(given.thickness) == 3e-6
    assert (of_dataset(contacts, stray=PICO).capacitance >= PICO).all()


def test_metal_by_the_share_of_asperities(folder):
    contacts = raceway.open(folder).contacts
    share = (contacts["load"] > 1000) * 0.2
    given = of_dataset(contacts.assign(asperity_share=share), Leak(None, metal=5.0, share=0.1))
    np.testing.assert_array_equal(given.conductance, share)
    with pytest.raises(RunError, match="metallic films need the column asperity_share"):
        of_dataset(contacts, Leak(None, metal=5.0))


def test_a_dry_run_has_no_circuit(dry_folder):
    with pytest.raises(RunError, match="a dry run has no films"):
        of_run(raceway.open(dry_folder))


# ---- voltages ----------------------------------------------------------------------------------
def test_common_mode_has_four_levels():
    time = np.linspace(0, 0.1, 20001)
    voltage = CommonMode(600.0, 1050.0, 50.0, 0.9)(time)
    assert np.allclose(np.unique(voltage.round(9)), [-300, -100, 100, 300])
    # without modulation all legs switch together, half of the time each
    plain = CommonMode(600.0, 1000.0, 50.0, 0.0)(time + 1e-7)
    assert set(np.unique(plain)) == {-300, 300} and abs(plain.mean()) < 1


def test_table_from_a_file(tmp_path):
    path = tmp_path / "table.txt"
    path.write_text("# s V\n0 1\n1e-3 3\n")
    assert read_table(path)(np.array([-1, 5e-4, 2])).tolist() == [1, 2, 3]
    path.write_text("0 1\n1e-3 3\n1e-3 4\n")
    with pytest.raises(RunError, match="times of a table must rise: row 3"):
        read_table(path)
    path.write_text("0 1 2\n")
    with pytest.raises(RunError, match="3 columns, not 2"):
        read_table(path)


@pytest.mark.parametrize(
    "make, message",
    [
        (lambda: Sine(1.0, 0.0), "frequency = 0 Hz must be positive"),
        (lambda: CommonMode(1.0, 1e3, 50.0, 1.2), "modulation = 1.2 must lie from 0 to 1"),
        (lambda: Table([0, 1], [1]), "two columns with at least two rows"),
        (lambda: Source(Constant(1.0), -1.0), "resistance = -1 ohm must be 0 or more"),
        (lambda: Motor(Constant(1.0), 0.0, 1e-9), "winding_rotor = 0 F must be positive"),
        (lambda: Motor(Constant(1.0), 1e-12, 1e-9, 1e-12, 1.0), "not as both"),
        (lambda: Breakdown(0.0), "strength = 0 V/m must be positive"),
        (lambda: Breakdown(1e6, "wavy"), "surfaces = 'wavy' must be rough or smooth"),
        (lambda: Leak(-1.0), "resistivity = -1 ohm m must be positive"),
        (lambda: Leak(share=1.0), "share = 1 must lie from 0 to 1"),
        (lambda: circuit.run(turning(), Floating(), points=0), "points = 0 must be a whole"),
        (lambda: circuit.run(turning(), Source(Constant(1.0)), WEAK), "give it a resistance"),
        (
            lambda: circuit.run(turning(n=11), Source(Sine(1.0, 1e3)), points=1),
            "points = 1 must be at least 8: a sample takes 0.001 s",
        ),
        (lambda: circuit.run(turning(), Floating(), stray=1e-12), "belong to the films"),
    ],
)
def test_bad_input(make, message):
    with pytest.raises(ValueError, match=message):
        make()


def test_current_of_a_failure():
    """The inner film of one ball: behind it lies its own capacitance beside that of the rest."""
    inner, outer, rest, arc = 60 * PICO, 40 * PICO, 25 * PICO, 3.0
    given = steady([inner], [outer], thickness=np.array([[[100e-9], [900e-9]]]))
    events = circuit.run(given, Floating(10.0, rest), Breakdown(35e6, "smooth", arc=arc)).events
    one = events.iloc[0]
    assert len(events) == 1 and one.raceway == "inner"
    behind = inner + outer * rest / (outer + rest)
    assert one.film_voltage == pytest.approx(4.0)
    assert one.current == pytest.approx(4.0 / arc)
    assert one.duration == pytest.approx(arc * behind, rel=1e-12)
    assert np.isnan(one.current_density)  # no ellipse is known
    known = dataclasses.replace(given, hertz_area=np.full(3, 5e-6))
    (density,) = circuit.run(
        known, Floating(10.0, rest), Breakdown(35e6, "smooth", arc=arc)
    ).events.current_density
    assert density == pytest.approx(4.0 / arc / 5e-6)
    plain = circuit.run(given, Floating(10.0, rest), Breakdown(35e6, "smooth")).events
    assert plain[["current", "duration", "current_density"]].isna().all(axis=None)
    with pytest.raises(ValueError, match="arc = 0 ohm must be positive"):
        Breakdown(35e6, arc=0.0)
