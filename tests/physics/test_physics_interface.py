# SPDX-License-Identifier: GPL-2.0-or-later
"""Tests of the C interface, through which functions are called by name (exports.h, exports.py):
names matter, but their order does not."""

import subprocess
from pathlib import Path

import numpy as np
import pytest
import xarray
from physics_c import RACEWAY, Physics
from raceway.core.exports import Library

SOURCE = """
#include "{core}/exports.h"
EXPORTS
RECORD(Spring, double {fields};)
RECORD(Answer, double sum, force[3];)
EXPORT(int, push, ({parameters}))
{{
  for (int i = 0; i < 3; ++i) out->force[i] = spring->stiffness * way[i] + spring->preload;
  out->sum = out->force[0] + out->force[1] + out->force[2] + weight;
  return 7;
}}
RECORD(Sides, double left, right;)
FORMULA(Sides, split, (double whole, int times, bool turned))
{{
  return {{turned ? -whole : whole, whole * times}};
}}
FORMULA(double, quotient, (double one, double other)) {{ return one / other; }}
"""
FIELDS = "stiffness, preload"
PARAMETERS = "const Spring *spring, const double way[3], double weight, Answer *out"
GIVEN = dict(spring=dict(preload=0.5, stiffness=2.0), weight=10.0, way=[1.0, 2.0, 3.0])


def build(folder, fields=FIELDS, parameters=PARAMETERS):
    folder.mkdir(exist_ok=True)
    source, target = folder / "push.cpp", folder / "push.so"
    core = Path(__file__).resolve().parents[2] / "src-package" / "core" / "interface"
    source.write_text(SOURCE.format(core=core, fields=fields, parameters=parameters))
    subprocess.run(["g++", "-std=c++17", "-fPIC", "-shared", source, "-o", target], check=True)
    return Library(target)


@pytest.mark.parametrize(
    "change",
    [
        {},
        {"fields": "preload, stiffness"},
        {"parameters": "double weight, Answer *out, const double way[3], const Spring *spring"},
    ],
    ids=["as written", "fields in another order", "parameters in another order"],
)
def test_order_does_not_matter(tmp_path, change):
    result, answer = build(tmp_path, **change).call("push", **GIVEN)
    assert result == 7 and answer.force.tolist() == [2.5, 4.5, 6.5] and answer.sum == 23.5


def test_another_name_is_an_error(tmp_path):
    library = build(tmp_path)
    wrong = dict(GIVEN, spring=dict(preload=0.5, rate=2.0))
    with pytest.raises(
        TypeError, match="Spring has no value for stiffness and has nothing named rate"
    ):
        library.call("push", **wrong)
    with pytest.raises(TypeError, match="push has no value for weight and has nothing named mass"):
        library.call("push", spring=GIVEN["spring"], way=GIVEN["way"], mass=10.0)
    with pytest.raises(TypeError, match="push takes spring, way, weight as keyword arguments"):
        library.call("push", GIVEN["spring"], GIVEN["way"], 10.0)
    with pytest.raises(TypeError, match="way has 2 numbers, not 3"):
        library.call("push", **dict(GIVEN, way=[1.0, 2.0]))
    with pytest.raises(AttributeError, match="moment"):
        library.call("push", **GIVEN)[1].moment


def test_formulas_take_numbers_and_arrays(tmp_path):
    library = build(tmp_path)
    split, quotient = library.formula("split"), library.formula("quotient")
    whole, turned = np.array([1.0, 2.0, 3.0]), np.array([[False], [True]])
    found = split(whole, turned=turned, times=2)
    assert found.left.tolist() == [[1.0, 2.0, 3.0], [-1.0, -2.0, -3.0]]
    assert found.right.tolist() == [[2.0, 4.0, 6.0]] * 2
    assert quotient(6, 4) == 1.5 and quotient(6, 4).shape == ()
    assert quotient(other=whole, one=6).tolist() == [6.0, 3.0, 2.0]
    assert quotient(np.empty((0, 3)), 1.0).shape == (0, 3)
    assert quotient(whole[::-2], 2).tolist() == [1.5, 0.5]  # not contiguous
    labelled = quotient(
        xarray.DataArray(whole, dims="ball"), xarray.DataArray([1.0, 2.0], dims="time")
    )
    assert labelled.dims == ("ball", "time") and labelled[2].values.tolist() == [3.0, 1.5]
    for wrong in (dict(one=1.0), dict(one=1.0, two=2.0), dict(one=1.0, other=2.0, two=2.0)):
        with pytest.raises(TypeError, match="quotient takes one, other"):
            quotient(**wrong)
    with pytest.raises(ValueError, match="shape mismatch"):
        quotient(whole, whole[:2])
    with pytest.raises(AttributeError, match="no formula sum"):
        library.formula("sum")


def test_what_cannot_be_described_is_an_error(tmp_path):
    with pytest.raises(
        TypeError, match="function push: cannot read the parameter 'double &weight'"
    ):
        build(tmp_path / "a", parameters=PARAMETERS.replace("double weight", "double &weight"))
    with pytest.raises(TypeError, match="record Spring: cannot read 'int count'"):
        build(tmp_path / "b", fields="stiffness, preload; int count")


def test_the_raceway_of_the_tests_is_that_of_the_library(physics, monkeypatch):
    monkeypatch.setitem(RACEWAY, "rolling_friction", 0.0)
    monkeypatch.delitem(RACEWAY, "mu")
    with pytest.raises(
        TypeError, match="RacewayInput has no value for mu and has nothing named rolling_friction"
    ):
        Physics(physics.path)


def test_arrays_are_filled_in_place(physics):
    xi = np.array([1e-6, 0.0])
    given = dict(k=1e7, c=30.0, cap=0.0, vt=0.3, vw=0.0)
    assert physics.call("friction_spring", xi=xi, **given).ft == 0
    assert xi[0] == pytest.approx(-30 * 0.3 / 1e7)
    with pytest.raises(TypeError, match="xi is filled in place: it must be an array of double"):
        physics.call("friction_spring", xi=np.array([1, 0]), **given)
