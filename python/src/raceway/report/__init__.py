# SPDX-License-Identifier: GPL-2.0-or-later
"""Report on a run or a sweep as one self-contained HTML page.

`of_run` and `of_sweep` define the content, `page` writes the page, and `charts.js` draws the charts
in the browser.
"""
