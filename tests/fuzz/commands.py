# SPDX-License-Identifier: GPL-2.0-or-later
"""Command lines of `raceway`, drawn at random from its own parsers, with their options, choices and
ranges."""

import argparse
import inspect
import math

from fuzz.draw import grammar
from raceway import cli


def line(draw, files):
    """Return the words of a command, where `files` is {"DIR": folders of runs, "SHAFT": ...}."""
    words = [
        str(draw.choice(files[word])) if word in files else word
        for word in draw.choice(grammar("commands")["lines"]).split()
    ]
    name = words[0]
    options = [a for a in PARSERS[name]._actions if a.option_strings and a.dest not in KEPT]
    for action in draw.sample(options, min(len(options), draw.choice([0, 0, 1, 1, 2, 3]))):
        if not set(action.option_strings) & set(words):
            words += [draw.choice(action.option_strings), *_values(draw, action)]
    if draw.chance(0.3):  # give a second value for an option that the line already contains
        given = [k for k, word in enumerate(words) if word.startswith("--") and k + 1 < len(words)]
        for k in draw.sample(given, min(1, len(given))):
            action = PARSERS[name]._option_string_actions.get(words[k])
            if action and action.nargs != 0:
                values = _values(draw, action)
                words[k + 1 : k + 1 + len(values)] = values
    if draw.chance(0.05) and len(words) > 1:
        del words[draw.randrange(1, len(words))]
    return words


def _values(draw, action):
    if action.nargs == 0:
        return []
    count = action.nargs if isinstance(action.nargs, int) else 1
    if action.nargs in ("+", "*"):
        count = draw.randint(1, 3)
    metavars = action.metavar if isinstance(action.metavar, tuple) else [action.metavar] * count
    return [_value(draw, action, metavar) for metavar in metavars[:count]]


def _value(draw, action, metavar):
    if action.choices:
        return str(draw.choice([*action.choices] * 9 + ["x"]))
    if draw.chance(0.03):
        return draw.choice(grammar("hostile")["numbers"])
    texts = grammar("commands")["values"].get(metavar)
    if texts:
        return draw.choice(texts)
    held = inspect.getclosurevars(action.type).nonlocals if inspect.isfunction(action.type) else {}
    if "low" in held:
        return _between(draw, held["low"], held["high"])
    return str(draw.choice([1, 2, 3, 5, 10, 100, "0.5", "1e-3"]))


def _between(draw, low, high):
    """Return a random number from a range. Half of the draws are small, and some are at the limits
    of the range.
    """
    if draw.chance(0.1):
        return f"{draw.choice([low, high]):.17g}"
    if low < 0 or high <= 0:
        size = min(abs(high), 1e6) * 10 ** draw.uniform(-6, 0)
        return f"{draw.choice([1, -1]) * size:.6g}"
    least = max(low, min(high, 1e6) * 1e-8)
    return f"{math.exp(draw.uniform(math.log(least), math.log(min(high, 1e12)))):.6g}"


def _parsers():
    actions = cli._parser()._actions
    return next(a for a in actions if isinstance(a, argparse._SubParsersAction)).choices


PARSERS = _parsers()
# options that start programs or refer to paths outside the folder of the case
KEPT = ("help", "out", "program", "deck", "slurm", "inputs", "table", "reduced", "file")
