"""A property of every rating factor: which way it runs, that it has no steps but those of its standard, its ends.

Every sweep crosses the corners of its clauses. A factor is continuous when halving the grid halves its largest step;
those that the standards let jump are listed with their jump.
"""

from dataclasses import replace

import numpy as np
import pytest

from gearwright.parts.agma2001 import (
    BENDING_CARBURISED,
    PITTING,
    dynamic_factor_agma,
    hardened_pinion_factor,
    load_distribution_factor,
    reliability_factor,
    rim_factor_agma,
)
from gearwright.parts.iso6336 import (
    GearSteel,
    MeshDeviations,
    MeshDuty,
    MeshGeometry,
    MeshSprings,
    Misalignment,
    Treatment,
    bending_life_curve,
    bending_size_factor,
    contact_life_curve,
    dynamic_factor,
    dynamic_factor_by_speed,
    face_load_factor,
    life_factor,
    load_sharing_factor,
    lubricant_factor,
    notch_sensitivity_factor,
    rate_mesh,
    rim_factor,
    roughness_factor,
    speed_factor,
    static_notch_sensitivity,
    static_work_hardening,
    surface_factor,
    transverse_load_factor,
    work_hardening_factor,
)
from gearwright.parts.micropitting import FilmMesh, OilGrade, film_of_test, micropitting

CASE = GearSteel("Eh", Treatment.CASE_HARDENED, "MQ", 700.0, 1500e6, 500e6)
SOFT = GearSteel("V", Treatment.THROUGH_HARDENED, "MQ", 250.0, 700e6, 290e6, yield_strength=600e6)
SPUR = MeshGeometry((24.0, 48.0), 4e-3, 40e-3, 144e-3, (52e-3, 100e-3))
SPRINGS = MeshSprings(14e9, 20e9, 17e9)
ROUGH = MeshDeviations(8e-6, 6e-6)


def _face(offset):
    made = Misalignment(0.0, offset)
    return face_load_factor(SPUR, made, (CASE, CASE), stiffness=17e9, specific_load=2e5, speed=5.0).contact


def _transverse(deviation):
    return transverse_load_factor(SPUR, deviation, stiffness=20e9, specific_load=2e5, contact_ratio_factor=0.9).contact


def _dynamic(speed):
    return dynamic_factor(SPUR, SPRINGS, ROUGH, specific_load=2e5, pinion_speed=speed, masses=(3.0,)).factor


def _by_speed(speed):
    return dynamic_factor_by_speed(SPUR, 6, specific_load=2e5, speed=speed).factor


def _hard_mate(roughness):
    return work_hardening_factor(
        200.0, (Treatment.THROUGH_HARDENED, Treatment.CASE_HARDENED), mate_hardness=650.0, mate_roughness=roughness,
        ratio=3.0,
    )  # fmt: skip


def _tempered_mate(hardness):
    both = (Treatment.THROUGH_HARDENED, Treatment.THROUGH_HARDENED)
    return work_hardening_factor(200.0, both, mate_hardness=hardness, mate_roughness=3e-6, ratio=3.0)


def _overlap(width):
    slant = np.radians(20.0)
    helical = MeshGeometry(
        (24.0, 48.0), 4e-3, width, 144e-3 / np.cos(slant), (4e-3 + 48e-3 / np.cos(slant), 4e-3 + 96e-3 / np.cos(slant)),
        helix_angle=slant,
    )  # fmt: skip
    return load_sharing_factor(helical)


def _film(roughness):
    mesh = FilmMesh(SPUR, 5e3, 1.5, 150.0, roughness)
    return micropitting(mesh, OilGrade(100e-6), 80.0, stage=9.0).thinnest


UP, DOWN = 1, -1
SWEEPS = {
    "Z_L over ν_40": (lambda x: lubricant_factor(x, 1e9), (10e-6, 1e-3), UP),
    "Z_L over σ_Hlim": (lambda x: lubricant_factor(320e-6, x), (700e6, 1400e6), DOWN),
    "Z_v over v": (lambda x: speed_factor(x, 1e9), (0.1, 100.0), UP),
    "Z_R over R_z": (lambda x: roughness_factor(x, 20e-3, 1e9), (0.5e-6, 30e-6), DOWN),
    "Z_R over ρ_red": (lambda x: roughness_factor(4e-6, x, 1e9), (1e-3, 0.2), UP),
    "Z_W over R_zH": (_hard_mate, (3e-6, 16e-6), DOWN),
    "Z_W over the mate's hardness": (_tempered_mate, (240.1, 339.9), UP),
    "Z_W static over HV": (lambda x: static_work_hardening(replace(SOFT, hardness=x), CASE), (100.0, 400.0), DOWN),
    "Z_NT over N": (lambda x: life_factor(contact_life_curve(Treatment.CASE_HARDENED), x), (1e4, 1e11), DOWN),
    "Z_NT with some pitting": (
        lambda x: life_factor(contact_life_curve(Treatment.CASE_HARDENED, some_pitting=True), x), (1e4, 1e11), DOWN,
    ),
    "Y_NT over N": (lambda x: life_factor(bending_life_curve(Treatment.NITRIDED), x), (1e2, 1e11), DOWN),
    "Y_δrelT over q_s": (lambda x: notch_sensitivity_factor(x, CASE), (1.0, 8.0), UP),
    "Y_δrelT of a soft steel": (lambda x: notch_sensitivity_factor(x, SOFT), (1.0, 8.0), UP),
    "Y_δrelT over yield": (
        lambda x: notch_sensitivity_factor(6.0, replace(SOFT, yield_strength=x)), (300e6, 1000e6), DOWN,
    ),
    "Y_δrelT static over Y_S": (lambda x: static_notch_sensitivity(x, CASE), (1.0, 4.0), UP),
    "Y_RrelT over R_z": (lambda x: surface_factor(x, Treatment.CASE_HARDENED), (1e-6, 60e-6), DOWN),
    "Y_X over m_n": (lambda x: bending_size_factor(x, Treatment.CASE_HARDENED), (1e-3, 40e-3), DOWN),
    "Y_X of soft steel": (lambda x: bending_size_factor(x, Treatment.THROUGH_HARDENED), (1e-3, 40e-3), DOWN),
    "Y_B over s_R": (lambda x: rim_factor(x, 9e-3, 4e-3), (4.6e-3, 20e-3), DOWN),
    "Y_B of rings": (lambda x: rim_factor(x, 9e-3, 4e-3, internal=True), (7.1e-3, 20e-3), DOWN),
    "f_ε over b": (_overlap, (1e-4, 80e-3), DOWN),
    "K_Hβ over F_β": (_face, (1e-6, 80e-6), UP),
    "K_Hα over f_pb": (_transverse, (0.0, 60e-6), UP),
    "K_V below resonance": (_dynamic, (1.0, 0.84 * np.sqrt(20e9 / 3.0) / 24.0), UP),
    "K_V from resonance on": (_dynamic, (1.15 * np.sqrt(20e9 / 3.0) / 24.0, 3.0 * np.sqrt(20e9 / 3.0) / 24.0), DOWN),
    "K_V by method C": (_by_speed, (0.1, 12.0), UP),
    "K_v of AGMA over V": (lambda x: dynamic_factor_agma(x, 9.0), (0.1, 30.0), UP),
    "K_v of AGMA over Q_v": (lambda x: dynamic_factor_agma(10.0, x), (5.0, 11.0), DOWN),
    "K_m over F": (lambda x: load_distribution_factor(x, 0.1), (5e-3, 0.2), UP),
    "K_B over m_B": (rim_factor_agma, (0.6, 2.0), DOWN),
    "K_R over failures": (lambda x: reliability_factor(1.0 - x), (1e-4, 0.5), DOWN),
    "C_H over the gear's hardness": (lambda x: hardened_pinion_factor(x, 0.5e-6), (150.0, 450.0), DOWN),
    "Z_N over N": (lambda x: life_factor(PITTING, x), (1e3, 1e12), DOWN),
    "Y_N over N": (lambda x: life_factor(BENDING_CARBURISED, x), (1e2, 1e12), DOWN),
    "λ_GF over R_a": (_film, (0.1e-6, 2e-6), DOWN),
    "λ_GFT over the load stage": (lambda x: film_of_test(OilGrade(100e-6), x), (5.0, 10.0), DOWN),
}  # fmt: skip
"""Factor -> its function of one input, the range that is swept, and which way it runs."""
STEPS = {"Y_B over s_R": 1e-4}
"""Steps that the standards have at a corner, for formulas whose coefficients are rounded [-]."""
EVALUATED = 400


def swept(name, count):
    function, (start, end), way = SWEEPS[name]
    places = np.geomspace(start, end, count) if start > 0.0 else np.linspace(start, end, count)
    return way, np.array([float(np.asarray(function(float(place)))) for place in places])


@pytest.mark.parametrize("name", SWEEPS)
def test_a_factor_runs_one_way(name):
    way, values = swept(name, EVALUATED)
    assert np.all(np.isfinite(values))
    assert np.all(way * np.diff(values) >= -1e-12 - STEPS.get(name, 0.0))
    assert values[0] != values[-1]


@pytest.mark.parametrize("name", SWEEPS)
def test_a_factor_has_no_step_but_the_standards_own(name):
    """On a grid four times as fine the largest step is at most 0.3 of that on the coarse one."""
    coarse, fine = (np.max(np.abs(np.diff(swept(name, count)[1]))) for count in (EVALUATED, 4 * EVALUATED))
    assert fine <= 0.3 * coarse + STEPS.get(name, 0.0) + 1e-12


def test_two_equal_gears_are_rated_equally():
    """Symmetric where it must be: film, notch and load factors of equal gears do not know which drives."""
    even = MeshGeometry((30.0, 30.0), 4e-3, 40e-3, 120e-3, (64e-3, 64e-3))
    rated = rate_mesh(even, (CASE, CASE), MeshDuty(300.0, 100.0, 1e7))
    assert float(rated.bending[0].safety) == pytest.approx(float(rated.bending[1].safety), rel=1e-12)
    assert float(rated.pitting.safeties[0]) == pytest.approx(float(rated.pitting.safeties[1]), rel=1e-12)
