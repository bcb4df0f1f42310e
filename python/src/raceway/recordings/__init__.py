# SPDX-License-Identifier: GPL-2.0-or-later
"""Recordings of real bearings: their files, their lines, and the clearance, load and
temperature that follow from them."""

# relative standard deviation of a line: the scatter among recordings of a few seconds
# (docs/measured_bearings)
WITHIN = 2e-4
