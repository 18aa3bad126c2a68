"""What sizing yields of the bearings between planets and their pins: kind, size, what of it turns, what it weighs."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Annotated

from gearwright.catalogue import Bearing
from gearwright.parts.bearings import Journal
from gearwright.units import Length, Mass, Origin, Quantity, Ratio

_CYLINDERS = Origin("cylinders of rings, rolling elements and cage", "geometry")


@dataclass(frozen=True)
class PlanetBearingSizing:
    """What one planet turns on."""

    kind: str
    """cylindrical, needle, integral, ceramic or plain, as the design asks."""
    bearing: Bearing | None
    """One of the rolling bearings; None where a film bears."""
    side_by_side: int
    """Equal ones on a pin [-]."""
    pin_diameter: Annotated[float, Quantity("length"), Origin("smallest that serves", "choice of planet bearings")]
    """d: bore of the bearing, or of the pin under rollers or film [m]."""
    outer_diameter: Length
    """Bore of the planet [m]."""
    width: Length
    """Of all on a pin [m]."""
    clearance: Ratio
    """ψ of a plain bearing [-]; 0 of others."""
    turning_mass: Annotated[float, Quantity("mass"), _CYLINDERS]
    """What a carrier swings with the planet: outer rings, rolling elements, cages [kg]."""
    turning_inertia: Annotated[float, Quantity("inertia"), _CYLINDERS]
    """Of that about the pin, at the planet's speed: rolling elements turn at (1 + γ)/2 of it [kg m²]."""
    standing_mass: Annotated[float, Quantity("mass"), _CYLINDERS]
    """Inner rings on the pin [kg]."""

    @property
    def mass(self) -> Mass:
        """Of all bearings of one planet [kg]."""
        return self.turning_mass + self.standing_mass

    @property
    def journal(self) -> Journal | None:
        """The plain bearing that it is; None where it rolls."""
        return Journal(self.pin_diameter, self.width, self.clearance) if self.bearing is None else None

    @property
    def designation(self) -> str:
        """Name in the catalogue, or kind and size in mm."""
        if self.bearing is not None:
            return self.bearing.designation
        return f"plain {1e3 * self.pin_diameter:.4g}x{1e3 * self.width:.4g}"
