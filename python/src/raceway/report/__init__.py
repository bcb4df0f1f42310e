# SPDX-License-Identifier: GPL-2.0-or-later
"""A run or a sweep as one self-contained HTML page: `of_run` and `of_sweep` define its content,
`page` writes it, and `charts.js` draws the charts in the browser."""
