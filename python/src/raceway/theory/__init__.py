# SPDX-License-Identifier: GPL-2.0-or-later
"""Theory of bearings that does not need a run, with one topic per module. Formulas accept numbers
or arrays in SI units.

They are combined into the statics of a whole bearing (`static`), its films (`lubrication`) and the
results at an operating point (`operating_point`, formatted as text by `operating_table`)."""
