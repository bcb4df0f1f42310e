# SPDX-License-Identifier: GPL-2.0-or-later
"""`fix bearing/checkpoint` stops a run on a signal, resumes it, rejects files that do not match,
and reports a full disk."""

import os
import re
import resource
import signal
import subprocess

import pytest
from host import (
    ENVIRONMENT,
    ROOT,
    command,
    deck_file,
    frames,
    liggghts,
    refused,
    refuses,
    same_files,
    succeed,
    wait_for_file,
)
from hosts.kills import start
from raceway.errors import RunError
from raceway.runs.tables import RunTables

SCENE = {"passes": 40, "samples": 100, "keep": 50, "dumps": "yes"}
FILES = ("contacts.dump", "balls.dump", "rings.dat", "record.nc")


@pytest.fixture
def stopped(tmp_path):
    """Return the folder of a run that received SIGTERM during its measurement phase."""
    out = tmp_path / "run"
    process = start(SCENE, out)
    wait_for_file(out / "record.nc", 50_000)  # the run is in its measurement phase
    process.terminate()
    assert process.wait() == 128 + signal.SIGTERM
    return out


def test_stopped_run(stopped):
    text = (stopped.with_name("run.log")).read_text(errors="replace")
    assert f"-var resume yes continues from {stopped}/restart" in text
    assert not (stopped / "restart.part").exists()
    with pytest.raises(RunError, match="has not finished"):
        RunTables(stopped).need_finished()


@pytest.mark.parametrize("name", [signal.SIGINT, signal.SIGUSR1], ids=lambda which: which.name)
def test_other_signals(tmp_path, name):
    process = start(SCENE, tmp_path / "run")
    wait_for_file(tmp_path / "run" / "restart")
    process.send_signal(name)
    assert process.wait() == 128 + name


def test_other_settings_are_refused(stopped):
    says = "belongs to another run", "load 5000", "load 4000"
    words = {**SCENE, "load": 4000, "resume": "yes"}
    failed = refuses("inputs/in.6208", *says, out=stopped, **words)
    assert "spin speed" not in failed.error  # the spin speed is the same in both runs


def test_shortened_file_is_refused(stopped):
    with open(stopped / "contacts.dump", "r+b") as file:
        file.truncate(1000)
    says = "contacts.dump has 1000 bytes, it had", "start the run anew"
    refuses("inputs/in.6208", *says, out=stopped, resume="yes", **SCENE)


def test_scene_killed_before_its_first_restart_file(tmp_path):
    """`resume yes` starts such a run anew, and its dump has each sample once."""
    succeed("docs/decks/in.scene", out=tmp_path, steps=300)
    assert not (tmp_path / "restart").exists()
    succeed("docs/decks/in.scene", out=tmp_path, steps=500, resume="yes")
    steps = re.findall(r"TIMESTEP\n(\d+)", (tmp_path / "forces.dump").read_text())
    assert steps == ["0", "100", "200", "300", "400", "500"]


def test_replaced_file_is_refused(tmp_path):
    """A deck that does not append to a file replaces it when it continues. This used to fill the
    file with zeros up to its former length and then report that it had stopped growing."""
    deck = (ROOT / "docs/decks/in.scene").read_text()
    succeed("docs/decks/in.scene", out=tmp_path, steps=2000)
    dump = tmp_path / "forces.dump"
    length = dump.stat().st_size
    wrong = deck_file(tmp_path, deck.replace("append yes", "append no"))
    says = f"forces.dump has {{}} bytes, it had {length} when", "does not append"
    failed = refuses(wrong, says[1], out=tmp_path, steps=3000, resume="yes")
    left = dump.stat().st_size
    assert says[0].format(left) in failed.error and left < length
    assert b"\0" not in dump.read_bytes()


def test_shortened_record_is_refused(stopped):
    os.truncate(stopped / "record.nc", 20000)
    failed = liggghts("inputs/in.6208", out=stopped, resume="yes", **SCENE)
    refused(failed, r"cannot write .*record.nc: it has fewer than \d+ samples")


def test_new_run_replaces_an_old_restart_file(stopped):
    """Without `resume`, the run starts from the beginning, and no file of the old run is left."""
    small = {"passes": 1, "samples": 50, "dumps": "yes"}
    succeed("inputs/in.6208", out=stopped, **small)
    left = {path.name for path in stopped.iterdir()}
    assert left == {*FILES, "restart", "run.yaml"}
    assert len(frames(stopped / "balls.dump")) == 51


def test_restart_files_change_no_bit(tmp_path):
    """Writing restart files does not change a single bit of the results."""
    for name, keep in (("without", 0), ("with", 7)):
        succeed("inputs/in.6208", out=tmp_path / name, passes=1, samples=50, keep=keep, dumps="yes")
    same_files(tmp_path / "with", tmp_path / "without", *FILES)


def limited(out, bytes_of_a_file, **variables):
    """Run 40 passes with a limit on the size of files, and return the finished process."""
    return subprocess.run(
        command("inputs/in.6208", out=out, passes=40, models=None, settle=None, **variables),
        cwd=ROOT,
        env=ENVIRONMENT,
        text=True,
        errors="replace",
        stdout=subprocess.PIPE,
        stderr=subprocess.STDOUT,
        check=False,
        preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_FSIZE, (bytes_of_a_file,) * 2),
    )


def test_file_size_limit(tmp_path):
    done = limited(tmp_path / "record", 12_000_000)  # MPI creates files in blocks of 4 MB
    assert done.returncode != 0
    assert "record.nc: File too large" in done.stdout
    done = limited(tmp_path / "run", 30_000_000, dumps="yes", record="none")
    assert done.returncode != 0
    assert "contacts.dump has stopped growing at step" in done.stdout and "Make room" in done.stdout


def test_full_disk(tmp_path):
    disk = tmp_path / "disk"
    disk.mkdir()
    mount = ["mount", "-t", "tmpfs", "-o", "size=1m", "tmpfs", disk]
    if os.geteuid() != 0 or subprocess.run(mount, check=False).returncode != 0:
        pytest.skip("mounting a small disk needs root")
    try:
        words = {"out": disk / "run", "passes": 4, "keep": 20, "dumps": "yes"}
        refuses("inputs/in.6208", "No space left on device", **words)
        # once space has been freed, the run continues to the end with bitwise identical results
        subprocess.run(["mount", "-o", "remount,size=20m", disk], check=True)
        succeed("inputs/in.6208", resume="yes", **words)
        succeed("inputs/in.6208", out=tmp_path / "reference", passes=4, dumps="yes")
        same_files(disk / "run", tmp_path / "reference", *FILES)
    finally:
        subprocess.run(["umount", disk], check=True)


@pytest.mark.parametrize(
    "words, complaint",
    [
        ("0 x", "steps between samples is 0, must be"),
        ("10", "restart file"),
        ("10 x wrong", "restart, resume, last, balance, files"),
        ("10 x balance step", "balance: there is no fix bearing/ring or bearing/shaft 'step'"),
        ("10 x resume maybe", "no, yes"),
        ("10 x resume yes", "nothing to resume"),
    ],
)
def test_bad_commands(tmp_path, words, complaint):
    deck = deck_file(
        tmp_path,
        (ROOT / "docs/decks/in.smallest").read_text().rsplit("\nrun", 1)[0]
        + f"\nfix keep all bearing/checkpoint {words}\nrun 10\n",
    )
    refuses(deck, "bearing/checkpoint", complaint, cwd=tmp_path)
