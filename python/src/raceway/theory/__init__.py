# SPDX-License-Identifier: GPL-2.0-or-later
"""Bearings without a run: one topic in each module, formulas on numbers or arrays in SI units.

They are the basis of the statics of a whole bearing (`static`), its film (`lubrication`) and its
figures (`operating_point`, as text `operating_table`)."""
