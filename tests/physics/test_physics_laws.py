# SPDX-License-Identifier: GPL-2.0-or-later
"""Every compiled contact law: its derivative in duals against differences, and its bits.

A law says in its text what its derivative holds fixed; the differences hold the same. Central
differences with a step of 1e-5 of the natural size of a motion are good to 1e-10 of the slope (third
derivative) and to rounding, 2e-16/1e-5 of the force over that size: 1e-9 of the largest slope.
"""

import ctypes

import numpy as np
import pytest

SAMPLES = range(24)


@pytest.fixture(scope="module")
def library(physics):
    return physics._library


def laws(library):
    names = []
    for law in range(library.laws()):
        text = ctypes.create_string_buffer(400)
        library.law_name(law, text, 400)
        names.append(text.value.decode())
    return names


def array(size):
    values = np.zeros(size)
    return values, values.ctypes.data_as(ctypes.POINTER(ctypes.c_double))


def test_duals_are_differences(library):
    checked = 0
    for law, name in enumerate(laws(library)):
        if library.law_explicit(law):
            continue
        for sample in SAMPLES:
            dual, at_dual = array(36)
            difference, at_difference = array(36)
            forces, at_forces = array(6)
            n = library.law_slopes(law, sample, at_dual, at_difference, at_forces)
            dual, difference = dual[: n * n].reshape(n, n), difference[: n * n].reshape(n, n)
            assert forces[0] > 0, "the samples are loaded contacts"
            # forces and couples have their own units, and so have speeds and rotations
            for rows in (slice(0, 3), slice(3, n)):
                for columns in (slice(0, 3), slice(3, n)):
                    block = dual[rows, columns]
                    if block.size:
                        scale = np.abs(block).max() + 1e-300
                        worst = np.abs(block - difference[rows, columns]).max()
                        assert worst <= 1e-9 * scale, (name, sample, dual, difference)
            assert np.abs(dual[0, 0]) > 0, "the normal force depends on the approach"
            checked += 1
    assert checked >= 4 * len(SAMPLES)


def test_lanes_and_duals_have_the_bits_of_a_double(library):
    for law, name in enumerate(laws(library)):
        if not library.law_explicit(law):
            different = [library.law_bits(law, sample) for sample in SAMPLES]
            assert different == [0] * len(different), name


def test_laws_with_a_spring_are_for_explicit_steps_only(library):
    for law, name in enumerate(laws(library)):
        assert bool(library.law_explicit(law)) == ("tangential_spring" in name)
