# SPDX-License-Identifier: GPL-2.0-or-later
"""The laws written a second time, in 40-digit arithmetic or by quadrature, without calls to the
package."""
