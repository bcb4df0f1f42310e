# SPDX-License-Identifier: GPL-2.0-or-later
"""Labelled data sets: what a sensor has of many runs, in the files that people of condition
monitoring read."""
