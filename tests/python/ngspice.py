# SPDX-License-Identifier: GPL-2.0-or-later
"""Run ngspice (the shared library of Debian's libngspice0) in a separate process."""

import ctypes
import subprocess
import sys

import numpy as np

LIBRARY = "libngspice.so.0"


def run(netlist, folder, names):
    """Run `netlist` (text) in `folder` and return {name: values} for the vectors `names` and
    "time". Fail if ngspice reports an error."""
    circuit, found = folder / "net.cir", folder / "vectors.npz"
    circuit.write_text(netlist)
    done = subprocess.run(
        [sys.executable, __file__, str(circuit), str(found), *names],
        text=True,
        capture_output=True,
        timeout=120,
    )
    assert done.returncode == 0, done.stdout[-4000:] + done.stderr[-4000:]
    with np.load(found) as data:
        return dict(data)


class VectorInfo(ctypes.Structure):
    """The structure `vector_info` of sharedspice.h in ngspice."""

    _fields_ = [
        ("name", ctypes.c_char_p),
        ("type", ctypes.c_int),
        ("flags", ctypes.c_short),
        ("real", ctypes.POINTER(ctypes.c_double)),
        ("complex", ctypes.c_void_p),
        ("length", ctypes.c_int),
    ]


SAY = ctypes.CFUNCTYPE(ctypes.c_int, ctypes.c_char_p, ctypes.c_int, ctypes.c_void_p)
EXIT = ctypes.CFUNCTYPE(
    ctypes.c_int, ctypes.c_int, ctypes.c_bool, ctypes.c_bool, ctypes.c_int, ctypes.c_void_p
)


def main(circuit, found, *names):
    spice = ctypes.CDLL(LIBRARY)
    said = []

    @SAY
    def say(text, *_):
        said.append(text.decode(errors="replace"))
        print(said[-1])
        return 0

    @EXIT
    def leave(status, *_):
        print(f"ngspice requests exit with {status}")
        return 0

    assert spice.ngSpice_Init(say, None, leave, None, None, None, None) == 0
    for command in (f"source {circuit}", "run"):
        assert spice.ngSpice_Command(command.encode()) == 0
    assert not [line for line in said if "error" in line.lower()]
    spice.ngGet_Vec_Info.restype = ctypes.POINTER(VectorInfo)
    values = {}
    for name in ("time", *names):
        one = spice.ngGet_Vec_Info(name.encode())
        assert one, f"no vector {name}"
        values[name] = np.ctypeslib.as_array(one.contents.real, (one.contents.length,)).copy()
    np.savez(found, **values)


if __name__ == "__main__":
    main(*sys.argv[1:])
