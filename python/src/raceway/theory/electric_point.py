# SPDX-License-Identifier: GPL-2.0-or-later
"""Electrical results of a bearing at one operating point, from statics. First call `solve`, then
`figures`, which returns a dict; `electric_table` formats that dict as text.

The keys are a public interface for scripts. Quantities that `operating_point` also returns have the
same keys.
"""

import math
from typing import Any, NamedTuple

import numpy as np

from raceway import catalogue, inputs
from raceway.arrays import Floats, plain, short
from raceway.files import FilePath
from raceway.theory import capacitors, film_voltage, impedance, lubrication
from raceway.theory.asperity import clarke
from raceway.theory.bearing import Bearing, DoubleRow
from raceway.theory.capacitors import FLOODED, BearingCapacitors, Filling
from raceway.theory.contact_law import FilmInGap
from raceway.theory.lubrication import Lubrication
from raceway.theory.models import CAPACITANCE, PAPER
from raceway.theory.static import STRAIGHT, Equilibrium
from raceway.theory.validity import of_statics


class Point(NamedTuple):
    """A rotating bearing in equilibrium with its loads."""

    names: dict[str, Any]  # entries of the result of `figures` that identify the point
    bearing: Bearing
    oil: inputs.Oil
    state: Equilibrium
    films: Lubrication
    speed: float  # rad/s
    quiet: float | Floats  # Q_u, N; one value per ball if there are several rows
    clearance: float  # m
    film: FilmInGap | None
    filling: Filling
    four_point: float | None  # rad, contact angle if each ring has two grooves

    __repr__ = short

    def capacitors(self, scale: float = 1.0) -> BearingCapacitors:
        """Return the `BearingCapacitors`, with the thickness of every film multiplied by
        `scale`."""
        return capacitors.of_statics(
            self.bearing,
            self.state,
            self.oil,
            self.speed,
            self.quiet,
            filling=self.filling,
            clearance=self.clearance,
            factor=self.film and self.film.factor,
            scale=scale,
        )


class Ask(NamedTuple):
    """Quantities to compute in addition to the capacitance; None if not requested."""

    strength: float = film_voltage.STRENGTH  # V/m, breakdown field of a film
    voltage: float | None = None  # V, voltage between the rings
    frequency: float | None = None  # Hz
    resistivity: float = math.inf  # ohm m, resistivity of the oil
    motor: tuple[float, float] | None = None  # F, C_wr and C_rf
    measured: float | None = None  # F, measured capacitance of the bearing

    def parallel(self, bearing: Floats) -> Floats:
        """Capacitance (F) in parallel with that of a `bearing` on the shaft of a motor: of the
        second, equal bearing and of the motor; 0 without a motor."""
        return np.zeros_like(bearing) if self.motor is None else bearing + sum(self.motor)


NOTHING = Ask()


def solve(
    bearing: str,
    lubricant: str,
    folder: FilePath | None = None,
    *,
    rpm: float,
    load: float = 0.0,
    axial: float = 0.0,
    clearance: float = 0.0,
    temperature: float | None = None,
    models: str = PAPER,
    phase: float = 0.0,
    filling: Filling = FLOODED,
    four_point: float | None = None,
    double_row: DoubleRow | None = None,
) -> Point:
    """Return the `Point` for a bearing and a lubricant, which are given by name or path and
    searched for in the inputs `folder`. Loads are in N, `rpm` is the speed of the inner ring,
    `clearance` is the diametral clearance in m, `temperature` is in degrees C, and `phase` is the
    azimuth of the first ball in rad.

    Shoulders missing in `filling` are taken from the bearing's file. `models` is one of
    `models.CAPACITANCE`; "full" includes the film in the gap and inlet shear heating. `four_point`
    (rad) and `double_row` are as in `inputs.bearing`. Raises `RacewayError`, or `ValueError` if the
    speed is zero or a name is unknown.
    """
    path, oil_path = (
        catalogue.find("bearings", bearing, folder),
        catalogue.find("lubricants", lubricant, folder),
    )
    if models not in CAPACITANCE:
        raise ValueError(f"models '{models}' is not one of {', '.join(CAPACITANCE)}")
    if not rpm:
        raise ValueError("rpm = 0: balls that do not turn have no film")
    body = inputs.bearing(path, four_point=four_point, double_row=double_row)
    oil = inputs.oil(oil_path, temperature)
    fluid = inputs.fluid(oil_path, temperature)
    speed = rpm * math.pi / 30
    density = inputs.ball_density(path)
    film = FilmInGap(fluid, speed) if models == "full" else None
    state, orbit = lubrication.turning(
        body,
        speed,
        load,
        axial,
        held=STRAIGHT | inputs.held(path, axial, clearance, double_row),
        clearance=clearance,
        phase=phase,
        ball_density=density,
        film=film,
    )
    own = inputs.shoulders(path)
    known = [b if math.isnan(a) else a for a, b in zip(filling.shoulders, own)]
    return Point(
        dict(
            bearing=path.name,
            lubricant=oil_path.name,
            temperature_C=None if math.isnan(fluid.temperature) else fluid.temperature,
            models=models,
            load_N=load,
            axial_N=axial,
            clearance_m=clearance + body.play(inputs.nominal_angle(path)),
            rpm=rpm,
            surroundings=filling.kind,
        ),
        body,
        oil,
        state,
        lubrication.lubricate(body, state, oil, speed, clearance, film and film.factor),
        speed,
        capacitors.quiet_load(body, orbit, density),
        clearance,
        film,
        filling._replace(shoulders=type(own)(*known)),
        inputs.four_point_angle(path) if four_point is None else four_point,
    )


def figures(point: Point, ask: Ask = NOTHING) -> dict[str, Any]:
    """Return a dict of results in SI units, except that angles are in degrees. Quantities that were
    not requested are None. `balls` is a list with one dict per ball. Raises `ValueError` if no film
    thickness of the model gives the measured capacitance."""
    found, films, oil = point.capacitors(), point.films, point.oil
    top = int(np.argmax(found.inner.load))
    loaded = found.inner.load > 0
    plates = films.ball
    sides = (found.inner, found.outer)
    gaps, parts = zip(*((side.separation, side.total) for side in sides))
    smooth, rough = (
        film_voltage.threshold(gaps, parts, ask.strength, sigma) for sigma in (0.0, oil.roughness)
    )
    metallic = [
        np.atleast_2d(
            film_voltage.states(clarke(np.where(side.ratio > 0, side.ratio, np.inf))) == 2
        )
        for side in (films.inner, films.outer)
    ]
    result = dict(
        point.names,
        permittivity=oil.permittivity,
        roughness_m=oil.roughness,
        h_c_m=found.inner.separation[top],
        capacitance_F=plates.sum(),
        capacitance_surroundings_F=(found.ball - plates)[loaded].sum(),
        capacitance_unloaded_F=found.unloaded,
        capacitance_total_F=found.total,
        plates_factor=found.total / plates.sum() if plates.sum() else None,
        hertz_area_m2=sum(side.area.sum() for side in sides),
        threshold_V=smooth.bearing,
        threshold_peaks_V=rough.bearing,
        threshold_azimuth_deg=math.degrees(point.state.azimuth[smooth.weakest]),
        stored_energy_J=film_voltage.stored_energy(
            found.total + ask.parallel(found.total), smooth.bearing
        ),
        metallic_contacts=int(sum(side.sum() for side in metallic)),
    )
    result["lambda"] = np.atleast_2d(films.inner.ratio)[:, top].max()
    result.update(_field(gaps, parts, oil, ask))
    result.update(_impedance(found, ask))
    result.update(bearing_voltage_ratio=None, measured_F=ask.measured)
    if ask.motor is not None:
        result.update(
            bearing_voltage_ratio=impedance.bearing_voltage_ratio(
                *ask.motor, found.total, found.total
            )
        )
    result.update(measured_h_c_m=None, measured_plates_m=None)
    if ask.measured is not None:
        scale = impedance.film_scale(ask.measured, lambda s: point.capacitors(s).total)
        result.update(
            measured_h_c_m=scale * result["h_c_m"],
            measured_plates_m=result["h_c_m"] * plates.sum() / ask.measured,
        )
    result = plain(result)
    result["warnings"] = of_statics(
        point.bearing,
        point.filling.shoulders,
        point.state,
        films,
        load=point.names["load_N"],
        axial=point.names["axial_N"],
        four_point=point.four_point,
    )
    result["balls"] = _balls(point, found, smooth, [solid.any(0) for solid in metallic])
    return result


def _field(gaps, parts, oil, ask):
    if ask.voltage is None:
        return dict(field_V_m=None, field_peaks_V_m=None)
    films = list(zip(film_voltage.divided(abs(ask.voltage), *parts), gaps))
    most = [
        max(film_voltage.field(v, film_voltage.local_gap(gap, sigma)).max() for v, gap in films)
        for sigma in (0.0, oil.roughness)
    ]
    return dict(field_V_m=most[0], field_peaks_V_m=None if math.isinf(most[1]) else most[1])


def _impedance(found, ask):
    paths = [side.paths for side in (found.inner, found.outer)]
    leak = impedance.leak_of_films(paths, ask.resistivity)
    leak = float(leak) if math.isfinite(leak) else None
    result = dict(leak_ohm=leak, frequency_Hz=ask.frequency, impedance_ohm=None, phase_deg=None)
    if ask.frequency is not None:
        z = impedance.of_bearing(found, ask.frequency, ask.resistivity)
        result.update(impedance_ohm=abs(z), phase_deg=math.degrees(np.angle(z)))
    return result


def _balls(point, found, threshold, metallic):
    columns = dict(
        azimuth_rad=point.state.azimuth,
        capacitance_F=found.ball,
        plates_F=point.films.ball,
        threshold_V=threshold.ball,
    )
    for name, side, solid in zip(("inner", "outer"), (found.inner, found.outer), metallic):
        columns[f"q_{name}_N"] = side.load
        columns[f"capacitance_{name}_F"] = side.total
        columns[f"plates_{name}_F"] = side.plates
        columns[f"separation_{name}_m"] = side.separation
        columns[f"metallic_{name}"] = solid
    return [
        {key: values[ball].item() for key, values in columns.items()}
        for ball in range(len(point.state.azimuth))
    ]
