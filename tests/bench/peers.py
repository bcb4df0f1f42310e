# SPDX-License-Identifier: GPL-2.0-or-later
"""Compare several programs for a 6208 under 5 kN, and write build/bench/peers.rst:

    python tests/bench/peers.py [rounds]

The programs are stock LIGGGHTS with smooth cylinders and with triangle meshes (decks in
tests/bench/peers), Exudyn's ball bearing, and Raceway, both with its implicit integrator and with
velocity Verlet and the friction law that suits it. Programs whose results converge first try a list
of settings, and are then run with the best one. Every round runs all programs, with and without
output, so that a drift in the speed of the machine affects all of them.
"""

import statistics
from functools import partial
from importlib.metadata import PackageNotFoundError, version

import numpy as np
import torus_stl
from machine import count_asked, csv_table, publish
from peer_choice import ALLOWED, Peer, Setting, choose
from peer_runs import (
    BEARING,
    BOTH_ALIKE,
    DECKS,
    LOAD,
    OUT,
    PASS,
    PERIOD,
    ROOT,
    SPEED,
    SPHERE_ON_PLANE,
    STIFFNESS,
    Failure,
    cylinders,
    exact_shift,
    exudyn,
    precision,
    raceway,
    tori,
)
from raceway.theory.bearing import INNER, OUTER
from work_precision import SPRING

ROUNDS = 3
MESHES = {"180x8": (180, 8), "360x16": (360, 16), "720x32": (720, 32)}
# rad, extent of the meshed groove on either side of its bottom; at 5 kN, the contact extends to 18
# degrees
REACH = np.radians(40)
SECANT = BOTH_ALIKE * (exact_shift() / 2) ** 0.5  # N/m, stiffness of two equal linear contacts
FITTED = BEARING.young * BOTH_ALIKE / SPHERE_ON_PLANE
SHARP, SMOOTH = "curvature 0.25", "curvature 20 curvature_tolerant yes"
# On the tori, a ball passes two to four facets before it escapes, regardless of the size of the
# facets. With longer steps, balls escape earlier.
SCENES = [  # name, function that is called with or without output
    ("stock LIGGGHTS, smooth cylinders", partial(cylinders, BEARING.young)),
    ("stock LIGGGHTS, STL tori, 180 by 8 facets per ring", partial(tori, "180x8", 16000, SHARP)),
    ("STL tori, 360 by 16 facets", partial(tori, "360x16", 8000, SHARP)),
    ("STL tori, 720 by 32 facets", partial(tori, "720x32", 4000, SHARP, step=2e-7)),
    ("STL tori, 360 by 16 facets, edges switched off", partial(tori, "360x16", 8000, SMOOTH)),
    (
        "Exudyn, linear contact of Exudyn's bearing test (5e6 N/m)",
        partial(exudyn, 5e6, 1.0, 0.2, PERIOD / 2),
    ),
    (
        f"Exudyn, linear contact of {SECANT:.3g} N/m, exact at the largest load",
        partial(exudyn, SECANT, 1.0, 0.1, PERIOD / 16),
    ),
    ("Raceway, dry, with cage: the main deck", partial(raceway, "dry", lubricant="dry")),
]
WITHOUT = {name for name, _ in SCENES if "STL" not in name}  # also run without output


def fixed(call, divisor):
    """Return a setting whose step divides the time between samples."""
    return Setting(f"{PERIOD / divisor * 1e6:.3g} µs", partial(call, step=PERIOD / divisor))


def verlet(step):
    """Return a setting of Raceway with velocity Verlet and with the friction spring."""
    run = partial(precision, "verlet", integrator="verlet", friction=SPRING, step=step)
    return Setting(f"{step * 1e6:.3g} µs", run)


def implicit(steps, tolerance):
    """Return a setting of Raceway's implicit integrator for a number of host steps per ball pass
    and a tolerance (m). The record always has 200 samples per ball pass."""
    words = f"{steps} host steps per ball pass, {float(tolerance) * 1e9:g} nm"
    return Setting(
        words,
        partial(
            precision,
            "implicit",
            # the deck rounds the step down so that there is a whole number of steps per sample
            step=1.001 * PASS / steps,
            samples=steps,
            within=200 // steps,
            control=f"tolerance {tolerance}",
        ),
    )


STIFFENED = partial(cylinders, FITTED)
EXPONENT = partial(exudyn, BOTH_ALIKE, 1.5, 0.0)
PEERS = [  # programs whose results converge
    Peer(
        "stock LIGGGHTS, smooth cylinders, modulus raised to "
        f"{FITTED / 1e9:.0f} GPa to fit the exact stiffness",
        [fixed(STIFFENED, n) for n in (352, 176, 88, 64, 56, 44)],
        fixed(STIFFENED, 704),
    ),
    Peer(
        "Exudyn, exponent 1.5, exact stiffness, no friction",
        [fixed(EXPONENT, n) for n in (32, 16, 8, 4, 2, 1)],
        fixed(EXPONENT, 64),
    ),
    Peer(
        "Raceway, velocity Verlet with friction spring: film, cage",
        [verlet(step) for step in (4e-7, 8e-7, 1.2e-6, 1.4e-6, 1.6e-6)],
        verlet(2e-7),
    ),
    Peer(
        "Raceway, implicit: film, cage",
        [implicit(n, tol) for n in (200, 20, 10) for tol in ("1e-9", "1e-8", "1e-7")],
        Setting(
            "1600 host steps per ball pass, 0.1 nm",
            partial(precision, "implicit", step=PASS / 1600, control="tolerance 1e-10"),
        ),
    ),
]
HEADS = (
    *("model", "step µs", "simulated ms", "cost, with output", "cost, nothing written"),
    *("error, same displacement", "error, same ring load"),
)
TRIED = ("model", "setting", "error relative to the finest", "cost")


def percent(part):
    """Format a fraction in per cent, with more decimals if it is small."""
    return f"{100 * part:+.{2 if abs(part) < 0.1 else 1 if abs(part) < 1 else 0}f} %".replace(
        "-0.00", "+0.00"
    )


def number(value):
    """Format a number to two significant digits, or as a whole number if it is 100 or more."""
    return f"{value:.0f}" if value >= 100 else f"{value:.2g}"


def spread(outcomes):
    """Return the median and the range of the costs as a string."""
    costs = [each.cost for each in outcomes]
    return f"{number(statistics.median(costs))} ({number(min(costs))} to {number(max(costs))})"


def row(name, outcomes, bare):
    """Return the table row for a scene, where `outcomes` are the runs with output and `bare` those
    without."""
    for why in (each for each in outcomes + bare if isinstance(each, Failure)):
        cells = ["", "", f"failed: {why}", "", "", ""]
        break
    else:
        o = outcomes[-1]
        lost = f"; {o.left} balls left" if o.left < BEARING.balls else ""
        cells = [
            number(o.step * 1e6),
            number(o.simulated * 1e3),
            spread(outcomes),
            spread(bare) if bare else "not run",
            f"{percent(o.same_shift)} ({percent(o.low)} to {percent(o.high)}){lost}",
            percent(o.same_load),
        ]
    return [name, *cells]


def tried_rows(peer, choice):
    """Return table rows that list the settings tried for a peer."""
    rows = []
    for one in choice.tried:
        worth = f"{one.error:.0e}" if np.isfinite(one.error) else "stopped"
        if np.isfinite(one.cost) and not np.isfinite(one.error):
            worth = "balls lost, or samples at other times"
        price = number(one.cost) if np.isfinite(one.cost) else ""
        words = one.words + (", **chosen**" if one.words == choice.setting.words else "")
        rows.append((peer.name, words, worth, price))
    return rows


def exudyn_version():
    try:
        return version("exudyn")
    except PackageNotFoundError:
        return "not installed"


def write(rounds, choices):
    """Write the page with the text of peers/page.txt; `rounds` maps (name, output) to a list of
    outcomes."""
    names = dict.fromkeys(name for name, _ in rounds)
    rows = [row(name, rounds[name, True], rounds.get((name, False), [])) for name in names]
    tried = [row for peer, choice in zip(PEERS, choices) for row in tried_rows(peer, choice)]
    publish(
        "Other programs",
        (ROOT / DECKS / "page.txt").read_text(),
        rounds=len(next(iter(rounds.values()))),
        exudyn=exudyn_version(),
        load=LOAD,
        speed=SPEED,
        table=csv_table(HEADS, rows),
        chosen=csv_table(TRIED, tried),
        finest=[f"- {peer.name}: {peer.finest.words}" for peer in PEERS],
        allowed=ALLOWED,
        shift=exact_shift() * 1e6,
        sphere=SPHERE_ON_PLANE / 1e10,
        inner=STIFFNESS[INNER] / 1e10,
        outer=STIFFNESS[OUTER] / 1e10,
        both=BOTH_ALIKE / 1e10,
    )


def measured(call):
    try:
        return call()
    except Failure as failure:
        return failure


def main():
    """Measure, print the results and write the page."""
    count = count_asked(ROUNDS)
    (ROOT / OUT).mkdir(parents=True, exist_ok=True)
    for name, (around, across) in MESHES.items():
        for side, ring in ((INNER, "inner"), (OUTER, "outer")):
            torus_stl.write(
                ROOT / OUT / f"{ring}-{name}.stl",
                torus_stl.triangles(BEARING, side, around, across, REACH),
            )
    choices = []
    for peer in PEERS:
        choices.append(choose(peer))
        print(peer.name, *choices[-1].tried, "taken:", choices[-1].setting.words, flush=True)
    calls = SCENES + [(p.name, choice.setting.call) for p, choice in zip(PEERS, choices)]
    bare = WITHOUT | {peer.name for peer in PEERS}
    rounds = {}
    for number in range(count):
        for name, call in calls:
            for output in (True, False) if name in bare else (True,):
                ended = measured(partial(call, output=output) if name in bare else call)
                rounds.setdefault((name, output), []).append(ended)
                said = ended if isinstance(ended, Failure) else f"{ended.cost:.4g}"
                print(f"round {number + 1} of {count}: {name}, output {output}: {said}", flush=True)
    write(rounds, choices)


if __name__ == "__main__":
    main()
