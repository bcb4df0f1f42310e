# SPDX-License-Identifier: GPL-2.0-or-later
"""Runs the cases in cases.yaml and their references, and measures the differences."""

import re
from pathlib import Path
from typing import NamedTuple

import numpy as np
import yaml
from host import liggghts, tables
from raceway import static
from raceway.theory.bearing import Bearing

DECK = "tests/hard/in.hard"
BALLS = 9  # every case is a 6208
_data = yaml.safe_load((Path(__file__).parent / "cases.yaml").read_text())
CASES, BOUNDS, EXPLICIT = _data["cases"], _data["bounds"], _data["explicit"]
# Settings for the "fine" references and for all comparisons of the fix with its own finer runs;
# they do not depend on the defaults.
FINE = "tolerance 1e-10 control bound"
# `Course.error` of a run that ended normally but with fewer atoms
LOST = "atoms were lost without an error message"


class Course(NamedTuple):
    """The results of a run, sample by sample. If the run stopped, `error` is the host's message and
    the tables are None."""

    load: np.ndarray  # (samples, 2, balls), N; raceway 0 is the inner raceway
    film: np.ndarray  # (samples, 2, balls), m; 0 without contact or without film
    capacitance: np.ndarray  # (samples,), F, total of the bearing
    orbit: np.ndarray  # (samples, balls), rad/s
    ball: np.ndarray  # (samples, balls, 2), m: x and y
    ring: np.ndarray  # (samples, 3), m: inner ring
    step: float  # s, mean of the internal steps
    smallest: float  # s, smallest internal step
    refused: int  # number of rejected internal steps
    wall: float  # s, wall time of the host's loop
    simulated: float  # s, simulated time
    text: str
    error: str


def run(folder, case, **over):
    """Return the `Course` of one case; `over` contains deck variables that replace those of the
    case."""
    variables = {
        "samples": 400,
        "sample": 1e-4,
        "control": case.get("control", ""),
        **case["variables"],
        **over,
    }
    outcome = liggghts(DECK, out=folder, **variables)
    control = re.search(r"CONTROL mean (\S+) smallest (\S+) .* refused (\S+)", outcome.text)
    step, smallest, refused = (
        map(float, control.groups())
        if control
        else (float(variables["sample"]) / int(variables.get("substeps", 1)), 0, 0)
    )
    wall = re.findall(r"Loop time of (\S+) on", outcome.text)
    balls = [] if outcome.code else [rows for _, rows in tables(Path(folder) / "balls.dump")]
    lost = len({len(table) for table in balls}) > 1
    arrays = (
        [None] * 6
        if outcome.code or lost
        else _arrays(Path(folder), balls, variables.get("lubricant") != "dry")
    )
    return Course(
        *arrays,
        step,
        smallest,
        int(refused),
        float(wall[-1]) if wall else np.nan,
        int(variables["samples"]) * float(variables["sample"]),
        outcome.text,
        LOST if lost else outcome.error if outcome.code else "",
    )


def _arrays(folder, balls, wet):
    load, film, capacitance = np.zeros((3, len(balls), 2, BALLS))
    for k, (_, row) in enumerate(tables(folder / "contacts.dump")):
        load[k, row[:, 1].astype(int), row[:, 0].astype(int) - 1] = row[:, 2]
    for k, (_, row) in enumerate(tables(folder / "film.dump") if wet else []):
        at = k, row[:, 1].astype(int), row[:, 0].astype(int) - 1
        film[at], capacitance[at] = row[:, 2], row[:, 3]
    both = capacitance.min(1) > 0
    pair = np.divide(
        capacitance.prod(1), capacitance.sum(1), out=np.zeros_like(capacitance[:, 0]), where=both
    )
    atoms = np.array(balls)
    x, y, vx, vy = (atoms[:, :BALLS, k] for k in (2, 3, 5, 6))
    return (
        load,
        film,
        pair.sum(1),
        (x * vy - y * vx) / (x**2 + y**2),
        atoms[:, :BALLS, 2:4],
        atoms[:, -2, 2:5],
    )


# ---- references
# ---------------------------------------------------------------------------------------------


def reference(kind, folder, case, refine=1):
    """Return the `Course` of a reference run (verlet, history, fine), with steps finer than
    specified by the factor `refine`."""
    sample = float(case["variables"].get("sample", 1e-4))
    substeps = max(1, round(refine * sample / float(case["references"][kind]["step"])))
    words = {
        "verlet": {"integrator": "verlet"},
        "history": {"integrator": "verlet", "film": "history"},
        "fine": {"control": FINE},
    }[kind]
    return run(folder, case, substeps=substeps, **words)


def statics(found, case):
    """Return (samples, loads (sample, 2, balls) in N) for static equilibria with the balls at their
    positions in `found`."""
    v, words = case["variables"], case["references"]["statics"]
    bearing = Bearing(
        BALLS,
        12.6e-3,
        24e-3,
        36.6e-3,
        float(v.get("inner_groove", 6.552e-3)),
        float(v.get("outer_groove", 6.552e-3)),
        young=210e9,
        poisson=0.3,
    )
    picked = list(range(words.get("after", 0), len(found.load), int(words.get("every", 10))))
    loads = []
    for k in picked:
        azimuth = -np.pi / 2 + float(words.get("turning", 0)) * k * float(v["sample"])
        state = static.equilibrium(
            bearing,
            float(words["radial"]),
            float(words.get("axial", 0)),
            held=words.get("held"),
            clearance=float(v.get("clearance", 0)),
            load_azimuth=azimuth,
            finite_shift=True,
            orbital_speed=np.abs(found.orbit[k]).mean(),
            phase=np.arctan2(found.ball[k, :, 1], found.ball[k, :, 0]),
        )
        loads.append([state.inner.load, state.outer.load])
    return picked, np.array(loads)


# ---- figures
# ------------------------------------------------------------------------------------------------


class Figures(NamedTuple):
    """Largest differences over balls, raceways and samples."""

    load: float  # relative to the peak load
    orbit: float  # relative to the largest cage speed
    # relative to the film thickness or to 0.1 um, the roughness, whichever is larger, for contacts
    # that carry over 1 % of the peak in both courses; nan if dry
    film: float


def compare(found, truth, after=0, every=1):
    """Return the `Figures` for two courses, starting from sample `after` of `truth`; `found`
    contains only every `every`-th sample of `truth`."""
    first = -(-after // every)
    load, film, orbit = (table[::every][first:] for table in (truth.load, truth.film, truth.orbit))
    mine, my_film, my_orbit = (table[first:] for table in (found.load, found.film, found.orbit))
    peak = truth.load.max()
    both = (load > 0.01 * peak) & (mine > 0.01 * peak) & (film > 0) & (my_film > 0)
    miss = np.abs(my_film - film)[both] / np.maximum(film[both], 1e-7)
    return Figures(
        np.abs(mine - load).max() / peak,
        np.abs(my_orbit - orbit).max() / np.abs(orbit).max(),
        miss.max() if both.any() else np.nan,
    )


def before_whirl(course, limit):
    """Return the course up to 20 ms before the inner ring starts to whirl. The ring whirls when the
    sum of the inner loads stays above `limit` (N) for 10 ms."""
    a_sample = course.simulated / (len(course.load) - 1)
    window = round(10e-3 / a_sample)
    total = np.convolve(course.load[:, 0].sum(1), np.ones(window) / window, "valid")
    onset = np.flatnonzero(total > limit)
    return first_samples(course, max(onset[0] - 2 * window, 0)) if onset.size else course


class Average(NamedTuple):
    """A time average and its statistical error, which is computed from the scatter of ten blocks
    about their trend."""

    mean: float
    error: float


def averages(course, after=0, every=1):
    """Return {name: `Average`} for the time averages by which a chaotic case is judged."""
    first = -(-after // every)
    load, orbit = course.load[first:], course.orbit[first:]
    inner, outer = load[:, 0] > 0, load[:, 1] > 0
    series = {
        "sum of inner loads": load[:, 0].sum(1),
        "outer load": load[:, 1].mean(1),
        "cage speed": orbit.mean(1),
        "fraction of balls on the inner ring": inner.mean(1),
        "fraction of balls on no ring": (~inner & ~outer).mean(1),
    }
    result = {}
    for name, values in series.items():
        blocks = np.array([block.mean() for block in np.array_split(values, 10)])
        trend = np.polyval(np.polyfit(range(10), blocks, 1), range(10))
        result[name] = Average(values.mean(), (blocks - trend).std(ddof=2) / np.sqrt(10))
    return result


def full(folder, case, truth=None):
    """Return the courses of the implicit step and of velocity Verlet with the models `full`, with
    the cage tolerance that the decks use, and the `Verdict` from comparing the first course with
    the second. If `truth` is given, velocity Verlet is not run again."""
    film = "full_dry" if case["variables"].get("lubricant") == "dry" else "full"
    words = {"step": 5e-7, "after": 0, "last": None, **case.get("full", {})}
    own = case.get("control", "") + " cage_tolerance 1e-6"
    found = run(folder, case, film=film, control=own)
    substeps = round(float(case["variables"].get("sample", 1e-4)) / float(words["step"]))
    if truth is None:
        truth = run(folder, case, film=film, integrator="verlet", substeps=substeps)
    if found.error or truth.error:
        return found, truth, None
    bound = next(iter(case["references"].values()))["bound"]
    if bound not in ("averages", "vibration"):
        bound = "course"
    last = words["last"] or len(found.load)
    judged = (first_samples(course, last) for course in (found, truth))
    return found, truth, judge(*judged, case, dict(bound=bound, after=words["after"]))


class Verdict(NamedTuple):
    """A measured difference and its bound, with additional information."""

    figure: float
    bound: float
    remark: str = ""
    orbit: float = np.nan
    film: float = np.nan

    @property
    def good(self):
        return bool(self.figure <= self.bound)

    @property
    def share(self):
        return self.figure / self.bound

    def __str__(self):
        return (
            f"{self.figure:.2e}, bound {self.bound:.2e}{', ' if self.remark else ''}{self.remark}"
        )


def judge(found, truth, case, words, every=1):
    """Return the `Verdict` from comparing a course with another one, with the settings (`bound`,
    `after`) of a reference or of `large`."""
    bound, after = BOUNDS[words["bound"]]["value"], words.get("after", 0)
    if case.get("chaotic"):
        full = len(found.load)
        found, truth = (before_whirl(course, case["whirl"]) for course in (found, truth))
        if min(len(found.load) * every, len(truth.load)) < 3 * after:
            return Verdict(
                np.inf, bound, "the ring whirls too early for the time before to be judged"
            )
        verdict = _judge_averages(averages(found, after, every), averages(truth, after), bound)
        whirls = (
            f"; the ring whirls from sample {len(found.load)} of {full}"
            if len(found.load) < full
            else ""
        )
        return verdict._replace(remark=verdict.remark + whirls)
    figures = compare(found, truth, after, every)
    return Verdict(figures.load, bound, "", figures.orbit, figures.film)


def _judge_averages(found, truth, bound):
    """Return the `Verdict` for the average with the largest difference relative to its bound.
    Differences in loads and speeds are relative, differences in fractions absolute. Since a run
    with occasional bursts has a large statistical error, bounds are limited to one half."""
    verdicts = []
    for name, (mean, error) in truth.items():
        scale = 1 if name.startswith("fraction") else mean
        statistical = np.hypot(error, found[name].error) / scale
        verdicts.append(
            Verdict(
                abs(found[name].mean - mean) / scale,
                min(bound + 3 * statistical, 0.5),
                f"{name} {found[name].mean:.4g}, expected {mean:.4g} within {bound:g} and 3 x"
                f" {statistical:.2g}",
            )
        )
    return max(verdicts, key=lambda verdict: verdict.share)


def yardsticks(case):
    """Return the kind of reference with the same friction law by which a run is judged, and that of
    velocity Verlet with its settings."""
    kinds = case["references"]
    pairs = (("verlet", "fine"), ("verlet", "history"))
    return [next(one for one in pair if one in kinds) for pair in pairs]


def judge_coarse(found, truth, case):
    """Return the `Verdict` for a course by `coarse`, compared with a course with the samples of the
    case."""
    factor = case["large"]["factor"]
    truth = first_samples(truth, factor * (len(found.load) - 1))
    return judge(found, truth, case, case["large"], factor)


def least_room(course, truths, case):
    """Return the `Verdict` that is closest to its bound among all references of the case; `truths`
    contains the courses of the reference runs."""
    verdicts = [
        judge_statics(course, case)
        if kind == "statics"
        else judge(course, truths[kind], case, words)
        for kind, words in case["references"].items()
    ]
    return max(verdicts, key=lambda verdict: verdict.share)


def truths_of(folder, case):
    """Return {kind: `Course`} for the reference runs of a case."""
    return {kind: reference(kind, folder, case) for kind in case["references"] if kind != "statics"}


def judge_statics(found, case):
    """Return the `Verdict` for the largest difference from static loads, relative to the largest
    static load."""
    picked, loads = statics(found, case)
    return Verdict(
        np.abs(found.load[picked] - loads).max() / loads.max(),
        BOUNDS[case["references"]["statics"]["bound"]]["value"],
    )


def coarse(folder, case):
    """Return the course of the case with a host step that is deliberately too large."""
    factor = case["large"]["factor"]
    return run(
        folder,
        case,
        sample=float(case["variables"]["sample"]) * factor,
        samples=case["variables"]["samples"] // factor,
    )


def first_samples(course, count):
    """Return the first `count` samples after the start of a course."""
    return course._replace(
        **{
            name: getattr(course, name)[: count + 1]
            for name in ("load", "film", "capacitance", "orbit", "ball", "ring")
        }
    )
