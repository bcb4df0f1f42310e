# SPDX-License-Identifier: GPL-2.0-or-later
"""Many runs: `points` reads the table that asks for them, `point_run` does one, `sweep` all,
`gather` makes one table of what they gave. `heat_runs` makes those that find a temperature."""
