"""Rotors that were measured: torque in hover beside momentum and mean profile drag."""

import numpy as np

from gearwright.machines.rotors import Disc, Stream, rotor_power

CASTLES = (
    (0.00098, 24), (0.00168, 70), (0.00289, 137), (0.00400, 226), (0.00488, 342),
    (0.00160, 53), (0.00255, 108), (0.00346, 194), (0.00421, 301),
    (0.00179, 71), (0.00254, 138), (0.00414, 228), (0.00513, 323),
    (0.00187, 50), (0.00278, 114), (0.00374, 199), (0.00471, 321),
)  # fmt: skip
"""C_T and ΔC_Q [1e-6] beyond the torque without thrust, runs 15, 16, 39 and 41 of table V, from 3° on where C_T
reaches 0.0009: smaller torques are told to 10 % and worse."""


DISC, HOVER = Disc(2.0, 0.05, 0.0105, 1.15), Stream(1.0, 0.0, 0.0, 1.0)


def errors(induced_factor):
    """Return how far the torque beyond that without thrust is off: C_T = T and C_Q = P over the area at unit speed."""
    disc = DISC._replace(induced_factor=induced_factor)
    idle = rotor_power(disc, HOVER, 0.0)
    found = [(rotor_power(disc, HOVER, thrust * disc.area) - idle) / disc.area for thrust, _ in CASTLES]
    return np.array(found) / (1e-6 * np.array([torque for _, torque in CASTLES])) - 1.0


def test_torque_of_a_hovering_rotor_beyond_that_without_thrust():
    """Castles and Gray, NACA TN-2474 (1951), table V: three untwisted blades, σ 0.05, 6 ft, NACA 0015.

    As tabulated in the public repository mcroomp/dynbem. κ = 1.15 and a constant c_d0 leave out the drag that grows
    with lift and what untwisted blades lose: 8 % too little in the median. Runs at one C_T differ by 20 %.
    """
    error = errors(1.15)
    assert -0.12 < np.median(error) < -0.04
    assert np.mean(np.abs(error) < 0.20) > 0.7
    assert np.abs(error).max() < 0.35


def test_a_larger_induced_factor_meets_untwisted_blades():
    """κ = 1.25 takes the median of the same numbers to within 3 %, and 9 of 10 within 20 %."""
    error = errors(1.25)
    assert abs(np.median(error)) < 0.03
    assert np.mean(np.abs(error) < 0.20) > 0.9
