"""Published AGMA cases: the geometry factors of AGMA 908-B89 and Shigley's example 14-4."""

import numpy as np
import pytest

from gearwright.parts.agma908 import HobbedPair, LoadPlace, bending_geometry, pitting_geometry_factor
from gearwright.parts.agma2001 import (
    BENDING_HB250,
    PITTING,
    AgmaGear,
    AgmaLoad,
    AgmaMesh,
    AgmaSteel,
    agma_rating,
    agma_strength,
    dynamic_factor_agma,
    hardness_ratio_factor,
    load_distribution_factor,
    reliability_factor,
    size_factor,
)
from gearwright.parts.gears import lewis_form_factor
from gearwright.parts.iso6336 import life_factor
from gearwright.units import FOOT, HORSEPOWER, INCH, POUND_FORCE, RPM
from gearwright.validate.gears.ratings import AGMA_FACTORS

PSI = POUND_FORCE / INCH**2


@pytest.mark.parametrize(("teeth", "j"), [(21, 0.24), (26, 0.25), (35, 0.26)])
def test_bending_factor_with_the_load_at_the_tip(teeth, j):
    """AGMA 908-B89, the same teeth loaded at the tip; two decimals."""
    assert bending_geometry(HobbedPair((teeth, 60)), 0, LoadPlace.TIP).factor == pytest.approx(j, abs=0.005)


def test_the_whole_table_at_once_gives_the_same_numbers():
    """Arrays broadcast: one call for fifteen pairs, equal to rounding."""
    pinion, gear = (np.array([row[k] for row in AGMA_FACTORS], dtype=float) for k in (0, 1))
    together = bending_geometry(HobbedPair((pinion, gear)), 0).factor
    alone = [bending_geometry(HobbedPair((p, g)), 0).factor for p, g in zip(pinion, gear, strict=True)]
    np.testing.assert_allclose(together, alone, rtol=1e-12)


def test_helical_pitting_factor_of_shigleys_example_14_5():
    """17/52 teeth, 30° helix, F = 15 modules: I = 0.195 by Shigley's eq. 14-23 at the pitch point, m_N = p_N/(0.95 Z).

    AGMA 908 takes the mean point and the least length of the contact lines: 1 % apart.
    """
    pair = HobbedPair((17, 52), helix_angle=np.radians(30.0), face_width=15.0)
    angle = pair.transverse_angle
    share = np.pi * np.cos(np.radians(20.0)) / (0.95 * pair.contact_length)
    shigley = np.sin(angle) * np.cos(angle) / (2.0 * share) * RATIO / (RATIO + 1.0)
    assert shigley == pytest.approx(0.195, abs=5e-4)
    assert pitting_geometry_factor(pair) == pytest.approx(shigley, rel=0.01)


# Shigley's Mechanical Engineering Design, 9th ed., example 14-4: 17/52 teeth, P = 10, F = 1.5 in, 4 hp at 1800 rpm.
WIDTH, MODULE, DIAMETER = 1.5 * INCH, INCH / 10.0, 1.7 * INCH
SPEED = 1800.0 * RPM * DIAMETER / 2.0
FORCE = 4.0 * HORSEPOWER / SPEED
HARDNESS = (240.0, 200.0)
RATIO = 52.0 / 17.0


def shigley(gear):
    """The example's gear 0 or 1, with its J of 0.30 and 0.40 read from a chart and its I of 0.121."""
    cycles = (1e8, 1e8 / RATIO)[gear]
    load = AgmaLoad(
        FORCE, dynamic=dynamic_factor_agma(SPEED, 6.0), distribution=load_distribution_factor(WIDTH, DIAMETER)
    )
    body = AgmaGear(
        bending_factor=(0.30, 0.40)[gear],
        strength=agma_strength(AgmaSteel.THROUGH_HARDENED, 1, HARDNESS[gear]),
        size=size_factor(WIDTH, MODULE, (0.303, float(lewis_form_factor(52.0)))[gear]),
        bending_cycles=life_factor(BENDING_HB250, cycles),
        contact_cycles=life_factor(PITTING, cycles),
        hardness_ratio=1.0 if gear == 0 else hardness_ratio_factor(*HARDNESS, RATIO),
    )
    return body, agma_rating(
        load,
        body,
        AgmaMesh(WIDTH, MODULE, DIAMETER, pitting_factor=0.121, elastic_coefficient=2300.0 * np.sqrt(PSI)),
        reliability=reliability_factor(0.9),
    )


def test_factors_of_shigleys_example():
    """Example 14-4: V 801.1 ft/min, W_t 164.8 lbf, K_v 1.377, K_m 1.22, K_s 1.043 and 1.052, Y_N, Z_N: 0.1 %."""
    assert pytest.approx(801.1, rel=1e-3) == SPEED * 60.0 / FOOT
    assert pytest.approx(164.8, rel=1e-3) == FORCE / POUND_FORCE
    assert dynamic_factor_agma(SPEED, 6.0) == pytest.approx(1.377, rel=1e-3)
    assert load_distribution_factor(WIDTH, DIAMETER) == pytest.approx(1.22, abs=5e-3)
    pinion, gear = shigley(0)[0], shigley(1)[0]
    assert (pinion.size, gear.size) == pytest.approx((1.043, 1.052), rel=1e-3)
    assert (pinion.bending_cycles, gear.bending_cycles) == pytest.approx((0.977, 0.996), rel=1e-3)
    assert (pinion.contact_cycles, gear.contact_cycles) == pytest.approx((0.948, 0.973), rel=1e-3)
    assert gear.hardness_ratio == pytest.approx(1.005, rel=1e-3)
    assert pinion.strength.bending / PSI == pytest.approx(31350.0, rel=1e-3)
    assert gear.strength.contact / PSI == pytest.approx(93500.0, rel=1e-3)


def test_stresses_and_safeties_of_shigleys_example():
    """Example 14-4: 6417 and 4854 psi, 70 360 and 70 660 psi; S_F 5.62, 6.82; S_H 1.69, 1.52: 0.5 % by its rounded K's.

    The book prints S_F of the gear as 6.8; its own 33 114/4854 is 6.82.
    """
    ratings = [shigley(gear)[1] for gear in (0, 1)]
    assert [each.bending_stress / PSI for each in ratings] == pytest.approx([6417.0, 4854.0], rel=5e-3)
    assert [each.contact_stress / PSI for each in ratings] == pytest.approx([70360.0, 70660.0], rel=5e-3)
    assert [each.bending_limit / PSI for each in ratings] == pytest.approx([36034.0, 33114.0], rel=2e-3)
    assert [each.contact_limit / PSI for each in ratings] == pytest.approx([118667.0, 107565.0], rel=2e-3)
    assert [each.bending_safety for each in ratings] == pytest.approx([5.62, 6.82], rel=5e-3)
    assert [each.contact_safety for each in ratings] == pytest.approx([1.69, 1.52], rel=5e-3)
