# SPDX-License-Identifier: GPL-2.0-or-later
"""Type hints for numbers and arrays. Shapes and units are in the docstrings."""

import numpy as np
from numpy.typing import NDArray

Floats = NDArray[np.float64]
Integers = NDArray[np.int64]
Numbers = float | Floats  # one number or an array of them
