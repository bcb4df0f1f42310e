# SPDX-License-Identifier: GPL-2.0-or-later
"""Execution of many runs.

`points` reads the table of a sweep, `point_run` executes one run, `sweep` executes all of them, and
`gather` collects the results in a table. `heat_runs` executes the runs that find a temperature.
"""
