# SPDX-License-Identifier: GPL-2.0-or-later
"""Tests of the friction of rolling contacts in complete bearings. Velocity Verlet and the implicit
step use the same law, and their results agree for bearings that start from rest, oscillate, carry a
load or are nearly unloaded. The power of the shaft equals the sum of the losses."""

import re

import numpy as np
import pytest
import raceway
from host import succeed

CASE = "tests/friction/in.case"
FULL = (
    "friction mixed 0.12 0.05 heathcote 1.0e-4 rolling 0.047 0.134 1.0 rolling_hysteresis 0.01"
    " spin 1.0 drag 870 0.1"
)
GAP = "gap 1 film_damping branch inlet_shear murch 0.047 0.134 " + FULL
SLIP = "friction constant 0.1 heathcote 1.0e-4"
DRY = SLIP + " rolling_hysteresis 0.01 spin 1.0"
LOSSES = (
    "friction_power",
    "damping_power",
    "rolling_power",
    "hysteresis_power",
    "spin_power",
    "drag_power",
    "cage_power",
)


def radial(load, speed=50):
    return f"x free y free spin speed {speed} force 0 -{load} 0 ramp 3.0e-3"


COMBINED = "x free y free z free rx free ry free spin speed 50 force 0 -2000 10000 ramp 3.0e-3"
# law, lubricant, motion and initial speed of the inner ring, steps of velocity Verlet per sample
SCENES = {
    "radial, dry": (SLIP, "dry", radial(5000), 50, 50),
    "radial, film": (FULL, "mineral", radial(5000), 50, 200),
    "radial, film, constant friction": (SLIP, "mineral", radial(5000), 50, 200),
    "radial, 9549 rpm": (FULL, "mineral", radial(5000, 1000), 1000, 50),
    "combined, dry": (DRY, "dry", COMBINED, 50, 50),
    "combined, dry, no spin": (SLIP, "dry", COMBINED, 50, 50),
    "combined, film": (FULL, "mineral", COMBINED, 50, 200),
    "combined, film in the gap": (GAP, "mineral", COMBINED, 50, 100),
    "50 N, dry": (SLIP, "dry", radial(50), 50, 50),
    "50 N, film": (FULL, "mineral", radial(50), 50, 200),
    "from rest": (DRY, "dry", radial(5000), 0, 50),
}


def figures(folder, scene, integrator, substeps, **changes):
    """Return the means of the results over the second half of a run."""
    simulate(folder, scene, integrator, substeps, **changes)
    return means(folder)


def stored(folder, scene, integrator, substeps, **changes):
    """Return the kinetic energy and the spring energy (J) at the end of a run, excluding the energy
    of the rails."""
    text = simulate(folder, scene, integrator, substeps, **changes).text
    return float(re.search(r"STORED (\S+)", text).group(1))


def simulate(folder, scene, integrator, substeps, **changes):
    law, lubricant, inner, start, _ = SCENES[scene]
    return succeed(
        CASE,
        out=folder,
        law=law,
        lubricant=lubricant,
        inner=inner,
        start=start,
        integrator=integrator,
        substeps=substeps,
        **changes,
    )


def account(folder, control="tolerance 1e-9", **case):
    """Return four energies (J) of a run: work of drive and loads, loss in the steps, losses of the
    contacts, and what is stored."""
    text = succeed(CASE, out=folder, control=f"{control} energy yes", **case).text
    return [float(one) for one in re.search(r"ENERGY (.*)", text).group(1).split()]


def means(folder):
    run = raceway.open(folder)
    half = slice(run.bearing.sizes["time"] // 2, None)
    names = ("load_inner", "load_outer", "cage_speed", "friction_power", "spin_power")
    found = {name: float(run.bearing[name][half].mean()) for name in names}
    for name in ("x", "y", "z"):
        found[name] = float(inner_ring(run)[name][half].mean())
    return found


def inner_ring(run):
    return run.rings.sel(raceway="inner") if "raceway" in run.rings.dims else run.rings


def largest_difference(one, other):
    """Return the largest relative difference between two sets of results. Displacements are
    relative to the largest displacement, and the spin loss is relative to the friction loss."""
    most = max(abs(one[name]) for name in ("x", "y", "z"))
    scale = one | dict(x=most, y=most, z=most, spin_power=one["friction_power"])
    return max(abs(one[name] - other[name]) / abs(scale[name]) for name in one)


@pytest.mark.parametrize("scene", SCENES)
def test_one_answer(tmp_path, scene):
    """Loads, displacement, cage speed and friction power with the two integrators agree within 1 %;
    halving the step of either integrator changes them by less than 0.5 %."""
    steps = SCENES[scene][-1]
    found = {
        (integrator, n): figures(tmp_path / f"{integrator}{n}", scene, integrator, n)
        for integrator, n in (
            ("implicit", 1),
            ("implicit", 2),
            ("verlet", steps),
            ("verlet", 2 * steps),
        )
    }
    apart = largest_difference(found["verlet", 2 * steps], found["implicit", 1])
    halved = [
        largest_difference(found["implicit", 2], found["implicit", 1]),
        largest_difference(found["verlet", 2 * steps], found["verlet", steps]),
    ]
    print(scene, apart, halved)
    assert found["implicit", 1]["friction_power"] > 0
    assert apart < 1e-2
    assert max(halved) < 5e-3


def test_slip_and_spin_in_slices(tmp_path):
    """In a 7208 with a contact angle of 40 degrees under combined load, the integrators agree
    within 1 %. The losses due to slip and spin are smaller than with the closed-form solutions; the
    loads are equal."""
    inner = "x free y free z free rx free ry free spin speed 50 force 0 -500 4000 ramp 3.0e-3"
    case = dict(bearing="7208", inner=inner, samples=200)
    slices = GAP.replace("heathcote 1.0e-4", "slices 1.0e-4 1.0").replace(" spin 1.0", "")
    found = {}
    for name, law, integrator, n in (
        ("implicit", slices, "implicit", 1),
        ("verlet", slices, "verlet", 200),
        ("closed", GAP, "implicit", 1),
    ):
        case |= dict(out=tmp_path / name, law=law, integrator=integrator, substeps=n)
        succeed(CASE, **case)
        found[name] = means(tmp_path / name)
        # slip and spin losses come from a single sum of stresses, so dividing them is arbitrary
        found[name]["friction_power"] += found[name]["spin_power"]
    closed, implicit = found["closed"], found["implicit"]
    apart = largest_difference(found["verlet"], implicit)
    less = implicit["friction_power"] / closed["friction_power"]
    print(apart, less)
    assert apart < 1e-2
    assert 0.9 < less < 0.99
    assert implicit["load_inner"] == pytest.approx(closed["load_inner"], rel=5e-3)


@pytest.mark.parametrize("lubricant, law, steps", [("dry", DRY, 50), ("mineral", FULL, 200)])
def test_to_and_fro(tmp_path, lubricant, law, steps):
    """The ring rotates at 50 cos(2 pi t/20 ms) rad/s, so that the balls reverse their motion. The
    integrators agree within 2 % in the friction power and within 0.01 % in the radial displacement,
    and there is no drift."""
    found = {}
    for integrator, n in (("implicit", 1), ("verlet", steps)):
        succeed(
            CASE,
            out=tmp_path / integrator,
            law=law,
            lubricant=lubricant,
            integrator=integrator,
            substeps=n,
            inner=radial(5000, "v_turn"),
        )
        found[integrator] = means(tmp_path / integrator)
        speed = raceway.open(tmp_path / integrator).bearing["cage_speed"]
        assert float(speed.max()) > 18 and float(speed.min()) < -18
        assert abs(found[integrator]["cage_speed"]) < 0.01 * 19.8
    verlet, implicit = found["verlet"], found["implicit"]
    assert implicit["friction_power"] == pytest.approx(verlet["friction_power"], rel=2e-2)
    assert implicit["y"] == pytest.approx(verlet["y"], rel=1e-4)
    assert implicit["load_inner"] == pytest.approx(verlet["load_inner"], rel=1e-3)


@pytest.mark.parametrize("integrator, steps", [("implicit", 1), ("verlet", 50)])
def test_standing_bearing_sticks(tmp_path, integrator, steps):
    """A bearing that is loaded while it stands comes to rest: no power is dissipated and no ball
    rolls."""
    case = dict(law=DRY, lubricant="dry", start=0, inner=radial(5000, 0))
    succeed(CASE, out=tmp_path, integrator=integrator, substeps=steps, **case)
    run = raceway.open(tmp_path)
    assert abs(float(run.bearing["friction_power"][-50:].mean())) < 1e-4
    assert abs(float(run.bearing["cage_speed"][-50:].mean())) < 1e-4
    assert float(run.bearing["load_inner"][-1]) > 2300


@pytest.mark.parametrize(
    "integrator, steps, scene",
    [
        ("implicit", 1, "radial, film"),
        ("verlet", 400, "radial, film"),
        ("implicit", 1, "combined, dry"),
        ("verlet", 100, "combined, dry"),
        ("implicit", 1, "combined, film in the gap"),
        ("verlet", 100, "combined, film in the gap"),
    ],
)
def test_power_is_the_sum_of_losses(tmp_path, integrator, steps, scene):
    """During the third ball pass, the work of shaft and loads equals the losses in all parts plus
    the energy that is stored in bodies and springs. Under combined load, the speeds of the balls
    differ, and the balls compress the cage more in each pass, which stores 3 mJ per pass, or 1.7e-3
    of the losses.
    """
    cage = 19.775 if scene.startswith("radial") else 20.222
    case = dict(sample=2 * np.pi / 9 / cage / 350)
    before, after = (
        stored(tmp_path, scene, integrator, steps, samples=samples, **case)
        for samples in (700, 1050)
    )
    run = raceway.open(tmp_path)
    ring, passed = inner_ring(run).isel(time=slice(-350, None)), slice(-350, None)
    given = -(ring["mz"] * ring["spin"]).mean()
    given = given + sum_of_loads(ring, scene)
    lost = sum(float(run.bearing[name][passed].mean()) for name in LOSSES)
    time = 350 * case["sample"]
    lost += (after - before) / time
    print(integrator, scene, float(given), lost, float(given) / lost - 1)
    assert float(given) == pytest.approx(lost, rel=1e-3)
    for name in LOSSES:
        if name != "damping_power":
            assert float(run.bearing[name][passed].mean()) >= 0


@pytest.mark.parametrize("load", ["radial", "combined"])
@pytest.mark.parametrize("speed", [5, 50, 1000])
def test_work_is_dissipated_or_stored(tmp_path, speed, load):
    """With all parts of the law and a ramped load, the energy balance of the implicit step closes
    over two ball passes, i.e. the step itself adds or removes less than 1e-3 of the losses."""
    inner = (radial(5000) if load == "radial" else COMBINED).replace("speed 50", f"speed {speed}")
    span = dict(sample=2 * np.pi / 9 / (0.3955 * speed) / 50, samples=100)
    work, own, lost, grown = account(tmp_path, law=GAP, inner=inner, start=speed, **span)
    print(speed, load, own / lost, grown / lost)
    assert lost > 0 and work == pytest.approx(lost + grown + own, rel=1e-9)
    assert abs(own) < 1e-3 * lost


@pytest.mark.parametrize("law", [GAP, "gap 1 friction stribeck 0.12 0.05 smoothed 0.01"])
@pytest.mark.parametrize("load, ramp", [(50, True), (5000, True), (5000, False)])
@pytest.mark.parametrize("speed", [0, 0.01, 1, 50])
def test_balance_at_any_speed(tmp_path, speed, load, ramp, law):
    """The energy balance closes with a film in the gap, with and without the film branch."""
    inner = radial(load, speed) if ramp else radial(load, speed).partition(" ramp")[0]
    work, own, lost, grown = account(tmp_path, law=law, inner=inner, start=speed)
    assert work == pytest.approx(lost + grown + own, rel=1e-9) and work > 0
    assert abs(own) < 1e-3 * work


@pytest.mark.parametrize("law, lubricant", [("friction constant 0", "dry"), ("gap 1", "mineral")])
def test_the_own_loss_vanishes_with_the_tolerance(tmp_path, law, lubricant):
    """Contact angles grow under an axial load that is ramped up. The stiffness of a contact depends
    on its angle, but no force does work when the angle changes. If the energy balance neglected
    this, 5.5e-4 and 2e-4 of the work would be missing, regardless of the tolerance."""
    inner = "x free y free z free spin speed 50 force 0 -100 20000 ramp 3.0e-3"
    shares = []
    for tolerance in (1e-9, 1e-11):
        case = dict(law=law, lubricant=lubricant, inner=inner, samples=60)
        work, own, *_ = account(tmp_path / str(tolerance), f"tolerance {tolerance}", **case)
        shares.append(abs(own) / work)
    # steps of order 2 scale with the square root of the tolerance, and the energy lost in them
    # scales with the tolerance or with the step
    assert shares[0] < 1e-4 and shares[1] < 0.15 * shares[0]


def sum_of_loads(ring, scene):
    """Return the mean power (W) of the loads that act on the moving ring."""
    load = (0.0, -5000.0, 0.0) if scene.startswith("radial") else (0.0, -2000.0, 10000.0)
    return sum(float(ring[f"v{k}"].mean()) * f for k, f in zip("xyz", load, strict=True))


def test_step_limit_is_the_spring_s(tmp_path):
    """Two tangential springs act on a ball, so the step limit is 2 sqrt((2/7) m/(2 k_t)), which is
    5.2 us at 2.4 kN. A step of 4 us is stable at 48, 477.5 and 9549 rpm, where the slip law alone
    would require steps of 24 ns to 5 us."""
    powers = []
    case = dict(law=SLIP, lubricant="dry", integrator="verlet", substeps=25)
    for speed in (5, 50, 1000):
        out = tmp_path / str(speed)
        succeed(CASE, out=out, start=speed, inner=radial(5000, speed), **case)
        run = raceway.open(out)
        powers.append(float(run.bearing["friction_power"][-100:].mean()) / speed)
        assert float(run.bearing["friction_power"][-100:].min()) > 0
    # Coulomb's friction torque does not depend on the speed, apart from the effect of centrifugal
    # loads
    assert powers == pytest.approx([powers[0]] * 3, rel=0.05)
