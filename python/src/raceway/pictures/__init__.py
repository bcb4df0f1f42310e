# SPDX-License-Identifier: GPL-2.0-or-later
"""Pictures of runs, one per module; its function draws a run (a `RunTables`) to a file."""
