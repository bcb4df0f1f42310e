# SPDX-License-Identifier: GPL-2.0-or-later
"""bearing_fleet: bearings in a grid, each with the load, speed and phase of its number."""

import math

import pytest
from host import BOX, frames, run, succeed

FLEET = """# load, speed and phase
variable this_load equal 100+10*${b_k} # N
variable this_rpm &
  equal 30*${b_k}
variable this_phase equal 0.1*${b_k}
"""
LARGE = BOX.replace("-0.06 0.06 -0.06 0.06", "0 0.3 0 0.3")
RACEWAYS = """pair_style bearing/hertz friction constant 0.1
pair_coeff 1 2 inner 24.0e-3 6.552e-3
pair_coeff 1 3 outer 36.6e-3 6.552e-3
"""
WORDS = """bearing_fleet DIR/fleet numbers FIRST 5 2 grid 2 0.1 only ONLY tables DIR dry &
  create 1 none 2 3 balls 9 diameter 12.6e-3
"""
LAST = """write_dump all custom DIR/last id type x y omegaz modify &
  ${dump_format} "%d %d %.17g %.17g %.17g" sort id
"""


def text(tmp_path, words=WORDS, first=1, only=0, fleet=FLEET):
    (tmp_path / "fleet").write_text(fleet)
    words = words.replace("FIRST", str(first)).replace("ONLY", str(only))
    return (LARGE + RACEWAYS + words + LAST).replace("DIR", str(tmp_path))


def fleet(tmp_path, host="liggghts", ranks=1, **more):
    deck = tmp_path / "in.fleet"
    deck.write_text(text(tmp_path, **more))
    succeed(deck, host=host, ranks=ranks)
    return [(tmp_path / name).read_text() for name in ("fleet.txt", "load.atoms", "speed.atoms")]


@pytest.mark.parametrize(
    "host, ranks", [("liggghts", 1), ("liggghts", 2), ("lammps", 1), ("wheel", 2)]
)
def test_tables_and_places(tmp_path, host, ranks):
    """Numbers 1, 3 and 5 of a grid of two columns: all in the first one."""
    tables = fleet(tmp_path, host, ranks)
    rows = [line.split() for line in tables[0].splitlines()]
    assert [row[0] for row in rows] == ["1", "3", "5"] and {row[-1] for row in rows} == {"dry"}
    for n, (row, load, speed) in enumerate(zip(rows, *(t.splitlines() for t in tables[1:]))):
        k, ring = int(row[0]), 10 + 11 * n
        assert row[1:-1] == [
            str(ring),
            "0.05",
            f"{0.05 + 0.1 * n:.15g}",
            str(100 + 10 * k),
            str(30 * k),
        ]
        assert load == f"{ring} {-100 - 10 * k}"
        assert speed.split()[0] == str(ring)
        assert float(speed.split()[1]) == pytest.approx(math.pi * k, rel=1e-14)
    (atoms,) = frames(tmp_path / "last").values()
    atoms = sorted([float(word) for word in line.split()] for line in atoms)
    assert len(atoms) == 33
    for n, row in enumerate(rows):
        first, ring = atoms[11 * n], atoms[11 * n + 9]
        assert ring[1:4] == [2, 0.05, pytest.approx(0.05 + 0.1 * n)]
        assert ring[4] == pytest.approx(math.pi * int(row[0]))
        phase = math.atan2(first[3] - ring[3], first[2] - ring[2])
        assert phase == pytest.approx(0.1 * int(row[0]))


def test_as_by_hand(tmp_path):
    fleet(tmp_path)
    (made,) = frames(tmp_path / "last").values()
    by_hand = "".join(
        f"create_bearing 1 none 2 3 balls 9 diameter 12.6e-3 centre 0.05 {y} 0 phase {k / 10} "
        f"speed {math.pi * k:.15g} 0\n"
        for k, y in ((1, 0.05), (3, 0.15), (5, 0.25))
    )
    deck = tmp_path / "in.hand"
    deck.write_text(text(tmp_path, words=by_hand))
    succeed(deck)
    (again,) = frames(tmp_path / "last").values()
    assert again == made


def test_one_alone(tmp_path):
    """In its place; nothing where the only one is not among the numbers."""
    assert [row.split()[0] for row in fleet(tmp_path, only=3)[0].splitlines()] == ["3"]
    (tmp_path / "fleet.txt").unlink()
    deck = tmp_path / "in.none"
    deck.write_text(text(tmp_path, only=4).replace(LAST.replace("DIR", str(tmp_path)), ""))
    succeed(deck)
    assert not (tmp_path / "fleet.txt").exists()


@pytest.mark.parametrize(
    "old, new, says",
    [
        ("/fleet numbers", "/no numbers", "cannot read '"),
        ("numbers FIRST 5 2", "", "'numbers FIRST LAST STEP' is missing"),
        ("numbers FIRST", "numbers 0", "first number is 0, must be"),
        ("grid 2 0.1", "grid 0 0.1", "columns of the grid is 0, must be"),
        ("grid 2 0.1", "grid 2 v_none", "there is no equal-style variable 'none'"),
        ("grid 2 0.1", "", "'grid COLUMNS SPACING' is missing"),
        ("tables DIR dry", "", "'tables FOLDER NOTE' is missing"),
        ("tables DIR dry", "tables DIR/no dry", "cannot write "),
        ("only ONLY", "once", "unknown keyword or one argument too many: 'once'"),
        ("variable this_rpm", "variable that_rpm", "no variable this_rpm that is one number"),
        ("balls 9", "balls 99", "create_bearing: overlapping balls"),
    ],
)
def test_refused(tmp_path, old, new, says):
    deck = tmp_path / "in.bad"
    assert old in WORDS or old in FLEET
    deck.write_text(text(tmp_path, words=WORDS.replace(old, new), fleet=FLEET.replace(old, new)))
    done = run(deck)
    assert done.code != 0 and says in done.error, done.text[-1000:]
    assert "bearing_fleet" in done.error or "create_bearing" in done.error
