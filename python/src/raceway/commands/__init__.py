# SPDX-License-Identifier: GPL-2.0-or-later
"""Subcommands of `raceway`. Each is a module whose `add(commands)` adds its parser and whose
`run(arguments)` does the work."""

import argparse

# The commands by group, in the order in which `raceway --help` lists them.
GROUPS = {
    "Runs": ("decks", "summary", "plot", "animate", "report", "spectrum", "export", "check"),
    "Theory, without a run": ("static", "heat", "stiffness", "shaft", "catalogue"),
    "Films as capacitors": ("electric", "circuit"),
    "Many runs": ("sweep", "gather", "needs", "dataset"),
    "Measurements": ("measured", "compare", "identify", "track"),
    "The publication": ("paper",),
}

# type that `ArgumentParser.add_subparsers` returns
Commands = argparse._SubParsersAction
