# SPDX-License-Identifier: GPL-2.0-or-later
"""A second, independent implementation of the laws, in 40-digit arithmetic or by quadrature, which
does not call the package."""
