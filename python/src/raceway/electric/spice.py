# SPDX-License-Identifier: GPL-2.0-or-later
"""Export a bearing as a SPICE element whose capacitances and leaks follow a run and are
interpolated linearly between its samples (docs/electric_circuit, Export).

A variable capacitance is written in terms of its charge, Q = C(t) V, because a capacitor with a
`C=` expression would omit the current V dC/dt. The element was tested with ngspice.
"""

from collections.abc import Iterator
from pathlib import Path

import numpy as np

from raceway.arrays import Floats
from raceway.electric.films import Films, series
from raceway.files import FilePath, folder, whole

RACEWAYS = ("inner", "outer")
FARADS, SIEMENS = 1e-12, 1e-9  # F and S per volt at a controlling node
# ohm, gives every node a path for direct current, with a time constant of 10 000 s at 10 pF
LARGE = 1e15
PER_LINE = 4  # points of a piecewise linear source in each line of the file
NAME = "bearing"


def element(films: Films, name: str = NAME) -> str:
    """Return the text of two subcircuits with the terminals inner and outer. In `name`, every ball
    is a node; `name` followed by `_total` has the total capacitance and leak of the bearing.

    The two are equivalent as long as the balls are uncharged. A ball becomes charged if the leaks
    divide the voltage between its two films in another ratio than the capacitances do.
    """
    return "\n".join([*_heading(films, name), *_network(films, name), "", *_total(films, name), ""])


def write(films: Films, out: FilePath, name: str = NAME) -> Path:
    """Write `element` to `name`.cir and the table of `write_lines` to `name`.pwl, both in the
    folder `out`, and return the path of the .cir file. Raises `RunError` if a file cannot be
    written."""
    out = folder(out)
    write_lines(films, out / f"{name}.pwl")
    text = element(films, name)
    return whole(out / f"{name}.cir", lambda part: part.write_text(text, encoding="ascii"))


def write_lines(films: Films, path: FilePath) -> None:
    """Write the bearing as a single element to the text file `path`, with one row per sample: time
    (s), capacitance (F), and leak resistance (ohm, inf if there is no leak). Raises `RunError` if
    the file cannot be written."""
    with np.errstate(divide="ignore"):
        table = np.stack([films.time, series(films.capacitance).bearing, 1 / leak(films)], axis=1)
    heading = "time_s capacitance_F leak_ohm"
    whole(path, lambda part: np.savetxt(part, table, "%.17g", header=heading))


def leak(films: Films) -> Floats:
    """Return the conductance (n,) in S between the rings, with both films of a ball in series."""
    return series(films.conductance).bearing


def _heading(films, name):
    yield f"* {name}: {len(films.balls)} balls, {films.time[0]:g} to {films.time[-1]:g} s"
    yield "* controlling nodes: 1 V is 1 pF or 1 nS. Films do not break down."
    yield f"* use: X1 a b {name}, with .tran ... uic"


def _network(films: Films, name: str) -> Iterator[str]:
    yield f".subckt {name} inner outer"
    for place, ball in enumerate(films.balls):
        middle = f"ball{ball}"
        for side, ends in enumerate((("inner", middle), (middle, "outer"))):
            label = f"{RACEWAYS[side]}{ball}"
            column = (slice(None), side, place)
            capacitance, conductance = films.capacitance[column], films.conductance[column]
            yield from _film(films, label, ends, capacitance, conductance)
    yield f".ends {name}"


def _total(films, name):
    total = f"{name}_total"
    yield f".subckt {total} inner outer"
    yield from _film(
        films, "all", ("inner", "outer"), series(films.capacitance).bearing, leak(films)
    )
    yield f".ends {total}"


def _film(films, label, ends, capacitance, conductance):
    voltage = f"v({','.join(ends)})"
    two = " ".join(ends)
    yield from _lines_of(f"c_{label}", films.time, capacitance / FARADS)
    yield f"C_{label} {two} Q='{FARADS:g}*v(c_{label})*{voltage}'"
    if conductance.any():
        yield from _lines_of(f"g_{label}", films.time, conductance / SIEMENS)
        yield f"B_{label} {two} I={SIEMENS:g}*v(g_{label})*{voltage}"
    yield f"R_{label} {two} {LARGE:g}"


def _lines_of(node, time, values):
    """Yield the lines of a piecewise linear source of `values` at `node`."""
    yield f"V_{node} {node} 0 PWL("
    points = [f"{t:.17g} {value:.17g}" for t, value in zip(time - time[0], values)]
    for start in range(0, len(points), PER_LINE):
        yield "+ " + "  ".join(points[start : start + PER_LINE])
    yield "+ )"
