# SPDX-License-Identifier: GPL-2.0-or-later
"""The bearing as an electrical part: capacitance, leak, breakdown, its circuit."""
