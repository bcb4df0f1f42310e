# SPDX-License-Identifier: GPL-2.0-or-later
"""Check the include graph of src-package: its rooms, the includes between them, and their floors.

    python3 tests/include_graph.py [ROOT]

prints the graph of the tree at ROOT (default: this tree). The exit code is 1 if a rule is broken,
i.e. if a file includes a file from a room above its own, if there is a cycle of files or of
modules, if a room has more than `MOST_FLOORS` floors, or if a chain has more than `LONGEST` files.

A room is a folder of src-package. The number of floors of a room is the number of files in the
longest chain of includes within the room. A module is a header with its sources and its private
headers. docs/room_table.py uses this file to generate the table in docs/design.rst.
"""

import re
import sys
from pathlib import Path

# The rooms and their contents, from the bottom up. A file may include files of its own room and of
# lower rooms. No room in core/ may include a header of a host or of MPI.
ROOMS = {
    "core/numbers": "four numbers at a time, dual numbers, vectors, exponential, logarithm, tables",
    "core/laws": "formulas for plain numbers: Hertz, film, damping, friction, rolling, drag, oil",
    "core/geometry": "grooves, arches, shoulders, cage rails, ring bodies, surface profiles",
    "core/raceway": "a raceway with its constants, the kinematics and state of a contact, validity",
    "core/parts": "the parts of the contact law, one file each, with their losses",
    "core/contact": "laws as sets of parts: fused, part by part, with derivatives, four at a time",
    "core/electric": "capacitors, network, circuit, breakdown, impedance, waveforms",
    "core/bodies": "balls, rings, shafts and modes as bodies in the implicit step",
    "core/step": "the implicit step of one bearing",
    "core/settings": "readers for commands, their options, and data files",
    "core/figures": "output columns; sums and extremes for rings and bearings; the contact table",
    "core/record": "the record of a run: a growing netCDF file, written without a library",
    "core/interface": "a C interface through which Python calls the laws by name",
    "compat": "a common interface that hides the differences between hosts",
    "deck": "values driven by the deck, checks that ranks agree, tables of variables",
    "contacts": "attributes of the contact table, step check, validity check",
    "ranks": "messages between ranks, sums over rings, the home rank of a bearing",
    "styles": "pair styles, fixes, computes, commands: everything that a deck can name",
    "host": "loaders, plugin, program; installation into a LIGGGHTS or LAMMPS source tree",
}
MOST_FLOORS = 6
LONGEST = 15
INCLUDE = re.compile(r'^\s*#\s*include\s+"([^"]+)"', re.MULTILINE)


def read(package):
    """Return a dict that maps each file to the files of the package that it includes, relative to
    `package`. Headers of the host are left out."""
    package = Path(package).resolve()
    files = {p for p in package.rglob("*") if p.suffix in (".h", ".cpp")}
    graph = {}
    for file in sorted(files):
        targets = set()
        for name in INCLUDE.findall(file.read_text(encoding="utf-8")):
            for folder in (
                file.parent,
                package / "compat",
            ):  # the folders that the compiler searches
                target = (folder / name).resolve()
                if target in files:
                    targets.add(target.relative_to(package))
                    break
        graph[file.relative_to(package)] = targets
    return graph


def room(file):
    """Return the room of a file, i.e. the folder that contains it."""
    return file.parent.as_posix() if file.parts[0] == "core" else file.parts[0]


def arrows(graph):
    """Return a dict that maps (room, other room) to a list of (file, included file)."""
    found = {}
    for file, targets in graph.items():
        for target in sorted(targets):
            if room(file) != room(target):
                found.setdefault((room(file), room(target)), []).append((file, target))
    return found


def longest_chain(graph):
    """Return the longest chain of includes and one cycle of includes, each as a list of files. The
    latter is empty if there is no cycle."""
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
    """Return a dict that maps each file to the name of its module.

    A source belongs to the header with the same name. If there is none, it belongs to the header
    with the longest name that, followed by an underscore, begins the name of the source. A header
    is private to the module that includes it if no file outside this module includes it.
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
    """Return a dict that maps each module to the modules that its files include."""
    of, found = modules(graph), {}
    for file, targets in graph.items():
        found.setdefault(of[file], set()).update({of[t] for t in targets} - {of[file]})
    return found


def floors(graph, name):
    """Return the longest chain of includes within a room."""
    inside = {f: ts for f, ts in graph.items() if room(f) == name}
    return longest_chain({f: {t for t in ts if t in inside} for f, ts in inside.items()})[0]


def broken(graph):
    """Return a list that contains one sentence for each violation of the rules."""
    order = list(ROOMS)
    wrong = [f"{name} is not a room" for name in sorted({room(f) for f in graph} - set(order))]
    if wrong:
        return wrong
    wrong += [
        f"{file} includes {target}: {a} may not include {b}"
        for (a, b), pairs in sorted(arrows(graph).items())
        if order.index(b) > order.index(a)
        for file, target in pairs
    ]
    chain, cycle = longest_chain(graph)
    if cycle:
        return [*wrong, "a cycle: " + " -> ".join(map(str, cycle))]
    knot = longest_chain(module_graph(graph))[1]
    if knot:
        wrong.append("a cycle of modules: " + " -> ".join(map(str, knot)))
    for name in order:
        height = len(floors(graph, name))
        if height > MOST_FLOORS:
            wrong.append(f"{height} floors in {name}, at most {MOST_FLOORS} are allowed")
    if len(chain) > LONGEST:
        wrong.append(f"a chain of {len(chain)} files, at most {LONGEST} are allowed: "
                     + " -> ".join(map(str, chain)))  # fmt: skip
    return wrong


def table(graph):
    """Return a list of (room, files, floors, contents), from the bottom up."""
    return [
        (name, sum(room(f) == name for f in graph), len(floors(graph, name)), holds)
        for name, holds in ROOMS.items()
    ]


def main(root):
    """Print rooms, arrows, floors and violations, and return the number of violations."""
    graph = read(Path(root) / "src-package")
    print("rooms (files, floors):")
    for name, files, height, holds in table(graph):
        print(f"  {name:15} {files:3} {height:2}  {holds}")
    print("arrows (includes):")
    for (a, b), pairs in sorted(arrows(graph).items()):
        print(f"  {a:15} -> {b:15} {len(pairs):3}")
    chain = longest_chain(graph)[0]
    print(f"longest chain: {len(chain)} files")
    for file in chain:
        print(f"  {file}")
    wrong = broken(graph)
    print("broken rules:" if wrong else "no rule is broken")
    for line in wrong:
        print(f"  {line}")
    return len(wrong)


if __name__ == "__main__":
    sys.exit(main(sys.argv[1] if len(sys.argv) > 1 else Path(__file__).parents[1]) > 0)
