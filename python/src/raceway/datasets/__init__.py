# SPDX-License-Identifier: GPL-2.0-or-later
"""Labelled data sets: sensor signals of many runs in the file formats of condition monitoring."""
