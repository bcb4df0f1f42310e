# SPDX-License-Identifier: GPL-2.0-or-later
"""Follow the recipes of docs/extend.rst in a copy of the tree.

The copy builds, and every law passes the derivative test. The additions appear in the output, in
the tables of the documentation, and in a deck.
"""

import json
import os
import re
import shutil
import subprocess
from pathlib import Path

import pytest
import xarray as xr
import yaml
from host import ROOT

RECIPES = ROOT / "docs" / "recipes"
PYTHON = str(ROOT / ".venv" / "bin" / "python")
CORE = "python/src/raceway/core/lib/libraceway_core.so"
MOST_FILES = {"law": 5, "column": 1, "lubricant": 5, "keyword": 2}


def carry_out(recipe: str, tree: Path) -> set[str]:
    """Make the edits of a recipe in `tree`, and return the files that they affect."""
    touched = set()
    for edit in yaml.safe_load((RECIPES / f"{recipe}.yaml").read_text()):
        path = tree / edit["file"]
        touched.add(edit["file"])
        if "before" not in edit and "after" not in edit:
            assert not path.exists(), f"{path} already exists"
            path.write_text(edit["text"])
            continue
        anchor, text = edit.get("before") or edit["after"], path.read_text()
        assert text.count(anchor) == 1, (
            f"{edit['file']}: '{anchor}' found {text.count(anchor)} times"
        )
        added = edit.get("inline") or "\n" + edit["text"]
        at = text.index(anchor) + (len(anchor) if "after" in edit else 0)
        if "before" in edit:
            added = edit["text"]
        path.write_text(text[:at] + added + text[at:])
    return touched


def add_wrong_toy(tree: Path) -> None:
    """Add a second toy whose derivative is twice the correct value, so that the derivative test
    must reject it."""
    core = tree / "src-package/core"
    text = (core / "parts/part_toy.h").read_text()
    for old, new in {
        "ToyPart": "WrongToyPart",
        "ToyLoss": "WrongToyLoss",
        '"toy': '"wrong_toy',
    }.items():
        text = text.replace(old, new)
    text = text.replace("PART_TOY_H", "PART_WRONG_TOY_H")
    text = text.replace("  using Losses = LossList<WrongToyLoss>;\n", "")  # the toy has this loss
    text = text.replace(
        "struct WrongToyLoss",
        """template <class T> T twice_the_slope(const T &x) { return x; }
template <class B, int n> Dual<B, n> twice_the_slope(Dual<B, n> x)
{
  for (B &slope : x.d) slope = 2.0 * slope;
  return x;
}

struct WrongToyLoss""",
    )
    law = "own.stiffness * own.time * (1.0 - left) * c.roll_w"
    assert text.count(law) == 1
    (core / "parts/part_wrong_toy.h").write_text(text.replace(law, f"twice_the_slope(T({law}))"))
    contact = (core / "contact/contact.h").read_text()
    for old, new in (
        (
            '#include "../parts/part_toy.h"',
            '#include "../parts/part_toy.h"\n#include "../parts/part_wrong_toy.h"',
        ),
        ("ToyPart,\n", "ToyPart, WrongToyPart,\n"),
    ):
        assert contact.count(old) == 1, old
        contact = contact.replace(old, new)
    (core / "contact/contact.h").write_text(contact)


def run(command: list[str], folder: Path, tree: Path | None = None, **more) -> str:
    """Run `command` in `folder` with the Python package from `tree` (default: `folder`), and return
    the output."""
    path = {"PYTHONPATH": str((tree or folder) / "python" / "src")}
    done = subprocess.run(
        command, cwd=folder, env=os.environ | path, capture_output=True, text=True, **more
    )
    assert done.returncode == 0, f"{' '.join(command)}:\n{done.stdout[-3000:]}{done.stderr[-3000:]}"
    return done.stdout


@pytest.fixture(scope="module")
def touched(tmp_path_factory):
    """Return (tree, {recipe: files that it changes}), where tree is a copy to which all recipes
    have been applied, built without optimisation."""
    tree = tmp_path_factory.mktemp("recipes") / "tree"
    folders = ("src-package", "inputs", "docs/decks", "tests/physics", "tests/references", "python")
    for folder in folders:
        shutil.copytree(ROOT / folder, tree / folder, ignore=shutil.ignore_patterns("__pycache__"))
    for file in ("Makefile", "docs/column_table.py"):
        shutil.copy(ROOT / file, tree / file)
    shutil.copy(ROOT / "tests" / "pytest.ini", tree / "tests")
    (tree / ".venv").symlink_to(ROOT / ".venv")
    # reuse the object files, so that sources that no recipe changes are not compiled again
    for folder in ("build/obj", "build/obj-laws", "build/units"):
        shutil.copytree(ROOT / folder, tree / folder)
    files = {recipe: carry_out(recipe, tree) for recipe in MOST_FILES}
    add_wrong_toy(tree)
    targets = ["build/liggghts", "build/libraceway_physics.so", CORE]
    # the test library contains only the functions that the derivative test calls
    physics = "PHYSICS_C=tests/physics/physics_c.cpp tests/physics/law_c.cpp"
    # low priority, because ranks of other tests would wait for a rank whose core a compiler uses
    nice = ["nice", "-n", "19", "make", "-s", "-j2"]
    # clang takes two thirds of the time of g++
    words = ["CXX=clang++", "OPTIMISE=-O0 -DRACEWAY_ONE_TARGET", physics]
    run([*nice, *words, *targets], tree)
    return tree, files


@pytest.mark.parametrize("recipe", MOST_FILES)
def test_few_files(touched, recipe):
    assert len(touched[1][recipe]) <= MOST_FILES[recipe], sorted(touched[1][recipe])


def test_the_derivative_test_refuses_the_wrong_toy_alone(touched):
    """All sets of parts pass, including those with the toy; only those with the wrong toy
    fail."""
    tests = "tests/physics/test_physics_laws.py"
    command = [PYTHON, "-m", "pytest", "-q", "-c", "tests/pytest.ini", "--rootdir=.", tests]
    done = subprocess.run(command, cwd=touched[0], capture_output=True, text=True)
    assert "1 failed" in done.stdout and " passed" in done.stdout, done.stdout + done.stderr
    refused = re.findall(r"^wrong slope: (.*)$", done.stdout, re.MULTILINE)
    assert refused and all("wrong_toy" in parts for parts in refused), done.stdout


TABLES = """
import json, column_table as table
print(json.dumps({
    "parts": list(table.part_rows()), "contact": table.rows("contact", False),
    "keywords": table.keyword_rows(False) + table.keyword_rows(True),
}))
"""


def test_docs_have_the_part_its_keywords_and_columns(touched):
    tree = touched[0]
    tables = json.loads(run([PYTHON, "-c", TABLES], tree / "docs", tree=tree))
    parts = {row[0]: row for row in tables["parts"]}
    assert parts["*toy*"][2:] == ["*toy*", "1", "*toy_couple*, *toy_power*"]
    keywords = [row[0] for row in tables["keywords"]]
    for keyword in ("*toy* S TAU", "*density* RHO", "*hysteresis_limit* C"):
        assert keyword in keywords
    contact = dict(tables["contact"])
    assert {"*depth*", "*density*", "*toy_couple*", "*toy_power*"} <= set(contact)
    assert "(kg/m^3)" in contact["*density*"]


def rows(dump: Path) -> list[list[float]]:
    """Return the rows of the last frame of a dump."""
    lines = dump.read_text().splitlines()
    first = max(n for n, line in enumerate(lines) if line.startswith("ITEM: ENTRIES")) + 1
    return sorted([float(x) for x in line.split()] for line in lines[first:])


@pytest.fixture(scope="module")
def ran(touched):
    """Run docs/decks/in.toy and return {"0" or "1": folder}, where 0 is velocity Verlet and 1 is
    the implicit integrator."""
    folders = {}
    for implicit in ("0", "1"):
        folders[implicit] = touched[0] / f"run{implicit}"
        folders[implicit].mkdir()
        deck = touched[0] / "docs/decks/in.toy"
        command = [touched[0] / "build/liggghts", "-log", "none", "-in", deck]
        run([*map(str, command), "-var", "implicit", implicit], folders[implicit])
    return folders


def test_the_deck_runs_with_both_integrators(ran):
    """The couple on a ball that rolls steadily is the product of the toy's stiffness, its time, and
    the rolling speed.

    After ten times the toy's time, the integrators agree within the first-order error of Verlet's
    step in the toy's memory, 1e-6/1e-3. Balls that barely touch are excluded, because their
    contacts open and close.
    """
    found = {key: rows(folder / "toys.dump") for key, folder in ran.items()}
    loaded = {key: [row for row in found[key] if row[2] > 100] for key in found}
    assert len(loaded["0"]) == len(loaded["1"]) >= 8
    for one, other in zip(loaded["0"], loaded["1"]):
        assert one[:2] == other[:2] and abs(one[3]) > 1e-5
        assert one[3] == pytest.approx(other[3], rel=1e-3)


SHOWN = """
import json, sys
from raceway.report.of_run import page
from raceway.runs.run import Run
from raceway.sweeps.scene_parts import figures
run = Run(sys.argv[1])
found = run.summary()
report = page(run.tables).write(sys.argv[2]).read_text()
print(json.dumps({"summary": found, "needs": figures(found), "report": report}))
"""


def test_the_loss_arrives_in_torque_summary_needs_and_report(touched, ran):
    """The toy's loss appears in the friction torque, in losses_W, in the results of `raceway
    needs`, and on the report page. It equals the sum over the contacts in the record, excluding
    damping, which this law also includes."""
    folder = ran["1"] / "toy"
    found = json.loads(
        run([PYTHON, "-c", SHOWN, str(folder), str(folder / "report.html")], touched[0])
    )
    with xr.open_dataset(folder / "record.nc") as data:
        lost = float(data["toy_power"].sum(("raceway", "ball")).mean())
        bearing = float(data["bearing_toy_power"].mean())
    summary = found["summary"]
    assert lost > 1e-4 and bearing == pytest.approx(lost, rel=1e-13)
    assert summary["losses_W"]["toy"] == pytest.approx(lost, rel=1e-12)
    known = [loss for loss in summary["losses_W"].values() if loss]
    assert summary["power_loss_W"] == pytest.approx(sum(known), rel=1e-12)
    torque = summary["friction_torque_N_m"]
    assert torque == pytest.approx(summary["power_loss_W"] / 50.0, rel=1e-6)
    assert found["needs"]["torque"] == torque
    assert "by the toy" in found["report"]


def test_the_main_deck_has_the_new_columns(touched):
    tree = touched[0]
    words = "-in inputs/in.6208 -log none -var passes 1 -var dumps yes -var overwrite yes"
    run(["build/liggghts", *words.split()], tree)
    settings = yaml.safe_load((tree / "build/run/6208/run.yaml").read_text())
    names = settings["contact_columns"].split()
    assert {"depth", "density", "toy_couple"} <= set(names)
    last = rows(tree / "build/run/6208/contacts.dump")
    for row in last:
        contact = dict(zip(names, row))
        assert contact["density"] == 870 and contact["toy_couple"] == 0
        assert contact["depth"] == pytest.approx(contact["overlap"] / 6.3e-3, rel=1e-9)
