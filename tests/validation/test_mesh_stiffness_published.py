"""The energy method beside ISO 6336-1; the worked example of ISO/TR 6336-30 is a case of `gearwright validate`."""

import math

import numpy as np
import pytest

from gearwright.parts import Material
from gearwright.parts.gears import CylindricalGear, GearPair
from gearwright.parts.stiffness import (
    mesh_stiffness_energy,
    mesh_stiffness_iso6336,
    pair_stiffness,
    theoretical_stiffness,
)

STEEL = Material("steel", 206e9, 0.3, 7850.0)


def spur(first, second, shifts=(0.0, 0.0), helix=0.0):
    return GearPair(
        CylindricalGear(first, 3e-3, 20e-3, math.radians(helix), profile_shift=shifts[0]),
        CylindricalGear(second, 3e-3, 20e-3, math.radians(helix), profile_shift=shifts[1]),
    )


@pytest.mark.parametrize(
    ("teeth", "shifts", "theoretical"),
    [((20, 20), (0, 0), 14.7273236), ((30, 60), (0, 0), 17.6329006), ((25, 100), (0.3, -0.1), 18.6375226)],
)
def test_theoretical_single_stiffness(teeth, shifts, theoretical):
    """ISO 6336-1:2006, the nine coefficients evaluated independently; 1e-8 is their rounding."""
    assert theoretical_stiffness(teeth, shifts) / 1e9 == pytest.approx(theoretical, rel=1e-8)


@pytest.mark.parametrize(
    ("pair", "least", "most"),
    [
        (spur(20, 20), 1.0, 1.17),
        (spur(30, 60), 1.0, 1.10),
        (spur(40, 100), 1.0, 1.10),
        (spur(25, 100, (0.3, -0.1)), 1.0, 1.10),
        (spur(30, -90), 1.0, 1.10),
        (spur(54, -186), 1.0, 1.10),
    ],
)
def test_the_energy_method_finds_isos_theoretical_single_stiffness(pair, least, most):
    """c′_th is the greatest stiffness of one pair of perfect steel teeth, before C_M = 0.8 for what was measured.

    Two independent theories: the energy method is 2 to 8 % stiffer, 15 % at 20/20, the smallest gears tried.
    """
    distance = np.linspace(-pair.approach, pair.recess, 101)
    greatest = float(pair_stiffness(pair, distance, materials=(STEEL, STEEL)).stiffness.max())
    assert least < greatest / mesh_stiffness_iso6336(pair).theoretical < most


@pytest.mark.parametrize("teeth", [(30, 60), (40, 100), (54, 66), (17, 103), (30, -90), (48, -153), (66, -186)])
@pytest.mark.parametrize("helix", [0.0, 15.0, 25.0])
def test_the_energy_method_finds_isos_mean_mesh_stiffness(teeth, helix):
    """c′_th cos β (0.75 ε_α + 0.25), spur and helical, external and internal: within 6 %.

    Measured: 2 % below to 5 % above. C_M and C_B, which fit theory to measured gears, are in neither.
    """
    pair = spur(*teeth, helix=helix)
    ratio = pair.transverse_contact_ratio
    theory = mesh_stiffness_iso6336(pair).theoretical * math.cos(math.radians(helix)) * (0.75 * ratio + 0.25)
    mean = mesh_stiffness_energy(pair, materials=(STEEL, STEEL)).mean
    assert mean / pair.face_width == pytest.approx(theory, rel=0.06)
