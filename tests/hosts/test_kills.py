# SPDX-License-Identifier: GPL-2.0-or-later
"""The results of a run that is stopped or killed at a random moment and then resumed are bitwise
identical to those of an uninterrupted run. `kills.py` repeats this test fifty times."""

import random
import signal

import pytest
from hosts.kills import SCENES, disturb, run


@pytest.fixture(
    scope="module", params=SCENES, ids=lambda scene: scene.get("models", scene["integrator"])
)
def undisturbed(request, tmp_path_factory):
    """Return a scene, the folder of its undisturbed run, and the wall time of this run in s."""
    folder = tmp_path_factory.mktemp("undisturbed") / "run"
    return request.param, folder, run(request.param, folder)


@pytest.mark.parametrize("which", [signal.SIGTERM, signal.SIGKILL], ids=lambda which: which.name)
@pytest.mark.parametrize("ranks", [(1,), (2, 1)], ids=str)
def test_killed_and_resumed(undisturbed, tmp_path, which, ranks):
    scene, reference, length = undisturbed
    story = disturb(
        scene,
        tmp_path / "run",
        which,
        reference,
        length,
        random.Random(f"{which} {ranks} {scene}"),
        ranks=ranks,
    )
    assert story.kills >= 1
    assert story.codes[-1] == 0
    assert story.different == ()
