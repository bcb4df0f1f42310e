# SPDX-License-Identifier: GPL-2.0-or-later
"""Access to the results of a run.

`record` reads the file, `tables` provides the samples in a folder as tables, and `run` provides
them as labelled arrays. The other modules build on `tables` or `run`.
"""
