# SPDX-License-Identifier: GPL-2.0-or-later
"""The bearing as an electrical component: capacitance, leakage, breakdown, and its circuit."""
