# SPDX-License-Identifier: GPL-2.0-or-later
"""The page of each fix lists all elements of its vectors, as defined in the C++ tables."""

import re

import pytest
from host import ROOT
from raceway import core

TABLES = core.table("columns")
FIXES = sorted(name for name in TABLES if name.startswith("fix_"))


def test_which_fixes_have_a_vector():
    """A fix that set size_vector to a literal number would not appear in the tables."""
    sources = (ROOT / "src-package" / "styles").glob("fix_bearing_*.cpp")
    vectors = {s.stem.replace("fix_bearing_", "fix_") for s in sources if sizes(s)}
    assert vectors - {"fix_checkpoint"} == set(FIXES)  # its length depends on the command


def sizes(source):
    return "provide_values(" in source.read_text() or "size_vector =" in source.read_text()


@pytest.mark.parametrize("name", FIXES)
def test_the_page_has_the_table(name):
    page = (ROOT / "docs" / f"{name.replace('fix_', 'fix_bearing_')}.rst").read_text()
    assert f".. columns:: {name}\n   :numbered:\n" in page
    source = (
        ROOT / "src-package/styles" / f"{name.replace('fix_', 'fix_bearing_')}.cpp"
    ).read_text()
    assert re.search(rf"bearing::of_{name}::N[,);]", source)
