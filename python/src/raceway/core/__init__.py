# SPDX-License-Identifier: GPL-2.0-or-later
"""Access to the C++ library (src-package/core) that implements the laws of contact, film, oil and
circuit for both the simulation and Python.

`laws` has each formula as an attribute, and `table` returns the tables of columns and variables.
The library is built by `make build` and by `pip install ./python`.
"""

import ctypes
import functools
import json
from collections.abc import Iterable
from pathlib import Path
from typing import TYPE_CHECKING, Any

from raceway.errors import RacewayError

if TYPE_CHECKING:  # `exports` loads numpy, which `table` does not need
    from raceway.core.exports import Formula, Library

PATH = Path(__file__).with_name("lib") / "libraceway_core.so"


class NotBuilt(RacewayError, ImportError):
    """The library has not been built."""


def _built():
    if not PATH.exists():
        raise NotBuilt(f"{PATH} is missing: run `make build`, or `pip install ./python` again")
    return PATH


@functools.cache
def library() -> "Library":
    """Load the library on first use and return it. Raises `NotBuilt`."""
    from raceway.core.exports import Library

    return Library(_built())


@functools.cache
def table(name: str) -> Any:
    """Return a table that is defined in C++. "columns" is a dict {section: rows} with the output
    columns, the parts of the contact law and the rules of validity; "variables" is the list of deck
    variables. Raises `NotBuilt`."""
    text = ctypes.CDLL(str(_built()))[f"{name}_json"]
    text.restype = ctypes.c_char_p
    return json.loads(text())


def mistyped(names: Iterable[str]) -> str:
    """Return the message that decks print if one of the `names` in a data file is mistyped, or an
    empty string if none is. Raises `NotBuilt`."""
    return _message("mistyped_name", " ".join(names))


def wrong_value(name: str, value: str) -> str:
    """Return the message that decks print if the variable `name` cannot have the `value`, or an
    empty string if it can. Raises `NotBuilt`."""
    return _message("wrong_value", name, value)


def usual_cage(models: str, integrator: str, lubricant: str, cage_balls: str = "") -> str:
    """Return the kind of cage, ring or chain, that `cage auto` stands for. `cage_balls` is empty
    unless there are data of cage balls. Raises `NotBuilt`."""
    return _message("usual_cage", models, integrator, lubricant, cage_balls)


@functools.cache  # most data files have the same names, and many rows of a table the same values
def _message(function, *words):
    message = ctypes.CDLL(str(_built()))[function]
    message.restype, message.argtypes = ctypes.c_char_p, [ctypes.c_char_p] * len(words)
    return message(*(word.encode() for word in words)).decode()


class Laws:
    """Namespace of the library's formulas; each attribute is looked up on first use."""

    def __getattr__(self, name: str) -> "Formula":
        found = library().formula(name)
        setattr(self, name, found)
        return found


laws = Laws()
