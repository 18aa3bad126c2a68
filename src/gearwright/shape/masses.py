"""What the solids of a scene weigh, beside what sizing has for the same parts."""

from __future__ import annotations

from collections import defaultdict
from dataclasses import dataclass

from gearwright.catalogue import STEEL_DENSITY, housing_materials
from gearwright.identity import HOUSING, Kind, PartId
from gearwright.shape.casings.flanges import FLANGES
from gearwright.shape.casings.mounts import MOUNT
from gearwright.shape.casings.ribs import RIB
from gearwright.shape.casings.screws import SCREW
from gearwright.shape.housing import CHAMBER
from gearwright.shape.record import Node, Scene, triangles_of
from gearwright.sizing import Sizing
from gearwright.sizing.mass import complete_mass
from gearwright.units import Mass

PARTS = {"housing flanges": FLANGES, "housing bolts": SCREW, "housing ribs": RIB, "housing mounts": MOUNT}
"""What of a housing is drawn as it is weighed -> word in the names of its bodies."""
NEAR = 5e-3
"""By how much what is drawn may differ from what is weighed [-]."""
CORNERS = 720
"""Of circles whose volumes are taken: their chords lose 1.3e-5 [-]."""


@dataclass(frozen=True)
class SolidMass:
    """One kind of equal bodies, or all pieces of a carrier."""

    part: PartId
    bodies: int
    """Equal ones in the scene [-]."""
    solid: Mass
    """Of one as drawn: the volume of its solid, circles round, times the density of its material [kg]."""
    sized: Mass | None
    """Of one in the sizing's mass, by which designs are chosen; None of a housing, which is not in it [kg]."""
    weighed: Mass | None
    """Of one in the complete mass; None where that counts it within something else [kg]."""


def solid_masses(sizing: Sizing, scene: Scene) -> tuple[SolidMass, ...]:
    """Return what gears, shafts, carriers and a housing's shell weigh as drawn, as sized and in the complete mass.

    Args:
        sizing: As sized.
        scene: Of it.
    """
    weighed = {(item.group, item.part): item.each for item in complete_mass(sizing).parts}
    exact = {name: triangles_of(solid, CORNERS).volume for name, solid in scene.solids.items()}
    found = []
    for gear in sizing.gears:
        nodes = [node for node in scene.nodes if node.part.kind is Kind.GEAR and _of(node, gear.stage, gear.part)]
        density = sizing.design.gear_material(gear.stage).density
        volume = sum(exact[node.surface] for node in nodes) / gear.bodies
        found.append(SolidMass(gear.part, gear.bodies, volume * density, gear.mass, weighed.get(("gears", gear.name))))
    density = sizing.design.shaft_material.density
    volumes: defaultdict[str, float] = defaultdict(float)
    for node in scene.nodes:
        if node.part.kind in (Kind.SHAFT, Kind.CARRIER):
            volumes[str(node.part)] += exact[node.surface]
    for shaft in sizing.shafts:
        part = PartId(Kind.SHAFT, shaft.name)
        solid = volumes[shaft.name] * density
        found.append(SolidMass(part, 1, solid, shaft.mass, weighed.get(("shafts", shaft.name))))
    for carrier in sizing.carriers:
        solid = volumes[str(carrier.part)] * density
        found.append(SolidMass(carrier.part, 1, solid, carrier.mass, weighed.get(("carriers", str(carrier.part)))))
    chambers = [node for node in scene.nodes if node.part == HOUSING and CHAMBER in node.name]
    if chambers:
        density = housing_materials()[sizing.design.housing.material].density
        solid = sum(exact[node.surface] for node in chambers) * density
        found.append(SolidMass(HOUSING, 1, solid, None, weighed.get(("housing", "housing shell"))))
    return tuple(found)


def casing_masses(sizing: Sizing, scene: Scene) -> dict[str, tuple[float, float]]:
    """Return what is drawn of a housing but its shell -> what its solids weigh, and what the complete mass has [kg].

    Args:
        sizing: As sized.
        scene: Of it.
    """
    weighed = {item.part: item.count * item.each for item in complete_mass(sizing).parts if item.group == "housing"}
    material = housing_materials()[sizing.design.housing.material]
    exact = {name: triangles_of(scene.solids[name], CORNERS).volume
             for name in {node.surface for node in scene.nodes if node.part == HOUSING}}  # fmt: skip
    volumes: dict[str, float] = dict.fromkeys(set(PARTS) & weighed.keys(), 0.0)
    for node in scene.nodes:
        part = next((part for part, word in PARTS.items() if f"housing, {word} " in node.name), "")
        if part in weighed:
            volumes[part] += exact[node.surface]
    density = {part: STEEL_DENSITY if word == SCREW else material.density for part, word in PARTS.items()}
    return {part: (volume * density[part], weighed[part]) for part, volume in volumes.items()}


def short_of(sizing: Sizing, scene: Scene) -> dict[str, tuple[float, float]]:
    """Return what of a housing is drawn otherwise than it is weighed, as `casing_masses`: walls leave no more room.

    Args:
        sizing: As sized.
        scene: Of it.
    """
    drawn = casing_masses(sizing, scene)
    return {part: masses for part, masses in drawn.items() if abs(masses[0] - masses[1]) > NEAR * masses[1]}


def _of(node: Node, stage: str, part: PartId) -> bool:
    same = (node.part.name, node.part.role, node.part.own) == (stage, part.role, part.own)
    return same and node.look not in ("bell", "seat")
