# SPDX-License-Identifier: GPL-2.0-or-later
"""The Spack package and the conda recipe in docs/packaging have the same requirements as
pyproject.toml."""

import re
import sys
import tomllib
import types
from contextlib import contextmanager

import pytest
import raceway
import yaml
from host import ROOT

FOLDER = ROOT / "docs" / "packaging"
PROJECT = tomllib.loads((ROOT / "python" / "pyproject.toml").read_text())["project"]
NEEDED = dict(need.split(">=") for need in PROJECT["dependencies"])
VERSION = re.search(r'"(.+)"', (ROOT / "src-package/core/settings/raceway_version.h").read_text())[
    1
]


@pytest.fixture
def spack(monkeypatch):
    """Return (directives of the Spack package as (name, arguments), its class)."""
    asked = []
    stub = types.ModuleType("spack.package")
    for name in ("license", "version", "extends", "depends_on"):
        setattr(stub, name, lambda *words, _name=name, **more: asked.append((_name, *words)))
    stub.run_after = lambda phase: lambda function: function

    @contextmanager
    def default_args(**more):
        yield

    stub.default_args = default_args
    modules = {"spack": types.ModuleType("spack"), "spack.package": stub}
    for name, base in (("cmake", "CMakePackage"), ("python", "PythonExtension")):
        path = f"spack_repo.builtin.build_systems.{name}"
        for end in (1, 2, 3):
            part = ".".join(path.split(".")[:end])
            modules[part] = types.ModuleType(part)
        modules[path] = types.ModuleType(path)
        setattr(modules[path], base, type(base, (), {}))
    for name, module in modules.items():
        monkeypatch.setitem(sys.modules, name, module)
    space = {"__file__": str(FOLDER / "package.py")}
    exec(compile((FOLDER / "package.py").read_text(), "package.py", "exec"), space)
    return asked, space["Raceway"]


def test_spack(spack):
    asked, package = spack
    assert ("version", VERSION) in asked and VERSION in package.url
    assert (ROOT / package.root_cmakelists_dir / "CMakeLists.txt").is_file()
    python = [one[1].removeprefix("py-") for one in asked if one[1].startswith("py-")]
    found = dict(one.rstrip(":").split("@") for one in python if "@" in one)
    assert {name: found.get(name) for name in NEEDED} == NEEDED
    assert set(found) - set(NEEDED) == {"setuptools"}
    assert ("extends", f"python@{PROJECT['requires-python'].removeprefix('>=')}:") in asked


def test_conda():
    recipe = yaml.safe_load((FOLDER / "recipe.yaml").read_text())
    assert recipe["context"]["version"] == VERSION == raceway.__version__
    run = [need.replace("matplotlib-base", "matplotlib") for need in recipe["requirements"]["run"]]
    found = dict(need.split(" >=") for need in run)
    assert found.pop("python") == PROJECT["requires-python"].removeprefix(">=")
    assert found == NEEDED
    assert recipe["about"]["license"] == PROJECT["license"]["text"]
