# SPDX-License-Identifier: GPL-2.0-or-later
"""The Python package as others install it: what it asks for, what it brings, where it works."""

import re
import shutil
import subprocess
import sys
import tomllib
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]
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
    """A lower bound and nothing more: `pip install raceway` changes no newer version."""
    name, least = re.fullmatch(r"([a-z]+)>=([\d.]+)", needed).groups()
    assert numbers(LOCK[name]) >= numbers(least)


def test_lock_has_everything():
    """Also what is only for tests, docs and bench; exact versions stand in both alike."""
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


@pytest.fixture(scope="module")
def wheel(tmp_path_factory):
    """What a wheel holds, as setuptools gathers it from a copy of the sources."""
    folder = tmp_path_factory.mktemp("wheel")
    for name in ("python", "inputs"):
        shutil.copytree(ROOT / name, folder / "source" / name, symlinks=True)
    subprocess.run(
        [sys.executable, "-c", "import setuptools; setuptools.setup()"]
        + ["build_py", "--build-lib", folder / "site"],
        cwd=folder / "source" / "python",
        check=True,
        capture_output=True,
    )
    shutil.rmtree(folder / "source")
    return folder / "site"


def test_wheel_has_the_data_files(wheel):
    for kind in ("bearings", "lubricants"):
        for path in (ROOT / "inputs" / kind).iterdir():
            copy = wheel / "raceway" / "data" / kind / path.name
            assert copy.read_text() == path.read_text() and not copy.is_symlink()


def test_installed_from_a_wheel(wheel, tmp_path):
    """`raceway static` finds its bearings where no source tree is near."""
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
    """A .venv names its folder: `make` notices that it was made elsewhere and makes it anew."""
    (tmp_path / "Makefile").write_text((ROOT / "Makefile").read_text())
    (tmp_path / "python").mkdir()
    for name in ("pyproject.toml", "requirements.lock"):
        (tmp_path / "python" / name).touch()
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
