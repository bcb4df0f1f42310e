# SPDX-License-Identifier: GPL-2.0-or-later
"""Install the styles in the source tree of a host, or remove them.

Everything is checked before anything is written. All changes are listed in a manifest, and
uninstall reverts exactly these changes. A `Host` describes the source tree of a host and the
changes to it (liggghts_tree.py, lammps_tree.py).
"""

import hashlib
import json
import os
import re
import sys
from pathlib import Path

PACKAGE = Path(__file__).resolve().parents[1]
ROOMS = ("core/*", "deck", "ranks", "contacts", "styles", "compat")
MANIFEST = "raceway.manifest"


class Refused(Exception):
    """Raised if the script leaves the tree unchanged. The message states the reason."""


class Replace:
    """A patch that replaces a passage that occurs exactly once in a file of the host."""

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
    """A patch that adds a line before and a line after the whole text of a file of the host."""

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


class Both:
    """Two patches of the same file; the second is applied to the result of the first."""

    def __init__(self, first, second):
        self.first, self.second = first, second

    def is_in(self, text):
        return self.first.is_in(text) and self.second.is_in(text)

    def applies(self, text):
        return self.first.applies(text) and self.second.applies(text)

    def apply(self, text):
        return self.second.apply(self.first.apply(text))

    def undo(self, text):
        return self.first.undo(self.second.undo(text))


class Host:
    """A host with a known source tree: its names, and methods that act on such a tree."""

    name = variable = version = ""

    def base(self, tree):
        """Return the folder to which the names in the manifest are relative, or raise `Refused` if
        `tree` is not a source tree of this host."""
        raise NotImplementedError

    def patches(self, base):
        """Return the patches of files of the host as {name: patch}."""
        raise NotImplementedError

    def added(self, base):
        """Return the new files as {name: text}."""
        raise NotImplementedError

    def hint(self, tree):
        """Return the commands that build the host, and those that remove the build results."""
        raise NotImplementedError

    def in_use(self, base):
        """Return the reason why the package cannot be removed now, or "" if it can be removed."""
        return ""


def flat_sources():
    """Return the sources of the package as {name: text}, with the folders removed from includes."""
    found = {}
    for room in ROOMS:
        for source in sorted(PACKAGE.glob(f"{room}/*")):
            if source.suffix not in (".h", ".cpp") or source.parent.name == "interface":
                continue
            assert source.name not in found, f"two files of the package are called {source.name}"
            found[source.name] = re.sub(
                r'^#include "\.\./(?:\w+/|\.\./)*',
                '#include "',
                source.read_text(),
                flags=re.M,
            )
    return found


def digest(text):
    return hashlib.sha256(text.encode()).hexdigest()


def read(path):
    try:
        with open(path, encoding="utf-8", newline="") as file:
            return file.read()
    except UnicodeDecodeError as error:
        raise Refused(f"{path} is not text: {error}") from None


def write(path, text, stat=None):
    """Write the file atomically, with the file times from `stat` if it is given."""
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


def install(host, tree):
    src = host.base(tree)
    patches = host.patches(src)
    if (src / MANIFEST).exists():
        raise Refused(
            f"{tree} already contains Raceway; make uninstall-tree {host.variable}={tree} removes"
            " it"
        )
    for name, patch in patches.items():
        path = src / name
        if not path.is_file():
            raise Refused(f"{path} is missing: not the sources of {host.version}")
        text = read(path)
        if patch.is_in(text):
            raise Refused(
                f"{path} is patched already, but not by this script: install into an unpatched tree"
            )
        if not patch.applies(text):
            raise Refused(
                f"{path} is not the file of {host.version}: the passage to patch has been changed"
            )
    new = host.added(src)
    for name in new:
        if (src / name).exists():
            raise Refused(
                f"{src / name} exists but was not created by this script; nothing was changed"
            )
    for folder in {(src / name).parent for name in (MANIFEST, *patches, *new)}:
        there = next(above for above in (folder, *folder.parents) if above.exists())
        if not os.access(there, os.W_OK):
            raise Refused(f"{there} is not writable")

    made = {(src / name).parent for name in new if not (src / name).parent.exists()}
    manifest = {
        "added": {name: digest(text) for name, text in new.items()},
        "patched": sorted(patches),
        "folders": sorted(str(folder.relative_to(src)) for folder in made),
    }
    try:
        write(src / MANIFEST, json.dumps(manifest, indent=1) + "\n")
        for folder in made:
            folder.mkdir(parents=True, exist_ok=True)
        for name, text in new.items():
            write(src / name, text)
        # keep the old file times, so that make does not compile the whole host again
        for name, patch in patches.items():
            write(src / name, patch.apply(read(src / name)), (src / name).stat())
    except BaseException as error:
        take_out(src, manifest, patches)
        if isinstance(error, OSError):
            raise Refused(f"{error}; everything written so far was removed again") from None
        raise
    print(f"Raceway has been installed in {tree}. {host.hint(tree)[0]}")


def take_out(src, manifest, patches):
    """Revert the changes listed in `manifest`, except for those that an interrupted installation
    had not yet made."""
    for name in manifest["patched"]:
        path, patch = src / name, patches[name]
        if path.is_file() and patch.is_in(read(path)):
            write(path, patch.undo(read(path)), path.stat())
    for name in manifest["added"]:
        (src / name).unlink(missing_ok=True)
    for name in manifest["folders"]:
        if (src / name).is_dir() and not any((src / name).iterdir()):
            (src / name).rmdir()
    (src / MANIFEST).unlink(missing_ok=True)


def uninstall(host, tree):
    src = host.base(tree)
    patches = host.patches(src)
    if not (src / MANIFEST).is_file():
        raise Refused(
            f"{tree} has no Raceway installed by this script: there is no {src.name}/{MANIFEST}"
        )
    try:
        manifest = json.loads(read(src / MANIFEST))
        added, patched, _ = (manifest[key] for key in ("added", "patched", "folders"))
        assert set(patched) <= set(patches)
    except (ValueError, KeyError, TypeError, AssertionError):
        raise Refused(f"{src / MANIFEST} was not written by this script") from None
    if why := host.in_use(src):
        raise Refused(f"{why}; nothing was removed")
    changed = [
        name
        for name, was in added.items()
        if (src / name).is_file() and digest(read(src / name)) != was
    ]
    changed += [
        name
        for name in patched
        if not (patches[name].is_in(read(src / name)) or patches[name].applies(read(src / name)))
    ]
    if changed:
        raise Refused(
            f"changed since the installation: {', '.join(sorted(changed))} in {src}; nothing was"
            " removed. Save elsewhere what you need from an added file and delete the file; revert"
            " changes to a patched file"
        )
    try:
        take_out(src, manifest, patches)
    except OSError as error:
        raise Refused(f"{error}; repeat make uninstall-tree to continue") from None
    print(
        f"Raceway was removed from {tree}. To remove the compiled objects and programs,"
        f" run {host.hint(tree)[1]}."
    )


def main(host, usage, words):
    """Run the command given by `words` (install or uninstall, and the tree) for a `Host`."""
    if len(words) != 2 or words[0] not in ("install", "uninstall"):
        print(usage, file=sys.stderr)
        return 2
    if not words[1]:
        print(
            f"Which tree? make {words[0]}-tree {host.variable}=/path/to/{host.name}",
            file=sys.stderr,
        )
        return 2
    try:
        {"install": install, "uninstall": uninstall}[words[0]](host, words[1])
    except Refused as why:
        print(f"Refused: {why}", file=sys.stderr)
        return 1
    return 0
