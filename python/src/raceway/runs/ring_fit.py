# SPDX-License-Identifier: GPL-2.0-or-later
"""Stiffness and damping of a bearing, estimated from small motions of its ring in a run (free decay
or vibration under varying loads).

The force of the balls on the ring is fitted by f = f_0 - K q - C v in a least-squares sense over
all samples. K and C therefore apply to the excited frequencies and include the inertia of the balls
and the film laws.
"""

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from raceway.arrays import Floats
from raceway.errors import RunError
from raceway.runs.run import Run

# {degree of freedom: (column of the displacement, column of the force)}
COLUMNS = {
    "x": ("x", "fx"),
    "y": ("y", "fy"),
    "z": ("z", "fz"),
    "rx": ("tilt_1", "mx"),
    "ry": ("tilt_2", "my"),
}
APART = 1e-4  # ratio of singular values below which motions count as dependent


class Fit(NamedTuple):
    """Fit for n degrees of freedom, in SI units."""

    stiffness: Floats  # (n, n)
    damping: Floats  # (n, n)
    stiffness_error: Floats  # (n, n), standard errors, provided that the residuals are noise
    damping_error: Floats  # (n, n), standard errors under the same assumption
    left: Floats  # (n,), rms of the residual of each force divided by the rms of its variation


def fitted(
    place: ArrayLike, velocity: ArrayLike, force: ArrayLike, others: ArrayLike | None = None
) -> Fit:
    """Return the `Fit` to the positions, velocities and forces on the ring (N, n) at N samples.

    `others` (N, k) are further functions of time that contribute to the force, for instance a sine
    with the ball pass frequency. Raise `ValueError` if there are too few samples or if the motions
    are not independent.

    >>> time = np.linspace(0, 1, 500)
    >>> place, velocity = np.sin(20 * time)[:, None], 20 * np.cos(20 * time)[:, None]
    >>> found = fitted(place, velocity, 3.0 - 100.0 * place - 2.0 * velocity)
    >>> round(float(found.stiffness[0, 0]), 6), round(float(found.damping[0, 0]), 6)
    (100.0, 2.0)
    """
    q, v, f = (np.asarray(one, float) for one in (place, velocity, force))
    if not (q.ndim == 2 and q.shape == v.shape == f.shape):
        raise ValueError(
            f"positions {q.shape}, velocities {v.shape} and forces {f.shape} must agree"
        )
    beside = np.zeros((len(q), 0)) if others is None else np.asarray(others, float)
    known = np.concatenate([q, v, beside], axis=1)
    known, free = known - known.mean(0), f - f.mean(0)
    samples, columns = known.shape
    if samples < 2 * columns + 2:
        raise ValueError(f"{samples} samples are too few for {columns} motions")
    size = np.sqrt((known**2).mean(0))
    if not size.all():
        raise ValueError(f"motion {int(np.argmin(size))} of {columns} is constant")
    left, singular, right = np.linalg.svd(known / size, full_matrices=False)
    if singular[-1] < APART * singular[0]:
        raise ValueError("the motions are not independent: excite each at its own frequency")
    found = right.T @ ((left.T @ free) / singular[:, None]) / size[:, None]
    remains = free - known @ found
    noise = np.sqrt((remains**2).sum(0) / (samples - columns - 1))
    spread = np.sqrt(((right / singular[:, None]) ** 2).sum(0)) / size
    error = spread[:, None] * noise
    n = q.shape[1]
    return Fit(
        -found[:n].T,
        -found[n : 2 * n].T,
        error[:n].T,
        error[n : 2 * n].T,
        np.sqrt((remains**2).mean(0) / (free**2).mean(0)),
    )


def of_run(
    run: Run,
    freedoms: Sequence[str] = tuple(COLUMNS),
    *,
    since: float = -np.inf,
    until: float = np.inf,
    lines: Sequence[float] = (),
) -> Fit:
    """Return the `Fit` for the inner ring of `run` in the degrees of freedom `freedoms`, which are
    some of x, y, z, rx and ry in the frame of the bearing.

    The fit uses samples from the time `since` up to, but not including, `until` (s). `lines` (in
    rad/s) are frequencies of the force that are not due to the motion, such as the ball pass
    frequency of a bearing under radial load. Velocities are derivatives of splines through the
    displacements, so the samples must be evenly spaced, with ten or more per period. Raise
    `ValueError` in the same cases as `fitted`, and `RunError` for an unknown degree of freedom or
    unevenly spaced samples.
    """
    from scipy.interpolate import CubicSpline

    if unknown := [name for name in freedoms if name not in COLUMNS]:
        raise RunError(f"degree of freedom '{unknown[0]}' is not one of {', '.join(COLUMNS)}")
    rings = run.rings
    time = rings["time"].to_numpy()
    steps = np.diff(time)
    if len(steps) < 2 or not np.allclose(steps, steps[0], rtol=1e-6, atol=0):
        raise RunError("a fit of small motions needs evenly spaced samples")
    place = np.stack([rings[COLUMNS[name][0]].to_numpy() for name in freedoms], axis=1)
    force = np.stack([rings[COLUMNS[name][1]].to_numpy() for name in freedoms], axis=1)
    velocity = CubicSpline(time, place).derivative()(time)
    # The derivative of a spline is one-sided at its ends, so samples near the ends are not used.
    keep = (time >= since) & (time < until) & (time > time[3]) & (time < time[-4])
    sines = [wave(line * time) for line in lines for wave in (np.sin, np.cos)]
    others = np.stack(sines, axis=1)[keep] if sines else None
    return fitted(place[keep], velocity[keep], force[keep], others)
