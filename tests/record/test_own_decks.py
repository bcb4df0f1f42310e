# SPDX-License-Identifier: GPL-2.0-or-later
"""Every command can read records of decks other than the main deck, for any bearing and load."""

import json

import numpy as np
import pytest
import raceway
from host import ROOT, deck_file, succeed
from raceway.cli import main as command

RECORD = "fix rec all bearing/record 200 ${out} overwrite yes\n"
DECKS = {  # {name: (balls, largest rpm, load on the inner ring in N)}
    "in.combined": (None, 1500, 4472),
    "in.unbalance": (9, 3000, 500),  # growing angles have no mean
    "in.ehd": (9, 477.5, 5000),
}


@pytest.fixture(scope="module", params=DECKS)
def own(request, tmp_path_factory):
    """Return the name of a deck in docs/decks, and the folder of its run with a record."""
    folder = tmp_path_factory.mktemp("own")
    text = (ROOT / "docs" / "decks" / request.param).read_text()
    if "bearing/record" not in text:
        text = text.replace("\nrun 40000", f"\n{RECORD}run 80000")
    deck = deck_file(folder, text)
    succeed(deck, out=folder / "run")
    return request.param, folder / "run"


def test_what_was_measured(own):
    name, folder = own
    balls, rpm, load = DECKS[name]
    run = raceway.open(folder)
    settings = run.settings
    assert settings["rpm"] == pytest.approx(rpm, rel=1e-2)
    assert run.contacts.sizes["ball"] == (balls or settings["balls"])
    half = run.rings.isel(time=slice(run.rings.sizes["time"] // 2, None))
    force = np.sqrt(sum(half[axis].mean() ** 2 for axis in ("fx", "fy", "fz")))
    assert float(force) == pytest.approx(load, rel=0.1)
    assert float(run.contacts.Q.max()) > 0 and np.isfinite(run.bearing.h_min).any()


def test_summary(own, capsys):
    assert command(["summary", str(own[1]), "--json"]) == 0
    figures = json.loads(capsys.readouterr().out)
    assert figures["q_max_N"] > 100 and figures["h_min_m"] > 1e-9


@pytest.mark.parametrize(
    "words",
    [
        ["plot", "--out", "OUT.png"],
        ["plot", "--kind", "polar", "--out", "OUT.png"],
        ["animate", "--frames", "3", "--passes", "0.2", "--out", "OUT.gif"],
        ["export", "--format", "vtk", "--out", "OUT"],
    ],
    ids=lambda words: " ".join(words[:3:2]),
)
def test_commands(own, words, tmp_path):
    name, *more = words
    done = [word.replace("OUT", str(tmp_path / "out")) for word in more]
    assert command([name, str(own[1]), *done]) == 0
    made = list(tmp_path.iterdir())
    assert made and all(path.stat().st_size for path in made)


def test_universe(own):
    universe = raceway.open(own[1]).universe()
    assert len(universe.trajectory) > 100
    universe.trajectory[-1]
    assert universe.select_atoms("name ball").n_atoms > 0
