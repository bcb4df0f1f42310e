# SPDX-License-Identifier: GPL-2.0-or-later
"""Compare the loads of a run at equilibrium with statics in Python, for the bearing and the load of
a scene, without friction, film and speed, and with strong damping."""

import numpy as np
from fuzz.lab import Finding
from fuzz.scene import FREEDOMS
from raceway import static
from raceway.errors import NoEquilibrium
from raceway.theory.bearing import Bearing, Layout

# Fraction of the largest load; the balls roll a little while the run approaches equilibrium.
SHARE = 2e-2


def rest(scene):
    """Return the scene at rest, or None if nothing supports its ring."""
    ring = dict(scene["inner"])
    ring |= {"mass": 0.02, "inertia": [2e-6, 2e-6], "ramp": 0, "rotating": None, "unbalance": None}
    ring |= {"spin": 0, "supports": {}}
    ring["freedoms"] = {
        name: mode if mode == ["free"] else ["fixed"] for name, mode in ring["freedoms"].items()
    }
    radius = scene["grooves"][1][0]
    for name, mode in ring["freedoms"].items():
        if mode == ["free"]:
            scale = radius**2 if name.startswith("r") else 1
            ring["supports"][name] = [1.0 * scale, 3e3 * scale]
    still = {"film": False, "law": "hysteresis 5", "speed": [0, 0], "implicit": "order 1"}
    still |= {"step": 5.0e-5, "every": 20, "samples": 5, "outer": None, "gravity": None}
    # `seat` displaces the balls, and the displacement would persist if the ring is held
    still |= {} if ring["freedoms"]["z"] == ["free"] else {"seat": 0}
    still |= {"flaws": [], "capacitance": None, "inner": ring, "cage": None, "cage_ring": None}
    return scene | still


def check(scene, lab):
    """Compare the loads of all balls on both raceways with statics."""
    still = rest(scene)
    if _theory(still, still["phase"]) is None:
        return False
    figures = lab.figures(still, "rest")
    # without friction, the balls would roll away
    place = figures["atoms"][1][-1, : scene["balls"], 2:4]
    theory = _theory(still, np.arctan2(place[:, 1], place[:, 0]))
    if theory is None:
        return False
    columns, table = figures["contacts"]
    last, before = table[-1], table[-2]
    # a ball next to the load line carries more than the force across that line
    lever = np.sin(min(2 * np.pi / scene["balls"], np.pi / 2))
    if _unrest(still["inner"], scene["grooves"][0][0], *figures["rings"]) > SHARE * lever:
        return False
    at = columns.index("load")
    shape = (scene["balls"], 2, 2)  # ball, raceway, groove
    loads = last[:, at].reshape(shape)
    settled = abs(last[:, at] - before[:, at]).max() / max(loads.max(), 1e-9)
    for side, contacts in enumerate((theory.inner, theory.outer)):
        wanted = np.atleast_2d(contacts.load).T
        got = loads[:, side, : wanted.shape[1]]
        off = abs(got - wanted).max() / max(wanted.max(), 1e-9)
        if off > SHARE + 3 * settled:
            raise Finding(
                f"statics: loads of side {side} differ by {off:.2g} of the largest load, which is "
                f"{wanted.max():.4g} N in Python and {got.max():.4g} N in the run"
            )
    return True


def _unrest(ring, radius, names, table):
    """Return the fraction of the load that the contacts do not yet carry."""
    row = table[-1, table[-1, :, 0].argmin()]
    loads = zip(("fx", "fy", "fz", "mx", "my"), [*ring["force"], *ring["moment"]], strict=True)
    free = [
        (row[names.index(name)], load, radius if name[0] == "m" else 1)
        for (name, load), freedom in zip(loads, FREEDOMS, strict=True)
        if ring["freedoms"][freedom] == ["free"]
    ]
    scale = max((abs(load) / length for _, load, length in free), default=0) + 1e-9
    off = [abs(carried + load) / (scale * length) for carried, load, length in free]
    return max(off, default=0)


def _theory(scene, phase):
    grooves = [(-arch, arch) if arch else (0.0,) for _, _, arch in scene["grooves"]]
    if len(grooves[0]) != len(grooves[1]):
        return None
    (inner, groove_i, _), (outer, groove_o, _) = scene["grooves"]
    bearing = Bearing(
        scene["balls"],
        scene["diameter"],
        inner,
        outer,
        groove_i,
        groove_o,
        layout=Layout((0.0,), (grooves[0],), (grooves[1],)),
    )
    ring = scene["inner"]
    held = {name: 0.0 for name, mode in ring["freedoms"].items() if mode != ["free"]}
    force = ring["force"]
    try:
        return static.equilibrium(
            bearing,
            float(np.hypot(*force[:2])),
            force[2],
            moment=ring["moment"],
            held=held,
            load_azimuth=float(np.arctan2(force[1], force[0])),
            phase=phase,
            finite_shift=True,
        )
    except NoEquilibrium:
        return None
