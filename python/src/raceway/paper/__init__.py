# SPDX-License-Identifier: GPL-2.0-or-later
"""Figures, tables and statements of Farah, Guessasma and Bellenger 2020 from runs of this package.

`cases` defines the runs, `runner` runs them, `reading` reads numbers from a run, `theory` computes
such numbers without a run; `figures`, `tables`, `sensitivity` and `statements` are the products.
"""
