"""What of a scene is not as it would be made, in sentences."""

from __future__ import annotations

from collections.abc import Iterator

from gearwright.shape.phases import Phases
from gearwright.shape.teeth import halves_of, kind_of
from gearwright.sizing import Sizing
from gearwright.sizing.places import plates_of
from gearwright.sizing.shafts import holders_of
from gearwright.sizing.summaries import tips_in_fillets

BESIDE = 1e-3
"""How far gears in mesh may stand from each other along their axes before it is said [m]."""


def approximations(sizing: Sizing, phases: Phases) -> tuple[str, ...]:
    """Return what is approximated, assumed or cannot be, as far as it concerns this gearbox.

    Args:
        sizing: As sized.
        phases: How its gears stand.
    """
    told = [one.sentence for one in tips_in_fillets(sizing)]
    return (*_teeth(sizing), *_bodies(sizing), *told, *_meets(sizing, phases))


def _teeth(sizing: Sizing) -> Iterator[str]:
    kinds = {kind_of(sizing, gear.stage) for gear in sizing.gears}
    if "bevel" in kinds:
        yield "bevel teeth are those of Tredgold's virtual gears, spirals cross the cone at a constant angle"
    if "face" in kinds:
        yield "teeth of face gears are racks in every cylinder about the axis; their wheels' bodies are assumed"
    if any(gear.rim for gear in sizing.gears):
        yield "roots of rings are those of a shaper with as many teeth as their smallest mate"
    if any(halves_of(gear) > 1 for gear in sizing.gears):
        yield "double helices have no gap between their halves"
    yield "teeth have no backlash, crowning or tip relief"


def _bodies(sizing: Sizing) -> Iterator[str]:
    for carrier in sizing.carriers:
        if len(plates_of(sizing, carrier.stage)) == 1:
            yield f"{carrier.part} has one plate: beyond its planets another body stands where a second one would"
    if any(gear.rim and gear.shafts[0] in sizing.arrangement.frames for gear in sizing.gears):
        yield "bells that tie turning rings to their shafts are assumed"
    if sizing.bearings:
        yield "bearings are envelopes with the rings and the row of rolling elements assumed"
    if sizing.design.housing.own:
        yield (
            "the housing is the shell of the complete mass, a statistical one, as thick as it is weighed, with its "
            "flanges and their screws, ribs and mounts, bosses around sized bearings and what carries these; openings "
            "for shafts of a first sizing that leave it across the first one are left out"
        )
    if any(holder.lip for holder in holders_of(sizing)):
        yield "radial seals are rings of their sizes, without the lip's form"
    yield "labyrinths and other seals, other screws, machines and what holds rings that stand still are not drawn"


def _meets(sizing: Sizing, phases: Phases) -> Iterator[str]:
    for mesh, off in phases.missed.items():
        yield f"the teeth of {mesh} miss each other's gaps by {abs(off):.2f} of a pitch: the loop does not close"
    for mesh in phases.against:
        yield f"the shafts of {mesh} cannot turn in space as the speeds of the train have them"
    for mesh, off in sizing.arrangement.apart.items():
        if abs(off) > BESIDE:
            yield f"the gears of {mesh} stand {1e3 * abs(off):.3g} mm beside each other along their axes"
