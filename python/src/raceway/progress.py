# SPDX-License-Identifier: GPL-2.0-or-later
"""A line on the terminal while something takes long. Off in the library; the `raceway` command
turns it on."""

import sys

on = False


def line(text: str, last: bool) -> None:
    """Replace the last line on the terminal by `text`; after the `last`, the line goes
    away."""
    if on and sys.stderr.isatty():
        print("\r\033[K" + ("" if last else text), end="", file=sys.stderr, flush=True)
