# SPDX-License-Identifier: GPL-2.0-or-later
"""Tests of the rooms of src-package and the includes between them (tests/include_graph.py)."""

import sys
from pathlib import Path

import pytest
from host import ROOT

sys.path.insert(0, str(ROOT / "tests"))
import include_graph  # noqa: E402  the module is not in a package


def tree(folder, files):
    """Write a package of small files, given as {name: text}."""
    for name, text in files.items():
        (folder / name).parent.mkdir(parents=True, exist_ok=True)
        (folder / name).write_text(text)
    return include_graph.read(folder)


def test_the_package_keeps_its_rules():
    graph = include_graph.read(ROOT / "src-package")
    assert len(graph) > 70
    assert {include_graph.room(f) for f in graph} == set(include_graph.ROOMS)
    assert include_graph.broken(graph) == []


def test_a_private_member_of_the_solver_recompiles_the_implicit_fix_alone():
    """Only the sources of fix bearing/implicit include the class of the solver."""
    graph = include_graph.read(ROOT / "src-package")

    def sees(file):
        seen, todo = set(), [file]
        while todo:
            for target in graph[todo.pop()] - seen:
                seen.add(target)
                todo.append(target)
        return seen

    solver = Path("core/step/bearing_integrator.h")
    assert solver in graph
    rooms = ("styles", "contacts", "deck", "ranks")
    who = [f for f in graph if include_graph.room(f) in rooms and solver in sees(f)]
    assert {f.suffix for f in who} == {".cpp", ".h"}
    assert {f.parent / f.name.partition("implicit")[0] for f in who} == {
        Path("styles/fix_bearing_")
    }
    assert Path("styles/fix_bearing_implicit.h") not in who


@pytest.mark.parametrize(
    "files, complaint",
    [
        (
            {"contacts/a.h": '#include "../styles/b.h"\n', "styles/b.h": ""},
            "contacts/a.h includes styles/b.h: contacts may not include styles",
        ),
        (
            {"core/laws/a.h": '#include "bearing_compat.h"\n', "compat/bearing_compat.h": ""},
            "core/laws/a.h includes compat/bearing_compat.h: core/laws may not include compat",
        ),
        (
            {"deck/a.h": '#include "b.h"\n', "deck/b.h": '#include "a.h"\n'},
            "a cycle: deck/a.h -> deck/b.h -> deck/a.h",
        ),
        (
            {
                "styles/a.h": "",
                "styles/a_step.cpp": '#include "a.h"\n#include "b.h"\n',
                "styles/b.h": "",
                "styles/b.cpp": '#include "b.h"\n#include "a.h"\n',
            },
            "a cycle of modules: styles/a -> styles/b -> styles/a",
        ),
        (
            {f"styles/{k}.h": f'#include "{k + 1}.h"\n' for k in range(8)},
            "8 floors in styles, at most 6 are allowed",
        ),
    ],
)
def test_a_broken_rule_is_told(tmp_path, files, complaint):
    assert include_graph.broken(tree(tmp_path, files)) == [complaint]
