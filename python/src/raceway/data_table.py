# SPDX-License-Identifier: GPL-2.0-or-later
"""Lines of data files, and tables of data files, `FOLDER/*.csv`, in which each row replaces a data
file of the same name (see `docs/catalogue.rst` for the format)."""

import re
from collections.abc import Hashable
from functools import lru_cache
from pathlib import Path
from typing import NamedTuple

from raceway import files
from raceway.errors import InputError, unreadable

# a comment that explains a column or a source
SAID = re.compile(r"# (\w[\w ]*): (.+)")
SIZES = ("bore_diameter", "outside_diameter", "bearing_width")


class Line(NamedTuple):
    """A line `variable NAME index VALUE # COMMENT` of a data file."""

    name: str
    value: str
    comment: str  # empty if there is none


def line(text: str, place: str) -> Line | None:
    """Return the `Line` that `text` contains, or None if it is blank or a comment. As in decks,
    words after the value are ignored. Raises `InputError`, which names the `place`, for text in
    another form."""
    before, _, comment = text.partition("#")
    match before.split():
        case []:
            return None
        case ["variable", name, "index", value, *_]:
            return Line(name, value, comment.strip())
    raise InputError(f"{place}: a line of data is 'variable NAME index VALUE', not '{text}'")


def aligned(text: str) -> str:
    """Return the `text` of a data file with its names, values and comments in columns."""
    rows = text.splitlines()
    data = {number: found for number, row in enumerate(rows) if (found := line(row, row))}
    names, values = (max(len(one[k]) for one in data.values()) for k in (0, 1))
    for number, (name, value, comment) in data.items():
        note = f"# {comment}" if comment else ""
        rows[number] = f"variable {name:<{names}}  index {value:<{values}}  {note}".rstrip()
    return "\n".join(rows) + "\n"


def names(folder: Path) -> list[str]:
    """Return the sorted names of the data in a folder, i.e. of its files and of the rows of its
    tables. The list is empty if the folder does not exist."""
    if not folder.is_dir():
        return []
    files = {path.name for path in folder.iterdir() if path.is_file() and path.suffix != ".csv"}
    return sorted(files.union(*(table.rows for table in _tables(folder))))


def text(path: Path) -> str | None:
    """Return the text of the data file that is represented by the row `path.name` of a table in
    `path.parent`, with a comment after each value. Return None if there is no such row. Raises
    `InputError` if a table is invalid."""
    table = _of_row(path)
    return table.text(path.name) if table else None


def has(path: Path) -> bool:
    """Return True if a table in `path.parent` has the row `path.name`. Raises `InputError` if a
    table is invalid."""
    return _of_row(path) is not None


def _of_row(path):
    return next((table for table in _tables(path.parent) if path.name in table.rows), None)


def _tables(folder):
    for path in _paths(folder, files.version(folder)):
        yield _table(path, files.version(path))


def version(folder: Path) -> Hashable:
    """Return the `files.version` of all tables in a folder."""
    return tuple(map(files.version, _paths(folder, files.version(folder))))


@lru_cache(maxsize=8)
def _paths(folder, version):
    return sorted(folder.glob("*.csv"))


@lru_cache(maxsize=8)
def _table(path, version):
    return _Table(path)


class _Table:
    """A table with its comments, the commands that apply to all rows, its heading and its rows."""

    def __init__(self, path):
        self.path = path
        self.said, self.rows = {}, {}
        columns, common = None, {}
        try:
            lines = path.read_text(encoding="utf-8-sig").splitlines()
        except (OSError, UnicodeDecodeError) as error:
            raise InputError(unreadable(path, error)) from None
        for number, words in enumerate(lines, start=1):
            place = f"{path}, line {number}"
            if words.startswith("#"):
                if said := SAID.match(words):
                    self.said[said[1]] = said[2]
            elif not words.strip(" ,"):
                continue
            elif columns is None and words.startswith("name,"):
                columns = words.split(",")
            elif columns is None:
                common[place] = words.rstrip(",")
            else:
                self._add(columns, words.split(","), place)
        if columns is None:
            raise InputError(f"{path} has no heading that begins with name,")
        for place, words in common.items():
            line(words, place)
        self.common = list(common.values())
        end = columns.index("source") if "source" in columns else len(columns)
        self.variables = columns[1:end]

    def _add(self, columns, cells, place):
        if len(cells) != len(columns):
            raise InputError(
                f"{place}: {len(cells)} cells, must be {len(columns)} as in the heading"
            )
        if cells[0] in self.rows:
            raise InputError(f"{place}: a second row '{cells[0]}'")
        self.rows[cells[0]] = dict(zip(columns, cells))

    def text(self, name):
        row = self.rows[name]
        source = row.get("source", "")
        lines = [f"# {_title(row)}", f"# The row {name} of {self.path.name}, SI units."]
        if source in self.said:
            lines.append(f"# {source}: {self.said[source]}")
        for key in self.variables:
            if row[key]:
                comment = f" # {_filled(self.said[key], row)}" if key in self.said else ""
                lines.append(f"variable {key} index {row[key]}{comment}")
        return "\n".join([*lines, *self.common]) + "\n"


def _filled(said, row):
    """Return the comment `said`, with each name in braces replaced by the row's cell of that
    name."""
    return re.sub(r"\{(\w+)\}", lambda note: row.get(note[1], note[0]), said)


def _title(row):
    """Return the title of a bearing, such as "6306 deep groove ball bearing, 30 x 72 x 19 mm"."""
    kind = f" {row['kind']} ball bearing" if row.get("kind") else ""
    if not all(row.get(size) for size in SIZES):
        return row["name"] + kind
    return f"{row['name']}{kind}, {' x '.join(f'{1e3 * float(row[size]):g}' for size in SIZES)} mm"
