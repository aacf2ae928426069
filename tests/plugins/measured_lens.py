# SPDX-License-Identifier: BSD-3-Clause
"""The monotone cubics of scipy through the table of test_measured_lens.cpp.

Prints the figures that the test has. Needs python3-scipy.
"""
from scipy.interpolate import PchipInterpolator

DIRECTIONS = [-0.5, -0.41, -0.2, 0.02, 0.05, 0.3, 0.5]
ANGLES = [-31.0, -26.5, -12.0, 1.5, 4.0, 17.5, 27.0]

curve = PchipInterpolator(ANGLES, DIRECTIONS)
for angle in [-30.9, -28, -26.5, -20, -5, 0, 1, 2.2, 4.1, 10, 20, 26.9]:
    print("{%g, %.15g}," % (angle, curve(angle)))
