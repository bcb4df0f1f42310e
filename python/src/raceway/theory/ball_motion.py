# SPDX-License-Identifier: GPL-2.0-or-later
"""Motion of a ball that touches more grooves than it can roll on.

The rotation of a ball has two components (radial, axial) in the plane through the bearing's axis,
and its centre orbits. The sliding and spin speeds at its contacts are linear functions of these
three speeds. Under Coulomb's law, the forces and moments on the ball are in equilibrium where the
total power loss of all contacts is smallest. The spin moment is computed in closed form. The power
is then piecewise linear, so three of its terms vanish at the minimum (`least`).

If the loads change slightly, such a minimum can jump to another one that costs the same, for
example when a ball begins to slide at a light contact instead of spinning more at a heavy one. The
traction of a rolling contact is, however, proportional to its creep until the contact slides as a
whole, and its spin moment likewise. A ball with several contacts then moves from one minimum to
the other through motions in between (`driven`).
"""

from itertools import combinations

import numpy as np

from raceway.arrays import Floats
from raceway.core import laws
from raceway.theory import hertz, kinematics, sliding, spin
from raceway.theory.bearing import INNER, Bearing
from raceway.theory.static import Equilibrium

NEWTON = 30  # largest number of Newton steps for one `creeping` motion
LAG = 0.01  # difference in speed from the cage, as a fraction, over which the cage drives a ball


def rates(
    bearing: Bearing, raceways: Floats, angle: Floats, ring: float
) -> tuple[Floats, Floats, Floats]:
    """Return (lines (2 C, 3), goal (2 C,), ring speeds (C,)) for the C contacts of a ball with
    `raceways` at the contact angles `angle` (rad). `lines` times the motion of the ball minus
    `goal` gives, for each contact, the speed of the ball relative to the ring in m/s, followed by
    the spin at each contact in rad/s.

    The motion consists of the rotation (radial, axial) in rad/s and the speed of the centre in m/s.
    The inner ring turns at `ring` rad/s; the ring speeds are surface speeds in m/s.
    """
    radius, pitch = bearing.ball_radius, bearing.pitch_radius
    out = np.where(raceways == INNER, -1.0, 1.0)
    radial, axial = out * np.cos(angle), out * np.sin(angle)  # direction from ball to raceway
    turning = np.where(raceways == INNER, ring, 0.0)
    slides = np.stack([-radius * axial, radius * radial, np.ones(len(out))], 1)
    spins = np.stack([radial, axial, np.zeros(len(out))], 1)
    surface = turning * (pitch + radius * radial)
    return np.concatenate([slides, spins]), np.concatenate([surface, turning * axial]), surface


def gyroscopic(
    bearing: Bearing, state: Equilibrium, ring: float, orbit: float | Floats, density: float
) -> Floats:
    """Return the coefficient of friction (Z,) that is needed to hold each ball against its
    gyroscopic moment J w_c w_r, where w_c is its orbital speed and w_r the radial component of its
    rotation; 0 for a ball that is loaded by only one ring. The ball is assumed to roll on its more
    heavily loaded contact with each ring and to spin equally on both. Speeds are in rad/s, density
    in kg/m^3."""
    contacts = [
        [np.atleast_2d(getattr(side, name)) for name in ("load", "angle")]
        for side in (state.inner, state.outer)
    ]
    needed = np.zeros(len(state.azimuth))
    orbit = np.broadcast_to(orbit, needed.shape)
    for ball in range(len(needed)):
        top = [load[:, ball].argmax() for load, _ in contacts]
        loads, angles = np.array(
            [[one[k, ball] for one in side] for side, k in zip(contacts, top)]
        ).T
        if not np.all(loads > 0):
            continue
        lines, goal, _ = rates(bearing, np.array([INNER, 1 - INNER]), angles, ring)
        lines[2], goal[2] = lines[2] - lines[3], goal[2] - goal[3]
        turn = np.linalg.solve(lines[:3], goal[:3])[0]
        inertia = 8 / 15 * np.pi * bearing.ball_radius**5 * density
        needed[ball] = abs(inertia * orbit[ball] * turn) / (bearing.ball_radius * loads.sum())
    return needed


def least(lines: Floats, goal: Floats, weight: Floats, radius: float) -> Floats:
    """Return the motion (3,) of `rates` that minimises the sum of `weight` (2 C,) times the
    magnitudes of all sliding and spin speeds."""
    triples = np.array(list(combinations(range(len(goal)), 3)))
    size = np.array([radius, radius, 1.0])
    regular = triples[np.abs(np.linalg.det((lines / size)[triples])) > 1e-6 * radius**-2]
    tried = np.linalg.solve(lines[regular], goal[regular][..., None])[..., 0]
    return tried[np.argmin(np.abs(tried @ lines.T - goal) @ weight)]


def creeping(
    lines: Floats, goal: Floats, weight: Floats, creep: Floats, motion: Floats, radius: float
) -> Floats:
    """Return the motion (3,) at which forces and moments balance if each of them is `weight` times
    v/sqrt(v^2 + creep^2). Here v is `lines` times the motion minus `goal`, and `creep` is the speed
    over which a contact begins to slide or spin. The search starts from `motion`.

    The sum of weight times sqrt(v^2 + creep^2) is smallest there, and Newton's method finds it,
    mostly in a few steps from the result of `least`, otherwise after smaller and smaller creeps.
    """
    size = np.array([radius, radius, 1.0])
    rows, start = lines / size, motion * size
    at, found = _smallest(rows, goal, weight, creep, start)
    if not found:
        at = start
        for more in 10.0 ** np.arange(5, -1, -1):
            at, _ = _smallest(rows, goal, weight, more * creep, at)
    return at / size


def _smallest(rows, goal, weight, width, at):
    """Return the minimum of weight times sqrt(v^2 + width^2), v = rows at - goal, and whether it
    has been found."""
    speed = rows @ at - goal
    root = np.sqrt(speed**2 + width**2)
    for _ in range(NEWTON):
        slope = rows.T @ (weight * speed / root)
        bend = (rows.T * (weight * width**2 / root**3)) @ rows
        bend += 1e-12 * np.trace(bend) * np.eye(3)
        step, here, part = -np.linalg.solve(bend, slope), weight @ root, 1.0
        way = rows @ step
        while part > 1e-9:
            ahead = np.sqrt((speed + part * way) ** 2 + width**2)
            if weight @ ahead <= here + 1e-4 * part * (slope @ step):
                break
            part /= 2
        else:
            return at, True  # below the rounding error of the power
        at, speed, root = at + part * step, speed + part * way, ahead
        if np.all(np.abs(way) <= 1e-9 * width):
            return at, True
    return at, False


def driven(
    bearing: Bearing,
    raceways: Floats,
    angle: Floats,
    ring: float,
    weight: Floats,
    edge: Floats,
    a: Floats,
) -> Floats:
    """Return the motion (3,) of `rates` of a ball in its cage whose contacts resist sliding and
    spin with forces and moments of at most `weight` (2 C,). They reach these over the speeds of a
    run (docs/tribology), which follow from the sliding speeds `edge` s_e of differential slip (m/s)
    and the semi-axes `a` (m).

    Contacts with two grooves of the outer ring spin and would stop a ball that hardly touches the
    inner ring. The cage drives such a ball with a force that exceeds the resistance of all spins.
    """
    lines, goal, _ = rates(bearing, raceways, angle, ring)
    lean = float(np.average(np.abs(angle), weights=weight[: len(angle)]))
    cage = kinematics.frequencies(bearing, lean, ring).cage * bearing.pitch_radius
    force = 2 * weight[len(angle) :].sum() / bearing.ball_radius
    lines, goal = np.vstack([lines, [0.0, 0.0, 1.0]]), np.append(goal, cage)
    weight = np.append(weight, force)
    edge = np.maximum(edge, sliding.LEAST)
    little = 1e-3 * edge  # m/s, omega a at which the spin moment is still proportional to it
    spins = little / laws.spin_shares(little, edge, 0.0).spin / a
    creep = np.concatenate([edge / sliding.LEAN, spins, [LAG * abs(cage)]])
    found = least(lines, goal, weight, bearing.ball_radius)
    return creeping(lines, goal, weight, creep, found, bearing.ball_radius)


def speeds(bearing: Bearing, ring: float, state: Equilibrium) -> tuple[Floats, Floats]:
    """Return (entrainment, rolling) speeds (C, Z) in m/s for all contacts of an `Equilibrium`,
    loaded or not. The entrainment speed is half the sum of the speeds of both surfaces, and the
    rolling speed is R_x times the rotation of the ball relative to the ring about the rolling axis.
    The two are equal if there is no sliding.

    Both follow from rolling at each contact's own angle. For rings with several grooves they follow
    instead from the motion of each ball that is held by both rings, with one coefficient of
    friction at all of its contacts.
    """
    angle = np.vstack([state.inner.angle, state.outer.angle])
    speed = kinematics.entrainment(bearing, ring, angle)
    raceways = np.array(bearing.raceways)
    if len(raceways) == 2 or not ring:
        return speed, speed
    rolling, radius = speed.copy(), bearing.ball_radius
    r_d = np.array([sliding.deformed_radius(bearing.groove(side), radius) for side in raceways])
    load, a = (
        np.vstack([getattr(side, name) for side in (state.inner, state.outer)])
        for name in ("load", "a")
    )
    for ball in range(angle.shape[1]):
        live = load[:, ball] > 0
        held = {*raceways[live]} == {*raceways}
        if not held and np.count_nonzero(live) < 2:
            continue
        r_x, r_y = np.array([
            bearing.effective_radii(side, lean) for side, lean in zip(raceways, angle[:, ball])
        ]).T  # fmt: skip
        turns = spin.moment(load[:, ball], 1.0, a[:, ball], hertz.exact(r_x, r_y).second)
        lines, goal, surface = rates(bearing, raceways, angle[:, ball], ring)
        weight, seen = np.concatenate([load[:, ball], turns]), np.tile(live, 2)
        several = not held or live.sum() > 2
        if several:
            edge = sliding.edge_slip(speed[live, ball], a[live, ball], r_d[live], r_x[live])
            own = raceways[live], angle[live, ball], ring, weight[seen], edge, a[live, ball]
            motion = driven(bearing, *own)
        else:
            motion = least(lines[seen], goal[seen], weight[seen], radius)
        faster = (lines @ motion - goal)[: len(raceways)]
        # ratio of the distances of the contact and the ball centre from the bearing's axis; R_x/R_b
        out = np.where(raceways == INNER, -1.0, 1.0) * np.cos(angle[:, ball])
        ratio = 1 + radius * out / bearing.pitch_radius
        slips = ~live | several  # contacts that do not slip roll
        own = np.abs(surface + faster / 2 - motion[2] * ratio)
        turned = ratio * np.abs(surface / ratio + faster - motion[2])
        speed[slips, ball], rolling[slips, ball] = own[slips], turned[slips]
    return speed, rolling
