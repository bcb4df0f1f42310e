# SPDX-License-Identifier: GPL-2.0-or-later
"""Values and lines are found in recordings in the formats of public data sets. The tests generate
the recordings."""

import json

import numpy as np
import pytest
import raceway
import synthetic
from raceway import envelope, inputs, passages, recording, shaft_speed, spectrum
from raceway.cli import main
from raceway.errors import RunError
from raceway.recordings.contents import GRAVITY, POUND
from scipy import io
from scipy.io import wavfile

# Hz, Hz, and ratio of BPFO to shaft speed (for a contact angle other than the nominal one)
RATE, SHAFT, ORDER = 48000.0, 29.87, 3.5972
SECONDS = 4.0


@pytest.fixture(scope="module")
def bearing():
    return inputs.bearing("inputs/bearings/6205")


def struck(rate=RATE, order=ORDER, seconds=SECONDS):
    """Return a signal in m/s^2 of impacts at `order` that excite 4 kHz, with added shaft harmonics,
    mains hum and noise."""
    time = np.arange(int(seconds * rate)) / rate
    since = (order * SHAFT * time) % 1 / (order * SHAFT)
    shaft = sum(np.sin(2 * np.pi * n * SHAFT * time + n) / n for n in (1, 2, 3))
    noise = np.random.default_rng(3).normal(size=len(time))
    ringing = 20 * np.exp(-1500 * since) * np.sin(2 * np.pi * 4000 * since)
    return ringing + 0.5 * shaft + 0.1 * np.sin(2 * np.pi * 60 * time) + 0.2 * noise


def cwru(path, values):
    x = values[:, None] / GRAVITY
    io.savemat(path, {"X130_DE_time": x, "X130_BA_time": 0.1 * x, "X130RPM": [[1797.0]]})
    return {"rate": RATE}


def cwru_npz(path, values):
    np.savez(path, DE=values / GRAVITY, FE=0.1 * values)
    return {}


def mfpt(path, values):
    x = values[:, None] / GRAVITY
    io.savemat(path, {"bearing": {"sr": RATE, "gs": x, "load": 100, "rate": 30}})
    return {}


def paderborn(path, values):
    """Write time bases and channels as arrays of structures, with the speed sampled at 4 kHz."""
    slow = np.arange(int(SECONDS * 4000)) / 4000
    bases = [("HostService", np.arange(len(values)) / RATE), ("Mech_4kHz", slow)]
    x = np.array([(name, time) for name, time in bases], [("Raster", "O"), ("Data", "O")])
    y = [("speed", "Mech_4kHz", 60 * SHAFT + 0 * slow), ("vibration_1", "HostService", values)]
    y = np.array(y, [("Name", "O"), ("Raster", "O"), ("Data", "O")])
    io.savemat(path, {path.stem: {"X": x[None], "Y": y[None], "Info": 0}})
    return {}


def femto(path, values):
    """Write values separated by semicolons, as in some folders of the data set."""
    rows = [f"9;39;39;{k};{v / GRAVITY:.9g};0.0" for k, v in enumerate(values)]
    path.write_text("\n".join(rows))
    return {"rpm": 60 * SHAFT}


def columns(path, values):
    table = np.column_stack([np.arange(len(values)) / RATE, values])
    np.savetxt(path, table, delimiter=",", header="time_s,a_m_s2", comments="", fmt="%.12g")
    return {"rpm": 60 * SHAFT}


def wav(path, values):
    wavfile.write(path, int(RATE), values.astype(np.float32))
    return {"rpm": 60 * SHAFT}


FORMATS = {
    "130.mat": cwru,
    "1797_OR@6_7_DE48.npz": cwru_npz,
    "OuterRaceFault_vload_4.mat": mfpt,
    "N18_M07_F10_KA01_1.mat": paderborn,
    "acc_00001.csv": femto,
    "columns.csv": columns,
    "signal.wav": wav,
}
LOAD = {"OuterRaceFault_vload_4.mat": 100 * POUND, "N18_M07_F10_KA01_1.mat": 1000.0}


@pytest.mark.parametrize("name", FORMATS)
def test_a_format(name, tmp_path, bearing):
    """Values are read in SI units, and the sampling rate, the load and the line are found. If the
    file states only a nominal speed, the true speed is found."""
    rate = 25600.0 if name.startswith("acc") else RATE
    values = struck(rate)
    words = FORMATS[name](tmp_path / name, values)
    found = recording.Recording(tmp_path / name, bearing, **words)
    signal = found.signal()
    assert signal.values == pytest.approx(values, abs=1e-5)
    assert 1 / signal.sample_s == pytest.approx(rate, rel=1e-9)
    assert found.load == pytest.approx(LOAD.get(name, np.nan), nan_ok=True)
    assert found.rpm == pytest.approx(60 * SHAFT, rel=3e-5)
    assert bool(found.speed) == ("rpm" not in words)
    if found.speed:
        assert abs(found.speed.hertz - SHAFT) < 3 * found.speed.uncertainty
    lines = spectrum.lines(found, envelope.of_run(found, "", (2000, 7000)), within=0.01)
    outer = [line for line in lines if line.name == "BPFO"]
    assert [line.note for line in outer] == ["", "", ""]
    for line in outer:
        assert line.found / line.harmonic / SHAFT == pytest.approx(ORDER, rel=1e-4)


def test_the_true_speed_near_a_nominal_one(tmp_path, bearing, capsys):
    """If a file does not state the speed, a true speed that differs by 1 % from the nominal speed
    is found, and the lines equal those found if the file states the true speed."""
    columns(tmp_path / "a.csv", struck())
    for away in (0.99, 1.01):
        found = recording.Recording(tmp_path / "a.csv", bearing, nominal=60 * SHAFT * away)
        assert found.rpm == pytest.approx(60 * SHAFT, rel=3e-5)
    words = ["measured", str(tmp_path / "a.csv"), "--bearing", "6205", "--json"]
    said = []
    for speed in (["--nominal", "1800"], ["--rpm", f"{60 * SHAFT}"]):
        assert main([*words, *speed]) == 0
        said.append(json.loads(capsys.readouterr().out))
    assert said[0]["rpm_nominal"] == 1800
    for one, other in zip(*(given["lines"] for given in said)):
        assert (one["name"], one["note"], one["found_Hz"]) == (
            other["name"],
            other["note"],
            other["found_Hz"],
        )


@pytest.mark.parametrize("mark", [";", ";,", ",", "\t", "  "])
@pytest.mark.parametrize("head", [True, False])
@pytest.mark.parametrize("names", [["a_m_s2"], ["time_s", "a_m_s2", "b_g"]])
def test_separators(tmp_path, bearing, mark, head, names):
    """Files may have one or more columns, with or without a heading, after a comment. Numbers
    contain decimal points or, if the separators are semicolons, decimal commas."""
    values = struck(seconds=0.05)
    table = np.column_stack([np.arange(len(values)) / RATE, values, values])[:, -len(names) :]
    mark, point = (";", "," if names[1:] else ".") if mark == ";," else (mark, ".")
    rows = [mark.join(f"{x:.9e}".replace(".", point) for x in row) for row in table]
    lines = [mark.join(names)] * head + rows
    (tmp_path / "a.csv").write_text("# a rig\n" + "\n".join(lines))
    rate = None if head and len(names) > 1 else RATE
    found = recording.Recording(tmp_path / "a.csv", bearing, rpm=60 * SHAFT, rate=rate)
    wanted = names[-2:] if head else [f"column_{k + 1}" for k in range(len(names))]
    assert list(found.channels) == wanted
    assert found.signal(wanted[0 if head else -1]).values == pytest.approx(values, rel=1e-8)


def test_a_run_and_its_recording_are_one(tmp_path, lubricated):
    """If a column of a run is written to a file and read back, its spectrum is bitwise identical
    and has the same lines."""
    run = raceway.open(synthetic.write(tmp_path / "run", lubricated))
    values = spectrum.signal_of(run, "shift")
    sample_s = run.settings["sample_s"]
    np.savez(tmp_path / "shift.npz", shift=values)
    rpm = run.motion.shaft * 30 / np.pi
    same = recording.Recording(tmp_path / "shift.npz", run.geometry, rpm=rpm, rate=1 / sample_s)
    own, other = spectrum.of_run(run), spectrum.of_run(same, "shift")
    assert np.array_equal(own, other)
    assert {key: place[0] for key, place in spectrum.places(run, own=False).items()} == (
        pytest.approx({key: place[0] for key, place in spectrum.places(same).items()}, rel=1e-6)
    )


def test_length_of_a_spall_in_a_recording(tmp_path, bearing):
    """`passages.find` detects a ball that passes over two edges within 2 ms."""
    rpm, rate = 300.0, 1e5
    np.savez(tmp_path / "quiet.npz", a=np.zeros(64))
    period = (
        1
        / spectrum.places(
            recording.Recording(tmp_path / "quiet.npz", bearing, rpm=rpm, rate=rate), harmonics=1
        )["BPFO", 1][1]
    )
    time = np.arange(40000) / rate
    way = np.maximum(1 - np.abs((time - 0.03) % period - 0.02) / 2e-3, 0)
    np.savez(tmp_path / "passes.npz", a=-(way**2))
    of = recording.Recording(tmp_path / "passes.npz", bearing, rpm=rpm, rate=rate)
    assert 1e3 * passages.of_run(of, "outer", "a").seconds == pytest.approx(2.0, abs=0.02)


def test_no_speed_from_what_is_no_shaft(bearing):
    """Neither mains hum near the second harmonic nor noise is mistaken for the shaft speed."""
    time = np.arange(48000) / RATE
    noise = np.random.default_rng(5).normal(size=len(time))
    assert shaft_speed.find(np.sin(2 * np.pi * 60 * time) + 0.1 * noise, 1 / RATE, 29.9) is None


@pytest.mark.parametrize(
    "name, write, words, says",
    [
        ("a.csv", None, {}, "there is no file"),
        ("a.dat", lambda path: path.write_text("1"), {}, r"must end in \.mat"),
        ("a.mat", lambda path: path.write_text("nothing"), {}, "is not a MATLAB file"),
        ("a.mat", lambda path: io.savemat(path, {"A": 1}), {}, "has A: only X"),
        ("a.csv", lambda path: path.write_text(""), {}, "cannot read"),
        ("a.npz", lambda path: path.write_text("nothing"), {}, "cannot read"),
        ("a.wav", lambda path: path.write_text("nothing"), {}, "cannot read"),
        ("a.npz", lambda path: np.savez(path, a=np.ones(64)), {}, "not state its sampling rate"),
        ("a.npz", lambda path: np.savez(path, a=np.ones(64)), {"rate": 1e3}, "speed of the shaft"),
        ("a.npz", lambda path: np.savez(path, a=[1, np.nan]), {}, "not finite"),
        ("a.csv", lambda path: path.write_text("t,a\n0,1\n1,2\n5,3\n"), {}, "equal steps"),
        ("a.csv", lambda path: path.write_text("t,a\n0,1\n1,x\n2,3\n"), {}, "not a row of numbers"),
        ("acc_00001.csv", lambda path: path.write_text("1,2\n3,4\n"), {}, "has 2 columns"),
    ],
)
def test_files_that_it_refuses(tmp_path, bearing, name, write, words, says):
    if write:
        write(tmp_path / name)
    with pytest.raises(RunError, match=says):
        recording.Recording(tmp_path / name, bearing, **words)


def test_command(tmp_path, capsys):
    cwru(tmp_path / "130.mat", struck())
    words = ["measured", str(tmp_path / "130.mat"), "--bearing", "6205", "--rate", f"{RATE}"]
    for kind in ("lines", "time"):
        out = tmp_path / f"{kind}.png"
        assert main([*words, "--json", "--kind", kind, "--out", str(out)]) == 0
        assert out.stat().st_size > 10_000
    said = capsys.readouterr().out
    said = json.loads(said[: len(said) // 2])
    assert said["rpm"] == pytest.approx(60 * SHAFT, rel=3e-5) and said["rpm_nominal"] == 1797
    assert [one["name"] for one in said["channels"]] == ["DE", "BA"]
    assert said["channels"][0]["rms"] == pytest.approx(struck().std(), rel=1e-6)
    assert main(words) == 0
    assert "BPFO x3" in capsys.readouterr().out
    assert main([*words, "--channel", "FE"]) == 1
    assert "has no channel FE; it has DE, BA" in capsys.readouterr().err
