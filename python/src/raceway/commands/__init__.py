# SPDX-License-Identifier: GPL-2.0-or-later
"""Subcommands of `raceway`, one a module: `add(commands)` names its arguments, `run(arguments)` does it."""
