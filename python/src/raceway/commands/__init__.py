# SPDX-License-Identifier: GPL-2.0-or-later
"""Subcommands of `raceway`. Each is a module with the texts HELP, DESCRIPTION and EXAMPLES. Its
`add(one)` adds options to the parser of the command, and its `run(arguments)` prints the results or
writes the files. `run` raises `RacewayError` if the input is unusable or has no solution (exit code
1) and calls `arguments.complain` for a wrong command line (exit code 2)."""

# The commands by group, in the order in which `raceway --help` lists them.
GROUPS = {
    "Runs": ("decks", "summary", "plot", "animate", "report", "spectrum", "export", "check"),
    "Theory, without a run": ("static", "heat", "stiffness", "shaft", "catalogue"),
    "Films as capacitors": ("electric", "circuit"),
    "Many runs": ("sweep", "gather", "needs", "dataset"),
    "Measurements": ("measured", "compare", "identify", "track"),
    "The paper": ("paper",),
}
