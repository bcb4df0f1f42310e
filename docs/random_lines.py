# SPDX-License-Identifier: GPL-2.0-or-later
"""Draw random lines from pages, comments and messages, to be judged by a reader.

``python docs/random_lines.py --seed 1 --lines 40`` prints the lines with file and line number. For
a blind comparison, ``--among FOLDER ... --key FILE`` mixes them with equally many lines from other
projects, prints each with the lines around it but without its location, and writes the locations
to FILE. The verdicts are in ``docs/notes/language.rst``.
"""

import argparse
import random
import re
import subprocess
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
WORDS = 5  # lines with fewer words are titles, names and ends of sentences
CONTEXT = 5  # lines shown before and after a line in a blind comparison
NOT_PROSE = re.compile("SPDX|[Cc]opyright|GNU")
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


def files(folder):
    """Return the files of a project: those in git, or all files if the folder is not this tree."""
    if folder != ROOT:
        return sorted(path for path in folder.rglob("*") if path.is_file())
    names = subprocess.run(
        ["git", "ls-files"], cwd=ROOT, capture_output=True, text=True, check=True
    ).stdout.splitlines()
    return [ROOT / name for name in names]


def lines(folder=ROOT):
    """Yield (location, text) for all lines that have at least ``WORDS`` words."""
    for path in files(folder):
        if path.suffix in (".rst", ".md"):
            find = prose
        elif path.suffix in (".py", ".cpp", ".h") or path.name.startswith("in."):
            find = code
        else:
            continue
        for number, text in find(path.read_text(errors="replace")):
            if len(re.findall(r"[A-Za-z]{2,}", text)) >= WORDS and not NOT_PROSE.search(text):
                yield f"{path.relative_to(folder)}:{number}", text


def blind(drawn, key):
    """Print the lines `drawn`, a list of (folder, (location, text)), with their context and without
    their locations, which are written to the file `key`."""
    with open(key, "w", encoding="utf-8") as locations:
        for number, (folder, (place, text)) in enumerate(drawn, 1):
            name, at = place.rsplit(":", 1)
            around = (folder / name).read_text(errors="replace").splitlines()
            print(f"--- {number}: {text}")
            for k in range(max(1, int(at) - CONTEXT), min(len(around), int(at) + CONTEXT) + 1):
                print(">>" if k == int(at) else "  ", around[k - 1])
            locations.write(f"{number} {folder / name}:{at}\n")


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--lines", type=int, default=40)
    parser.add_argument("--among", nargs="+", type=Path, default=[], metavar="FOLDER")
    parser.add_argument("--key", help="file for the locations of the mixed lines")
    given = parser.parse_args()
    draw = random.Random(given.seed)
    drawn = draw.sample(sorted(set(lines())), given.lines)
    if not given.among:
        for place, text in sorted(drawn):
            print(f"{place}\n    {text}")
        return
    if not given.key:
        parser.error("--among needs --key")
    mixed = [(ROOT, one) for one in drawn]
    for folder in given.among:
        count = given.lines // len(given.among)
        mixed += [(folder, one) for one in draw.sample(sorted(set(lines(folder))), count)]
    draw.shuffle(mixed)
    blind(mixed, given.key)


if __name__ == "__main__":
    main()
