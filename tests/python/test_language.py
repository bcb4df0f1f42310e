# SPDX-License-Identifier: GPL-2.0-or-later
"""The glossary of docs/design.rst and the layout in README.md match the tree."""

import re
import subprocess
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]


def glossary():
    """{term: keys of output that it has} of the glossary."""
    text = (ROOT / "docs/design.rst").read_text()
    table = text.split(".. _glossary:")[1].split("The contact table\n")[0]
    rows = [row.splitlines() for row in table.split("   * - ")[2:]]  # without the heading
    return {row[0].strip(): re.findall(r"``(\w+)``", row[2]) for row in rows}


def test_a_term_stands_once_in_the_glossary():
    text = (ROOT / "docs/design.rst").read_text()
    terms = re.findall(r"^   \* - (.+)$", text.split(".. _glossary:")[1], re.MULTILINE)
    assert len(terms) > 30 and len(set(terms)) == len(terms)


def test_a_key_belongs_to_one_term():
    keys = [key for found in glossary().values() for key in found]
    assert len(keys) > 20 and len(set(keys)) == len(keys)


def test_readme_names_every_folder():
    files = subprocess.run(
        ["git", "ls-files"], cwd=ROOT, capture_output=True, text=True, check=True
    ).stdout.splitlines()
    folders = {name.split("/")[0] for name in files if "/" in name}
    for parent in ("src-package", "inputs", "docs"):
        folders |= {"/".join(name.split("/")[:2]) for name in files if name.startswith(f"{parent}/")
                    and name.count("/") > 1}  # fmt: skip
    layout = (ROOT / "README.md").read_text().split("## Layout")[1]
    assert not {folder for folder in folders - {"src-package"} if f"`{folder}`" not in layout}
