# SPDX-License-Identifier: GPL-2.0-or-later
"""Raceway can be installed as a package in a LAMMPS source tree and removed again; unsuitable trees
are rejected. The trees in this file contain only the files that the installer inspects;
own_lammps.py uses a complete tree."""

import pytest
from hosts.source_trees import Installer

TREES = Installer("LAMMPS")
CMAKE = """\
# we require C++11 without extensions
set(CMAKE_CXX_STANDARD 11)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(STANDARD_PACKAGES
  ADIOS
  YAFF)
"""
LATER = CMAKE.replace(
    "set(CMAKE_CXX_STANDARD 11)\n",
    "if(NOT CMAKE_CXX_STANDARD)\n  set(CMAKE_CXX_STANDARD 17)\nendif()\n",
)
MACHINE = (
    "CC =\t\tmpicxx\nCCFLAGS =\t-g -O3 -std=c++11\nLINK =\tmpicxx\nLINKFLAGS =\t-g -O3\nLIB =\n"
)


@pytest.fixture(params=[("29 Sep 2021", CMAKE), ("22 Jul 2025", LATER)], ids=["2021", "2025"])
def tree(request, tmp_path):
    version, cmake = request.param
    tree = tmp_path / "lammps"
    for name, text in {
        "src/version.h": f'#define LAMMPS_VERSION "{version}"\n',
        "src/pair.h": "",
        "src/MAKE/Makefile.mpi": MACHINE,
        "cmake/CMakeLists.txt": cmake,
    }.items():
        (tree / name).parent.mkdir(parents=True, exist_ok=True)
        (tree / name).write_text(text)
    (tree / "src" / "MAKE" / "MINE").mkdir()
    return tree


def test_in_and_out(tree):
    before, after = TREES.in_and_out(tree)
    assert {"src/RACEWAY/vec3.h", "src/RACEWAY/create_bearing.cpp"} <= after.keys()
    assert {name for name in before if after[name] != before[name]} == {"cmake/CMakeLists.txt"}
    lists = after["cmake/CMakeLists.txt"].decode()
    assert "set(STANDARD_PACKAGES\n  RACEWAY\n" in lists
    assert "set(CMAKE_CXX_STANDARD 11)" not in lists
    machine = after["src/MAKE/MINE/Makefile.raceway"].decode()
    assert "-std=c++17" in machine and "-std=c++11" not in machine and "LIB =\n" in machine


def test_no_tree(tmp_path):
    TREES.refused(tmp_path, "is not a LAMMPS source tree")


def test_another_version(tree):
    (tree / "src" / "version.h").write_text('#define LAMMPS_VERSION "3 Mar 2020"\n')
    TREES.refused(tree, "is LAMMPS 20200303; supported are 20210929, and 20220504 or later")


def test_changed_where_it_must_be_patched(tree):
    (tree / "cmake" / "CMakeLists.txt").write_text(CMAKE.replace("STANDARD_PACKAGES", "PACKAGES"))
    TREES.refused(tree, "CMakeLists.txt is not the file of a known LAMMPS")


def test_another_machine_file(tree):
    (tree / "src" / "MAKE" / "Makefile.mpi").write_text("CC = mpicxx\n")
    TREES.refused(tree, "it must have exactly one line CCFLAGS")


def test_a_file_in_the_way(tree):
    (tree / "src" / "film.h").write_text("// another film\n")
    TREES.refused(tree, "has film.h already")
    (tree / "src" / "film.h").unlink()
    (tree / "src" / "MAKE" / "MINE" / "Makefile.raceway").write_text("mine\n")
    TREES.refused(tree, "Makefile.raceway exists")


def test_a_file_changed_since(tree):
    assert TREES.make("install", tree)[0] == 0
    (tree / "src" / "RACEWAY" / "vec3.h").write_text("// mine\n")
    TREES.refused(tree, "changed since the installation: src/RACEWAY/vec3.h", what="uninstall")


def test_package_that_is_in_use(tree):
    """The package counts as in use, because `make yes-raceway` has copied it to src."""
    assert TREES.make("install", tree)[0] == 0
    (tree / "src" / "create_bearing.cpp").touch()
    TREES.refused(tree, "no-raceway first", what="uninstall")


def test_a_file_of_the_user_stays(tree):
    assert TREES.make("install", tree)[0] == 0
    (tree / "src" / "RACEWAY" / "mine.cpp").touch()
    assert TREES.make("uninstall", tree)[0] == 0
    assert [path.name for path in (tree / "src" / "RACEWAY").iterdir()] == ["mine.cpp"]
