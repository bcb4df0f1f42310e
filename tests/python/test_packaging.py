# SPDX-License-Identifier: GPL-2.0-or-later
"""Tests of the installed Python package: its requirements, its contents, and use in any folder."""

import os
import re
import shutil
import subprocess
import sys
import tomllib

import pytest
from host import ROOT
from raceway import core

PROJECT = tomllib.loads((ROOT / "python" / "pyproject.toml").read_text())["project"]
LOCK = dict(
    line.lower().split("==")
    for line in (ROOT / "python" / "requirements.lock").read_text().splitlines()
    if line and not line.startswith("#")
)


def numbers(version):
    return [int(part) for part in version.split(".")]


@pytest.mark.parametrize("needed", PROJECT["dependencies"])
def test_what_is_installed_already_stays(needed):
    """Requirements are only lower bounds, because `pip install raceway` must not replace a newer
    version."""
    name, least = re.fullmatch(r"([a-z]+)>=([\d.]+)", needed).groups()
    assert numbers(LOCK[name]) >= numbers(least)


def test_lock_has_everything():
    """The lock file also contains the packages for tests, docs and benches. If pyproject.toml
    requires an exact version, the lock file contains this version."""
    asked = [need for extra in PROJECT["optional-dependencies"].values() for need in extra]
    for need in asked:
        name, bound, version = re.fullmatch(
            r"([\w-]+)(?:\[[\w,]+\])?(?:([=>]=)([\d.]+))?", need
        ).groups()
        if name == "raceway":
            continue
        assert name.lower() in LOCK, need
        if bound == "==":
            assert LOCK[name.lower()] == version


def copy_sources(folder):
    """Copy the files of the package as they are in a checkout in which neither `make` nor `pip` has
    built anything."""
    built = shutil.ignore_patterns("libraceway_core.so", "build", "*.egg-info")
    for name in ("python", "inputs", "src-package/core"):
        shutil.copytree(ROOT / name, folder / name, symlinks=True, ignore=built)
    return folder / "python"


@pytest.fixture(scope="module")
def wheel(tmp_path_factory):
    """Return the files of a wheel that setuptools builds from a copy of the sources, with a library
    that is compiled without optimisation, by clang because it takes less time than g++."""
    folder = tmp_path_factory.mktemp("wheel")
    compiler = folder / "compiler"
    compiler.write_text('#!/bin/sh\nexec clang++ "$@" -O0\n')
    compiler.chmod(0o755)
    subprocess.run(
        [sys.executable, "setup.py", "-q", "build", "--build-lib", folder / "site"],
        cwd=copy_sources(folder / "source"),
        env={**os.environ, "CXX": str(compiler)},
        check=True,
        capture_output=True,
    )
    shutil.rmtree(folder / "source")
    return folder / "site"


def test_an_install_without_a_compiler_asks_for_one(tmp_path):
    done = subprocess.run(
        [sys.executable, "setup.py", "-q", "build_ext", "--inplace"],
        cwd=copy_sources(tmp_path),
        env={"PATH": str(tmp_path)},
        text=True,
        capture_output=True,
    )
    assert done.returncode
    assert "needs a C++ compiler for its laws: install g++, or set CXX" in done.stderr


def test_without_the_library_a_law_says_what_to_run(tmp_path, monkeypatch):
    monkeypatch.setattr(core, "PATH", tmp_path / "libraceway_core.so")
    core.library.cache_clear()
    with pytest.raises(ImportError, match="run `make build`, or `pip install ./python` again"):
        core.library()
    core.library.cache_clear()


def test_wheel_has_the_data_files(wheel):
    files = [path for path in (ROOT / "inputs").rglob("*") if path.is_file()]
    assert len(files) > 30
    for path in files:
        copy = wheel / "raceway" / "data" / path.relative_to(ROOT / "inputs")
        assert copy.read_text() == path.read_text() and not copy.is_symlink()
    assert (wheel / "raceway" / "py.typed").exists()


def test_installed_from_a_wheel(wheel, tmp_path):
    """An installed `raceway static` finds its bearings even if there is no source tree."""
    done = subprocess.run(
        [
            sys.executable,
            "-c",
            "import sys\nsys.path.insert(0, sys.argv.pop(1))\nfrom raceway.cli import main\n"
            "import raceway.catalogue\nprint(raceway.catalogue.folder())\nsys.exit(main())",
            wheel,
            "static",
            "--load",
            "2000",
            "--bearing",
            "7205B",
        ],
        cwd=tmp_path,
        text=True,
        capture_output=True,
        check=True,
    )
    assert done.stdout.startswith(str(wheel / "raceway" / "data"))


def test_folder_that_was_moved(tmp_path):
    """A .venv contains the path of its folder. `make` detects that a .venv was created in another
    folder, and creates a new one."""
    (tmp_path / "Makefile").write_text((ROOT / "Makefile").read_text())
    for name in (
        "python/pyproject.toml",
        "python/requirements.lock",
        "src-package/core/settings/raceway_version.h",
        "src-package/core/interface/tables.txt",
        "src-package/core/interface/compile_flags.txt",
    ):
        (tmp_path / name).parent.mkdir(parents=True, exist_ok=True)
        (tmp_path / name).touch()
    (tmp_path / ".venv" / "bin").mkdir(parents=True)

    def planned(made_in):
        (tmp_path / ".venv" / "bin" / "pip").write_text(f"#!{made_in}/.venv/bin/python3\n")
        (tmp_path / ".venv" / ".installed").touch()
        return subprocess.run(
            ["make", "-n", ".venv/.installed"],
            cwd=tmp_path,
            text=True,
            capture_output=True,
            check=True,
        ).stdout

    assert "rm -rf .venv" not in planned(tmp_path)
    assert "made in /home/old: making a new one" in planned("/home/old")
