"""Shafts of one diameter and built ones: stretches, sections, joints, bending, room, checks; carriers of planets.

What holds parts and bearings along sized shafts is the room `holding`.
"""

from gearwright.sizing.shafts.building import Built
from gearwright.sizing.shafts.carriers import size_carriers
from gearwright.sizing.shafts.checks import built_checks, carrier_checks, shaft_checks
from gearwright.sizing.shafts.holding import (
    ENDS,
    Groove,
    Held,
    Holder,
    Retention,
    Sealed,
    Thread,
    case_hardened,
    cut_steps,
    ends,
    groove_checks,
    grooves,
    held_rings,
    holders_of,
    holding_checks,
    retention_checks,
    retentions,
    seal_checks,
    sealed_exits,
    threads,
    unsealed_exits,
)
from gearwright.sizing.shafts.pressure_centres import centred_bearings, pressure_centre_checks
from gearwright.sizing.shafts.refusals import refuse_bores, refuse_idle_shafts
from gearwright.sizing.shafts.sections import Section, Strength, strengths
from gearwright.sizing.shafts.shafts import shaft_material, size_shafts
from gearwright.sizing.shafts.undercuts import Cut, undercuts_of

__all__ = [
    "ENDS",
    "Built",
    "Cut",
    "Groove",
    "Held",
    "Holder",
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
