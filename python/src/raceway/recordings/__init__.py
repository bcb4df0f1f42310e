# SPDX-License-Identifier: GPL-2.0-or-later
"""Recordings of real bearings: their files, their lines, and the clearance, load and
temperature that follow from them."""
