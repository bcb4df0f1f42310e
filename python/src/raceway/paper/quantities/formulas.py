# SPDX-License-Identifier: GPL-2.0-or-later
"""Quantities that follow only from formulas and the data of the bearing."""

import numpy as np

from raceway.paper import cases, theory
from raceway.paper.book import Book
from raceway.paper.quantity import Quantity
from raceway.theory import capacitance, damping, film, hertz, kinematics
from raceway.theory.bearing import INNER, OUTER
from raceway.units import prefixed

CAGE_BALL = 4.19e-3  # m, R_z (table 1)
STEEL = 7800.0  # kg/m3
WIDTH = 18e-3  # m, width of a 6208 (ISO 15)


def measure(book: Book, printed: bool) -> dict[str, Quantity]:
    """Return {name: `Quantity`}; see `quantities`."""
    b, oil = book.bearing, book.oils["mineral"]
    q = theory.largest_load(b, 5000.0)
    result = {}
    for side, name in ((INNER, "inner"), (OUTER, "outer")):
        radii, modulus = b.effective_radii(side), b.effective_modulus
        shape = hertz.hamrock_brewe(*radii, printed=True) if printed else hertz.exact(*radii)
        exact = hertz.exact(*radii)
        result |= {
            f"stiffness_{name}": Quantity(
                hertz.stiffness(shape, modulus) / hertz.stiffness(exact, modulus),
                "",
                f"stiffness relative to exact Hertz theory, {name}",
            ),
            f"ellipticity_{name}": Quantity(shape.kappa, "", f"κ {name}"),
        }
    contact = theory.contact(b, oil, INNER, q, 0.41, printed=printed)
    r_x, r_y = b.effective_radii(INNER)
    group = film.group(
        oil.viscosity,
        oil.pressure_viscosity,
        b.effective_modulus,
        r_x,
        hertz.exact(r_x, r_y).kappa,
        0.41,
        q,
    )
    result |= {
        "h_min_over_hamrock": Quantity(
            contact.h_min / film.hamrock_dowson_min(r_x, group), "", "$h_{min}$ over Hamrock-Dowson"
        ),
        "h_c_over_hamrock": Quantity(
            contact.h_c / film.hamrock_dowson_c(r_x, group), "", "$h_c$ over Hamrock-Dowson"
        ),
        "h_c_over_h_min": Quantity(contact.h_c / contact.h_min, "", "$h_c/h_{min}$"),
        "sphere_stiffness": Quantity(
            1 / (1 - b.poisson) if printed else 1.0,
            "",
            "stiffness of ball on cage ball relative to Hertz",
        ),
    }
    return result if printed else result | _same(book, q)


def _same(book, q):
    b, oil, pao = book.bearing, book.oils["mineral"], book.oils["pao48"]
    diameter, radius = b.ball_diameter, b.pitch_radius
    result = {
        "geometric_clearance": Quantity(
            2 * (b.outer_radius - b.inner_radius - diameter), "m", "2 ($R_e - R_i - 2 R_b$)"
        ),
        "pocket_gap": Quantity(
            2 * radius * np.sin(np.pi / 18) - b.ball_radius - CAGE_BALL,
            "m",
            "gap between ball and cage ball",
        ),
        "conformity": Quantity(b.inner_groove / diameter, "", "$r_c/D$"),
        "clearance_35": Quantity(0.0035 * diameter, "m", "0.0035 D"),
        "clearance_20": Quantity(0.002 * diameter, "m", "0.002 D"),
        "entrainment_of_rpm": Quantity(book.entrainment(477.5), "m/s", "$U_r$ at 477.5 rpm"),
        "rpm_of_entrainment": Quantity(cases.rpm(b, 0.41), "rpm", "speed for 0.41 m/s"),
        "rigidity_identity": Quantity(_rigidity(b), "", "$2G/(1-ν)$ over $E'$"),
        "hysteretic": Quantity(
            damping.hysteretic(q), "N s/m", "hysteretic damping at the largest load"
        ),
        "film_damping": Quantity(
            damping.film(
                oil.viscosity,
                hertz.semi_axes(hertz.exact(*b.effective_radii(INNER)), b.effective_modulus, q)[0],
                b.ball_radius,
                theory.contact(b, oil, INNER, q, 0.41).h_min,
            ),
            "N s/m",
            "film damping there, 0.41 m/s",
        ),
        "lambda_of_ball_roughness": Quantity(
            film.ratio(1.0, 1.0, 0.2) - 1, "%", "change of $Λ_f$ due to a ball one fifth as rough"
        ),
        "vacuum": Quantity(capacitance.VACUUM, "F/m", "ε₀"),
        "density": Quantity(capacitance.density_ratio(2.571e9), "", "ρ/ρ₀ at 2.571 GPa"),
        "permittivity_rise": Quantity(
            capacitance.permittivity(pao.permittivity, 2.571e9) / pao.permittivity,
            "",
            "ratio of $ε_r$ at 2.571 GPa to $ε_r$ at ambient pressure",
        ),
        "permittivity_step": Quantity(
            np.diff(capacitance.permittivity(pao.permittivity, np.linspace(0, 3e9, 301))).min(),
            "",
            "smallest increase of $ε_r$ per 10 MPa up to 3 GPa",
        ),
        "ring_to_ring": Quantity(
            capacitance.VACUUM
            * oil.permittivity
            * 2
            * np.pi
            * WIDTH
            / np.log(b.outer_radius / b.inner_radius),
            "F",
            f"rings as a coaxial capacitor {prefixed(WIDTH, 'm', 2)} wide, filled with oil",
        ),
        "centrifugal": Quantity(
            4 / 3 * np.pi * b.ball_radius**3 * STEEL * radius * kinematics.frequencies(b).cage ** 2,
            "N",
            "centrifugal load of a ball at 1 rad/s",
        ),
    }
    for curvature in (0.08, 0.10, 0.12, 0.14):
        name = f"{curvature:.2f}"[2:]
        result[f"groove_{name}"] = Quantity(
            cases.groove(b, curvature), "m", f"$r_c$ for B = {curvature:.2f}"
        )
        result[f"conformity_{name}"] = Quantity(
            cases.groove(b, curvature) / diameter, "", "$r_c/D$"
        )
    return result


def _rigidity(b):
    shear = b.young / (2 * (1 + b.poisson))
    return 2 * shear / (1 - b.poisson) / b.effective_modulus
