# SPDX-License-Identifier: GPL-2.0-or-later
"""Run decks that are damaged on purpose by swapping, dropping, repeating or adding words and lines.
They may end with any message, but not with a crash, a hang, or NaN."""

import re
from contextlib import suppress

from fuzz.draw import grammar
from fuzz.lab import Finding

NUMBER = re.compile(r"[-+]?\d[\d.]*(e[-+]?\d+)?$")


def spoil(draw, text):
    lines = text.splitlines()
    for _ in range(draw.choice([1, 1, 1, 2, 3])):
        draw.choice([_number, _number, _word, _drop, _repeat, _swap, _add, _add])(draw, lines)
    return "\n".join([*lines, ""])


def _number(draw, lines):
    places = [
        (i, k)
        for i, line in enumerate(lines)
        for k, word in enumerate(line.split())
        if NUMBER.match(word) and not line.startswith(("dump", "group", "region"))
    ]
    i, k = draw.choice(places)
    words = lines[i].split()
    value = float(words[k])
    new = draw.choice([*grammar("hostile")["numbers"], None, None, None, None, None, None])
    if new is None:
        scale = draw.choice([-1, 0.1, 10, 1e-3, 1e3, 1 + 1e-9])
        new = f"{value * scale:.12g}"
    words[k] = new
    lines[i] = " ".join(words)


def _word(draw, lines):
    i = draw.randrange(len(lines))
    words = lines[i].split()
    k = draw.randrange(len(words))
    others = [word for line in lines for word in line.split()]
    words[k] = draw.choice([draw.choice(grammar("hostile")["words"]), draw.choice(others)])
    if draw.chance(0.2):
        words.insert(k, draw.choice(others))
    lines[i] = " ".join(words)


def _drop(draw, lines):
    i = draw.randrange(len(lines))
    words = lines[i].split()
    if draw.chance(0.5) and len(words) > 1:
        del words[draw.randrange(1, len(words))]
        lines[i] = " ".join(words)
    else:
        del lines[i]


def _repeat(draw, lines):
    lines.insert(draw.randrange(len(lines)), draw.choice(lines))


def _swap(draw, lines):
    i, k = draw.randrange(len(lines)), draw.randrange(len(lines))
    lines[i], lines[k] = lines[k], lines[i]


def _add(draw, lines):
    first = next((i for i, line in enumerate(lines) if line.startswith("create_bearing")), 0)
    new = draw.choice(grammar("hostile")["lines"])
    at = draw.randint(min(first, len(lines)), len(lines))
    lines.insert(at, new)
    if draw.chance(0.5):
        lines.append("run 6")


def check(draw, text, lab):
    """Run a damaged deck and return "passed" or "refused". Raise Finding if it fails in another
    way."""
    text = spoil(draw, text)
    if not affordable(text):
        return "refused"
    end = lab.start(text, "first")
    if end.code:
        return "refused"
    for file in lab.folder.glob("**/*"):
        if file.is_file() and file.suffix in (".dump", ".txt"):
            _finite(file)
    return "passed"


def _finite(file):
    for line in file.read_text(errors="replace").splitlines():
        for word in line.split():
            if word.lower().lstrip("+-") in ("nan", "inf"):
                raise Finding(f"exit code 0 with {word} in {file.name}: {line[:150]}")


def affordable(text):
    """Return whether the runs and steps of a deck are short; simulating one second takes
    minutes."""
    for word, most in (("run", 2e4), ("timestep", 1e-3)):
        for number in re.findall(rf"^{word} (\S+)", text, re.M):
            with suppress(ValueError):
                if not abs(float(number)) <= most:
                    return False
    return True
