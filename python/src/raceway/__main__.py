# SPDX-License-Identifier: GPL-2.0-or-later
"""`python -m raceway` is the `raceway` command."""

import sys

from raceway.cli import main

sys.exit(main())
