# SPDX-License-Identifier: GPL-2.0-or-later
"""Analysis of ball bearing runs, one topic a module. See the README for the list."""

__version__ = "0.1.0"
