# SPDX-License-Identifier: GPL-2.0-or-later
"""Find the steady temperature of a bearing whose friction is taken from simulation runs.

Statics provides the decrease of friction with temperature, and a run provides the magnitude of the
friction. The temperature of the next run is the one at which the friction from statics, scaled to
the last run, balances the cooling. Every run has a folder named after its variables, in which a
stopped run is resumed.
"""

import json
import math
import os
import signal
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager
from pathlib import Path
from typing import Any

from raceway.errors import RacewayError
from raceway.files import FilePath
from raceway.sweeps.point_run import FINISHED, mapping, run_point
from raceway.sweeps.points import folder_name
from raceway.theory.steady_heat import Case

CLOSE = 0.1  # K, largest difference between the temperature of a run and the one that follows
RANGE = (-40.0, 200.0)  # degrees C, range of temperatures that a deck accepts


def by_runs(
    case: Case,
    folder: FilePath,
    command: Sequence[str],
    *,
    runs: int,
    more: dict[str, str] | None = None,
    say: Callable[[str], None] = lambda line: None,
) -> dict[str, Any]:
    """Return the results of `steady_heat.figures`, with friction scaled to that of simulation runs.

    At most `runs` runs with the models of `case` are executed; there are fewer if the temperature
    changes by less than `CLOSE` kelvin. `command` is a list of program, options and deck; `more`
    contains further variables of the deck. The folders of the runs are in `folder`; finished runs
    are not repeated. `say` is called with a line of text for each run. The results also include
    `runs` and, for the last run, the temperature in degrees C, the power loss in W and its ratio to
    the power loss of statics. `losses_W` contains the losses of the last run. With three nodes, the
    friction of a run is divided between the rings in the same way as in statics. Raise
    `RacewayError` if a run fails or is stopped.
    """
    if case.double_row is not None:
        raise RacewayError(
            "friction from runs requires one row, as in the main deck; leave out --double-row"
        )
    scene = case.scene()
    found = case.steady(scene)
    with _stopped() as stop:
        for number in range(1, runs + 1):
            asked = round(found["temperature_C"], 2)
            if not RANGE[0] <= asked <= RANGE[1]:
                raise RacewayError(
                    f"{asked} C is out of range: a deck accepts {RANGE[0]:g} to {RANGE[1]:g} C"
                )
            variables = _variables(case, asked, found["clearance_warm_m"], more or {})
            place = Path(folder) / folder_name(variables).replace("/", "_")
            status, message = run_point(place, variables, command, retry=True, stop=stop)
            if status != FINISHED:
                raise RacewayError(f"{place}: {message}")
            ran = mapping(place / "summary.json", json.loads)
            power = ran["power_loss_W"]
            scene.share = 1.0
            scene.share = power / scene.at(asked, float(variables["clearance"]))["power_loss_W"]
            found = case.steady(scene)
            change = found["temperature_C"] - asked
            say(
                f"run {number} of at most {runs}: {asked:.2f} C, {power:.4g} W, "
                f"{scene.share:.2f} of statics; next {found['temperature_C']:.2f} C"
            )
            if abs(change) < CLOSE:
                break
    rest = found["warm"].rest(found["temperature_C"], case.clearance)
    return dict(
        case.report(scene, dict(found, losses_W=ran["losses_W"]), rest),
        runs=number,
        run_temperature_C=asked,
        run_power_W=power,
        run_over_statics=scene.share,
    )


def _variables(case, temperature, clearance, more):
    angle = case.four_point
    return {
        "bearing": str(case.bearing),
        "lubricant": str(case.lubricant),
        "load": f"{case.load:.10g}",
        "axial": f"{case.axial:.10g}",
        "rpm": f"{case.rpm:.10g}",
        "clearance": f"{clearance:.4e}",
        "temperature": f"{temperature:.2f}",
        "models": case.models,
        **({} if case.spin_law == "closed" else {"spin_law": case.spin_law}),
        "lubrication": case.supply.kind,
        "oil_level": f"{case.supply.level:.10g}",
        **({"cage": "chain"} if case.cage is None else _cage(case.cage)),
        **({} if angle is None else {"four_point": f"{math.degrees(angle):.9g}"}),
        **more,
    }


def _cage(ring):
    """Return {variable: value} for a `CageRing`."""
    of = {"cage": "ring", "cage_play": f"{ring.play:.10g}", "cage_filled": f"{ring.filled:.10g}"}
    if ring.land is not None:
        radius, clearance, width = ring.land
        of |= {
            "cage_guide": "inner" if ring.inner else "outer",
            "cage_land": f"{radius:.10g}",
            "cage_clearance": f"{clearance:.10g}",
            "cage_width": f"{0.5 * width:.10g}",  # width of each of the two lands
        }
    return of | {"cage_without": "+".join(sorted(ring.without)) or "none"}


@contextmanager
def _stopped() -> Iterator[int]:
    """Yield a descriptor that becomes readable on Ctrl-C, SIGTERM and SIGHUP.

    The run then writes a restart file, from which the next start resumes.
    """
    reading, writing = os.pipe()
    numbers = (signal.SIGINT, signal.SIGTERM, signal.SIGHUP)
    before = [signal.signal(number, lambda *_: os.write(writing, b"x")) for number in numbers]
    try:
        yield reading
    finally:
        for number, handler in zip(numbers, before):
            signal.signal(number, handler)
        os.close(reading)
        os.close(writing)
