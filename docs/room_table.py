# SPDX-License-Identifier: GPL-2.0-or-later
"""Sphinx extension for `.. rooms::`, which lists the folders of src-package with their contents,
numbers of files and floors, and the longest chain of includes. The numbers are determined from the
current sources (tests/include_graph.py)."""

import sys
from pathlib import Path

from column_table import table
from docutils.statemachine import StringList
from sphinx.util.docutils import SphinxDirective

ROOT = Path(__file__).resolve().parents[1]
sys.path.insert(0, str(ROOT / "tests"))
import include_graph  # noqa: E402  this module belongs to the tests, not to a package


class RoomTable(SphinxDirective):
    def run(self):
        self.env.note_reread()
        graph = include_graph.read(ROOT / "src-package")
        rows = [
            (f"``{name}``", holds, str(files), str(floors))
            for name, files, floors, holds in reversed(include_graph.table(graph))
        ]
        lines = table("18 60 10 12", ("room", "contents", "files", "floors"), rows)
        chain = include_graph.longest_chain(graph)[0]
        lines += [
            "",
            f"The longest chain of includes has {len(chain)} files, from ``{chain[0]}`` to "
            f"``{chain[-1]}``.",
        ]
        return self.parse_text_to_nodes(StringList(lines, source=str(ROOT / "src-package")))


def setup(app):
    app.add_directive("rooms", RoomTable)
    return {"parallel_read_safe": True}
