# SPDX-License-Identifier: GPL-2.0-or-later
"""Recordings of real bearings: their files, the lines in their spectra, and the clearance, load and
temperature that follow from these lines."""

# relative standard deviation of a line: its scatter among recordings of a few seconds each
# (docs/measured_bearings)
WITHIN = 2e-4
