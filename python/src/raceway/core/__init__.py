# SPDX-License-Identifier: GPL-2.0-or-later
"""The laws of contact, film, oil and circuit: one C++ library (src-package/core) for the simulation
and for Python.

`laws` gives each formula by name, `table` gives the tables of columns and variables. `make build`
and `pip install ./python` build the library.
"""

import ctypes
import functools
import json
from collections.abc import Iterable
from pathlib import Path
from typing import TYPE_CHECKING, Any

from raceway.errors import RacewayError

if TYPE_CHECKING:  # loads numpy, which `table` does not need
    from raceway.core.exports import Formula, Library

PATH = Path(__file__).with_name("lib") / "libraceway_core.so"


class NotBuilt(RacewayError, ImportError):
    """The library is missing."""


def _built():
    if not PATH.exists():
        raise NotBuilt(f"{PATH} is missing: run `make build`, or `pip install ./python` again")
    return PATH


@functools.cache
def library() -> "Library":
    """The library, loaded on first use. Raises `NotBuilt`."""
    from raceway.core.exports import Library

    return Library(_built())


@functools.cache
def table(name: str) -> Any:
    """A table defined in C++. "columns" is {section: rows} of output columns, parts of the contact
    law and rules of validity; "variables" is the rows of the variables of decks. Raises
    `NotBuilt`."""
    text = ctypes.CDLL(str(_built()))[f"{name}_json"]
    text.restype = ctypes.c_char_p
    return json.loads(text())


def mistyped(names: Iterable[str]) -> str:
    """The message that decks print about a mistyped name among the `names` of a data file; empty if
    there is none. Raises `NotBuilt`."""
    return _mistyped(" ".join(names))


@functools.cache  # data files mostly have the same names
def _mistyped(names):
    message = ctypes.CDLL(str(_built())).mistyped_name
    message.restype, message.argtypes = ctypes.c_char_p, [ctypes.c_char_p]
    return message(names.encode()).decode()


class Laws:
    """Each formula of the library as an attribute, found on first use."""

    def __getattr__(self, name: str) -> "Formula":
        found = library().formula(name)
        setattr(self, name, found)
        return found


laws = Laws()
