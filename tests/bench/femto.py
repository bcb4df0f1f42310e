# SPDX-License-Identifier: GPL-2.0-or-later
"""Model the temperatures of the bearing in the PRONOSTIA rig (FEMTO) at 1800 rpm and 4 kN. The
script fits three parameters of the housing to three measured runs, compares time jumps with full
integration, and simulates the first ten minutes after a cold start with the main deck. It writes
build/bench/femto.rst.

Statics with the models `full` provides the losses and the contact conductances; the heat capacities
of the rings and balls follow from their dimensions. In the warm runs, the housing starts at ambient
temperature, because the data suggest that the recordings began with a warm bearing.
"""

import csv
from pathlib import Path
from typing import NamedTuple

import matplotlib
import numpy as np
import raceway
from deck_runs import MAIN, ROOT, run_deck
from machine import publish
from raceway import heat, heat_scene, inputs
from raceway.core import laws, library
from scipy import integrate, optimize

matplotlib.use("Agg")
from matplotlib import pyplot as plt  # noqa: E402

HERE = Path(__file__).with_suffix("")
PICTURE = ROOT / "docs/images/femto.png"
AMBIENT, LOAD, RPM, OIL = 26.5, 4000.0, 1800.0, "vg68"
FIRST, LAST = 10.0, 240.0  # min, time range of the fit
GUESS = dict(seat=0.45, housing=1.1, capacity=2200.0)
OILS = np.array([26.5, 35, 45, 55, 65, 75, 85, 95, 105, 115, 125, 140])  # C


class Losses(NamedTuple):
    """Losses at both raceways (W) and contact conductances (W/K) as functions of the oil
    temperature."""

    sides: np.ndarray  # (N, 2)
    contacts: np.ndarray  # (N, 2)

    def at(self, oil):
        """Return ([inner, outer] losses in W, [inner, outer] conductances in W/K) for an oil
        temperature of `oil` degrees C."""
        return tuple(
            [float(np.interp(oil, OILS, column)) for column in table.T]
            for table in (self.sides, self.contacts)
        )


def measured():
    """Return a dict that maps each measured run to (minutes, temperatures in C)."""
    lines = (HERE / "measured.csv").read_text().splitlines()
    rows = list(csv.reader(line for line in lines if not line.startswith("#")))
    minutes = np.array(rows[0][1:], float)
    return {row[0]: (minutes, np.array(row[1:], float)) for row in rows[1:]}


def losses():
    path = HERE / "bearing"
    scene = heat_scene.Scene(
        inputs.bearing(path),
        inputs.lubricant(ROOT / "inputs/lubricants" / OIL),
        1e-7,
        LOAD,
        0.0,
        RPM,
        size=inputs.size(path),
    )
    found = [scene.at(oil, 0.0) for oil in OILS]
    return Losses(
        np.array([one["sides"] for one in found]), np.array([one["contacts"] for one in found])
    )


def capacities():
    """Return the heat capacities (J/K) of the inner ring, the balls and the outer ring."""
    bearing, steel = inputs.bearing(HERE / "bearing"), laws.steel_of_bearings()
    depth = 0.18 * bearing.ball_diameter
    rings = [
        float(laws.ring_capacity(inner, radius, groove, seat, 2 * (radius + grown), 7e-3))
        for inner, radius, groove, seat, grown in (
            (True, bearing.inner_radius, bearing.inner_groove, 20e-3, depth),
            (False, bearing.outer_radius, bearing.outer_groove, 32e-3, -depth),
        )
    ]
    ball = 7800.0 * np.pi / 6 * bearing.ball_diameter**3 * float(steel.heat)
    return rings[0], bearing.balls * ball, rings[1]


def network(contacts, seat, housing, capacity):
    return heat.network(
        (*capacities(), capacity), contacts=tuple(contacts), seat=seat, housing=housing,
        ambient=AMBIENT,
    )  # fmt: skip


def integrated(table, start, minutes, seat, housing, capacity):
    """Integrate the heat balance, and return the temperatures in C, shape (M, 4), of the inner
    ring, the balls, the outer ring and the housing."""
    own = np.array([*capacities(), capacity])

    def rate(_, t):
        sides, (inner, outer) = table.at(t[:3].mean())
        flow = np.array([inner * (t[0] - t[1]), outer * (t[1] - t[2]), seat * (t[2] - t[3])])
        gain = np.array(heat.into_nodes(*sides)[:4])  # without the oil, which does not flow
        gain -= np.array([*flow, 0.0])
        gain[1:] += flow
        gain[3] -= housing * (t[3] - AMBIENT)
        return gain / own

    times = 60.0 * np.asarray(minutes, float)
    begin = [start, start, start, AMBIENT]
    found = integrate.solve_ivp(
        rate, (0, times[-1]), begin, "LSODA", times, rtol=1e-7, atol=1e-6, max_step=600
    )
    return found.y.T


def jumps(table, start, until, change, housing_of):
    """Advance the temperatures with time jumps, and return (times in s, temperatures (N, 4) in C,
    number of simulated ball passes)."""
    control = dict(
        change=change, error=0.5, until=until, steady=0.05, hottest=200.0, share=0.2, both_ends=1.0
    )
    state = library().records["HeatStateOf"]()
    for k, t in enumerate([start, start, start, AMBIENT]):
        state.at[k] = state.law[k] = t
    rows = []
    for passes in range(1, 5000):
        sides, contacts = table.at(np.mean(state.law[:3]))
        net = network(contacts, **housing_of)
        library().call(
            "heat_jump", state=state, heat=heat.into_nodes(*sides), inner=contacts[0],
            outer=contacts[1], convection=0.0, net=net, control=control,
        )  # fmt: skip
        rows.append((state.time, *state.at))
        if state.end:
            return np.array(rows), passes
    raise SystemExit("the jumps do not reach the end of the run")


def fit(table):
    """Return the fitted parameters of the housing, and the largest deviation (K) from the three
    measured runs."""
    runs = measured()

    def missing(logs):
        of = dict(zip(GUESS, np.exp(logs)))
        parts = []
        for minutes, seen in runs.values():
            known = minutes >= FIRST
            found = integrated(table, seen[0], minutes, **of)[:, 2]
            parts.append((found - seen)[known])
        return np.concatenate(parts)

    best = optimize.least_squares(missing, np.log(list(GUESS.values())), diff_step=1e-3)
    best = optimize.minimize(
        lambda logs: abs(missing(logs)).max(), best.x, method="Nelder-Mead",
        options=dict(xatol=1e-3, fatol=1e-3, maxfev=300),
    )  # fmt: skip
    of = {name: float(value) for name, value in zip(GUESS, np.exp(best.x))}
    return of, abs(missing(best.x)).max()


def error_of_jumps(table, of, change):
    """Return (largest error in K within four hours of a cold start, number of ball passes)."""
    start = measured()["cold start"][1][0]
    rows, passes = jumps(table, start, 60 * LAST, change, of)
    keep = np.flatnonzero(np.diff(rows[:, 0], prepend=-1.0))
    exact = integrated(table, start, rows[keep, 0] / 60, **of)
    return float(abs(rows[keep, 1:] - exact).max()), passes


def cold_start(of, folder, until=600.0, change=2.0):
    """Run the main deck with time jumps from a cold start, and return the dataset of its
    temperatures."""
    run_deck(
        MAIN, bearing=HERE / "bearing", lubricant=OIL, load=LOAD, rpm=RPM, heat="yes",
        ambient=AMBIENT, warm_start=measured()["cold start"][1][0], warm_time=until,
        warm_change=change, seat=of["seat"], cooling=of["housing"],
        housing_capacity=of["capacity"], out=folder, overwrite="yes", record="summary", passes=1,
    )  # fmt: skip
    return raceway.open(folder).heat


def picture(table, of):
    """Plot the measured and the fitted temperatures next to the outer ring."""
    figure, axes = plt.subplots(figsize=(7, 4), layout="constrained")
    minutes = np.linspace(0, LAST, 200)
    for k, (name, (read, seen)) in enumerate(measured().items()):
        axes.plot(read, seen, "o", color=f"C{k}", label=name)
        axes.plot(minutes, integrated(table, seen[0], minutes, **of)[:, 2], color=f"C{k}")
    axes.axvspan(FIRST, LAST, color="0.95", zorder=0)
    axes.set(xlabel="time, min", ylabel="temperature next to the outer ring, °C")
    axes.legend()
    figure.savefig(PICTURE, dpi=110)


def main():
    table = losses()
    of, worst = fit(table)
    picture(table, of)
    own = capacities()
    lines = [
        f"Capacities of inner ring, balls and outer ring: {own[0]:.2f}, {own[1]:.2f},"
        f" {own[2]:.2f} J/K.",
        f"Fitted: outer ring to housing {of['seat']:.3f} W/K, housing to ambient"
        f" {of['housing']:.3f} W/K, housing {of['capacity']:.0f} J/K. Largest deviation from the"
        f" measurements in three runs between {FIRST:g} and {LAST:g} min: {worst:.2f} K.",
        "",
    ]
    for name, (minutes, seen) in measured().items():
        found = integrated(table, seen[0], minutes, **of)[:, 2]
        pairs = ", ".join(f"{a:.1f} ({b:.1f})" for a, b in zip(found, seen))
        lines.append(f"* {name}, model (measured), C: {pairs}")
    lines.append("")
    for change in (4.0, 2.0, 1.0):
        error, passes = error_of_jumps(table, of, change)
        lines.append(f"* largest change {change:g} K: error {error:.3f} K with {passes} passes")
    hot = cold_start(of, ROOT / "build/bench/femto")
    last = hot.isel(thermal_time=-1)
    run, thermal = float(last["run_time"]), float(last["thermal_time"])
    balance = float(last["booked"] - last["carried"] - last["stored"]) / float(last["booked"])
    outer = float(last["temperature_outer"])
    lines += [
        "",
        f"Cold start of {thermal:g} s, simulated in a run of {run:.3f} s"
        f" (1/{thermal / run:.0f} of that time): outer ring {outer:.2f} C,"
        f" with the losses of statics"
        f" {integrated(table, measured()['cold start'][1][0], [0, 10], **of)[-1, 2]:.2f} C,"
        f" measured {measured()['cold start'][1][1]:g} C; losses {float(last['power']):.2f} W;"
        f" heat balance {balance:.1e}.",
    ]
    fine = cold_start(of, ROOT / "build/bench/femto_fine", change=0.25).isel(thermal_time=-1)
    change = max(
        abs(float(last[f"temperature_{p}"] - fine[f"temperature_{p}"]))
        for p in ("inner", "balls", "outer", "housing")
    )
    lines.append(f"With jumps of at most 0.25 K, the final temperature differs by {change:.3f} K.")
    publish("Temperatures of the PRONOSTIA bearing", "{lines}\n", lines=lines)


if __name__ == "__main__":
    main()
