# SPDX-License-Identifier: GPL-2.0-or-later
"""The program given by --program, and the command that runs it with the deck given by --deck."""

import argparse
import signal
import sys
from pathlib import Path

from raceway.errors import RacewayError
from raceway.sweeps import host_program


def program(text: str) -> list[str]:
    """Return the program and its options as a list.

    If the default program is missing, return the program that `host_program.find` finds. Raise
    `RacewayError` if there is none.
    """
    usual = host_program.BUILT["liggghts"]
    absent = text == str(usual) and not usual.is_file()
    return host_program.find() if absent else host_program.words(text)


def command(arguments: argparse.Namespace) -> list[str]:
    """Return the program with its options and the deck.

    Raise `RacewayError` if the program or the deck is missing.
    """
    words = program(arguments.program)
    if not Path(arguments.deck).is_file():
        raise RacewayError(f"--deck {arguments.deck}: there is no such file")
    return [*words, "-in", arguments.deck]


def end_on_signals() -> None:
    """Make SIGTERM and SIGHUP end the process as Ctrl-C does, so that runs are stopped and files
    are left complete."""
    signal.signal(signal.SIGTERM, _terminated)
    signal.signal(signal.SIGHUP, _terminated)


def _terminated(number, _):
    signal.signal(number, signal.SIG_IGN)  # ignore further signals while the runs are stopped
    sys.exit(128 + number)
