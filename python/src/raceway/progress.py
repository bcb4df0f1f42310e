# SPDX-License-Identifier: GPL-2.0-or-later
"""A progress line on the terminal, which is off unless the `raceway` command turns it on."""

import sys

on = False


def line(text: str, last: bool) -> None:
    """Replace the progress line on the terminal with `text`, or erase it on the `last` call."""
    if on and sys.stderr.isatty():
        print("\r\033[K" + ("" if last else text), end="", file=sys.stderr, flush=True)
