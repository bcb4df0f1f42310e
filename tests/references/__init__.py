# SPDX-License-Identifier: GPL-2.0-or-later
"""The laws written a second time, in 40 digits or by quadrature: nothing here calls the package."""
