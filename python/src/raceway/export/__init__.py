# SPDX-License-Identifier: GPL-2.0-or-later
"""Runs as files that other programs open: ParaView (`vtk`) and OVITO (`xyz`)."""
