# SPDX-License-Identifier: GPL-2.0-or-later
"""`raceway needs DECK`: find the model parts and numerical settings that a scene needs."""

import argparse
import re

from raceway import files
from raceway.commands import options, output
from raceway.commands.program import command, end_on_signals
from raceway.errors import RacewayError, near

HELP = "find the model parts and numerical settings that a scene needs"
DESCRIPTION = """\
Runs a scene with the full model and fine numerical settings. Then omits each part and coarsens each
setting, one at a time, and shows the effect on the results and on the cost. Finally searches for
the cheapest set that meets the required accuracy, runs it, and prints its -var options.

Each run is stored in a folder named after its variables. A command that was interrupted continues
when it is repeated. The table is printed, and DIR/needs.json and DIR/needs.png contain the same
data."""
EXAMPLES = """\
examples:
  raceway needs inputs/in.6208 -var load 2000 --want torque=10% capacitance=5% load=1%
  raceway needs inputs/in.6208 -var rpm 3000 --want film=2% --keep record samples

Exit codes: 0 done, 1 the scene cannot be run or lacks a requested result, 2 wrong command line, 130
and 143 stopped."""
WANTED = {"torque": 0.1, "capacitance": 0.05, "load": 0.01}


def add(one: argparse.ArgumentParser) -> None:
    one.add_argument("deck", metavar="DECK", help="deck with the variables of inputs/in.6208")
    options.variables(one, "variable of the deck")
    one.add_argument(
        "--want",
        nargs="+",
        metavar="FIGURE=ERROR",
        default=None,
        help="results and their allowed errors, for instance torque=10%% (default: torque=10%%"
        " capacitance=5%% load=1%%, where the scene provides them)",
    )
    one.add_argument(
        "--keep",
        nargs="+",
        metavar="NAME",
        default=[],
        help="parts and groups that are not changed: drag, samples, record, ...",
    )
    one.add_argument(
        "--out",
        metavar="DIR",
        default="build/needs",
        help="folder for the runs (default: %(default)s)",
    )
    options.jobs(one)
    options.program(one)


def run(arguments: argparse.Namespace) -> None:
    from raceway.pictures.needs import picture
    from raceway.sweeps import scene_parts
    from raceway.sweeps.needs import needs
    from raceway.sweeps.needs_shown import as_json, table
    from raceway.sweeps.points import OURS, WORD, deck_variables

    known = deck_variables(arguments.deck)
    given = dict(arguments.var)
    for name, value in given.items():
        if name in OURS or name in scene_parts.REFERENCE or name == "without":
            raise RacewayError(f"-var {name} is set by raceway needs; leave it out")
        if name not in known:
            raise RacewayError(f"{arguments.deck} has no variable '{name}'{near(name, known)}")
        if not WORD.fullmatch(value):
            raise RacewayError(f"-var {name} is '{value}', must be one word or number")
    if missing := sorted(set(scene_parts.REFERENCE) - set(known)):
        raise RacewayError(f"{arguments.deck} has no variable {', '.join(missing)}")
    wet = scene_parts.lubricated(given, known.get("lubricant", ""))
    scene = scene_parts.whole_scene(given, wet, known)
    available = _without(scene_parts.choices(scene, wet, known), arguments.keep)
    runs = command(arguments)
    out = files.folder(arguments.out)
    end_on_signals()
    found = needs(scene, _wanted(arguments.want, wet), available, out, runs, jobs=arguments.jobs)
    files.text(out / "needs.json", output.as_json(as_json(found)))
    picture(found, out / "needs.png")
    print(table(found))


def _wanted(texts, wet):
    from raceway.sweeps.scene_parts import FIGURES

    if texts is None:
        return {word: most for word, most in WANTED.items() if wet or word != "capacitance"}
    wanted = {}
    for text in texts:
        match = re.fullmatch(r"(\w+)=([0-9.eE-]+)(%?)", text)
        if not match or match[1] not in FIGURES:
            raise RacewayError(
                f"--want {text}: must be FIGURE=ERROR, for instance torque=10%; FIGURE is one of"
                f" {', '.join(FIGURES)}"
            )
        try:
            value = float(match[2]) * (0.01 if match[3] else 1.0)
        except ValueError:
            value = -1.0
        if not 0 < value <= 1:
            raise RacewayError(f"--want {text}: the error must be above 0 and at most 100%")
        wanted[match[1]] = value
    return wanted


def _without(choices, keep):
    names = {name for choice in choices for name in (choice.name, choice.group)}
    if unknown := sorted(set(keep) - names):
        raise RacewayError(f"--keep {unknown[0]}: unknown; known: {', '.join(sorted(names))}")
    return [choice for choice in choices if choice.name not in keep and choice.group not in keep]
