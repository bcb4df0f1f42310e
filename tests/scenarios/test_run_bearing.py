# SPDX-License-Identifier: GPL-2.0-or-later
"""The results of run_bearing are bitwise identical to those obtained with the host's commands,
wherever the run is stopped and on any number of ranks."""

import math
import re
import signal
import subprocess
import time

import numpy as np
import pytest
from host import liggghts, refused, start, succeed
from recorded_runs import bytes_of, differ
from scipy.io import netcdf_file

DECK = "tests/scenarios/in.run"
BALLS, BALL, INNER, OUTER, GROOVE = 9, 12.6e-3, 24.0e-3, 36.6e-3, 6.552e-3
IMPLICIT = {"move": "bearing/implicit tolerance 1.0e-9 relative 2e-4"}
DAMPING = {"move": "bearing/implicit solve damping tolerance 1.0e-7"}
VERLET = {"move": "nve/sphere", "movers": "parts", "rpm": 20000, "more": "step 3.0e-6"}


def ball_pass(rpm=1500.0, outer_rpm=0.0, angle=0.0, clearance=0.0):
    """Return the duration (s) of a ball pass if the balls roll without slip (Harris). Their centres
    then move at the mean speed of the two surfaces."""
    pitch = INNER + OUTER + 0.5 * clearance
    share = BALL * math.cos(angle) / pitch
    cage = 0.5 * (rpm * (1 - share) + outer_rpm * (1 + share)) * 2 * math.pi / 60
    return 2 * math.pi / (BALLS * cage)


def numbers(folder):
    """Return all numeric attributes of a record."""
    with netcdf_file(folder / "record.nc", mmap=False) as file:
        return {k: v for k, v in file._attributes.items() if not isinstance(v, bytes)}


def written(value):
    return float(f"{value:.15g}")


@pytest.mark.parametrize(
    "scene, within",
    [(IMPLICIT, 10), (DAMPING, 10), ({**IMPLICIT, "more": "step 2.0e-5"}, 1)],
    ids=["implicit", "damping", "step"],
)
def test_same_bits_as_commands_of_the_host(scene, within, tmp_path):
    """`settle N` is equivalent to a run over the load ramp and N ball passes, followed by a second
    run for the measurement."""
    settle, passes, samples = 2, 1, 200
    once = written(ball_pass())
    largest = written(once / samples * within)
    every = 1 if within > 1 else math.ceil(largest / 2.0e-5)
    dt = written(largest / every)
    succeed(DECK, out=tmp_path / "run", settle=settle, passes=passes, **scene)
    succeed(
        DECK,
        out=tmp_path / "plain",
        end="run.plain",
        move=scene["move"],
        dt=f"{dt:.15g}",
        settle_steps=math.ceil(written(settle * once + 1e-2) / dt),
        steps=passes * samples * every // within,
        every=every,
        within=within,
    )
    assert differ(tmp_path / "run", tmp_path / "plain") == []


@pytest.mark.parametrize(
    "scene, closed",
    [
        ({"rpm": 900}, {"rpm": 900}),
        ({"rpm": 600, "outer_rpm": -1500, "load": 500}, {"rpm": -600, "outer_rpm": 1500}),
        (
            {"clearance": 1.5e-4, "seat": "plus", "axial": 2000, "load": 100},
            {"clearance": 1.5e-4, "angle": math.acos(1 - 0.75e-4 / (2 * GROOVE - BALL))},
        ),
        ({"more": "angle 25"}, {"angle": math.radians(25)}),
    ],
    ids=["inner", "both rings", "seated", "angle given"],
)
def test_ball_pass(scene, closed, tmp_path):
    """For each integrator and several ring speeds, 200 samples cover a ball pass, whose duration
    agrees with the closed-form solution."""
    succeed(DECK, out=tmp_path, samples=200, settle=0, **scene)
    notes = numbers(tmp_path)
    assert notes["samples_per_pass"] == 200
    assert 200 * notes["sample_s"] == pytest.approx(abs(ball_pass(**closed)), rel=1e-9)


@pytest.mark.parametrize("rate", [48000, 192000])
def test_rate(rate, tmp_path):
    """If the number of samples per second is given instead of samples per ball pass, passes end at
    the nearest sample."""
    succeed(DECK, out=tmp_path, more=f"rate {rate}", passes=3, **DAMPING)
    notes = numbers(tmp_path)
    assert notes["sample_s"] == pytest.approx(1 / rate, rel=1e-12)
    assert len(bytes_of(tmp_path)["time"]) / 8 - 1 == round(3 * rate * ball_pass())


@pytest.mark.parametrize("scene", [IMPLICIT, DAMPING, VERLET], ids=["all", "damping", "verlet"])
def test_more_passes(scene, tmp_path):
    """A run of one pass that is continued for a second pass gives the same results as a run of two
    passes."""
    succeed(DECK, out=tmp_path / "two", passes=2, **scene)
    for passes in (1, 2):
        succeed(DECK, out=tmp_path / "one", passes=passes, resume="yes", **scene)
    assert differ(tmp_path / "one", tmp_path / "two") == []
    assert numbers(tmp_path / "one") == numbers(tmp_path / "two")


@pytest.mark.parametrize(
    "scene",
    [
        IMPLICIT,
        VERLET,
        {**IMPLICIT, "settle": "auto"},
        {**DAMPING, "settle": "auto"},
        {**VERLET, "settle": "auto"},
    ],
    ids=["implicit", "verlet", "auto", "damping, auto", "verlet, auto"],
)
def test_ranks(scene, tmp_path):
    for ranks in (1, 2, 4):
        succeed(DECK, out=tmp_path / str(ranks), ranks=ranks, **scene)
    for ranks in ("2", "4"):
        assert differ(tmp_path / "1", tmp_path / ranks) == []


# the thrust is too small for this speed, so balls slip and their spin axes tilt
TURNS = {
    **IMPLICIT,
    "models": "friction mixed 0.12 0.05 heathcote 1.0e-4 spin 1",
    "clearance": 3e-4,
    "seat": "plus",
    "axial": 1000,
    "load": 300,
    "rpm": 8000,
}


def power(folder):
    """Return the mean power loss of the bearing in W."""
    with netcdf_file(folder / "record.nc", mmap=False) as file:
        return sum(
            np.nanmean(variable.data)
            for name, variable in file.variables.items()
            if name.startswith("bearing_") and name.endswith("_power")
        )


def evaluations(folder):
    """Return the number of force evaluations that a run needs until it has settled."""
    return numbers(folder)["settling_evaluations"]


def test_auto_settles(tmp_path):
    """After one ball pass, the loss differs by 70 % from its final value. After six passes, at a
    turning point, it equals the loss of a long run, but it then changes by another 3 %. `auto`
    continues past this point, and needs only a fraction of the evaluations of the long run."""
    for settle in (1, "auto", 60):
        succeed(DECK, out=tmp_path / str(settle), settle=settle, **TURNS)
    want = power(tmp_path / "60")
    assert power(tmp_path / "1") > 1.2 * want
    assert power(tmp_path / "auto") == pytest.approx(want, rel=1e-2)
    notes = numbers(tmp_path / "auto")
    assert 10 < notes["settled_passes"] < 40
    assert notes["rest_torque"] <= 1e-2 and notes["rest_load"] <= 1e-3
    assert notes["rest_cage_speed"] <= 1e-2 and notes["rest_spin_axis_rad"] <= 1e-2
    assert evaluations(tmp_path / "auto") < 0.5 * evaluations(tmp_path / "60")


def test_last_passes_have_the_steps_of_the_deck(tmp_path):
    """Steps during settling are coarse and do not depend on the tolerance. At least one ball pass
    with the tolerance of the deck precedes the measurement."""
    for tolerance in ("1.0e-9", "1.0e-10"):
        scene = {**TURNS, "move": f"bearing/implicit tolerance {tolerance}"}
        done = succeed(DECK, out=tmp_path / tolerance, settle="auto", **scene)
        passes = [line for line in done.text.splitlines() if line.startswith("Ball pass")]
        assert "coarse steps" in passes[0] and "coarse steps" not in passes[-1]
        coarse = [line for line in passes if "coarse steps" in line]
        assert len(coarse) > 0.5 * len(passes)
    done = succeed(DECK, out=tmp_path / "verlet", settle="auto", **VERLET)
    assert "Ball pass" in done.text and "coarse steps" not in done.text


def test_auto_asks_for_more(tmp_path):
    """If only a tenth of the remaining change is allowed, settling takes more ball passes and meets
    this limit."""
    passes = []
    for settled in (1e-2, 1e-3):
        out = tmp_path / str(settled)
        succeed(DECK, out=out, settle="auto", more=f"settled {settled} limit 300", **TURNS)
        notes = numbers(out)
        assert notes["rest_torque"] <= settled and notes["rest_load"] <= 0.1 * settled
        passes.append(notes["settled_passes"])
    assert passes[1] > passes[0]


def test_auto_ends_at_its_limit(tmp_path):
    """The run prints a warning with the values reached, and then starts the measurement."""
    done = succeed(DECK, out=tmp_path, settle="auto", more="limit 2", **TURNS)
    assert re.search(r"WARNING: run_bearing: not settled after 2 ball passes: .* 0\.01", done.text)
    notes = numbers(tmp_path)
    assert notes["settled_passes"] == 2 and notes["rest_torque"] > 1e-2


def stop(out, scene, share, deck=DECK):
    """Stop a run when its settling phase has reached `share`, which is given in per cent or as a
    number of ball passes."""
    with start(deck, out=out, output=subprocess.PIPE, **scene) as process:
        for line in process.stdout:
            words = line.split()
            assert "Measuring" not in words, "it was not stopped on the way"
            if line.startswith(f"Ball pass {share}:"):
                process.terminate()
                break
            if len(words) == 9 and words[0][0].isdigit() and float(words[0]) >= share:
                process.terminate()
                break
        process.stdout.read()
    assert process.returncode == 128 + signal.SIGTERM


@pytest.mark.parametrize(
    "scene, at",
    [
        ({**IMPLICIT, "settle": 600}, 15),
        ({**VERLET, "settle": 20}, 15),
        ({**VERLET, "settle": 20, "more": "step 0"}, 15),
        ({**TURNS, "settle": "auto"}, 0),
        ({**TURNS, "settle": "auto"}, 2),
        ({**TURNS, "settle": "auto", "more": "settled 1.0e-6 limit 9"}, 8),
        ({**VERLET, "settle": "auto", "more": "settled 1.0e-6 limit 8"}, 3),
    ],
    ids=[
        *("implicit", "verlet", "verlet, chosen steps"),
        *("ramp, auto", "coarse, auto", "last, auto", "verlet, auto"),
    ],
)
def test_stopped_while_it_settles(scene, at, tmp_path):
    """A run that was stopped can be continued, also with adaptive steps. It is stopped while the
    loads are applied in coarse steps, in a ball pass with coarse steps, or in the last ball
    pass."""
    stop(tmp_path / "stopped", scene, at)
    assert not (tmp_path / "stopped" / "record.nc").exists()
    succeed(DECK, out=tmp_path / "whole", **scene)
    succeed(DECK, out=tmp_path / "stopped", resume="yes", **scene)
    assert differ(tmp_path / "stopped", tmp_path / "whole") == []
    assert numbers(tmp_path / "stopped") == numbers(tmp_path / "whole")


def test_stopped_at_the_end_of_adaptive_steps(tmp_path):
    """Adaptive steps continue to the next multiple of 5000 after the loads have been applied, also
    if a run is stopped in between."""
    scene = {**VERLET, "settle": "auto", "more": "settled 1.0e-6 limit 2"}
    succeed(DECK, out=tmp_path / "whole", **scene)
    for number in range(100):
        out = tmp_path / str(number)
        with start(DECK, out=out, output=subprocess.PIPE, **scene) as process:
            next(line for line in process.stdout if line.split()[2:3] == ["10000"])
            time.sleep(1e-3 * number)
            process.terminate()
            stopped = re.search(r"after step (\d+)", process.stdout.read())
        if stopped and 11000 < int(stopped[1]) < 15000:
            break
    else:
        pytest.fail("it was never stopped among its last adaptive steps")
    succeed(DECK, out=out, resume="yes", **scene)
    assert differ(out, tmp_path / "whole") == []


@pytest.mark.parametrize("host", ["liggghts", "lammps"])
@pytest.mark.parametrize("settle", [1, "auto"])
def test_stopped_after_the_last_step_of_settling(settle, host, tmp_path):
    """A run continues from a restart file that was written after settling had ended and before the
    measurement started."""
    scene = {**IMPLICIT, "settle": settle, "samples": 20}  # there are 20 steps per ball pass
    whole = succeed(DECK, host=host, out=tmp_path / "whole", **scene)
    *settling, measuring = (int(n) for n in re.findall(r"for (\d+) steps", whole.text))
    assert sum(settling) > measuring  # the only restart file is of the last settling step
    kept = {**scene, "keep": sum(settling), "last": "no", "out": tmp_path / "kept"}
    succeed(DECK, host=host, **kept)
    resumed = succeed(DECK, host=host, resume="yes", **kept)
    assert re.findall(r"for (\d+) steps", resumed.text) == [str(measuring)]
    assert differ(tmp_path / "kept", tmp_path / "whole") == []
    assert numbers(tmp_path / "kept") == numbers(tmp_path / "whole")


@pytest.mark.parametrize("host", ["lammps", "wheel"])
def test_auto_in_other_hosts(host, tmp_path):
    for program in ("liggghts", host):
        out = tmp_path / program
        own = {"bearing": 7208, "rpm": 6000, "samples": 20, "passes": 1, "settle": "auto"}
        succeed("inputs/in.6208", out=out, host=program, **own)
    assert differ(tmp_path / "liggghts", tmp_path / host) == []


@pytest.mark.parametrize(
    "scene, message",
    [
        ({"passes": 0}, "passes is 0, must be a whole number from 1 to"),
        ({"settle": "auto", "more": "settled 2"}, "settled is 2, must be from 1e-06 to 1"),
        ({"settle": -1}, "ball passes to settle is -1, must be from 0 to"),
        ({"settle": "long"}, "settle is 'long', must be a number of ball passes, auto or orbit"),
        ({"more": "step 1.0"}, r"step \(s\) is 1, must be from 1e-09 to 0.001, or 0"),
        ({"more": "stepp 1"}, "'stepp'; did you mean 'step'"),
        ({"rpm": 0}, "no ring turns, so balls do not pass"),
        ({"samples": 0}, "samples in a ball pass is 0, must be"),
    ],
)
def test_errors_before_anything_runs(scene, message, tmp_path):
    failed = liggghts(DECK, out=tmp_path, **scene)
    refused(failed, message)
    assert "Settling" not in failed.text
