# SPDX-License-Identifier: GPL-2.0-or-later
"""Sphinx extension for `.. paper-statements::`, which lists the statements in the paper and the
verdicts on them, from the table that `raceway paper` uses."""

import re
from collections import Counter
from importlib import resources

from column_table import table
from docutils.statemachine import StringList
from raceway.paper.statements import AGREE, DIFFER, SAME, UNKNOWN, markup, read
from sphinx.util.docutils import SphinxDirective

SOURCE = resources.files("raceway.paper") / "statements.yaml"
HEADS = (
    "where",
    "the paper says",
    "corrected formulas",
    "printed formulas",
    "all of the capacitance",
    "why",
)


def reason(text):
    """Return those sentences of a reason that do not contain a result of a run."""
    return " ".join(one for one in re.split(r"(?<=[.;]) ", text) if "{" not in one)


def count(verdicts):
    totals = Counter(verdicts)
    return ", ".join(f"{totals[name]} {name}" for name in (AGREE, DIFFER, UNKNOWN))


class StatementTable(SphinxDirective):
    def run(self):
        self.env.note_dependency(str(SOURCE))
        all_of_them = read()
        whole = [one.found for one in all_of_them if one.found[2] != SAME]
        rows = [
            (
                markup(one.where),
                markup(one.says),
                *(name if name == SAME else f"**{name}**" for name in one.found),
                markup(reason(f"{one.why} {one.whole.get('why', '')}")),
            )
            for one in all_of_them
        ]
        lines = [
            f"{len(rows)} statements. With the corrected formulas: "
            + count(one.found[0] for one in all_of_them)
            + ". With the formulas as printed: "
            + count(one.found[one.found[1] != SAME] for one in all_of_them)
            + f". With all of the capacitance, {len(whole)} statements are judged again: "
            + count(one[2] for one in whole)
            + "; with the plates alone: "
            + count(one[0] for one in whole)
            + ".",
            "",
            *table("8 26 11 11 13 31", HEADS, rows),
        ]
        return self.parse_text_to_nodes(StringList(lines, source=str(SOURCE)))


def setup(app):
    app.add_directive("paper-statements", StatementTable)
    return {"parallel_read_safe": True}
