# SPDX-License-Identifier: GPL-2.0-or-later
"""Quantities that follow only from formulas and the data of the bearing."""

import numpy as np

from raceway.paper import cases, theory
from raceway.paper.book import Book
from raceway.theory import capacitance, damping, film, hertz, kinematics
from raceway.theory.bearing import INNER, OUTER
from raceway.theory.steel import STEEL

CAGE_BALL = 4.19e-3  # m, R_z (table 1)
WIDTH = 18e-3  # m, width of a 6208 (ISO 15)


def measure(book: Book, printed: bool) -> dict[str, float]:
    """Return {name: value}; see `quantities`."""
    b, oil = book.bearing, book.oils["mineral"]
    q = theory.largest_load(b, 5000.0)
    result = {}
    for side, name in ((INNER, "inner"), (OUTER, "outer")):
        radii, modulus = b.effective_radii(side), b.effective_modulus
        exact = hertz.exact(*radii)
        shape = hertz.hamrock_brewe(*radii, printed=True) if printed else exact
        stiffness = hertz.stiffness(shape, modulus) / hertz.stiffness(exact, modulus)
        result |= {f"stiffness_{name}": stiffness, f"ellipticity_{name}": shape.kappa}
    contact = theory.contact(b, oil, INNER, q, 0.41, printed=printed)
    r_x, r_y = b.effective_radii(INNER)
    kappa, modulus = hertz.exact(r_x, r_y).kappa, b.effective_modulus
    group = film.group(oil.viscosity, oil.pressure_viscosity, modulus, r_x, kappa, 0.41, q)
    result |= {
        "h_min_over_hamrock": contact.h_min / film.hamrock_dowson_min(r_x, group),
        "h_c_over_hamrock": contact.h_c / film.hamrock_dowson_c(r_x, group),
        "h_c_over_h_min": contact.h_c / contact.h_min,
        "sphere_stiffness": 1 / (1 - b.poisson) if printed else 1.0,
    }
    return result if printed else result | _same(book, q)


def _same(book, q):
    b, oil, pao = book.bearing, book.oils["mineral"], book.oils["pao48"].permittivity
    diameter, radius = b.ball_diameter, b.pitch_radius
    shear = b.young / (2 * (1 + b.poisson))
    a, _ = hertz.semi_axes(hertz.exact(*b.effective_radii(INNER)), b.effective_modulus, q)
    h_min = theory.contact(b, oil, INNER, q, 0.41).h_min
    pressures = np.linspace(0, 3e9, 301)
    coaxial = 2 * np.pi * WIDTH / np.log(b.outer_radius / b.inner_radius)
    mass = 4 / 3 * np.pi * b.ball_radius**3 * STEEL.density
    result = {
        "geometric_clearance": 2 * (b.outer_radius - b.inner_radius - diameter),
        "pocket_gap": 2 * radius * np.sin(np.pi / 18) - b.ball_radius - CAGE_BALL,
        "conformity": b.inner_groove / diameter,
        "clearance_35": 0.0035 * diameter,
        "clearance_20": 0.002 * diameter,
        "entrainment_of_rpm": book.entrainment(477.5),
        "rpm_of_entrainment": cases.rpm(b, 0.41),
        "rigidity_identity": 2 * shear / (1 - b.poisson) / b.effective_modulus,
        "hysteretic": damping.hysteretic(q),
        "film_damping": damping.film(oil.viscosity, a, b.ball_radius, h_min),
        "lambda_of_ball_roughness": film.ratio(1.0, 1.0, 0.2) - 1,
        "vacuum": capacitance.VACUUM,
        "density": capacitance.density_ratio(2.571e9),
        "permittivity_rise": capacitance.permittivity(pao, 2.571e9) / pao,
        "permittivity_step": np.diff(capacitance.permittivity(pao, pressures)).min(),
        "ring_to_ring": (capacitance.VACUUM * oil.permittivity * coaxial, 1e3 * WIDTH),
        "centrifugal": mass * radius * kinematics.frequencies(b).cage ** 2,
    }
    for curvature in (0.08, 0.10, 0.12, 0.14):
        name, groove = f"{curvature:.2f}"[2:], cases.groove(b, curvature)
        result |= {f"groove_{name}": groove, f"conformity_{name}": groove / diameter}
    return result
