# SPDX-License-Identifier: GPL-2.0-or-later
"""Many runs: `points` reads their table, `point_run` does one run, `sweep` does all of them, and
`gather` collects the results in a table. `heat_runs` does the runs that find a temperature."""
