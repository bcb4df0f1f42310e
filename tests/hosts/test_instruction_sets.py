# SPDX-License-Identifier: GPL-2.0-or-later
"""Processors without AVX2 evaluate contacts with different code, which is generated from the same
formulas, and the results are bitwise identical. That code calls the contact law part by part,
whereas the AVX2 code contains inlined laws for the named `models`.

The environment variable RACEWAY_NARROW_LANES selects that code on AVX2 processors (docs/design).
"""

import ctypes
import os
import sys

import host
import pytest

LIBRARY = host.ROOT / "build" / "libraceway_physics.so"


def takes_avx2(**environment):
    """Return whether a process with these environment variables uses AVX2."""
    ask = f"import ctypes; print(ctypes.CDLL({str(LIBRARY)!r}).takes_avx2())"
    done = host.call([sys.executable, "-c", ask], env=dict(os.environ, **environment), check=True)
    return int(done.stdout)


def test_the_variable_is_heeded():
    has = ctypes.CDLL(str(LIBRARY)).has_avx2()
    assert takes_avx2() == has
    assert takes_avx2(RACEWAY_NARROW_LANES="1") == 0


@pytest.mark.parametrize("integrator, step", [("implicit", 0), ("verlet", 2e-6)])
@pytest.mark.parametrize(
    "scene",
    [
        {"models": "paper"},
        {"models": "film"},
        {"models": "full", "lubricant": "vg46"},
        {"models": "paper", "lubricant": "dry"},
        {"models": "full", "spin_law": "slices", "without": "gap"},  # parts that are not listed
        {"models": "paper", "flaw_outer": "notch -1.5708 1.0e-3 full 1.0e-5 5.0e-5"},
    ],
    ids=lambda scene: "-".join(scene.values()).split()[0],
)
def test_same_bits(scene, integrator, step, tmp_path, monkeypatch):
    records = []
    for name in ("wide", "narrow"):
        if name == "narrow":
            monkeypatch.setitem(host.ENVIRONMENT, "RACEWAY_NARROW_LANES", "1")
        host.succeed(
            "inputs/in.6208",
            out=tmp_path / name,
            **scene,
            integrator=integrator,
            step=step,
            rpm=4000,
            passes=1,
            settle=0.2,
            samples=50,
        )
        records.append((tmp_path / name / "record.nc").read_bytes())
    assert records[0] == records[1]
