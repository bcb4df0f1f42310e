# SPDX-License-Identifier: GPL-2.0-or-later
"""What a run wrote: `dump` reads the text, `tables` has the tables of a folder, `run` the same as
labelled arrays; the other modules work with one of the two."""
