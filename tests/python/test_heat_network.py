# SPDX-License-Identifier: GPL-2.0-or-later
"""The conductances and heat capacities of a bearing, its heat network, and temperatures that
advance in jumps are compared with quadrature, the matrix exponential and closed-form solutions."""

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
    "oil flows": heat.network(
        (53.0, 34.0, 83.0, 0.0), contacts=(2.99, 3.35), housing=2.17,
        oil=heat.OilFlow(14.0, 45.0, (2.8e-3, 4.5e-3, 4.2e-3), 230.0),
    ),
    "oil flows, housing": heat.network(
        (3.4, 1.05, 4.3, 2157.0), contacts=(1.05, 0.98), shaft=0.1, seat=0.449, housing=1.12,
        oil=heat.OilFlow(0.3, 10.0, (0.6e-3, 0.5e-3, 0.8e-3), 500.0),
    ),
}  # fmt: skip
HEAT = np.array([6.0, 12.0, 6.0, 0.5, 3.0])


class Whole:
    """A heat network as a symmetric matrix over inner ring, balls, outer ring, housing, oil,
    ambient and inlet. A node without a capacity is treated as the limit of a vanishing capacity, so
    its temperature follows from those of the other nodes."""

    def __init__(self, net):
        self.net, self.capacity = net, np.array([*net["capacity"], 0.0])
        self.fixed = np.array([net["ambient"], net["inlet"]])
        g = np.zeros((7, 7))
        # if the seat is perfect, housing and outer ring are one node
        seat, cooled = (net["seat"], 3) if net["seat"] else (1.0, 2)
        oil = [net["convection"] * area for area in net["wetted"]]
        links = {
            (0, 1): net["inner"], (1, 2): net["outer"], (2, 3): seat, (0, 5): net["shaft"],
            (cooled, 5): net["housing"], (4, 6): net["flow"] or 1.0,
            **{(i, 4): oil[i] for i in range(3)},
        }  # fmt: skip
        for (i, j), link in links.items():
            g[i, i] += link
            g[j, j] += link
            g[i, j] -= link
            g[j, i] -= link
        self.g = g
        self.slow = np.flatnonzero(self.capacity)
        self.fast = np.flatnonzero(self.capacity == 0)
        self.heat = HEAT * [1, 1, 1, 1, net["flow"] > 0]

    def into(self, heat):
        """Add the heat of a housing without capacity to the outer ring."""
        if self.capacity[3]:
            return heat
        return np.array([*heat[:2], heat[2] + heat[3], 0.0, heat[4]])

    def all_of(self, slow, heat):
        """Return the temperatures of all five nodes, given those of the nodes with a capacity."""
        heat = self.into(heat)
        at = np.empty(5)
        at[self.slow] = slow
        known = np.r_[slow, self.fixed]
        columns = self.g[np.ix_(self.fast, np.r_[self.slow, 5, 6])]
        at[self.fast] = np.linalg.solve(
            self.g[np.ix_(self.fast, self.fast)], heat[self.fast] - columns @ known
        )
        return at

    def leaving(self, slow, heat):
        """Return the heat flow in W into the ambient and into the oil."""
        at, flow = self.all_of(slow, heat), self.net["flow"]
        away = -self.g[:5, 5] @ (at - self.net["ambient"])
        return away + flow * (at[4] - self.net["inlet"])

    def rate(self, slow, heat):
        at = np.r_[self.all_of(slow, heat), self.fixed]
        return ((self.into(heat) - self.g[:5] @ at)[self.slow]) / self.capacity[self.slow]

    def affine(self):
        """Return (matrix, vector) of the linear expression for d(slow)/dt."""
        n = len(self.slow)
        least = self.rate(np.zeros(n), self.heat)
        columns = [self.rate(one, self.heat) - least for one in np.eye(n)]
        return np.transpose(columns), least


def test_conductance_of_a_contact():
    steel = laws.steel_of_bearings()
    a, b, u = 1.102e-3, 0.1241e-3, 1.203
    # at each point, two half-spaces are in contact for the time 2 b sqrt(1 - z^2)/u
    along = integrate.quad(lambda z: (1 - z * z) ** 0.25, 0, 1, epsabs=1e-13)[0]
    assert along == pytest.approx(0.87402, abs=5e-6)
    property = float(steel.conductivity * steel.density * steel.heat)
    expected = along * 2 * a * np.sqrt(2 * property * b * u / np.pi)
    assert float(laws.contact_conductance(a, b, u, 1.0)) == pytest.approx(expected, rel=1e-9)
    assert expected == pytest.approx(0.242, abs=5e-4)


def test_contact_of_different_materials():
    """The reference is the heat equation in two bars that touch at their ends, one of which has
    another conductivity and capacity, solved by finite volumes with implicit steps."""
    k, c, ends = (4.0, 1.0), (1.0, 0.36), 1.0  # W/(m K), J/(m^3 K), s
    effusivity = np.sqrt(k[0] * c[0] / (k[1] * c[1]))

    def end(start, source):
        """Return the temperature (2, n) at the end for a `source` of heat in W/m^2 at the joint."""
        n = 400
        edges = 25.0 * (np.linspace(0, 1, n + 1) ** 2)  # m, from the joint
        width, centre = np.diff(edges), (edges[1:] + edges[:-1]) / 2
        matrix, inflow = np.zeros((2 * n, 2 * n)), np.zeros(2 * n)
        for side in (0, 1):
            at, flow = side * n + np.arange(n), k[side] / np.diff(centre)
            for i, one in enumerate(flow):
                matrix[np.ix_(at[i : i + 2], at[i : i + 2])] += one * np.array([[1, -1], [-1, 1]])
        # the joint without capacity is eliminated
        half = np.array([k[side] / centre[0] for side in (0, 1)])
        share, series = half / half.sum(), half.prod() / half.sum()
        matrix[np.ix_([0, n], [0, n])] += series * np.array([[1, -1], [-1, 1]])
        inflow[[0, n]] = source * share
        capacity, now = np.r_[c[0] * width, c[1] * width], np.repeat(start, n).astype(float)
        steps = 2000
        solve = np.linalg.inv(np.diag(capacity * steps / ends) + matrix)
        for _ in range(steps):
            now = solve @ (capacity * steps / ends * now + inflow)
        return now.reshape(2, n), width

    at, width = end([1.0, 0.0], 0.0)
    heat = c[1] * (at[1] * width).sum()  # J/m^2, that has flowed into the second bar
    alike = 2 * np.sqrt(k[1] * c[1] * ends / np.pi) / 2  # if both were like the second one
    steel = float(laws.contact_conductance(1.0, 1.0, 1.0, 1.0))
    other = float(laws.contact_conductance(1.0, 1.0, 1.0, effusivity))
    assert other / steel == pytest.approx(heat / alike, rel=0.01)
    at, width = end([0.0, 0.0], 1.0)
    first, second = (c[side] * (at[side] * width).sum() for side in (0, 1))
    share = float(laws.heat_share_of_balls(effusivity))
    assert share == pytest.approx(first / (first + second), rel=0.01)


def test_convection_of_the_oil():
    """The reference is the boundary layer of a plate with Blasius's velocity, for which scipy
    integrates the heat equation. At the large Prandtl numbers of oils, the exact constant is 0.339,
    i.e. 2 % above 0.332."""
    k, heat_capacity, density, viscosity, orbit, pitch = 0.15, 1950.0, 860.0, 0.02, 385.0, 0.06
    prandtl = viscosity * heat_capacity / k
    far = 6.0  # eta, where (Pr/2) times the integral of f exceeds 1000

    def layer(_, y):
        f, slope, curvature, whole, _ = y
        return [slope, curvature, -f * curvature / 2, f, np.exp(-prandtl * whole / 2)]

    start = [0.0, 0.0, 0.332057, 0.0, 0.0]
    end = integrate.solve_ivp(layer, (0, far), start, "Radau", rtol=1e-8, atol=1e-10).y[:, -1]
    reynolds = orbit * pitch / 2 / 3 * pitch * density / viscosity
    expected = k / pitch * np.sqrt(reynolds) / end[4]
    found = laws.oil_convection(k, heat_capacity, density, viscosity, orbit, pitch)
    assert float(found) == pytest.approx(expected, rel=0.025)


def test_surfaces_that_oil_wets():
    inner, balls, outer = laws.wetted_surfaces(0.024, 0.0366, 0.0063, 9, 0.018)
    sphere = 2 * np.pi * integrate.quad(lambda a: 0.0063**2 * np.sin(a), 0, np.pi)[0]
    assert float(balls) == pytest.approx(9 * sphere, rel=1e-12)
    assert float(inner + outer) == pytest.approx(2 * np.pi * (0.024 + 0.0366) * 0.018, rel=1e-12)
    assert float(outer / inner) == pytest.approx(0.0366 / 0.024, rel=1e-12)


def test_capacity_of_a_ring(bearing):
    """The capacity follows from the volume of thin cylinders; for both rings of the 6208 together
    it is 136 J/K."""
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
    whole = Whole(net)
    slowest, found = heat.steady(net, whole.heat)
    rates, least = whole.affine()
    expected = np.linalg.solve(rates, -least)
    n = len(expected)
    assert found[:n] == pytest.approx(expected, abs=1e-10)
    assert slowest == pytest.approx(-1 / linalg.eigvals(rates).real.max(), rel=1e-8)
    at = whole.all_of(found[:n], whole.heat)
    assert found[3] == pytest.approx(at[3], abs=1e-10)
    if net["flow"]:
        assert heat.outlet(net, found[:3], HEAT[4]) == pytest.approx(at[4], abs=1e-10)
    assert whole.leaving(found[:n], whole.heat) == pytest.approx(whole.heat.sum(), rel=1e-12)


@pytest.mark.parametrize("net", NETS.values(), ids=NETS)
@pytest.mark.parametrize("time", [1e-3, 3.0, 200.0, 1e5])
def test_advance_is_the_matrix_exponential(net, time):
    whole = Whole(net)
    start = np.array([20.0, 60.0, 35.0, 25.0])
    rates, least = whole.affine()
    steady = np.linalg.solve(rates, -least)
    n = len(steady)
    expected = steady + linalg.expm(rates * time) @ (start[:n] - steady)
    carried, found = heat.advance(net, whole.heat, start, time)
    assert found[:n] == pytest.approx(expected, abs=1e-9)
    stored = whole.capacity[:n] @ (found[:n] - start[:n])
    brought = whole.heat.sum() * time
    assert stored + carried == pytest.approx(brought, abs=1e-9 * (1 + brought))


@pytest.mark.parametrize("net", NETS.values(), ids=NETS)
def test_heat_that_grows_evenly(net):
    whole = Whole(net)
    n = len(whole.slow)
    start, time = np.array([20.0, 60.0, 35.0, 25.0]), 90.0
    begin = whole.heat
    end = 3.0 * np.r_[begin[3::-1], 2.0 * begin[4]]

    def rate(t, at):
        heat_in = begin + (end - begin) * t / time
        return [*whole.rate(at[:n], heat_in), whole.leaving(at[:n], heat_in)]

    exact = integrate.solve_ivp(rate, (0, time), [*start[:n], 0.0], "Radau", rtol=1e-10, atol=1e-9)
    carried, found = heat.advance(net, begin, start, time, end)
    assert [*found[:n], carried] == pytest.approx(exact.y[:, -1], rel=1e-8)
    booked = 0.5 * (begin.sum() + end.sum()) * time
    stored = whole.capacity[:n] @ (found[:n] - start[:n])
    assert stored + carried == pytest.approx(booked, rel=1e-10)


def spread(net, loss):
    """Distribute a loss in W among the nodes and, if there is an oil flow, the oil."""
    oil = 0.1 * loss if net["flow"] else 0.0
    return np.array(heat.into_nodes(0.6 * loss - oil, 0.4 * loss, drag=oil, flows=True))


def jump(net, losses, start, **control):
    """Return the rows with the time in s and the temperatures of the nodes in C, and the last
    state, for a run that advances in jumps; `losses`(T) is the power loss in W."""
    state = library().records["HeatStateOf"]()
    for k in range(4):
        state.at[k] = state.law[k] = start
    inner, outer = net["inner"], net["outer"]
    rows = []
    for _ in range(2000):
        library().call(
            "heat_jump", state=state, heat=spread(net, losses(np.mean(state.law[:3]))),
            inner=inner, outer=outer, convection=net["convection"], net=net,
            control=CONTROL | control,
        )  # fmt: skip
        rows.append((state.time, *state.at))
        if state.end:
            break
    return np.array(rows), state


def integrated(net, losses, start, times):
    """Return the temperatures integrated by scipy, without jumps."""
    whole = Whole(net)

    def rate(_, t):
        return whole.rate(t, spread(net, losses(t[:3].mean())))

    cold = [start] * len(whole.slow)
    return integrate.solve_ivp(rate, (0, times[-1]), cold, "LSODA", times, rtol=1e-9, atol=1e-9).y.T


def fall(t):
    """Return a power loss in W that behaves as in an oil-lubricated bearing: it first decreases
    with temperature, and then increases because of mixed friction."""
    return 30 * np.exp(-(t - 20) / 40) + 0.08 * t


@pytest.mark.parametrize("net", NETS.values(), ids=NETS)
def test_jumps_against_no_jumping(net):
    """The error of a cold start is proportional to the square of the largest temperature change
    that is allowed in a jump."""
    worst = []
    for change in (4.0, 2.0, 1.0):
        rows, state = jump(net, fall, 20.0, change=change, error=1e9, until=3600.0)
        times, found = rows[:, 0], rows[:, 1 : 1 + np.count_nonzero(net["capacity"])]
        keep = np.flatnonzero(np.diff(times, prepend=-1.0))
        exact = integrated(net, fall, 20.0, times[keep])
        worst.append(abs(found[keep] - exact).max())
        assert state.time == pytest.approx(3600.0) and state.end == 1
        stored = np.array(net["capacity"]) @ (np.array(state.at) - 20.0)
        assert state.booked == pytest.approx(state.carried + stored, rel=1e-9)
    assert worst[1] < 0.5
    assert worst[2] < 0.35 * worst[0] or worst[2] < 0.02


@pytest.mark.parametrize("name", ["none", "oil flows"])
def test_jumps_to_the_steady_state(name):
    net = NETS[name]
    rows, state = jump(net, fall, 20.0)
    end = integrated(net, fall, 20.0, np.array([0.0, 1e5]))[-1]
    assert rows[-1, 1:4] == pytest.approx(end, abs=0.06)
    slope = (fall(end.mean() + 0.1) - fall(end.mean() - 0.1)) / 0.2
    (_, hot), (_, idle) = heat.steady(net, spread(net, 1.0)), heat.steady(net, np.zeros(5))
    gain = slope * (hot[:3].mean() - idle[:3].mean())
    assert state.gain == pytest.approx(gain, abs=0.05 * abs(gain) + 0.01)


@pytest.mark.parametrize(("share", "end"), [(0.9, 2), (1.1, 3)])
def test_run_away(share, end):
    """The losses increase linearly with temperature, at 0.9 and 1.1 times the total conductance."""
    net = NETS["none"]
    _, hot = heat.steady(net, heat.into_nodes(0.6, 0.4))
    slope = share / (hot[:3].mean() - 20)  # W/K
    _, state = jump(net, lambda t: 30.0 + slope * (t - 20), 20.0, hottest=1e4)
    assert state.end == end
    assert state.gain == pytest.approx(share, rel=1e-2)
