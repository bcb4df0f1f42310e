# SPDX-License-Identifier: GPL-2.0-or-later
"""Subcommands of `raceway`, a module each: `add(commands)` adds its parser, `run(arguments)` does
the work."""

import argparse

# what `ArgumentParser.add_subparsers` gives
Commands = argparse._SubParsersAction
