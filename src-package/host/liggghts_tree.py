#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-2.0-or-later
"""Put the styles into an upstream LIGGGHTS 3.8.0 source tree, with the patches a modern compiler
needs, or take them out.

    python3 src-package/host/liggghts_tree.py install TREE
    python3 src-package/host/liggghts_tree.py uninstall TREE

The styles register themselves there as all of the host's do: its Make.sh collects the headers that
name a style. Sources are copied flat into TREE/src, since the host compiles what lies there; a
machine file MAKE/Makefile.raceway is added. Everything is checked before anything is written;
TREE/src/raceway.manifest lists what was done, and uninstall undoes just that.
"""

import hashlib
import json
import os
import re
import sys
from pathlib import Path

PACKAGE = Path(__file__).resolve().parents[1]
ROOMS = ("physics", "implicit", "deck", "ranks", "contacts", "styles", "compat")
MANIFEST = "raceway.manifest"
KNOWN = "3.8.0"


class Refused(Exception):
    """A tree that this script leaves alone, and why."""


class Replace:
    """A passage of a file of the host, exactly once there, and what takes its place."""

    def __init__(self, before, after):
        self.before, self.after = before, after

    def is_in(self, text):
        return text.count(self.after) == 1 and self.before not in text.replace(self.after, "")

    def applies(self, text):
        return text.count(self.before) == 1 and not self.is_in(text)

    def apply(self, text):
        return text.replace(self.before, self.after)

    def undo(self, text):
        return text.replace(self.after, self.before)


class Wrap:
    """A line before and a line after a whole file of the host."""

    def __init__(self, first, last):
        self.first, self.last = first + "\n", last + "\n"

    def is_in(self, text):
        return text.startswith(self.first) and text.endswith(self.last)

    def applies(self, text):
        return not text.startswith(self.first)

    def apply(self, text):
        return self.first + text + self.last

    def undo(self, text):
        return text[len(self.first) : -len(self.last)]


WITH_VTK = Wrap(
    "#ifdef LAMMPS_VTK    // raceway: VTK is optional", "#endif    // raceway: LAMMPS_VTK"
)
PATCHES = {  # none changes what a compiled program does
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


def added_files():
    """What goes into TREE/src: {name: text}, folders between the rooms taken out of the
    includes."""
    found = {}
    for room in ROOMS:
        for source in sorted((PACKAGE / room).glob("*")):
            if source.suffix not in (".h", ".cpp"):
                continue
            assert source.name not in found, f"two files of the package are called {source.name}"
            found[source.name] = re.sub(
                rf'^#include "\.\./(?:{"|".join(ROOMS)})/',
                '#include "',
                source.read_text(),
                flags=re.M,
            )
    found["MAKE/Makefile.raceway"] = (PACKAGE / "host" / "Makefile.raceway").read_text()
    return found


def digest(text):
    return hashlib.sha256(text.encode()).hexdigest()


def read(path):
    try:
        with open(path, encoding="utf-8", newline="") as file:
            return file.read()
    except UnicodeDecodeError as error:
        raise Refused(f"{path} is no text: {error}") from None


def write(path, text, stat=None):
    """Whole or not at all; with the times of `stat` if given."""
    temporary = path.with_name(path.name + ".raceway-new")
    try:
        with open(temporary, "w", encoding="utf-8", newline="") as file:
            file.write(text)
        if stat:
            os.utime(temporary, ns=(stat.st_atime_ns, stat.st_mtime_ns))
        os.replace(temporary, path)
    except BaseException:
        temporary.unlink(missing_ok=True)
        raise


def source_folder(tree):
    """TREE/src of a LIGGGHTS that is known."""
    src = Path(tree) / "src"
    version = src / "version_liggghts.txt"
    if not version.is_file() or not (src / "Make.sh").is_file():
        raise Refused(
            f"{tree} is no LIGGGHTS source tree: there is no src/version_liggghts.txt with a"
            " src/Make.sh"
        )
    found = read(version).strip()
    if found != KNOWN:
        raise Refused(f"{tree} is LIGGGHTS {found or 'of no version'}; known is {KNOWN} only")
    return src


def install(tree):
    src = source_folder(tree)
    if (src / MANIFEST).exists():
        raise Refused(
            f"{tree} has Raceway in it already: make uninstall-tree LIGGGHTS={tree} takes it out"
        )
    for name, patch in PATCHES.items():
        path = src / name
        if not path.is_file():
            raise Refused(f"{path} is missing: not the sources of LIGGGHTS {KNOWN}")
        text = read(path)
        if patch.is_in(text):
            raise Refused(
                f"{path} is patched already, but not by this script: install into an unpatched tree"
            )
        if not patch.applies(text):
            raise Refused(
                f"{path} is not that of LIGGGHTS {KNOWN}: it has been changed where it must be"
                " patched"
            )
    new = added_files()
    for name in new:
        if (src / name).exists():
            raise Refused(
                f"{src / name} is there already and not of this script; nothing was changed"
            )
    if not os.access(src, os.W_OK) or not os.access(src / "MAKE", os.W_OK):
        raise Refused(f"{src} or its MAKE folder is not writable")

    manifest = {
        "added": {name: digest(text) for name, text in new.items()},
        "patched": sorted(PATCHES),
    }
    try:
        write(src / MANIFEST, json.dumps(manifest, indent=1) + "\n")
        for name, text in new.items():
            write(src / name, text)
        # their objects stay as good as they were: no need to compile the host again
        for name, patch in PATCHES.items():
            write(src / name, patch.apply(read(src / name)), (src / name).stat())
    except BaseException as error:
        take_out(src, manifest)
        if isinstance(error, OSError):
            raise Refused(f"{error}; all that had been written is taken out again") from None
        raise
    print(
        f"Raceway is in {tree}. Build it:  make -C {src} raceway    (the program is"
        f" {src}/lmp_raceway)"
    )


def take_out(src, manifest):
    """Undo what was done of `manifest`; what an interrupted installation had not come to is
    left."""
    for name in manifest["patched"]:
        path, patch = src / name, PATCHES[name]
        if path.is_file() and patch.is_in(read(path)):
            write(path, patch.undo(read(path)), path.stat())
    for name in manifest["added"]:
        (src / name).unlink(missing_ok=True)
    (src / MANIFEST).unlink(missing_ok=True)


def uninstall(tree):
    src = source_folder(tree)
    if not (src / MANIFEST).is_file():
        raise Refused(f"{tree} has no Raceway of this script in it: there is no src/{MANIFEST}")
    try:
        manifest = json.loads(read(src / MANIFEST))
        added, patched = manifest["added"], manifest["patched"]
        assert set(patched) <= set(PATCHES)
    except (ValueError, KeyError, TypeError, AssertionError):
        raise Refused(f"{src / MANIFEST} is not what this script writes") from None
    changed = [
        name
        for name, was in added.items()
        if (src / name).is_file() and digest(read(src / name)) != was
    ]
    changed += [
        name
        for name in patched
        if not (PATCHES[name].is_in(read(src / name)) or PATCHES[name].applies(read(src / name)))
    ]
    if changed:
        raise Refused(
            f"changed since the installation: {', '.join(sorted(changed))} in {src}; nothing was"
            " taken out. Save what you need of an added file elsewhere and delete it; undo changes"
            " to a patched one"
        )
    try:
        take_out(src, manifest)
    except OSError as error:
        raise Refused(f"{error}; make uninstall-tree again goes on where this stopped") from None
    print(
        f"Raceway is out of {tree}. Objects and programs that were built are left (make -C {src}"
        " clean-raceway)."
    )


def main(words):
    if len(words) != 2 or words[0] not in ("install", "uninstall"):
        print(__doc__, file=sys.stderr)
        return 2
    if not words[1]:
        print(f"Which tree? make {words[0]}-tree LIGGGHTS=/path/to/LIGGGHTS", file=sys.stderr)
        return 2
    try:
        {"install": install, "uninstall": uninstall}[words[0]](words[1])
    except Refused as why:
        print(f"Refused: {why}", file=sys.stderr)
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
