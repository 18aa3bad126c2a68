"""The verb: what a sized gearbox weighs with everything in it."""

from __future__ import annotations

from gearwright.sizing.casing import shell_of
from gearwright.sizing.mass.bearings import bearing_items
from gearwright.sizing.mass.calibration import CALIBRATED, Calibration
from gearwright.sizing.mass.details import detail_items
from gearwright.sizing.mass.duties import seat_duties
from gearwright.sizing.mass.gears import gear_items
from gearwright.sizing.mass.housing import housing_items
from gearwright.sizing.mass.oil_system import oil_items
from gearwright.sizing.mass.planet_bores import planet_bores
from gearwright.sizing.mass.record import CompleteMass, MassItem, ordered
from gearwright.sizing.mass.rotating import carrier_items, shaft_items
from gearwright.sizing.result import Sizing
from gearwright.verbs import verb


@verb
def complete_mass(sizing: Sizing) -> CompleteMass:
    """Return the complete mass of a gearbox: gears with teeth and webs, shafts, carriers, bearings, housing, oil.

    Machines are not in it. What the design gives (masses of parts, of the housing, of the whole) stands as given.

    Args:
        sizing: As sized.

    >>> import gearwright as gw
    >>> mass = gw.complete_mass(gw.size(gw.read("off-set")))
    >>> ", ".join(group.group for group in mass.groups)
    'gears, shafts, bearings, housing, lubrication, details'
    """
    return summed(sizing, CALIBRATED)


def summed(sizing: Sizing, fitted: Calibration) -> CompleteMass:
    """Return the complete mass with given constants, for their fit.

    Args:
        sizing: As sized.
        fitted: What published gearboxes set.
    """
    whole = sizing.given.get("gearbox.mass")
    if whole is not None:
        item = MassItem("gearbox", "details", 1, whole.value, 0.02, "given", whole.origin or "the design")
        return CompleteMass(sizing.design.name, (item,), 1.0)
    duties = tuple(seat_duties(sizing))
    bores = planet_bores(sizing, duties)
    bearings = tuple(bearing_items(sizing, duties, bores))
    parts = [*gear_items(sizing, bores), *shaft_items(sizing), *carrier_items(sizing), *bearings]
    shell = shell_of(sizing)
    parts += housing_items(sizing, shell, bearings, fitted)
    parts += oil_items(sizing, shell.volume)
    parts += detail_items(sizing, parts, fitted)
    return CompleteMass(sizing.design.name, ordered(parts), fitted.scatter)
