"""The oil and the formulas by which a gearbox loses power."""

from __future__ import annotations

from collections.abc import Mapping
from types import MappingProxyType
from typing import NamedTuple

from gearwright.errors import Problem, near, refuse
from gearwright.parts.losses import OIL_DENSITY, TURBINE_OIL, MeshLaw, OilState, oil_viscosity
from gearwright.sizing.result import Sizing
from gearwright.units import CELSIUS

NOTHING: Mapping[str, float] = MappingProxyType({})
"""No gear dips."""


class Oil(NamedTuple):
    """What losses need of oil, flanks and seals, and by whose formulas they are found."""

    temperature: float
    """[K]"""
    roughness: float
    """R_a of the flanks [m]."""
    dip: Mapping[str, float] = NOTHING
    """Gear -> part of it that dips into an oil bath [-]; one left out runs dry."""
    friction: MeshLaw = MeshLaw.SCHLENK
    """Whose friction of the teeth."""
    bearings: str = "constant"
    """Whose friction of the bearings."""
    windage: str = "anderson-loewenthal"
    """Whose windage of the gears."""
    seals: str = "none"
    """Whose friction of the seals."""
    enclosure: float = 1.0
    """λ of Dawson's windage [-]."""
    lubricant_factor: float = 1.0
    """X_L [-]."""
    grade: tuple[float, float] = TURBINE_OIL
    """Kinematic viscosity at 40 °C and at 100 °C [m²/s]."""
    density: float = OIL_DENSITY
    """[kg/m³]"""

    @property
    def viscosity(self) -> float:
        """Kinematic, at its temperature [m²/s]."""
        return oil_viscosity(self.temperature, self.grade)

    @property
    def on_teeth(self) -> OilState:
        """The oil between the teeth."""
        return OilState(self.viscosity * self.density, self.density, self.roughness, self.lubricant_factor)


def oil_of_design(sizing: Sizing) -> Oil:
    """Return the oil and the formulas that a design asks for.

    Args:
        sizing: With its design.

    Raises:
        DesignError: A gear dips that there is not.
    """
    oil, rules = sizing.design.oil, sizing.design.losses
    return Oil(
        temperature=oil.temperature + CELSIUS,
        roughness=rules.roughness,
        dip=dipping(sizing, rules.dip, "losses.dip"),
        friction=MeshLaw(rules.friction),
        bearings=rules.bearings,
        windage=rules.windage,
        seals=rules.seals,
        enclosure=rules.enclosure,
        lubricant_factor=rules.lubricant_factor,
        grade=(oil.viscosity_40 * 1e-6, oil.viscosity_100 * 1e-6),
        density=oil.density,
    )


def dipping(sizing: Sizing, dip: Mapping[str, float], path: str) -> Mapping[str, float]:
    """Return how far gears dip, refused where there is no such gear or it cannot dip so far.

    Args:
        sizing: With its gears.
        dip: Gear -> part of it [-].
        path: Where that is written.

    Raises:
        DesignError: With every gear that there is not, and the nearest.
    """
    gears = [gear.name for gear in sizing.gears]
    messages = {name: f"there is no gear {name!r}; {near(name, gears)}" for name in dip if name not in gears}
    messages |= {
        name: f"{part:g} of a gear cannot dip into oil; give 0 to 1"
        for name, part in dip.items()
        if not 0.0 <= part <= 1.0
    }
    refuse(Problem(f"{path}.{name}", message) for name, message in messages.items())
    return dip
