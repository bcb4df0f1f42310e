# SPDX-License-Identifier: GPL-2.0-or-later
"""Errors of the command `bearing` state how to fix a mistake."""

import pytest
from host import deck_file, refuses


@pytest.mark.parametrize(
    ("line", "error"),
    [
        ("bearing b 6208", "bearing: 'types BALLS CAGE INNER OUTER' is missing"),
        ("bearing b 6208 types 1 2 3 3", "balls, cage balls and both rings need their own"),
        ("bearing b 6208 types 1 2 3 4 vars lod", "bearing: vars 'lod', must be one of: inputs,"),
        (
            "variable load index 5\nbearing b 6208 types 1 2 3 4 vars load",
            "bearing: variable load belongs to bearing/ring: leave it out here",
        ),
        (
            "bearing b-1 6208 types 1 2 3 4",
            "the name 'b-1' must consist of letters, digits and '_'",
        ),
    ],
)
def test_errors_of_the_line(tmp_path, line, error):
    refuses(deck_file(tmp_path, line + "\n"), error)
