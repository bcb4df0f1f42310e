# SPDX-License-Identifier: GPL-2.0-or-later
"""The styles are available in stock programs with LD_PRELOAD and from Python."""

import sys
import textwrap
from pathlib import Path

import pytest
from host import ENVIRONMENT, ROOT, call, frames, same_files, succeed


@pytest.mark.parametrize(
    "program, host, styles",
    [
        ("liggghts", "liggghts", "libraceway_liggghts.so"),
        ("lmp", "lammps", "libraceway_lammps_2021.so"),
    ],
)
def test_preload_into_the_stock_program(program, host, styles, tmp_path, monkeypatch):
    """Debian's programs run decks after the styles have been loaded with LD_PRELOAD."""
    succeed("tests/hosts/in.bits", out=tmp_path / "ours")
    monkeypatch.setitem(ENVIRONMENT, "LD_PRELOAD", str(ROOT / "build" / styles))
    stock = Path("/usr/bin") / program
    succeed("tests/hosts/in.bits", program=stock, host=host, out=tmp_path / "stock")
    same_files(tmp_path / "ours", tmp_path / "stock", "balls.dump", read=frames)


def test_from_python(tmp_path):
    """The library is loaded with ctypes (as in "From Python" in docs), and runs the deck through
    its C interface."""
    script = textwrap.dedent("""
        import ctypes, sys
        lib = ctypes.CDLL(sys.argv[1], mode=ctypes.RTLD_GLOBAL)
        words_type, handle_type = ctypes.POINTER(ctypes.c_char_p), ctypes.POINTER(ctypes.c_void_p)
        lib.lammps_open_no_mpi.argtypes = [ctypes.c_int, words_type, handle_type]
        lib.lammps_file.argtypes = [ctypes.c_void_p, ctypes.c_char_p]
        lib.lammps_command.argtypes = [ctypes.c_void_p, ctypes.c_char_p]
        lib.lammps_close.argtypes = [ctypes.c_void_p]
        words = b"liggghts -log none -screen none -var out".split() + [sys.argv[2].encode()]
        array = (ctypes.c_char_p * len(words))(*words)
        handle = ctypes.c_void_p()
        lib.lammps_open_no_mpi(len(words), array, ctypes.byref(handle))
        lib.lammps_file(handle, b"tests/hosts/in.bits")
        lib.lammps_command(handle, b"run 20")
        lib.lammps_close(handle)
    """)
    library = ROOT / "build" / "libraceway_liggghts.so"
    done = call([sys.executable, "-c", script, library, tmp_path])
    assert done.returncode == 0, done.stdout + done.stderr
    assert max(frames(tmp_path / "balls.dump")) == 420
