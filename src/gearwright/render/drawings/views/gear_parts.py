"""A gear's body as its drawing shows it: bore, joint and rim; in mm."""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import NamedTuple

from gearwright.catalogue import key_for_shaft
from gearwright.identity import Role
from gearwright.parts.bevel import bevel_way
from gearwright.parts.joints import KeySection, Spline
from gearwright.render.drawings.views.shaft_parts import MM, away_of, bevel_profile, spline_of, toothed_piece
from gearwright.render.drawings.views.weights import made_of
from gearwright.shape.teeth import bevel_pair, cylindrical_gear, halves_of, is_internal, kind_of, meshes_of
from gearwright.sizing import GearSizing, JointSizing, Sizing
from gearwright.sizing.casing import ring_seats
from gearwright.sizing.mass import bevel_dish, bevel_hub, bevel_web
from gearwright.sizing.places import BOSS
from gearwright.spec import GROUND

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


class Web(NamedTuple):
    """What is turned out of a cylindrical gear on both sides, between its rim and its hub [mm]."""

    rim: float
    """Radius inside the rim."""
    hub: float
    """Radius outside of the hub."""
    width: float
    """Of what is left between them."""
    holes: int = 0
    """Through it, evenly spaced [-]."""
    circle: float = 0.0
    """Radius of the circle of their middles."""
    hole: float = 0.0
    """Radius of one."""
    dish: float = 0.0
    """How far it stands at the hub from where it stands at the rim, towards the shaft's second end."""

    def aside(self, radius: float) -> float:
        """Return how far it stands from the middle at a radius [mm].

        Args:
            radius: Between hub and rim [mm].
        """
        return self.dish * (self.rim - radius) / (self.rim - self.hub)


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
    web: Web | None = None
    """Of a cylindrical gear that is not solid between rim and hub."""
    way: tuple[complex, ...] = ()
    """Behind the teeth of a bored bevel gear, as it is weighed: along the axis away from the apex, and radius [mm]."""

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
    hub = _bored(sizing, gear, shaft)
    return replace(hub, web=_web(sizing, gear), way=_way(sizing, gear, hub))


def _way(sizing: Sizing, gear: GearSizing, hub: Hub) -> tuple[complex, ...]:
    """Return the way behind the teeth of a bored bevel gear, with the bore that is drawn."""
    if not hub.bore or kind_of(sizing, gear.stage) != "bevel":
        return ()
    pair, side = bevel_pair(sizing, gear.stage), meshes_of(sizing, gear.name)[0][1]
    bore = made_of(sizing).blanks[gear.name].bore_radius
    web, seat = bevel_web(sizing, gear, bore), bevel_hub(sizing, gear, bore)
    points = bevel_way(pair, side, bore, web, seat, dish=bevel_dish(sizing, gear))
    inner = min(radius for _, radius in points)
    return tuple(complex(MM * z, hub.bore / 2.0 if radius == inner else MM * radius) for z, radius in points)


def _web(sizing: Sizing, gear: GearSizing) -> Web | None:
    """Return what is turned out of a cylindrical gear, as it is weighed; None of a solid one."""
    blank = made_of(sizing).blanks.get(gear.name)
    if blank is None or blank.is_solid or kind_of(sizing, gear.stage) != "cylindrical":
        return None
    web = Web(
        MM * blank.rim_radius, MM * blank.hub_radius, MM * halves_of(gear) * blank.web_width, dish=MM * blank.dish
    )
    if not blank.hole_radius:
        return web
    return web._replace(holes=blank.holes, circle=MM * blank.hole_circle, hole=MM * blank.hole_radius)


def _bored(sizing: Sizing, gear: GearSizing, shaft: str) -> Hub:
    """Return the bore of a gear."""
    joint = next((joint for joint in sizing.joints if joint.part == gear.name and joint.shaft == shaft), None)
    if joint is not None:
        hub = _joined(joint)
        return replace(hub, boss=_boss(sizing, gear, joint, hub)) if kind_of(sizing, gear.stage) == "bevel" else hub
    if is_internal(sizing, gear):
        return Hub(0.0, note=_held(sizing, gear, shaft))
    carrier = next((carrier for carrier in sizing.carriers if carrier.stage == gear.stage), None)
    if gear.role is Role.PLANET and carrier is not None:
        bore = 2.0 * MM * made_of(sizing).blanks[gear.name].bore_radius
        what = (
            "its bearings" if gear.runs_on else f"what its load asks for on a pin of Ø{MM * carrier.pin_diameter:.4g}"
        )
        return _fitting(sizing, gear, bore, f"Bore: outside of {what}, as weighed.")
    sized = next((body for body in sizing.shafts if body.name == shaft), None)
    diameter = MM * sized.diameter if sized is not None else 0.0
    return _fitting(sizing, gear, diameter, "Bore: diameter of the shaft; their joint is not sized.")


def _held(sizing: Sizing, ring: GearSizing, shaft: str) -> str:
    """Return what holds a ring."""
    if shaft != GROUND:
        return f"The arrangement has its bell to shaft {shaft}; their joint is not sized, and not drawn."
    seat = next((seat for seat in ring_seats(sizing) if seat.ring is ring), None)
    if seat is None:
        return "What holds the ring is not sized, and not drawn."
    length, tip = (f"{MM * size:.4g}" for size in (seat.spline[1] - seat.spline[0], seat.teeth.shaft_tip))
    return (
        f"Outside, about the middle: splines W {seat.name} (as DIN 5480-1, which has no such diameter), {length} long, "
        f"Ø{tip} over tips, drawn to half of their height."
    )


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
