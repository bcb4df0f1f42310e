# SPDX-License-Identifier: GPL-2.0-or-later
"""If the deck does not define a variable given with -var, the run stops at the command
`bearing`."""

import json
import re
import shutil
import subprocess
import sys

import numpy as np
import pytest
import raceway
import xarray
from commands import reply
from host import ENVIRONMENT, QUICK, ROOT, deck_file, refuses, succeed
from raceway import core, inputs
from raceway.sweeps import variable_table

SHORT = {"passes": 1, "samples": 20, "rpm": 20000}
HOSTS = ["liggghts", "lammps", "wheel"]


@pytest.mark.parametrize("host", HOSTS)
@pytest.mark.parametrize("ranks", [1, 2])
@pytest.mark.parametrize(
    "name, nearest",
    [("lod", "load"), ("Rpm", "rpm"), ("tolerence", "tolerance"), ("cage_paly", "cage_play")],
)
def test_unknown(tmp_path, host, ranks, name, nearest):
    says = f"bearing: -var {name}: the deck has no such variable, nearest is '{nearest}'"
    words = {"out": tmp_path / "run", name: 1}
    refuses("inputs/in.6208", says, host=host, ranks=ranks, **words)
    assert not (tmp_path / "run").exists()


DECKS = [
    "in.axial",
    "in.cage_ring",
    "in.dry",
    "in.many",
    "in.nocage",
    "in.preload",
    "paper/in.printed",
]


@pytest.mark.parametrize("deck", DECKS)
def test_unknown_in_every_deck(tmp_path, deck):
    says = "-var clearence: the deck has no such variable, nearest is 'clearance'"
    refuses(f"inputs/{deck}", says, out=tmp_path / "run", clearence=1e-5)


@pytest.mark.parametrize("host", HOSTS)
@pytest.mark.parametrize("ranks", [1, 2])
def test_given(tmp_path, host, ranks):
    """Variables at the head of the deck, of `vars`, and of a bearing or an oil are accepted. A run
    records exactly those bearing and lubricant data that were given with -var."""
    own = dict(ball_poisson=0.29, inner_mass=2, viscosity=0.05, load=3000, tolerance=1e-9)
    succeed("inputs/in.6208", host=host, ranks=ranks, out=tmp_path, **own, **SHORT)
    said = raceway.open(tmp_path).settings["given_data"]
    assert sorted(said.split(",")) == ["ball_poisson=0.29", "inner_mass=2", "viscosity=0.05"]
    succeed("inputs/in.6208", host=host, out=tmp_path, overwrite="yes", **SHORT)
    assert raceway.open(tmp_path).settings["given_data"] == "none"


def test_models(tmp_path):
    """`models` selects a named set of keywords for the pair style, and both the record and the
    summary contain this name."""

    def commands():
        return raceway.open(tmp_path).tables.record.attrs["pair_commands"]

    succeed("inputs/in.6208", out=tmp_path, models="paper", overwrite="yes", **SHORT)
    ran = raceway.open(tmp_path)
    assert ran.settings["models"] == ran.summary()["models"] == "paper"
    assert "friction stribeck 0.12 0.05" in commands() and "gap" not in commands()
    succeed(
        "inputs/in.6208", out=tmp_path, models="full", lubricant="vg46", overwrite="yes", **SHORT
    )
    assert "gap 1 gap_film power film_damping branch inlet_shear murch" in commands()
    assert raceway.open(tmp_path).settings["models"] == "full"
    succeed("inputs/in.dry", out=tmp_path, models="full", overwrite="yes", **SHORT)
    assert "friction constant 0.1" in commands() and "gap" not in commands()
    slices = dict(models="full", spin_law="slices", without="spin")
    succeed("inputs/in.dry", out=tmp_path, overwrite="yes", **slices, **SHORT)
    assert "slices 1.0e-4 0" in commands() and "heathcote" not in commands()
    assert "spin_law=slices" in raceway.open(tmp_path).settings["deck_variables"]


def test_models_of_an_oil_without_the_numbers(tmp_path):
    """A user's lubricant file may be limited to the data required by the models of the paper."""
    own = tmp_path / "inputs"
    shutil.copytree(ROOT / "inputs", own)
    (own / "lubricants" / "mine").write_text(
        "variable film index film\nvariable viscosity index 0.04\n"
        "variable pressure_viscosity index 22e-9\nvariable permittivity index 2.2\n"
        "variable roughness index 1e-7\nvariable ball_roughness index 0\n"
    )
    case = {"inputs": own, "lubricant": "mine", "out": tmp_path / "run", "overwrite": "yes"} | SHORT
    succeed("inputs/in.6208", **case)
    says = "oil mine: the lubricant has no variable temperature_viscosity, oil_density"
    refuses("inputs/in.6208", says, models="full", **case)


OIL = {"kinematic_viscosity_40": 46, "kinematic_viscosity_100": 6.8, "oil_density_40": 865}


@pytest.mark.parametrize("models", ["paper", "full", "eyring", "none"])
def test_an_oil_of_three_numbers(tmp_path, models, capsys):
    """Viscosities and density from a data sheet are sufficient. Runs and statics use the same
    defaults for properties that were not measured. A file that states these defaults explicitly
    gives the same run. Summaries list the properties that were assumed."""
    short, whole = tmp_path / "short", tmp_path / "whole"
    lines = "".join(f"variable {name} index {value}\n" for name, value in OIL.items())
    short.write_text(lines)
    defaults = {name: row["default"] for name, row in variable_table.oil().items()}
    others = {"pressure_viscosity", "permittivity"}  # used only for oils at one temperature
    stated = {name: value for name, value in defaults.items() if name not in others}
    whole.write_text(lines + "".join(f"variable {n} index {v}\n" for n, v in stated.items()))
    records = []
    for oil in (short, whole):
        words = dict(models=models, lubricant=oil, temperature=60, **SHORT)
        succeed("inputs/in.6208", out=tmp_path / "run", overwrite="yes", **words)
        with xarray.open_dataset(tmp_path / "run/record.nc") as data:
            records.append(data.load())
        assumed = inputs.assumed(oil, models)
        noted = records[-1].attrs.get("assumed_data", "")
        assert noted == ",".join(f"{name}={defaults[name]}" for name in assumed)
        figures = json.loads(reply(capsys, ["summary", str(tmp_path / "run"), "--json"]))
        assert figures.get("assumed_data", {}) == assumed
        assert (figures["statics_absent"] is None) == (models != "none")
        said = reply(capsys, ["summary", str(tmp_path / "run")])
        assert all(f"  {name} {value:g}" in said for name, value in assumed.items())
    for name, values in records[0].data_vars.items():
        np.testing.assert_array_equal(values, records[1][name], err_msg=name)
    assert ("eyring_stress" in inputs.assumed(short, models)) == (models == "eyring")
    assert not inputs.assumed(whole)


def test_other_spelling_of_the_option(tmp_path):
    refuses("inputs/in.6208", "-var lod", extra=["-v", "lod", "1"], out=tmp_path / "run")


def test_deck_that_includes_the_deck(tmp_path):
    """Variables of the including deck are recognised, and variables that the including deck sets
    itself need not be given."""
    deck = deck_file(
        tmp_path,
        "variable mine index 1\nvariable fixed string 2\nvariable more equal 3\n"
        "include inputs/in.6208\n",
    )
    succeed(deck, out=tmp_path / "run", mine=5, **QUICK, **SHORT)
    refuses(deck, "-var mina", out=tmp_path / "run", mina=5, **SHORT)


def test_option_of_another_program(tmp_path):
    """The -v in `python -v` is not mistaken for a deck variable."""
    script = tmp_path / "script.py"
    script.write_text(
        "import ctypes, sys\n"
        "host = ctypes.CDLL(sys.argv[1], mode=ctypes.RTLD_GLOBAL)\n"
        "words = [b'liggghts', b'-log', b'none', b'-var', b'out', sys.argv[2].encode()]\n"
        "lmp = ctypes.c_void_p()\n"
        "argv = (ctypes.c_char_p * len(words))(*words)\n"
        "host.lammps_open_no_mpi(len(words), argv, ctypes.byref(lmp))\n"
        "host.lammps_file(lmp, sys.argv[3].encode())\n"
    )
    deck = deck_file(tmp_path, "variable out index x\nbearing b 6208 types 1 2 3 4\nprint done\n")
    done = subprocess.run(
        [
            sys.executable,
            *("-v", script, ROOT / "build" / "libraceway_liggghts.so", tmp_path, deck),
        ],
        cwd=ROOT,
        env=ENVIRONMENT,
        text=True,
        capture_output=True,
        check=False,
    )
    assert done.returncode == 0 and "done" in done.stdout, done.stdout[-1000:]


def test_page_of_the_main_deck_has_every_variable():
    """Each variable is in the generated table for a deck or for a command. Bearing and oil data,
    which variables can override, are described on the page of the catalogue."""
    page = (ROOT / "docs" / "main_deck.rst").read_text()
    generated = re.findall(r"deck-variables:: (\S+)", page)
    deck = (ROOT / "inputs" / "in.6208").read_text()
    missing = [
        one["name"]
        for one in core.table("variables")
        if not (one["of"].endswith(" data") or one["of"].startswith("oil "))
        and one["of"] not in generated
        and not re.search(rf"\b{one['name']}\b", deck)
    ]
    assert "in.6208" in generated and missing == []
