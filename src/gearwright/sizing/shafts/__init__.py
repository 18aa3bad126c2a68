"""Shafts of one diameter and built ones: stretches, sections, joints, bending, room, checks; carriers of planets.

What holds parts and bearings along sized shafts is the room `holding`.
"""

from gearwright.sizing.bearings import centred_bearings, pressure_centre_checks
from gearwright.sizing.shafts.building import Built
from gearwright.sizing.shafts.carriers import carrier_checks, size_carriers
from gearwright.sizing.shafts.ends import (
    Groove,
    Held,
    Leaving,
    Sealed,
    Thread,
    case_hardened,
    cut_steps,
    groove_checks,
    grooves,
    held_rings,
    holders_of,
    holding_checks,
    leaving_of,
    seal_checks,
    sealed_exits,
    threads,
    unsealed_exits,
)
from gearwright.sizing.shafts.retention import ENDS, Holder, Retention, ends, retention_checks, retentions
from gearwright.sizing.shafts.sections import Cut, Section, Strength, strengths, undercuts_of
from gearwright.sizing.shafts.shafts import (
    built_checks,
    refuse_bores,
    refuse_idle_shafts,
    shaft_checks,
    shaft_material,
    size_shafts,
)

__all__ = [
    "ENDS",
    "Built",
    "Cut",
    "Groove",
    "Held",
    "Holder",
    "Leaving",
    "Retention",
    "Sealed",
    "Section",
    "Strength",
    "Thread",
    "built_checks",
    "carrier_checks",
    "case_hardened",
    "centred_bearings",
    "cut_steps",
    "ends",
    "groove_checks",
    "grooves",
    "held_rings",
    "holders_of",
    "holding_checks",
    "leaving_of",
    "pressure_centre_checks",
    "refuse_bores",
    "refuse_idle_shafts",
    "retention_checks",
    "retentions",
    "seal_checks",
    "sealed_exits",
    "shaft_checks",
    "shaft_material",
    "size_carriers",
    "size_shafts",
    "strengths",
    "threads",
    "undercuts_of",
    "unsealed_exits",
]
