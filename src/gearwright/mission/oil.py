"""The oil of a flight: as its mission says, and where it says nothing as the design does."""

from __future__ import annotations

from gearwright.errors import DesignError, Problem
from gearwright.parts.losses import MeshLaw, oil_viscosity
from gearwright.sizing import Sizing
from gearwright.sizing.losses import Oil, dipping, oil_of_design
from gearwright.spec import Mission
from gearwright.units import CELSIUS

THICKEST = 0.02
"""Kinematic viscosity beyond which no pump moves oil and no law of losses holds [m²/s]; MIL-PRF-23699 lets an oil have
0.013 at -40 °C, below which engines are not started without heating."""


def flown_oil(sizing: Sizing, mission: Mission) -> Oil:
    """Return the oil of a flight, and by whose formulas power is lost in it.

    Args:
        sizing: With the design's oil and losses.
        mission: Whose [oil] comes first.

    Raises:
        DesignError: A gear dips that there is not.
    """
    rules, oil = mission.oil, oil_of_design(sizing)
    return oil._replace(
        temperature=rules.inlet_temperature_k,
        roughness=oil.roughness if rules.roughness is None else rules.roughness,
        of_stages={
            stage: flank if rules.roughness is None else flank._replace(roughness=rules.roughness)
            for stage, flank in oil.of_stages.items()
        },
        dip=dipping(sizing, rules.dip, "oil.dip") if rules.dip else oil.dip,
        friction=MeshLaw(rules.friction) if rules.friction else oil.friction,
        bearings=rules.bearings or oil.bearings,
        windage=rules.windage or oil.windage,
        seals=rules.seals or oil.seals,
    )


def refuse_stiff(oil: Oil) -> None:
    """Refuse oil that is too cold to flow.

    Args:
        oil: As warm as it is.

    Raises:
        DesignError: It is; with its viscosity.
    """
    viscosity = oil_viscosity(oil.temperature, oil.grade)
    if viscosity > THICKEST:
        message = (
            f"at {oil.temperature - CELSIUS:.1f} °C it has {1e6 * viscosity:.3g} mm²/s, and above {1e6 * THICKEST:g}"
            " no pump moves it; heat it before the start (oil.network.start_temperature_k, oil.inlet_temperature_k), or"
            " take a thinner one ([oil] of the design)"
        )
        raise DesignError([Problem("oil", message)])
