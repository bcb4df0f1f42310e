# SPDX-License-Identifier: GPL-2.0-or-later
"""Tests of runs that once failed silently or with the wrong message. They cover contacts outside
their range of validity, lost balls, steps that make no progress, restart files, and two processes
that write to one folder."""

import os
import re
import shutil
import signal

import pytest
import raceway
from host import HOSTS, ROOT, deck_file, liggghts, refused, run, succeed, wait_for_file
from host import start as start_deck
from hosts.kills import start
from smallest import IMPLICIT, SMALLEST, outcome

EHD = (ROOT / "docs" / "decks" / "in.ehd").read_text()
SHORT = {"passes": 1, "samples": 20, "settle": 0.1}


# ---- atoms, steps, cages -----------------------------------------------------------------------


@pytest.mark.parametrize("ranks", [1, 2])
def test_a_ball_that_leaves_the_box_is_missed(tmp_path, ranks):
    """LIGGGHTS once deleted balls without an error: 1 of 11 atoms was left, all results were 0, and
    the exit code was 0, too."""
    end = outcome(
        tmp_path,
        SMALLEST,
        "thermo_modify lost ignore\nvelocity balls set 0 0 1e5 units box\nrun 500\n",
        ranks=ranks,
    )
    refused(end, r"lost \d of 11 balls, cage balls and rings at step \d+")


def test_a_cage_without_rails(tmp_path):
    """Cage balls once left the box without an error: after 200,000 steps, 14 of 20 atoms were left,
    and the exit code was 0."""
    deck = tmp_path / "in.norails"
    text = EHD.replace("fix rails cage bearing/cage 4\n", "").replace(" v_rails", "")
    text = re.sub(r"variable rails equal .*\n", "", text)
    deck.write_text(
        text.replace("run 40000", "velocity cage set 0 0 1e4 units box\nrun 4000").replace(
            "group moving", "group cage type 2\ngroup moving"
        )
    )
    refused(liggghts(deck, out=tmp_path / "out"), r"lost 9 of 20 balls, cage balls and rings")


@pytest.mark.parametrize("step", ["-1.0e-6", "0", "1.0e-300"])
@pytest.mark.parametrize("deck", [SMALLEST, IMPLICIT], ids=["verlet", "implicit"])
def test_time_goes_on(tmp_path, deck, step):
    refused(
        outcome(tmp_path, deck, f"timestep {step}\nrun 200\n"),
        r"timestep is \S+ s, must be at least 1e-15 s",
    )


def test_a_step_that_vanishes_is_no_limit(tmp_path):
    refused(
        outcome(tmp_path, SMALLEST, "fix grow all bearing/timestep 10 adapt yes max 1e-300\n"),
        r"fix grow bearing/timestep: largest step \(s\) is 1e-300, must be from 1e-12",
    )


@pytest.mark.parametrize(
    "words, message",
    [
        ("largest 1e-300", r"largest step \(s\) is 1e-300, must be from 1e-12"),
        ("tolerance 1e-4", r"tolerance \(m\) is 0.0001, must be from 1e-13 to 1e-05"),
    ],
)
def test_limits_of_an_implicit_step(tmp_path, words, message):
    """With the first setting, a step once never finished; with the second, the load was too large
    by a factor of 2.7."""
    deck = IMPLICIT.replace("bearing/implicit", f"bearing/implicit {words}")
    refused(outcome(tmp_path, deck, "run 1\n", timeout=20), message)


def test_a_cage_without_a_coefficient(tmp_path):
    """There is a warning if cage balls pass through the balls because a coefficient is missing, and
    none if there is a coefficient."""
    for name, text in (("without", EHD.replace("pair_coeff 1 2 sphere", "#")), ("with", EHD)):
        deck = deck_file(tmp_path, text.replace("run 40000", "run 200\nrun 200"), f"in.{name}")
        end = succeed(deck, out=tmp_path / name)
        warned = end.text.count("cage balls pass through the balls: there is no 'pair_coeff 1 2")
        assert warned == (name == "without")


# ---- validity of a contact ---------------------------------------------------------------------


@pytest.mark.parametrize("integrator", ["implicit", "verlet"])
def test_an_ellipse_as_wide_as_the_groove(tmp_path, integrator):
    """At a load of 300 kN, which `raceway static` rejected, a run once continued up to 10 GPa."""
    end = liggghts(
        "inputs/in.6208", out=tmp_path, load=3e5, integrator=integrator, timeout=120, **SHORT
    )
    refused(end, r"contact ellipse (is )?as wide as the groove")


def test_an_almost_conformal_groove(tmp_path):
    """The contact ellipse on a ball of 12.6 mm was once 429 mm long."""
    end = liggghts("inputs/in.6208", out=tmp_path, inner_groove=6.3000001e-3, **SHORT)
    refused(end, r"contact ellipse (is )?as wide as the groove")


def doubts(text):
    return re.findall(r"beyond validity: (.+? of ball \d+) is (?:up|down) to ([^\s;]+)", text)


def test_pressure_beyond_iso_76(tmp_path):
    end = succeed("inputs/in.dry", out=tmp_path, load=6e4, **SHORT)
    (what, value), *more = doubts(end.text)
    assert not more and what.startswith("Hertz pressure") and 4.2e9 < float(value) < 8e9


def test_an_ellipse_past_its_shoulder(tmp_path):
    """If the deck specifies the shoulder diameters, a run prints the same warning as `raceway
    summary`."""
    words = dict(out=tmp_path, load=1.5e5, **SHORT)
    found = dict(doubts(succeed("inputs/in.6208", **words).text))
    (name,) = (one for one in found if one.startswith("reach of a contact ellipse"))
    said = " ".join(raceway.open(tmp_path).summary()["warnings"])
    up, edge = re.search(r"reaches ([0-9.]+)° .*? shoulder is at ([0-9.]+)°", said).groups()
    assert float(found[name]) > 1
    assert float(found[name]) == pytest.approx(float(up) / float(edge), rel=0.05)
    unknown = dict(inner_shoulder_diameter=0, outer_shoulder_diameter=0, overwrite="yes")
    text = succeed("inputs/in.6208", **unknown, **words).text
    assert "reach of a contact ellipse" not in text and "Hertz pressure" in text


@pytest.mark.parametrize("law, warned", [("hamrock", True), ("masjedi", False)])
def test_a_film_outside_its_fit(tmp_path, law, warned):
    """The contact ellipse of a 6208 is about nine times as long as it is wide."""
    deck = deck_file(tmp_path, re.sub("lubricant 0.040", f"film {law} lubricant 0.040", EHD))
    found = dict(doubts(succeed(deck, out=tmp_path).text))
    (value,) = [float(v) for k, v in found.items() if k.startswith("ellipticity")] or [0.0]
    assert 8 < value < 11 if warned else value == 0.0


@pytest.mark.parametrize("ramp", [0, 0.1])
def test_a_ramp_longer_than_the_settling(tmp_path, ramp):
    """The load was once measured while it was still being ramped up."""
    succeed("inputs/in.6208", out=tmp_path, ramp=ramp, **SHORT)
    assert raceway.open(tmp_path).summary()["force_y_N"] == pytest.approx(5000, rel=1e-2)


def test_a_film_thicker_than_its_contact_is_long(tmp_path):
    deck = deck_file(
        tmp_path, EHD.replace("lubricant 0.040", "lubricant 1.0e8").replace("run 40000", "run 0")
    )
    found = dict(doubts(liggghts(deck, out=tmp_path).text))
    assert any(name.startswith("lambda ratio") for name in found)
    assert any(name.startswith("film thickness over the semi-axis b") for name in found)


@pytest.mark.parametrize("capacitance", [True, False])
def test_a_capacitance_of_a_film_that_conducts(tmp_path, capacitance):
    """At 48 rpm, the lambda ratio of 0.3 causes a warning only if capacitances are requested."""
    text = EHD.replace("lubricant 0.040", "lubricant 0.001").replace("run 40000", "run 20000")
    if not capacitance:
        text = re.sub(r"fix cap .*|dump .*&\n.*|dump_modify .*| h_c capacitance| f_cap", "", text)
        assert "bearing/capacitance" not in text
    deck = deck_file(tmp_path, text)
    found = dict(doubts(succeed(deck, out=tmp_path).text))
    names = [name for name in found if name.startswith("lambda ratio beside a capacitance")]
    assert len(names) == capacitance and all(0.0 < float(found[name]) < 1.0 for name in names)


def test_a_usual_run_is_in_no_doubt(tmp_path):
    assert not doubts(succeed("inputs/in.6208", out=tmp_path, **SHORT).text)


# ---- restart files -----------------------------------------------------------------------------


def test_restart_files_of_the_deck_are_its_own(tmp_path):
    """The fix once accepted any restart file, and the run then crashed at the next step."""
    end = outcome(
        tmp_path,
        SMALLEST,
        f"fix ck all bearing/checkpoint 50 {tmp_path}/ck restart 100\nrun 200\n"
        f"write_restart {tmp_path}/mine\nrun 100\n",
    )
    assert end.code == 0, end.text[-2000:]
    assert (tmp_path / "mine").exists() and (tmp_path / "ck").exists()


def test_one_checkpoint_fix(tmp_path):
    refused(
        outcome(
            tmp_path,
            SMALLEST,
            f"fix a all bearing/checkpoint 50 {tmp_path}/a\n"
            f"fix b all bearing/checkpoint 50 {tmp_path}/b\nrun 10\n",
        ),
        r"fix b bearing/checkpoint: fix a already has this style",
    )


READ = """units si
atom_style granular
communicate single vel yes
atom_modify map array
newton off
read_restart {file}
neigh_modify delay 0
group balls type 1
group inner type 2
fix move balls nve/sphere
fix inner inner bearing/ring mass 0.2 x free y free spin speed 50.0 force 0 -5000 0 ramp 3.0e-3
timestep 1.0e-6
fix ck all bearing/checkpoint 50 {file} resume yes
run 100
"""


@pytest.mark.parametrize("sanitized", [False, True])
def test_a_checkpoint_of_nothing_but_the_run(tmp_path, sanitized):
    """If there are no files, nothing is copied from a null pointer."""
    if sanitized and not HOSTS["sanitized"][0].exists():
        pytest.fail("build/sanitized/liggghts is missing: run make sanitized", pytrace=False)
    file = tmp_path / "ck"
    end = outcome(
        tmp_path, SMALLEST, f"fix ck all bearing/checkpoint 50 {file} restart 100\nrun 201\n"
    )
    assert end.code == 0, end.text[-2000:]
    deck = deck_file(tmp_path, READ.format(file=file))
    succeed(deck, sanitized=sanitized)


@pytest.fixture(scope="module")
def stopped(tmp_path_factory):
    """Return the folder of a run that received SIGTERM during its measurement phase; tests work on
    a copy of it."""
    out = tmp_path_factory.mktemp("stopped") / "run"
    process = start({"passes": 40, "samples": 100, "keep": 20}, out)
    wait_for_file(out / "restart")
    process.terminate()
    assert process.wait() == 128 + signal.SIGTERM
    return out


def test_every_flipped_bit_of_a_restart_file_is_noticed(stopped, tmp_path):
    """The host's restart format has no checksum, so 33 of 77 damaged files once went undetected."""
    out = tmp_path / "run"
    shutil.copytree(stopped, out)
    good = (out / "restart").read_bytes()
    case = {"passes": 40, "samples": 100, "keep": 20, "out": out, "resume": "yes"}
    mark = good.index(b"bearing/checkpoint sum")
    for k, place in enumerate([mark, *(len(good) * k // 12 for k in range(1, 12))]):
        bad = bytearray(good)
        bad[place] ^= 1 << (k % 8)
        (out / "restart").write_bytes(bad)
        end = liggghts("inputs/in.6208", **case)
        refused(end, r"is damaged: its checksum is wrong")


# ---- one writer per folder -----------------------------------------------------------------------


@pytest.mark.parametrize("host", ["liggghts", "lammps", "wheel"])
def test_two_runs_in_one_folder(tmp_path, host):
    """The second run reports which process is writing to the folder, and the first run is not
    affected. When the first process is killed, the folder is free again at once."""
    out = tmp_path / "run"
    waits = f"bearing_resume {out}/restart resume no\nshell sleep 60\n"
    first = start_deck(deck_file(tmp_path, waits, "in.waits"), host=host)
    try:
        wait_for_file(out / ".writer")
        for resume in ("no", "yes"):
            refused(
                liggghts("inputs/in.6208", out=out, resume=resume, **SHORT),
                rf"bearing_resume: output folder '{out}' is in use: process \d+ on"
                rf" {os.uname().nodename} writes there",
            )
        assert first.poll() is None
    finally:
        os.killpg(first.pid, signal.SIGKILL)
        first.wait()
    assert (out / ".writer").exists()
    once = deck_file(tmp_path, f"bearing_resume {out}/restart resume no\n" * 2, "in.once")
    assert run(once, host=host).code == 0
    assert not (out / ".writer").exists()
