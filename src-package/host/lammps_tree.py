#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-2.0-or-later
"""Add the styles to a LAMMPS source tree as the package RACEWAY, or remove the package.

    python3 src-package/host/lammps_tree.py install TREE
    python3 src-package/host/lammps_tree.py uninstall TREE

The package is installed in TREE/src/RACEWAY, for `make yes-raceway` and for CMake with
-D PKG_RACEWAY=on, and its name is added to CMake's list of packages. The machine file
MAKE/MINE/Makefile.raceway is the Makefile.mpi of the tree with the flags of Raceway. All changes
are listed in TREE/raceway.manifest.
"""

import re
import sys
from pathlib import Path

import lammps_folder
from source_tree import Both, Host, Refused, Replace, flat_sources, main, read

FLAGS = "-O3 -std=c++17 -fno-math-errno -fno-trapping-math -ffp-contract=off -Wno-psabi"
LISTED = Replace("set(STANDARD_PACKAGES\n", "set(STANDARD_PACKAGES\n  RACEWAY\n")
# releases up to 2022 require C++11; later ones accept -D CMAKE_CXX_STANDARD=17
STANDARD = Replace(
    "\nset(CMAKE_CXX_STANDARD 11)\n", "\nset(CMAKE_CXX_STANDARD 17) # raceway: was 11\n"
)
CMAKE = "cmake/CMakeLists.txt"


class Lammps(Host):
    name, variable, version = "LAMMPS", "LAMMPS", "a known LAMMPS"

    def base(self, tree):
        try:
            lammps_folder.known(lammps_folder.version(Path(tree)), tree)
        except lammps_folder.Refused as why:
            raise Refused(why) from None
        return Path(tree)

    def patches(self, base):
        text = read(base / CMAKE) if (base / CMAKE).is_file() else ""
        forced = STANDARD.before in text or STANDARD.after in text
        return {CMAKE: Both(LISTED, STANDARD) if forced else LISTED}

    def added(self, base):
        taken = [name for name in flat_sources() if (base / "src" / name).exists()]
        if taken:
            raise Refused(
                f"{base}/src has {', '.join(taken)} already: make yes-raceway would overwrite them"
                " with files of Raceway"
            )
        sources = {f"src/RACEWAY/{name}": text for name, text in flat_sources().items()}
        return {**sources, "src/MAKE/MINE/Makefile.raceway": self.machine(base)}

    @staticmethod
    def machine(base):
        """Return the machine file that `make raceway` uses."""
        path = base / "src" / "MAKE" / "Makefile.mpi"
        text = read(path) if path.is_file() else ""
        text, compiled = re.subn(r"^CCFLAGS\s*=.*$", f"CCFLAGS = {FLAGS}", text, flags=re.M)
        text, linked = re.subn(r"^LINKFLAGS\s*=.*$", "LINKFLAGS = -O3", text, flags=re.M)
        if (compiled, linked) != (1, 1):
            raise Refused(
                f"{path} is not the file of LAMMPS: it must have exactly one line CCFLAGS and one"
                " LINKFLAGS"
            )
        return "# raceway = MPI, the flags of Raceway: same bits as build/liggghts\n" + text

    def hint(self, tree):
        return (
            f"Build it:  make -C {tree}/src yes-raceway && make -C {tree}/src raceway,"
            " or CMake with -D PKG_RACEWAY=on -D CMAKE_CXX_STANDARD=17",
            f"make -C {tree}/src clean-raceway",
        )

    def in_use(self, base):
        if (base / "src" / "create_bearing.cpp").exists():
            return f"the package is installed in {base}/src: make -C {base}/src no-raceway first"
        return ""


if __name__ == "__main__":
    sys.exit(main(Lammps(), __doc__, sys.argv[1:]))
