# SPDX-License-Identifier: GPL-2.0-or-later
"""Reproduction of the figures, tables and statements of Farah, Guessasma and Bellenger 2020.

`cases` defines the runs, `runner` executes them, `reading` reads values from a run, and `theory`
computes such values without a run; `figures`, `tables`, `sensitivity` and `statements` make the
products.
"""
