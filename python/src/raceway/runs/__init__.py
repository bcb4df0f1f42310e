# SPDX-License-Identifier: GPL-2.0-or-later
"""Results of a run: `record` reads the file, `tables` gives a folder's samples as tables, `run` as
labelled arrays. The other modules build on `tables` or `run`."""
