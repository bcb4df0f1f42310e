# SPDX-License-Identifier: GPL-2.0-or-later
"""Every compiled contact law: its derivative in duals against differences, and its bits.

A law says in its text what its derivative holds fixed; the differences hold the same. Central
differences of fourth order have a step of 1e-5 of the natural size of a motion. They are good to
rounding, 2e-16/1e-5 of the force over that size: 1e-9 of the largest slope.
"""

import numpy as np

SAMPLES = range(24)


def laws(physics):
    return [physics.call("law_name", law).decode() for law in range(physics.call("laws"))]


def test_duals_are_differences(physics):
    checked, wrong = 0, set()
    for law, name in enumerate(laws(physics)):
        if physics.call("law_explicit", law):
            continue
        for sample in SAMPLES:
            n, dual, difference, forces = physics.call("law_slopes", law, sample)
            dual, difference = dual[: n * n].reshape(n, n), difference[: n * n].reshape(n, n)
            assert forces[0] > 0, "the samples are loaded contacts"
            # forces and couples have their own units, and so have speeds and rotations
            for rows in (slice(0, 3), slice(3, n)):
                for columns in (slice(0, 3), slice(3, n)):
                    block = dual[rows, columns]
                    if block.size:
                        scale = np.abs(block).max() + 1e-300
                        worst = np.abs(block - difference[rows, columns]).max()
                        if not worst <= 1e-9 * scale:
                            print(name, sample, dual, difference)
                            wrong.add(name)
            assert np.abs(dual[0, 0]) > 0, "the normal force depends on the approach"
            checked += 1
    assert checked >= 4 * len(SAMPLES)
    assert not wrong


def test_lanes_and_duals_have_the_bits_of_a_double(physics):
    for law, name in enumerate(laws(physics)):
        if not physics.call("law_explicit", law):
            different = [physics.call("law_bits", law, sample) for sample in SAMPLES]
            assert different == [0] * len(different), name


def test_contacts_of_the_host_s_step_in_lanes(physics):
    """Four contacts that differ, one of them open: what each has alone, to the bit."""
    for law, name in enumerate(laws(physics)):
        different = [physics.call("law_lanes", law, sample) for sample in range(8)]
        assert different == [0] * 8, name


def test_laws_with_a_spring_are_for_explicit_steps_only(physics):
    for law, name in enumerate(laws(physics)):
        assert bool(physics.call("law_explicit", law)) == ("tangential_spring" in name)
