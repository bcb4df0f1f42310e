# SPDX-License-Identifier: GPL-2.0-or-later
"""Results for a bearing in any orientation in the lab frame equal those for an axis along z.

Records are rotated instead of decks, because the tolerance of integrators would hide small errors.
"""

import contextlib
import io

import netCDF4
import numpy as np
import pytest
import raceway
import scenes
import turned
from circuits import MOTOR_OF_INVERTER
from fuzz.pose import Pose
from host import ROOT, deck_file, succeed
from raceway.cli import main as command
from raceway.electric import circuit
from raceway.electric.breakdown import Breakdown
from raceway.electric.leak import Leak
from raceway.runs import envelope, losses, sensor, spectrum
from recorded_runs import small
from smallest import SMALLEST

UPRIGHT = Pose()
ALONG = [Pose((1, 2, 0)), Pose((2, 0, 1))]  # with the axis along x, and along y
COMMANDS = [
    "summary run",
    "summary run --json",
    "spectrum run --json",
    "spectrum run --envelope --signal ay --ring outer",
    "export run --format vtk --every 800",
    "export run --format xyz --every 800",
]
PICTURES = ["plot run --kind bearing", "plot run --kind motion", "spectrum run --out run/lines.png"]
MOTOR = "circuit run --motor 50e-12 1e-9 --common-mode 560 2000 50 0.8 --strength 70e6 --arc 1"
CIRCUITS = [
    f"{MOTOR} --json",
    f"{MOTOR} --resistivity 1e9 --out run/discharges",
    "export run --format spice --resistivity 1e9",
    "report run",
]
ELSEWHERE = [  # turned about its own axis, mirrored, turned upside down
    Pose((1, 0, 2), (1, -1, 1), (0.013, -0.02, 0.007)),
    Pose((1, 0, 2), (1, 1, 1), (0.013, -0.02, 0.007)),
    Pose((2, 1, 0), (1, 1, 1), (0.013, -0.02, 0.007)),
    Pose((0, 2, 1), (1, -1, -1), (-0.003, 0.001, 0.02)),
    Pose((2, 0, 1), (1, 1, -1), (0.013, -0.02, 0.007)),
    Pose((0, 1, 2), (-1, 1, 1), (0.013, -0.02, 0.007)),
]


@pytest.fixture(scope="module", params=scenes.SCENES)
def scene(request, tmp_path_factory):
    """Return the name of the scene, and the folder of its run with the axis along z."""
    folder = tmp_path_factory.mktemp(request.param)
    return request.param, scenes.run(request.param, folder / "z")


def written(source, folder, pose, commands):
    """Return {command or file: its output} for the run in `source` after rotation to a `pose`."""
    turned.write(source, folder / "run", pose)
    before = {path.name for path in (folder / "run").iterdir()}
    found = {}
    with contextlib.chdir(folder):
        if commands[-1] == PICTURES[-1]:
            atoms = raceway.open("run").universe()
            found["universe"] = [atoms.atoms.positions.tolist() for _ in atoms.trajectory[::50]]
        for words in commands:
            out = io.StringIO()
            with contextlib.redirect_stdout(out), contextlib.redirect_stderr(out):
                code = command(words.split())
            found[words] = f"{code} {out.getvalue()}"
    for path in (folder / "run").rglob("*"):
        if path.is_file() and path.relative_to(folder / "run").parts[0] not in before:
            found[str(path.relative_to(folder))] = path.read_bytes()
    if "report run" in commands:  # the report states the axis
        own = f">{'xyz'[pose.axis]}</td>".encode()
        assert own in found["run/report.html"]
        found["run/report.html"] = found["run/report.html"].replace(own, b"")
    return found


def figures(folder):
    """Return {name: array} for everything that readers compute from the run in `folder`, and for
    the data of the run."""
    run = raceway.open(folder)
    run = run if len(run.bearing_numbers) == 1 else run.select(2)
    found = {
        f"summary {key}": value
        for key, value in run.summary().items()
        if isinstance(value, float) or value is None
    }
    of = {"losses": losses.losses(run), "around": losses.losses_around(run, 8)}
    caged = "cage_x" in run.tables.record.variables
    parts = ("contacts", "balls", "rings", "bearing", *["cage"][:caged])
    for name, data in {**of, **{name: getattr(run, name) for name in parts}}.items():
        numbers = [key for key in data.variables if data[key].dtype.kind == "f"]
        found |= {f"{name} {key}": data[key].to_numpy() for key in numbers}
    found |= of_circuit(run) if "capacitance_total" in run.contacts else {}
    shift = spectrum.of_run(run)
    found["spectrum"] = shift.to_numpy()
    for line in spectrum.lines(run, shift):
        found |= {
            f"line {line.name} {line.harmonic} {key}": value
            for key, value in line._asdict().items()
            if isinstance(value, float) and key != "prominence"  # relative to rounding errors
        }
    return found | of_data_set(run)


def of_data_set(run):
    """Return {name: array} for the quantities of `run` in a data set: lines of the bearing and
    sensor signals."""
    found = {
        f"label {line}": np.array(place)
        for (line, _), place in spectrum.places(run, harmonics=1).items()
    }
    for name in ("ax", "ay", "az"):
        with contextlib.suppress(raceway.errors.RunError):  # the ring does not move along this axis
            found[f"sensor {name}"] = sensor.of_run(run, name, "inner").to_numpy()
    return found


def of_circuit(run):
    """Return {name: array} for the circuit of an inverter with the bearing of `run`, including
    discharges."""
    result = circuit.run(run, MOTOR_OF_INVERTER, Breakdown(70e6, arc=1.0), Leak(1e9))
    assert len(result.events) > 10
    tables = {"circuit": result.data, "event": result.events}
    return {
        f"{part} {name}": table[name].to_numpy()
        for part, table in tables.items()
        for name in table
        if table[name].dtype.kind == "f" and name != "charge_error"  # a rounding error
    }


VECTORS = {  # {name with {} for x, y, z: True if the vector is axial}
    "{}": False,
    "v{}": False,
    "a{}": False,
    "f{}": False,
    "omega{}": True,
    "m{}": True,
    "force_{}_N": False,
    "shift_{}_m": False,
    "moment_{}_N_m": True,
    "tilt_{}_rad": True,
}
COST = {"wall_s", "processor_s", "real_time_factor"}
ABOUT_AXIS = {"spin", "cage_speed", "cage_speed_rad_s", "rpm_inner", "rpm_outer", "from_load_line"}


def moved(found, pose):
    """Return the results `found` in a scene with a `pose`, converted to the frame of the
    bearing."""
    new = {}
    for name, values in found.items():
        part, _, key = name.partition(" ")
        new[name] = values
        for form, axial in VECTORS.items():
            k = next((k for k in range(3) if form.format("xyz"[k]) == key), None)
            if k is not None:
                own = pose.axes.index(k)
                sign = pose.signs[own] * (pose.hand if axial else 1)
                source = found[f"{part} {form.format('xyz'[own])}"]
                new[name] = None if source is None else sign * source
        if part == "rings" and key.startswith("tilt_"):
            own = pose.axes.index(int(key[-1]) - 1)
            new[name] = pose.hand * pose.signs[own] * found[f"rings tilt_{own + 1}"]
        if (key in ABOUT_AXIS and part != "around") or name in ("rings angle", "rings torque"):
            new[name] = pose.sense * values
        if key == "azimuth":
            new[name] = turned.wrapped(pose.sense * values + pose.azimuth(0))
        if name in ("contacts angle", "summary axial_N") and values is not None:
            new[name] = pose.signs[2] * values
        if part == "around" and pose.sense < 0 and np.ndim(values) == 2:
            new[name] = values[:, ::-1]
        if part == "contacts" and pose.signs[2] < 0 and np.shape(values)[1:2] == (4,):
            new[name] = new[name][:, [1, 0, 3, 2]]
    return new


def worst(found, wanted):
    """Return [(error relative to the largest value or to the largest of the vector, name)] for
    results that differ by more than 1e-12."""
    wrong = []
    for name, one in wanted.items():
        if one is None or found[name] is None:
            if one is not found[name]:
                wrong.append((np.inf, name))
            continue
        one, other = np.asarray(one, float), np.asarray(found[name], float)
        apart = other - one
        if name.endswith(("azimuth", "from_load_line")):
            apart = turned.wrapped(apart)
        scale = max(largest(wanted[k]) for k in components(name, wanted)) or 1
        share = largest(apart) / scale
        if (np.isnan(one) != np.isnan(other)).any() or share > 1e-12:
            wrong.append((share, name))
    return sorted(wrong, reverse=True)


def largest(values):
    values = np.asarray(values if values is not None else 0.0, float)
    return float(np.abs(values[np.isfinite(values)]).max(initial=0))


def components(name, known):
    """Return the names of all components of the vector that contains `name`, or of all values of
    the spectrum that contains it, or `name` alone."""
    part, _, key = name.partition(" ")
    if part == "line" and key.endswith("amplitude"):
        return ["spectrum"]
    for form in VECTORS:
        names = [f"{part} {form.format(x)}" for x in "xyz"]
        if name in names:
            return [one for one in names if one in known]
    return [name]


def test_elsewhere(scene, tmp_path):
    name, source = scene
    pose = ELSEWHERE[[*scenes.SCENES].index(name) % len(ELSEWHERE)]
    turned.write(source, tmp_path / "there", pose)
    found = figures(tmp_path / "there")
    wanted = moved(figures(source), turned.own_frame(pose))
    assert found.keys() == wanted.keys()
    assert worst(found, wanted) == []


def test_axis(scene, tmp_path):
    name, source = scene
    number = [*scenes.SCENES].index(name)
    more = {"combined": PICTURES, "circuit": CIRCUITS}.get(name, [])
    bearing = " --bearing 2" if name == "rows" else ""
    commands = [f"{words}{bearing}" for words in COMMANDS + more]
    upright, found = (
        written(source, tmp_path / str(k), pose, commands)
        for k, pose in enumerate((UPRIGHT, ALONG[number % 2]))
    )
    assert upright[commands[0]].startswith("0"), upright[commands[0]]
    assert found.keys() == upright.keys()
    assert [key for key in upright if found[key] != upright[key]] == []


def test_run_about_x(tmp_path):
    """If the same scene runs with its axis along z and along x, all results except the cost
    agree."""
    change = [("run 2000", "run 500")]
    about_x = [
        ("bearing/ehd ", "bearing/ehd axis x "),
        ("x free y free", "y free z free"),
        ("force 0 -500 0", "force 0 0 -500"),
    ]
    found = []
    for name, changes in (("z", change), ("x", change + about_x)):
        deck = tmp_path / f"{name}.deck"
        deck.write_text(scenes.changed("in.unbalance", changes))
        succeed(deck, out=tmp_path / name)
        found.append(figures(tmp_path / name))
    z, x = found
    kept = {name: value for name, value in z.items() if name.split()[-1] not in COST}
    assert [one for one in worst(x, kept) if one[0] > 1e-9] == []


def test_plain_deck_about_x(tmp_path):
    """In the main deck with *axis* in its pair style, the results for warming, a one-piece cage and
    the record are bitwise identical, except for the order of the axes."""
    words = {"lubricant": "vg46", "rpm": 3000, "models": "full", "cage": "ring", "heat": "yes"}
    words |= {"passes": 1, "samples": 40, "axial": 300, "warm_time": 20}
    text = (ROOT / "inputs" / "in.6208").read_text()
    found, heat = [], []
    for axis in "zx":
        deck = deck_file(
            tmp_path,
            text.replace("pair_style bearing oil", f"pair_style bearing axis {axis} oil"),
            f"in.{axis}",
        )
        succeed(deck, out=tmp_path / axis, **words)
        found.append(figures(tmp_path / axis))
        heat.append((tmp_path / axis / "heat.txt").read_text())
    z, x = found
    assert heat[0] == heat[1] and heat[0].count("\n") > 3
    kept = {name: value for name, value in z.items() if name.split()[-1] not in COST}
    assert worst(x, kept) == []


def test_direction_without_a_load(tmp_path):
    """A radial load of the size of rounding errors has no direction, so the direction of the
    displacement is used instead."""
    end = succeed(small(tmp_path, deck=SMALLEST.replace("run 20000", "run 500")), out=tmp_path)
    assert end.code == 0
    found = []
    for number, pose in enumerate((UPRIGHT, *ELSEWHERE[:2])):
        folder = turned.write(tmp_path / "run", tmp_path / str(number), pose)
        with netCDF4.Dataset(folder / "record.nc", "a") as record:
            for k, name in enumerate(("fx", "fy", "fz")):
                record[f"ring_{name}"][...] = 1e-13 * (number + k) if k < 2 else 500.0
        found.append(raceway.open(folder).summary()["ring_shift_m"])
    assert found[0] > 1e-7
    assert found[1:] == pytest.approx(found[:1] * 2, rel=1e-12)


def test_run_up_names_the_spall(tmp_path):
    """In in.run_up, BPFO is found in the order spectrum, at the value calculated from the cage
    speed in the run."""
    folder = tmp_path / "run"
    deck = tmp_path / "deck"
    deck.write_text(scenes.changed("in.run_up", [("run 15000", "run 8000")]))
    succeed(deck, out=folder)
    run = raceway.open(folder)
    found = envelope.of_run(run, "ay", ring="outer")
    bpfo = [one for one in spectrum.lines(run, found) if one.name == "BPFO"]
    assert all(one.unit == "order" and not one.note for one in bpfo), bpfo
    assert [one.found for one in bpfo] == pytest.approx([one.by_cage for one in bpfo], rel=2e-3)
