"""The film at which an oil lets flanks micropit: the FZG test C-GF/8.3/90 (FVA 54/7) at its failure load stage."""

from __future__ import annotations

import numpy as np

from gearwright.errors import Problem, refuse
from gearwright.parts.iso6336 import MeshGeometry, Treatment
from gearwright.parts.micropitting.film import FilmMesh, film_thickness, path_places
from gearwright.parts.micropitting.lubricant import OilGrade
from gearwright.units import RPM

STAGES = {5: 70.0, 6: 98.9, 7: 132.5, 8: 171.6, 9: 215.6, 10: 265.1}
"""Load stage -> torque on the pinion of the test [N m] (FVA 54/7)."""
_GEARS = MeshGeometry((16.0, 24.0), 4.5e-3, 14e-3, 91.5e-3, (41.23e-3, 59.18e-3))
"""Gears of type C-GF: m_n 4.5 mm, b 14 mm, d_a 82.46 and 118.36 mm."""
_SPEED, _TEMPERATURE, _ROUGHNESS = 2250.0 * RPM, 90.0, 0.5e-6
_LOAD_FACTOR, _PRESSURE = 1.163, 1.045
"""On the load of friction, and on the line load at A, which the test's gears add [-]: back-reckoned from the bulk and
the contact temperature, 127.7 and 251.7 °C, that a commercial report prints at load stage 10."""
_LINE_LOAD = _PRESSURE * 236.3e3 / 265.1
"""F_bb/b at A over the torque of the pinion [1/m²]: 236.3 N/mm at load stage 10, by the same report."""
MATERIAL = {
    Treatment.CASE_HARDENED: 1.0,
    Treatment.NITRIDED: 1.5,
    Treatment.NITRIDED_THROUGH_HARDENED: 1.5,
    Treatment.NITROCARBURISED: 1.5,
    Treatment.INDUCTION_HARDENED: 0.65,
    Treatment.THROUGH_HARDENED: 0.5,
    Treatment.STRUCTURAL: 0.5,
}
"""Material factor W_W [-] (ISO/TR 15144-1:2014, annex A; case-hardened with up to 25 % austenite)."""


def film_of_test(oil: OilGrade, stage: float) -> float:
    """Return the specific film thickness λ_GFT at which an oil fails the micropitting test [-].

    Args:
        oil: The oil.
        stage: Load stage of its failure, 5 to 10 [-].

    Source: ISO/TR 15144-1:2014, annex A: the film of the test gears at A by method B, R_a 0.5 µm, 90 °C, sprayed with
        X_S = 1.2; between stages straight over their torque.

    Raises:
        DesignError: a load stage that the test does not have.

    >>> round(film_of_test(OilGrade(220e-6, 19e-6, 890.0), 10), 2)
    0.1
    """
    low, high = min(STAGES), max(STAGES)
    refuse(
        [Problem("stage", f"{stage:g} given; FVA 54/7 has stages {low} to {high}")] if not low <= stage <= high else []
    )
    torque = float(np.interp(stage, list(STAGES), list(STAGES.values())))
    force = 2.0 * torque / float(_GEARS.pitch_diameters[0])
    nominal = force / float(np.cos(_GEARS.transverse_angle)) / float(_GEARS.face_width)
    share = np.full(len(path_places(_GEARS)), _LINE_LOAD * torque / nominal / _LOAD_FACTOR)
    mesh = FilmMesh(_GEARS, force, _LOAD_FACTOR, _SPEED, _ROUGHNESS, supply=1.2)
    return float(film_thickness(mesh, oil, _TEMPERATURE, sharing=share).relative(_ROUGHNESS)[0])


def permissible_film(oil: OilGrade, stage: float, treatment: Treatment = Treatment.CASE_HARDENED) -> float:
    """Return the permissible specific film thickness λ_GFP [-].

    Args:
        oil: The oil.
        stage: Load stage at which it fails the micropitting test [-].
        treatment: Of the weaker flank.

    Source: ISO/TR 15144-1:2014, annex A: λ_GFP = 1.4 W_W λ_GFT.
    """
    return 1.4 * MATERIAL[treatment] * film_of_test(oil, stage)
