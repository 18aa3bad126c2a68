"""A design as one of its cases holds it: what brakes hold belongs to the ground, and open clutches join nothing."""

from __future__ import annotations

from collections.abc import Set
from typing import TypeVar

from gearwright.identity import SIDES
from gearwright.spec import GROUND, Clutch, Design, Epicyclic, case_named
from gearwright.spec.design import MACHINES
from gearwright.spec.record import Record

Part = TypeVar("Part", bound=Record)


def as_held(design: Design, case: str) -> Design:
    """Return a design in which the brakes of a case ground members of planetary sets, without its open clutches.

    Args:
        design: As read.
        case: Name of one of its cases.
    """
    if not design.clutches:
        return design
    clutches = _holding(design, case)
    braked = {end for clutch in clutches.values() for end in (clutch.driving, clutch.driven) if _is_brake(clutch)}
    held = braked & _members(design)
    turning = {
        table: {name: machine for name, machine in getattr(design, table).items() if machine.shaft not in held}
        for table in MACHINES
    }
    grounded = {
        "shafts": [shaft for shaft in design.shafts if shaft not in held],
        "clutches": {name: clutch for name, clutch in clutches.items() if not _is_brake(clutch)},
        "planetaries": {name: _grounded(stage, held) for name, stage in design.planetaries.items()},
        "epicyclics": {name: _grounded_set(stage, held) for name, stage in design.epicyclics.items()},
    }
    return design.model_copy(update={**turning, **grounded})


def _holding(design: Design, case: str) -> dict[str, Clutch]:
    engaged = case_named(design, case).engaged
    return {
        name: clutch
        for name, clutch in design.clutches.items()
        if clutch.kind == "overrunning" or (clutch.kind == "engaged" if engaged is None else name in engaged)
    }


def _is_brake(clutch: Clutch) -> bool:
    return GROUND in (clutch.driving, clutch.driven)


def _members(design: Design) -> set[str]:
    """Return the shafts of planetary sets that carry no gear of a pair: held, they leave the speeds of others known."""
    members = {shaft for stage in design.planetaries.values() for shaft in (stage.sun, stage.ring, stage.carrier)}
    members |= {shaft for stage in design.epicyclics.values() for shaft in stage.members}
    return members - {shaft for pair in design.pairs.values() for side in SIDES for shaft in pair.named(side)}


def _grounded(part: Part, held: Set[str]) -> Part:
    """Return a record whose shafts that are held are the ground."""
    return part.model_copy(update={key: GROUND for key, value in part if isinstance(value, str) and value in held})


def _grounded_set(epicyclic: Epicyclic, held: Set[str]) -> Epicyclic:
    update = {
        "suns": {name: _grounded(gear, held) for name, gear in epicyclic.suns.items()},
        "rings": {name: _grounded(gear, held) for name, gear in epicyclic.rings.items()},
    }
    return _grounded(epicyclic, held).model_copy(update=update)
