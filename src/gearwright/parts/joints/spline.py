"""Involute splines of DIN 5480: teeth for a shaft, diameters, and the length that a torque asks for."""

from __future__ import annotations

import math
from typing import NamedTuple

from gearwright.errors import DesignError, Problem

MODULES = (
    0.5e-3,
    0.6e-3,
    0.75e-3,
    0.8e-3,
    1e-3,
    1.25e-3,
    1.5e-3,
    1.75e-3,
    2e-3,
    2.5e-3,
    3e-3,
    4e-3,
    5e-3,
    6e-3,
    8e-3,
    10e-3,
)
"""Modules of the standard [m] (DIN 5480-1:2006)."""
BEARING_SHARE = 0.75
"""Share of the teeth that bear in a first sizing [-] (usual for flank centred splines of grade 8)."""
SHORTEST_RATIO = 0.6
"""l/d_B below which a hub rocks on its shaft [-] (usual for gears without another seat)."""
HOBBED = 0.60
"""Dedendum h_fP of a hobbed shaft over its module [-]; broached 0.55, shaped 0.65, cold rolled 0.84 (DIN 5480-1:2006,
basic rack profile)."""
ROOT_DEPTH = 1.1 + 2.0 * HOBBED
"""(d_B − d_f1)/m of a hobbed shaft [-]: d_f1 = m z + 2 x m − 2 h_fP with m z + 2 x m = d_B − 1.1 m."""
_SHIFT = (-0.05, 0.45)
"""Range of the profile shift x of shafts [-] (DIN 5480-1:2006)."""


class Spline(NamedTuple):
    """A shaft-hub joint with involute teeth of 30°."""

    reference_diameter: float
    """d_B [m]."""
    module: float
    """m [m]."""
    teeth: int
    """z [-]."""
    profile_shift: float
    """x of the shaft [-]; that of the hub is −x."""

    @property
    def pitch_diameter(self) -> float:
        """D = m z [m]."""
        return self.module * self.teeth

    @property
    def shaft_tip(self) -> float:
        """Tip diameter of the shaft d_a1 = d_B − 0.2 m [m]."""
        return self.reference_diameter - 0.2 * self.module

    @property
    def hub_tip(self) -> float:
        """Tip diameter of the hub d_a2 = d_B − 2 m [m]."""
        return self.reference_diameter - 2.0 * self.module

    @property
    def shaft_root(self) -> float:
        """Root diameter of the hobbed shaft d_f1 = d_B − 2.3 m [m]; DIN 5480-2 lists d_B − 2.2 m, the largest."""
        return self.reference_diameter - ROOT_DEPTH * self.module


def spline(reference_diameter: float, module: float) -> Spline:
    """Return the teeth of DIN 5480 on a shaft.

    Of two numbers of teeth with an allowed shift the even one is taken, as the standard does.

    Args:
        reference_diameter: d_B, that of the bearing or shaft [m].
        module: m [m].

    Source: DIN 5480-1:2006: d_B = m (z + 2 x + 1.1) with −0.05 ≤ x ≤ 0.45.

    Raises:
        DesignError: If the module is not standard or too few teeth fit.

    >>> spline(0.120, 0.003).teeth
    38
    """
    if not any(math.isclose(module, standard) for standard in MODULES):
        closest = min(MODULES, key=lambda standard: abs(standard - module))
        message = f"{1e3 * module:g} mm is not a module of DIN 5480; the nearest is {1e3 * closest:g} mm"
        raise DesignError([Problem("spline.module", message)])
    room = reference_diameter / module - 1.1
    fewest, most = math.ceil(room - 2.0 * _SHIFT[1] - 1e-9), math.floor(room - 2.0 * _SHIFT[0] + 1e-9)
    teeth = next((z for z in range(fewest, most + 1) if z % 2 == 0), fewest)
    if teeth < 6:
        message = f"{1e3 * reference_diameter:g} mm has room for {teeth} teeth of {1e3 * module:g} mm; 6 are needed"
        raise DesignError([Problem("spline.reference_diameter", message)])
    return Spline(reference_diameter, module, teeth, (room - teeth) / 2.0)


def spline_pressure(torque: float, joint: Spline, length: float, *, share: float = BEARING_SHARE) -> float:
    """Return the mean pressure on the flanks of a spline [Pa].

    Args:
        torque: T [N m].
        joint: Teeth [m].
        length: Bearing length l [m].
        share: Of the teeth that bear k [-].

    Source: first sizing as in Roloff/Matek, Maschinenelemente, with DIN 5480 heights: p = 2 T/(d_m h l z k),
        h = (d_a1 − d_a2)/2 = 0.9 m, d_m = (d_a1 + d_a2)/2 = d_B − 1.1 m.
    """
    return spline_length(torque, joint, share=share, allowable=1.0) / length


def spline_length(torque: float, joint: Spline, *, allowable: float, share: float = BEARING_SHARE) -> float:
    """Return the bearing length that a torque asks for [m]; 0.6 d_B at least keeps the hub from rocking.

    Args:
        torque: T [N m].
        joint: Teeth [m].
        allowable: Pressure on the flanks [Pa].
        share: Of the teeth that bear k [-].

    Source: as `spline_pressure`, solved for l.
    """
    height = (joint.shaft_tip - joint.hub_tip) / 2.0
    middle = (joint.shaft_tip + joint.hub_tip) / 2.0
    return 2.0 * torque / (middle * height * joint.teeth * share * allowable)
