# SPDX-License-Identifier: GPL-2.0-or-later
"""Run a 6208 in stock LIGGGHTS, Exudyn and Raceway for peers.py, and compare the runs with the
exact static load.

Runs with `output` write the data that a user would want, every PERIOD unless stated otherwise. Runs
without output write nothing; only their cost is used.
"""

import json
import re
import subprocess
import sys
from pathlib import Path
from typing import NamedTuple

import numpy as np
import xarray as xr
from deck_runs import MAIN, ROOT, command, tables
from deck_runs import cost as told_cost
from raceway import hertz, inputs, static
from raceway.theory.bearing import INNER, OUTER

DECKS = Path("tests/bench/peers")
OUT = Path("build/bench/peers")
LOAD, SPEED = 5000.0, 50.0  # N along -y, rad/s
PERIOD = 1.76e-4  # s, time between samples; there are about 200 samples per ball pass
PASSES = 8  # number of ball passes in Raceway's runs
BEARING = inputs.bearing(ROOT / "inputs/bearings/6208")
# exact Hertzian stiffness, N/m^1.5
STIFFNESS = [
    hertz.stiffness(hertz.exact(*BEARING.effective_radii(side)), BEARING.effective_modulus)
    for side in (INNER, OUTER)
]
IN_SERIES = sum(k ** (-2 / 3) for k in STIFFNESS) ** -1.5
BOTH_ALIKE = 2**1.5 * IN_SERIES  # two equal contacts with this stiffness have IN_SERIES in series
SPHERE_ON_PLANE = 2 / 3 * BEARING.effective_modulus * BEARING.ball_radius**0.5


# s
PASS = 4 * np.pi / (BEARING.balls * SPEED * (1 - BEARING.ball_radius / BEARING.pitch_radius))


class Sample(NamedTuple):
    """Values at one instant: the displacement of the inner ring (2,) in m, the positions of the
    balls (n, 2) in m, and their inner loads (n,) in N."""

    shift: np.ndarray
    balls: np.ndarray
    load: np.ndarray


class Outcome(NamedTuple):
    """The result of one run: its cost, and the load on the ball nearest the load line relative to
    the exact theory (see `judge`)."""

    cost: float  # wall seconds per simulated second
    step: float  # s
    simulated: float  # s
    same_shift: float = np.nan
    low: float = np.nan
    high: float = np.nan
    same_load: float = np.nan
    left: int = BEARING.balls  # number of balls that are still in the bearing
    loads: np.ndarray | None = None  # inner loads (samples, balls), N


class Failure(Exception):
    """A program did not run; the text states why."""


def exact_shift():
    """Return the exact displacement (m) of the inner ring in the direction of the load when one
    ball is on the load line."""
    rest = static.equilibrium(BEARING, LOAD, load_azimuth=-np.pi / 2, phase=-np.pi / 2)
    load, _ = exact(rest.shift[:2], np.stack([np.cos(rest.azimuth), np.sin(rest.azimuth)], 1))
    if np.abs(load - rest.inner.load).max() > 1e-6 * LOAD:
        sys.exit("the closed form of the exact load disagrees with raceway.static")
    return -rest.shift[1]


def exact(shift, balls):
    """Return two arrays (n,) in N: the exact static loads on balls at given positions for a given
    displacement of the ring, and the components of these loads along the displacement.

    If there is neither clearance nor axial load, the two contacts of a ball act in series with K =
    (K_i^-2/3 + K_o^-2/3)^-3/2, and are compressed by the approach of the raceways at the ball's
    azimuth.
    """
    along = balls / np.linalg.norm(balls, axis=1)[:, None] @ shift
    return IN_SERIES * np.maximum(along, 0) ** 1.5, along / np.linalg.norm(shift)


def judge(samples, cost, step, simulated):
    """Return the `Outcome` of one run, from medians over its samples.

    same_shift is the load on the ball with the largest theoretical load, divided by the exact load
    for the ring's position, minus one; low and high are its 5 % and 95 % quantiles. same_load is
    the fraction of the ring's load that this ball carries, divided by the exact fraction, minus
    one.
    """
    ratio, part = [], []
    for shift, balls, load in samples:
        truth, along = exact(shift, balls)
        if not np.any(truth > 0):
            raise Failure("no ball is left under the load")
        k = np.argmax(truth)
        ratio.append(load[k] / truth[k])
        if (carried := load @ along) > 0:
            part.append(ratio[-1] * (truth @ along) / carried)
    low, high = np.percentile(ratio, [5, 95])
    return Outcome(
        cost,
        step,
        simulated,
        np.median(ratio) - 1,
        low - 1,
        high - 1,
        np.median(part) - 1 if part else np.nan,
        len(samples[-1].balls),
        whole(samples),
    )


def whole(samples):
    """Return the loads in N, shape (samples, balls), or None if balls were lost."""
    loads = [sample.load for sample in samples]
    return np.array(loads) if len({len(row) for row in loads}) == 1 else None


def host(program, deck, **variables):
    """Run a deck and return the printed text. Raise `Failure` with the message of the host if the
    run fails."""
    # line-buffered, because the host aborts without flushing, and its last message would be lost
    done = subprocess.run(
        ["stdbuf", "-oL", program, *command(deck, **variables)[1:]],
        cwd=ROOT,
        text=True,
        capture_output=True,
        errors="replace",
        check=False,
    )
    if done.returncode:
        wrong = re.findall(r"^ERROR.*", done.stdout, re.MULTILINE)
        raise Failure(wrong[-1] if wrong else f"{deck} failed:\n{done.stdout[-1000:]}")
    return done.stdout


def loop_time(text):
    """Return the wall time in s of the last run of a deck, read from its log."""
    return float(re.findall(r"Loop time of (\S+) on", text)[-1])


def cylinders(young, step=1e-6, output=True):
    """Run stock LIGGGHTS with smooth cylinders and the ring at the exact displacement, after the
    balls have settled for 0.1 s."""
    every = round(PERIOD / step)
    steps = 2000 * every
    text = host(
        "liggghts",
        DECKS / "in.cylinders",
        steps=steps,
        every=every,
        dt=step,
        shift=exact_shift(),
        young=young,
        write=int(output),
        out=OUT / "cylinders",
    )
    cost = loop_time(text) / (steps * step)
    if not output:
        return Outcome(cost, step, steps * step)
    shift = np.array([0, -exact_shift()])
    rows = [table for _, table in tables(ROOT / OUT / "cylinders.dump")]  # id x y fx fy
    samples = [Sample(shift, r[:, 1:3], np.hypot(r[:, 3], r[:, 4])) for r in rows]
    return judge(samples[round(0.1 / PERIOD) :], cost, step, steps * step)


def tori(mesh, steps, edges, step=4e-7):
    """Run stock LIGGGHTS with triangle meshes and the ring at the exact displacement."""
    every = 20
    text = host(
        "liggghts",
        DECKS / "in.tori",
        steps=steps,
        every=every,
        dt=step,
        shift=exact_shift(),
        mesh=mesh,
        edges=edges,
        folder=OUT,
        out=OUT / "tori",
    )
    shift = np.array([0, -exact_shift()])
    balls = tables(ROOT / OUT / "tori.dump")  # id x y
    touch = tables(ROOT / OUT / "tori.forces")  # mesh triangle id fx fy fz
    samples = []
    for (_, ball), (_, each) in zip(balls, touch):
        inner = each[each[:, 0] == 0]
        force = np.array([inner[inner[:, 2] == n, 3:].sum(0) for n in ball[:, 0]])
        samples.append(Sample(shift, ball[:, 1:], np.linalg.norm(force, axis=1)))
    return judge(samples[len(samples) // 5 :], loop_time(text) / (steps * step), step, steps * step)


def exudyn(stiffness, exponent, friction, step, output=True):
    """Run Exudyn's bearing under the load, with the damping and the full-friction sliding speed
    from Exudyn's bearing test."""
    case = {
        "stiffness": stiffness,
        "exponent": exponent,
        "friction": friction,
        "damping": 50.0,
        "zone": 1e-2,
        "load": LOAD,
        "speed": SPEED,
        "step": step,
        "ramp": 3e-3,
        # a whole number of periods, so that samples are at the same times for all steps that divide
        # a period
        "settle": 114 * PERIOD,
        "window": 400 * PERIOD,
        "period": PERIOD,
        "folder": str(ROOT / OUT / "exudyn") if output else "",
    }
    (ROOT / OUT / "exudyn").mkdir(parents=True, exist_ok=True)
    done = subprocess.run(
        [sys.executable, Path(__file__).with_name("exudyn_bearing.py"), json.dumps(case)],
        text=True,
        capture_output=True,
        check=False,
    )
    if done.returncode:
        raise Failure(done.stderr.strip().splitlines()[-1])
    found = json.loads(done.stdout.splitlines()[-1])
    if "error" in found:
        raise Failure(f"{found['error']} after {found['reached'] * 1e3:.2f} ms")
    cost = found["wall"] / found["simulated"]
    if not output:
        return Outcome(cost, step, found["simulated"])
    samples = [
        Sample(*map(np.array, sample))
        for sample in zip(found["shift"], found["balls"], found["loads"])
    ]
    return judge(
        [Sample(s.shift[:2], s.balls, s.load) for s in samples], cost, step, found["simulated"]
    )


def raceway(name, output=True, **variables):
    """Run Raceway's main deck under the load with its defaults."""
    host(
        "build/liggghts",
        MAIN,
        load=LOAD,
        rpm=SPEED * 30 / np.pi,
        passes=PASSES,
        out=OUT / name,
        record="all" if output else "none",
        overwrite="yes",
        **variables,
    )
    told = told_cost(ROOT / OUT / name)
    step, simulated = told["step_s"], told["simulated_s"]
    price = told["wall_s"] / simulated
    if not output:
        return Outcome(price, step, simulated)
    return judge(recorded(ROOT / OUT / name), price, step, simulated)


def precision(name, output=True, **variables):
    """Run Raceway with film, friction and cage from a fixed starting time, so that the results with
    different settings can be compared ball by ball."""
    text = host(
        "build/liggghts",
        "tests/bench/in.precision",
        load=LOAD,
        speed=SPEED,
        passes=PASSES,
        record="netcdf" if output else "none",
        out=OUT / name,
        **variables,
    )
    rate, step = map(float, re.search(r"RESULT rate (\S+) step (\S+)", text).groups())
    simulated = PASSES * PASS
    if control := re.search(r"CONTROL mean (\S+)", text):
        step = float(control.group(1))
    if not output:
        return Outcome(1 / rate, step, simulated)
    return judge(recorded(ROOT / OUT / name / "record"), 1 / rate, step, simulated)


def recorded(folder):
    """Return the samples in a record of a Raceway run."""
    with xr.open_dataset(folder / "record.nc", decode_times=False) as record:
        load = np.nan_to_num(record["load"].sel(raceway="inner").values)
        inner = list(record["ring_raceway"].values).index(INNER)
        ring, ball = (
            np.stack([record[f"{of}_{x}"].values for x in "xy"], -1) for of in ("ring", "ball")
        )
    return [Sample(*sample) for sample in zip(ring[:, inner], ball, load)]
