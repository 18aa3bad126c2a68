"""The oil and the formulas by which a gearbox loses power."""

from __future__ import annotations

from collections.abc import Mapping
from types import MappingProxyType
from typing import NamedTuple

from gearwright.errors import Problem, near, refuse
from gearwright.parts.iso6336 import RZ_OVER_RA
from gearwright.parts.losses import OIL_DENSITY, TURBINE_OIL, MeshLaw, OilState, oil_viscosity
from gearwright.parts.micropitting import BASES
from gearwright.sizing.result import Sizing
from gearwright.spec.design import RATINGS
from gearwright.units import CELSIUS

NOTHING: Mapping[str, float] = MappingProxyType({})
"""No gear dips."""


class Flank(NamedTuple):
    """What losses need of the flanks of one stage."""

    roughness: float
    """R_a [m]."""
    lubricant_factor: float
    """X_L [-]."""


UNTOLD: Mapping[str, Flank] = MappingProxyType({})
"""No stage says anything of its flanks."""


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
    of_stages: Mapping[str, Flank] = UNTOLD
    """Stage -> its flanks, where its rating says how rough they are or what oil they run in."""

    @property
    def viscosity(self) -> float:
        """Kinematic, at its temperature [m²/s]."""
        return oil_viscosity(self.temperature, self.grade)

    def on_teeth(self, stage: str = "") -> OilState:
        """Return the oil between the teeth of a stage.

        Args:
            stage: Its name; one without flanks of its own has those of all.
        """
        flank = self.of_stages.get(stage, Flank(self.roughness, self.lubricant_factor))
        return OilState(self.viscosity * self.density, self.density, *flank)


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
        of_stages={name: _flank(sizing, name) for name in sizing.design.stages},
    )


def _flank(sizing: Sizing, stage: str) -> Flank:
    """Return roughness and X_L of a stage: of [losses], and where that leaves them out as its rating has them."""
    losses, rules = sizing.design.losses, sizing.design.rules(stage)
    roughness, factor = losses.roughness, losses.lubricant_factor
    table = RATINGS[sizing.design.rating(stage)].table
    if "roughness" not in losses.model_fields_set:
        if table == "iso6336" and "flank_roughness" in rules.iso6336.model_fields_set:
            roughness = rules.iso6336.flank_roughness / RZ_OVER_RA
        elif table == "agma2001" and "flank_roughness" in rules.agma2001.model_fields_set:
            roughness = rules.agma2001.flank_roughness
    if "lubricant_factor" not in losses.model_fields_set and table == "iso6336":
        factor = BASES[rules.iso6336.oil_type].lubricant
    return Flank(roughness, factor)


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
