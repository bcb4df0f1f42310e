# SPDX-License-Identifier: GPL-2.0-or-later
"""Pictures of runs, one per module; a function of the module draws a run (a `RunTables`) to a
file."""
