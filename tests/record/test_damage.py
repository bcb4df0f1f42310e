# SPDX-License-Identifier: GPL-2.0-or-later
"""Reading a damaged record stops with an error message for any kind of damage."""

import random
import shutil

import netCDF4
import pytest
import raceway
import synthetic
from host import succeed
from raceway.errors import RunError
from raceway.runs.record import Record
from recorded_runs import small
from smallest import SMALLEST

CASES = 200


@pytest.fixture(scope="module")
def folder(tmp_path_factory):
    """Return the folder of a run with seven samples."""
    folder = tmp_path_factory.mktemp("tiny")
    deck = SMALLEST.replace("bearing/record 100", "bearing/record 500").replace(
        "run 20000", "run 3000"
    )
    succeed(small(folder, deck=deck))
    return folder / "run"


def flip(dice, content, at):
    content[at] ^= 1 << dice.randrange(8)


def zeros(dice, content, at):
    n = min(dice.choice((8, 512, 4096)), len(content) - at)
    content[at : at + n] = bytes(n)


def noise(dice, content, at):
    content[at : at + 8] = dice.randbytes(min(8, len(content) - at))


def insert(dice, content, at):
    content[at:at] = dice.randbytes(dice.choice((1, 4, 8)))


def leave_out(dice, content, at):
    del content[at : at + dice.choice((1, 4, 8))]


def cut(dice, content, at):
    del content[at:]


def add(dice, content, at):
    content += bytes(dice.choice((1, 8, 4096)))


WAYS = (flip, flip, zeros, noise, insert, leave_out, cut, add)


def test_damage_is_found(folder, tmp_path):
    right, one = (folder / "record.nc").read_bytes(), Record(folder).record_bytes
    raceway.open(folder).summary()
    header = len(right) - 7 * one
    dice, to, silent = random.Random(29), tmp_path / "run", []
    shutil.copytree(folder, to)

    def swap(dice, content, _):
        """Swap two samples."""
        a, b = (slice(at, at + one) for at in dice.sample(range(header, len(right), one), 2))
        content[a], content[b] = content[b], content[a]

    for k in range(CASES):
        content, way = bytearray(right), (*WAYS, swap)[k % (len(WAYS) + 1)]
        at = dice.randrange(header if k % 2 else len(right))
        way(dice, content, at)
        if content == right:  # zeros were replaced by zeros
            continue
        (to / "record.nc").write_bytes(content)
        try:
            raceway.open(to).summary()
            silent.append((k, way.__name__, at))
        except RunError as error:
            assert "record.nc" in str(error) and "\n" not in str(error)
    assert not silent


def test_a_sample_is_found_wherever_it_is_read(folder, tmp_path):
    shutil.copytree(folder, tmp_path / "run")
    with netCDF4.Dataset(tmp_path / "run" / "record.nc", "a") as data:
        data["bearing_load_inner"][3] *= 1.001
    record = Record(tmp_path / "run")
    assert record.pick("load", (2, 0)).max() > 0  # another sample
    for read in (
        lambda: raceway.open(tmp_path / "run"),  # reads load and speed
        lambda: record.pick("ring_fx", (3, 0)),
        lambda: record.read(["load"]),
    ):
        with pytest.raises(RunError, match="damaged: sample 4 differs from its checksum"):
            read()


def test_a_record_without_checksums(tmp_path):
    """Records without checksums are read and reported as unchecked. Their sums are compared with
    sums over their contacts."""
    synthetic.write(tmp_path, synthetic.run(passes=1, samples_per_pass=12))
    run = raceway.open(tmp_path)
    run.summary()
    assert "without checksums" in repr(run)
    with netCDF4.Dataset(tmp_path / "record.nc", "a") as data:
        data["bearing_load_outer"][3] *= 1.001
    with pytest.raises(RunError, match="damaged: in sample 4 the largest load on the outer"):
        raceway.open(tmp_path).summary()
