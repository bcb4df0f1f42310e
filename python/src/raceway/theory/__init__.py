# SPDX-License-Identifier: GPL-2.0-or-later
"""Bearings without a run: one topic a module, formulas on numbers or arrays in SI units.

On them stand the statics of a whole bearing (`static`), its film (`lubrication`) and its figures
(`operating_point`, as text `operating_table`)."""
