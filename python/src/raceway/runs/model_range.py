# SPDX-License-Identifier: GPL-2.0-or-later
"""Known model uncertainty of the results of a run, due to the range of the inputs and the spread of
the laws. Unknown uncertainties are not included; for numerical errors see `raceway check`.

The ranges of films and capacitance follow from the limits of the inputs, the film laws of
Masjedi-Khonsari and Hamrock-Dowson, and the inlet shear factors of Murch, Wilson and Gupta. A run
without inlet shear is isothermal; its lower limit is the film thinned by inlet shear. All limits
are evaluated at the inner contact with the largest load and applied as factors; limits that act in
the same direction are combined. The range of the asperity load follows from the three laws of
`theory.asperity`. The range of the torque follows from the unknowns of the friction laws and from
the makers' formulas. The unknowns are the inlet, from the shortest to a flooded one; alpha of
hysteresis, from 0.005 to 0.05; the fraction of the load on asperities; and the drag, from half to
twice its value.
"""

import math
from collections.abc import Mapping
from importlib.resources import files
from typing import Any, NamedTuple

import numpy as np
import yaml

from raceway import catalogue, inputs
from raceway.runs.settings import LUBRICANT, deck_words
from raceway.runs.tables import RunTables
from raceway.theory import asperity, capacitance, film, film_factors, hertz, rolling, traction
from raceway.theory.bearing import INNER
from raceway.theory.contact_friction import Surfaces

INPUTS = yaml.safe_load(files("raceway").joinpath("runs/model_range.yaml").read_text())
FIELDS = dict(zip(LUBRICANT, inputs.Oil._fields))
GUPTA = 10.0  # largest thermal loading for which Gupta's factor is valid
SAME = 1e-6  # relative difference below which two values count as equal
LAWS = ((film.h_min, film.h_c), (film.hamrock_dowson_min, film.hamrock_dowson_c))
HYSTERESIS = (0.005, 0.05)  # alpha, Schwarz et al. 2023
SHARES = (asperity.zhou_hoeprich, asperity.olver_spikes, asperity.clarke)


class Range(NamedTuple):
    """Range of a result due to known model uncertainty, in the unit of the result, and its
    reason."""

    low: float
    high: float
    why: str


def model_ranges(tables: RunTables, figures: Mapping[str, Any]) -> dict[str, Range]:
    """Return {key: `Range`} for the results (`figures`) of the run `tables`.

    Films and capacitance have no range for a dry run and for a lubricant without a file.
    """
    result: dict[str, Range] = {}
    needed = ("h_c_m", "entrainment_speed_m_s", "q_inner_max_N", "p_max_inner_Pa")
    if tables.lubricated and all(figures.get(key) for key in (*needed, *FIELDS)):
        try:
            path = catalogue.find("lubricants", figures["lubricant"])
            temperature = _temperature(tables)
            oil, fluid = inputs.oil(path, temperature), inputs.fluid(path, temperature)
        except inputs.InputError:
            return {}
        result = _films(tables, figures, oil, fluid)
    share = figures.get("asperity_share")
    if share is not None and figures.get("lambda"):
        known = [float(law(figures["lambda"])) for law in SHARES]
        why = "Zhou and Hoeprich, Olver and Spikes, Clarke"
        result["asperity_share"] = Range(min(share, *known), max(share, *known), why)
    makers = [figures.get(key) for key in ("torque_skf_N_m", "torque_palmgren_N_m")]
    makers = [torque for torque in makers if torque]
    own = figures.get("friction_torque_N_m")
    if own and figures.get("models") == "full":
        known = [own, *makers, *_torques(tables, figures)]
        why = f"inlet, hysteresis, asperities, drag{'; SKF, Palmgren' if makers else ''}"
        if len(known) > 1:
            result["friction_torque_N_m"] = Range(min(known), max(known), why)
    return result


def _torques(tables, figures):
    """Return the smallest and the largest torque in N m over the unknowns of the friction laws."""
    losses, share = figures.get("losses_W"), figures.get("asperity_share")
    if not losses or not figures.get("lambda") or share is None or not figures.get("h_c_m"):
        return []
    bearing, surfaces = tables.geometry, Surfaces()
    r_x, r_y = bearing.effective_radii(INNER, 0.0, figures["clearance_m"] or 0.0)
    _, b = hertz.semi_axes(
        hertz.exact(r_x, r_y), bearing.effective_modulus, figures["q_inner_max_N"]
    )
    inlet = float(tables.pair_keyword("rolling_inlet") or 0.0)
    left = float(rolling.inlet(inlet, figures["h_c_m"], b, r_x))
    alpha = float(tables.pair_keyword("rolling_hysteresis") or surfaces.loss)
    mu = [
        traction.mixed(one, surfaces.boundary, surfaces.film)
        for one in (share, *(float(law(figures["lambda"])) for law in SHARES))
    ]
    factors = {
        "rolling": (0.5 / left, 1 / left),
        "hysteresis": (HYSTERESIS[0] / alpha, HYSTERESIS[1] / alpha) if alpha else (1.0, 1.0),
        "slip": (min(mu) / mu[0], max(mu) / mu[0]),
        "spin": (min(mu) / mu[0], max(mu) / mu[0]),
        "drag": (0.5, 2.0),
    }
    own, power = figures["friction_torque_N_m"], sum(filter(None, losses.values()))
    return [
        own
        + own
        / power
        * sum((factors[part][end] - 1) * (losses.get(part) or 0.0) for part in factors)
        for end in (0, 1)
    ]


def _temperature(tables):
    known = deck_words(tables.settings)
    return float(known["temperature"]) if "temperature" in known else None


def _films(tables, figures, oil, fluid):
    bearing, speed = tables.geometry, figures["entrainment_speed_m_s"]
    r_x, r_y = bearing.effective_radii(INNER, 0.0, figures["clearance_m"] or 0.0)
    ellipse = hertz.exact(r_x, r_y)
    load, pressure = figures["q_inner_max_N"], figures["p_max_inner_Pa"]
    a = math.sqrt(1.5 * load * ellipse.kappa / (math.pi * pressure))  # p = 1.5 Q/(pi a b)
    ends, why = {}, []
    for key, field in FIELDS.items():
        own, given = getattr(oil, field), figures[key]
        typical = abs(given / own - 1) < SAME
        factors = INPUTS[key]["factors"] if typical else (1.0, 1.0)
        ends[key] = [given * factor for factor in factors]
        if typical:
            why.append(INPUTS[key]["why"])
    thinning = _thinning(tables, figures, fluid)
    of, flow = (bearing.effective_modulus, r_x, ellipse.kappa, speed, load), LUBRICANT[:2]
    groups = film.group(*np.meshgrid(*(ends[key] for key in flow)), *of)
    # films h_min and h_c, for all laws, values of the inputs and factors of inlet shear
    films = [np.multiply.outer([law(r_x, groups) for law in laws], thinning) for laws in zip(*LAWS)]
    usual = film.group(*(figures[key] for key in flow), *of)
    # The ratio of the run's film to that of the law contains all other effects on the thickness.
    scale = [figures["h_min_m"] / film.h_min(r_x, usual), figures["h_c_m"] / film.h_c(r_x, usual)]
    lows = [float(k * one.min()) for k, one in zip(scale, films)]
    highs = [float(k * one.max()) for k, one in zip(scale, films)]
    laws = "Masjedi-Khonsari or Hamrock-Dowson, inlet shear by Murch, Wilson or Gupta"
    flows = "; ".join([text for text in why if text.startswith(("viscosity", "pressure"))] + [laws])
    rough = ends["roughness_m"]
    result = {
        "h_min_m": Range(lows[0], highs[0], flows),
        "h_c_m": Range(lows[1], highs[1], flows),
        "lambda": Range(lows[0] / rough[1], highs[0] / rough[0], "film and roughness"),
    }

    def electric(permittivity, h):
        return float(capacitance.contact(permittivity, pressure, a, a / ellipse.kappa, h))

    now = electric(figures["permittivity"], figures["h_c_m"])
    least = electric(ends["permittivity"][0], highs[1]) / now
    most = electric(ends["permittivity"][1], lows[1]) / now
    for key in ("capacitance_F", "capacitance_top_F"):
        if figures.get(key):
            result[key] = Range(figures[key] * least, figures[key] * most, "film and permittivity")
    return result


def _thinning(tables, figures, fluid):
    """Return the factors on the film of the run that follow from the laws of inlet shear."""
    loading = film_factors.thermal_loading(
        fluid.temperature_viscosity,
        figures["viscosity_Pa_s"],
        figures["entrainment_speed_m_s"],
        fluid.conductivity,
    )
    if math.isnan(loading):  # the file does not contain the necessary data
        return [1.0]
    pressure = figures["p_max_inner_Pa"] / tables.geometry.effective_modulus
    laws = {"murch": film_factors.murch_wilson(loading), "wilson": film_factors.wilson(loading)}
    if loading < GUPTA:
        laws["gupta"] = film_factors.gupta(loading, pressure)
    own = tables.pair_keyword("inlet_shear")
    if own is None:  # isothermal
        return [1.0, *map(float, laws.values())]
    return [float(law / laws.get(own, laws["murch"])) for law in laws.values()]
