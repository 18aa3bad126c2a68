"""Margins: every check of a sizing in one list, the worst first."""

from __future__ import annotations

import math
from dataclasses import dataclass

from gearwright.sizing.mounted import Check
from gearwright.sizing.result import CarrierSizing, MeshSizing, ShaftSizing, Sizing
from gearwright.units import Ratio, shown, unit

ROUNDING = 1e-9
"""Of a margin that counts as rounding [-]."""


@dataclass(frozen=True)
class Margin:
    """One check of one part."""

    part: str
    check: str
    """What is checked."""
    case: str
    """Load case that governs; empty where no single one does."""
    value: float
    """As computed, in the unit."""
    limit: float
    """With the asked factor in it, in the unit."""
    unit: str
    """Empty for a ratio."""
    margin: Ratio
    """1 is just enough [-]."""
    source: str
    """Equation or clause."""
    group: str
    """gears, shafts, bearings, joints or carriers."""

    @property
    def holds(self) -> bool:
        """True if the value is allowed."""
        return self.margin >= 1.0 - ROUNDING


def margins(sizing: Sizing) -> tuple[Margin, ...]:
    """Return every check of a sizing, worst first.

    Args:
        sizing: As sized.
    """
    margins = [margin for mesh in sizing.meshes if mesh.rating is None for margin in _mesh_margins(mesh)]
    margins += [_shaft_margin(shaft) for shaft in sizing.shafts]
    margins += [margin for carrier in sizing.carriers for margin in _carrier_margins(carrier)]
    margins += [_checked(check, _group(sizing, check)) for check in sizing.checks]
    return tuple(sorted(margins, key=lambda margin: (round(margin.margin, 9), margin.part)))


def _checked(check: Check, group: str) -> Margin:
    value, limit = (shown(amount, check.dimension) for amount in (check.value, check.limit))
    return Margin(
        check.part, check.check, check.case, value, limit, unit(check.dimension), check.margin, check.clause, group
    )


def _group(sizing: Sizing, check: Check) -> str:
    """Return the kind of part that a check is about."""
    first = check.part.partition(" ")[0]
    if check.part in {shaft.name for shaft in sizing.built_shafts}:
        return "shafts"
    if first in sizing.design.bearings:
        return "bearings"
    return "joints" if " on " in check.part else "gears"


def _mesh_margins(mesh: MeshSizing) -> list[Margin]:
    return [
        _stressed(mesh.name, "bending", mesh.case, mesh.bending_stress, mesh.bending_margin, "eq. 2.1", "gears"),
        _stressed(mesh.name, "contact", mesh.case, mesh.contact_stress, mesh.contact_margin, "eq. 2.2", "gears"),
    ]  # fmt: skip


def _shaft_margin(shaft: ShaftSizing) -> Margin:
    return _stressed(shaft.name, "Tresca", shaft.case, shaft.stress, shaft.margin, "eq. 2.47", "shafts")


def _carrier_margins(carrier: CarrierSizing) -> list[Margin]:
    part, case = f"{carrier.stage}.carrier", carrier.case
    pins = _stressed(part, "pin bending", case, carrier.pin_stress, carrier.pin_margin, "cantilever", "carriers")
    if carrier.plate_margin is None:
        return [pins]
    plate = _stressed(part, "plate shear", case, carrier.plate_stress, carrier.plate_margin, "Tresca", "carriers")
    return [pins, plate]


def _stressed(part: str, check: str, case: str, stress: float, margin: float, source: str, group: str) -> Margin:
    value = shown(stress, "stress")
    limit = value * margin if math.isfinite(margin) else math.inf
    return Margin(part, check, case, value, limit, unit("stress"), margin, source, group)
