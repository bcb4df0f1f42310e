# SPDX-License-Identifier: GPL-2.0-or-later
"""Call `raceway` from tests in their own process."""

from raceway.cli import main


def reply(capsys, words, code=0):
    """Call `raceway` with `words`, check its exit code, and return what it prints: its output if
    the code is 0, otherwise its messages."""
    try:
        found = main(words)
    except SystemExit as end:
        found = end.code
    printed = capsys.readouterr()
    assert found == code, printed.err
    return printed.err if code else printed.out
