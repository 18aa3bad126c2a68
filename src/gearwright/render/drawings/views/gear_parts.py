"""A gear's body as its drawing shows it: bore, joint and rim; in mm."""

from __future__ import annotations

from dataclasses import dataclass, replace

from gearwright.catalogue import key_for_shaft
from gearwright.identity import Role
from gearwright.parts.joints import KeySection, Spline
from gearwright.render.drawings.views.shaft_parts import MM, away_of, bevel_profile, spline_of, toothed_piece
from gearwright.shape.teeth import cylindrical_gear, is_internal, kind_of
from gearwright.sizing import GearSizing, JointSizing, Sizing
from gearwright.sizing.places import BOSS

LEAST_WALL = 1.0
"""Wall between a bore and the roots of the teeth below which no bore is drawn, in modules [-]."""


@dataclass(frozen=True)
class Boss:
    """The hub of a bevel gear where it sits on its shaft, along the axis away from the apex, from the mean point."""

    start: float
    """[mm]"""
    end: float
    """[mm]"""
    diameter: float
    """[mm]"""


@dataclass(frozen=True)
class Hub:
    """The bore of a gear and what is cut into it."""

    bore: float
    """[mm]; zero where there is none."""
    tolerance: str = ""
    """Tolerance class of the bore."""
    key: KeySection | None = None
    teeth: Spline | None = None
    designation: str = ""
    note: str = ""
    """Where the bore comes from, or why there is none."""
    boss: Boss | None = None
    """Of a bevel gear whose seat is sized."""

    @property
    def reach(self) -> float:
        """Largest diameter that is cut out on the side of the keyway [mm]."""
        if self.key is not None:
            return self.bore + 2.0 * MM * self.key.hub_depth
        return MM * self.teeth.reference_diameter if self.teeth is not None else self.bore


def hub_of(sizing: Sizing, gear: GearSizing, shaft: str) -> Hub:
    """Return the bore of a gear: its joint's, or the diameter of what carries it where no joint is sized.

    Args:
        sizing: What was sized.
        gear: One of its gears.
        shaft: That carries it.
    """
    joint = next((joint for joint in sizing.joints if joint.part == gear.name and joint.shaft == shaft), None)
    if joint is not None:
        hub = _joined(joint)
        return replace(hub, boss=_boss(sizing, gear, joint, hub)) if kind_of(sizing, gear.stage) == "bevel" else hub
    if is_internal(sizing, gear):
        return Hub(0.0, note="What holds the ring is not sized; it is not drawn.")
    carrier = next((carrier for carrier in sizing.carriers if carrier.stage == gear.stage), None)
    if gear.role is Role.PLANET and carrier is not None:
        return _fitting(sizing, gear, MM * carrier.pin_diameter, "Bore: diameter of the pin; its bearing is not sized.")
    sized = next((body for body in sizing.shafts if body.name == shaft), None)
    diameter = MM * sized.diameter if sized is not None else 0.0
    return _fitting(sizing, gear, diameter, "Bore: diameter of the shaft; their joint is not sized.")


def _joined(joint: JointSizing) -> Hub:
    diameter = MM * joint.diameter
    if joint.kind == "integral":
        return Hub(0.0, note=f"One piece with shaft {joint.shaft}; see its sheet.")
    if joint.kind == "key":
        return Hub(diameter, "H7", key=key_for_shaft(joint.diameter).section, designation=joint.designation,
                   note="Bore H7, keyway P9 (assumed).")  # fmt: skip
    if joint.kind == "spline":
        teeth = spline_of(joint)
        designation = joint.designation.replace(" W ", " N ")
        note = f"Hub {designation}; the bore shown is its tip circle."
        return Hub(MM * teeth.hub_tip, teeth=teeth, designation=designation, note=note)
    return Hub(diameter, "H7", note="Bore H7 (assumed); press fit by its joint's calculation.")


def _boss(sizing: Sizing, gear: GearSizing, joint: JointSizing, hub: Hub) -> Boss | None:
    """Return the hub over the gear's seat on its shaft, within the root at the small end; None of one piece with it."""
    built = next(shaft for shaft in sizing.built_shafts if shaft.name == joint.shaft)
    seats = [step for step in built.steps if step.seat == gear.name]
    if not hub.bore or not seats:
        return None
    away = away_of(sizing, gear)
    ends = sorted(away * MM * (edge - joint.position) for edge in (seats[0].start, seats[-1].end))
    root = 2.0 * bevel_profile(sizing, gear).roots[0].imag
    return Boss(ends[0], ends[1], max(min(BOSS * hub.reach, root), hub.bore))


def _fitting(sizing: Sizing, gear: GearSizing, diameter: float, note: str) -> Hub:
    """Return a plain bore, or none where it would leave no wall under the teeth."""
    if kind_of(sizing, gear.stage) == "bevel":
        root = toothed_piece(sizing, gear, 0.0).diameters
        inner = min(root) - 2.0 * MM * 2.25 * gear.module
    else:
        inner = 2.0 * MM * cylindrical_gear(sizing, gear).root_radius
    if diameter > inner - 2.0 * LEAST_WALL * MM * gear.module:
        return Hub(0.0, note=f"A shaft of Ø{diameter:.4g} leaves no wall under the teeth: one piece with its shaft.")
    return Hub(diameter, note=note)
