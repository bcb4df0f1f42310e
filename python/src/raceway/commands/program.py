# SPDX-License-Identifier: GPL-2.0-or-later
"""The program of --program, and the command with the deck of --deck that a sweep runs."""

import argparse
import shlex
import shutil
import signal
import sys
from pathlib import Path

from raceway.errors import RacewayError


def program(text: str) -> list[str]:
    """Words of the program. Raises `RacewayError` if it is not found."""
    try:
        words = shlex.split(text)
    except ValueError as error:
        raise RacewayError(f"--program {text!r}: {error}") from None
    if not words or shutil.which(words[0]) is None:
        raise RacewayError(
            f"there is no program {text!r}: `make build` makes build/liggghts; start"
            " from the repository's root"
        )
    return words


def command(arguments: argparse.Namespace) -> list[str]:
    """Program, options and deck. Raises `RacewayError` if program or deck is missing."""
    words = program(arguments.program)
    if not Path(arguments.deck).is_file():
        raise RacewayError(f"--deck {arguments.deck}: there is no such file")
    return [*words, "-in", arguments.deck]


def end_on_signals() -> None:
    """Let SIGTERM and SIGHUP end the process as Ctrl-C does, with runs stopped and files
    complete."""
    signal.signal(signal.SIGTERM, _terminated)
    signal.signal(signal.SIGHUP, _terminated)


def _terminated(number, _):
    signal.signal(number, signal.SIG_IGN)  # once is enough, stopping takes a moment
    sys.exit(128 + number)
