# SPDX-License-Identifier: GPL-2.0-or-later
"""The physics headers as a library, made by `make build` (Makefile rule
build/libraceway_physics.so)."""

import sys
from pathlib import Path

import pytest

# the helpers of this folder, from wherever pytest starts
sys.path.insert(0, str(Path(__file__).resolve().parent))

from physics_c import Physics  # noqa: E402

LIBRARY = Path(__file__).resolve().parents[2] / "build" / "libraceway_physics.so"


@pytest.fixture(scope="session")
def physics():
    if not LIBRARY.exists():
        pytest.fail(f"{LIBRARY} is missing: run make build first", pytrace=False)
    return Physics(LIBRARY)
