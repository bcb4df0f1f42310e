# SPDX-License-Identifier: GPL-2.0-or-later
"""Provides the physics headers as a library, which `make interfaces` builds (the rule for
build/libraceway_physics.so in the Makefile)."""

import sys
from pathlib import Path

import pytest

# lets pytest find the helpers in this folder regardless of where it is started
sys.path.insert(0, str(Path(__file__).resolve().parent))

from film_scene import Gap  # noqa: E402
from physics_c import INNER, OUTER, Physics  # noqa: E402

LIBRARY = Path(__file__).resolve().parents[2] / "build" / "libraceway_physics.so"


@pytest.fixture(scope="session")
def physics():
    if not LIBRARY.exists():
        pytest.fail(f"{LIBRARY} is missing: run make interfaces first", pytrace=False)
    return Physics(LIBRARY)


@pytest.fixture(scope="module", params=[INNER, OUTER], ids=["inner", "outer"])
def side(request):
    return request.param


@pytest.fixture(scope="module")
def gap(physics, side):
    """Return a contact with its film, on the inner or the outer raceway."""
    return Gap(physics, side)


@pytest.fixture(scope="module")
def inner(physics):
    """Return a contact with its film, on the inner raceway."""
    return Gap(physics, INNER)
