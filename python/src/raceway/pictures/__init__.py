# SPDX-License-Identifier: GPL-2.0-or-later
"""Pictures of runs. There is one module per picture, with a function that plots a run (a
`RunTables`) and writes the picture to a file."""
