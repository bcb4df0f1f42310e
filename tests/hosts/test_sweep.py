# SPDX-License-Identifier: GPL-2.0-or-later
"""Tests of `raceway sweep` with the real program: points, failures, locks, kills, job arrays, and
the scripts in inputs/cluster."""

import contextlib
import io
import json
import os
import re
import signal
import subprocess
import sys
from pathlib import Path
from types import SimpleNamespace

import host
import pandas as pd
import pytest
import raceway
from commands import reply
from host import ENVIRONMENT, ROOT, run, same_files, succeed, wait_for
from raceway.cli import main
from raceway.sweeps.points import deck_variables

ENV = {
    **ENVIRONMENT,
    "PYTHONPATH": str(Path(raceway.__file__).parents[1]),
    "PYTHONDONTWRITEBYTECODE": "1",
}
PLAIN = {"models": None, "settle": None}  # as in the deck
TABLE = """load,rpm,lubricant,passes,samples
5000,477.5,mineral,1,20
2000,1000,dry,1,20
2e7,1000,dry,1,20
2000,477.5,pao48,1,20
"""
COUNTER = """#!/bin/bash
# counts how often each point is started, then runs the program
for word; do case "$last" in out) echo start >> "$word.starts";; esac; last=$word; done
exec {program} "$@"
"""


def words(*arguments):
    return [sys.executable, "-m", "raceway", *map(str, arguments)]


def call(command, env=ENV):
    return host.call(command, env=env)


def started(command, env=ENV, **more):
    return subprocess.Popen(command, cwd=ROOT, env=env, text=True, stdout=subprocess.PIPE, **more)


def sweep(*arguments):
    """Run `raceway sweep` in this process, which has already imported the large packages."""
    out, err = io.StringIO(), io.StringIO()
    handlers = {one: signal.getsignal(one) for one in (signal.SIGTERM, signal.SIGHUP)}
    with contextlib.chdir(ROOT), contextlib.redirect_stdout(out), contextlib.redirect_stderr(err):
        try:
            code = main(["sweep", *map(str, arguments)])
        except SystemExit as end:
            code = end.code
    for one, handler in handlers.items():
        signal.signal(one, handler)
    return SimpleNamespace(returncode=code, stdout=out.getvalue(), stderr=err.getvalue())


@pytest.fixture
def table(tmp_path):
    path = tmp_path / "table.csv"
    path.write_text(TABLE)
    return path


def test_a_deck_of_several_bearings_without_resume(tmp_path):
    """The table of results has columns for each bearing, which contain the values in the bearing's
    summary."""
    (tmp_path / "t.csv").write_text("rpm\n3000\n")
    out = tmp_path / "out"
    done = sweep(tmp_path / "t.csv", "--deck", "docs/decks/in.two_bearings", "--out", out)
    assert "1 finished" in done.stdout, done.stderr
    row = pd.read_csv(out / "results.csv").iloc[0]
    for number, name in ((1, "6208"), (2, "6306")):
        figures = raceway.open(out / "rpm=3000").select(number).summary()
        assert str(row[f"bearing_{number}_bearing"]) == name == figures["bearing"]
        assert row[f"bearing_{number}_q_max_N"] == pytest.approx(figures["q_max_N"], rel=1e-15)
        assert row[f"bearing_{number}_loss_slip_W"] == pytest.approx(figures["losses_W"]["slip"])


@pytest.fixture
def counter(tmp_path):
    """Return a program that, at each start, appends a line to a file next to the folder of the
    point."""
    path = tmp_path / "counter.sh"
    path.write_text(COUNTER.format(program=ROOT / "build" / "liggghts"))
    path.chmod(0o755)
    return path


def starts(folder):
    return {
        path.name.removesuffix(".starts"): len(path.read_text().split())
        for path in folder.glob("*.starts")
    }


def test_sweep(table, tmp_path, counter):
    out = tmp_path / "out"
    done = sweep(table, "--out", out, "--program", counter)
    assert done.returncode == 1 and "Traceback" not in done.stderr
    assert "3 finished, 1 failed" in done.stdout
    assert "bearing: load (N) is 2e+07, must be from 0.001 to 1e+06" in done.stderr
    results = pd.read_csv(out / "results.csv")
    # the table is sorted by load, then by speed
    assert list(results["status"]) == ["finished", "finished", "finished", "failed"]
    assert "must be from 0.001" in results["message"][3]
    one = results.set_index("point").loc[
        "load=5000_rpm=477.5_lubricant=mineral_passes=1_samples=20"
    ]
    figures = raceway.open(out / one.name).summary()
    losses = {f"loss_{part}_W" for part in figures["losses_W"] or ()}
    assert set(figures) - {"losses_W", "model_ranges", "absent"} | losses <= set(results.columns)
    assert one["q_max_N"] == pytest.approx(figures["q_max_N"], rel=1e-15)
    # the result equals that of a run of the deck without a sweep
    succeed("inputs/in.6208", out=tmp_path / "alone", passes=1, samples=20, **PLAIN)
    same_files(out / one.name, tmp_path / "alone", "record.nc")
    # a second call runs nothing and keeps failed points; with --retry only the failed point is
    # rerun
    again = sweep(table, "--out", out, "--program", counter)
    assert "3 finished (3 before), 1 failed" in again.stdout and set(starts(out).values()) == {1}
    sweep(table, "--out", out, "--program", counter, "--retry")
    assert sorted(starts(out).values()) == [1, 1, 1, 2]
    # a sweep gathers its results, which can also be done with a separate command
    (out / "results.csv").unlink()
    gathered = call(words("gather", out))
    assert gathered.stdout == f"{out / 'results.csv'}: 3 finished, 1 failed\n"
    pd.testing.assert_frame_equal(pd.read_csv(out / "results.csv"), results)


def test_shares_of_the_time(tmp_path, capsys):
    """A column `share` is copied to results.csv, from which `--spectrum` computes the life. Statics
    for the same loads gives the same life."""
    path, out = tmp_path / "duties.csv", tmp_path / "out"
    head, rows = "load,rpm,share", ("2000,1500,0.7", "5000,3000,0.3")
    path.write_text("\n".join([f"{head},passes,samples", *(f"{row},1,20" for row in rows)]) + "\n")
    assert sweep(path, "--out", out).returncode == 0
    results = pd.read_csv(out / "results.csv")
    assert list(results["share"]) == [0.7, 0.3] and "share" not in results["point"][0]
    (tmp_path / "alone.csv").write_text("\n".join([head, *rows]) + "\n")
    found = []
    for table in (out / "results.csv", tmp_path / "alone.csv"):
        found.append(json.loads(reply(capsys, ["static", "--spectrum", str(table), "--json"])))
    lives = results["life_reference_Mrev"]
    turns = results["rpm"] * results["share"]
    assert found[0]["life_reference_Mrev"] == pytest.approx(turns.sum() / (turns / lives).sum())
    assert found[0]["equivalent_load_N"] == pytest.approx(found[1]["equivalent_load_N"], rel=0.02)


def test_finished_means_the_figures_of_these_variables(table, tmp_path, counter):
    """A folder whose files contain other settings is not treated as finished."""
    out = tmp_path / "out"
    sweep(table, "--out", out, "--program", counter)
    name = "load=2000_rpm=1000_lubricant=dry_passes=1_samples=20"
    (out / name / "point.yaml").write_text("load: '1'\n")
    sweep(table, "--out", out, "--program", counter)
    assert starts(out)[name] == 2
    # if results are missing but the run is complete, they are recomputed without another run
    (out / name / "summary.json").unlink()
    sweep(table, "--out", out, "--program", counter)
    assert (
        starts(out)[name] == 2
        and json.loads((out / name / "summary.json").read_text())["load_N"] == 2000
    )


def test_two_sweeps_share_the_work(tmp_path, counter):
    table, out = tmp_path / "table.csv", tmp_path / "out"
    table.write_text(
        "load,passes,samples\n" + "".join(f"{load},2,50\n" for load in range(1000, 7000, 1000))
    )
    one = words("sweep", table, "--out", out, "--jobs", 1, "--program", counter)
    both = [started(one, stderr=subprocess.STDOUT) for _ in range(2)]
    texts = [process.communicate(timeout=300)[0] for process in both]
    assert [process.returncode for process in both] == [0, 0], texts
    assert len(starts(out)) == 6 and set(starts(out).values()) == {1}
    assert set(pd.read_csv(out / "results.csv")["status"]) == {"finished"}


@pytest.mark.parametrize(
    "which, code",
    [(signal.SIGINT, 130), (signal.SIGTERM, 143), (signal.SIGKILL, -9)],
    ids=lambda value: str(value),
)
def test_stopped_half_way(tmp_path, counter, which, code):
    """Nothing is lost, no finished point is repeated, and the interrupted point continues from its
    restart file."""
    table, out = tmp_path / "table.csv", tmp_path / "out"
    table.write_text(
        "load,passes,samples,integrator\n"
        + "".join(f"{load},4,50,implicit\n" for load in range(1000, 5000, 1000))
        + "9000,8,20,verlet\n"  # still running when the signal arrives
    )
    process = started(
        words("sweep", table, "--out", out, "--jobs", 2, "--program", counter),
        start_new_session=True,
        stderr=subprocess.PIPE,
    )
    wait_for(lambda: len(list(out.glob("*/summary.json"))) >= 2)
    if which == signal.SIGINT:
        os.killpg(process.pid, which)  # a terminal signals the process group in the same way
    else:
        process.send_signal(which)
    _, errors = process.communicate(timeout=60)
    assert process.returncode == code and "Traceback" not in errors, errors
    stopped = re.search(r"stopped with (\d) of 5 points finished", errors)
    assert bool(stopped) == (which != signal.SIGKILL), errors
    wait_for(lambda: not in_work(out))
    before = {path: path.stat().st_mtime_ns for path in out.glob("*/summary.json")}
    assert 2 <= len(before) < 5 and (not stopped or int(stopped[1]) == len(before))
    done = sweep(table, "--out", out, "--program", counter)
    assert done.returncode == 0, done.stderr
    assert {path: path.stat().st_mtime_ns for path in before} == before
    assert all(starts(out)[path.parent.name] == 1 for path in before)
    assert list(pd.read_csv(out / "results.csv")["status"]) == ["finished"] * 5


def in_work(folder):
    """Return whether a process is still writing to a path below `folder`."""
    for line in Path("/proc").glob("[0-9]*/cmdline"):
        try:
            if f"{folder}/".encode() in line.read_bytes():
                return True
        except OSError:
            continue
    return False


@pytest.mark.parametrize(
    "arguments, complaint",
    [
        (["--program", "nowhere/liggghts"], "there is no program 'nowhere/liggghts'"),
        (["--deck", "in.none"], "cannot read deck in.none"),
    ],
)
def test_mistakes(table, arguments, complaint):
    done = sweep(table, *arguments)
    assert done.returncode == 1 and complaint in done.stderr and "Traceback" not in done.stderr


@pytest.mark.parametrize(
    "arguments", [["--jobs", "0"], ["--part", "3/2"], ["--part", "0/2"], ["--tasks", "-1"]]
)
def test_wrong_options(table, arguments):
    assert sweep(table, *arguments).returncode == 2


def test_check_runs_nothing(table, tmp_path):
    table.write_text(table.read_text().replace("2e7", "20"))
    done = sweep(table, "--out", tmp_path / "out", "--check")
    assert (done.returncode, done.stdout) == (0, f"{table}: 4 points\n")
    assert not (tmp_path / "out").exists()


@pytest.mark.parametrize(
    ("name", "right", "wrong"), [("bearing", "6306", "NU206"), ("lubricant", "dry", "honey")]
)
def test_check_finds_unknown_names(tmp_path, name, right, wrong):
    table = tmp_path / "t.csv"
    table.write_text(f"{name}\n{right}\n")
    assert sweep(table, "--check").returncode == 0
    table.write_text(f"{name}\n{right}\n{wrong}\n")
    assert f"'{wrong}' in " in sweep(table, "--check").stderr


@pytest.mark.parametrize("deck", ["inputs/in.6208", "inputs/in.many", "docs/decks/in.two_bearings"])
def test_check_finds_what_the_deck_refuses(tmp_path, deck):
    """For one wrong value at a time, the message of `--check` is that of the deck. Values that the
    deck accepts pass, and so do variables that it uses in formulas of its own."""
    table, known = tmp_path / "t.csv", deck_variables(ROOT / deck)
    words = {"rpm": (-5, 1e4), "load": (0, "5.0e2"), "clearance": ("1e-2", "-1e-6")}
    words |= {"passes": (1.5, 2), "axial": ("0x10", 0), "integrator": ("euler", "implicit")}
    words |= {"moment_x": (1e9, -9), "ball_poisson": (0.9, 0.29), "ramp": (-1, 3e-3)}
    refused = 0
    for name in words.keys() & known.keys():
        wrong, right = words[name]
        table.write_text(f"{name}\n{right}\n")
        assert sweep(table, "--deck", deck, "--check").returncode == 0
        table.write_text(f"{name}\n{wrong}\n")
        if (checked := sweep(table, "--deck", deck, "--check")).returncode:
            refused += 1
            own = {"models": None, "settle": None, name: wrong}
            said = checked.stderr.partition(f"{name}={wrong}: ")[2].strip()
            assert said and said in run(deck, out=tmp_path / "out", **own).text, checked.stderr
    assert refused == (len(words) if deck == "inputs/in.6208" else refused) > 0


def slurm(task, tasks, **more):
    """Return the environment with the variables that Slurm sets for a task of a job array."""
    return {
        **ENV,
        "SLURM_ARRAY_TASK_ID": str(task),
        "SLURM_ARRAY_TASK_COUNT": str(tasks),
        "SLURM_CPUS_PER_TASK": "1",
        **more,
    }


def test_job_array(table, tmp_path, counter):
    """The script written by `--slurm` is run task by task, as Slurm would run it."""
    out, script = tmp_path / "out", tmp_path / "job.sh"
    done = sweep(table, "--out", out, "--program", counter, "--slurm", script, "--tasks", 2)
    assert done.stdout == f"{script}: 4 points in 2 tasks\n" and not starts(out)
    assert "#SBATCH --array=1-2" in script.read_text()
    for task in (1, 2):
        call(["bash", script], slurm(task, 2))
        assert len(starts(out)) == 2 * task
    assert sorted(pd.read_csv(out / "results.csv")["status"]) == ["failed"] + ["finished"] * 3


def test_array_script(table, tmp_path):
    tool = tmp_path / "raceway"
    tool.write_text(f'#!/bin/bash\nexec {sys.executable} -m raceway "$@"\n')
    tool.chmod(0o755)
    command = ["bash", "inputs/cluster/array.sh", table, tmp_path / "out"]
    for task in (1, 2):
        call(command, slurm(task, 2, RACEWAY=str(tool)))
    results = pd.read_csv(tmp_path / "out" / "results.csv")
    assert sorted(results["status"]) == ["failed"] + ["finished"] * 3
    refused = call(command)
    assert refused.returncode != 0 and "sbatch --array" in refused.stderr


@pytest.mark.parametrize("script, tasks", [("run.sh", 1), ("mpi.sh", 2)])
def test_run_scripts(tmp_path, script, tasks):
    """A run is stopped as if a time limit had been reached, restarted on one rank, and started once
    more after it has finished."""
    out, settings = tmp_path / "run", ["-var", "passes", "30", "-var", "samples", "100"]
    command = ["bash", f"inputs/cluster/{script}", str(out), *settings]
    environment = {
        **ENV,
        "SLURM_NTASKS": str(tasks),
        "KEEP": "20",
        "MPIRUN": "mpirun.openmpi --oversubscribe",
    }
    process = started(command, env=environment, stderr=subprocess.STDOUT)
    wait_for((out / "restart").exists)
    process.terminate()  # the signal of --signal=B:TERM@120 reaches only the shell
    text = process.communicate(timeout=60)[0]
    assert process.returncode == 138, text
    assert "-var resume yes continues from" in text
    resumed = call(["bash", "inputs/cluster/run.sh", *command[2:]])
    assert resumed.returncode == 0 and "Continuing from" in resumed.stdout
    succeed("inputs/in.6208", out=tmp_path / "alone", passes=30, samples=100, **PLAIN)
    same_files(out, tmp_path / "alone", "record.nc")
    finished = call(command, environment)
    assert (finished.returncode, finished.stdout) == (0, "")


@pytest.mark.parametrize(
    "script", sorted((ROOT / "inputs" / "cluster").glob("*.sh")), ids=lambda path: path.name
)
def test_scripts_parse(script):
    subprocess.run(["bash", "-n", script], check=True)
    text = script.read_text()
    assert text.startswith("#!/bin/bash\n") and re.search(r"^#SBATCH --time=", text, re.MULTILINE)


def test_partition_deck(tmp_path):
    """In inputs/in.partition, two partitions share four points, and the result for each point
    equals that of a separate run. Hosts lock points with a file in the current folder, so this test
    uses a separate folder."""
    (tmp_path / "inputs").symlink_to(ROOT / "inputs")
    words = {"passes": 1, "samples": 50}
    apart = ("-partition", "2x1", "-screen", "none")
    succeed("inputs/in.partition", ranks=2, extra=apart, cwd=tmp_path, to=tmp_path / "all", **words)
    points = [(1000, 477.5, "mineral"), (2000, 477.5, "mineral")]
    points += [(5000, 477.5, "pao48"), (5000, 3000, "pao48")]
    for number, (load, rpm, oil) in enumerate(points, 1):
        alone, point = tmp_path / "alone", {"load": load, "rpm": rpm, "lubricant": oil}
        succeed("inputs/in.6208", out=alone, overwrite="yes", **point, **words, **PLAIN)
        same_files(tmp_path / "all" / str(number), alone, "record.nc")


def test_table_of_the_docs(tmp_path):
    """docs/sweep.rst shows the output of this command and the name of one of its folders."""
    done = sweep("docs/decks/sweep.csv", "--out", tmp_path)
    assert (done.returncode, done.stdout) == (0, f"4 finished: {tmp_path / 'results.csv'}\n")
    assert (tmp_path / "load=1000_rpm=477.5_lubricant=mineral_passes=1" / "summary.json").exists()
