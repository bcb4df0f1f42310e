# SPDX-License-Identifier: GPL-2.0-or-later
"""Quantities related to films and lubrication regimes in the runs. The printed eq 9 affects only
the central film thickness."""

import numpy as np

from raceway.paper import passage, sensitivity
from raceway.paper.book import Book
from raceway.paper.figures.regime import PASSAGE, curves
from raceway.paper.quantity import Quantity
from raceway.theory.bearing import INNER, OUTER

SHORT = {"mineral": "mineral", "pao48": "PAO"}


def measure(book: Book, printed: bool) -> dict[str, Quantity]:
    """Return {name: `Quantity`}; see `quantities`."""
    b, oils, runs = book.bearing, book.oils, book.readings
    form = "_printed" if printed else ""
    fast = runs.some("speeds" + form, lubricant="mineral", load=5000)[-1]
    result = {
        "thickest": Quantity(
            max(
                one.top(side, "h_c") for one in runs.all("speeds" + form) for side in (INNER, OUTER)
            ),
            "m",
            "thickest central film at ψ = 0, all speeds",
        ),
        "h_inner": Quantity(fast.top(INNER, "h_min"), "m", "inner $h_{min}$"),
        "h_outer": Quantity(fast.top(OUTER, "h_min"), "m", "outer $h_{min}$"),
    }
    bound = curves(book, printed)
    for name, rows in bound.items():
        result[f"lambda_least_{name}"] = Quantity(
            rows["lambda"].min(), "", f"least $Λ_f$, {SHORT[name]}"
        )
        result[f"lambda_most_{name}"] = Quantity(
            rows["lambda"].max(), "", f"largest $Λ_f$, {SHORT[name]}"
        )
        result[f"passage_speed_{name}"] = Quantity(
            np.exp(np.interp(0.0, np.log(rows["lambda"]), np.log(rows["entrainment_m_s"]))),
            "m/s",
            f"$U_r$ at Λ = 1, {SHORT[name]}",
        )
        result[f"passage_capacitance_{name}"] = Quantity(
            np.exp(np.interp(0.0, np.log(rows["lambda"]), np.log(rows["capacitance_F"]))),
            "F",
            f"bearing at Λ = 1, {SHORT[name]}",
        )
        for whole, word in ((True, "bearing"), (False, "ball")):
            needed = passage.roughness(b, oils[name], 5000.0, PASSAGE, whole, printed)
            result[f"roughness_{word}_{name}"] = Quantity(
                needed, "m", f"corresponding roughness, {SHORT[name]}"
            )
        rough = sensitivity.ranges(book)[name]["roughness"][1]
        result[f"passage_rough_{name}"] = Quantity(
            passage.capacitance(b, oils[name], 5000.0, rough, printed=printed),
            "F",
            f"bearing at Λ = 1 on the roughest plausible raceway, {SHORT[name]}",
        )
    result["passage_oils"] = Quantity(
        result["passage_capacitance_pao48"].value / result["passage_capacitance_mineral"].value,
        "",
        "PAO over mineral at Λ = 1",
    )
    result["lambda_oils"] = Quantity(
        (bound["mineral"]["lambda"] / bound["pao48"]["lambda"]).min(),
        "",
        "smallest ratio of $Λ_f$, mineral over PAO, same speed",
    )
    result["lambda_growth"] = Quantity(
        min(np.diff(rows["lambda"]).min() for rows in bound.values()),
        "",
        "smallest increase of $Λ_f$ between speeds",
    )
    if not printed:
        slow = [runs.some("speeds", lubricant="pao48", load=load)[0] for load in (5000, 1000)]
        quick = runs.some("speeds", lubricant="pao48", load=1000)[-1]
        soft, stiff = (
            runs.one("sensitivity", pressure_viscosity=xi).top(INNER, "h_min")
            for xi in (20e-9, 25e-9)
        )
        result |= {
            "piezo_film": Quantity(stiff / soft, "", "ratio of $h_{min}$ at ξ = 25 and 20 /GPa"),
            "lambda_heavy_slow": Quantity(
                slow[0].top(INNER, "lambda"), "", "$Λ_f$ at 5 kN, 0.02 m/s"
            ),
            "lambda_light_slow": Quantity(slow[1].top(INNER, "lambda"), "", "at 1 kN, 0.02 m/s"),
            "lambda_light_fast": Quantity(quick.top(INNER, "lambda"), "", "at 1 kN, 1.2 m/s"),
            "friction_slow": Quantity(slow[0].top(INNER, "mu"), "", "μ at 5 kN, 0.02 m/s"),
            "friction_fast": Quantity(quick.top(INNER, "mu"), "", "μ at 1 kN, 1.2 m/s"),
            "viscosity_ratio": Quantity(
                oils["mineral"].viscosity / oils["pao48"].viscosity, "", "η mineral over PAO"
            ),
            "pressure_viscosity_ratio": Quantity(
                oils["mineral"].pressure_viscosity / oils["pao48"].pressure_viscosity,
                "",
                "ξ mineral over PAO",
            ),
            "passage_60_speed": Quantity(
                passage.speed(
                    b, oils["mineral"], 5000.0, result["roughness_bearing_mineral"].value
                ),
                "m/s",
                "$U_r$ at which the bearing has 60 pF, mineral",
            ),
        }
    return result
