# SPDX-License-Identifier: GPL-2.0-or-later
"""Pictures of runs, one in each module: each has a function that draws a run (a `RunTables`) to a
file."""
