# SPDX-License-Identifier: GPL-2.0-or-later
"""A progress line on the terminal. It is off in the library and turned on by the `raceway`
command."""

import sys

on = False


def line(text: str, last: bool) -> None:
    """Replace the last line on the terminal by `text`; remove the line after the
    `last`."""
    if on and sys.stderr.isatty():
        print("\r\033[K" + ("" if last else text), end="", file=sys.stderr, flush=True)
