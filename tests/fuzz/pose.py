# SPDX-License-Identifier: GPL-2.0-or-later
"""Orientation and position of a scene in the lab frame: one of 48 rotations and reflections of the
axes, and a centre."""

import math
from dataclasses import dataclass
from itertools import permutations, product

import numpy as np

LAB = "xyz"


@dataclass(frozen=True)
class Pose:
    """Axis i of the scene points along signs[i] times the axis `axes[i]` of the lab frame."""

    axes: tuple = (0, 1, 2)
    signs: tuple = (1, 1, 1)
    centre: tuple = (0.0, 0.0, 0.0)

    @property
    def matrix(self):
        matrix = np.zeros((3, 3))
        for own, (lab, sign) in enumerate(zip(self.axes, self.signs, strict=True)):
            matrix[lab, own] = sign
        return matrix

    @property
    def hand(self):
        """-1 for a reflection, otherwise 1."""
        return round(np.linalg.det(self.matrix))

    @property
    def axis(self):
        """Axis of the bearing in the lab frame."""
        return self.axes[2]

    @property
    def sense(self):
        """-1 if the azimuth in the lab frame decreases as the azimuth in the scene increases, or
        1."""
        return self.hand * self.signs[2]

    def polar(self, vector):
        """Return the components in the lab frame of a displacement, a velocity or a force."""
        return [float(value) for value in self.matrix @ vector]

    def axial(self, vector):
        """Return the components in the lab frame of a spin, a tilt or a moment."""
        return [self.hand * value for value in self.polar(vector)]

    def azimuth(self, own):
        """Return the azimuth in the lab frame, measured from the axis that follows the bearing's
        axis."""
        lab = self.polar([math.cos(own), math.sin(own), 0])
        first, second = (self.axis + 1) % 3, (self.axis + 2) % 3
        return math.atan2(lab[second], lab[first])

    def back(self, vectors, axial=False):
        """Return the components in the scene's frame of vectors (n, 3) given in the lab frame."""
        return (np.asarray(vectors) @ self.matrix) * (self.hand if axial else 1)


UPRIGHT = Pose()
POSES = [
    Pose(axes, signs) for axes in permutations(range(3)) for signs in product((1, -1), repeat=3)
]
TURNS = [pose for pose in POSES if pose.hand == 1 and pose != UPRIGHT]
MIRRORS = [pose for pose in POSES if pose.hand == -1]
