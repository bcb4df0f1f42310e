# SPDX-License-Identifier: GPL-2.0-or-later
"""Hybrid bearings, whose balls are of silicon nitride and whose rings are of steel. Decks and
Python use the same materials, and runs agree with statics and with the balance of heat."""

import numpy as np
import pytest
from host import ROOT, columns, deck_file, run, same_files, succeed
from hosts.test_named_data import told
from raceway import catalogue, heat_scene, inputs, static, steady_heat
from raceway.core import laws
from raceway.errors import InputError
from raceway.runs.tables import RunTables
from raceway.runs.warming import strains
from raceway.theory import electric_point
from raceway.theory.cage_drag import CageRing

MAIN, STEEL = "inputs/in.6208", ROOT / "inputs/bearings/6208"
CERAMIC = {"ball_material": "silicon_nitride"}
PROPERTIES = ("young", "poisson", "density")
ELASTIC = [f"{part}_{name}" for part in ("ball", "ring") for name in PROPERTIES]


@pytest.fixture(scope="module")
def hybrid(tmp_path_factory):
    """Return the path of a file that describes a 6208 with ceramic balls."""
    text = STEEL.read_text() + "variable ball_material index silicon_nitride\n"
    return deck_file(tmp_path_factory.mktemp("data"), text, "hybrid6208")


OWN = {
    "steel": {},
    "ceramic": CERAMIC,
    "own ceramic": {**CERAMIC, "ball_young": "300e9", "ball_density": "3200"},
    "zirconia": {
        "ball_young": "200e9", "ball_poisson": "0.31", "ball_density": "6040",
        "ring_young": "208e9", "ring_poisson": "0.3", "ring_density": "7800",
        "ball_expansion": "10.3e-6", "ball_conductivity": "2", "ball_heat_capacity": "400",
    },
}  # fmt: skip


@pytest.mark.parametrize("name", OWN)
@pytest.mark.parametrize("bearing", ["6208", "7208", "6303"])
def test_materials(tmp_path, bearing, name):
    """Words of a deck and lines of a file give the same materials, in decks and in Python. Lines of
    the file state the balls' data only if it states those of the rings, too."""
    words, names = OWN[name], [*ELASTIC, "inner_mass", "ball_expansion", "ball_conductivity"]
    by_deck = told(tmp_path, names, bearing=bearing, **words)
    known = inputs.values(catalogue.find("bearings", bearing))
    lines = known | words
    if name == "own ceramic":
        rings = {key: by_deck[key] for key in ELASTIC if key.startswith("ring")}
        lines |= rings | {"ball_poisson": by_deck["ball_poisson"]}
    text = "".join(f"variable {key} index {value}\n" for key, value in lines.items())
    own = deck_file(tmp_path, text, "own")
    assert told(tmp_path, names, bearing=own) == by_deck
    body, ball = inputs.bearing(own), inputs.ball_material(own)
    found = {"ball_young": body.young, "ball_poisson": body.poisson, "ball_density": ball.density}
    found |= {"ring_young": body.ring.young, "ring_poisson": body.ring.poisson}
    assert found == {key: float(by_deck[key]) for key in found}
    if float(by_deck["ball_expansion"]):
        assert ball.expansion == float(by_deck["ball_expansion"])
    usual = inputs.bearing(catalogue.find("bearings", bearing))
    assert float(by_deck["ring_young"]) == (208e9 if name == "zirconia" else usual.young)
    assert (name == "steel") == (body == usual)


def test_stated_rings_change_no_bit(tmp_path):
    """The rings of a steel bearing are those of its balls, whether or not this is stated."""
    scene = {"passes": 1, "samples": 50}
    steel = {"ring_young": "210e9", "ring_poisson": 0.3, "ring_density": 7800}
    for name, words in (("usual", {}), ("stated", steel)):
        succeed(MAIN, out=tmp_path / name, dumps="yes", **scene, **words)
    same_files(tmp_path / "usual", tmp_path / "stated", "contacts.dump", "balls.dump", "rings.dat")


def test_run_and_statics(tmp_path, hybrid):
    """Displacement and loads of a run are those of statics. The Hertz stiffness follows from the
    elastic constants of both materials, so that the ring moves less than in a steel bearing."""
    out, load = tmp_path / "run", 5000.0
    text = succeed(MAIN, out=out, models=None, rpm=477.5, **CERAMIC).text
    assert text.count("silicon_nitride, which insulates") == 1
    tables = RunTables(out)
    body = inputs.bearing(hybrid)
    assert tables.geometry == body
    part = [(1 - nu**2) / e for e, nu in ((310e9, 0.24), (210e9, 0.3))]
    assert body.effective_modulus == pytest.approx(2 / sum(part), rel=1e-14)
    density = inputs.ball_density(hybrid)
    mass = tables.record.fixed("ball_mass")[0]
    assert mass == pytest.approx(4 / 3 * np.pi * body.ball_radius**3 * density, rel=1e-6)
    steel, rest = inputs.bearing(STEEL), static.equilibrium(body, load)
    ratio = (body.effective_modulus / steel.effective_modulus) ** (-2 / 3)
    usual = static.equilibrium(steel, load).shift[0]
    assert rest.shift[0] / usual == pytest.approx(ratio, rel=1e-9)
    largest = tables.total_columns["load_inner"].mean()
    phases = np.linspace(-np.pi / 9, np.pi / 9, 40, endpoint=False)
    pass_over = [static.equilibrium(body, load, phase=one).inner.load.max() for one in phases]
    # the film and the speed, which statics without oil leaves out, change loads by some 1e-3
    assert largest == pytest.approx(np.mean(pass_over), rel=5e-3)


@pytest.mark.parametrize("material", ["steel", "silicon_nitride"])
def test_heat(tmp_path, hybrid, material):
    """The temperatures of a run are those of the balance of heat in statics, whose losses differ by
    less than 1 %, i.e. 0.7 K. Its clearance is that of balls which expand as their material
    does."""
    out, bearing = tmp_path / "run", hybrid if material != "steel" else STEEL
    scene = {"rpm": 9549, "load": 1000, "lubricant": "vg46", "heat": "yes", "passes": 1}
    succeed(MAIN, out=out, models="full", settle="auto", ball_material=material, **scene)
    table = columns(out / "heat.txt")
    asked = steady_heat.Case(
        str(bearing), "vg46", load=1000.0, rpm=9549.0, nodes=heat_scene.Nodes(), cage=CageRing()
    )
    found = asked.steady(asked.scene())
    for part in ("inner", "balls", "outer"):
        end = table[f"temperature_{part}"][-1]
        assert end == pytest.approx(found[f"temperature_{part}_C"], abs=0.7), part
    rises = [table[f"temperature_{part}"][-1] - 20 for part in ("inner", "balls", "outer")]
    body, steel = inputs.bearing(bearing), float(laws.steel_of_bearings().expansion)
    own, heat_capacity = (steel, 460) if material == "steel" else (3.3e-6, 700)
    grown = steel * body.outer_radius * rises[2] - steel * body.inner_radius * rises[0]
    grown -= own * 2 * body.ball_radius * rises[1]
    assert table["clearance"][-1] == pytest.approx(2 * grown, rel=1e-6)
    tables = RunTables(out)
    inner, balls, _ = (one[-1] for one in strains(tables))
    assert balls / inner == pytest.approx(own / steel * rises[1] / rises[0], rel=1e-3)
    # the rings of the 6208 have a capacity of 136 J/K together
    stored = 9 * tables.record.fixed("ball_mass")[0] * heat_capacity * rises[1]
    rings = table["stored"][-1] - stored
    assert 136 * rises[2] < rings < 136 * rises[0]


def test_capacitances_need_steel(tmp_path, hybrid):
    with pytest.raises(InputError, match="balls of silicon_nitride insulate"):
        electric_point.solve(str(hybrid), "mineral", load=1000.0, rpm=1000.0)
    failed = run(MAIN, out=tmp_path / "run", ball_material="glass")
    assert "ball_material is 'glass', must be one of steel, silicon_nitride" in failed.error
