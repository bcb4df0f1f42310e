# SPDX-License-Identifier: GPL-2.0-or-later
"""Electrical results of a bearing at one operating point, from statics. First call `solve`, then
`figures`, which returns a dict; `electric_table` formats that dict as text.

The keys are a public interface for scripts. Quantities that `operating_point` also returns have the
same keys.
"""

import math
from collections.abc import Sequence
from typing import Any, NamedTuple

import numpy as np

from raceway import catalogue, inputs
from raceway.arrays import Floats, plain, short
from raceway.files import FilePath
from raceway.theory import (
    ball_pass,
    capacitors,
    film_gap,
    film_voltage,
    impedance,
    lubrication,
)
from raceway.theory.asperity import clarke
from raceway.theory.bearing import Bearing, DoubleRow, grooves
from raceway.theory.capacitors import FLOODED, BearingCapacitors, Filling
from raceway.theory.contact_law import FilmInGap
from raceway.theory.lubrication import Lubrication
from raceway.theory.models import CAPACITANCE, PAPER
from raceway.theory.static import STRAIGHT, Equilibrium
from raceway.theory.validity import of_statics


class Place(NamedTuple):
    """Equilibrium with the balls at one position."""

    share: float  # of the ball pass that it represents
    state: Equilibrium
    films: Lubrication
    quiet: float | Floats  # Q_u, N; one value per ball if there are several rows

    __repr__ = short


class Point(NamedTuple):
    """A rotating bearing in equilibrium with its loads, at positions of the balls that represent a
    ball pass, or at a single one."""

    names: dict[str, Any]  # entries of the result of `figures` that identify the point
    bearing: Bearing
    oil: inputs.Oil
    places: tuple[Place, ...]
    speed: float  # rad/s
    clearance: float  # m
    film: FilmInGap | None
    filling: Filling
    four_point: float | None  # rad, contact angle if each ring has two grooves

    __repr__ = short

    @property
    def state(self) -> Equilibrium:
        """Equilibrium at the first position, or at the only one."""
        return self.places[0].state

    @property
    def films(self) -> Lubrication:
        """Films at that position."""
        return self.places[0].films

    def capacitors(self, scale: float = 1.0, place: int = 0) -> BearingCapacitors:
        """Return the `BearingCapacitors` at the position with the number `place`, with the
        thickness of every film multiplied by `scale`."""
        return capacitors.of_statics(
            self.bearing,
            self.places[place].state,
            self.oil,
            self.speed,
            self.places[place].quiet,
            filling=self.filling,
            clearance=self.clearance,
            factor=self.film and self.film.factor,
            scale=scale,
        )

    def every(self, scale: float = 1.0) -> list[BearingCapacitors]:
        """Return the `capacitors` at all positions."""
        return [self.capacitors(scale, place) for place in range(len(self.places))]

    def mean(self, values: Sequence[Any]) -> Any:
        """Return the mean over the ball pass of numbers or arrays, one for each position."""
        return np.average(values, axis=0, weights=[place.share for place in self.places])

    def total(self, scale: float = 1.0) -> float:
        """Return the capacitance in F, as a mean over the positions."""
        return float(self.mean([one.total for one in self.every(scale)]))

    @property
    def heaviest(self) -> int:
        """Number of the position with the largest inner load."""
        return int(np.argmax([place.state.inner.load.max() for place in self.places]))


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
    phase: float | None = None,
    filling: Filling = FLOODED,
    four_point: float | None = None,
    double_row: DoubleRow | None = None,
) -> Point:
    """Return the `Point` for a bearing and a lubricant, which are given by name or path and
    searched for in the inputs `folder`. Loads are in N, `rpm` is the speed of the inner ring,
    `clearance` is the diametral clearance in m, `temperature` is in degrees C, and `phase` is the
    azimuth of the first ball in rad, by default all positions that `ball_pass.over` selects.

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
    material = inputs.values(path).get("ball_material", "steel")
    if material != "steel":
        raise inputs.InputError(
            f"{path}: balls of {material} insulate, but the capacitances are those of steel balls"
        )
    body = inputs.bearing(path, four_point=four_point, double_row=double_row)
    oil = inputs.oil(oil_path, temperature)
    fluid = inputs.fluid(oil_path, temperature)
    speed = rpm * math.pi / 30
    density = inputs.ball_density(path)
    film = FilmInGap(fluid, speed) if models == "full" else None

    def placed(phase):
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
        films = lubrication.lubricate(body, state, oil, speed, clearance, film and film.factor)
        return (
            state,
            films,
            capacitors.quiet_load(body, orbit, density, cut=film_gap.CUT if film else 0.0),
        )

    if phase is None:
        over = ball_pass.over(placed, body.balls, lambda found: found[0].inner.load)
    else:
        over = [(1.0, placed(phase))]
    arch = inputs.four_point_angle(path) if four_point is None else four_point
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
            **grooves(arch, double_row),
            surroundings=filling.kind,
        ),
        body,
        oil,
        tuple(Place(share, *found) for share, found in over),
        speed,
        clearance,
        film,
        filling._replace(shoulders=type(own)(*known)),
        arch,
    )


def figures(point: Point, ask: Ask = NOTHING) -> dict[str, Any]:
    """Return a dict of results in SI units, except that angles are in degrees. Quantities that were
    not requested are None. Capacitances and impedance are means over the positions of the `point`,
    voltages, fields and numbers of contacts are extremes over them, and films are those at the
    largest inner load. `balls` is a list with one dict per ball at the first position. Raises
    `ValueError` if no film thickness of the model gives the measured capacitance."""
    every, oil = point.every(), point.oil
    heavy, films = every[point.heaviest], point.places[point.heaviest].films
    top = int(np.argmax(heavy.inner.load))
    plates = [place.films.ball for place in point.places]
    gaps = [(found.inner.separation, found.outer.separation) for found in every]
    parts = [(found.inner.total, found.outer.total) for found in every]
    smooth, rough = (
        [film_voltage.threshold(*both, ask.strength, sigma) for both in zip(gaps, parts)]
        for sigma in (0.0, oil.roughness)
    )
    weakest = int(np.argmin([one.bearing for one in smooth]))
    metallic = [_metallic(place.films) for place in point.places]

    def mean(values):
        return float(point.mean(list(values)))

    around = ((found.ball - own)[found.inner.load > 0].sum() for found, own in zip(every, plates))
    total, of_plates = mean(found.total for found in every), mean(own.sum() for own in plates)
    result = dict(
        point.names,
        permittivity=oil.permittivity,
        roughness_m=oil.roughness,
        h_c_m=heavy.inner.separation[top],
        capacitance_F=of_plates,
        capacitance_surroundings_F=mean(around),
        capacitance_unloaded_F=mean(found.unloaded for found in every),
        capacitance_total_F=total,
        plates_factor=total / of_plates if of_plates else None,
        hertz_area_m2=mean(found.inner.area.sum() + found.outer.area.sum() for found in every),
        threshold_V=smooth[weakest].bearing,
        threshold_peaks_V=min(one.bearing for one in rough),
        threshold_azimuth_deg=math.degrees(
            point.places[weakest].state.azimuth[smooth[weakest].weakest]
        ),
        stored_energy_J=film_voltage.stored_energy(
            total + ask.parallel(total), smooth[weakest].bearing
        ),
        metallic_contacts=max(int(sum(side.sum() for side in one)) for one in metallic),
    )
    result["lambda"] = films.inner.ratio.flat[
        np.argmax(point.places[point.heaviest].state.inner.load)
    ]
    result.update(_field(gaps, parts, oil, ask))
    result.update(_impedance(point, every, ask))
    result.update(bearing_voltage_ratio=None, measured_F=ask.measured)
    if ask.motor is not None:
        result.update(
            bearing_voltage_ratio=impedance.bearing_voltage_ratio(*ask.motor, total, total)
        )
    result.update(measured_h_c_m=None, measured_plates_m=None)
    if ask.measured is not None:
        scale = impedance.film_scale(ask.measured, point.total)
        result.update(
            measured_h_c_m=scale * result["h_c_m"],
            measured_plates_m=result["h_c_m"] * of_plates / ask.measured,
        )
    result = plain(result)
    result["warnings"] = of_statics(
        point.bearing,
        point.filling.shoulders,
        point.places[point.heaviest].state,
        films,
        load=point.names["load_N"],
        axial=point.names["axial_N"],
        four_point=point.four_point,
    )
    result["balls"] = _balls(point, every[0], smooth[0], [solid.any(0) for solid in metallic[0]])
    return result


def _metallic(films):
    return [
        np.atleast_2d(
            film_voltage.states(clarke(np.where(side.ratio > 0, side.ratio, np.inf))) == 2
        )
        for side in (films.inner, films.outer)
    ]


def _field(gaps, parts, oil, ask):
    if ask.voltage is None:
        return dict(field_V_m=None, field_peaks_V_m=None)
    films = [
        film
        for own, apart in zip(parts, gaps)
        for film in zip(film_voltage.divided(abs(ask.voltage), *own), apart)
    ]
    most = [
        max(film_voltage.field(v, film_voltage.local_gap(gap, sigma)).max() for v, gap in films)
        for sigma in (0.0, oil.roughness)
    ]
    return dict(field_V_m=most[0], field_peaks_V_m=None if math.isinf(most[1]) else most[1])


def _impedance(point, every, ask):
    leaks = [
        impedance.leak_of_films([side.paths for side in (one.inner, one.outer)], ask.resistivity)
        for one in every
    ]
    leak = point.mean([1 / one for one in leaks])
    leak = float(1 / leak) if leak > 0 else None
    result = dict(leak_ohm=leak, frequency_Hz=ask.frequency, impedance_ohm=None, phase_deg=None)
    if ask.frequency is not None:
        z = of_pass(point, every, ask.frequency, ask.resistivity)
        result.update(impedance_ohm=abs(z), phase_deg=math.degrees(np.angle(z)))
    return result


def of_pass(
    point: Point, every: list[BearingCapacitors], frequency: Any, resistivity: float
) -> Any:
    """Return Z in ohm as in `impedance.of_bearing`, from the mean admittance over the positions of
    the `point` with the capacitors `every`."""
    found = [1 / impedance.of_bearing(one, frequency, resistivity) for one in every]
    return 1 / point.mean(found)


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
