# SPDX-License-Identifier: GPL-2.0-or-later
"""A line on the terminal while something takes long. Off in the library; the `raceway` command
turns it on."""

import sys
import time
from collections.abc import Iterable, Iterator
from pathlib import Path
from typing import TYPE_CHECKING

if TYPE_CHECKING:  # pandas takes longer to load than `--help` should
    from raceway.runs.dump import Block

AFTER = 1.0  # s: what takes less needs no word
on = False


def reading(path: Path, blocks: Iterable["Block"]) -> Iterator["Block"]:
    """Yield `blocks` (`dump.Block`s of the file at `path`), with the share read on standard error
    if that is a terminal."""
    if not (on and sys.stderr.isatty()):
        yield from blocks
        return
    size, last, shown = path.stat().st_size, time.monotonic() + AFTER, False
    try:
        for block in blocks:
            yield block
            if time.monotonic() > last:
                print(
                    f"\rreading {path.name}: {min(block.end / size, 1):4.0%}",
                    end="",
                    file=sys.stderr,
                    flush=True,
                )
                last, shown = time.monotonic() + 0.2, True
    finally:
        if shown:
            print("\r\033[K", end="", file=sys.stderr, flush=True)  # the line goes away


def line(text: str, last: bool) -> None:
    """Show `text` on the terminal in place of the line before it; after the `last`, the line goes
    away."""
    if on and sys.stderr.isatty():
        print("\r\033[K" + ("" if last else text), end="", file=sys.stderr, flush=True)
