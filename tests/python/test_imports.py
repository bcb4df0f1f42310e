# SPDX-License-Identifier: GPL-2.0-or-later
"""A command imports only the large packages that it needs."""

import subprocess
import sys

import pytest
from raceway.cli import modules

LARGE = {"numpy", "pandas", "matplotlib", "PIL", "xarray", "scipy", "yaml", "tqdm"}
SCRIPT = f"""
import sys
from raceway.cli import main
try:
    code = main(sys.argv[1:])
except SystemExit as end:
    code = end.code
print(*({LARGE} & sys.modules.keys()), file=sys.stderr)
sys.exit(code)
"""


def loaded(*arguments):
    """Return the large packages that `raceway` imports when it is called with these arguments."""
    done = subprocess.run(
        [sys.executable, "-c", SCRIPT, *map(str, arguments)],
        text=True,
        capture_output=True,
        check=True,
    )
    return set(done.stderr.splitlines()[-1].split())


@pytest.mark.parametrize("command", ["", *(one.__name__.rpartition(".")[2] for one in modules())])
def test_help_loads_none(command):
    assert loaded(*command.split(), "--help") == set()


def test_summary(folder):
    assert loaded("summary", folder) == {"numpy", "yaml"}


def test_gather(folder):
    (folder / "point.yaml").write_text("load: '5000'\n")
    assert loaded("gather", folder.parent) == {"numpy", "yaml"}


def test_static():
    assert loaded("static", "--load", "2000") == {"numpy"}


def test_plot(folder, tmp_path):
    """The test detects that a command that draws a picture imports the packages needed for it."""
    assert "matplotlib" in loaded("plot", folder, "--out", tmp_path / "picture.png")
