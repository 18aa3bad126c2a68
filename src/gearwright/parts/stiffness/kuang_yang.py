"""Two closed forms of mesh stiffness: Kuang & Yang's single tooth, and a cut square wave.

They are here to be compared with; `mesh_stiffness_iso6336` is the default.
"""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import ArrayLike

from gearwright.arrays import Floats
from gearwright.errors import DesignError, Problem, refuse
from gearwright.parts.gears import CylindricalGear, GearPair, contact_radii
from gearwright.parts.material import STEEL_MODULUS
from gearwright.parts.stiffness.curve import StiffnessCurve
from gearwright.parts.stiffness.passing_pairs import pair_curve

KUANG_YANG_TEETH = (12, 50)
"""Numbers of teeth for which the cubics are trusted [-]: A_0 falls 19 % from z = 40 to 80; real teeth get stiffer."""
_CUBICS = (
    (3.867, 1.612, -0.02916, 0.0001553),
    (17.060, 0.7289, -0.01728, 0.0000993),
    (2.637, -1.222, 0.02217, -0.0001179),
    (-6.330, -1.033, 0.02068, -0.0001130),
)
"""A_0 to A_3 as cubics of z, N/(µm mm). The thesis prints 0.00009993 and 0.0001179 for the last two of A_1 and A_3."""
_UNIT = 1e9  # N/(µm mm) in N/m²


def tooth_stiffness_kuang_yang(teeth: int, radius_offset: ArrayLike, profile_shift: float = 0.0) -> Floats:
    """Return the stiffness of one tooth of a steel spur gear per unit face width.

    Args:
        teeth: Number of teeth z [-].
        radius_offset: Radius of the load less the reference radius, in modules [-], any shape.
        profile_shift: Profile shift coefficient X [-].

    Returns:
        K [N/m²], shape of `radius_offset`.

    Source: Kuang & Yang 1992, Int. Power Transmission and Gearing Conf., ASME; Pulvirenti 2023, eq. (3.18) to (3.22)
        with the factor 10⁹ on the whole sum and (1 + X) in the denominator.
    Valid for: external, 20° full depth, 12 ≤ z ≤ 50 and |X| ≤ 0.6.

    Raises:
        DesignError: outside that range.

    >>> round(float(tooth_stiffness_kuang_yang(20, 0.0)) / 1e9, 4)
    25.6854
    """
    fewest, most = KUANG_YANG_TEETH
    problems = []
    if not fewest <= teeth <= most:
        problems.append(
            Problem("teeth", f"{teeth} given; Kuang & Yang's fit holds from {fewest} to {most}: use ISO 6336-1")
        )
    if abs(profile_shift) > 0.6:
        problems.append(
            Problem("profile_shift", f"{profile_shift:.3g} given; Kuang & Yang's fit holds from −0.6 to 0.6")
        )
    refuse(problems)
    a_0, a_1, a_2, a_3 = (sum(c * teeth**n for n, c in enumerate(cubic)) for cubic in _CUBICS)
    x = profile_shift
    return np.asarray(_UNIT * ((a_0 + a_1 * x) + (a_2 + a_3 * x) * np.asarray(radius_offset) / (1.0 + x)))


def mesh_stiffness_kuang_yang(
    pair: GearPair, *, harmonics: int = 8, elastic_moduli: tuple[float, float] = (STEEL_MODULUS, STEEL_MODULUS)
) -> StiffnessCurve:
    """Return the time-varying stiffness of two teeth in series by Kuang and Yang, pairs in contact added.

    Args:
        pair: External spur pair.
        harmonics: Harmonics of the mesh phase to keep [-].
        elastic_moduli: E of driver and driven gear [Pa]; a tooth is as stiff as its E beside that of steel.

    Source: Kuang & Yang 1992; Pulvirenti 2023, eq. (3.23). No Hertzian deflection.
    Valid for: as `tooth_stiffness_kuang_yang`.
    """
    if pair.side < 0 or pair.driver.helix_angle > 0.0:
        raise DesignError(
            [Problem("", "Kuang & Yang's fit holds for external spur pairs: use ISO 6336-1 or the energy method")]
        )
    pitch = pair.driver.base_pitch

    def single(place: Floats) -> Floats:
        radii = np.array([contact_radii(pair, float(s) * pitch) for s in place]).T
        teeth = zip((pair.driver, pair.driven), radii, elastic_moduli, strict=True)
        first, second = (modulus / STEEL_MODULUS * _tooth(gear, r) for gear, r, modulus in teeth)
        return pair.face_width * first * second / (first + second)

    return pair_curve(
        (-pair.approach / pitch, pair.recess / pitch),
        single,
        overlap=0.0,
        harmonics=harmonics,
        source="Kuang & Yang 1992",
    )


def cut_square_wave(mean: float) -> StiffnessCurve:
    """Return a variable stiffness: a square wave of ± a quarter of the mean, cut at its fifth harmonic.

    Args:
        mean: Mean mesh stiffness K [N/m].

    Returns:
        K + (K/π) (sin φ + sin 3φ/3 + sin 5φ/5); contact ratio and levels of the real teeth are not in it.

    Source: Pulvirenti 2023, eq. (3.35), written in the mesh phase.
    """
    sine = tuple(mean / (math.pi * n) if n % 2 else 0.0 for n in range(1, 6))
    return StiffnessCurve(mean, (0.0,) * 5, sine, "Pulvirenti 2023, eq. (3.35)")


def _tooth(gear: CylindricalGear, radius: Floats) -> Floats:
    """Stiffness of a gear's tooth at given radii [N/m²]."""
    return tooth_stiffness_kuang_yang(gear.teeth, (radius - gear.pitch_radius) / gear.module, gear.profile_shift)
