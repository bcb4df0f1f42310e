# SPDX-License-Identifier: GPL-2.0-or-later
"""Call `raceway` from tests in their own process."""

import json

from PIL import Image
from raceway.cli import main


def reply(capsys, words, code=0):
    """Call `raceway` with `words` (a list, or text with spaces between them), check its exit code,
    and return what it prints: its output if the code is 0, otherwise its messages."""
    try:
        found = main(words.split() if isinstance(words, str) else [str(word) for word in words])
    except SystemExit as end:
        found = end.code
    printed = capsys.readouterr()
    assert found == code, printed.err
    return printed.err if code else printed.out


def answer(capsys, words):
    """Return the object that `raceway` prints for `words` and --json."""
    return json.loads(
        reply(capsys, [*(words.split() if isinstance(words, str) else words), "--json"])
    )


def drawn(path):
    """Check that the file `path` is a picture with something in it."""
    with Image.open(path) as picture:
        assert picture.width >= 1000 and len(picture.convert("RGB").getcolors(1 << 24)) > 100
