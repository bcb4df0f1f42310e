# SPDX-License-Identifier: GPL-2.0-or-later
"""Values and lines are found in recordings in the formats of public data sets. The tests generate
the recordings."""

import json

import numpy as np
import pytest
import raceway
import synthetic
from commands import answer, reply
from raceway import envelope, inputs, kinematics, passages, recording, shaft_speed, spectrum
from raceway.cli import main
from raceway.datasets import make
from raceway.errors import RunError
from raceway.recordings import orders
from raceway.recordings.contents import GRAVITY, POUND
from raceway.runs.source import Signal
from raceway.sweeps.points import Point
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


def told(path, name, value):
    """A file of MFPT with another `value` of one of its numbers."""
    numbers = {"sr": RATE, "load": 100, "rate": 30, name: value}
    io.savemat(path, {"bearing": {"gs": np.ones((64, 1)), **numbers}})


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
    words = ["measured", str(tmp_path / "a.csv"), "--bearing", "6205"]
    said = []
    for speed in (["--nominal", "1800"], ["--rpm", f"{60 * SHAFT}"]):
        said.append(answer(capsys, [*words, *speed]))
    assert said[0]["rpm_nominal"] == 1800
    for one, other in zip(*(given["lines"] for given in said)):
        assert all(one[key] == other[key] for key in ("name", "note", "found_Hz"))


@pytest.mark.parametrize("scale", [1e-120, 1.0, 1e120])
def test_level_scales_with_the_signal(scale):
    """A level has the unit of the signal, but its kurtosis has none, however large the values."""
    noise = np.random.default_rng(1).normal(2.0, 3.0, 100000)
    noise /= noise.std() / 3.0
    found = recording.level(Signal(scale * noise, 1e-4, {}))
    assert found.rms == pytest.approx(3.0 * scale, rel=1e-12, abs=0)
    assert found.peak == pytest.approx(scale * np.abs(noise - noise.mean()).max(), rel=1e-9, abs=0)
    assert found.kurtosis == pytest.approx(3.0, abs=0.1)


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


def test_a_nominal_speed_is_not_the_true_one(tmp_path, bearing, capsys):
    """If no lines of the shaft are found, the speed is said to be nominal, and an order is as
    uncertain as this speed."""
    rng, time = np.random.default_rng(4), np.arange(int(2 * RATE)) / RATE
    since = (ORDER * SHAFT * time) % 1 / (ORDER * SHAFT)
    ringing = np.exp(-1500 * since) * np.sin(2 * np.pi * 4000 * since)
    np.savez(tmp_path / "a.npz", a=ringing + 0.02 * rng.normal(size=len(time)))
    words = ["measured", str(tmp_path / "a.npz"), "--bearing", "6205", "--rate", f"{RATE}"]
    assert "shaft 1800 rpm, nominal: the true speed is unknown" in reply(
        capsys, [*words, "--nominal", "1800"]
    )
    assert "shaft 1800 rpm\n" in reply(capsys, [*words, "--rpm", "1800"])
    for words, source, share in (({"nominal": 1800}, "nominal", 8e-3), ({"rpm": 1800}, "given", 0)):
        found = recording.Recording(tmp_path / "a.npz", bearing, rate=RATE, **words)
        one = orders.of_recording(found)["BPFO"]
        assert found.speed_from == source
        assert found.title.endswith("1800 rpm nominal" if source == "nominal" else "1800 rpm")
        assert share * one.value <= one.uncertainty <= (share + 2e-3) * one.value


def test_a_measured_speed_is_not_nominal(tmp_path, bearing):
    """A file of Paderborn University contains the measured speed, which counts if the signal shows
    no lines of the shaft. A nominal speed that the user gives takes precedence."""
    noise = np.random.default_rng(4).normal(size=int(RATE))
    file = tmp_path / "N15_M07_F10_KA01_1.mat"
    paderborn(file, noise)
    found = recording.Recording(file, bearing)
    assert found.speed is None and found.speed_from == "file"
    assert found.rpm == pytest.approx(60 * SHAFT) and found.speed_uncertainty == 0
    assert recording.Recording(file, bearing, nominal=1800).speed_from == "nominal"


def test_the_speed_of_a_data_set_is_exact(tmp_path, bearing, capsys):
    """A file of `raceway dataset` states the speed of its run, unlike a file of CWRU, whose speed
    is nominal."""
    noise = np.random.default_rng(4).normal(size=int(RATE))
    one = make.Record(7, Point("0007", {}), {"flaw": "none", "load": 500.0}, 60 * SHAFT)
    make._save_matlab(tmp_path / "0007.mat", one, int(RATE), noise)
    cwru(tmp_path / "130.mat", noise)
    words = ["measured", str(tmp_path / "0007.mat"), "--bearing", "6205"]
    said = answer(capsys, words)
    assert said["rpm"] == 60 * SHAFT and (said["rpm_from"], said["load_N"]) == ("file", 500)
    assert f"shaft {60 * SHAFT:.6g} rpm, as stated in the file\n" in reply(capsys, words)
    assert recording.Recording(tmp_path / "0007.mat", bearing).speed_uncertainty == 0
    assert recording.Recording(tmp_path / "130.mat", bearing, rate=RATE).speed_from == "nominal"


def test_angle_of_a_four_point_contact_bearing(tmp_path, capsys):
    """Its lines are those at the angle of its grooves."""
    columns(tmp_path / "a.csv", struck(seconds=0.5))
    words = ["measured", str(tmp_path / "a.csv"), "--rpm", "1800", "--bearing", "QJ208"]
    said = []
    for more in ([], ["--angle", "35"]):
        said.append([one["order"] for one in answer(capsys, [*words, *more])["lines"]])
    assert said[0] == pytest.approx(said[1], rel=1e-12)


@pytest.mark.parametrize("flaw", ["BPFO", "BPFI"])
@pytest.mark.parametrize("degrees", [0, 4, 8, 10, 12, 14])
def test_a_flaw_of_one_raceway_shows_one_line(tmp_path, bearing, flaw, degrees):
    """With a contact angle, a harmonic of one raceway lies where one of the other raceway would be
    without it (a 6205 has 3 BPFO = 2 BPFI at 10.5 degrees)."""
    rolling = kinematics.frequencies(bearing, np.radians(degrees))
    order = {"BPFO": rolling.outer, "BPFI": rolling.inner}[flaw]
    np.savez(tmp_path / "one.npz", signal=struck(order=order))
    one = recording.Recording(tmp_path / "one.npz", bearing, rpm=60 * SHAFT, rate=RATE)
    found = orders.of_recording(one)
    assert list(found) == [flaw]
    assert found[flaw].harmonics == 3
    assert abs(found[flaw].value - order) < 2 * found[flaw].uncertainty


def test_no_speed_from_what_is_no_shaft(bearing):
    """Neither mains hum near the second harmonic nor noise is mistaken for the shaft speed."""
    time = np.arange(48000) / RATE
    noise = np.random.default_rng(5).normal(size=len(time))
    assert shaft_speed.find(np.sin(2 * np.pi * 60 * time) + 0.1 * noise, 1 / RATE, 29.9) is None
    hum = sum(np.sin(2 * np.pi * n * 60 * time + n) / n for n in (1, 2, 3))
    assert shaft_speed.find(hum + 0.1 * noise, 1 / RATE, 29.9) is None


@pytest.mark.parametrize("hum", [0.05, 0.5])
def test_harmonics_of_the_mains_are_not_the_shaft(hum):
    """The harmonics of 60 Hz are even harmonics of 1800 rpm, next to those of a motor at 1787 rpm:
    the speed of the motor is found."""
    time = np.arange(4 * int(RATE)) / RATE
    shaft = sum(np.sin(2 * np.pi * n * 1787 / 60 * time + n) / n for n in (1, 2, 3))
    mains = sum(np.sin(2 * np.pi * n * 60 * time + n) / n for n in (1, 2, 3))
    noise = np.random.default_rng(5).normal(size=len(time))
    found = shaft_speed.find(shaft + hum * mains + 0.1 * noise, 1 / RATE, 1797 / 60)
    assert abs(60 * found.hertz - 1787) < 3 * 60 * found.uncertainty < 0.5


@pytest.mark.parametrize(
    "name, write, words, says",
    [
        ("a.csv", None, {}, "there is no file"),
        ("a.npz", lambda path: np.savez(path, a=np.ones(64) + 1j), {}, "not a row of numbers"),
        ("a.mat", lambda path: told(path, "sr", "48k"), {}, "sr is not one number"),
        ("a.mat", lambda path: told(path, "load", [1, 2]), {}, "load is not one number"),
        ("a.mat", lambda path: told(path, "rate", []), {}, "speed of the shaft"),
        ("a.dat", lambda path: path.write_text("1"), {}, r"must end in \.mat"),
        ("a.mat", lambda path: path.write_text("nothing"), {}, "not a MATLAB file"),
        ("a.mat", lambda path: io.savemat(path, {"A": 1}), {}, "has A: only X"),
        ("a.csv", lambda path: path.write_text(""), {}, "cannot read"),
        ("a.csv", lambda path: path.write_bytes(bytes(range(256))), {}, "not a table .it has null"),
        ("a.npz", lambda path: path.write_text("nothing"), {}, "cannot read"),
        ("a.wav", lambda path: path.write_text("nothing"), {}, "cannot read"),
        ("a.npz", lambda path: np.savez(path, a=np.ones(64)), {}, "not state its sampling rate"),
        ("a.npz", lambda path: np.savez(path, a=np.ones(64)), {"rate": 1e3}, "speed of the shaft"),
        ("a.npz", lambda path: np.savez(path, a=[1, np.nan]), {}, "not finite, the first in row 2"),
        (
            "130.mat",
            lambda path: io.savemat(path, {"X130_DE_time": np.ones(64), "X130RPM": [1797, 1796]}),
            {},
            "X130RPM is not one number",
        ),
        ("a.csv", lambda path: path.write_text("t,a\n0,1\n1,2\n5,3\n"), {}, "equal steps"),
        ("a.csv", lambda path: path.write_text("t,a\n0,1\n2,2\n1,3\n3,4\n"), {}, "equal steps"),
        ("a.csv", lambda path: path.write_text("t,a\n0,1\n1,x\n2,3\n"), {}, "not a row of numbers"),
        ("a.csv", lambda path: path.write_text("a,b\n0,1,2\n1,2,4\n"), {}, "not match length"),
        ("a.csv", lambda path: path.write_text("a\n1e400\n1e400\n"), {}, "a has values that"),
        ("a.csv", lambda path: path.write_text("a #1,a #2\n0,1\n1,2\n"), {}, "not match length"),
        ("acc_00001.csv", lambda path: path.write_text("1,2\n3,4\n"), {}, "has 2 columns"),
    ],
)
def test_files_that_it_refuses(tmp_path, bearing, recwarn, name, write, words, says):
    if write:
        write(tmp_path / name)
    with pytest.raises(RunError, match=says):
        recording.Recording(tmp_path / name, bearing, **words)
    assert not list(recwarn)


@pytest.mark.parametrize("end", [0.02, 0.5, 0.98])
@pytest.mark.parametrize("name", ["105.mat", "0007.mat", "a.npz", "a.wav", "a.csv"])
def test_files_that_end_too_early(tmp_path, bearing, name, end):
    """A file that was not transferred completely is refused. Only a CSV file, which does not state
    its length, is read as far as it goes."""
    path, values = tmp_path / name, np.random.default_rng(1).normal(size=3000)
    if name == "0007.mat":
        io.savemat(path, {"X007_DE_time": values[:, None]}, do_compression=True)
    elif name == "a.npz":
        np.savez_compressed(path, DE=values)
    else:
        {"105.mat": cwru, "a.wav": wav, "a.csv": columns}[name](path, values)
    whole = path.read_bytes()
    path.write_bytes(whole[: int(end * len(whole))])
    try:
        found = recording.Recording(path, bearing, rate=RATE, rpm=1800)
    except RunError as error:
        assert str(path) in str(error)
    else:
        assert name == "a.csv" and len(found.signal().values) < len(values)


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
    assert "BPFO x3" in reply(capsys, words)
    assert "has no channel FE; it has DE, BA" in reply(capsys, [*words, "--channel", "FE"], code=1)
