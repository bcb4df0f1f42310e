# SPDX-License-Identifier: GPL-2.0-or-later
"""All public names exist, and every public function has annotations for its parameters and its
result."""

import importlib
import inspect
import pkgutil
import subprocess
import sys
import typing

import pandas
import pytest
import raceway
import xarray

MODULES = [
    found.name
    for found in pkgutil.walk_packages(raceway.__path__, "raceway.")
    if not found.name.endswith("__main__")
]


def public(module):
    """Yield (name, function) for every public function and method that `module` defines, including
    constructors."""
    for name, thing in vars(module).items():
        if name.startswith("_") or getattr(thing, "__module__", None) != module.__name__:
            continue
        if inspect.isfunction(thing):
            yield name, thing
        elif inspect.isclass(thing):
            yield from (
                (f"{name}.{key}", function)
                for key, member in vars(thing).items()
                for function in [plain(member)]
                if function and (key == "__init__" or not key.startswith("_"))
                if function.__module__ == module.__name__
            )


def plain(member):
    """Return the function behind a method, property or cached property of a class, or None for any
    other member."""
    for wrapped in ("__func__", "fget", "func", "__wrapped__"):
        member = getattr(member, wrapped, member)
    return member if inspect.isfunction(member) else None


def without_hint(function):
    """Return the names of the parameters without an annotation, and "return" if the result has
    none; `self` and `cls` are omitted."""
    signature = inspect.signature(function)
    names = [
        name
        for place, (name, one) in enumerate(signature.parameters.items())
        if one.annotation is one.empty and not (place == 0 and name in ("self", "cls"))
    ]
    return names + ["return"] * (signature.return_annotation is signature.empty)


@pytest.mark.parametrize("name", MODULES)
def test_hints(name):
    module = importlib.import_module(name)
    assert {key: left for key, one in public(module) if (left := without_hint(one))} == {}


@pytest.mark.parametrize("name", MODULES)
def test_docstrings(name):
    module = importlib.import_module(name)
    assert module.__doc__
    # a constructor is documented by its class, and the functions of a command by `raceway.commands`
    known = ("add", "run") if hasattr(module, "EXAMPLES") else ("__init__",)
    bare = [key for key, one in public(module) if not (one.__doc__ or key.endswith(known))]
    assert bare == []


def test_hints_name_types_that_are():
    """Every annotation can be evaluated, including annotations in quotes."""
    from MDAnalysis import Universe
    from raceway.recordings.compare import Comparison
    from raceway.recordings.identify import Found
    from raceway.recordings.readings import Readings
    from raceway.recordings.recording import Recording
    from raceway.runs.record import Record
    from raceway.runs.source import Source
    from raceway.runs.spectrum import Line
    from raceway.runs.tables import RunTables

    late = {
        "Run": raceway.Run,
        "RunTables": RunTables,
        "Universe": Universe,
        "Line": Line,
        "Record": Record,
        "Source": Source,
        "Recording": Recording,
        "Readings": Readings,
        "Found": Found,
        "Comparison": Comparison,
        "Equilibrium": raceway.static.Equilibrium,
        "Lubrication": raceway.lubrication.Lubrication,
        "pd": pandas,
        "xr": xarray,
    }
    functions = [one for name in MODULES for _, one in public(importlib.import_module(name))]
    assert len(functions) > 250
    for one in [raceway.open, *functions]:
        assert typing.get_type_hints(one, localns=late)


def test_a_missing_hint_is_found():
    def half(a: int, b, *, c: str = ""):
        return a, b, c

    assert without_hint(half) == ["b", "return"]


@pytest.mark.parametrize("name", raceway.NAMES)
def test_name(name):
    namespace = {}
    exec(f"from raceway import {name}", namespace)
    assert namespace[name] is getattr(raceway, name)
    assert namespace[name].__name__.rsplit(".")[-1] == name and name in dir(raceway)


def test_a_name_has_one_home():
    """No module hides a module in another folder, and no class hides a module."""
    homes = [found.name for room in ("", *raceway.ROOMS) for found in modules(room)]
    assert len(homes) == len(set(homes))
    assert set(raceway.NAMES) == {*homes, *raceway.CLASSES} - {"__main__"}
    assert set(raceway.__all__) == {"open", *raceway.NAMES} and not {"open"} & set(homes)
    for name in ("bearing", "static", "columns", "spectrum", "catalogue", "circuit", "export"):
        assert name in homes


def modules(room):
    package = importlib.import_module(f"raceway.{room}".rstrip("."))
    return pkgutil.iter_modules(package.__path__)


def test_the_package_alone_loads_nothing_large():
    said = subprocess.run(
        [sys.executable, "-c", "import sys, raceway; print(*sys.modules)"],
        capture_output=True,
        text=True,
        check=True,
    ).stdout.split()
    assert "raceway" in said
    assert not {"numpy", "scipy", "pandas", "xarray", "matplotlib", "yaml"} & set(said)
