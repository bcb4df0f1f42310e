# SPDX-License-Identifier: GPL-2.0-or-later
"""The plugin in a LAMMPS built from Debian's sources with PLUGIN and Open MPI has the bits of
build/liggghts. `make test-lammps` builds both and runs this."""

import pytest
from debian_lammps import TREE
from host import ROOT, frames, succeed

PROGRAM = TREE / "src" / "lmp_mpi"
PLUGIN = ROOT / "build" / "plugin" / "raceway_plugin.so"
CASE = {"passes": 1, "samples": 20}


@pytest.fixture(autouse=True)
def library(monkeypatch):
    from host import ENVIRONMENT

    monkeypatch.setitem(ENVIRONMENT, "LD_LIBRARY_PATH", str(PROGRAM.parent))


@pytest.mark.parametrize("integrator", ["implicit", "verlet"])
@pytest.mark.parametrize("ranks", [1, 2])
def test_main_deck(tmp_path, integrator, ranks):
    deck = tmp_path / "in.own"
    deck.write_text(f"plugin load {PLUGIN}\ninclude inputs/in.6208\n")
    case = {"integrator": integrator, "rpm": 20000, **CASE}
    succeed("inputs/in.6208", out=tmp_path / "liggghts", **case)
    succeed(deck, program=PROGRAM, ranks=ranks, out=tmp_path / "own", **case)
    for name in ("contacts.dump", "balls.dump"):
        assert frames(tmp_path / "own" / name) == frames(tmp_path / "liggghts" / name)
    rings = [(tmp_path / host / "rings.dat").read_text() for host in ("own", "liggghts")]
    head, *rows = rings[1].splitlines()
    # LAMMPS writes a row at the start, too
    assert rings[0].splitlines()[0] == head and rings[0].splitlines()[2:] == rows
