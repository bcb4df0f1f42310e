# SPDX-License-Identifier: GPL-2.0-or-later
"""Entry point for `python -m raceway`, which is the same as the `raceway` command."""

import sys

from raceway.cli import main

sys.exit(main())
