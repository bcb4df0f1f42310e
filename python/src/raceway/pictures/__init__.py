# SPDX-License-Identifier: GPL-2.0-or-later
"""Pictures of runs, with one module per picture; a function in each module plots a run (a
`RunTables`) and writes the picture to a file."""
