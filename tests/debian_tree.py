# SPDX-License-Identifier: GPL-2.0-or-later
"""Install Raceway in an upstream LIGGGHTS source tree that comes from Debian's tarball, and build
build/tree/lmp_raceway.

    python3 tests/debian_tree.py [FLAG ...]

apt runs with a private configuration under build/source, which has separate folders and takes its
sources from those of the machine; the user's apt is not changed. Files that already exist are
neither fetched nor rebuilt. The build is unoptimised and uses clang, because optimisation
multiplies the compile time, and g++ takes one and a half times as long as clang. The headers that
most of the host's sources include are precompiled for them. They are not precompiled for Raceway's
sources, so that each Raceway source still has to include what it needs.

The flags are those of sanitizers. Raceway's sources are compiled with them, and as code of a shared
library, because the Makefile also links the objects to Debian's LIGGGHTS (build/sanitized).
"""

import json
import re
import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
SOURCE, TREE = ROOT / "build" / "source", ROOT / "build" / "tree"
INSTALLER = ROOT / "src-package" / "host" / "liggghts_tree.py"
sys.path.insert(0, str(INSTALLER.parent))
import liggghts_tree  # noqa: E402
import source_tree  # noqa: E402

COMPILER, HEADER = TREE / "compiler", TREE / "host.h"
OWN = "-DRACEWAY_ONE_TARGET"  # a flag that only Raceway's sources are compiled with
SHARED = "-g1 -fPIC -fvisibility=hidden"
# as C++17, clang rejects the `register` variables in the host's sources
SCRIPT = f"""#!/bin/sh
export OMPI_CXX=clang++
case " $* " in
*" {OWN} "* | *" -x "*) ;;
*" -c "*) set -- -include-pch {HEADER}.pch "$@" ;;
esac
exec mpicxx.openmpi -Wno-register "$@"
"""
COMMON = """#include <mpi.h>
#include <cmath>
#include <fstream>
#include <iomanip>
#include <iostream>
#include <list>
#include <map>
#include <set>
#include <sstream>
#include <vector>
#include "pointers.h"
#include "atom.h"
#include "comm.h"
#include "domain.h"
#include "fix_property_global.h"
#include "force.h"
#include "memory.h"
#include "modify.h"
#include "neighbor.h"
#include "update.h"
"""


def run(*command, quiet=True, **kwargs):
    done = subprocess.run(
        [str(word) for word in command],
        text=True,
        check=False,
        stdin=subprocess.DEVNULL,
        stdout=subprocess.PIPE if quiet else None,
        stderr=subprocess.STDOUT if quiet else None,
        **kwargs,
    )
    if done.returncode:
        sys.exit(f"{' '.join(map(str, command))[:300]} failed:\n{(done.stdout or '')[-1500:]}")


def release():
    """Return the codename of the installed Debian release and the names of its suites."""
    names = dict(
        re.findall(r'^(\w+)="?([^"\n]*)"?$', Path("/etc/os-release").read_text(), flags=re.M)
    )
    return {names.get("VERSION_CODENAME", "bookworm"), "stable", "oldstable"}


def source_entries(folder, suites):
    """Return the entries in apt's `folder` for the section main of `suites`, as deb-src stanzas."""
    stanzas = []
    for path in [folder / "sources.list", *sorted((folder / "sources.list.d").glob("*"))]:
        if not path.is_file():
            continue
        text = re.sub(r"^#.*\n?", "", path.read_text(), flags=re.M)
        if path.suffix == ".list":
            for options, uri, suite, parts in re.findall(
                r"^deb(?:\s+\[(.*?)\])?\s+(\S+)\s+(\S+)\s+(.+)$", text, flags=re.M
            ):
                if suite in suites and "main" in parts.split():
                    signed = re.search(r"signed-by=(\S+)", options or "")
                    stanzas.append(
                        f"Types: deb-src\nURIs: {uri}\nSuites: {suite}\nComponents: main\n"
                        + (f"Signed-By: {signed.group(1)}\n" if signed else "")
                    )
        elif path.suffix == ".sources":
            for stanza in re.split(r"\n\s*\n", text):
                field = {
                    key.lower(): value.split()
                    for key, value in re.findall(
                        r"^([\w-]+):\s*(.*(?:\n\s+.*)*)", stanza, flags=re.M
                    )
                }
                suite = [name for name in field.get("suites", []) if name in suites]
                if (
                    "deb" not in field.get("types", [])
                    or not suite
                    or "main" not in field.get("components", [])
                ):
                    continue
                if field.get("enabled") == ["no"]:
                    continue
                kept = re.sub(
                    r"^(Types|Suites|Components|Architectures):.*(?:\n\s+.*)*\n?",
                    "",
                    stanza + "\n",
                    flags=re.M | re.I,
                )
                stanzas.append(
                    f"Types: deb-src\nSuites: {' '.join(suite)}\nComponents: main\n{kept.strip()}\n"
                )
    return stanzas


def fetch(package):
    """Fetch the upstream sources of a package in the form of Debian's tarball, and return its
    path."""
    there = sorted(SOURCE.glob(f"{package}_*.orig.tar.*"))
    if there:
        return there[-1]
    stanzas = source_entries(Path("/etc/apt"), release())
    if not stanzas:
        sys.exit(
            "no entry of this machine's apt sources provides the main part of its Debian:"
            f" cannot fetch the sources of {package}"
        )
    apt = SOURCE / "apt"
    for folder in ("lists/partial", "cache/archives/partial"):
        (apt / folder).mkdir(parents=True, exist_ok=True)
    (apt / "debian.sources").write_text("\n".join(stanzas))
    options = [
        f"Dir::Etc::sourcelist={apt}/debian.sources",
        "Dir::Etc::sourceparts=-",
        f"Dir::State::lists={apt}/lists",
        f"Dir::Cache={apt}/cache",
        "APT::Sandbox::User=root",
    ]
    apt_get = ["apt-get", "-q", *(word for option in options for word in ("-o", option))]
    run(*apt_get, "update")
    run(*apt_get, "source", "--tar-only", package, cwd=SOURCE)
    there = sorted(SOURCE.glob(f"{package}_*.orig.tar.*"))
    if not there:
        sys.exit(f"apt-get source --tar-only {package} left no tarball")
    return there[-1]


def unpacked(folder, package="liggghts"):
    """Return the upstream tree of a package in `folder`, after unpacking it if necessary."""
    if not (folder / "src" / "Make.sh").is_file():
        folder.mkdir(parents=True, exist_ok=True)
        run("tar", "-xf", fetch(package), "-C", folder, "--strip-components=1")
    return folder


def precompile(src):
    """Precompile `HEADER` with the flags of the host's sources, and write a script that calls the
    compiler with the precompiled header."""
    if Path(f"{HEADER}.pch").exists():
        return
    COMPILER.write_text(SCRIPT)
    COMPILER.chmod(0o755)
    HEADER.write_text(COMMON)
    (flags,) = re.findall(
        r"^CCFLAGS = (.*)", (src / "MAKE" / "Makefile.raceway").read_text(), flags=re.M
    )
    flags = flags.replace("$(OPTIMISE_HOST)", "-O0").split()
    run(COMPILER, *flags, "-I", src, "-x", "c++-header", "-c", HEADER, "-o", f"{HEADER}.pch")


def main(sanitizers):
    tree = unpacked(TREE / "liggghts")
    manifest = tree / "src" / source_tree.MANIFEST
    wanted = {
        name: source_tree.digest(text)
        for name, text in liggghts_tree.Liggghts().added(None).items()
    }
    if manifest.exists() and json.loads(manifest.read_text())["added"] != wanted:
        run(sys.executable, INSTALLER, "uninstall", tree)
    if not manifest.exists():
        run(sys.executable, INSTALLER, "install", tree)
    precompile(tree / "src")
    flags = [
        "OPTIMISE_HOST=-O0",
        f"OPTIMISE=-O0 {OWN} {SHARED} {sanitizers}",
        f"LINKFLAGS={sanitizers}",
    ]
    run("make", "-j2", "raceway", f"CC={COMPILER}", *flags, cwd=tree / "src")
    program = TREE / "lmp_raceway"
    program.unlink(missing_ok=True)
    program.symlink_to("liggghts/src/lmp_raceway")


if __name__ == "__main__":
    main(" ".join(sys.argv[1:]))
