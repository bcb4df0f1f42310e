# SPDX-License-Identifier: GPL-2.0-or-later
"""Waviness of a raceway moves the inner ring with the frequency, direction and amplitude predicted
by theory. The 6208 rotates slowly under an axial load of 1 kN, and all nine balls are loaded."""

import numpy as np
import pytest
import raceway
from host import succeed
from raceway.theory import hertz

BALLS, AMPLITUDE = 9, 1e-8  # m
RPM = 600


def waves(*orders, amplitude=AMPLITUDE):
    return " ".join(f"wave {order} {amplitude} 0.3" for order in orders)


def turned(folder, **variables):
    """Return the time (s), the displacement of the inner ring perpendicular to its axis (x + i y)
    and along it (m), the speeds of ring and cage (rad/s), and the quasi-static response per
    amplitude in both directions."""
    succeed("tests/scenarios/in.waves", out=folder, rpm=RPM, **variables)
    run = raceway.open(folder)
    time = run.rings["time"].values
    x, y, z = (run.rings[name].values for name in "xyz")
    azimuth = np.unwrap(np.arctan2(run.balls["y"].values, run.balls["x"].values), axis=0)
    cage = np.polyfit(time, azimuth, 1)[0].mean()
    angle, Q = (float(run.contacts[name].mean()) for name in ("angle", "load"))
    approach = float(run.contacts["overlap"].mean("ball").sum("raceway").mean())
    k = 1.5 * Q / approach
    L = 2 * 6.552e-3 - 12.6e-3 + approach
    c, s = np.cos(angle), np.sin(angle)
    slow = (k * c / (k * c**2 + Q / L * s**2), k * s / (k * s**2 + Q / L * c**2))
    return time, x + 1j * y, z, 2 * np.pi * RPM / 60, cage, slow


def lines(time, values, speeds):
    """Return the amplitudes at `speeds` (rad/s, positive in the direction of rotation), fitted
    together with a mean value."""
    columns = np.exp(1j * np.outer(time, [0.0, *speeds]))
    found, *_ = np.linalg.lstsq(columns, values.astype(complex), rcond=None)
    return dict(zip(speeds, np.abs(found[1:])))


@pytest.mark.parametrize("ring", ["outer", "inner"])
def test_one_before_and_after_the_balls(tmp_path, ring):
    """On the outer raceway, orders Z - 1 and Z + 1 make the ring whirl at Z times the cage speed,
    with and against the rotation of the shaft, respectively. On the inner raceway, the same orders
    make it whirl against and with the shaft at Z (w - w_c) - w and Z (w - w_c) + w, where w is the
    shaft speed and w_c the cage speed. Order Z moves the ring along its axis. The effect of each
    order alone equals the result of statics."""
    orders = (BALLS - 1, BALLS, BALLS + 1)
    time, across, along, shaft, cage, (radial, axial) = turned(
        tmp_path, **{f"flaw_{ring}": waves(*orders)}
    )
    if ring == "outer":
        below, above, straight = BALLS * cage, -BALLS * cage, BALLS * cage
    else:
        passing = BALLS * (shaft - cage)
        below, above, straight = -(passing - shaft), passing + shaft, passing
    others = () if ring == "outer" else (-below, -above)
    whirl = lines(time, across, [below, above, *others])
    assert whirl[below] == pytest.approx(AMPLITUDE * radial, rel=2e-3)
    assert whirl[above] == pytest.approx(AMPLITUDE * radial, rel=2e-3)
    for other in others:
        assert whirl[other] < 2e-3 * AMPLITUDE
    pump = lines(time, along, [straight, -straight])
    assert 2 * pump[straight] == pytest.approx(AMPLITUDE * axial, rel=2e-3)


@pytest.mark.parametrize("order, way", [(BALLS - 1, 1), (BALLS + 1, -1)])
def test_one_wave_whirls_one_way(tmp_path, order, way):
    time, across, along, _, cage, (radial, _) = turned(tmp_path, flaw_outer=waves(order))
    whirl = lines(time, across, [BALLS * cage, -BALLS * cage])
    assert whirl[way * BALLS * cage] == pytest.approx(AMPLITUDE * radial, rel=2e-3)
    assert whirl[-way * BALLS * cage] < 2e-3 * AMPLITUDE
    assert lines(time, along, [BALLS * cage])[BALLS * cage] < 2e-3 * AMPLITUDE


def test_other_orders_move_nothing(tmp_path):
    """With eleven simultaneous waves, no line differs from that of a smooth bearing by more than
    1e-3 of the amplitude of one wave. The amplitude of the waves is a tenth of that in the other
    tests, because two waves together cause lines in proportion to the product of their amplitudes,
    namely 3e-3 of an amplitude of 10 nm."""
    flat = 0.1 * AMPLITUDE
    orders = [n for n in range(2, 16) if n % BALLS not in (0, 1, BALLS - 1)]
    smooth = turned(tmp_path / "smooth")
    wavy = turned(tmp_path / "wavy", flaw_outer=waves(*orders, amplitude=flat))
    cage = wavy[4]
    for which in (1, 2):
        speeds = [n * cage for n in orders] + [BALLS * cage]
        found, base = (lines(run[0], run[which], speeds) for run in (wavy, smooth))
        for speed in speeds:
            assert abs(found[speed] - base[speed]) < 1e-3 * flat


def test_waves_of_a_ball(tmp_path):
    """A wave of even order n makes a ball larger and smaller n times per turn relative to the cage.
    The ring then whirls at n times the speed of the ball relative to the cage, plus and minus the
    cage speed, and moves along its axis at n times this ball speed. A wave of odd order touches one
    raceway with a crest and the other with a trough at the same time, so it does not move the ring.
    The path of the contacts crosses the wave off the equator. Along the axis the ring is still
    settling, which adds 5e-3 of the line at any speed."""
    time, across, along, _, cage, _ = turned(
        tmp_path, flaw_ball=f"wave 2 {AMPLITUDE} 0.3 wave 3 {AMPLITUDE} 0.3"
    )
    run = raceway.open(tmp_path)
    ball = run.balls.isel(ball=0)
    x, y, wx, wy, wz = (ball[name].values for name in ("x", "y", "omegax", "omegay", "omegaz"))
    outward = ((wx * x + wy * y) / np.hypot(x, y)).mean()
    turns = np.hypot(outward, wz.mean() - cage)
    angle = float(run.contacts["angle"].mean())
    # angle between the contact normal and the axis of rotation of the ball
    sine = (outward * np.cos(angle) + (wz.mean() - cage) * np.sin(angle)) / turns
    orbit = 2 * AMPLITUDE / (BALLS * np.cos(angle)) * (1 - sine**2)
    turn = {n: [n * turns + cage, cage - n * turns] for n in (2, 3)}
    back = [-speed for speed in turn[2]]
    found = lines(time, across, [*turn[2], *turn[3], *back])
    assert [found[speed] for speed in turn[2]] == pytest.approx([orbit, orbit], rel=1e-2)
    assert max(found[speed] for speed in (*turn[3], *back)) < 1e-3 * orbit
    pump = lines(time, along, [2 * turns, 3 * turns])
    assert pump[2 * turns] > orbit and pump[3 * turns] < 1e-2 * pump[2 * turns]


def orbit_of_a_larger_ball(folder, larger):
    """Return (position of the ring's centre, its closed-form solution to first order in `larger`
    (m)). The position is complex, in m, in the frame that rotates with the larger ball; the effect
    of unequal ball spacing is subtracted."""
    time, across, _, _, cage, _ = turned(folder, larger=larger)
    orbit = lines(time, across, [cage, -cage, 2 * cage])
    assert orbit[-cage] < 2e-3 * orbit[cage] and orbit[2 * cage] < 2e-3 * orbit[cage]
    run = raceway.open(folder)
    azimuth = np.arctan2(run.balls["y"].values, run.balls["x"].values)
    angle, load = (float(run.contacts[name].mean()) for name in ("angle", "load"))
    approach = float(run.contacts["overlap"].mean("ball").sum("raceway").mean())
    c, s = np.cos(angle), np.sin(angle)
    k, across_groove = 1.5 * load / approach, load / (2 * 6.552e-3 - 12.6e-3 + approach)
    stiffness = 0.5 * BALLS * (k * c**2 + across_groove * s**2)
    own = np.exp(-1j * azimuth[:, 0])
    uneven = load * c / stiffness * (np.exp(1j * azimuth).sum(axis=1) * own).mean()
    # a larger ball conforms more closely to the grooves, so its contacts are stiffer
    stiffer = (log_stiffness(angle, 1e-8) - log_stiffness(angle, -1e-8)) / 4e-8
    form = larger * c * (k + load * stiffer) / stiffness
    return (across * own).mean() + uneven, form


def log_stiffness(angle, larger):
    """Return the logarithm, up to a constant, of the stiffness of both contacts of a ball whose
    radius is larger by `larger` (m)."""
    radius, groove, compliance = 6.3e-3 + larger, 6.552e-3, 0.0
    for side in (-1, 1):
        along = radius * (1 + side * radius * np.cos(angle) / 30.3e-3)
        shape = hertz.exact(along, radius * groove / (groove - radius))
        compliance += hertz.stiffness(shape, 2.1e11) ** (-2 / 3)
    return -1.5 * np.log(compliance)


def test_a_larger_ball_carries_the_ring_around(tmp_path):
    """One ball has a different atom type. The centre of the ring orbits with the cage, and is
    displaced away from a larger ball. The difference between the results for a larger and for a
    smaller ball isolates the first order. The closed-form solution with constant stiffness, 2 dD/(Z
    cos a), is 0.5 % too low, because a larger ball has stiffer contacts."""
    found = [
        orbit_of_a_larger_ball(tmp_path / str(k), larger) for k, larger in enumerate((1e-7, -1e-7))
    ]
    (more, form), (less, opposite) = found
    assert form == pytest.approx(-opposite, rel=1e-3)
    assert 0.5 * (less - more) == pytest.approx(form, rel=1e-3)
    plain = 2e-7 / (BALLS * np.cos(np.deg2rad(16.2)))
    assert 1.003 < form / plain < 1.007
