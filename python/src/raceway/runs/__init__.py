# SPDX-License-Identifier: GPL-2.0-or-later
"""What a run recorded: `record` reads the file, `tables` has the tables of a folder, `run` the same
as labelled arrays; the other modules work with one of the two."""
