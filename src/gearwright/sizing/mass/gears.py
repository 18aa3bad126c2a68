"""Gears as they are made: true teeth, a rim, a web and a hub; rings with their wall, and what ties a turning one."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping

from gearwright.sizing.mass.bodies import Seats, gear_volume, shaft_diameters
from gearwright.sizing.mass.planet_bores import PlanetBore
from gearwright.sizing.mass.record import MassItem
from gearwright.sizing.result import GearSizing, Sizing

_SOLID = "A_z b ρ + annuli; A_z = z ∫ 2 ψ r dr"
_SOURCE = "outline of the true tool; AGMA 2001-D04 (backup ratio 1.2); geometry"
SURE = 0.10
"""One standard deviation of gears over their value, an estimate: bores, webs, holes that lighten [-]."""


def gear_items(sizing: Sizing, bores: Mapping[str, PlanetBore]) -> Iterator[MassItem]:
    """Yield every gear, and the disc that ties a ring to its shaft where it turns.

    Args:
        sizing: As sized.
        bores: Planet -> what it turns on.
    """
    seats = Seats(bores, shaft_diameters(sizing))
    for gear in sizing.gears:
        given = sizing.given.get(f"{gear.name}.mass")
        if given is not None:
            yield MassItem(gear.name, "gears", gear.bodies, given.value, 0.02, "given", given.origin or "the design")
            continue
        yield gear_item(sizing, gear, seats)
        if gear.rim and gear.shafts[0] in seats.shafts:
            yield _tie(sizing, gear, seats.shafts[gear.shafts[0]])


def gear_item(sizing: Sizing, gear: GearSizing, seats: Seats) -> MassItem:
    """Return one gear as it is made.

    Args:
        sizing: As sized.
        gear: Of it.
        seats: What gears sit on.
    """
    density = sizing.design.material(sizing.design.rules(gear.stage).material).density
    formula = "(A_z + π (r_o² − r_f²)) b ρ" if gear.rim else _SOLID
    return MassItem(gear.name, "gears", gear.bodies, gear_volume(sizing, gear, seats) * density, SURE, formula, _SOURCE)


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
