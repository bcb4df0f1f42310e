# SPDX-License-Identifier: GPL-2.0-or-later
"""List and copy the decks and data files that are shipped with the package."""

from pathlib import Path

from raceway import catalogue, data_file, data_table, files
from raceway.errors import InputError
from raceway.files import FilePath

# the folder in which decks look for their data, relative to the working directory
INPUTS = "inputs"


def decks() -> dict[str, str]:
    """Return {name: title} for all decks, where the title is the first comment in the deck."""
    return {path.name: _title(path.read_text()) for path in sorted(catalogue.SHIPPED.glob("in.*"))}


def lubricants() -> dict[str, str]:
    """Return {name: title} for all lubricants."""
    shelf = catalogue.SHIPPED / "lubricants"
    return {name: _title(data_file.text(shelf / name)) for name in data_table.names(shelf)}


def bearings() -> list[str]:
    """Return the names of all bearings, whether they are files or rows of tables."""
    return list(data_table.names(catalogue.SHIPPED / "bearings"))


def copy(name: str, to: FilePath = ".") -> list[Path]:
    """Copy the deck, bearing or lubricant `name` to the folder `to`, and return the paths of the
    files written. A deck is copied together with a folder `inputs` that contains all files it
    reads.

    An existing file with identical text is not rewritten. Raises `InputError` if the name is
    unknown or if a file with different text exists; in the latter case nothing is written.
    """
    shipped, to = catalogue.SHIPPED, Path(to)
    if name in decks():
        wanted = {to / name: shipped / name} | {
            to / INPUTS / path.relative_to(shipped): path
            for path in sorted(shipped.rglob("*"))
            if path.is_file()
        }
        texts = {path: source.read_text() for path, source in wanted.items()}
    else:
        for kind in catalogue.KINDS:
            source = shipped / kind / name
            if name in data_table.names(source.parent):
                texts = {to / name: data_file.text(source)}
                break
        else:
            raise InputError(f"there is no deck, bearing or lubricant '{name}' (raceway decks)")
    texts = {path: text for path, text in texts.items() if not _is(path, text)}
    for path in texts:
        if path.exists():
            raise InputError(f"{path} exists with different text: remove it, or copy elsewhere")
    for path, text in texts.items():
        files.folder(path.parent)
        files.text(path, text)
    return list(texts)


def _is(path, text):
    return path.is_file() and path.read_text() == text


def _title(text):
    """Return the first line of a file without its comment mark."""
    return text.partition("\n")[0].lstrip("# ")
