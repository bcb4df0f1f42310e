# SPDX-License-Identifier: GPL-2.0-or-later
"""Sphinx: `.. columns:: SECTION` is a table of output columns, from the file that `make columns`
writes."""

import json
from pathlib import Path

from docutils.statemachine import StringList
from sphinx.util.docutils import SphinxDirective

COLUMNS = Path(__file__).resolve().parents[1] / "python" / "src" / "raceway" / "columns.json"
NEEDS = {
    "film": "*bearing/ehd* only",
    "capacitance": "needs :doc:`fix_bearing_capacitance`",
}


def rows(section: str, numbered: bool) -> list[tuple[str, str]]:
    """(name or number and name, meaning with unit and needs) of the columns of a section."""
    found = []
    for number, column in enumerate(json.loads(COLUMNS.read_text())[section], 1):
        name = f"*{column['name']}*"
        text = column["meaning"] + (f" ({column['unit']})" if column["unit"] else "")
        if needs := NEEDS.get(column.get("needs")):
            text += f"; {needs}"
        found.append((f"{number} {name}" if numbered else name, text))
    return found


class ColumnTable(SphinxDirective):
    """The option `numbered` puts the place in a vector before each name."""

    required_arguments = 1
    option_spec = {"numbered": lambda argument: True}

    def run(self):
        self.env.note_dependency(str(COLUMNS))
        lines = [".. list-table::", "   :header-rows: 1", "   :widths: 20 80", ""]
        lines += ["   * - column", "     - meaning"]
        for name, text in rows(self.arguments[0], "numbered" in self.options):
            lines += [f"   * - {name}", f"     - {text}"]
        return self.parse_text_to_nodes(StringList(lines, source=str(COLUMNS)))


def setup(app):
    app.add_directive("columns", ColumnTable)
    return {"parallel_read_safe": True}
