# SPDX-License-Identifier: GPL-2.0-or-later
"""Labelled data sets: sensor signals from many runs in file formats of condition monitoring."""
