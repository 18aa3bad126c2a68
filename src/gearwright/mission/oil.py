"""The oil of a flight: as its mission says, and where it says nothing as the design does."""

from __future__ import annotations

from gearwright.parts.losses import MeshLaw
from gearwright.sizing import Sizing
from gearwright.sizing.losses import Oil, dipping, oil_of_design
from gearwright.spec import Mission


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
