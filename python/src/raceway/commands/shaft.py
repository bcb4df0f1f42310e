# SPDX-License-Identifier: GPL-2.0-or-later
"""`raceway shaft FILE`: compute the equilibrium of a shaft on several bearings."""

import argparse
import math
from typing import Any

from raceway.commands import options, output
from raceway.commands.quantity import number
from raceway.rows import aligned
from raceway.units import prefixed

HELP = "compute loads, tilt and life of bearings on one shaft, without a simulation"
DESCRIPTION = """\
Computes the static equilibrium of a shaft on several ball bearings from theory: the load, tilt and
rating life of every bearing, the displacements of the shaft, its rigid-body properties, and its
natural frequencies with the stiffness of the bearings at equilibrium. The shaft is a Timoshenko
beam; each bearing follows the statics of `raceway static`. The file contains sections, bearings and
loads in SI units (docs/shaft.rst). For several values of --rpm, one line is printed for each, with
the stiffness of the bearings and the natural frequencies.

For a ROSS rotor (.toml) or its matrices (.npz), only --reduced and the properties of the free
rotor are available."""
EXAMPLES = """\
examples:
  raceway shaft inputs/shafts/motor
  raceway shaft inputs/shafts/motor --json
  raceway shaft inputs/shafts/motor --rpm 1500 3000 6000
  raceway shaft inputs/shafts/motor --out build/motor.png
  raceway shaft inputs/shafts/motor --reduced build/motor.modes --places 0.1 0.27
  raceway shaft rotor.toml --reduced build/rotor.modes

Exit codes: 0 done, 1 no equilibrium or unusable data, 2 wrong command line."""
MODES = 4  # default of --modes
SHOWN = 6  # number of natural frequencies and of critical speeds that are shown
FASTEST = 1e4  # rad/s, upper limit of the search for critical speeds
LOADS = ("load_x_N", "load_y_N", "load_z_N", "moment_x_N_m", "moment_y_N_m")
PLACES = ("shift_x_m", "shift_y_m", "shift_z_m", "tilt_x_rad", "tilt_y_rad")


def add(one: argparse.ArgumentParser) -> None:
    one.add_argument("file", metavar="FILE", help="YAML file of the shaft, or a ROSS rotor")
    options.inputs(one)
    options.point(one, "rpm", "speed of the shaft in rpm (default: the speed in the file)")
    options.cleanliness(one)
    output.option(one, "print a JSON object, or a list for several --rpm")
    one.add_argument("--out", metavar="PNG", help="plot the displacement of the shaft")
    reduced = one.add_argument_group("flexible shaft, for fix bearing/shaft")
    reduced.add_argument(
        "--reduced",
        metavar="FILE",
        help="write a model of the flexible shaft, reduced to a few coordinates",
    )
    reduced.add_argument(
        "--modes",
        type=int,
        metavar="N",
        help="number of modes per plane with bearings and loads held (default: 4)",
    )
    reduced.add_argument(
        "--damping",
        type=number(0, 1, ""),
        metavar="RATIO",
        help="damping ratio of every elastic mode (default: 0)",
    )
    reduced.add_argument(
        "--kept",
        type=number(-1e3, 1e3, "m"),
        nargs="+",
        default=[],
        metavar="Z",
        help="positions (m) at which the deflection under steady loads is exact; in addition to the"
        " bearings and loads of a YAML file, but instead of the bearings of a ROSS rotor",
    )
    reduced.add_argument(
        "--places",
        type=number(-1e3, 1e3, "m"),
        nargs="+",
        default=[],
        metavar="Z",
        help="further positions (m) at which the deck applies loads and unbalances",
    )


def run(arguments: argparse.Namespace) -> None:
    # loading scipy takes longer than printing --help
    from raceway import ross_file, shaft_file
    from raceway.errors import RacewayError
    from raceway.theory import shaft

    _check(arguments)
    if ross_file.is_ross(arguments.file):
        from raceway.commands import _ross_rotor

        return _ross_rotor.run(arguments)
    case = shaft_file.read(arguments.file, arguments.inputs)
    results = []
    for rpm in arguments.rpm or [case.rpm]:
        case = case._replace(rpm=rpm)
        try:
            rest = shaft.rest(case.shaft, case.seats, case.loads, speed=rpm * math.pi / 30)
        except ValueError as error:
            raise RacewayError(f"{arguments.file}: {error}") from None
        results.append(figures(case, rest, arguments.inputs, arguments.cleanliness))
    if arguments.out:
        from raceway.pictures.shaft import picture

        picture(case, rest, arguments.out)
    if arguments.reduced:
        reduce(case, rest, arguments)
    output.show_each(arguments, results, table, over_speed)


def _check(arguments):
    from raceway.errors import RacewayError

    given = {name: getattr(arguments, name) for name in ("modes", "damping", "kept", "places")}
    for name, value in given.items():
        if not arguments.reduced and value not in (None, []):
            raise RacewayError(f"--{name} applies to --reduced FILE, which is missing")
    if arguments.modes is None:
        arguments.modes = MODES
    if arguments.damping is None:
        arguments.damping = 0.0
    if not 0 <= arguments.modes <= 50:
        raise RacewayError(f"--modes is {arguments.modes}, must be from 0 to 50")
    if not 0 <= arguments.damping < 1:
        raise RacewayError(f"--damping is {arguments.damping:g}, must be at least 0 and below 1")
    if len(arguments.rpm or ()) > 1 and (arguments.out or arguments.reduced):
        raise RacewayError("--out and --reduced apply to one speed; give one --rpm")


def reduce(case: Any, rest: Any, arguments: argparse.Namespace) -> None:
    """Write the file `arguments.reduced`; raise `RacewayError` if the options are invalid."""
    from raceway import bending_file
    from raceway.errors import RacewayError
    from raceway.theory import shaft_motion

    try:
        found = shaft_motion.bending(
            case.shaft,
            rest,
            case.loads,
            modes=arguments.modes,
            damping=arguments.damping,
            kept=arguments.kept,
            places=arguments.places,
        )
        bending_file.write(arguments.reduced, found)
    except ValueError as error:
        raise RacewayError(f"{arguments.file}: {error}") from None


def figures(case: Any, rest: Any, folder: str | None, cleanliness: str) -> dict[str, Any]:
    """Return results for a `shaft_file.Case` and its `shaft.Rest` in SI units, keyed by name."""
    from raceway import catalogue, inputs
    from raceway.theory import life, shaft_modes, shaft_motion

    viscosity = None
    oil = case.lubricant and catalogue.find("lubricants", case.lubricant, folder)
    if oil and not inputs.dry(oil):
        found = inputs.fluid(oil).kinematic
        viscosity = None if math.isnan(found) else found
    bearings = []
    for name, rated, angle, one in zip(case.names, case.ratings, case.angles, rest.bearings):
        state = one.state
        largest = max(state.inner.load.max(), state.outer.load.max())
        pressure = max(state.inner.pressure.max(), state.outer.pressure.max())
        row = dict(
            bearing=name,
            at_m=one.seat.at,
            **dict(zip(LOADS, one.load.tolist())),
            **dict(zip(PLACES, one.place.tolist())),
            tilt_rad=float(math.hypot(*one.place[3:])),
            q_max_N=float(largest),
            p_max_Pa=float(pressure),
            static_safety=float(life.static_safety(pressure)) if pressure else None,
            stiffness=state.stiffness.tolist(),
        )
        if rated is not None and state.inner.load.any():
            found = life.of_loads(
                one.seat.bearing,
                rated,
                state.inner.load,
                state.outer.load,
                angle=angle,
                rpm=case.rpm,
                viscosity=viscosity,
                cleanliness=cleanliness,
            )
            row.update(life_reference_Mrev=found.reference, equivalent_load_N=found.equivalent)
            if case.rpm:
                row.update(life_reference_h=found.reference * 1e6 / (60 * case.rpm))
            if not math.isnan(found.factor):
                row.update(life_factor=found.factor)
        bearings.append(row)
    rigid = shaft_motion.rigid(case.shaft, rest)
    speed = case.rpm * math.pi / 30
    frequencies = shaft_motion.frequencies(case.shaft, rest, speed)
    modes = shaft_modes.modes(case.shaft, rest, speed)[:SHOWN]
    critical = shaft_modes.critical_speeds(case.shaft, rest, FASTEST)[:SHOWN]
    return dict(
        rpm=case.rpm,
        lubricant=case.lubricant,
        bearings=bearings,
        z_m=rest.z.tolist(),
        place=rest.place.tolist(),
        residual=rest.residual,
        rigid=rigid_figures(rigid),
        frequencies_Hz=(frequencies / (2 * math.pi)).tolist(),
        modes=[
            dict(frequency_Hz=one.speed / (2 * math.pi), shape=one.shape, whirl=one.whirl)
            for one in modes
        ],
        critical_speeds=[
            dict(rpm=one.speed * 30 / math.pi, shape=one.shape, whirl=one.whirl) for one in critical
        ],
    )


def table(result: dict[str, Any]) -> str:
    """Return the result of `figures` as text."""
    columns = (
        ("bearing", "bearing", ""),
        ("at_m", "at", "m"),
        ("load_x_N", "F_x", "N"),
        ("load_y_N", "F_y", "N"),
        ("load_z_N", "F_z", "N"),
        ("moment_x_N_m", "M_x", "N m"),
        ("moment_y_N_m", "M_y", "N m"),
        ("tilt_rad", "tilt", "rad"),
        ("q_max_N", "Q max", "N"),
        ("p_max_Pa", "p max", "Pa"),
        ("static_safety", "s_0", ""),
        ("life_reference_h", "L_10r, h", ""),
        ("life_factor", "a_ISO", ""),
    )
    shown = [column for column in columns if any(column[0] in row for row in result["bearings"])]
    rows = [[heading for _, heading, _ in shown]]
    least = _noise(
        (row.get(key), unit) for row in result["bearings"] for key, _, unit in shown if unit
    )
    rows += [
        [_cell(row.get(key), unit, least) for key, _, unit in shown] for row in result["bearings"]
    ]
    text = ["Bearings", *aligned(rows), "", "Shaft"]
    rows = [["z", "x", "y", "z", "tilt x", "tilt y"]]
    units = ("m", "m", "m", "rad", "rad")
    least = _noise(pair for place in result["place"] for pair in zip(place, units))
    for z, place in zip(result["z_m"], result["place"]):
        rows.append([prefixed(z, "m"), *(_cell(*pair, least) for pair in zip(place, units))])
    body = result["rigid"]
    modes = [
        [prefixed(one["frequency_Hz"], "Hz"), one["shape"], one["whirl"]] for one in result["modes"]
    ]
    critical = [
        [f"{one['rpm']:.5g} rpm", one["shape"], one["whirl"]] for one in result["critical_speeds"]
    ]
    return "\n".join(
        [
            *text,
            *aligned(rows),
            "",
            f"Natural frequencies at {result['rpm']:g} rpm",
            *aligned(modes),
            "",
            f"Critical speeds up to {FASTEST * 30 / math.pi:.5g} rpm",
            *aligned(critical or [["none"]]),
            "",
            rigid_line(body),
        ]
    )


def over_speed(results: list[dict[str, Any]]) -> str:
    """Return several results of `figures` as text, with one line for each."""
    names = [one["bearing"] for one in results[0]["bearings"]]
    heads = [f"{name} {entry}" for name in names for entry in ("kxx", "kyy")]
    rows = [["rpm", *heads, *(f"mode {k}" for k in range(1, SHOWN + 1))]]
    for one in results:
        matrices = [carried["stiffness"] for carried in one["bearings"]]
        stiff = [matrix[axis][axis] for matrix in matrices for axis in (0, 1)]
        modes = [prefixed(mode["frequency_Hz"], "Hz") for mode in one["modes"]]
        modes += ["-"] * (SHOWN - len(modes))
        rows.append([f"{one['rpm']:g}", *(prefixed(value, "N/m") for value in stiff), *modes])
    return "\n".join(aligned(rows, ""))


def rigid_figures(rigid: Any) -> dict[str, float]:
    """Return the properties of a `beam_motion.Rigid` in SI units, keyed by name."""
    return dict(
        mass_kg=rigid.mass,
        centre_m=rigid.centre,
        axial_kg_m2=rigid.axial,
        transverse_kg_m2=rigid.transverse,
    )


def rigid_line(body: dict[str, float]) -> str:
    """Return the result of `rigid_figures` as a line of text."""
    return (
        f"Rigid body: mass {body['mass_kg']:.4g} kg,"
        f" centre at {prefixed(body['centre_m'], 'm')},"
        f" inertia {body['axial_kg_m2']:.4g} about the axis, {body['transverse_kg_m2']:.4g}"
        " kg m2 across it"
    )


def _noise(values):
    """Return {unit: value below which a quantity (value, unit) is shown as 0}.

    The equilibrium of a shaft is accurate to 1e-9 of the loads.
    """
    largest: dict[str, float] = {}
    for value, unit in values:
        largest[unit] = max(largest.get(unit, 0.0), abs(value or 0.0))
    return {unit: 1e-6 * value for unit, value in largest.items()}


def _cell(value, unit, least):
    if value is None:
        return "-"
    if isinstance(value, str):
        return value
    return "0" if unit and abs(value) <= least[unit] else prefixed(value, unit)
