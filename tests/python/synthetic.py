# SPDX-License-Identifier: GPL-2.0-or-later
"""Write the record of a run without a simulation. Every sample is a solution of statics with balls
that roll without slip and with the film formulas."""

import re

import netCDF4
import numpy as np
from bearings import B6208
from raceway import capacitance, columns, core, film, hertz, kinematics, static
from raceway.theory.bearing import INNER, OUTER

MECHANICAL = (
    "ball ring raceway azimuth angle overlap load normal damping a b pressure "
    "entrainment sliding mu friction friction_power damping_power"
).split()
LUBRICATED = MECHANICAL + "h_min h_c lambda regime capacitance".split()
BALL_COLUMNS = "id type x y z vx vy vz omegax omegay omegaz".split()
RING_COLUMNS = "step time x y z vx vy vz spin fx fy fz mx my mz".split()
LOSS = (1e-6, 2e-6)  # W/N, friction loss and damping loss per unit of load (arbitrary values)
OIL = {
    "viscosity_Pa_s": 0.04,
    "pressure_viscosity_per_Pa": 22e-9,
    "permittivity": 2.2,
    "roughness_m": 1.5e-7,
}


def run(
    load=5000.0,
    rpm=477.5,
    clearance=0.0,
    oil=OIL,
    load_azimuth=-np.pi / 2,
    passes=2,
    samples_per_pass=24,
    bearing=B6208,
):
    """Return a run as plain data: `settings`, `contacts` and `balls` with one frame per sample, and
    `rings` with one row per sample."""
    spin = rpm * np.pi / 30
    cage = spin * kinematics.frequencies(bearing).cage
    sample_s = 2 * np.pi / bearing.balls / cage / samples_per_pass
    z, inner_ring, outer_ring = bearing.balls, 2 * bearing.balls + 1, 2 * bearing.balls + 2
    contacts, balls, rings = [], [], []  # mz is the shaft torque that supplies the dissipated power
    for sample in range(passes * samples_per_pass + 1):  # both ends of the measured window
        state = static.equilibrium(
            bearing,
            load,
            clearance=clearance,
            load_azimuth=load_azimuth,
            phase=0.1 + cage * sample_s * sample,
        )
        contacts.append(
            [row for side in (INNER, OUTER) for row in _rows(bearing, state, side, spin, oil, z)]
        )
        balls.append(_atoms(bearing, state, cage, spin, inner_ring, outer_ring))
        lost = sum(sum(LOSS) * row[6] for row in contacts[-1])
        rings.append(
            [sample * 100, sample * sample_s, *state.shift, 0, 0, 0, spin]
            + [*state.force, *state.moment[:2]]
            + [-lost / spin]
        )
    settings = {
        "bearing": "6208",
        "lubricant": "mineral" if oil else "dry",
        "host": "liggghts",
        "integrator": "implicit",
        "models": "paper",
        "load_N": load,
        "rpm": rpm,
        "clearance_m": clearance,
        "step_s": 1e-06,
        "passes": passes,
        "wall_s": 2.5,
        "processor_s": 2.25,
        "evaluations": 1234.0,
        "simulated_s": rings[-1][1],
        "balls": z,
        "ball_diameter_m": bearing.ball_diameter,
        "ball_young_Pa": bearing.young,
        "ball_poisson": bearing.poisson,
        "inner_radius_m": bearing.inner_radius,
        "outer_radius_m": bearing.outer_radius,
        "inner_groove_m": bearing.inner_groove,
        "outer_groove_m": bearing.outer_groove,
        "load_azimuth_rad": load_azimuth,
        "sample_s": sample_s,
        "samples_per_pass": samples_per_pass,
        **({**oil, "temperature_C": 40.0} if oil else {}),
        "contact_columns": " ".join(LUBRICATED if oil else MECHANICAL),
        "inner_ring": inner_ring,
        "outer_ring": outer_ring,
    }
    return {"settings": settings, "contacts": contacts, "balls": balls, "rings": rings}


def _rows(bearing, state, side, spin, oil, z):
    part = (state.inner, state.outer)[side]
    speed = kinematics.entrainment(bearing, spin)
    for i in np.flatnonzero(part.load > 0):
        azimuth = np.mod(state.azimuth[i] + np.pi, 2 * np.pi) - np.pi
        load, pressure, a, b = (getattr(part, name)[i] for name in ("load", "pressure", "a", "b"))
        row = [i + 1, 2 * z + 1 + side, side, azimuth, part.angle[i], part.overlap[i], load, load]
        row += [100.0, a, b, pressure, speed, 0.0]
        row += [0.05 if oil else 0.1, 0.0, *(load * loss for loss in LOSS)]
        if oil:
            viscosity, pressure_viscosity, permittivity, roughness = oil.values()
            r_x, r_y = bearing.effective_radii(side)
            of = bearing.effective_modulus, r_x, hertz.exact(r_x, r_y).kappa, speed, load
            group = film.group(viscosity, pressure_viscosity, *of)
            h_min, h_c = film.h_min(r_x, group), film.h_c(r_x, group)
            ratio = film.ratio(h_min, roughness)
            row += [h_min, h_c, ratio, film.regime(ratio)]
            row += [capacitance.contact(permittivity, pressure, a, b, h_c)]
        yield row


def _atoms(bearing, state, cage, spin, inner_ring, outer_ring):
    z, radius, rows = bearing.balls, bearing.pitch_radius, []
    for kind, offset in ((1, 0.0), (2, np.pi / z)):
        for i, azimuth in enumerate(state.azimuth + offset):
            x, y = radius * np.cos(azimuth), radius * np.sin(azimuth)
            # the results must not depend on the speed of cage balls
            turn = cage * (1 if kind == 1 else 7)
            own = cage - spin * kinematics.frequencies(bearing).spin
            rows.append([i + 1 + (kind - 1) * z, kind, x, y, 0, -turn * y, turn * x, 0, 0, 0, own])
    rows.append([inner_ring, 3, *state.shift, 0, 0, 0, 0, 0, spin])
    rows.append([outer_ring, 4] + [0.0] * 9)
    return rows[::-1]  # in no particular order


def changed(data, **settings):
    """Return `data` with some of its settings replaced."""
    return {**data, "settings": {**data["settings"], **settings}}


def shaken(folder, data, time, x, y, spin, **settings):
    """Write `data` with an inner ring at the arrays `x` and `y` that turns at `spin`, in rad/s, and
    with some of its settings replaced."""
    rows = np.zeros((len(time), len(RING_COLUMNS)))
    rows[:, 0] = 100 * np.arange(1, len(time) + 1)
    for name, values in dict(time=time, x=x, y=y, spin=spin).items():
        rows[:, RING_COLUMNS.index(name)] = values
    return write(folder, dict(changed(data, **settings), rings=rows))


def spoil(folder, pattern, replacement):
    """Replace the line of run.yaml that matches `pattern`."""
    path = folder / "run.yaml"
    text, count = re.subn(pattern, replacement, path.read_text(), count=1, flags=re.MULTILINE)
    assert count == 1
    path.write_text(text)


# ---- the record --------------------------------------------------------------------------------

NUMBERS = (  # settings that appear as attributes of the file and as entries in run.yaml
    "load_N axial_N rpm passes samples_per_pass load_azimuth_rad balls ball_diameter_m"
    " inner_radius_m outer_radius_m inner_groove_m outer_groove_m clearance_m ball_young_Pa"
    " ball_poisson viscosity_Pa_s pressure_viscosity_per_Pa permittivity roughness_m temperature_C"
    " inner_ring outer_ring sample_s"
).split()
WORDS = "bearing lubricant integrator models host".split()
END = "step_s evaluations processor_s simulated_s wall_s".split()
TABLES = core.table("columns")
MASS = 8.2e-3  # kg, mass of a ball


def write(folder, data, end=True):
    """Write `data`, as returned by `run`, to `folder`: record.nc in the layout of fix
    bearing/record, and run.yaml. Each row of `rings` is a sample. When the frames of contacts and
    balls are exhausted, they are repeated from the start. If `end` is false, the run is marked as
    still active."""
    folder.mkdir(parents=True, exist_ok=True)
    settings = data["settings"]
    words = {"title": "ball bearing run", **{name: settings[name] for name in WORDS}, "axis": "z"}
    numbers = {name: np.float64(settings[name]) for name in NUMBERS if name in settings}
    last = {name: settings[name] for name in END} | {
        "simulated_s": len(data["rings"]) and data["rings"][-1][1]
    }
    # a deck prints numbers as C does: 1e-06, not 1.0e-06
    told = words | {k: f"{v:.17g}" for k, v in (numbers | (last if end else {})).items()}
    (folder / "run.yaml").write_text("".join(f"{k}: {v}\n" for k, v in told.items()))
    with netCDF4.Dataset(folder / "record.nc", "w", format="NETCDF3_64BIT_OFFSET") as file:
        file.setncatts(words | numbers)
        samples = _fill(file, data, end)
    # write all samples at once, because netCDF would write each variable of each sample separately
    with open(folder / "record.nc", "r+b") as file:
        file.seek(4)
        file.write(len(samples).to_bytes(4, "big"))
        file.seek(-samples.itemsize if len(samples) else 0, 2)
        samples.tofile(file)
    return folder


def _fill(file, data, end):
    """Define all variables, write the first sample and the variables without a time dimension, and
    return all samples in the order in which the file stores them."""
    settings, count = data["settings"], len(data["rings"])
    file.set_auto_maskandscale(False)
    file.set_fill_off()
    z = settings["balls"]
    rings = np.array(data["rings"], dtype=float).reshape(count, len(RING_COLUMNS))
    places = _places(data, count)
    caged = places["cage_ball"].shape[1] > 0
    sizes = {"time": None, "raceway": 2, "ball": z, "ring": 2, "bearing": 1}
    sizes |= {"cage_ball": z} if caged else {}
    for name, size in {**sizes, "letters": 5}.items():
        file.createDimension(name, size)

    # values are written after the last definition, because each definition moves all existing
    # values
    pending = []

    def put(name, dimensions, values, column=None, kind="f8"):
        variable = file.createVariable(name, kind, dimensions)
        if column:
            variable.setncatts({"units": column["unit"] or "1", "long_name": column["meaning"]})
        pending.append((variable, values, dimensions[:1] == ("time",)))

    def fixed(name, dimensions, values, meaning, unit="", kind="i4"):
        put(name, dimensions, values, {"unit": unit, "meaning": meaning}, kind)

    put("raceway", ("raceway", "letters"), np.array(["inner", "outer"]), kind="S1")
    file["raceway"].setncattr("_Encoding", "utf-8")
    fixed("finished", (), int(end), "1 if the run has reached its end")
    atoms = {"ball": np.arange(z) + 1, "cage_ball": np.arange(z) + z + 1, "ring": 2 * z + 1}
    for kind, ids in ((kind, ids) for kind, ids in atoms.items() if kind in sizes):
        fixed(kind, (kind,), ids + np.arange(2) if kind == "ring" else ids, _ATOM[kind])
        fixed(f"{kind}_bearing", (kind,), 1, "its bearing")
    fixed("ring_raceway", ("ring",), [0, 1], "0 inner, 1 outer, 2 one-piece cage")
    for axis in "xyz":
        where = "position of the ring at the start"
        fixed(f"ring_origin_{axis}", ("ring",), 0.0, where, "m", "f8")
    fixed("bearing", ("bearing",), 1, "number of a bearing")
    kind = _kind(settings, caged)
    for column in TABLES["kind"]:
        if not column["name"].endswith("_arch"):
            put(column["name"], ("bearing",), kind[column["name"]], column)

    put(
        "time",
        ("time",),
        rings[:, 1],
        {"unit": "s", "meaning": "time since the start of the record"},
    )
    put("step", ("time",), rings[:, 0], {"unit": "", "meaning": "step of the host"})
    contacts = _contacts(data, count)
    for column in TABLES["contact"]:
        if column["name"] in contacts:
            put(column["name"], ("time", "raceway", "ball"), contacts[column["name"]], column)
    for k, column in enumerate(TABLES["atom"][2:]):
        for prefix, ids in (("ball", "ball"), ("cage", "cage_ball"))[: 1 + caged]:
            put(f"{prefix}_{column['name']}", ("time", ids), places[ids][..., k], column)
    moving = _rings(rings, places["ring"])
    for column in TABLES["ring"]:
        if column["name"] in moving:
            put(f"ring_{column['name']}", ("time", "ring"), moving[column["name"]], column)
    sums = _sums(contacts, places)
    for column in TABLES["bearing"]:
        if column["name"] in sums:
            put(f"bearing_{column['name']}", ("time", "bearing"), sums[column["name"]], column)
    moving = [(variable, values) for variable, values, over_time in pending if over_time]
    shapes = [(variable.name, ">f8", values.shape[1:]) for variable, values in moving]
    samples = np.empty(count, shapes)
    for variable, values in moving:
        samples[variable.name] = values
        variable[: min(count, 1)] = values[:1]
    for variable, values, over_time in pending:
        if not over_time:
            variable[...] = values
    return samples


_ATOM = {
    "ball": "atom number of a ball",
    "cage_ball": "atom number of a cage ball",
    "ring": "atom number of a ring",
}


def _kind(settings, caged):
    """Return {name in the file: value} for the constant properties of the bearing."""
    of = {column["name"]: np.nan for column in TABLES["kind"]}
    known = {name.rsplit("_", 1)[0]: value for name, value in settings.items() if name in NUMBERS}
    of |= {name: value for name, value in known.items() if name in of}
    return of | {
        "balls": settings["balls"],
        "outer_radius": settings["outer_radius_m"] + settings["clearance_m"] / 2,
        "cage_balls": settings["balls"] if caged else 0,
        "cage_ball_diameter": 8.38e-3 if caged else np.nan,
        "ball_mass": MASS,
        "ring_young": settings["ball_young_Pa"],
        "ring_poisson": settings["ball_poisson"],
        "viscosity": settings.get("viscosity_Pa_s", np.nan),
        "pressure_viscosity": settings.get("pressure_viscosity_per_Pa", np.nan),
        "permittivity": settings.get("permittivity", np.nan),
        "ring_roughness": settings.get("roughness_m", np.nan),
        "ball_roughness": 0.0 if "roughness_m" in settings else np.nan,
    }


def _contacts(data, count):
    """Return {column: array (time, raceway, ball)}."""
    names, z = data["settings"]["contact_columns"].split(), data["settings"]["balls"]
    frames = data["contacts"]
    found = {
        column["name"]: np.full((len(frames), 2, z), columns.CONTACT[column["name"]].absent)
        for column in TABLES["contact"]
        if column["name"] in names[3:]
    }
    for sample, frame in enumerate(frames):
        for ball, _, raceway, *values in frame:
            for name, value in zip(names[3:], values):
                found[name][sample, raceway, ball - 1] = value
    return {name: values[np.arange(count) % len(frames)] for name, values in found.items()}


def _places(data, count):
    """Return {kind of atom: array (time, atom, component)}, where the components are position,
    velocity and spin."""
    z = data["settings"]["balls"]
    table = np.array([sorted(frame, key=lambda row: row[0]) for frame in data["balls"]])
    table = table[np.arange(count) % len(table), :, 2:]
    return {"ball": table[:, :z], "cage_ball": table[:, z:-2], "ring": table[:, -2:]}


def _rings(rings, places):
    """Return {column: array (time, inner and outer)}. Forces and moments on the outer ring are
    opposite to those on the inner ring."""
    found = {}
    for name, values in zip(RING_COLUMNS[2:], rings.T[2:]):
        found[name] = np.column_stack([values, -values if name[0] in "fm" else 0 * values])
    for k, name in enumerate(RING_COLUMNS[2:8]):
        found[name][:, 1] = places[:, 1, k]
    spin = found["spin"][:, 0]
    turned = np.cumsum(np.diff(rings[:, 1], prepend=rings[:1, 1]) * (spin + np.roll(spin, 1)) / 2)
    turned = np.column_stack([turned, 0 * turned])
    nothing = dict.fromkeys(("tilt_1", "tilt_2", "ax", "ay", "az"), np.zeros_like(turned))
    return {**found, "angle": turned, "torque": found["mz"], **nothing}


def _sums(contacts, places):
    """Return {column of the bearing: array (time, 1)}."""
    load = contacts["load"]
    live, samples = load > 0, np.arange(len(load))
    top = load[:, 0].argmax(axis=1)

    def least(name):
        values = np.where(live, contacts[name], np.inf).min(axis=(1, 2))
        return np.where(live.any(axis=(1, 2)), values, np.nan)

    def at_top(name):
        return np.where(live[:, 0].any(axis=1), contacts[name][samples, 0, top], np.nan)

    way = places["ball"] - places["ring"][:, 1:]
    x, y, vx, vy = (way[..., k] for k in (0, 1, 3, 4))
    found = {
        "contacts": live.sum(axis=(1, 2)),
        "loaded_balls": live.all(axis=1).sum(axis=1),
        "load_inner": load[:, 0].max(axis=1),
        "load_outer": load[:, 1].max(axis=1),
        "pressure_inner": contacts["pressure"][:, 0].max(axis=1),
        "pressure_outer": contacts["pressure"][:, 1].max(axis=1),
        "cage_speed": ((x * vy - y * vx) / (x**2 + y**2)).mean(axis=1),
        "friction_power": contacts["friction_power"].sum(axis=(1, 2)),
        "damping_power": contacts["damping_power"].sum(axis=(1, 2)),
        "entrainment_top": at_top("entrainment"),
    }
    if places["cage_ball"].shape[1]:
        found |= dict.fromkeys(("cage_power", "cage_force"), np.zeros(len(load)))
    if "h_min" in contacts:
        both = live.all(axis=1)
        parts = np.where(live, contacts["capacitance"], 1.0)
        series = np.where(both, 1 / (1 / parts[:, 0] + 1 / parts[:, 1]), 0.0)
        found |= {"h_min": least("h_min"), "lambda": least("lambda")}
        found |= {f"{name}_top": at_top(name) for name in ("h_min", "lambda", "h_c")}
        found |= {"capacitance": series.sum(axis=1), "capacitance_top": series.max(axis=1)}
    return {name: values[:, None] for name, values in found.items()}
