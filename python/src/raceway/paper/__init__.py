# SPDX-License-Identifier: GPL-2.0-or-later
"""Figures, tables and statements of Farah, Guessasma and Bellenger 2020 from runs of this package.

`cases` reads what to run, `runner` runs it, `reading` takes numbers out of a run, `theory` gives
them without one; `figures`, `tables`, `sensitivity` and `statements` are the products.
"""
