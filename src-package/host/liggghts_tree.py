#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-2.0-or-later
"""Install the styles in an upstream LIGGGHTS 3.8.0 source tree, with the patches that a modern
compiler needs, or remove both.

    python3 src-package/host/liggghts_tree.py install TREE
    python3 src-package/host/liggghts_tree.py uninstall TREE

The styles are registered like the host's own styles, whose headers are collected by Make.sh. The
sources are copied into TREE/src without subfolders, because the host compiles all sources in that
folder, and a machine file MAKE/Makefile.raceway is added. All changes are listed in
TREE/src/raceway.manifest.
"""

import sys
from pathlib import Path

from source_tree import PACKAGE, Host, Refused, Replace, Wrap, flat_sources, main, read

KNOWN = "3.8.0"
WITH_VTK = Wrap(
    "#ifdef LAMMPS_VTK    // raceway: VTK is optional", "#endif    // raceway: LAMMPS_VTK"
)
PATCHES = {  # none of these patches changes the behaviour of a compiled program
    "finish.cpp": Replace(
        "if (neighbor->lists[m]->numneigh > 0) {", "if (neighbor->lists[m]->numneigh != NULL) {"
    ),
    "utils.h": Replace(
        "return static_cast< std::ostringstream & >(( std::ostringstream() << std::dec << a )"
        " ).str();",
        "return std::to_string(a);",
    ),
    "dump_mesh_vtk.h": WITH_VTK,
    "dump_mesh_vtk.cpp": WITH_VTK,
}


class Liggghts(Host):
    name, variable, version = "LIGGGHTS", "LIGGGHTS", f"LIGGGHTS {KNOWN}"

    def base(self, tree):
        src = Path(tree) / "src"
        version = src / "version_liggghts.txt"
        if not version.is_file() or not (src / "Make.sh").is_file():
            raise Refused(
                f"{tree} is not a LIGGGHTS source tree: it must contain"
                " src/version_liggghts.txt and src/Make.sh"
            )
        found = read(version).strip()
        if found != KNOWN:
            raise Refused(
                f"{tree} is LIGGGHTS {found or 'without a version'}; only {KNOWN} is supported"
            )
        return src

    def patches(self, base):
        return PATCHES

    def added(self, base):
        machine = (PACKAGE / "host" / "Makefile.raceway").read_text()
        return {**flat_sources(), "MAKE/Makefile.raceway": machine}

    def hint(self, tree):
        return (
            f"Build it:  make -C {tree}/src raceway    (the program is {tree}/src/lmp_raceway)",
            f"make -C {tree}/src clean-raceway",
        )


if __name__ == "__main__":
    sys.exit(main(Liggghts(), __doc__, sys.argv[1:]))
