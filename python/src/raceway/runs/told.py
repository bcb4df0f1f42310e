# SPDX-License-Identifier: GPL-2.0-or-later
"""What a record says of its run, as a dict that knows why a key is not there."""

from collections.abc import Callable, Mapping
from typing import Any


class Told(dict[str, Any]):
    """`values` by the names of `run.yaml`. A key that is missing is one bearing's own, or was
    measured: each of `needed` raises `RunError` where that is the reason."""

    def __init__(self, values: Mapping[str, Any], needed: tuple[Callable[[], None], ...]) -> None:
        super().__init__(values)
        self._needed = needed

    def __missing__(self, key: str) -> Any:
        for need in self._needed:
            need()
        raise KeyError(key)
