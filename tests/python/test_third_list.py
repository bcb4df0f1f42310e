# SPDX-License-Identifier: GPL-2.0-or-later
"""Every row of tests/third_list.yaml states the earlier behaviour, and either names tests that
exist or is listed in docs/scope."""

import ast

import yaml
from host import ROOT

ROWS = yaml.safe_load((ROOT / "tests/third_list.yaml").read_text())


def test_rows():
    assert [row["row"] for row in ROWS] == list(range(1, 37))
    assert all(row.get("tests") or row.get("low") for row in ROWS)
    assert all(row.get("a7b5052") for row in ROWS)


def test_tests_exist():
    named = {name for row in ROWS for name in row.get("tests", ())}
    known = {
        f"{file}::{node.name}"
        for file in {name.split("::")[0] for name in named}
        for node in ast.parse((ROOT / "tests" / file).read_text()).body
        if isinstance(node, ast.FunctionDef)
    }
    assert named <= known, sorted(named - known)


def test_rows_that_are_low_are_in_scope():
    scope = " ".join((ROOT / "docs/scope.rst").read_text().split())
    assert [row["what"] for row in ROWS if "low" in row and row["what"] not in scope] == []
