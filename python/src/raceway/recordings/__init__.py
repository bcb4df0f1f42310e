# SPDX-License-Identifier: GPL-2.0-or-later
"""Recordings of real bearings: their files, their lines, and what they say of clearance, load and
temperature."""
