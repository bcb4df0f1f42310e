# SPDX-License-Identifier: GPL-2.0-or-later
"""Read the points of a sweep from a table whose columns are variables of a deck, and check them
before anything runs."""

import hashlib
import math
import re
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import NamedTuple

from raceway import core, files, units
from raceway.errors import RacewayError, near, unreadable
from raceway.files import FilePath
from raceway.sweeps import variable_table

INDEX = re.compile(r"^\s*variable\s+(\w+)\s+index\s+(\S+)", re.MULTILINE)
# patterns that find variables that a command uses if they exist, the command that reads the data of
# a bearing, a word that ends with the value of a variable, and a deck in the same folder
VARS = re.compile(r"^(?!\s*#)[^#\n]*?\bvars ((?:\w+[ \t]*)+)", re.MULTILINE)
BEARING = re.compile(r"^bearing\s", re.MULTILINE)
USED = re.compile(r"\$\{(\w+)\}$")
DECK = re.compile(r"^include \S*?/(in\.\S+)", re.MULTILINE)
# Values and paths may contain these characters, none of which is special in a deck or a shell.
WORD = re.compile(r"[A-Za-z0-9_.+/-]+")
OURS = {
    "out": "the sweep gives every point its own folder",
    "resume": "the sweep resumes points by itself",
    "overwrite": "the sweep skips finished points by itself",
    "inputs": "it is the folder of the deck's data files; start from a folder where it is found",
}
SHARE = "share"  # column that is not a variable but the fraction of the time, for load spectra
LONGEST = 160  # maximum length of a folder name, well below the limit of 255 of file systems
SHOWN = 20  # largest number of errors in one message
LISTED = 20  # largest number of variables in one message


class TableError(RacewayError):
    """Raised if the table of a sweep cannot be used; the message lists the errors row by row."""


class Point(NamedTuple):
    """A point of a sweep.

    It consists of the name of its folder, the variables in the order of the deck, with values as
    written in the table, and its time share in a load spectrum, which is "" if the table has no
    shares.
    """

    name: str
    variables: dict[str, str]
    share: str = ""


def deck_variables(deck: FilePath) -> dict[str, str]:
    """Return names (in order) and defaults of the variables that a user may set.

    They are defined by the `variable NAME index` lines of the deck at path `deck` and of the decks
    that it includes, and by the words after `vars` in its commands, whose defaults are given by
    those commands (`variable_table`). A default that comes from data files is empty. Raise
    `TableError` if the deck cannot be read.
    """
    found: dict[str, str] = {}
    _add_variables(found, Path(deck))
    if not found:
        raise TableError(
            f"{deck} has no line 'variable NAME index VALUE': there is nothing to vary"
        )
    return found


def _text(path):
    """Return the text of a deck with every command on one line."""
    return re.sub(r"&[ \t]*\n", " ", path.read_text())


def _add_variables(found, path):
    """Add the variables of a file to `found`."""
    try:
        text = _text(path)
    except (OSError, UnicodeDecodeError) as error:
        raise TableError(
            f"{unreadable(f'deck {path}', error)}; `raceway decks {path.name}` copies one of the"
            " package's decks here"
        ) from None
    for name, default in INDEX.findall(text):
        found.setdefault(name, default)
    for name in " ".join(VARS.findall(text)).split():
        found.setdefault(name, variable_table.default(name))
    if BEARING.search(text):
        for name in variable_table.data():
            found.setdefault(name, "")
    for name in DECK.findall(text):  # keep the order and the defaults of the including deck
        included: dict[str, str] = {}
        _add_variables(included, path.parent / name)
        ordered = {key: found.get(key, value) for key, value in included.items()}
        own = dict(found)
        found.clear()
        found.update(ordered | own)


def read_points(table: FilePath, variables: Mapping[str, str]) -> list[Point]:
    """Return the `Point` objects in the CSV file `table` (path), in the order of the file.

    `variables` is the result of `deck_variables`. Empty lines and lines that start with # are
    skipped. Raise `TableError` for unknown or repeated columns, rows of different length, empty
    cells, values that are not a single word, numbers with a unit, and rows that request the same
    point twice ("5000" and "5e3" are the same).
    """
    lines = files.csv_rows(table, TableError)
    if not lines:
        raise TableError(f"{table} is empty: the first line must name variables of the deck")
    columns, wrong = [cell.strip() for cell in lines[0][1]], []
    for name in sorted(set(columns)):
        if name in OURS:
            wrong.append(f"column '{name}' cannot be swept: {OURS[name]}")
        elif name not in variables and name != SHARE:
            wrong.append(f"column '{name}' is not a variable of the deck{near(name, variables)}")
        if columns.count(name) > 1:
            wrong.append(f"column '{name}' occurs {columns.count(name)} times")
    if wrong:
        names = [name for name in variables if name not in OURS]
        some = names if len(names) <= LISTED else [*names[:LISTED], f"{len(names)} in all"]
        text = _some(wrong)
        text += " Variables: " if text.endswith("?") else "; variables: "
        raise TableError(f"{table}: {text}{', '.join(some)}")
    if len(lines) == 1:
        raise TableError(f"{table} has no rows below its header")
    points, seen, order = [], {}, [name for name in variables if name in columns]
    numbers = {
        row["name"]: row["unit"]
        for row in variable_table.rows()
        if row["unit"] and isinstance(_value(variables.get(row["name"], "")), float)
    }
    shared = SHARE in columns and SHARE not in order
    for number, cells in lines[1:]:
        cells = [cell.strip() for cell in cells]
        if len(cells) != len(columns):
            wrong.append(f"line {number}: {len(cells)} cells instead of {len(columns)}")
            continue
        row = dict(zip(columns, cells))
        bad = [name for name in order if not WORD.fullmatch(row[name])]
        for name in bad:
            wrong.append(
                f"line {number}: {name} is "
                + (f"'{row[name]}', must be one word or number" if row[name] else "empty")
            )
        for name in order:
            if name in numbers and _has_unit(row[name], unit := numbers[name]):
                bad.append(name)
                wrong.append(
                    f"line {number}: {name} is '{row[name]}': give a number alone, in {unit}"
                )
        if shared and not _positive(row[SHARE]):
            wrong.append(f"line {number}: {SHARE} is '{row[SHARE]}', must be a number above 0")
            continue
        if bad:
            continue
        same = tuple(_value(row[name]) for name in order)
        if same in seen:
            wrong.append(f"line {number}: the same point as line {seen[same]}")
            continue
        seen[same] = number
        point = {name: row[name] for name in order}
        points.append(Point(folder_name(point), point, row[SHARE] if shared else ""))
    if wrong:
        raise TableError(f"{table}: {_some(wrong)}")
    return points


def check_ranges(table: FilePath, points: Sequence[Point], deck: FilePath) -> None:
    """Raise `TableError` with the message of the `deck` for values in the `table` that it refuses
    before it runs, i.e. for variables that it passes to a command under their own names, and for
    bearings and lubricants that do not exist."""
    passed = _passed(Path(deck))
    wrong = [
        f"{point.name}: {message}"
        for point in points
        for name, value in point.variables.items()
        if name in passed
        and (message := core.wrong_value(name, value) or _missing(name, value, point))
    ]
    if wrong:
        raise TableError(f"{table}: {_some(wrong)}")


def _missing(name, value, point):
    """Return a message if `value` is the name of a bearing or lubricant that does not exist."""
    if name not in ("bearing", "lubricant"):
        return None
    from raceway import catalogue  # it loads numpy, which no help of a command needs

    try:
        catalogue.find(f"{name}s", value, point.variables.get("inputs"))
    except RacewayError as error:
        return str(error)
    return None


def _passed(path):
    """Return the names of the variables whose ranges the deck at `path` checks (see
    `NameBearing::refuse_unknown`): those after `vars`, those in the form `load ${load}` or `moment
    ${moment_x}`, those of the main deck if the deck has all of them, and the data of bearings if it
    reads them."""
    text, names = _text(path), deck_variables(path)
    found = set(" ".join(VARS.findall(text)).split())
    for line in text.splitlines():
        words, keyword = line.partition("#")[0].split(), "variable"
        for word in words if words[:1] != ["variable"] else ():
            if not (name := USED.search(word)):
                keyword = word if word[0].isalpha() else keyword
            elif f"{name[1]}_".startswith(f"{keyword}_") or word == f"bearing/{name[0]}":
                found.add(name[1])
    rows = variable_table.rows()
    main = {row["name"] for row in rows if "deck" in row["of"].split("|")}
    found |= main if main <= names.keys() else set()
    found |= {row["name"] for row in rows if path.name in row["of"].split("|")}
    if BEARING.search(text):
        found |= {row["name"] for row in rows if "bearing data" in row["of"].split("|")}
    for name in DECK.findall(text):
        found |= _passed(path.parent / name)
    return found


def _some(wrong):
    more = [f"and {len(wrong) - SHOWN} more"] if len(wrong) > SHOWN else []
    return "; ".join(wrong[:SHOWN] + more)


def folder_name(variables: Mapping[str, str]) -> str:
    """Return a readable name that depends only on the variables, such as load=5000_rpm=477.5.

    A name that is long, or in which a path is shortened to its last component, ends with a digest.
    """
    name = "_".join(f"{key}={value}" for key, value in variables.items())
    short = "_".join(f"{key}={value.rsplit('/', 1)[-1]}" for key, value in variables.items())
    if len(name) <= LONGEST and name == short:
        return name
    return short[: LONGEST - 17] + "_" + hashlib.sha256(name.encode()).hexdigest()[:16]


def _has_unit(text, unit):
    """Return True if `text` is a number with a unit instead of a plain number in `unit`."""
    try:
        units.read(text, unit)
    except ValueError:
        return False
    return not isinstance(_value(text), float)


def _positive(text):
    value = _value(text)
    return isinstance(value, float) and 0 < value < math.inf


def _value(text):
    try:
        return float(text)
    except ValueError:
        return text
