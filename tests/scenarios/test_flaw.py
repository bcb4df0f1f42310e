# SPDX-License-Identifier: GPL-2.0-or-later
"""A ball moves over flaws on an outer raceway. Its path agrees with that of a rigid ball, and its
energy is conserved."""

import re

import numpy as np
import pytest
from host import ROOT, deck_file, frames, refuses, succeed

DECK = "tests/scenarios/in.flaw"
RACEWAY, BALL, ORBIT = 36.6e-3, 6.3e-3, 30.3e-3  # m
ROLLING = BALL * (1 + BALL / ORBIT)  # m, effective radius in the rolling direction
BOTTOM = -np.pi / 2
MASS = 7800 * 4 / 3 * np.pi * BALL**3  # kg
EDGE = 5e-6  # m, edge radius; it is small because closed-form solutions assume sharp edges
MOVERS = {"verlet": {}, "implicit": {"mover": "all bearing/implicit tolerance 1.0e-11"}}
# slow motion, damped by the steel: the ball moves as if ball and raceway were rigid
SLOW = dict(speed=0.03, field=200, damping="hysteresis 0.3", azimuth=BOTTOM - 0.03, sink=2.46e-7)
QUICK = {
    "verlet": dict(step=1e-6, steps=40000, every=20),
    "implicit": dict(step=2e-5, steps=2000, every=1),
}


def notch(length, depth, width="full", edge=EDGE, azimuth=BOTTOM):
    return f"notch {azimuth} {length} {width} {depth} {edge}"


def rolled(folder, flaw, by="verlet", **variables):
    """Return the columns of ball.dat: time (s), path of the contact along the raceway, measured
    from the bottom (m), drop (m), radial velocity (m/s), and energies (J)."""
    folder.mkdir(exist_ok=True)
    given = {**MOVERS[by], **variables}
    succeed(DECK, out=folder, flaw=flaw, **given)
    step, x, y, vx, vy, ke, pe, spin = np.loadtxt(folder / "ball.dat", ndmin=2).T
    r = np.hypot(x, y)
    path = RACEWAY * (np.arctan2(y, x) - BOTTOM)
    return dict(
        t=step * float(given.get("step", 1e-7)),
        path=path,
        drop=r - r[np.abs(path) >= 0.9 * np.abs(path).max()].mean(),
        falls=(x * vx + y * vy) / r,
        ke=ke,
        spin=spin,
        energy=ke + pe + spin + given.get("field", 1000.0) * y * MASS,
    )


@pytest.mark.parametrize("mover", MOVERS)
@pytest.mark.parametrize("length", [0.7e-3, 1e-3])
def test_narrow_notch(tmp_path, mover, length):
    """The ball does not reach the bottom of the notch. In the middle it has fallen by w^2/(8 R_x),
    half a length after the fall began; at this point the speed of its centre jumps by v w/R_x."""
    b = rolled(tmp_path, notch(length, 1e-3), mover, **SLOW, **QUICK[mover])
    assert b["drop"].max() == pytest.approx(length**2 / (8 * ROLLING), rel=0.02)
    speed = np.gradient(b["path"], b["t"])
    turn = np.argmax(b["drop"])
    assert abs(b["path"][turn]) < 0.02 * length / 2
    # computed from parabolas that are fitted to both flanks
    half = length / 2
    jump = 0.0
    for side in (-1, 1):
        flank = (side * b["path"] > 0.05 * half) & (side * b["path"] < 0.95 * half)
        path = np.polyfit(b["path"][flank], b["drop"][flank], 2)
        jump -= side * path[1] * speed[turn]
    assert jump == pytest.approx(speed[turn] * length / ROLLING, rel=0.02)


@pytest.mark.parametrize("mover", MOVERS)
def test_bottom(tmp_path, mover):
    """A ball reaches the bottom of a long notch at a distance of sqrt(2 R_x d) from the edge, and
    then rolls along the bottom."""
    length, depth = 1.5e-3, 5e-6
    b = rolled(tmp_path, notch(length, depth), mover, **SLOW, **QUICK[mover])
    flat = np.abs(b["path"]) < 0.3e-3
    assert b["drop"][flat].mean() == pytest.approx(depth, rel=0.02)
    reached = b["path"][np.argmax(b["drop"] > 0.98 * depth)]
    assert reached == pytest.approx(-length / 2 + np.sqrt(2 * ROLLING * depth), abs=0.02 * length)


def test_deeper_than_the_ball_reaches_changes_nothing(tmp_path):
    for name, depth in (("a", 2e-5), ("b", 2e-3)):
        rolled(tmp_path / name, notch(1e-3, depth), steps=20000)
    assert (tmp_path / "a/ball.dat").read_bytes() == (tmp_path / "b/ball.dat").read_bytes()


def test_converges_with_the_step(tmp_path):
    """Until the ball bounces off the far flank, the error of velocity Verlet is of second order."""
    last = []
    for k, step in enumerate((4e-7, 2e-7, 1e-7, 1e-8)):
        b = rolled(
            tmp_path / str(k),
            notch(1e-3, 1e-3, edge=5e-5),
            sink=7.2e-7,
            step=step,
            steps=round(9e-3 / step),
            every=round(9e-3 / step),
        )
        last.append(b["ke"][-1])
    off = np.abs(np.array(last[:-1]) - last[-1])
    assert off[1] < 0.35 * off[0] and off[2] < 0.35 * off[1]


@pytest.mark.parametrize(
    "flaw",
    [
        notch(1e-3, 1e-3, edge=5e-5),
        notch(1e-3, 1e-3, width=1e-4, edge=5e-5),
        "wave 40 2e-7 0.3 wave 9 1e-6 0",
        notch(1e-3, 1e-3, edge=5e-5) + " wave 31 1e-6 0",
    ],
    ids=["notch", "pit", "waves", "both"],
)
@pytest.mark.parametrize("mover", MOVERS)
def test_energy(tmp_path, mover, flaw):
    """Without friction, the energy of a ball that moves over a flaw is constant to within 1e-6 of
    its kinetic energy."""
    steps = {
        "verlet": dict(step=1e-7, steps=90000, every=300),
        "implicit": dict(
            step=1e-6, steps=9000, every=30, mover="all bearing/implicit largest 2.5e-8"
        ),
    }[mover]
    b = rolled(tmp_path, flaw, mover, sink=7.2e-7, azimuth=BOTTOM - 0.04, **steps)
    assert b["path"][0] < -1e-3 and b["path"][-1] > 1e-3
    assert np.abs(b["energy"] - b["energy"][0]).max() < 1e-6 * b["ke"].min()


def test_energy_of_a_ball_that_turns_over_its_own_flaws(tmp_path):
    """The ball has a pit, which is narrower than the contact ellipse and off its middle, a wave and
    a tabulated profile. All of them are off the equator. The spin supplies the energy for the
    motion. Both integrators give the same path."""
    azimuth = np.arange(4000) * 2 * np.pi / 4000
    np.savetxt(tmp_path / "table.txt", np.c_[azimuth, 2e-7 * np.sin(7 * azimuth)])
    steps = {
        "verlet": dict(step=1e-7, steps=60000, every=200),
        "implicit": dict(
            step=1e-6, steps=6000, every=20, mover="all bearing/implicit largest 2.5e-8"
        ),
    }
    drops = []
    for mover, given in steps.items():
        b = rolled(
            tmp_path / mover,
            "none",
            mover,
            flaw_ball="ball pit -1.8 0.02 1e-3 4e-4 1e-3 5e-5 wave 9 2e-7 0.3"
            f" file {tmp_path}/table.txt",
            turning=80,
            tumbling=10,
            speed=0,
            azimuth=BOTTOM,
            sink=7.2e-7,
            **given,
        )
        assert np.ptp(b["spin"]) > 1e-3 * b["spin"][0]
        assert np.abs(b["energy"] - b["energy"][0]).max() < 1e-6 * b["spin"].min()
        drops.append(b["drop"])
    assert np.abs(drops[1] - drops[0]).max() < 1e-3 * np.ptp(drops[0])


@pytest.mark.parametrize("mover", ["moving nve/sphere", "all bearing/implicit"])
def test_orientation_of_a_ball(tmp_path, mover):
    """For a ball with constant spin, the columns of compute bearing/ball agree with the closed-form
    solution."""
    deck, spin, step = tmp_path / "in.turn", np.array([300.0, 0.0, 400.0]), 1e-6
    names = "turn_w turn_x turn_y turn_z"
    deck.write_text(
        (ROOT / DECK)
        .read_text()
        .replace(
            "timestep ${step}",
            f"compute o balls bearing/ball {names}\n"
            "dump o balls custom 1000 ${out}/turn.dump id c_o[1] c_o[2] c_o[3] c_o[4]\n"
            'dump_modify o ${dump_format} "%d %.17g %.17g %.17g %.17g"\ntimestep ${step}',
        )
    )
    out = tmp_path / "out"
    far = "ball pit 0 1.4 1e-4 1e-4 1e-4 1e-5"  # this pit is never in contact
    words = dict(flaw_ball=far, turning=spin[2], tumbling=spin[0], step=step, steps=5000)
    succeed(deck, out=out, mover=mover, azimuth=BOTTOM, speed=0, **words)
    found = frames(out / "turn.dump")
    assert len(found) == 6
    for at, (row,) in found.items():
        half = 0.5 * np.linalg.norm(spin) * step * at
        want = [np.cos(half), *(np.sin(half) * spin / np.linalg.norm(spin))]
        assert list(map(float, row.split()[1:])) == pytest.approx(want, abs=1e-9)


def test_orientation_needs_a_profile_of_balls(tmp_path):
    ask = "compute o balls bearing/ball turn_w\nvariable o equal c_o[1]\ntimestep ${step}"
    deck = deck_file(tmp_path, (ROOT / DECK).read_text().replace("timestep ${step}", ask))
    says = "attribute 'turn_w' needs a fix bearing/profile with a profile of balls"
    refuses(deck, says, out=tmp_path / "out", steps=10)


@pytest.mark.parametrize("latitude, share", [(0.0, 1.0), (0.5, 0.0)])
def test_pit_of_a_ball(tmp_path, latitude, share):
    """A ball that rotates slowly in place drops by w^2/(8 R_x) when the pit passes the contact. If
    the pit misses the contact, the ball does not drop, and vibrates by less than 0.1 um."""
    length = 0.7e-3
    b = rolled(
        tmp_path,
        "none",
        flaw_ball=f"ball pit {BOTTOM - 0.2} {latitude} {length} 4e-3 1e-3 {EDGE}",
        turning=10,
        **{**SLOW, **dict(azimuth=BOTTOM, speed=0)},
        **QUICK["verlet"],
    )
    drop = b["drop"] - b["drop"][0]
    assert drop.max() == pytest.approx(share * length**2 / (8 * ROLLING), rel=0.02, abs=1e-7)


def test_flaw_turns_with_its_ring(tmp_path):
    """A frictionless ball rests at the bottom while a flaw on the ring passes it at 10 rad/s."""
    b = rolled(
        tmp_path,
        notch(1e-3, 1e-3, azimuth=BOTTOM - 0.03),
        speed=0,
        azimuth=BOTTOM,
        sink=7.2e-7,
        spin=10,
        damping="hysteresis 0.3",
        step=1e-6,
        steps=4000,
        every=10,
    )
    assert b["t"][np.argmax(b["drop"])] == pytest.approx(3e-3, rel=0.02)


def test_table(tmp_path):
    """Tables of measured points describe a wave and a slot that the ball bridges."""
    azimuth = np.arange(20000) * 2 * np.pi / 20000
    tables = {
        "wave": 1e-7 * np.cos(31 * azimuth),
        "slot": np.where(np.abs(azimuth - BOTTOM - 2 * np.pi) * RACEWAY < 0.5e-3, 1e-3, 0.0),
    }
    for name, depth in tables.items():
        np.savetxt(tmp_path / f"{name}.txt", np.c_[azimuth, depth], header="rad m")
    found = {
        name: rolled(tmp_path / name, flaw, steps=40000, step=1e-6, **SLOW, every=50)
        for name, flaw in {
            "file": f"file {tmp_path}/wave.txt",
            "wave": "wave 31 1e-7 0",
            "slot": f"file {tmp_path}/slot.txt",
        }.items()
    }
    wave, table = found["wave"]["drop"], found["file"]["drop"]
    assert np.abs(wave - table).max() < 1e-3 * np.abs(wave).max()
    # the ball rests on the last points on both sides of the slot
    length = RACEWAY * (1 + np.sum(tables["slot"] > 0)) * azimuth[1]
    assert found["slot"]["drop"].max() == pytest.approx(length**2 / (8 * ROLLING), rel=0.02)


def test_table_of_a_ball(tmp_path):
    """A table of points describes a wave on a ball that rotates in place."""
    azimuth = np.arange(4000) * 2 * np.pi / 4000
    np.savetxt(tmp_path / "wave.txt", np.c_[azimuth, 3e-7 * np.cos(12 * azimuth)])
    wave, table = (
        rolled(
            tmp_path / name,
            "none",
            flaw_ball=f"ball {words}",
            turning=20,
            **{**SLOW, **dict(azimuth=BOTTOM, speed=0)},
            **QUICK["verlet"],
        )["drop"]
        for name, words in (("wave", "wave 12 3e-7 0"), ("file", f"file {tmp_path}/wave.txt"))
    )
    assert np.ptp(wave) > 6e-7  # twice the amplitude
    assert np.abs(wave - table).max() < 3e-3 * np.ptp(wave)


@pytest.mark.parametrize(
    "words, says",
    [
        ("notch 0 1e-3 full 1e-4", "edge of the notch"),
        ("notch 0 1e-3 full 1e-4 1", "must be"),
        ("notch 9 1e-3 full 1e-4 1e-5", "azimuth of the notch (rad) is 9"),
        ("notch 0 0.2 full 1e-4 1e-5", "below half the raceway's circumference"),
        ("notch 0 1e-3 full 1e-9 1e-5", "edge of the notch (m) is 1e-05, must be below 3.9"),
        ("notch 0 1e-3 1e-4 1e-4 1e-5 notch 0.02 1e-3 1e-4 1e-4 1e-5", "overlap on ring"),
        ("wave 0 1e-6 0", "order of the wave"),
        ("wave 500 1e-5 0", "amplitude of the wave (m) of order 500 is 1e-05, must be below"),
        ("file nowhere.txt", "cannot read 'nowhere.txt'"),
        ("file {out}/uneven.txt", "point 2 is at 0.1 rad, must be at 0.785398"),
        ("file {out}/words.txt", "line 2: 'b' is not an azimuth"),
        ("groove 1 wave 9 1e-6 0", "has no groove 1"),
        ("none wave 9 1e-6 0", "'none' stands alone"),
        ("pit 0", "known: groove, notch, wave, file, none, or 'ball' first"),
        ("groove 0", "needs 'notch', 'wave', 'file' or 'none'"),
    ],
)
def test_mistakes_are_named(tmp_path, words, says):
    np.savetxt(tmp_path / "uneven.txt", np.c_[np.arange(8) * 0.1, np.zeros(8)])
    (tmp_path / "words.txt").write_text("0 0\nb 0\n")
    flaw = words.format(out=tmp_path)
    refuses(DECK, "fix flaw bearing/profile", says, out=tmp_path / "out", flaw=flaw, steps=10)


@pytest.mark.parametrize(
    "words, says",
    [
        ("notch 0 1e-3 full 1e-4 1e-5", "known: pit, wave, file, none"),
        ("pit 0 2 1e-3 1e-3 1e-4 1e-5", "latitude of the pit (rad) is 2"),
        ("pit 0 0 1e-2 1e-3 1e-4 1e-5", "length of the pit (m) is 0.01 on the equator"),
        ("pit 0 0 1e-3 1e-3 1e-4 1e-3", "edge of the pit (m) is 0.001, must be below 0.0005"),
        ("pit 0 0 1e-3 1e-3 1e-4 1e-5 pit 0.1 0 1e-3 1e-3 1e-4 1e-5", "overlap in azimuth"),
        ("wave 500 1e-5 0", "amplitude of the wave (m) of order 500 is 1e-05, must be below"),
        ("none wave 9 1e-6 0", "'none' stands alone"),
        ("file nowhere.txt", "cannot read 'nowhere.txt'"),
        ("", "needs 'pit', 'wave', 'file' or 'none'"),
    ],
)
def test_mistakes_of_balls_are_named(tmp_path, words, says):
    flaws = {"flaw": "none", "flaw_ball": f"ball {words}"}
    refuses(DECK, "fix flaw_ball bearing/profile", says, out=tmp_path, steps=10, **flaws)


def test_one_pit_a_contact(tmp_path):
    flaw, pit = notch(1e-3, 1e-3, width=1e-4), "ball pit 0 0 1e-3 1e-3 1e-4 1e-5"
    says = "give the notch the width 'full'"
    refuses(DECK, says, out=tmp_path, flaw=flaw, flaw_ball=pit, steps=10)


def test_balls_only(tmp_path):
    deck = deck_file(
        tmp_path, (ROOT / DECK).read_text().replace("fix flaw_ball balls", "fix flaw_ball outer")
    )
    flaws = {"flaw": "none", "flaw_ball": "ball wave 2 1e-7 0"}
    says = "which no pair_coeff puts on a raceway as a ball"
    refuses(deck, says, out=tmp_path / "out", steps=10, **flaws)


def test_rings_only(tmp_path):
    says = "which no pair_coeff names as a ring"
    refuses(DECK, says, out=tmp_path, flaw="wave 9 1e-6 0", group="balls", steps=10)


def test_angle_must_be_counted(tmp_path):
    text = re.sub("fix outer outer.*", "set atom 2 omegaz 1.0", (ROOT / DECK).read_text())
    says = "spins without a fix bearing/ring"
    words = {"out": tmp_path / "out", "flaw": "wave 9 1e-6 0", "steps": 10}
    refuses(deck_file(tmp_path, text), says, **words)
