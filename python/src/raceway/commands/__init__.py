# SPDX-License-Identifier: GPL-2.0-or-later
"""Subcommands of `raceway`. Each is a module with the texts HELP, DESCRIPTION and EXAMPLES, whose
`add(one)` adds options to the parser of the command and whose `run(arguments)` does the work."""

# The commands by group, in the order in which `raceway --help` lists them.
GROUPS = {
    "Runs": ("decks", "summary", "plot", "animate", "report", "spectrum", "export", "check"),
    "Theory, without a run": ("static", "heat", "stiffness", "shaft", "catalogue"),
    "Films as capacitors": ("electric", "circuit"),
    "Many runs": ("sweep", "gather", "needs", "dataset"),
    "Measurements": ("measured", "compare", "identify", "track"),
    "The paper": ("paper",),
}
