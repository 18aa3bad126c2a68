"""Rings whose tips reach below the involutes of their mates, into the fillets that a rack leaves there."""

from __future__ import annotations

import math
from typing import NamedTuple

from gearwright.parts.gears import form_radius
from gearwright.sizing.mass import tooth_of
from gearwright.sizing.meshed import MeshSizing
from gearwright.sizing.result import GearSizing, Sizing
from gearwright.spec import Design

ROUNDED = 1e-6
"""How far tips may reach below an involute by rounding [m]."""
SHADE = 1e-4
"""What is added to a tip alteration so that it suffices when written with four decimals [-]."""


class InFillet(NamedTuple):
    """Tips of a ring in the fillets of a mate."""

    mesh: MeshSizing
    below: float
    """How far below the beginning of the mate's involute they touch [m]."""
    path: str
    """Of the ring's tip alteration in the design."""
    tip_alteration: float
    """k of the ring with which they end where the involute begins [-]."""

    @property
    def sentence(self) -> str:
        """What is wrong, and what mends it."""
        mate, ring = self.mesh.gears
        return (
            f"tips of {ring} reach {1e6 * self.below:.3g} µm below the involutes of {mate}, into fillets that a rack "
            f"leaves: {self.path} = {self.tip_alteration:.4f} keeps them out"
        )


def tips_in_fillets(sizing: Sizing) -> tuple[InFillet, ...]:
    """Return the rings whose tips reach below the involutes of their mates.

    Args:
        sizing: As sized.

    Source: radius at which a ring's tip touches, r_1² = r_b1² + (√(r_a2² − r_b2²) − a_w sin α_wt)² (ISO 21771:2007),
        and the same solved for r_a2.
    """
    gears, found = {gear.name: gear for gear in sizing.gears}, list[InFillet]()
    for row in sizing.meshes:
        if row.gears[1] not in sizing.train.internal:
            continue
        mate, ring = (tooth_of(sizing, gears[name]) for name in row.gears)
        line = row.centre_distance * math.sin(row.working_pressure_angle)
        touched = math.sqrt(max(ring.tip_radius**2 - ring.base_radius**2, 0.0)) - line
        form = form_radius(mate)
        below = form - math.hypot(mate.base_radius, max(touched, 0.0))
        if below > ROUNDED:
            tip = math.hypot(ring.base_radius, line + math.sqrt(max(form**2 - mate.base_radius**2, 0.0)))
            own = gears[row.gears[1]]
            shortened = own.tip_alteration - (tip - ring.tip_radius) / own.module - SHADE
            found.append(InFillet(row, below, _path(sizing.design, own), shortened))
    return tuple(found)


def _path(design: Design, ring: GearSizing) -> str:
    """Return where a design has the tip alteration of a ring."""
    own = f"rings.{ring.own}.tip_alteration" if ring.own else f"{ring.role}_tip_alteration"
    return f"{design.table(ring.stage)}.{own}"
