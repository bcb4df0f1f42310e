# SPDX-License-Identifier: GPL-2.0-or-later
"""Count, for each law, the tests whose expected value does not come from the package but from
40-digit arithmetic, quadrature, a different type of solver, or printed values.

    python tests/references/count.py [--list] [TREE ...]

A test is assigned to a law if words of that law occur in the name of the test, in its body or in
the name of its file. The reference may also be in those helpers, fixtures and constants of the file
that the test uses."""

import ast
import re
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
FOLDERS = ("physics", "python", "friction", "implicit")
# {law: (number of tests at a7b5052, where most laws existed in two languages; words that mark the
# tests of the law)}
LAWS = {
    "elliptic integrals, Hertz": (16, r"elliptic|ellipk|hertz|semi_axes"),
    "effective radii": (8, r"effective_radii|curvatures|meusnier"),
    "film, power laws": (7, r"hamrock|masjedi|h_min|film_thickness"),
    "film in all regimes": (2, r"regimes|asymptot|film_laws"),
    "film factors": (0, r"inlet_shear|murch|starvation|film_factors|thermal"),
    "film in the gap": (3, r"film_gap|gap_film|in_the_gap"),
    "film branch": (4, r"film_branch|film_damping|maxwell"),
    "damping": (5, r"damping|damped"),
    "asperities": (1, r"asperit|stribeck|zhou|clarke"),
    "traction": (1, r"traction|eyring"),
    "differential slip": (5, r"differential_slip|heathcote|sliding"),
    "spin, slip in slices": (2, r"spin|slices"),
    "rolling": (1, r"rolling_resistance|rolling_friction|biboulet|houpert|inlet_of_rolling"),
    "drag": (0, r"drag"),
    "oil": (7, r"lubricant|viscosity|walther|vogel|barus"),
    "kinematics": (7, r"kinematics|entrainment|frequencies|orbit"),
    "plates": (4, r"permittivity|plates|contact_capacitance|rough_film"),
    "surroundings": (7, r"surroundings|capacitance_outside|gap_integral|groove_width"),
    "impedance": (0, r"impedance"),
    "breakdown": (1, r"breakdown|discharge|threshold"),
    "network": (3, r"network|dense|nodal"),
    "waveforms": (0, r"waveform|triangle"),
    "groove and rail": (11, r"groove|rail|shoulder|gothic"),
    "rings and shafts": (9, r"ring_body|shaft|beam|gyroscop"),
    "cage ring": (1, r"cage_ring|pocket|land"),
    "heat": (2, r"heat_network|steady_heat|heat_scene|flash|conductance|cooling"),
    "life": (4, r"life|rating|weibull"),
}
# "printed" is a printed value, not what a command has printed
REFERENCE = re.compile(
    r"mpmath|\bmpf?\(|\bmp\.|workdps|quad\(|solve_ivp|odeint|expm\(|ngspice|fsolve|brentq"
    r"|root_scalar|linalg\.(solve|eig)|leggauss|sawtooth|np\.cosh\("
    r"|references|[Pp]rinted(?![(.]| = [cjr])|[Pp]ublished|by hand|handbook|data sheet|Harris"
    r"|Johnson|ISO \d"
)


def _of_module(tree, source):
    """Return ({name: (its text, names that it uses)}, nodes of the tests) for a module."""
    known, tests, imported, lines = {}, [], {}, source.splitlines()
    for node in tree.body:
        names = [getattr(node, "name", None)]
        if isinstance(node, ast.Assign):
            targets = [one for target in node.targets for one in ast.walk(target)]
            names = [one.id for one in targets if isinstance(one, ast.Name)]
        elif isinstance(node, (ast.Import, ast.ImportFrom)):
            module = getattr(node, "module", "") or ""
            for alias in node.names:
                imported[alias.asname or alias.name] = f"{module} {alias.name}"
            continue
        text = "\n".join(lines[node.lineno - 1 : node.end_lineno])
        used = {one.id for one in ast.walk(node) if isinstance(one, ast.Name)}
        used |= {one.arg for one in ast.walk(node) if isinstance(one, ast.arg)}
        for name in filter(None, names):
            known[name] = (text, used)
        if isinstance(node, ast.FunctionDef) and node.name.startswith("test_"):
            tests.append(node.name)
    for name, where in imported.items():
        known.setdefault(name, (where, set()))
    return known, tests


def _all_of(name, known):
    """Return the text of `name` and of everything in the same file that it uses."""
    seen, left, text = set(), [name], ""
    while left:
        one = left.pop()
        if one in seen or one not in known:
            continue
        seen.add(one)
        own, used = known[one]
        text += own + "\n"
        left += used
    return text


def found(root: Path) -> dict[str, list[str]]:
    """Return a dict that maps each law to its tests with a reference in `root`, as `file::test`."""
    result = {law: [] for law in LAWS}
    for folder in FOLDERS:
        for path in sorted((root / "tests" / folder).glob("test_*.py")):
            source = path.read_text()
            known, tests = _of_module(ast.parse(source), source)
            for test in tests:
                if not REFERENCE.search(_all_of(test, known)):
                    continue
                words = f"{path.stem} {known[test][0]}".lower()
                for law, (_, marks) in LAWS.items():
                    if re.search(marks, words):
                        result[law].append(f"{folder}/{path.name}::{test}")
    return result


def main():
    trees = [Path(word) for word in sys.argv[1:] if word != "--list"] or [ROOT]
    counts = [found(tree) for tree in trees]
    for law, (before, _) in LAWS.items():
        print(f"{law:28}{before:5}", *(f"{len(one[law]):5}" for one in counts))
        if "--list" in sys.argv:
            print(*(f"    {test}" for test in counts[-1][law]), sep="\n")


if __name__ == "__main__":
    main()
