# SPDX-License-Identifier: GPL-2.0-or-later
"""Writes a run folder without a simulation: static theory at every sample, rolling without slip,
film formulas."""

import numpy as np
from raceway import capacitance, film, hertz, kinematics, static
from raceway.theory.bearing import INNER, OUTER, Bearing

# the paper's 6208
DEEP_GROOVE = Bearing(
    balls=9,
    ball_diameter=12.6e-3,
    inner_radius=24e-3,
    outer_radius=36.6e-3,
    inner_groove=6.552e-3,
    outer_groove=6.552e-3,
)
MECHANICAL = (
    "ball ring raceway azimuth angle overlap load normal damping a b pressure "
    "entrainment sliding mu friction friction_power damping_power"
).split()
LUBRICATED = (
    MECHANICAL[:-4]
    + "h_min h_c lambda regime mu friction friction_power damping_power capacitance".split()
)
BALL_COLUMNS = "id type x y z vx vy vz omegax omegay omegaz".split()
RING_COLUMNS = "step time x y z vx vy vz spin fx fy fz mx my mz".split()
LOSS = (1e-6, 2e-6)  # W of friction and damping per N of load, made up
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
    bearing=DEEP_GROOVE,
):
    """The run as plain data: `settings`, `contacts` and `balls` (a frame a sample), `rings` (a row
    a sample)."""
    spin = rpm * np.pi / 30
    cage = spin * kinematics.frequencies(bearing).cage
    sample_s = 2 * np.pi / bearing.balls / cage / samples_per_pass
    z, inner_ring, outer_ring = bearing.balls, 2 * bearing.balls + 1, 2 * bearing.balls + 2
    contacts, balls, rings = [], [], []  # mz: the shaft puts in what the contacts lose
    for sample in range(passes * samples_per_pass + 1):  # both ends of the window
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
        balls.append(_atoms(bearing, state, cage, z, inner_ring, outer_ring))
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
        "simulated_s": sample_s * len(rings),
        "balls": z,
        "ball_diameter_m": bearing.ball_diameter,
        "inner_radius_m": bearing.inner_radius,
        "outer_radius_m": bearing.outer_radius,
        "inner_groove_m": bearing.inner_groove,
        "outer_groove_m": bearing.outer_groove,
        "load_azimuth_rad": load_azimuth,
        "sample_s": sample_s,
        "samples_per_pass": samples_per_pass,
        **(oil or {}),
        "contact_columns": " ".join(LUBRICATED if oil else MECHANICAL),
        "ball_columns": " ".join(BALL_COLUMNS),
        "inner_ring": inner_ring,
        "outer_ring": outer_ring,
    }
    return {"settings": settings, "contacts": contacts, "balls": balls, "rings": rings}


def _rows(bearing, state, side, spin, oil, z):
    part = (state.inner, state.outer)[side]
    speed = kinematics.entrainment(bearing, spin)
    for i in np.flatnonzero(part.load > 0):
        azimuth = np.mod(state.azimuth[i] + np.pi, 2 * np.pi) - np.pi
        row = [
            i + 1,
            2 * z + 1 + side,
            side,
            azimuth,
            part.angle[i],
            part.overlap[i],
            part.load[i],
            part.load[i],
            100.0,
            part.a[i],
            part.b[i],
            part.pressure[i],
            speed,
            0.0,
        ]
        losses = [part.load[i] * loss for loss in LOSS]
        if oil:
            r_x, r_y = bearing.effective_radii(side)
            group = film.group(
                oil["viscosity_Pa_s"],
                oil["pressure_viscosity_per_Pa"],
                bearing.effective_modulus,
                r_x,
                hertz.exact(r_x, r_y).kappa,
                speed,
                part.load[i],
            )
            h_min, h_c = film.h_min(r_x, group), film.h_c(r_x, group)
            ratio = film.ratio(h_min, oil["roughness_m"])
            row += [
                h_min,
                h_c,
                ratio,
                film.regime(ratio),
                0.05,
                0.0,
                *losses,
                capacitance.contact(
                    oil["permittivity"], part.pressure[i], part.a[i], part.b[i], h_c
                ),
            ]
        else:
            row += [0.1, 0.0, *losses]
        yield row


def _atoms(bearing, state, cage, z, inner_ring, outer_ring):
    radius, rows = bearing.pitch_radius, []
    for kind, offset in ((1, 0.0), (2, np.pi / z)):
        for i, azimuth in enumerate(state.azimuth + offset):
            x, y = radius * np.cos(azimuth), radius * np.sin(azimuth)
            turn = cage * (1 if kind == 1 else 7)  # the cage balls' speed must not count
            rows.append(
                [i + 1 + (kind - 1) * z, kind, x, y, 0, -turn * y, turn * x, 0, 0, 0, -100.0]
            )
    rows.append([inner_ring, 3, *state.shift, 0, 0, 0, 0, 0, 50.0])
    rows.append([outer_ring, 4] + [0.0] * 9)
    return rows[::-1]  # in no particular order


def write(folder, data):
    """Write `data` as `run` returns it to `folder`, in the files and formats of a deck."""
    folder.mkdir(parents=True, exist_ok=True)
    # a deck prints numbers as C does, 1e-06 and not 1.0e-06
    (folder / "run.yaml").write_text(
        "".join(
            f"{key}: {value if isinstance(value, str) else format(value, '.17g')}\n"
            for key, value in data["settings"].items()
        )
    )
    for name, what, label in (
        ("contacts.dump", "ENTRIES", "c_1[1] c_1[2]"),
        ("balls.dump", "ATOMS", "id type x"),
    ):
        frames = data[name.split(".")[0]]
        (folder / name).write_text(
            "".join(
                f"ITEM: TIMESTEP\n{100 * k}\nITEM: NUMBER OF {what}\n{len(rows)}\nITEM: BOX BOUNDS"
                " ff ff ff\n" + 3 * "-0.05 0.05\n" + f"ITEM: {what} {label}\n" + _text(rows)
                for k, rows in enumerate(frames)
            )
        )
    (folder / "rings.dat").write_text("# " + " ".join(RING_COLUMNS) + "\n" + _text(data["rings"]))
    return folder


def _text(rows):
    return "".join(" ".join(format(value, ".17g") for value in row) + " \n" for row in rows)
