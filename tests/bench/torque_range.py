# SPDX-License-Identifier: GPL-2.0-or-later
"""Compare the friction torque of settled runs with that of statics in random scenes under combined
loads, and write build/bench/torque_range.rst:

    python tests/bench/torque_range.py [SCENES]

The scenes are grouped by the reasons that `raceway static` gives for a difference. The exit code is
1 if the torque of a run is outside the range that statics prints.
"""

import sys
import tempfile
from collections import defaultdict
from concurrent.futures import ProcessPoolExecutor
from pathlib import Path

import numpy as np
from deck_runs import MAIN, attempt
from machine import count_asked, csv_table, publish
from raceway.theory import validity
from raceway.theory.cage_drag import CageRing
from torque_scenes import Scene, mean_torque, run_torque

SEED, SCENES = 168, 168
HEADS = ("reasons", "scenes", "run/statics", "printed range", "outside", "stopped runs")
PAGE = "{table}\n{outside}\n"


def drawn(random):
    """Draw a scene; about a quarter of all scenes have a moment."""
    balls, per_ball = int(random.integers(4, 17)), np.exp(random.uniform(*np.log((6, 150))))
    axial = balls * per_ball
    arm = np.exp(random.uniform(*np.log((0.3e-3, 3e-3)))) if random.random() < 0.28 else 0.0
    angle = random.choice([15, 25, 40])
    loads = (axial * random.choice([1 / 3, 1, 3]), axial, arm * axial)
    point = (random.choice([500, 1500, 3000, 8000, 12000]), random.choice([40, 60, 80, 100]))
    return Scene(int(angle), balls, *(round(float(one), 3) for one in loads), *map(int, point))


def compared(scene):
    """Return (reasons, torque of the run over that of statics, or None if the run stopped, smallest
    and largest ratio by statics) for a scene."""
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        found = scene.statics(folder, CageRing(), phases=3)
        texts = " ".join(text for one in found for text in one["warnings"])
        reasons = tuple(key for key, one in validity.TORQUE.items() if one.why in texts)
        mean, ends = mean_torque(found), [one["ranges"]["friction_torque_N_m"] for one in found]
        low, high = min(one["low"] for one in ends), max(one["high"] for one in ends)
        done = attempt(MAIN, **scene.variables(folder))
        ratio = None if done.returncode else run_torque(folder) / mean
    return reasons, ratio, low / mean, high / mean


def row(reasons, found):
    """Return the table row of the scenes with the same reasons."""
    ratios = [ratio for ratio, *_ in found if ratio is not None]
    lows, highs = zip(*((low, high) for _, low, high in found))
    outside = sum(not low <= ratio <= high for ratio, low, high in found if ratio is not None)
    return (
        " and ".join(validity.TORQUE[key].why for key in reasons) or "none",
        len(ratios),
        f"{min(ratios):.2f} to {max(ratios):.2f}" if ratios else "",
        f"{min(lows):.2f} to {max(highs):.2f}",
        outside,
        len(found) - len(ratios),
    )


def main():
    random = np.random.default_rng(SEED)
    scenes = [drawn(random) for _ in range(count_asked(SCENES))]
    groups, outside = defaultdict(list), []
    with ProcessPoolExecutor() as pool:
        for scene, (reasons, ratio, low, high) in zip(scenes, pool.map(compared, scenes)):
            groups[reasons].append((ratio, low, high))
            text = f"{scene}: {ratio and round(ratio, 3)} of {low:.2f} to {high:.2f}, {reasons}"
            print(text, flush=True)
            if ratio is not None and not low <= ratio <= high:
                outside.append(f"* outside: {text}")
    table = csv_table(HEADS, [row(*one) for one in sorted(groups.items())])
    publish("Friction torque of runs and of statics", PAGE, table=table, outside=outside)
    return int(bool(outside))


if __name__ == "__main__":
    sys.exit(main())
