"""Gears as they are made: true teeth, a rim, a web and a hub; rings with their wall, and what ties a turning one."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping

from gearwright.identity import Role
from gearwright.parts.gears import Blank, CylindricalGear, blank_volume, tooth_area
from gearwright.sizing.mass.duties import seat_duties
from gearwright.sizing.mass.planet_bores import PlanetBore, planet_bores
from gearwright.sizing.mass.record import MassItem
from gearwright.sizing.result import GearSizing, Sizing
from gearwright.sizing.tooth_shape import cylindrical_gear
from gearwright.spec.design import GearRules

BACKUP = 1.2
"""Rim below the roots over the tooth height where the design says nothing [-]: the least without loss of strength,
AGMA 2001-D04, rim thickness factor."""
HUBS = {"": 1.25, "integral": 1.0, "spline": 1.3, "key": 1.8, "press-fit": 1.8}
"""Joint -> outside of the hub over the shaft's diameter [-]; estimates within what machine-element tables give for
steel. Nothing said: flanged or splined."""
PLANET_HUB = 1.1
"""Seat of a bearing in a planet: outside over the bearing's own outside [-], an estimate."""
_SOLID = "A_z b ρ + annuli; A_z = z ∫ 2 ψ r dr"
_SOURCE = "ISO 21771:2007 (ψ); AGMA 2001-D04 (backup ratio 1.2); geometry"
SURE = 0.10
"""One standard deviation of gears over their value, an estimate: bores, webs, holes that lighten [-]."""


def gear_items(sizing: Sizing, bores: Mapping[str, PlanetBore]) -> Iterator[MassItem]:
    """Yield every gear, and the disc that ties a ring to its shaft where it turns.

    Args:
        sizing: As sized.
        bores: Planet -> what it turns on.
    """
    shafts = {shaft.name: shaft.diameter for shaft in sizing.shafts}
    for gear in sizing.gears:
        given = sizing.given.get(f"{gear.name}.mass")
        if given is not None:
            yield MassItem(gear.name, "gears", gear.bodies, given.value, 0.02, "given", given.origin or "the design")
            continue
        yield gear_item(sizing, gear, bores, shafts)
        if gear.rim and gear.shafts[0] in shafts:
            yield _tie(sizing, gear, shafts[gear.shafts[0]])


def gear_item(
    sizing: Sizing, gear: GearSizing, bores: Mapping[str, PlanetBore], shafts: Mapping[str, float]
) -> MassItem:
    """Return one gear as it is made.

    Args:
        sizing: As sized.
        gear: Of it.
        bores: Planet -> what it turns on.
        shafts: Shaft -> diameter [m].
    """
    density = sizing.design.material(sizing.design.rules(gear.stage).material).density
    if gear.rim:
        volume, formula = _ring_volume(sizing, gear), "(A_z + π (r_o² − r_f²)) b ρ"
    else:
        volume, formula = _disc_volume(sizing, gear, bores, shafts), _SOLID
    return MassItem(gear.name, "gears", gear.bodies, volume * density, SURE, formula, _SOURCE)


def _ring_volume(sizing: Sizing, gear: GearSizing) -> float:
    """Return the volume of a ring: its teeth, and its wall from the roots outwards [m³]."""
    teeth = _internal(sizing, gear)
    outside = gear.pitch_diameter / 2.0 + gear.rim
    wall = math.pi * (max(outside, teeth.root_radius) ** 2 - teeth.root_radius**2)
    return (tooth_area(teeth) + wall) * gear.face_width


def _internal(sizing: Sizing, gear: GearSizing) -> CylindricalGear:
    outer = cylindrical_gear(sizing.design, gear)
    return CylindricalGear(
        -gear.teeth, gear.module, gear.face_width, gear.helix_angle,
        profile_shift=gear.profile_shift, rack=outer.rack, tip_alteration=gear.tip_alteration,
    )  # fmt: skip


def _disc_volume(
    sizing: Sizing, gear: GearSizing, bores: Mapping[str, PlanetBore], shafts: Mapping[str, float]
) -> float:
    """Return the volume of an external gear, bevel gears as cylinders of their mean cones [m³]."""
    teeth, rules = cylindrical_gear(sizing.design, gear), sizing.design.rules(gear.stage)
    blank = gear_blank(gear, rules, teeth.root_radius, seat=_seat(sizing, gear, bores, shafts))
    crown = tooth_area(teeth) * gear.face_width
    if gear.role is Role.WHEEL and rules.web_ratio < 1.0:
        whole = blank._replace(rim_radius=0.0)
        return crown + rules.web_ratio * blank_volume(whole)
    return crown + blank_volume(blank)


def _seat(
    sizing: Sizing, gear: GearSizing, bores: Mapping[str, PlanetBore], shafts: Mapping[str, float]
) -> tuple[float, float]:
    """Return bore and outside of a gear's hub [m]."""
    if gear.name in bores:
        outside = bores[gear.name].bearing_diameter
        return outside, PLANET_HUB * outside
    bore = max((shafts.get(shaft, 0.0) for shaft in gear.shafts), default=0.0)
    joint = sizing.design.joints.get(gear.name)
    return bore, HUBS["" if joint is None else joint.kind] * bore


def gear_blank(gear: GearSizing, rules: GearRules, root: float, *, seat: tuple[float, float]) -> Blank:
    """Return the body under the teeth of an external gear by the rules of its stage.

    Args:
        gear: As sized.
        rules: Of its stage.
        root: Radius of the root circle [m].
        seat: Diameters of bore and hub [m].
    """
    height = 2.25 * gear.module
    rim = root - (BACKUP if rules.rim_ratio is None else rules.rim_ratio) * height
    bore, hub = (min(diameter / 2.0, root) for diameter in seat)
    return Blank(root, max(rim, 0.0), hub, bore, gear.face_width, rules.web_thickness_ratio * gear.face_width)


def gear_blanks(sizing: Sizing) -> dict[str, Blank]:
    """Return external gear -> its body as it is weighed; a wheel that weighs a share of its disc has a web for it.

    Args:
        sizing: As sized.
    """
    bores = planet_bores(sizing, tuple(seat_duties(sizing)))
    shafts = {shaft.name: shaft.diameter for shaft in sizing.shafts}
    blanks = {}
    for gear in sizing.gears:
        if gear.rim:
            continue
        root, rules = cylindrical_gear(sizing.design, gear).root_radius, sizing.design.rules(gear.stage)
        blank = gear_blank(gear, rules, root, seat=_seat(sizing, gear, bores, shafts))
        lightened = gear.role is Role.WHEEL and rules.web_ratio < 1.0
        blanks[gear.name] = _lightened(blank, rules.web_ratio) if lightened else blank
    return blanks


def _lightened(blank: Blank, share: float) -> Blank:
    """Return a body with rim, hub and a web between them that weighs a share of the solid one."""
    target = share * blank_volume(blank._replace(rim_radius=0.0))
    if blank.is_solid:
        return blank
    web = blank.web_width
    bare = blank_volume(blank._replace(web_width=0.0))
    ring = math.pi * (blank.rim_radius**2 - blank.hub_radius**2)
    if target > bare + 0.5 * web * ring:
        return blank._replace(web_width=min((target - bare) / ring, blank.width))
    # A rim by the rules weighs too much: a thinner one under half of the web.
    web = 0.5 * web
    hub = math.pi * (blank.hub_radius**2 - blank.bore_radius**2) * blank.width
    squared = math.pi * (blank.root_radius**2 * blank.width - blank.hub_radius**2 * web) + hub - target
    rim = math.sqrt(max(squared / (math.pi * (blank.width - web)), blank.hub_radius**2))
    return blank._replace(rim_radius=min(rim, blank.root_radius), web_width=web)


def _tie(sizing: Sizing, ring: GearSizing, hub: float) -> MassItem:
    """Return the disc between a turning ring and its shaft, as thick as its torque asks at the hub."""
    material, shafting = sizing.design.shaft_material, sizing.design.shafting
    torque = _ring_torque(sizing, ring)
    shear = (material.yield_strength or 0.0) / shafting.safety / 2.0
    thickness = 2.0 * torque / (math.pi * hub**2 * shear) if shear else 0.0
    outside = ring.pitch_diameter / 2.0 + ring.rim
    # The shear falls as 1/r²; the disc is tapered so, down to a third of its thickness at the hub.
    radius = min(math.sqrt(3.0) * hub / 2.0, outside)
    inner = math.pi * hub**2 / 2.0 * math.log(2.0 * radius / hub) * thickness
    outer = math.pi * (outside**2 - radius**2) * thickness / 3.0
    return MassItem(
        f"{ring.name} disc", "gears", 1, material.density * (inner + outer), 0.3,
        "t = 2 T/(π d² τ) at the hub, falling as 1/r² to a third", "equilibrium of a disc in shear (Tresca)",
    )  # fmt: skip


def _ring_torque(sizing: Sizing, ring: GearSizing) -> float:
    """Return the largest torque that the meshes of a ring put on it, of all cases [N m]."""
    rows = [(mesh.name, mesh.gears.index(ring.name)) for mesh in sizing.train.meshes if ring.name in mesh.gears]
    return max(abs(sum(flow.meshes[row].torques[side] for row, side in rows)) for flow in sizing.flows.values())
