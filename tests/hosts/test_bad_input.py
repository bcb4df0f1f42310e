# SPDX-License-Identifier: GPL-2.0-or-later
"""Invalid input stops the run before the first step, with an error that names the command, the
value and the allowed range."""

import re

import pytest
from host import BOX, deck_file, liggghts, refused, run

# {mistake: (variables of in.6208, regular expression that matches the error)}
MAIN_DECK = {
    "conformal groove": (
        {"inner_groove": 6.2e-3},
        r"create_bearing b: groove radius 0.0062 m must be larger than the ball radius 0.0063",
    ),
    "too many balls": (
        {"balls": 16},
        (
            r"create_bearing b: overlapping balls: 16 balls of diameter 0.0126 m .* are 0.0118\d* m"
            r" apart"
        ),
    ),
    "oil that is too cold": (
        {"lubricant": "vg68", "temperature": -40},
        r"vg68' at -40 C: viscosity \(Pa s\) is 140\.\d+, must be from 1e-05 to 100",
    ),
    "no room": (
        {"clearance": -1e-3},
        r"create_bearing b: clearance -0.001 m .* leaves no room .* may not be below",
    ),
    "rings at odds": (
        {"outer_radius": 20e-3, "clearance": 0},
        (
            r"create_bearing b: two rings at odds: inner raceway radius 0.024 m is not smaller than"
            r" the outer one, 0.02 m"
        ),
    ),
    "step too large": (
        {"step": 1e-4, "integrator": "verlet"},
        r"step 0.0001 s exceeds what the contact spring at 1 um overlap allows, 1.8\d*e-05 s",
    ),
    "unknown bearing": (
        {"bearing": "9999"},
        (
            r"bearing: there is no '9999' in folder inputs/bearings; there is: 6009, 6209,"
            r" 6309, 6000, 6001, 6002, \d+ in all"
        ),
    ),
    "unknown models": (
        {"models": "papers"},
        r"pair_style bearing: there is no model 'papers'; "
        r"there is: paper, film, full, eyring, none, or a file",
    ),
    "unknown lubricant": (
        {"lubricant": "honey"},
        (
            r"pair_style bearing: there is no 'honey' in folder inputs/lubricants; there is: dry,"
            r" mineral, pao48, pao8, vg100, vg32, vg46, vg68, grease110"
        ),
    ),
    "contact angle without usual data": (
        {"contact_angle": 20},
        r"bearing: contact_angle is 20, must be 0 \(other angles need a bearing with usual data",
    ),
    "too many balls for usual data": (
        {"bearing": "6210", "balls": 20},
        r"bearing: 20 balls of 0.0127 m overlap on a pitch circle of",
    ),
    "oil at another temperature": (
        {"temperature": 70},
        r"pair_style bearing: .* has values for 40 C only, not for 70 C: use a lubricant with",
    ),
    "cage ball too large": (
        {"cage_ball_diameter": 9e-3},
        (
            r"create_bearing b: cage ball of diameter 0.009 m is too large for the gap between two"
            r" balls; the largest diameter that fits is 0.0084\d* m"
        ),
    ),
    "output not writable": (
        {"out": "/proc/nowhere/run"},
        r"bearing_resume: cannot make output folder '/proc/nowhere/run'",
    ),
}

STYLE = "pair_style bearing/hertz\n"
INNER = "pair_coeff 1 3 inner 24.0e-3 6.552e-3\n"
OUTER = "pair_coeff 1 4 outer 36.6e-3 6.552e-3\n"
CREATE = "create_bearing 1 none 3 4 balls 9 diameter 12.6e-3\n"
GROUPS = "group balls type 1\ngroup inner type 3\nfix move balls nve/sphere\n"
DRY = BOX + STYLE + INNER + OUTER + CREATE + GROUPS
FILM = "lubricant 0.04 2e-8 roughness 1e-7 0"
ARCH = " gothic_arch 1.0e-4\n"
WET = DRY.replace(STYLE, f"pair_style bearing/ehd {FILM}\n")
FOUR_POINT = (
    BOX
    + f"pair_style bearing/ehd {FILM}\n"
    + INNER.strip()
    + ARCH
    + OUTER.replace("36.6", "36.65").strip()
    + ARCH
    + CREATE
    + GROUPS
)

# {mistake: (deck, regular expression that matches the error)}
DECKS = {
    "unknown style keyword": (
        BOX + "pair_style bearing/hertz viscosity 0.04\n",
        r"pair_style bearing/hertz: unknown keyword .*'viscosity'; known: axis",
    ),
    "too few numbers": (
        BOX + STYLE + "pair_coeff 1 3 inner 24.0e-3\n",
        r"pair_coeff 1 3 inner: too few arguments: groove radius \(m\) is missing",
    ),
    "film without roughness": (
        BOX + "pair_style bearing/ehd lubricant 0.04 2e-8\n" + INNER,
        r"bearing/ehd needs 'roughness RACEWAY BALL'",
    ),
    "unknown role": (
        BOX + STYLE + "pair_coeff 1 3 middle 24.0e-3 6.552e-3\n",
        r"role is 'middle', must be one of: inner, outer, sphere",
    ),
    "film without oil": (
        BOX + "pair_style bearing/ehd\n" + INNER,
        r"bearing/ehd needs 'lubricant VISCOSITY PRESSURE_VISCOSITY'",
    ),
    "missing ring in create": (
        BOX + STYLE + INNER + CREATE,
        r"create_bearing: missing ring: no pair_coeff 1 4 outer",
    ),
    "no ring atom": (
        BOX
        + STYLE
        + INNER
        + OUTER
        + "create_atoms 1 single 0.0303 0 0 units box\nset type 1 diameter 12.6e-3\nrun 0\n",
        r"missing ring: pair_coeff 1 3 names ring type 3, but no atom has that type",
    ),
    "ring elsewhere": (
        DRY + "displace_atoms inner move 0.01 0 0 units box\nrun 0\n",
        r"ball \d at .* is not in any groove of an inner ring at step 0",
    ),
    "arch without a width": (
        BOX + STYLE + INNER.strip() + " gothic_arch 0\n",
        r"pair_coeff 1 3 inner: distance of the groove centres from the ring's middle plane"
        r" \(m\) is 0, must be > 0",
    ),
    "arch too wide": (
        BOX + STYLE + INNER.strip() + " gothic_arch 3.0e-4\n" + OUTER + CREATE,
        r"create_bearing: gothic_arch 0.0003 m must be smaller than the groove radius minus the"
        r" ball radius, 0.000252 m",
    ),
    "arch too wide at run": (
        FOUR_POINT + "set type 1 diameter 12.95e-3\nrun 0\n",
        r"pair_coeff 1 3: gothic_arch 0.0001 m must be smaller than .* 7.7e-05 m",
    ),
    "seat on three points": (
        BOX
        + STYLE
        + INNER.strip()
        + ARCH
        + OUTER.replace("36.6", "36.622")
        + CREATE.strip()
        + " seat plus\n",
        r"create_bearing: 'seat': a ball would lie in both grooves of one ring",
    ),
    "two outer rings": (
        DRY + "create_atoms 4 single 1e-6 0 0 units box\nset type 4 diameter 2e-4\nrun 0\n",
        r"sits in the grooves of two outer rings",
    ),
    "overlapping balls": (
        DRY.replace("9 diam", "13 diam")
        + "create_atoms 1 single 0.0303 0.004 0 units box\nset type 1 diameter 12.6e-3\nrun 0\n",
        (
            r"overlapping balls: atoms \d+ and \d+ are 0.00\d* m apart, but the sum of their radii"
            r" is 0.0126 m"
        ),
    ),
    "balls of two sizes": (
        DRY + "set atom 2 diameter 12.5e-3\nrun 0\n",
        r"balls of type 1 have radii from 0.00625 to 0.0063 m; give each size its own type",
    ),
    "conformal groove at run": (
        DRY + "set type 1 diameter 13.2e-3\nrun 0\n",
        r"groove radius 0.006552 m must be larger than the ball radius 0.0066 m",
    ),
    "other units": (
        DRY.replace("units si", "units cgs") + "run 0\n",
        r"needs 'units si', not 'units cgs'",
    ),
    "newton on": (DRY.replace("newton off", "newton on") + "run 0\n", r"needs 'newton off'"),
    "periodic box": (
        DRY.replace("boundary f f f", "boundary p p p") + "run 0\n",
        r"needs 'boundary f f f'",
    ),
    "step of 1 s": (
        DRY + "timestep 1.0\nrun 1\n",
        r"timestep 1 s: the contact spring at 1 um overlap allows at most",
    ),
    "ring fix before pair_coeff": (
        BOX + STYLE + "group inner type 3\nfix r inner bearing/ring\n",
        r"missing ring, group inner is empty",
    ),
    "cage fix before pair_coeff": (
        BOX + STYLE + "fix c all bearing/cage 3\n",
        r"fix c bearing/cage: type 3 is not a ring",
    ),
    "fix before pair style": (
        BOX + "group inner type 3\nfix r inner bearing/ring\n",
        r"fix bearing/ring needs pair_style bearing, bearing/hertz or bearing/ehd before it",
    ),
    "ring fix on balls": (
        DRY + "fix r balls bearing/ring\n",
        (
            r"fix r bearing/ring: atom \d of group balls is of type 1, which no pair_coeff names as"
            r" a ring"
        ),
    ),
    "free ring without mass": (
        DRY + "fix r inner bearing/ring x free\n",
        r"fix r bearing/ring: x free needs 'mass M'",
    ),
    "impossible inertia": (
        DRY + "fix r inner bearing/ring inertia 3e-4 1e-4\n",
        r"no body has more than twice as much about its axis",
    ),
    "no such variable": (
        DRY + "fix r inner bearing/ring spin speed v_none\nrun 0\n",
        r"fix r bearing/ring: there is no equal- or atom-style variable 'none'",
    ),
    "capacitance of a dry contact": (
        DRY + "fix c balls bearing/capacitance 10 permittivity 2.2\n",
        r"a dry contact has no capacitance",
    ),
    "permittivity below vacuum": (
        WET + "fix c balls bearing/capacitance 10 permittivity 0.5\n",
        r"relative permittivity at ambient pressure is 0.5, must be from 1 to 10",
    ),
    "film column of a dry contact": (
        DRY + "compute c balls bearing/contact load h_min\n",
        r"attribute 'h_min' needs a lubricant",
    ),
    "unknown column": (
        DRY + "compute c balls bearing/contact load weight\n",
        r"unknown attribute 'weight'; known: all, usual, ball, ring",
    ),
    "capacitance column without its fix": (
        WET + "compute c balls bearing/contact capacitance\nrun 0\n",
        r"compute c bearing/contact: attribute 'capacitance' needs a fix bearing/capacitance",
    ),
    "bearing outside the box": (
        BOX + STYLE + INNER + OUTER + CREATE.replace("\n", " centre 0.03 0 0\n"),
        r"create_bearing: the bearing \(radius 0.0429 m\) does not fit into the box in direction x",
    ),
}


def wrong(outcome, message):
    """Check that the run failed with exactly one readable error and did not make a single step."""
    refused(outcome, message)
    assert not re.search(r"^Loop time", outcome.text, re.MULTILINE)
    assert "Segmentation" not in outcome.text


@pytest.mark.parametrize("name", MAIN_DECK)
def test_main_deck(name, tmp_path):
    variables, message = MAIN_DECK[name]
    outcome = liggghts("inputs/in.6208", **{"out": tmp_path / "run", **variables})
    wrong(outcome, message)
    assert not list(tmp_path.rglob("*.dump")), "an output file was created"


@pytest.mark.parametrize("name", DECKS)
def test_deck(name, tmp_path):
    text, message = DECKS[name]
    deck = deck_file(tmp_path, text)
    wrong(liggghts(deck), message)


# invalid setups that are tested in every host
SETUPS = [
    "newton on",
    "periodic box",
    "other units",
    "overlapping balls",
    "ring elsewhere",
    "unknown style keyword",
]
GHOSTS = {"liggghts": "communicate single", "lammps": "comm_modify", "wheel": "comm_modify"}


@pytest.mark.parametrize("host", ["lammps", "wheel"])
@pytest.mark.parametrize("name", SETUPS)
def test_setup_in_lammps(name, host, tmp_path):
    text, message = DECKS[name]
    deck = deck_file(tmp_path, text)
    wrong(run(deck, host=host), message)


@pytest.mark.parametrize("host", GHOSTS)
def test_ghost_cutoff_too_small(host, tmp_path):
    deck = deck_file(tmp_path, DRY + f"{GHOSTS[host]} cutoff 0.02 vel yes\nrun 0\n")
    wrong(
        run(deck, host=host),
        rf"the ghost cutoff 0.02 m \({GHOSTS[host]} cutoff\) is too small: .* up to 0.043152 m"
        r" away; leave the cutoff out",
    )


PUSH = "fix r inner bearing/ring mass 0.2 x free force {} 0 0\ntimestep {}\nrun 100000\n"
NOTHING = "variable nothing equal 1.0e308*10*step-1.0e308*10*step\n"  # inf - inf


def test_lost_ball_is_named(tmp_path):
    """A run that diverges stops with an error that names the contact, the step and the remedy."""
    refused(
        liggghts(deck_file(tmp_path, DRY + PUSH.format("5.0e7", "1.0e-6"))),
        r"ball \d on (inner|outer) ring 1\d at step \d+: overlap \S+ m, force \S+ N, .* load is"
        r" too high",
    )


def test_step_that_turns_out_too_large_is_refused(tmp_path):
    """A fixed step that exceeds the limit of the springs stops the main deck."""
    outcome = liggghts(
        "inputs/in.6208", models="paper", integrator="verlet", step=3.0e-6, out=tmp_path / "run"
    )
    refused(outcome, r"step 3e-06 s exceeds what .* allows, \S+ s, at step \d+|overlap")


def test_not_a_number_under_an_implicit_step(tmp_path):
    """The step cannot be refined any further, and the run stops with an error that names the fix
    and the step."""
    integrator = "unfix move\nfix i all bearing/implicit\n"
    refused(
        liggghts(
            deck_file(tmp_path, DRY + NOTHING + integrator + PUSH.format("v_nothing", "1.0e-5"))
        ),
        r"fix i bearing/implicit at step \d+: no solution with substeps down to \S+ s; last"
        r" correction",
    )


def test_not_a_number_is_named(tmp_path):
    """A position that is NaN is not mistaken for a gap: the run stops with an error that names the
    contact."""
    deck = deck_file(tmp_path, DRY + NOTHING + PUSH.format("v_nothing", "1.0e-6"))
    refused(liggghts(deck), r"ball \d on inner ring 10 at step 1: overlap -?nan m")
