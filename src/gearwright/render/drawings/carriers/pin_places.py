"""How true the pins of a carrier stand, and what that makes of the load of a planet."""

from __future__ import annotations

import math
from typing import NamedTuple

from gearwright.catalogue import LARGEST, SMALLEST, standard_tolerance
from gearwright.identity import Role, gear_part
from gearwright.parts.planetary import pin_error_share, pin_error_within
from gearwright.sizing import CarrierSizing, Sizing

PLACE_GRADE = 6
"""Of the zone in which the axis of a pin lies, over the radius of the pin circle; assumed."""
MESH_STIFFNESS = 20e9
"""Of steel teeth over their width [N/m²]: 20 N/(mm µm), the mean value of ISO 6336-1 for c_γ, from memory."""


class PinPlaces(NamedTuple):
    """Where the axes of pins may stand."""

    zone: float | None
    """Diameter of the zone about the true place [m]; None beyond the sizes of ISO 286-1."""
    origin: str
    """Where it comes from, as a note says it."""
    asked: float
    """K_γ that the stage is rated with [-]."""
    is_simple: bool = False
    """Whether the closed form holds for its set: three planets or more around one sun."""
    floating: float | None = None
    """K_γ with one pin at the edge of its zone, where a member floats [-]; None where planets lose all load."""
    fixed: float | None = None
    """The same where none does [-]."""


class _Set(NamedTuple):
    """What the closed form asks of a set."""

    planets: int
    force: float
    stiffness: tuple[float, float]
    angle: float


def pin_places(sizing: Sizing, carrier: CarrierSizing) -> PinPlaces:
    """Return in which zone the pins of a carrier stand: by the design's errors, else so that K_γ is kept, at most IT6.

    Args:
        sizing: What was sized.
        carrier: Of it.

    Source: Ligata, Kahraman & Singh 2009 by `gearwright.parts.planetary.pin_error_share`; zones by ISO 286-1.
    """
    set_, asked = _set_of(sizing, carrier), sizing.design.rules(carrier.stage).mesh_load_factor or 1.0
    errors = _stated(sizing, carrier)
    fits = SMALLEST < carrier.radius <= LARGEST
    zone = standard_tolerance(carrier.radius, PLACE_GRADE) if fits else None
    origin = f"IT{PLACE_GRADE} of the pin circle's radius (assumed)"
    if errors:
        zone, origin = 2.0 * errors, "twice the largest error of a pin in [errors]"
    elif set_ is not None and asked > 1.0 and zone is not None:
        kept = 2.0 * pin_error_within(set_.planets, asked, set_.force, stiffness=set_.stiffness,
                                      pressure_angle=set_.angle, floating=True)  # fmt: skip
        if kept < zone:
            zone, origin = math.floor(1e6 * kept) / 1e6, f"keeps K_{{γ}} = {asked:g} of the design, if a member floats"
    if set_ is None or not zone:
        return PinPlaces(zone or None, origin, asked)
    floating, fixed = (_factor(set_, zone / 2.0, floating=way) for way in (True, False))
    return PinPlaces(zone, origin, asked, is_simple=True, floating=floating, fixed=fixed)


def _stated(sizing: Sizing, carrier: CarrierSizing) -> float:
    """Return the largest error of a pin that the design has [m]."""
    count = max(gear.bodies for gear in sizing.gears if gear.stage == carrier.stage and gear.role is Role.PLANET)
    names = [str(gear_part(carrier.stage, Role.PLANET, number=k)) for k in range(1, count + 1)]
    rows = [sizing.design.errors[name] for name in names if name in sizing.design.errors]
    return max((math.hypot(row.pin_tangential, row.pin_radial) for row in rows), default=0.0)


def _set_of(sizing: Sizing, carrier: CarrierSizing) -> _Set | None:
    """Return what the closed form asks; None of compound sets, fewer than three planets, and without load."""
    planetary = sizing.design.planetaries.get(carrier.stage)
    if planetary is None or planetary.planets < 3 or not carrier.torque:
        return None
    rows = [mesh for mesh in sizing.meshes if mesh.stage == carrier.stage]
    width = next(gear.face_width for gear in sizing.gears if gear.stage == carrier.stage and gear.role is Role.PLANET)
    angle = sum(row.working_pressure_angle for row in rows) / len(rows)
    stiffness = MESH_STIFFNESS * width
    return _Set(planetary.planets, carrier.torque / carrier.radius, (stiffness, stiffness), angle)


def _factor(set_: _Set, error: float, *, floating: bool) -> float | None:
    """Return K_γ; None where a neighbour would lose more than its load, which the closed form does not know."""
    count, free = set_.planets, 3 if floating else 1
    factor = count * pin_error_share(
        count, error, set_.force, stiffness=set_.stiffness, pressure_angle=set_.angle, floating=floating
    )
    if count == free:
        return factor
    loss = (factor - 1.0) / (count - free) * (1.0 + 2.0 * math.cos(2.0 * math.pi / count) if floating else 1.0)
    return factor if loss <= 1.0 else None
