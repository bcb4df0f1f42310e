# SPDX-License-Identifier: GPL-2.0-or-later
"""Subcommands of `raceway`, one module each: `add(commands)` adds its parser, `run(arguments)`
does the work."""

import argparse

# The commands in the order of `raceway --help`; each belongs to one group.
GROUPS = {
    "Runs": ("decks", "summary", "plot", "animate", "report", "spectrum", "export", "check"),
    "Theory, without a run": ("static", "heat", "stiffness", "shaft", "catalogue"),
    "Films as capacitors": ("electric", "circuit"),
    "Many runs": ("sweep", "gather", "needs", "dataset"),
    "Measurements": ("measured", "compare", "identify", "track"),
    "The publication": ("paper",),
}

# type of the result of `ArgumentParser.add_subparsers`
Commands = argparse._SubParsersAction
