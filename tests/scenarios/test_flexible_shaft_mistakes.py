# SPDX-License-Identifier: GPL-2.0-or-later
"""fix bearing/shaft flexible: mistakes in its words and in the file of its modes are refused."""

import pytest
from flexible_shaft import modes_file
from host import refuses
from shaft_runs import small_deck

FREE = "y free z free ry free rz free spin speed 100"


@pytest.fixture(scope="module")
def file(tmp_path_factory):
    return modes_file(tmp_path_factory.mktemp("file"))


@pytest.mark.parametrize(
    "text, says",
    [
        ("FILE mass 4", "mass, inertia and centre of a flexible shaft come from"),
        ("FILE centre 0.1", "mass, inertia and centre of a flexible shaft come from"),
        ("FILE ry fixed", "needs both transverse displacements and both tilts 'free'"),
        ("FILE load 0.25 0 1 0", "a load is at 0.25 m, and"),
        ("FILE unbalance 0.05 1e-5 0", "an unbalance is at 0.05 m, and"),
        ("nowhere", "cannot read 'nowhere'"),
        ("FILE\nunfix m\nfix m balls nve/sphere", "a flexible shaft needs fix bearing/implicit"),
        (
            "FILE\nunfix m\nfix m all bearing/implicit solve damping",
            "a flexible shaft needs 'solve all' of fix m",
        ),
    ],
)
def test_mistakes(tmp_path, file, text, says):
    first, *lines = text.replace("FILE", str(file)).splitlines()
    deck = f"fix m all bearing/implicit\nfix s inner bearing/shaft {FREE} flexible {first}\n"
    refuses(small_deck(tmp_path, deck + "\n".join([*lines, "run 0\n"])), says)


@pytest.mark.parametrize(
    "old, new, says",
    [
        ("raceway-shaft 1", "raceway-shaft 2", "must be 'raceway-shaft 1'"),
        ("units m kg s N rad", "units mm kg s N rad", "must be 'units m kg s N rad'"),
        ("units m kg s N rad\n", "", "has no line 'units m kg s N rad'"),
        ("\nmass ", "\nweight ", "unknown word 'weight'; known: units, mass"),
        ("\nmass ", "\nmass -", "'mass' is -"),
        ("\nmodal_mass ", "\nmodal_mass -", "'modal_mass' is -"),
        ("\nmodal_stiffness ", "\nmodal_stiffness 1 ", "'modal_stiffness' has 9 numbers"),
        ("\nmodal_damping 0", "\nmodal_damping -1", "'modal_damping' is -1, must be from 0"),
        ("\nmodes 8", "\nmodes 7", "'modal_mass' has 8 numbers, must have 7"),
        ("\nmodes 8", "\nmodes 8.5", "'modes' is 8.5, must be a whole number"),
        ("\ngyroscopic ", "\n# ", "has 8 lines 'gyroscopic', must have 9"),
        ("\nstation 0 ", "\nstation 0 1 ", "'station' has 18 numbers, must have 17"),
        ("\nstation 0 ", "\nstation 1 ", "must be beyond the one before it"),
        ("\nstation 0 ", "\nstation 0.001 ", "ring atom 10 is at 0 m, and"),
        ("\nstation 0 ", "\nstation nan ", "'nan' is not a finite number"),
    ],
)
def test_bad_files(tmp_path, file, old, new, says):
    content = file.read_text()
    assert old in content
    bad = tmp_path / "bad.modes"
    bad.write_text(content.replace(old, new, 1))
    deck = f"fix m all bearing/implicit\nfix s inner bearing/shaft {FREE} flexible {bad}\nrun 0\n"
    refuses(small_deck(tmp_path, deck), says)


def test_matrix_that_is_not_symmetric(tmp_path, file):
    lines = file.read_text().splitlines()
    first = next(k for k, line in enumerate(lines) if line.startswith("gyroscopic"))
    word, one, two, *others = lines[first].split()
    lines[first] = " ".join([word, one, repr(1.001 * float(two)), *others])
    bad = tmp_path / "bad.modes"
    bad.write_text("\n".join(lines))
    deck = f"fix s inner bearing/shaft {FREE} flexible {bad}\n"
    refuses(small_deck(tmp_path, deck), "'gyroscopic' is not symmetric")
