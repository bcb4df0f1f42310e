# SPDX-License-Identifier: GPL-2.0-or-later
"""The laws of contact, film, oil and circuit: one C++ library (src-package/core) for the simulation
and for Python.

`laws` has each formula by its name. `make build` and `pip install ./python` build the library.
"""

import functools
from pathlib import Path

from raceway.core.exports import Formula, Library
from raceway.errors import RacewayError

PATH = Path(__file__).with_name("lib") / "libraceway_core.so"


class NotBuilt(RacewayError, ImportError):
    """The library is missing."""


@functools.cache
def library() -> Library:
    """The library, loaded on first use. Raises `NotBuilt`."""
    if not PATH.exists():
        raise NotBuilt(f"{PATH} is missing: run `make build`, or `pip install ./python` again")
    return Library(PATH)


class Laws:
    """Each formula of the library as an attribute, found on first use."""

    def __getattr__(self, name: str) -> Formula:
        found = library().formula(name)
        setattr(self, name, found)
        return found


laws = Laws()
