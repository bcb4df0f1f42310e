# SPDX-License-Identifier: GPL-2.0-or-later
"""Sphinx extension for tables that C++ exports: `.. columns:: SECTION` for output columns,
`.. law-keywords:: dry|film` for keywords of the contact law, `.. law-parts::` for the parts of the
law, `.. validity::` for validity rules, `.. oil-constants::` for the default constants of oils, and
`.. deck-variables:: COMMAND|DECK` for the deck variables of a command or a deck."""

import re
from pathlib import Path

from docutils.statemachine import StringList
from raceway import core
from raceway.sweeps import variable_table
from sphinx.util.docutils import SphinxDirective

COLUMNS = core.PATH  # the library that contains the tables
INPUTS = Path(__file__).resolve().parents[1] / "inputs"
APART = ("bearing/heat", "usual data")  # these have a table of their own
NEEDS = {
    "film": "*bearing/ehd* only",
    "capacitance": "needs :doc:`fix_bearing_capacitance`",
    "surroundings": "needs :doc:`fix_bearing_capacitance` with *surroundings*",
}


def rows(section: str, numbered: bool) -> list[tuple[str, str]]:
    """Return a list of (name, meaning with unit and prerequisites) for the columns of a section; if
    `numbered`, each name is preceded by its number."""
    found = []
    for number, column in enumerate(core.table("columns")[section], 1):
        name = f"*{column['name']}*"
        text = column["meaning"] + (f" ({column['unit']})" if column["unit"] else "")
        if needs := NEEDS.get(column.get("needs")):
            text += f"; {needs}"
        found.append((f"{number} {name}" if numbered else name, text))
    return found


class ColumnTable(SphinxDirective):
    """Table of columns. With the option `numbered`, each name is preceded by its index in the
    vector."""

    required_arguments = 1
    option_spec = {"numbered": lambda argument: True}

    def run(self):
        self.env.note_dependency(str(COLUMNS))
        found = rows(self.arguments[0], "numbered" in self.options)
        lines = table("20 80", ("column", "meaning"), found)
        return self.parse_text_to_nodes(StringList(lines, source=str(COLUMNS)))


def range_of(parameter: dict) -> str:
    """Return the range of a number as "> 0", "0 or more" or "0 to 2", or "" for a word."""
    if parameter["choices"]:
        return ""
    if parameter["most"] is not None:
        return f"{parameter['least']:g} to {parameter['most']:g}"
    return "> 0" if parameter["open"] else "0 or more"


def keyword_rows(film: bool) -> list[tuple[str, str, str]]:
    """Return a list of (keyword and values, meaning with range, default) for the contact law."""
    found, seen = [], set()
    for part in core.table("columns")["law"]:
        for keyword in part["keywords"]:
            name, parameters = keyword["name"], keyword["parameters"]
            if keyword["form"] and name not in seen and not film:
                found.append((f"*{name}* none", f"no {name}", "none"))
            seen.add(name)
            if part["film"] != film:
                continue
            symbols = " ".join(p["symbol"].replace("|", " | ") for p in parameters)
            texts = [" ".join([p["meaning"], range_of(p)]).strip() for p in parameters]
            initial = ", ".join(dict.fromkeys(p["initial"] for p in parameters))
            found.append(
                (
                    f"*{name}* {keyword['form']} {symbols}".replace("  ", " "),
                    "; ".join(filter(None, [*texts, keyword["note"]])),
                    ""
                    if part["when"] == "on request" and not keyword["name"] == "tangential"
                    else initial,
                )
            )
    return found


def part_rows() -> list[tuple[str, ...]]:
    """Return a list of (part, condition for the part, keywords, number of states, columns)."""
    return [
        (
            f"*{part['name']}*",
            part["when"],
            ", ".join(dict.fromkeys(f"*{k['name']}*" for k in part["keywords"])),
            str(part["states"]),
            ", ".join(f"*{c}*" for c in part["columns"]),
        )
        for part in core.table("columns")["law"]
    ]


def table(widths: str, heads: tuple[str, ...], rows: list[tuple[str, ...]]) -> list[str]:
    """Return the lines of a list-table directive."""
    lines = [".. list-table::", "   :header-rows: 1", f"   :widths: {widths}", ""]
    for row in [heads, *rows]:
        lines += [f"   {'*' if n == 0 else ' '} - {cell}".rstrip() for n, cell in enumerate(row)]
    return lines


class KeywordTable(SphinxDirective):
    """Keywords of the contact law: those that every pair style accepts (dry), or those that require
    a lubricant (film)."""

    required_arguments = 1

    def run(self):
        self.env.note_dependency(str(COLUMNS))
        heads = ("keyword and values", "meaning", "default")
        lines = table("30 50 20", heads, keyword_rows(self.arguments[0] == "film"))
        return self.parse_text_to_nodes(StringList(lines, source=str(COLUMNS)))


class PartTable(SphinxDirective):
    def run(self):
        self.env.note_dependency(str(COLUMNS))
        heads = ("part", "in the law", "keywords", "states", "columns")
        lines = table("22 18 24 8 28", heads, part_rows())
        return self.parse_text_to_nodes(StringList(lines, source=str(COLUMNS)))


class ValidityTable(SphinxDirective):
    def run(self):
        self.env.note_dependency(str(COLUMNS))
        rules = core.table("columns")["validity"]

        def side(rule):
            return "below" if rule["below"] else "above"

        rows = [
            (
                r["value"],
                f"{'below' if r['below'] else 'above'} {r['bound']:g} {r['unit']}",
                r["limit"],
            )
            for r in rules
        ]
        lines = table("35 20 45", ("quantity", "warning if", "reason"), rows)
        return self.parse_text_to_nodes(StringList(lines, source=str(COLUMNS)))


class OilTable(SphinxDirective):
    """Constants of oils, with their defaults and effects."""

    def run(self):
        self.env.note_dependency(str(COLUMNS))
        rows = [
            (f"*{r['name']}*", f"{r['default']} {r['unit']}".strip(), r["meaning"])
            for r in variable_table.oil().values()
        ]
        lines = table("25 20 55", ("constant", "default", "meaning and effect"), rows)
        return self.parse_text_to_nodes(StringList(lines, source=str(COLUMNS)))


def range_of_variable(row: dict) -> str:
    """Return the range of a deck variable as "1 to 5", "1 to 5, or 0" or a list of words."""
    first, *rest = row["range"].split() or [""]
    if first == "one_of":
        return ", ".join(rest)
    text = f"{first} to {' '.join(rest)}" if rest else ""
    return text.replace(" or ", ", or ").replace(" whole", ", whole")


def of_deck(name: str) -> dict[str, str]:
    """Return {variable: default, or "" if it is that of the command} for a deck in inputs."""
    text = (INPUTS / name).read_text().replace("&\n", "")
    passed = " ".join(re.findall(r"\bvars\b(.*)", text)).split()
    return dict.fromkeys(passed, "") | dict(re.findall(r"^variable (\S+) +index (\S+)", text, re.M))


class DeckVariables(SphinxDirective):
    """Deck variables that set the keywords of one command, or those of a deck in inputs."""

    required_arguments = 1

    def run(self):
        self.env.note_dependency(str(COLUMNS))
        of = self.arguments[0]
        deck = of_deck(of) if of == "in.6208" else {}
        rows = [
            (
                f"``{r['name']}``",
                deck.get(r["name"]) or r["default"],
                range_of_variable(r),
                r["meaning"] + (f" ({r['unit']})" if r["unit"] else ""),
            )
            for r in variable_table.rows()
            if r["of"] == of or (r["name"] in deck and r["of"] not in APART)
        ]
        lines = table("20 14 22 44", ("variable", "default", "range", "meaning"), rows)
        return self.parse_text_to_nodes(StringList(lines, source=str(COLUMNS)))


def setup(app):
    app.add_directive("columns", ColumnTable)
    app.add_directive("deck-variables", DeckVariables)
    app.add_directive("oil-constants", OilTable)
    app.add_directive("law-keywords", KeywordTable)
    app.add_directive("law-parts", PartTable)
    app.add_directive("validity", ValidityTable)
    return {"parallel_read_safe": True}
