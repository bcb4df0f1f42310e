# SPDX-License-Identifier: GPL-2.0-or-later
"""The figures of the paper. Each is a function that takes a `Book` and returns (matplotlib figure,
DataFrame of the plotted values)."""

from raceway.paper.figures import azimuth, capacitance, free, loads, pressure, regime

FIGURES = {
    "6a": pressure.permittivity,
    "6b": pressure.around,
    "8a": azimuth.by_load,
    "8b": capacitance.by_load,
    "9": azimuth.by_clearance,
    "10a": capacitance.mineral,
    "10b": capacitance.pao,
    "11": capacitance.by_film,
    "12a": regime.by_speed,
    "12b": regime.by_capacitance,
    "A.2": loads.distribution_page,
    "A.4": free.play,
}
