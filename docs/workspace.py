# SPDX-License-Identifier: GPL-2.0-or-later
"""A folder that looks like the built tree to a page's commands and is thrown away afterwards."""

import shutil
import tempfile
from contextlib import contextmanager
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]


@contextmanager
def workspace(program=ROOT / "build/liggghts"):
    """A temporary folder with copies of `inputs` and `docs/decks`, the built `program` and the
    Python environment."""
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        shutil.copytree(ROOT / "inputs", folder / "inputs")
        shutil.copytree(ROOT / "docs/decks", folder / "docs/decks")
        (folder / "build").mkdir()
        (folder / "build/liggghts").symlink_to(program)
        (folder / ".venv").symlink_to(ROOT / ".venv")
        yield folder
