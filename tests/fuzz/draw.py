# SPDX-License-Identifier: GPL-2.0-or-later
"""Random choices for a case, drawn with the seed of the case."""

import math
import random
from functools import cache
from pathlib import Path

import yaml

GRAMMAR = Path(__file__).parent / "grammar"


@cache
def grammar(name):
    """Return the contents of a file in grammar/. YAML reads 1e-3 as a string, so numbers in these
    files have a decimal point."""
    return yaml.safe_load((GRAMMAR / f"{name}.yaml").read_text())


class Draw(random.Random):
    """A generator of random numbers from the intervals in a grammar."""

    def number(self, interval):
        """Return a value from [least, most] or [log, least, most], rounded to four digits. If both
        limits of [least, most] are whole numbers, the value is also a whole number."""
        if interval[0] == "log":
            low, high = map(math.log, interval[1:])
            return float(f"{math.exp(self.uniform(low, high)):.4g}")
        if all(isinstance(end, int) for end in interval) and interval[1] - interval[0] > 1:
            return self.randint(*interval)
        return float(f"{self.uniform(*interval):.4g}")

    def chance(self, share):
        return self.random() < share

    def maybe(self, share, make):
        """Return `make()` or None."""
        return make() if self.chance(share) else None
