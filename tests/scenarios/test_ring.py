# SPDX-License-Identifier: GPL-2.0-or-later
"""The motion under fix bearing/ring agrees with the mechanics of a free body: fall, gyroscopic
motion, driven motion and conservation laws."""

import numpy as np
from host import BOX, deck_file, succeed

MASS, AXIAL, ACROSS = 0.2, 1.2e-4, 6.5e-5  # kg, kg m^2
BALL_MASS = 4 / 3 * np.pi * 6.3e-3**3 * 7800

# A radial play of 0.2 mm keeps balls and rings apart; there is no contact unless the play is
# changed.
DECK = (
    BOX
    + """
variable play index 2.0e-4
variable outer equal 36.6e-3+${play}
pair_style bearing/hertz friction constant 0.1
pair_coeff 1 3 inner 24.0e-3 6.552e-3
pair_coeff 1 4 outer ${outer} 6.552e-3
variable b_omega index 0
create_bearing 1 none 3 4 balls 9 diameter 12.6e-3 speed ${b_omega} 0
group balls type 1
group inner type 3
group outer type 4
fix move balls nve/sphere
timestep 1.0e-6
variable t equal step*dt
"""
)
REPORT = """
variable x equal f_inner[1]
variable y equal f_inner[2]
variable z equal f_inner[3]
variable vz equal f_inner[6]
variable rx equal f_inner[7]
variable ry equal f_inner[8]
variable spin equal f_inner[9]
variable angle equal f_inner[10]
fix report all print 50 "${t} ${x} ${y} ${z} ${vz} ${rx} ${ry} ${spin} ${angle}" &
  file ${out} screen no
"""


def motion(tmp_path, commands, steps, **variables):
    """Return the columns t, x, y, z, vz, rx, ry, spin and angle of the inner ring."""
    deck = deck_file(tmp_path, DECK + commands + REPORT + f"run {steps}\n")
    succeed(deck, out=tmp_path / "ring.txt", **variables)
    return np.loadtxt(tmp_path / "ring.txt").T


def test_constant_force_on_a_free_ring(tmp_path):
    """The displacement is z = F t^2/(2 m). Velocity Verlet is exact in this case, and the columns
    have 15 digits."""
    t, x, y, z, vz, *_ = motion(
        tmp_path, f"fix inner inner bearing/ring mass {MASS} z free force 3.0 4.0 5.0\n", 2000
    )
    np.testing.assert_allclose(z, 5.0 / (2 * MASS) * t**2, rtol=1e-11)
    np.testing.assert_allclose(vz, 5.0 / MASS * t, rtol=1e-11)
    assert not x.any() and not y.any()  # these directions are fixed


def test_moment_on_a_spinning_ring(tmp_path):
    """A moment M about x acts on a ring that has the spin W and is free to tilt. In linear theory,
    with n = I_a W/I_t, the tilt about x is M/(I_t n^2) (1 - cos n t) and the tilt about y is
    -M/(I_t n^2) (n t - sin n t): a gyroscope yields sideways. The sign follows from dL/dt = M: a
    moment along +x turns the axis e (L = I_a W e) towards +x, which is a positive tilt about y.
    Relative to the tilt, nonlinear terms are of the order of its square, 1e-5, and errors of the
    step are of the order of (n h)^2/12 = 3e-7.
    """
    spin, moment = 1000.0, 0.05
    t, *_, rx, ry, rate, angle = motion(
        tmp_path,
        f"fix inner inner bearing/ring inertia {AXIAL} {ACROSS} rx free ry free spin speed {spin}"
        f" moment {moment} 0 0\n",
        4000,
    )
    n = AXIAL * spin / ACROSS
    amplitude = moment / (ACROSS * n**2)
    np.testing.assert_allclose(rx, amplitude * (1 - np.cos(n * t)), rtol=0, atol=1e-4 * amplitude)
    np.testing.assert_allclose(
        ry, amplitude * (n * t - np.sin(n * t)), rtol=0, atol=1e-4 * amplitude * n * t[-1]
    )
    np.testing.assert_allclose(rate, spin, rtol=1e-12)
    np.testing.assert_allclose(angle, spin * t, rtol=1e-11)


def test_one_free_tilt_has_no_gyroscope(tmp_path):
    """If the other tilt is fixed, the free tilt is M t^2/(2 I_t), without gyroscopic motion."""
    t, *_, rx, ry, _, _ = motion(
        tmp_path,
        f"fix inner inner bearing/ring inertia {AXIAL} {ACROSS} rx free spin speed 1000 moment 0.05"
        " 0.05 0\n",
        400,
    )
    np.testing.assert_allclose(rx, 0.05 / (2 * ACROSS) * t**2, rtol=1e-9)
    assert not ry.any()


def test_driven_degrees_of_freedom(tmp_path):
    """Displacements and tilts follow their variables exactly, and so does the integral of an
    imposed speed."""
    t, x, y, z, vz, rx, ry, spin, _ = motion(
        tmp_path,
        "variable wx equal 1.0e-5*sin(2000*v_t)\nvariable wr equal 1.0e-3*sin(1000*v_t)\nvariable"
        " ws equal 100*v_t\nfix inner inner bearing/ring x position v_wx y speed 2.0e-3 rx position"
        " v_wr spin speed v_ws\n",
        2000,
    )
    np.testing.assert_allclose(x, 1e-5 * np.sin(2000 * t), rtol=0, atol=1e-16)
    np.testing.assert_allclose(y, 2e-3 * t, rtol=1e-12)
    np.testing.assert_allclose(rx, 1e-3 * np.sin(1000 * t), rtol=0, atol=1e-15)
    np.testing.assert_allclose(spin, 100 * t, rtol=1e-12)
    assert not z.any() and not ry.any()


def test_load_ramp(tmp_path):
    """The load increases as 3 s^2 - 2 s^3, so the momentum after the ramp is half of F T."""
    (t, *_) = rows = motion(
        tmp_path,
        f"fix inner inner bearing/ring mass {MASS} z free force 0 0 5.0 ramp 1.0e-3\n",
        1000,
    )
    s = t / 1e-3
    # Verlet integrates the impulse by the trapezoidal rule, plus half a step at the start; the
    # error h^2/12 F'(end) is less than 1e-6 of the impulse
    np.testing.assert_allclose(
        rows[4], 5.0 / MASS * 1e-3 * (s**3 - s**4 / 2), rtol=0, atol=1e-5 * 5.0 / MASS * 1e-3
    )


def test_free_bearing_keeps_its_momentum(tmp_path):
    """Two free rings and nine compressed, sliding balls conserve linear momentum, and angular
    momentum about any axis.

    Every contact exerts opposite forces on both bodies at the same point, so both momenta are
    conserved to within rounding, i.e. about 1e5 additions with errors of 1e-16 relative to the
    largest single momentum."""
    free = "mass 0.2 inertia 1.2e-4 6.5e-5 x free y free z free rx free ry free spin free"
    deck = deck_file(
        tmp_path,
        DECK
        # the balls are initially at rest, so they slip
        + "fix inner inner bearing/ring spin speed 300\nrun 0\nunfix inner\nfix inner inner"
        f" bearing/ring {free}\nfix outer outer bearing/ring {free}\nvelocity inner set 0.01 0.02"
        " 0.005\ndump all all custom 500 ${out} id type x y z vx vy vz omegax omegay"
        ' omegaz\ndump_modify all format "%d %d %.17g %.17g %.17g %.17g %.17g %.17g %.17g %.17g'
        ' %.17g" sort id\ntimestep 2.0e-7\nrun 5000\n',
    )
    succeed(deck, out=tmp_path / "all.dump", play=-1e-5)
    lines = (tmp_path / "all.dump").read_text().splitlines()
    frames = [
        np.array([line.split() for line in lines[at + 9 : at + 20]], float)
        for at in range(0, len(lines), 20)
    ]
    assert len(frames) == 11
    linear, angular = zip(*(_momenta(frame) for frame in frames))
    largest = 300 * AXIAL  # kg m^2/s, initial angular momentum of the inner ring
    np.testing.assert_allclose(linear, np.tile(linear[0], (11, 1)), rtol=0, atol=1e-12)
    # only the spin about z is tested; about other axes the rings tilt, and the dumped omega alone
    # does not give I omega
    np.testing.assert_allclose(np.array(angular)[:, 2], angular[0][2], rtol=0, atol=1e-9 * largest)
    spins = [frame[9, 10] for frame in frames]
    assert spins[-1] < 0.999 * spins[0]  # there was friction


def _momenta(frame):
    ball = frame[:, 1] == 1
    mass = np.where(ball, BALL_MASS, MASS)[:, None]
    inertia = np.where(ball, 0.4 * BALL_MASS * 6.3e-3**2, AXIAL)[:, None]
    x, v, w = frame[:, 2:5], frame[:, 5:8], frame[:, 8:11]
    return (mass * v).sum(0), (np.cross(x, mass * v) + inertia * w).sum(0)
