"""Gears as they are made: true teeth, a rim, a web and a hub; rings with their wall, bells of turning ones."""

from __future__ import annotations

from collections.abc import Iterator, Mapping

from gearwright.sizing.casing import ring_seats
from gearwright.sizing.mass.bodies import Seats, gear_volume, shaft_diameters
from gearwright.sizing.mass.planet_bores import PlanetBore
from gearwright.sizing.mass.record import MassItem
from gearwright.sizing.places import bells
from gearwright.sizing.result import GearSizing, Sizing

_SOLID = "A_z b ρ + annuli; A_z = z ∫ 2 ψ r dr"
_SOURCE = "outline of the true tool; AGMA 2001-D04 (backup ratio 1.2); geometry"
_BELL, _SHEAR = "wall; disc, t = 2 T/(π d² τ) at its hub, a cone to t/3", "equilibrium of a disc in shear (Tresca)"
_SPLINE = "DIN 5480-1"
SURE = 0.10
"""One standard deviation of gears over their value, an estimate: bores, webs, holes that lighten [-]."""
SURE_BELL = 0.3
"""One standard deviation of bells over their value, an estimate: holes, joints, stiffness [-]."""


def gear_items(sizing: Sizing, bores: Mapping[str, PlanetBore]) -> Iterator[MassItem]:
    """Yield every gear, and the bell that joins a ring to its shaft where it turns.

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
    density = sizing.design.shaft_material.density
    for bell in bells(sizing):
        if f"{bell.ring.name}.mass" not in sizing.given:  # a ring's given mass is with its bell
            yield MassItem(bell_name(bell.ring), "gears", 1, bell.volume * density, SURE_BELL, _BELL, _SHEAR)
    for seat in ring_seats(sizing):
        if f"{seat.ring.name}.mass" not in sizing.given:
            steel = sizing.design.gear_material(seat.ring.stage).density
            teeth, keeper = seat_names(seat.ring)
            yield MassItem(teeth, "gears", 1, seat.teeth_volume * steel, SURE, "half of the height of splines", _SPLINE)
            yield MassItem(keeper, "gears", 1, seat.keeper_volume * density, SURE_BELL, "section", "estimate")


def bell_name(ring: GearSizing) -> str:
    """Return what the bell of a ring is called.

    Args:
        ring: That turns.
    """
    return f"{ring.name} bell"


def seat_names(ring: GearSizing) -> tuple[str, str]:
    """Return what the splines of a ring are called, and what keeps it in the housing.

    Args:
        ring: That stands in it.
    """
    return f"{ring.name} splines", f"{ring.name} keeper"


def gear_item(sizing: Sizing, gear: GearSizing, seats: Seats) -> MassItem:
    """Return one gear as it is made.

    Args:
        sizing: As sized.
        gear: Of it.
        seats: What gears sit on.
    """
    density = sizing.design.gear_material(gear.stage).density
    formula = "(A_z + π (r_o² − r_f²)) b ρ" if gear.rim else _SOLID
    return MassItem(gear.name, "gears", gear.bodies, gear_volume(sizing, gear, seats) * density, SURE, formula, _SOURCE)
