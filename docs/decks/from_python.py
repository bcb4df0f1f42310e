# Run LIGGGHTS with the package from Python, without a subprocess:
#   .venv/bin/python docs/decks/from_python.py
# RTLD_GLOBAL puts the package before libliggghts in the search order,
# so its styles are available when the host starts.
import ctypes

lib = ctypes.CDLL("build/libraceway_liggghts.so", mode=ctypes.RTLD_GLOBAL)
lib.lammps_open_no_mpi.argtypes = [
    ctypes.c_int,
    ctypes.POINTER(ctypes.c_char_p),
    ctypes.POINTER(ctypes.c_void_p),
]
lib.lammps_file.argtypes = lib.lammps_command.argtypes = [ctypes.c_void_p, ctypes.c_char_p]
lib.lammps_close.argtypes = [ctypes.c_void_p]

words = [b"liggghts", b"-log", b"none", b"-screen", b"none"]
bearing = ctypes.c_void_p()
lib.lammps_open_no_mpi(len(words), (ctypes.c_char_p * len(words))(*words), ctypes.byref(bearing))
lib.lammps_file(bearing, b"docs/decks/in.smallest")
lib.lammps_command(bearing, b"run 1000")
lib.lammps_close(bearing)
