# SPDX-License-Identifier: GPL-2.0-or-later
"""Plot the error of each integrator against its cost, and write build/bench/work_precision.rst and
the diagram.

    python tests/bench/work_precision.py [rad/s ...]

The error is the largest over all balls and samples of one ball pass, compared with a reference that
uses the same friction law. It covers the inner and outer loads (relative to the largest load), the
orbital speed (relative to its mean) and, for balls that carry more than 1 % of the largest load,
the film thickness (relative). The cost is the wall time per simulated second on one core, as the
median of ROUNDS rounds. These runs compute the capacitance at 200 instants of a ball pass and write
no output. A round runs all methods for a scene.
"""

import re
import statistics

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402
import numpy as np  # noqa: E402
from deck_runs import ROOT, attempt, tables  # noqa: E402
from machine import bench_file, csv_table, publish, words_asked  # noqa: E402
from matplotlib.ticker import NullFormatter  # noqa: E402

FOLDER = "build/bench/precision"
PICTURE = bench_file("work_precision.png")
PAGE = """\
The bearing is a 6208 at 5 kN in mineral oil, with film, friction, cage and a free ring. Its
capacitance is computed at 200 instants per ball pass (:doc:`../fix_bearing_capacitance`, *within*).
There is no output.

The error is the largest over all balls and instants of one ball pass, compared with a reference
that uses the same friction law. It covers inner and outer loads (relative to the largest load),
cage speed (relative to its mean) and, for balls that carry more than 1 % of the largest load, the
film.

All runs use one core. The values are medians of {rounds} rounds; each round runs all settings of a
scene.

Required speed
--------------

The table lists real-time factors (simulated time divided by wall time) of
:doc:`../fix_bearing_implicit` in this run.

Velocity Verlet is compared twice, each time with the fastest step whose error is at most 1e-3. The
first ratio is the fair comparison: Verlet uses the friction law that suits it, a spring with
history, and has a separate reference. For the second ratio, Verlet uses the smoothed friction law
of the implicit step, which acts as a stiff damper at low sliding speeds. At 50 rad/s, this shortens
the steps of Verlet by a factor of ten to twenty. At 5 rad/s, the steps would be only nanoseconds
long, so these cases were not run. At 1000 rad/s, this law is not stiff, and Verlet is about as fast
with either law.

{targets}

Diagram
-------

.. image:: work_precision.png
   :alt: error against wall time per simulated second

Points further left and lower are better. The dotted line is the difference between the reference
methods; errors below it are not significant. The grey line is 1e-3.

{scenes}

Rejected variants
-----------------

:doc:`../notes/integrator` describes what was tried and rejected.

{machine}
"""
ROUNDS = 2
SAMPLES = 200
SPEEDS = (5.0, 50.0, 1000.0)
CLEARANCES = {-0.0035: -44.1e-6, 0.0: 0.0, 0.0035: 44.1e-6}
# colours that colour-blind readers can distinguish (from Okabe and Ito)
STYLE = {
    "implicit, order 1": ("#0072b2", "o"),
    "implicit, order 2": ("#d55e00", "s"),
    "Verlet, same friction": ("#555555", "^"),
    "Verlet, history spring": ("#009e73", "v"),
    "dampers implicit": ("#cc79a7", "D"),
}
# the friction law that suits Verlet is a spring with history; the smoothed law would act as a stiff
# damper
SPRING = "tangential 0.8235 0.3"
# {rad/s: steps of Verlet in s}: the longest stable step at this clearance, and shorter steps
SAME_STEPS = {50.0: (1.6e-7, 8e-8, 4e-8), 1000.0: (2e-6, 1e-6, 5e-7)}
SPRING_STEPS = {
    5.0: (1e-6, 8e-7, 4e-7),
    50.0: (1.6e-6, 1.4e-6, 1e-6, 5e-7),
    1000.0: (3e-6, 2e-6, 1e-6, 5e-7),
}
# {rad/s: real-time factors required at errors of 1e-3 and 1e-2}
TARGETS = {5.0: (150, 300), 50.0: (20, 40), 1000.0: (1.5, 10)}


def run(**variables):
    """Return (wall time per simulated time, mean step) for one run of in.precision, or None if the
    run was rejected."""
    text = attempt("tests/bench/in.precision", out=FOLDER, **variables).stdout
    result = re.search(r"RESULT rate (\S+) step (\S+)", text)
    control = re.search(r"CONTROL mean (\S+)", text)
    return result and (1 / float(result[1]), float(control[1] if control else result[2]))


def recorded(**variables):
    """Return (loads and films, shape (instants, 2, 9); orbital speeds, shape (samples, 9)), or None
    if the run was rejected."""
    if run(record="yes", passes=1, **variables) is None:
        return None
    rows = np.loadtxt(ROOT / FOLDER / "contacts.txt")
    orbit = np.array([rows[:, 1] for _, rows in tables(ROOT / FOLDER / "balls.dump")])
    count = (len(orbit) - 1) * int(variables.get("within", 1)) + 1
    since, whole = rows[:, 0] - rows[0, 0], rows[-1, 0] - rows[0, 0]
    instant = np.rint(since * (count - 1) / whole).astype(int)
    place = instant, rows[:, 3].astype(int), rows[:, 2].astype(int) - 1
    load, film = np.zeros((count, 2, 9)), np.ones((count, 2, 9))
    load[place], film[place] = rows[:, 4], rows[:, 5]
    return load, film, orbit


def error(found, truth):
    """Return the error defined in the docstring of the module; `found` may have fewer, evenly
    spaced samples."""
    truth = [there[:: (len(there) - 1) // (len(here) - 1)] for here, there in zip(found, truth)]
    peak = truth[0].max()
    loaded = (truth[0] > 0.01 * peak) & (found[0] > 0)
    return max(
        np.abs(found[0] - truth[0]).max() / peak,
        np.abs(found[2] - truth[2]).max() / truth[2].mean(),
        np.abs(found[1] / truth[1] - 1)[loaded].max(),
    )


def settings(speed):
    """Yield (method, text for the table, variables of the deck, type of reference) for each
    point."""
    # the deck rounds the step down so that there is a whole number of steps per sample
    sample = 1.7627e-4 * 50 / speed * 1.001
    for order in (1, 2):
        for samples in (10, 20, 40, 100, 200):
            yield (
                f"implicit, order {order}",
                f"{samples} host steps per ball pass, tolerance 0.1 µm",
                dict(
                    step=sample * SAMPLES / samples,
                    samples=samples,
                    within=SAMPLES // samples,
                    control=f"tolerance 1e-7 order {order}",
                ),
                "same",
            )
        for pieces in (1, 2, 4) if speed > 500 else (2, 4):
            yield (
                f"implicit, order {order}",
                f"20 host steps, {pieces} internal steps per sample",
                dict(
                    step=sample * 10,
                    samples=20,
                    within=10,
                    control=f"tolerance 1e-7 order {order} largest {sample / pieces:.4g}",
                ),
                "same",
            )
    if speed >= 50:
        for control in ("", " largest 4e-6", " largest 2e-6"):
            yield (
                "dampers implicit",
                "20 host steps"
                + (f", internal steps of {control.split()[1]} s" if control else ""),
                dict(step=sample * 10, samples=20, within=10, control="solve damping" + control),
                "same",
            )
    for tolerance in ("1e-8", "3e-9", "1e-9"):
        yield (
            "implicit, order 2",
            f"200 samples, tolerance {float(tolerance) * 1e9:g} nm"
            + (" (default)" if tolerance == "1e-9" else ""),
            dict(step=sample, control=f"tolerance {tolerance}"),
            "same",
        )
    for step in SAME_STEPS.get(speed, ()):
        yield ("Verlet, same friction", "", dict(step=step, integrator="verlet"), "same")
    for step in SPRING_STEPS.get(speed, ()):
        yield (
            "Verlet, history spring",
            "against itself",
            dict(step=step, integrator="verlet", friction=SPRING),
            "history",
        )


def references(scene, speed):
    """Return ({type of reference: truth}, difference between the two methods). The methods are
    Verlet with a step of 25 ns, and the implicit integrator with a tolerance of 0.1 nm. At 5 rad/s,
    where the same friction limits the steps of Verlet to nanoseconds, the methods are the implicit
    integrator with orders 1 and 2."""
    fine = recorded(
        **scene,
        step=1e-5 if speed < 50 else 2e-6 if speed < 1000 else 1e-7,
        control="tolerance 1e-10",
    )
    spring = recorded(
        **scene, step=2e-7 if speed < 50 else 1e-7, integrator="verlet", friction=SPRING
    )
    if speed < 50:
        other = recorded(**scene, step=5e-6, control="tolerance 1e-10 order 1")
        return {"same": fine, "history": spring}, error(other, fine)
    verlet = recorded(**scene, step=2.5e-8, integrator="verlet")
    return {"same": verlet, "history": spring}, error(fine, verlet)


def measure(speed, clearance):
    """Return (rows, difference between the references). Each row contains the method, its text, the
    mean step, the error, and the median, least and most wall time per simulated second."""
    scene = dict(speed=speed, clearance=clearance)
    truths, apart = references(scene, speed)
    points = []
    for method, words, variables, kind in settings(speed):
        found = recorded(**scene, **variables)
        points.append(
            (method, words, {**scene, **variables}, error(found, truths[kind]) if found else None)
        )
    costs = [[] for _ in points]
    for _ in range(ROUNDS):
        for cost, (_, _, variables, miss) in zip(costs, points):
            if miss is not None:
                cost.append(
                    run(record="no", passes=1 if "integrator" in variables else 40, **variables)
                )
    rows = []
    for (method, words, _, miss), cost in zip(points, costs):
        walls = [c[0] for c in cost if c]
        rows.append(
            (method, words, cost[0][1], miss, statistics.median(walls), min(walls), max(walls))
            if walls
            else (method, words, None, None, None, None, None)
        )
    return rows, apart


def slope(rows, method):
    """Return the observed order of a method, computed from the errors and mean steps with its
    coarsest and finest fixed settings."""
    points = sorted((r[2], r[3]) for r in rows if r[0] == method and r[3] and "nm" not in r[1])
    return (
        np.polyfit(np.log([p[0] for p in points]), np.log([p[1] for p in points]), 1)[0]
        if len(points) > 2
        else np.nan
    )


METHODS = ("method", "setting", "mean internal step (s)", "error",
           "simulated time / wall time (range)")  # fmt: skip


def cells(method, words, step, miss, wall, least, most):
    found = ("", "rejected", "")
    if step:
        speed = f"{1 / wall:.3g} ({1 / most:.3g} to {1 / least:.3g})"
        found = (f"{step:.3g}", f"{miss:.1e}", speed)
    return (method, words or "fixed step", *found)


def fastest(rows, limit, method=None):
    """Return (real-time factor, setting) of the fastest row with at most this error, for one method
    or for all of Raceway's implicit methods. Return (nan, "none") if there is no such row."""
    fitting = [
        (1 / r[4], f"{r[0]}: {r[1]}")
        for r in rows
        if r[3] and r[3] <= limit and (r[0] == method if method else "Verlet" not in r[0])
    ]
    return max(fitting, default=(np.nan, "none"))


def targets(results):
    """Tabulate the best real-time factors for each scene at errors of at most 1e-3 and 1e-2,
    together with the goals and the ratios to Verlet."""
    head = (
        "rad/s",
        "P_d/D",
        "at most 1e-3",
        "relative to Verlet with the friction spring, 1e-3",
        "relative to Verlet with the same friction, 1e-3",
        "required",
        "method and setting",
        "at most 1e-2",
        "required",
        "method and setting",
    )
    body = []
    for (speed, ratio), (rows, _) in results.items():
        fine, coarse = fastest(rows, 1e-3), fastest(rows, 1e-2)
        over = (
            fine[0] / fastest(rows, 1e-3, method)[0]
            for method in ("Verlet, history spring", "Verlet, same friction")
        )
        body.append(
            (
                f"{speed:g}",
                f"{ratio:g}",
                f"{fine[0]:.3g}",
                *(
                    "not run"
                    if np.isnan(value)
                    else f"{value:.0f}"
                    if value >= 10
                    else f"{value:.2g}"
                    for value in over
                ),
                f"{TARGETS[speed][0]:g}",
                fine[1],
                f"{coarse[0]:.3g}",
                f"{TARGETS[speed][1]:g}",
                coarse[1],
            )
        )
    return csv_table(head, [["" if cell == "nan" else cell for cell in row] for row in body])


def draw(results):
    figure, axes = plt.subplots(
        len(SPEEDS), len(CLEARANCES), figsize=(13, 11), sharex="row", sharey=True
    )
    for (speed, ratio), (rows, apart) in results.items():
        ax = axes[SPEEDS.index(speed), list(CLEARANCES).index(ratio)]
        for method, (colour, mark) in STYLE.items():
            points = sorted((r[4], r[3]) for r in rows if r[0] == method and r[3])
            if points:
                ax.loglog(*zip(*points), mark, color=colour, markersize=6, label=method)
        ax.axhline(apart, color="#999999", linewidth=0.8, linestyle=":")
        ax.axhline(1e-3, color="#cccccc", linewidth=0.8)
        ax.set_title(f"{speed:g} rad/s, $P_d/D$ = {ratio:g}", fontsize=11)
        ax.grid(True, which="major", color="#eeeeee")
    for ax in axes.flat:
        ax.xaxis.set_minor_formatter(NullFormatter())
    for ax in axes[-1]:
        ax.set_xlabel("wall seconds per simulated second")
    for ax in axes[:, 0]:
        ax.set_ylabel("error")
    handles, labels = axes[1, 1].get_legend_handles_labels()
    figure.legend(handles, labels, loc="upper center", ncol=5, frameon=False)
    figure.tight_layout(rect=(0, 0, 1, 0.96))
    figure.savefig(PICTURE, dpi=110)


def page(results):
    scenes = []
    for (speed, ratio), (rows, apart) in results.items():
        title = f"{speed:g} rad/s, P_d/D = {ratio:g}"
        slopes = {method: slope(rows, method) for method in STYLE}
        orders = ", ".join(f"{m} {one:.1f}" for m, one in slopes.items() if np.isfinite(one))
        scenes += [
            *(title, "-" * len(title), ""),
            f"The references differ by {apart:.1e}. Observed order (error against step):"
            f" {orders or 'too few points'}.",
            "",
            *csv_table(METHODS, [cells(*row) for row in rows]),
        ]
    publish("Speed against error", PAGE, rounds=ROUNDS, targets=targets(results), scenes=scenes)


def main():
    results = {}
    for speed in map(float, words_asked() or SPEEDS):
        for ratio, clearance in CLEARANCES.items():
            print(f"{speed:g} rad/s, P_d/D {ratio:g}", flush=True)
            results[speed, ratio] = measure(speed, clearance)
            for row in results[speed, ratio][0]:
                print("  ", *row, flush=True)
    if len(results) == len(SPEEDS) * len(CLEARANCES):
        draw(results)
        page(results)


if __name__ == "__main__":
    main()
