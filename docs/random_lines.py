# SPDX-License-Identifier: GPL-2.0-or-later
"""Draw random lines from pages, comments and messages, to be judged by a reader.

``python docs/random_lines.py --seed 1 --lines 40`` prints the lines with file and line number. The
verdicts are in ``docs/notes/language.rst``.
"""

import argparse
import random
import re
import subprocess
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
WORDS = 5  # lines with fewer words are titles, names and ends of sentences
COMMENT = re.compile(r"(?:^|\s)(?://+|#)\s(.+)")
QUOTES = re.compile(r'^r?"""|"""$')
MESSAGE = re.compile(r'"([^"\n]*\s[^"\n]*\s[^"\n]*)"')


def prose(text):
    """Yield (line number, text) for the lines of a page, except literal blocks and directives."""
    literal = None
    for number, line in enumerate(text.splitlines(), 1):
        indent = len(line) - len(line.lstrip())
        if literal is not None and line.strip() and indent <= literal:
            literal = None
        if literal is None and not line.lstrip().startswith((".. ", ":", "|", "+--", "===", "---")):
            yield number, line.strip()
        if line.rstrip().endswith("::") or line.lstrip().startswith((".. code", ".. math")):
            literal = indent


def code(text):
    """Yield (line number, text) for the comments, docstrings and messages of a source file."""
    inside = False
    for number, line in enumerate(text.splitlines(), 1):
        quotes = line.count('"""')
        if inside or quotes:
            yield number, QUOTES.sub("", line.strip()).strip()
            inside = inside != (quotes % 2 == 1)
            continue
        for found in (COMMENT.search(line), MESSAGE.search(line)):
            if found:
                yield number, found.group(1).strip()


def lines():
    """Yield (location, text) for all lines that have at least ``WORDS`` words."""
    names = subprocess.run(
        ["git", "ls-files"], cwd=ROOT, capture_output=True, text=True, check=True
    ).stdout.splitlines()
    for name in names:
        path = Path(name)
        if path.suffix in (".rst", ".md"):
            found = prose((ROOT / path).read_text())
        elif path.suffix in (".py", ".cpp", ".h") or path.name.startswith("in."):
            found = code((ROOT / path).read_text())
        else:
            continue
        for number, text in found:
            if len(re.findall(r"[A-Za-z]{2,}", text)) >= WORDS and "SPDX" not in text:
                yield f"{name}:{number}", text


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--lines", type=int, default=40)
    given = parser.parse_args()
    drawn = random.Random(given.seed).sample(sorted(set(lines())), given.lines)
    for place, text in sorted(drawn):
        print(f"{place}\n    {text}")


if __name__ == "__main__":
    main()
