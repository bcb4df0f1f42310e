# SPDX-License-Identifier: GPL-2.0-or-later
"""Exceptions raised by the package. Formulas raise `ValueError` for values outside their domain."""

from collections.abc import Iterable
from difflib import get_close_matches


class RacewayError(Exception):
    """Base class of all errors that a user can cause; the text is a complete error message."""


class RunError(RacewayError):
    """A run folder is missing, broken, unfinished or inconsistent."""


class RunWarning(UserWarning):
    """A run folder is readable only in part."""


class NoEquilibrium(RacewayError):
    """The bearing cannot carry the load, or the position of its ring is indeterminate."""


class InputError(RacewayError):
    """A data file is missing, broken or incomplete."""


def unreadable(path: object, error: Exception) -> str:
    """Return the message about a file at `path` that cannot be read because of an `error`."""
    return f"cannot read {path}: {getattr(error, 'strerror', None) or error}"


def near(word: str, known: Iterable[str]) -> str:
    """Return the end of an error message about the wrong `word`, which suggests the most similar
    words among `known`, or an empty string if none is similar.

    >>> near("sumary", ["summary", "static"]), near("x", ["summary"])
    ('; did you mean summary?', '')
    """
    found = get_close_matches(word, list(known), 2, 0.6)
    return f"; did you mean {' or '.join(found)}?" if found else ""
