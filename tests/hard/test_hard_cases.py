# SPDX-License-Identifier: GPL-2.0-or-later
"""The hard cases in cases.yaml are compared with references, run with deliberately large steps, and
one is run for thirty seconds."""

import re
from functools import cache

import numpy as np
import pytest

from hard import longrun
from hard.harness import (
    CASES,
    EXPLICIT,
    coarse,
    full,
    judge,
    judge_coarse,
    judge_statics,
    reference,
    run,
    yardsticks,
)
from hard.speed import nearest


def marked(*keys, name, key):
    """Return a pytest parameter, marked as an expected failure if cases.yaml states that the case
    misses its bound."""
    why = CASES[name].get("misses", {}).get(key)
    return pytest.param(
        name,
        *keys,
        id=f"{name}: {key}",
        marks=[pytest.mark.xfail(strict=True, raises=AssertionError, reason=why)] if why else [],
    )


@pytest.fixture(scope="module")
def courses(tmp_path_factory):
    """Return a function of (case, kind) that returns a `Course`; each course is computed when it is
    first needed. The kind "default" is the fix with its defaults."""
    folder = tmp_path_factory.mktemp("hard")

    @cache
    def get(name, kind):
        course = (
            run(folder, CASES[name]) if kind == "default" else reference(kind, folder, CASES[name])
        )
        assert not course.error, course.error
        return course

    return get


@pytest.mark.parametrize(
    "name, kind",
    [
        marked(kind, name=name, key=kind)
        for name, case in CASES.items()
        for kind in case["references"]
    ],
)
def test_figure(courses, name, kind):
    """The fix with its defaults and one host step per sample agrees with each reference."""
    case, found = CASES[name], courses(name, "default")
    verdict = (
        judge_statics(found, case)
        if kind == "statics"
        else judge(found, courses(name, kind), case, case["references"][kind])
    )
    print(f"{name}, {kind}: {verdict}")
    assert verdict.good, str(verdict)


@pytest.mark.parametrize("name", [name for name, case in CASES.items() if "fast" in case])
def test_fast_words(courses, tmp_path, name):
    """The faster settings meet the bounds of the case, both with one host step per sample and with
    long host steps, and their internal steps are at least 1.5 times as long."""
    case = CASES[name]
    truths = {kind: courses(name, kind) for kind in case["references"] if kind != "statics"}
    verdict, step = nearest(tmp_path, case, case["fast"], truths)
    print(f"{name}, {case['fast']}: {verdict}, internal step {step:.2e} s")
    assert verdict.good, str(verdict)
    assert step > 1.5 * courses(name, "default").step


@pytest.mark.parametrize("name", CASES)
def test_models_full(tmp_path, name):
    """The implicit step with its defaults agrees with velocity Verlet, both with the models
    `full`."""
    found, truth, verdict = full(tmp_path, CASES[name])
    assert not found.error and not truth.error, found.error or truth.error
    print(f"{name}, full: {verdict}")
    assert verdict.good, str(verdict)


@pytest.mark.parametrize("film, words", [("film", "relative 2e-4"), ("full", "relative 0")])
def test_defaults_depend_on_the_film_in_the_gap(tmp_path, film, words):
    """The default is `control estimate`, with a relative tolerance unless the film is in the gap.
    Steps with a relative tolerance are longer."""
    case, few = CASES["turning load"], dict(film=film, samples=40)
    default = run(tmp_path, case, **few)
    same = run(tmp_path, case, **few, control=f"control estimate {words}")
    other = run(tmp_path, case, **few, control="tolerance 1e-9 relative 2e-4 control estimate")
    assert (default.load == same.load).all()
    if film == "full":
        assert other.step > 1.5 * default.step
    else:
        assert other.step == default.step


@pytest.mark.parametrize(
    "name", ["axial and radial", "30,000 rpm", "30,000 rpm, unloaded inner ring"]
)
def test_defaults_need_half_of_the_evaluations(tmp_path, name):
    """At high speed, where vibration limits the step, the defaults require less than half as many
    evaluations as bounds on the errors in m."""
    found = [
        re.search(r"substeps (\S+) corrections (\S+)", coarse(tmp_path, case).text).groups()
        for case in (CASES[name], dict(CASES[name], control="control bound relative 0"))
    ]
    default, bound = (float(steps) * float(each) for steps, each in found)
    assert default < 0.5 * bound


def test_kept_derivatives_solve_the_same_stages(tmp_path):
    """With `control estimate` the last iterations evaluate only the cage; forces and stored states
    of the raceways are extrapolated from their derivatives. With the same steps, this requires
    fewer evaluations than iterating to the bound. Loads agree within the change due to 1 nm in the
    most heavily loaded contact."""
    found = []
    for control in ("bound", "estimate"):
        words = f"control {control} tolerance 1e-9 largest 1e-5 error 100"
        course = run(tmp_path, CASES["turning load"], film="full", samples=100, control=words)
        assert not course.error and not course.refused, course.error
        found.append((course, float(re.search(r"corrections (\S+)", course.text)[1])))
    (bound, most), (estimate, fewer) = found
    assert estimate.step == bound.step == pytest.approx(1e-5)
    assert fewer < most
    assert np.abs(estimate.load - bound.load).max() < 1e-9 * 2.1e8


@pytest.mark.parametrize("name", [marked(name=name, key="large") for name in CASES])
def test_host_step_too_large(courses, tmp_path, name):
    """The error control refines the step until the samples meet the bound of the case, or the run
    is rejected with a clear message."""
    case, kind = CASES[name], yardsticks(CASES[name])[0]
    found = coarse(tmp_path, case)
    if found.error:
        assert re.search(
            r"fix bearing/implicit at step \d+: no solution with substeps down to", found.error
        ), found.error
        return
    verdict = judge_coarse(found, courses(name, kind), case)
    print(f"{name}, host step x {case['large']['factor']}: {verdict}")
    assert verdict.good, str(verdict)


@pytest.mark.parametrize(
    "name, factor",
    [marked(factor, name=name, key=f"explicit {factor}") for name in CASES for factor in EXPLICIT],
)
def test_verlet_step_too_large(courses, tmp_path, name, factor):
    """Velocity Verlet with a step far beyond its limit is rejected or still gives sensible results;
    a warning alone is not enough."""
    case, kind = CASES[name], yardsticks(CASES[name])[1]
    found = reference(kind, tmp_path, case, refine=1 / factor)
    if found.error:
        assert re.search(
            r"timestep \S+ s: .* allows at most|largest allowed overlap|in no groove|not finite",
            found.error,
        )
        return
    words = dict(case["references"][kind], bound="nonsense")
    verdict = judge(found, courses(name, kind), case, words)
    print(f"{name}, Verlet step x {factor}: {verdict}")
    assert verdict.good, (
        f"{verdict}, {'with a warning' if 'WARNING: timestep' in found.text else 'quietly'}"
    )


@pytest.fixture(scope="module")
def thirty_seconds(tmp_path_factory):
    course = longrun.long_run(tmp_path_factory.mktemp("long"), 30)
    assert not course.error, course.error
    return course


def test_no_drift_in_thirty_seconds(thirty_seconds):
    """Means over the first and the last second agree within 1e-4 and within three times their
    statistical error. A rounding or damping error that accumulates over the 850 ball passes between
    them would be detected."""
    for name, drift in longrun.drifts(thirty_seconds).items():
        print(f"{name}: {drift.first:.8g} to {drift.last:.8g}, {drift.figure:.1e}")
        assert abs(drift.last - drift.first) < 1e-4 * abs(drift.first) + 3 * drift.error, name


def test_energy_of_thirty_seconds(thirty_seconds):
    """With the defaults the energy balance closes to 1e-3 of the losses. The losses are 1.5 mW,
    hundreds of times less than the power that is exchanged as balls enter and leave the load zone.
    """
    found = longrun.account(thirty_seconds)
    print(found, found.figure)
    assert found.dissipated > 0.03 and abs(found.figure) <= 1e-3


def test_the_integrators_own_loss(tmp_path):
    """The energy that a method loses decreases with the square of the step for order 2, and with
    the step for order 1, which has strong damping; the step grows with the square root of the
    tolerance. With the default settings, the work of the drive equals the contact losses found with
    a tenth of the tolerance."""

    def found(control):
        return longrun.account(longrun.long_run(tmp_path, 1.5, f"energy yes {control}"))

    coarse, default, fine = (found(f"tolerance {t}") for t in (1e-8, 1e-9, 1e-10))
    print([one.figure for one in (coarse, default, fine)])
    assert 5 < default.own / fine.own < 20 and 5 < coarse.own / default.own < 20
    assert default.work - default.stored == pytest.approx(fine.dissipated, rel=2e-3)
    first, half = (found(f"order 1 tolerance {t}") for t in (1e-9, 1e-10))
    print([one.figure for one in (first, half)])
    assert first.figure > 0.1 and 2.5 < first.own / half.own < 5
    damping = found("solve damping")
    print(damping.figure)
    assert abs(damping.figure) < 3e-3


def test_thirty_seconds_with_one_step_a_sample(tmp_path):
    """The error control refines host steps of 2.9 ms, twelve of which make up a ball pass, and no
    error occurs."""
    course = longrun.long_run(tmp_path, 30, substeps=1)
    assert not course.error, course.error
