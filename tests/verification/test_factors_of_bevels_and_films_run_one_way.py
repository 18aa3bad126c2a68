"""Which way factors of bevel gears, scuffing and micropitting run, and that they have no steps but their standards'.

Every sweep crosses the corners of its clauses. A factor is continuous when a grid four times as fine has a largest step
of at most 0.3 of the coarse one's; those that the standards let jump are listed with their jump.
"""

import math
from dataclasses import replace

import numpy as np
import pytest

from gearwright.parts.agma908 import HobbedPair, pitting_geometry_factor
from gearwright.parts.agma2001 import Hardnesses, hardness_ratio_of
from gearwright.parts.agma2003 import (
    BENDING,
    BENDING_CRITICAL,
    CONTACT,
    AgmaBevelDuty,
    AgmaBevelMaking,
    BevelEdition,
    BevelSteel,
    bevel_geometry,
    bevel_strength,
    lengthwise_curvature,
    load_distribution,
    rate_agma_bevel,
    size_factor_bending,
    size_factor_contact,
    temperature_factor,
)
from gearwright.parts.bevel_geometry import BevelPair, BevelTooth
from gearwright.parts.gears import lewis_form_factor
from gearwright.parts.iso6336 import GearSteel, MeshGeometry, Treatment, life_factor
from gearwright.parts.iso10300 import (
    BevelDuty,
    VirtualPair,
    contact_ratio_factor_bending,
    mid_zone_factor,
    rate_bevel,
    spiral_angle_factor,
)
from gearwright.parts.micropitting import OilGrade, helical_factor, load_sharing as film_sharing, path_places
from gearwright.parts.scuffing import (
    Oil,
    ScuffingMesh,
    approach_factor,
    contact_ratio_factor_integral,
    flash_temperature,
    friction_coefficient,
    friction_coefficient_integral,
    integral_temperature,
    scuffing_integral_temperature,
    tip_relief_factor,
)

STEEL = GearSteel("case-hardened", Treatment.CASE_HARDENED, "MQ", 700.0, 1500e6, 500e6)
SPUR = MeshGeometry((23, 71), 3e-3, 24e-3, 142.1e-3, (38.2e-3, 109.6e-3))
HELICAL = MeshGeometry((23, 71), 3e-3, 30e-3, 146.1e-3, (39.1e-3, 113.2e-3), math.radians(14.0))
PAIR = BevelPair((17, 43), 8.5e-3, 51e-3, math.radians(35.0), tooth=BevelTooth(profile_shift=0.3))
MESH = ScuffingMesh(SPUR, 3e5, 2e5, 17.0, 0.6e-6, reliefs=(6e-6, 4e-6))
OIL, GRADE = Oil(90.0, 11e-3, 9.0), OilGrade(150e-6, 15.5e-6)
MAKING = AgmaBevelMaking((bevel_strength(BevelSteel.CARBURISED, 1),) * 2)


def rated(torque: float, gear: int, kind: str) -> float:
    found = rate_bevel(PAIR, (STEEL, STEEL), BevelDuty(torque, 158.5, 8e-6), 1e7)
    return float(found.pitting.safeties[gear] if kind == "contact" else found.bending[gear].safety)


def agma(torque: float, gear: int, kind: str) -> float:
    one = rate_agma_bevel(PAIR, AgmaBevelDuty(torque, 158.5, 1e7), MAKING).gears[gear]
    return one.contact_safety if kind == "contact" else one.bending_safety


def virtual(width: float) -> VirtualPair:
    return VirtualPair(replace(PAIR, face_width=width))


def share(width: float, place: float) -> float:
    """X_Y of a helical pair at a part of its path."""
    pair = replace(HELICAL, face_width=width)
    return float(film_sharing(pair, 7, np.array([place * path_places(pair)[-1]]))[0])


UP, DOWN, EITHER = 1, -1, 0
SWEEPS = {
    "C_s over b": (size_factor_contact, (5e-3, 0.15), UP),
    "C_s of 1997 over b": (lambda x: size_factor_contact(x, BevelEdition.B97), (5e-3, 0.15), UP),
    "K_s over m_et": (size_factor_bending, (1e-3, 20e-3), UP),
    "K_m over b": (lambda x: load_distribution(x, 1.1), (5e-3, 0.355), UP),
    "K_x over r_c0": (lambda x: lengthwise_curvature(math.radians(35.0), x, 0.1), (0.02, 1.0), DOWN),
    "K_T over ϑ": (temperature_factor, (50.0, 200.0), UP),
    "C_L over N": (lambda x: life_factor(CONTACT, x), (1.0, 1e12), DOWN),
    "K_L over N": (lambda x: life_factor(BENDING, x), (1.0, 1e12), DOWN),
    "K_L in critical service": (lambda x: life_factor(BENDING_CRITICAL, x), (1.0, 1e12), DOWN),
    "I of AGMA 2003 over x": (
        lambda x: bevel_geometry(replace(PAIR, tooth=BevelTooth(profile_shift=x))).pitting.factor, (0.15, 0.5), EITHER),
    "J of AGMA 2003 over ρ_a0": (
        lambda x: bevel_geometry(replace(PAIR, tooth=BevelTooth(edge_radii=(x, x)))).bending[0].factor, (0.1, 0.3), UP),
    "S_H of AGMA 2003 over T": (lambda x: agma(x, 0, "contact"), (100.0, 9000.0), DOWN),
    "S_F of AGMA 2003 over T": (lambda x: agma(x, 1, "bending"), (100.0, 9000.0), DOWN),
    "S_H of ISO 10300 over T": (lambda x: rated(x, 0, "contact"), (100.0, 9000.0), DOWN),
    "S_F of ISO 10300 over T": (lambda x: rated(x, 1, "bending"), (100.0, 9000.0), DOWN),
    "Z_M-B over b": (lambda x: mid_zone_factor(virtual(x)), (5e-3, 56e-3), EITHER),
    "Y_ε of bevels over b": (lambda x: contact_ratio_factor_bending(virtual(x)), (5e-3, 56e-3), DOWN),
    "Y_BS over b": (lambda x: spiral_angle_factor(virtual(x)), (5e-3, 56e-3), EITHER),
    "Z_LS over b": (lambda x: virtual(x).load_sharing, (5e-3, 56e-3), EITHER),
    "C_H over u": (lambda x: hardness_ratio_of(Hardnesses(320.0, 230.0), x), (1.0, 12.0), UP),
    "I of AGMA 908 over z_1": (lambda x: pitting_geometry_factor(HobbedPair((x, 3.0 * x))), (17.0, 60.0), UP),
    "Lewis Y over z": (lewis_form_factor, (12.0, 400.0), UP),
    "μ_m over v": (lambda x: friction_coefficient(replace(MESH, speed=x), OIL), (0.5, 90.0), DOWN),
    "μ_m over w": (lambda x: friction_coefficient(replace(MESH, specific_load=x), OIL), (2e4, 2e6), UP),
    "X_J over C_a2": (
        lambda x: approach_factor(replace(MESH, reliefs=(0.0, x)), np.array([-0.6, 0.5]))[0], (0.0, 40e-6), DOWN),
    "S_B over w": (
        lambda x: flash_temperature(replace(MESH, specific_load=x, nominal_load=x / 1.5), OIL).safety,
        (2e4, 2e6), DOWN),
    "μ_mC over w": (lambda x: friction_coefficient_integral(replace(MESH, specific_load=x), OIL), (2e4, 2e6), UP),
    "μ_mC over v": (lambda x: friction_coefficient_integral(replace(MESH, speed=x), OIL), (0.5, 90.0), DOWN),
    "S_intS over w": (
        lambda x: integral_temperature(replace(MESH, specific_load=x, nominal_load=x / 1.5), OIL).safety,
        (2e4, 2e6), DOWN),
    "ϑ_intS over S_FZG": (lambda x: scuffing_integral_temperature(replace(OIL, load_stage=x), 1.0), (4.0, 14.0), UP),
    "X_Ca over C_a": (lambda x: tip_relief_factor(replace(MESH, reliefs=(x, x))), (0.0, 30e-6), UP),
    "X_ε over ε_1": (lambda x: contact_ratio_factor_integral(x, 0.8), (0.05, 2.1), EITHER),
    "X_ε over ε_2": (lambda x: contact_ratio_factor_integral(0.75, x), (0.05, 2.2), EITHER),
    "X_ε of equal parts": (lambda x: contact_ratio_factor_integral(x, x), (0.2, 1.49), EITHER),
    "K_Bγ over ε_γ": (helical_factor, (2.05, 5.0), UP),
    "X_Y at A over b": (lambda x: share(x, 0.0), (1e-3, 90e-3), EITHER),
    "X_Y along the path": (lambda x: share(60e-3, x), (0.0, 1.0), EITHER),
    "ν over ϑ": (GRADE.kinematic, (20.0, 160.0), DOWN),
    "ρ over ϑ": (GRADE.density, (20.0, 160.0), DOWN),
    "α over ϑ": (GRADE.pressure_coefficient, (20.0, 160.0), DOWN),
}  # fmt: skip
"""Factor -> its function of one input, the range that is swept, and which way it runs."""
STEPS = {"K_s over m_et": 2e-4}
"""Steps that the standards have at a corner, for formulas whose coefficients are rounded [-]."""
EVALUATED = 160


def swept(name: str, count: int) -> tuple[int, np.ndarray]:
    function, (start, end), way = SWEEPS[name]
    places = np.geomspace(start, end, count) if start > 0.0 else np.linspace(start, end, count)
    return way, np.array([float(np.asarray(function(float(place)))) for place in places])


@pytest.mark.parametrize("name", SWEEPS)
def test_a_factor_runs_one_way_without_steps(name):
    way, coarse = swept(name, EVALUATED)
    assert np.all(np.isfinite(coarse)) and np.ptp(coarse) > 0.0
    size = np.max(np.abs(coarse))
    assert np.all(way * np.diff(coarse) >= -(1e-12 + STEPS.get(name, 0.0)) * size)
    fine = np.max(np.abs(np.diff(swept(name, 4 * EVALUATED)[1])))
    assert fine <= 0.3 * np.max(np.abs(np.diff(coarse))) + (STEPS.get(name, 0.0) + 1e-12) * size
