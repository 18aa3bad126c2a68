"""Radial seals as they are placed: which exit has which, and whether lip, oil and running surface suit each other."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import takewhile
from typing import NamedTuple

from gearwright.catalogue.standard_parts.radial_seals import FAST, FAST_HARDNESS, HARDNESS, SHAFT
from gearwright.checks import Check, not_assessed
from gearwright.identity import Kind, PartId
from gearwright.parts.hardness import vickers_of_rockwell
from gearwright.parts.iso6336 import GearSteel, Treatment
from gearwright.sizing.rating import method_for, rating_of
from gearwright.sizing.result import Sizing
from gearwright.sizing.sealing import LIP_WARMER, NEAR, Exit, exits_of, leaving_of
from gearwright.sizing.shafts.holding.covers import SEAL
from gearwright.sizing.shafts.holding.held import holders_of
from gearwright.sizing.shafts.holding.holders import Holder

SPEEDS = "SKF, pages of products HMS5"
SURFACE = "DIN 3760, as makers' sheets have it"


class Sealed(NamedTuple):
    """An exit with the seal that runs there."""

    leaves: Exit
    seal: Holder


def sealed_exits(sizing: Sizing) -> tuple[Sealed, ...]:
    """Return the exits in whose covers seals sit.

    Args:
        sizing: As sized.
    """
    seals = {(holder.shaft, -holder.lip): holder for holder in holders_of(sizing) if holder.kind == SEAL}
    return tuple(
        Sealed(leaves, seals[leaves.shaft, leaves.way])
        for leaves in exits_of(sizing)
        if (leaves.shaft, leaves.way) in seals
    )


def unsealed_exits(sizing: Sizing) -> tuple[Exit, ...]:
    """Return the exits without a seal, each with what it lacks.

    Args:
        sizing: As sized.
    """
    sealed = {one.leaves for one in sealed_exits(sizing)}
    return tuple(leaves for leaves in exits_of(sizing) if leaves not in sealed)


def seal_checks(sizing: Sizing) -> Iterator[Check]:
    """Yield of every seal whether its lip bears speed and oil, and whether the shaft is long and hard enough under it.

    Args:
        sizing: As sized.
    """
    for leaves, seal in sealed_exits(sizing):
        part, lip = PartId(Kind.MACHINE, leaves.machine), leaves.elastomer
        assert lip is not None and leaves.limit is not None
        yield Check(
            part, "seal speed", SPEEDS, leaves.velocity, leaves.limit, "velocity", at_most=True, exponent=None,
            symbol="v", place=seal.designation,
        )  # fmt: skip
        yield Check(
            part, "seal temperature", SPEEDS, sizing.design.oil.temperature + LIP_WARMER, lip.hottest, "temperature",
            at_most=True, exponent=None, place=f"lip, {LIP_WARMER:g} K warmer than the oil",
        )  # fmt: skip
        free, needed = _surface(sizing, leaves, seal)
        yield Check(
            part, "seal seat", "as drawn", free, needed, "length", exponent=None,
            place=f"shaft {1e3 * leaves.diameter:g} {SHAFT}, from the bearing on",
            why="" if free >= needed - NEAR else "move what sits outside further out, or the bearing inwards",
        )  # fmt: skip
        yield _hardness(sizing, part, leaves)


def _surface(sizing: Sizing, leaves: Exit, seal: Holder) -> tuple[float, float]:
    """Return how far the shaft is free and of one diameter from its bearing on, and how far the seal reaches [m]."""
    face = next(end.face for end in leaving_of(sizing) if (end.shaft, end.way) == (leaves.shaft, leaves.way))
    shaft = next(shaft for shaft in sizing.built_shafts if shaft.name == leaves.shaft)
    outwards = shaft.steps if leaves.way > 0 else shaft.steps[::-1]
    beyond = [step for step in outwards if leaves.way * ((step.start + step.end) / 2.0 - face) > 0.0]
    level = takewhile(lambda step: abs(step.diameter - leaves.diameter) < NEAR and not step.seat, beyond)
    free = sum(step.end - step.start for step in level)
    return free, max(leaves.way * (place - face) for place in (seal.start, seal.end))


def case_hardened(sizing: Sizing, shaft: str) -> dict[str, GearSteel]:
    """Return gears of one piece with a shaft that are case-hardened -> their steel; what runs under its seals is, too.

    Args:
        sizing: As sized.
        shaft: Its name.
    """
    found = dict[str, GearSteel]()
    stages = {gear.name: gear.stage for gear in sizing.gears}
    for joint in sizing.joints:
        if joint.kind == "integral" and joint.shaft == shaft and joint.part in stages:
            rating = rating_of(sizing.design, stages[joint.part], sizing.teeth)
            steel = method_for(rating).making(rating).iso_steel
            if steel is not None and steel.treatment is Treatment.CASE_HARDENED:
                found[joint.part] = steel
    return found


def _hardness(sizing: Sizing, part: PartId, leaves: Exit) -> Check:
    """Return whether the surface under a lip is hard enough, in HV."""
    mode, asked = "seal hardness", FAST_HARDNESS if leaves.velocity > FAST else HARDNESS
    hardness, needed = sizing.design.shaft_material.hardness, vickers_of_rockwell(asked)
    if hardness is None:
        why = f"the material of the shafts states none, and {asked:g} HRC are asked: harden the seat or fit a sleeve"
        return not_assessed(part, mode, SURFACE, why)
    if not case_hardened(sizing, leaves.shaft):
        why = (
            f"{asked:g} HRC are asked under the lip, and no teeth of one piece with this shaft are case-hardened, "
            "with which its seat would be: harden the seat or fit a sleeve"
        )
        return not_assessed(part, mode, SURFACE, why)
    return Check(
        part, mode, SURFACE, hardness, needed, "number", exponent=None, symbol="HV",
        place=f"{asked:g} HRC or more under the lip, 0.3 mm deep",
        why="" if hardness >= needed else "harden the seat by induction, or fit a hardened sleeve",
    )  # fmt: skip
