# SPDX-License-Identifier: GPL-2.0-or-later
"""Tests of every set of parts that forms a contact law. Derivatives from duals agree with finite
differences. The results of a law are bitwise identical whether it is evaluated part by part, as a
whole or in lanes. Contradictory sets are rejected.

The text of a law states which quantities its derivative treats as constant; the differences treat
the same quantities as constant. The differences are central and of fourth order, and their step is
1e-5 of the natural size of a motion, which is 0.1 m/s or 10 rad/s. Their rounding error is
2e-16/1e-5 of the force divided by that size, which is well below 1e-9 of the largest slope.
"""

import ctypes

import numpy as np
import pytest

SAMPLES = 24  # samples per contact
EPSILON = np.finfo(float).eps


def laws(physics):
    return [physics.call("law_name", law).decode() for law in range(physics.call("laws"))]


def some(law):
    """Return the indices of a few samples, which differ from law to law. Together, the sets of
    parts test every part with all samples."""
    return [(7 * law + 5 * k) % SAMPLES for k in range(4)]


def test_duals_are_differences(physics):
    wrong = set()
    for law, name in enumerate(laws(physics)):
        if physics.call("law_explicit", law):
            continue
        for sample in some(law):
            n, dual, difference, forces = physics.call("law_slopes", law, sample)
            dual, difference = dual[: n * n].reshape(n, n), difference[: n * n].reshape(n, n)
            assert forces[0] > 0, "the samples are loaded contacts"
            # forces and couples have different units, as do speeds and rotations
            for rows in (slice(0, 3), slice(3, n)):
                for columns, size in ((slice(0, 3), 0.1), (slice(3, n), 10.0)):
                    block = dual[rows, columns]
                    if block.size:
                        rounding = 4 * EPSILON * np.abs(forces[rows]).max() / (1e-5 * size)
                        worst = np.abs(block - difference[rows, columns]).max()
                        bound = 1e-9 * np.abs(block).max() + rounding
                        if not worst <= bound and name not in wrong:
                            print("wrong slope:", name)
                            wrong.add(name)
            assert np.abs(dual[0, 0]) > 0, "the normal force depends on the approach"
    assert not wrong


def test_sets_that_nobody_listed_are_there(physics):
    """The sets contain each part with and without a film, except for parts that require one; 7 laws
    are compiled as a whole."""
    names = laws(physics)
    assert len(names) == len(set(names)) > 600
    fused = [name for law, name in enumerate(names) if physics.call("law_fused", law, 0) >= 0]
    assert len(fused) == 7


def test_lanes_and_duals_have_the_bits_of_a_double(physics):
    for law, name in enumerate(laws(physics)):
        if not physics.call("law_explicit", law):
            different = [physics.call("law_bits", law, sample) for sample in some(law)]
            assert different == [0] * len(different), name


def test_a_law_compiled_as_a_whole_has_the_bits_of_its_parts(physics):
    """All values of the contact and its stored states are bitwise identical, and so are the slopes
    if the law can be used in implicit steps."""
    for law, name in enumerate(laws(physics)):
        if physics.call("law_fused", law, 0) >= 0:
            different = [physics.call("law_fused", law, sample) for sample in range(SAMPLES)]
            assert different == [0] * SAMPLES, name


def test_contacts_of_the_host_s_step_in_lanes(physics):
    """Four different contacts evaluated in lanes, one of them open, are bitwise identical to the
    same contacts evaluated alone."""
    for law, name in enumerate(laws(physics)):
        different = [physics.call("law_lanes", law, sample) for sample in some(law)]
        assert different == [0] * len(different), name


def test_laws_with_a_spring_are_for_explicit_steps_only(physics):
    for law, name in enumerate(laws(physics)):
        assert bool(physics.call("law_explicit", law)) == ("tangential_spring" in name)


@pytest.mark.parametrize(
    "parts, why",
    [
        ("hertz hysteresis normal_force rolling", "has rolling, which requires a film"),
        ("hertz hysteresis normal_force friction_constant smoothed_friction spin",
         "has spin but not differential_slip, which it requires"),
        ("hertz hysteresis film_thickness normal_force film_branch",
         "has film_branch but not film_in_gap, which it requires"),
        ("hertz film_in_gap hysteresis film_thickness normal_force",
         "has hertz and film_in_gap, which exclude each other"),
    ],
)  # fmt: skip
def test_contradictions(physics, parts, why):
    law = " + ".join(parts.split())
    names = ctypes.create_string_buffer(parts.encode())
    found = physics.call("law_contradiction", ctypes.addressof(names)).decode()
    assert found == f"the contact law {law} {why}"
