# SPDX-License-Identifier: GPL-2.0-or-later
"""The program of --program."""

import shlex
import shutil

from raceway.errors import RacewayError


def program(text: str) -> list[str]:
    """Its words. Raises `RacewayError` when there is none such."""
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
