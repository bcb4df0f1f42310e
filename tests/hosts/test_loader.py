# SPDX-License-Identifier: GPL-2.0-or-later
"""The styles are available regardless of how LIGGGHTS is started: after `clear`, with LD_PRELOAD,
in partitions, and from Python."""

import os
import subprocess
import sys
import textwrap

import pytest
from host import FORMATS, ROOT, deck_file, frames, same_files, succeed


def test_clear(tmp_path):
    """Results for the second bearing in a script, after `clear`, are bitwise identical to those for
    the first."""
    deck = deck_file(
        tmp_path,
        f"variable out index {tmp_path}/first\ninclude tests/hosts/in.bits\nclear\n"
        f"variable out delete\nvariable out index {tmp_path}/second\ninclude tests/hosts/in.bits\n",
    )
    succeed(deck)
    assert frames(tmp_path / "first" / "balls.dump") == frames(tmp_path / "second" / "balls.dump")


def test_partition(tmp_path):
    """Two partitions run two lubricants at the same time (universe variables), and the results of
    each partition are bitwise identical to those of a separate run."""
    deck = deck_file(
        tmp_path,
        "variable lubricant universe mineral pao48\nvariable out index"
        f" {tmp_path}/together/${{lubricant}}\ninclude tests/hosts/in.bits\n",
    )
    succeed(deck, ranks=2, extra=("-partition", "2x1", "-screen", "none"))
    for oil in ("mineral", "pao48"):
        succeed("tests/hosts/in.bits", lubricant=oil, out=tmp_path / "alone" / oil)
        same_files(tmp_path / "together" / oil, tmp_path / "alone" / oil, "contacts.dump")


@pytest.mark.parametrize(
    "program, host, styles",
    [
        ("liggghts", "liggghts", "libraceway_liggghts.so"),
        ("lmp", "lammps", "libraceway_lammps_2021.so"),
    ],
)
def test_preload_into_the_stock_program(program, host, styles, tmp_path):
    """Debian's programs run decks after the styles have been loaded with LD_PRELOAD."""
    done = subprocess.run(
        [
            f"/usr/bin/{program}",
            "-in",
            "tests/hosts/in.bits",
            "-log",
            "none",
            "-var",
            "out",
            str(tmp_path),
            "-var",
            "dump_format",
            FORMATS.get(host, "format"),
        ],
        cwd=ROOT,
        text=True,
        capture_output=True,
        check=False,
        env=dict(os.environ, LD_PRELOAD=str(ROOT / "build" / styles)),
    )
    assert done.returncode == 0, done.stdout[-2000:] + done.stderr
    succeed("tests/hosts/in.bits", out=tmp_path / "ours")
    assert frames(tmp_path / "balls.dump") == frames(tmp_path / "ours" / "balls.dump")


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
    done = subprocess.run(
        [
            sys.executable,
            "-c",
            script,
            str(ROOT / "build" / "libraceway_liggghts.so"),
            str(tmp_path),
        ],
        cwd=ROOT,
        text=True,
        capture_output=True,
        check=False,
    )
    assert done.returncode == 0, done.stdout + done.stderr
    assert max(frames(tmp_path / "balls.dump")) == 420
