# SPDX-License-Identifier: GPL-2.0-or-later
"""Tests of elliptic.h against 80-digit arithmetic, where m1 is the complementary parameter."""

import mpmath
import numpy as np
import pytest
from raceway.core import laws


@pytest.mark.parametrize("m1", [1 - 1e-15, 1 - 1e-9, 1 - 1e-4, 0.9, 0.5, 0.1, 1e-3, 1e-8, 1e-30])
def test_against_high_precision(m1):
    with mpmath.workdps(80):  # 1 - 1e-30 alone requires thirty digits
        m = 1 - mpmath.mpf(m1)
        first, second = mpmath.ellipk(m), mpmath.ellipe(m)
        expected = [float(first), float(second), float((first - second) / m)]
    v = laws.complete_elliptic(m1)
    # there are about five averaging steps, each with a rounding error of 1e-16; E = K - m D loses
    # accuracy by a factor of K/E, which is at most 36 here
    assert [v.K, v.D] == pytest.approx([expected[0], expected[2]], rel=2e-15)
    assert v.E == pytest.approx(expected[1], rel=1e-15 * (1 + expected[0] / expected[1]))


def test_circle():
    v = laws.complete_elliptic(1.0)
    assert [v.K, v.E, v.D] == pytest.approx([np.pi / 2, np.pi / 2, np.pi / 4], rel=4e-16)


@pytest.mark.parametrize("m1", [0.03, 0.4, 0.9])
def test_legendre_relation(m1):
    one, other = laws.complete_elliptic(m1), laws.complete_elliptic(1 - m1)
    # in E K' + E' K - K K' = pi/2, the terms are of order three, each with an accuracy of 2e-15
    assert one.E * other.K + other.E * one.K - one.K * other.K == pytest.approx(
        np.pi / 2, abs=2e-14
    )
