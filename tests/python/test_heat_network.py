# SPDX-License-Identifier: GPL-2.0-or-later
"""Conductances and capacities of a bearing, its heat network and the jumps of its temperatures,
against quadrature, the matrix exponential, and closed forms."""

import numpy as np
import pytest
from raceway import heat
from raceway.core import laws, library
from scipy import integrate, linalg

CONTROL = dict(
    change=2.0, error=0.5, until=0.0, steady=0.05, hottest=200.0, share=0.2, both_ends=1.0
)
NETS = {
    "housing": heat.network(
        (3.4, 1.05, 4.3, 2157.0), contacts=(1.05, 0.98), shaft=0.1, seat=0.449, housing=1.12,
        ambient=26.5,
    ),
    "none": heat.network((53.0, 34.0, 83.0, 0.0), contacts=(2.99, 3.35), housing=2.17),
    "in series": heat.network(
        (53.0, 34.0, 83.0, 0.0), contacts=(2.99, 3.35), shaft=0.2, seat=0.5, housing=2.17
    ),
}  # fmt: skip
HEAT = np.array([6.0, 12.0, 6.0, 0.5])


def matrix(net):
    """Conductances between the nodes with a capacity, and to ambient (W/K)."""
    n = 4 if net["capacity"][3] else 3
    seat, housing = net["seat"], net["housing"]
    outside = np.zeros(4)
    outside[0] = net["shaft"]
    if n == 4:
        outside[3] = housing
    else:
        outside[2] = housing if not seat else 1 / (1 / seat + 1 / housing)
    g = np.diag(outside)
    for i, link in enumerate([net["inner"], net["outer"], seat if n == 4 else 0.0]):
        g[i : i + 2, i : i + 2] += link * np.array([[1, -1], [-1, 1]])
    return n, g[:n, :n], outside[:n]


def into(n):
    """Heat of a housing without capacity goes into the outer ring."""
    return HEAT if n == 4 else HEAT[:3] + [0, 0, HEAT[3]]


def test_conductance_of_a_contact():
    steel = laws.steel_of_bearings()
    a, b, u = 1.102e-3, 0.1241e-3, 1.203
    # heat through each point: two half-spaces in contact for the time 2 b sqrt(1 - z^2)/u
    along = integrate.quad(lambda z: (1 - z * z) ** 0.25, 0, 1, epsabs=1e-13)[0]
    assert along == pytest.approx(0.87402, abs=5e-6)
    property = float(steel.conductivity * steel.density * steel.heat)
    expected = along * 2 * a * np.sqrt(2 * property * b * u / np.pi)
    assert float(laws.contact_conductance(a, b, u)) == pytest.approx(expected, rel=1e-9)
    assert expected == pytest.approx(0.242, abs=5e-4)


def test_capacity_of_a_ring(bearing):
    """Against the volume of thin cylinders; both rings of the 6208 have 136 J/K."""
    steel = laws.steel_of_bearings()
    total = 0.0
    for inner, bottom, groove, seat, shoulder in (
        (True, bearing.inner_radius, bearing.inner_groove, 40e-3, 52.6e-3),
        (False, bearing.outer_radius, bearing.outer_groove, 80e-3, 67.4e-3),
    ):
        across = np.linspace(-9e-3, 9e-3, 200001)
        arch = groove - np.sqrt(np.maximum(groove**2 - across**2, 0.0))
        radius = bottom + arch if inner else bottom - arch
        face = np.minimum(radius, shoulder / 2) if inner else np.maximum(radius, shoulder / 2)
        face = np.where(abs(across) < groove, face, shoulder / 2)
        area = np.pi * abs(face**2 - (seat / 2) ** 2)
        expected = float(steel.density * steel.heat) * integrate.trapezoid(area, across)
        found = float(laws.ring_capacity(inner, bottom, groove, seat, shoulder, 18e-3))
        assert found == pytest.approx(expected, rel=1e-6)
        total += found
    assert total == pytest.approx(136, rel=0.15)


@pytest.mark.parametrize("net", NETS.values(), ids=NETS)
def test_steady_state(net):
    n, g, outside = matrix(net)
    slowest, found = heat.steady(net, HEAT)
    expected = net["ambient"] + np.linalg.solve(g, into(n))
    assert found[:n] == pytest.approx(expected, abs=1e-11)
    rates = linalg.eigvals(g / np.array(net["capacity"][:n])[:, None]).real
    assert slowest == pytest.approx(1 / rates.min(), rel=1e-9)
    assert outside @ (found[:n] - net["ambient"]) == pytest.approx(HEAT.sum(), rel=1e-12)


@pytest.mark.parametrize("net", NETS.values(), ids=NETS)
@pytest.mark.parametrize("time", [1e-3, 3.0, 200.0, 1e5])
def test_advance_is_the_matrix_exponential(net, time):
    n, g, outside = matrix(net)
    start = np.array([20.0, 60.0, 35.0, 25.0])
    capacity = np.array(net["capacity"][:n])
    rates = -g / capacity[:, None]
    steady = net["ambient"] + np.linalg.solve(g, into(n))
    expected = steady + linalg.expm(rates * time) @ (start[:n] - steady)
    carried, found = heat.advance(net, HEAT, start, time)
    assert found[:n] == pytest.approx(expected, abs=1e-9)
    stored = capacity @ (found[:n] - start[:n])
    assert stored + carried == pytest.approx(HEAT.sum() * time, abs=1e-9 * (1 + HEAT.sum() * time))


@pytest.mark.parametrize("net", NETS.values(), ids=NETS)
def test_heat_that_grows_evenly(net):
    n, g, outside = matrix(net)
    start, time = np.array([20.0, 60.0, 35.0, 25.0]), 90.0
    capacity, end = np.array(net["capacity"][:n]), 3.0 * HEAT[::-1]
    last = end[:n] + (0 if n == 4 else np.array([0, 0, end[3]]))

    def rate(t, at):
        heat_in = into(n) + (last - into(n)) * t / time
        return [*((heat_in - g @ (at[:n] - net["ambient"])) / capacity),
                outside @ (at[:n] - net["ambient"])]  # fmt: skip

    exact = integrate.solve_ivp(rate, (0, time), [*start[:n], 0.0], "Radau", rtol=1e-10, atol=1e-9)
    carried, found = heat.advance(net, HEAT, start, time, end)
    assert [*found[:n], carried] == pytest.approx(exact.y[:, -1], rel=1e-8)
    booked = 0.5 * (HEAT.sum() + end.sum()) * time
    assert capacity @ (found[:n] - start[:n]) + carried == pytest.approx(booked, rel=1e-10)


def jump(net, losses, start, **control):
    """Temperatures from jumps (time in s and C of the nodes) with losses `losses`(T) in W, and
    the last state."""
    state = library().records["HeatStateOf"]()
    for k in range(4):
        state.at[k] = state.law[k] = start
    inner, outer = net["inner"], net["outer"]
    rows = []
    for _ in range(2000):
        oil = np.mean(state.law[:3])
        pass_ = heat.into_nodes(0.6 * losses(oil), 0.4 * losses(oil))
        library().call(
            "heat_jump", state=state, heat=pass_, inner=inner, outer=outer, net=net,
            control=CONTROL | control,
        )  # fmt: skip
        rows.append((state.time, *state.at))
        if state.end:
            break
    return np.array(rows), state


def integrated(net, losses, start, times):
    """The same integrated by scipy, without jumps."""
    n, g, _ = matrix(net)
    capacity = np.array(net["capacity"][:n])

    def rate(_, t):
        heat_in = np.array(heat.into_nodes(0.6 * losses(t[:3].mean()), 0.4 * losses(t[:3].mean())))
        return (heat_in[:n] - g @ (t - net["ambient"])) / capacity

    return integrate.solve_ivp(
        rate, (0, times[-1]), [start] * n, "LSODA", times, rtol=1e-9, atol=1e-9
    ).y.T


def fall(t):
    """A loss like that with an oil: it falls with temperature, then grows by mixed friction."""
    return 30 * np.exp(-(t - 20) / 40) + 0.08 * t


@pytest.mark.parametrize("net", NETS.values(), ids=NETS)
def test_jumps_against_no_jumping(net):
    """The error of a cold start falls with the square of the largest change."""
    worst = []
    for change in (4.0, 2.0, 1.0):
        rows, state = jump(net, fall, 20.0, change=change, error=1e9, until=3600.0)
        times, found = rows[:, 0], rows[:, 1 : 1 + matrix(net)[0]]
        keep = np.flatnonzero(np.diff(times, prepend=-1.0))
        exact = integrated(net, fall, 20.0, times[keep])
        worst.append(abs(found[keep] - exact).max())
        assert state.time == pytest.approx(3600.0) and state.end == 1
        stored = np.array(net["capacity"]) @ (np.array(state.at) - 20.0)
        assert state.booked == pytest.approx(state.carried + stored, rel=1e-9)
    assert worst[1] < 0.5
    assert worst[2] < 0.35 * worst[0] or worst[2] < 0.02


def test_jumps_to_the_steady_state():
    net = NETS["none"]
    rows, state = jump(net, fall, 20.0)
    end = integrated(net, fall, 20.0, np.array([0.0, 1e5]))[-1]
    assert rows[-1, 1:4] == pytest.approx(end, abs=0.06)
    slope = (fall(end.mean() + 0.1) - fall(end.mean() - 0.1)) / 0.2
    _, hot = heat.steady(net, heat.into_nodes(0.6, 0.4))
    gain = slope * (hot[:3].mean() - 20)
    assert state.gain == pytest.approx(gain, abs=0.05 * abs(gain) + 0.01)


@pytest.mark.parametrize(("share", "end"), [(0.9, 2), (1.1, 3)])
def test_run_away(share, end):
    """Losses that grow linearly, at 0.9 and 1.1 of the total conductance."""
    net = NETS["none"]
    _, hot = heat.steady(net, heat.into_nodes(0.6, 0.4))
    slope = share / (hot[:3].mean() - 20)  # W/K
    _, state = jump(net, lambda t: 30.0 + slope * (t - 20), 20.0, hottest=1e4)
    assert state.end == end
    assert state.gain == pytest.approx(share, rel=1e-2)
