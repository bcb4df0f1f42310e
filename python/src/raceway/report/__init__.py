# SPDX-License-Identifier: GPL-2.0-or-later
"""A run or a sweep as one HTML page that needs nothing else: `of_run` and `of_sweep` say what is on
it, `page` writes it, `charts.js` draws it in the browser."""
