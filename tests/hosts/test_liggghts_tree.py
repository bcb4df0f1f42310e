# SPDX-License-Identifier: GPL-2.0-or-later
"""Results of Raceway installed in an upstream LIGGGHTS source tree are bitwise identical to those
with Debian's library. Raceway can be removed from the tree again, and unsuitable trees are
rejected."""

import os
import shutil

import pytest
from debian_tree import TREE, source_entries, unpacked
from host import call, frames, same_files, succeed
from hosts.source_trees import Installer, contents

TREES = Installer("LIGGGHTS")
DUMPS = ("contacts.dump", "balls.dump")
PROGRAM = TREE / "lmp_raceway"
PATCHED = ("finish.cpp", "utils.h", "dump_mesh_vtk.h", "dump_mesh_vtk.cpp")


@pytest.fixture(scope="module")
def upstream(tmp_path_factory):
    """Return the upstream sources that the tests use: everything in src except for its packages,
    unmodified."""
    whole = unpacked(tmp_path_factory.mktemp("upstream") / "liggghts")
    tree = tmp_path_factory.mktemp("small")
    (tree / "src" / "MAKE").mkdir(parents=True)
    for path in (whole / "src").iterdir():
        if path.is_file():
            shutil.copy2(path, tree / "src")
    return tree


@pytest.fixture
def tree(upstream, tmp_path):
    return shutil.copytree(upstream, tmp_path / "liggghts")


def test_in_and_out(tree):
    before, after = TREES.in_and_out(tree)
    assert {name for name in before if after[name] != before[name]} == {
        f"src/{name}" for name in PATCHED
    }
    assert {
        "src/fix_bearing_ring.h",
        "src/vec3.h",
        "src/bearing_integrator.cpp",
        "src/MAKE/Makefile.raceway",
    } <= after.keys()
    assert not any(b'"../' in text for name, text in after.items() if text and name not in before)


def test_no_tree(tmp_path):
    TREES.refused(tmp_path, "is not a LIGGGHTS source tree")


def test_another_version(tree):
    (tree / "src" / "version_liggghts.txt").write_text("3.7.0\n")
    TREES.refused(tree, "is LIGGGHTS 3.7.0; only 3.8.0 is supported")


def test_patched_by_hand(tree):
    path = tree / "src" / "finish.cpp"
    path.write_text(path.read_text().replace("numneigh > 0) {", "numneigh != NULL) {"))
    TREES.refused(tree, "finish.cpp is patched already")


def test_changed_where_it_must_be_patched(tree):
    path = tree / "src" / "utils.h"
    path.write_text(path.read_text().replace("std::dec << a", "a"))
    TREES.refused(tree, "utils.h is not the file of LIGGGHTS 3.8.0")


def test_a_file_in_the_way(tree):
    (tree / "src" / "film.h").write_text("// another film\n")
    TREES.refused(tree, "film.h exists")


def test_a_file_changed_since(tree):
    assert TREES.make("install", tree)[0] == 0
    (tree / "src" / "vec3.h").write_text("// mine\n")
    TREES.refused(tree, "changed since the installation: vec3.h", what="uninstall")


def test_another_change_of_a_patched_file_is_kept(tree):
    assert TREES.make("install", tree)[0] == 0
    path = tree / "src" / "finish.cpp"
    path.write_text("// mine\n" + path.read_text())
    assert TREES.make("uninstall", tree)[0] == 0
    assert path.read_text().startswith("// mine\n") and "numneigh > 0) {" in path.read_text()


def test_an_interrupted_installation_is_taken_out(tree):
    """If an installation is killed half-way, the files installed so far can be removed, because the
    manifest is written before any other file."""
    before = contents(tree)
    assert TREES.make("install", tree)[0] == 0
    for name in ("film.h", "create_bearing.cpp"):
        (tree / "src" / name).unlink()
    (tree / "src" / "utils.h").write_bytes(before["src/utils.h"])
    assert TREES.make("uninstall", tree)[0] == 0
    assert contents(tree) == before


def test_a_failure_half_way_leaves_nothing(tree):
    """One of the last files cannot be written, because there is a non-empty folder with the same
    name."""
    (tree / "src" / "finish.cpp.raceway-new").mkdir()
    (tree / "src" / "finish.cpp.raceway-new" / "x").write_text("x")
    TREES.refused(tree, "removed again")


def times(tree):
    return {name: (tree / "src" / name).stat().st_mtime_ns for name in PATCHED}


def test_patches_keep_the_times_of_files(tree):
    """The patches do not change the compiled program, so the object files of the host need not be
    rebuilt."""
    before = times(tree)
    assert TREES.make("install", tree)[0] == 0
    assert times(tree) == before


@pytest.mark.parametrize("integrator", ["implicit", "verlet"])
def test_main_deck_has_the_same_bits(tmp_path, integrator):
    """For a few passes of the main deck at high speed, every column of every sample agrees."""
    case = {"integrator": integrator, "rpm": 20000, "passes": 1, "samples": 20, "dumps": "yes"}
    succeed("inputs/in.6208", out=tmp_path / "debian", **case)
    succeed("inputs/in.6208", program=PROGRAM, out=tmp_path / "tree", **case)
    same_files(tmp_path / "tree", tmp_path / "debian", *DUMPS, read=frames)
    same_files(tmp_path / "tree", tmp_path / "debian", "rings.dat")


@pytest.mark.parametrize("ranks", [1, 2])
def test_transient_has_the_same_bits(tmp_path, ranks):
    """With rings that are free to tilt, all digits agree, both on one rank and on two."""
    succeed("tests/hosts/in.bits", out=tmp_path / "debian", tilt="free")
    succeed("tests/hosts/in.bits", program=PROGRAM, ranks=ranks, out=tmp_path / "tree", tilt="free")
    same_files(tmp_path / "tree", tmp_path / "debian", *DUMPS, read=frames)
    same_files(tmp_path / "tree", tmp_path / "debian", "ring.txt")


def test_it_is_the_tree_that_ran(tmp_path):
    """The program is built from the tree and does not use Debian's LIGGGHTS library."""
    assert "liggghts" not in call(["ldd", PROGRAM], check=True).stdout
    assert os.path.islink(PROGRAM)


def test_sources_of_apt_in_one_line(tmp_path):
    """The private apt sources are derived from those of the machine in either of their formats;
    other suites and repositories are left out."""
    (tmp_path / "sources.list").write_text(
        "# deb x\ndeb [arch=amd64 signed-by=/k.gpg] http://m/debian bookworm main contrib\n"
        "deb http://m/debian bookworm-updates main\ndeb http://n/x nodistro main\n"
    )
    (tmp_path / "sources.list.d").mkdir()
    (tmp_path / "sources.list.d" / "d.sources").write_text(
        "Types: deb\n# a comment\nURIs: http://d/debian\nSuites: bookworm"
        " bookworm-updates\nComponents: main\nSigned-By: /d.gpg\n\nTypes: deb\nURIs:"
        " http://e/debian\nSuites: bookworm-security\nComponents: main\n"
    )
    one, two = source_entries(tmp_path, {"bookworm"})
    assert (
        one
        == "Types: deb-src\nURIs: http://m/debian\nSuites: bookworm\nComponents: main\nSigned-By:"
        " /k.gpg\n"
    )
    assert (
        two
        == "Types: deb-src\nSuites: bookworm\nComponents: main\nURIs: http://d/debian\nSigned-By:"
        " /d.gpg\n"
    )
