# SPDX-License-Identifier: GPL-2.0-or-later
"""Recordings of real bearings: how to read them, find the lines in their spectra, and determine
clearance, load and temperature from these lines."""

# relative standard deviation of a line, i.e. its scatter among recordings of a few seconds each
# (docs/measured_bearings)
WITHIN = 2e-4
