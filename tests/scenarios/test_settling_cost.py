# SPDX-License-Identifier: GPL-2.0-or-later
"""The number of force evaluations in whole runs, including settling, is compared with that of
commit a7b5052, in which runs settled for one ball pass regardless of the remaining change."""

import pytest
import raceway
from host import succeed
from raceway.sweeps.scene_parts import REFERENCE

MOST = 1.3
HEAD = ("load", "axial", "rpm", "clearance", "lubricant", "temperature", "before")
# scenes that tests/bench/needs.py draws, including those that it rejects, and the evaluations that
# a7b5052 needed with the reference settings of `raceway needs`
SCENES = """
1.1e+03 0 256 -4.9e-06 vg68 37 14100
682 0 1.59e+03 1.9e-05 pao8 42 26461
4.83e+03 0 109 -1.2e-06 pao8 67 33280
348 98.3 1.85e+03 2e-05 vg68 45 33918
1.35e+03 0 578 1.1e-05 pao8 41 39790
368 0 875 8.7e-07 vg46 42 7781
943 0 1.81e+03 1.3e-05 vg32 51 25874
6.26e+03 0 1.81e+03 -1.9e-06 pao8 25 10059
3.03e+03 1.48e+03 262 5.2e-06 vg68 22 92365
367 132 376 7.8e-06 vg32 36 51564
448 0 274 4.9e-06 vg32 84 69276
468 0 189 1.1e-05 vg68 37 60924
2.36e+03 0 4.51e+03 -2.4e-06 vg46 39 9886
1.29e+03 338 691 1.5e-06 vg32 22 27356
627 230 492 1.5e-05 vg32 49 47565
460 0 180 5e-06 vg46 82 73711
6.52e+03 0 515 4.1e-06 vg100 78 21142
6.18e+03 0 3.34e+03 7.2e-06 pao8 41 18053
485 0 2.12e+03 1e-06 vg100 35 7848
1.46e+03 223 139 1.1e-05 vg32 71 283170
933 0 2.04e+03 -3.7e-06 vg68 57 8110
446 0 506 5.7e-07 vg100 35 9557
331 0 514 1.1e-05 vg32 39 32886
2.89e+03 0 184 1.9e-05 vg46 34 56464
4.82e+03 1.69e+03 1.56e+03 1.1e-05 vg68 56 56732
2.65e+03 1.11e+03 5.58e+03 6.8e-06 vg100 44 22124
""".strip().splitlines()
CHANGES = {  # choices of `raceway needs` for some scenes, with few evaluations or with slow modes
    "tolerance 1e-8": ({"tolerance": "1e-8"}, {7: 887, 21: 608, 0: 915}),
    "damping": ({"integrator": "damping", "tolerance": "1e-7"}, {7: 4000, 21: 7284, 0: 15375}),
    "no cage": ({"cage": "no"}, {7: 9892, 21: 8090, 0: 12504}),
    "film": ({"models": "film"}, {3: 29102, 19: 248952}),
    "paper": ({"models": "paper"}, {3: 32588, 7: 5493}),
}


def evaluations(number, folder, **changes):
    """Return (evaluations of the run, evaluations that a7b5052 needed with the reference
    settings)."""
    words = dict(zip(HEAD, SCENES[number].split(), strict=True))
    before = float(words.pop("before"))
    own = {"passes": "1", "settle": "auto", "surroundings": "flooded"}
    scene = {**words, **own, **REFERENCE, **changes}
    succeed("inputs/in.6208", out=folder, **scene)
    cost = raceway.open(folder).settings
    return cost["settling_evaluations"] + cost["evaluations"], before


def test_of_the_reference(tmp_path):
    """Most scenes need a tenth to a half of the evaluations of a7b5052. Slow or lightly loaded
    scenes, which need many evaluations while the loads are applied, need a larger fraction."""
    shares = []
    for number in range(len(SCENES)):
        now, before = evaluations(number, tmp_path / str(number))
        assert now < MOST * before, SCENES[number]
        shares.append(now / before)
    assert sorted(shares)[len(shares) // 2] < 0.3


@pytest.mark.parametrize("name", CHANGES)
def test_of_its_choices(name, tmp_path):
    changes, scenes = CHANGES[name]
    for number, before in scenes.items():
        now, _ = evaluations(number, tmp_path / str(number), **changes)
        assert now < MOST * before, SCENES[number]
