# SPDX-License-Identifier: GPL-2.0-or-later
"""The subcommands of `raceway`, a module each: `add(commands)` puts it into the parser, `run(arguments)` does it."""
