# SPDX-License-Identifier: GPL-2.0-or-later
"""The include graph of src-package: rooms, arrows between them, floors.

    python3 tests/include_graph.py [ROOT]

prints the graph of the tree at ROOT (default: this one). The exit code is 1 if a rule is broken:
an arrow that `ARROWS` does not allow, a cycle of files or of modules, or more than `MOST_FLOORS`
floors.

A room is a folder of src-package. An arrow A -> B says that a file of A includes a file of B. A
floor is one file in the longest chain of includes among the files of `FLOOR_ROOMS`. A module is a
header with its sources and its private headers.
"""

import re
import sys
from pathlib import Path

# What each room may include besides itself.
ARROWS = {
    "host": {"styles", "contacts", "deck", "physics", "compat"},
    "styles": {"record", "contacts", "deck", "ranks", "implicit", "physics", "compat"},
    "record": {"contacts", "physics"},
    "ranks": {"contacts", "deck", "implicit", "physics", "compat"},
    "contacts": {"deck", "implicit", "physics", "compat"},
    "deck": {"physics", "compat"},
    "implicit": {"physics"},
    "core": {"physics"},
    "physics": set(),
    "compat": set(),
}
FLOOR_ROOMS = ("styles", "contacts", "deck", "ranks")
MOST_FLOORS = 7
INCLUDE = re.compile(r'^\s*#\s*include\s+"([^"]+)"', re.MULTILINE)


def read(package):
    """{file: files of the package that it includes}, both relative to `package`; headers of the
    host are left out."""
    package = Path(package).resolve()
    files = {p for p in package.rglob("*") if p.suffix in (".h", ".cpp")}
    graph = {}
    for file in sorted(files):
        targets = set()
        for name in INCLUDE.findall(file.read_text(encoding="utf-8")):
            for folder in (
                file.parent,
                package / "compat",
            ):  # as the compiler looks for it
                target = (folder / name).resolve()
                if target in files:
                    targets.add(target.relative_to(package))
                    break
        graph[file.relative_to(package)] = targets
    return graph


def room(file):
    """The folder of src-package that a file lies in."""
    return file.parts[0]


def arrows(graph):
    """{(room, other room): [(file, included file), ...]}"""
    found = {}
    for file, targets in graph.items():
        for target in sorted(targets):
            if room(file) != room(target):
                found.setdefault((room(file), room(target)), []).append((file, target))
    return found


def longest_chain(graph):
    """Longest chain of includes as a list of files, and a cycle as a list of files (empty if there
    is none)."""
    best, cycle = {}, []

    def chain(file, above):
        if file in above:
            cycle[:] = [*above[above.index(file) :], file]
            return []
        if file not in best:
            below = [chain(t, [*above, file]) for t in sorted(graph[file] & graph.keys())]
            best[file] = [file, *max(below, key=len, default=[])]
        return best[file]

    chains = [chain(file, []) for file in sorted(graph)]
    return max(chains, key=len, default=[]), cycle


def modules(graph):
    """{file: name of its module}.

    A source belongs to the header of its name, or to that with the longest name which its own
    continues after an underscore. A header is private to a module that it includes and that alone
    includes it.
    """
    headers = {f.with_suffix("") for f in graph if f.suffix == ".h"}

    def owner(file):
        name = file.with_suffix("")
        while name not in headers and "_" in name.name:
            name = name.with_name(name.name.rpartition("_")[0])
        return name if name in headers else file.with_suffix("")

    found = {f: owner(f) if f.suffix == ".cpp" else f.with_suffix("") for f in graph}
    for file in graph:
        users = {found[f] for f, targets in graph.items() if file in targets} - {found[file]}
        if len(users) == 1 and file.suffix == ".h":
            (user,) = users
            if any(found[t] == user for t in graph[file]):
                found[file] = user
    return found


def module_graph(graph):
    """{module: modules that its files include}"""
    of, found = modules(graph), {}
    for file, targets in graph.items():
        found.setdefault(of[file], set()).update({of[t] for t in targets} - {of[file]})
    return found


def floors(graph):
    """Longest chain of includes among the files of `FLOOR_ROOMS`."""
    part = {f: {t for t in ts if room(t) in FLOOR_ROOMS} for f, ts in graph.items()}
    return longest_chain({f: ts for f, ts in part.items() if room(f) in FLOOR_ROOMS})[0]


def broken(graph):
    """What breaks a rule, a sentence each."""
    wrong = [
        f"{file} includes {target}: {a} may not include {b}"
        for (a, b), pairs in sorted(arrows(graph).items())
        if b not in ARROWS.get(a, set())
        for file, target in pairs
    ]
    cycle = longest_chain(graph)[1]
    if cycle:
        wrong.append("a cycle: " + " -> ".join(map(str, cycle)))
    knot = longest_chain(module_graph(graph))[1]
    if knot and not cycle:
        wrong.append("a cycle of modules: " + " -> ".join(map(str, knot)))
    height = len(floors(graph))
    if height > MOST_FLOORS:
        wrong.append(f"{height} floors, at most {MOST_FLOORS} are allowed")
    return wrong


def main(root):
    """Print rooms, arrows, floors and what is wrong; return the number of broken rules."""
    graph = read(Path(root) / "src-package")
    print("rooms (files):")
    for name in sorted({room(f) for f in graph}):
        print(f"  {name:9} {sum(room(f) == name for f in graph):3}")
    print("arrows (includes):")
    for (a, b), pairs in sorted(arrows(graph).items()):
        print(f"  {a:9} -> {b:9} {len(pairs):3}")
    chain = floors(graph)
    print(f"floors of {', '.join(FLOOR_ROOMS)}: {len(chain)}")
    for file in chain:
        print(f"  {file}")
    whole = longest_chain(graph)[0]
    print(f"longest chain of the package: {len(whole)} files, from {whole[0]} to {whole[-1]}")
    wrong = broken(graph)
    print("broken rules:" if wrong else "no rule is broken")
    for line in wrong:
        print(f"  {line}")
    return len(wrong)


if __name__ == "__main__":
    sys.exit(main(sys.argv[1] if len(sys.argv) > 1 else Path(__file__).parents[1]) > 0)
