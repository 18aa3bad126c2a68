"""What can be wrong with gears beyond their teeth: axes that do not meet squarely, shared gears, rings."""

from __future__ import annotations

import math
from collections.abc import Iterator

from gearwright.errors import DesignError, Problem
from gearwright.identity import SIDES, Role, gear_part
from gearwright.parts.agma2001 import AgmaSteel, agma_strength
from gearwright.parts.agma2003 import BevelSteel, bevel_strength
from gearwright.spec.design import (
    RATINGS,
    Agma2001Rules,
    Agma2003Rules,
    AgmaWheelSteel,
    Design,
    Epicyclic,
    GearRules,
    Pair,
    Planetary,
    method_of,
    stage_shifts,
    uncovered,
)

SQUARE = 0.5 * math.pi
"""Axis angle of face and bevel gears that is understood [rad]."""
ROUNDING = 1e-6
"""How near to it a written angle must be [rad]."""
AGREEMENT = 0.08
"""How far hardnesses of one steel may lie apart, after conversion from another scale [-]."""
_THROUGH = "through-hardened"
_HARDENED = {
    "carburised": "case-hardened", "nitrided-4140": "nitrided", "nitralloy-135m": "nitrided", _THROUGH: _THROUGH,
}  # fmt: skip
"""Steel of AGMA's tables -> how the classes of ISO 6336-5 that are hardened so begin."""
_HARDENINGS = ("case-hardened", "nitrided", _THROUGH, "induction-hardened", "nitrocarburised")
"""How the classes of ISO 6336-5 begin."""


def gear_problems(design: Design) -> Iterator[Problem]:
    """Yield what is wrong with crossing axes, with gears that pairs share and with pinions in rings.

    Args:
        design: As typed.
    """
    for name, pair in design.pairs.items():
        yield from _crossing(name, pair, design)
        for side in SIDES:
            yield from _shared(name, side, design)
        problems = list(_inside(name, pair))
        yield from problems or _shifted(name, pair, design)
    for name, stage in design.stages.items():
        yield from _covered(f"{design.table(name)}.gears.rating", stage, design.rules(name).rating)
    yield from _dished(design)
    yield from _agma_steels(design)


def _dished(design: Design) -> Iterator[Problem]:
    """Find dished webs with holes, and dished webs of face gears, neither of which is worked out; once each."""
    found = set[Problem]()
    for name, pair in design.pairs.items():
        rules = design.rules(name)
        path = design.key_of(name, "gears.web_dish")
        if not rules.web_dish:
            continue
        if rules.web_holes and pair.kind == "cylindrical":
            message = f"{rules.web_dish:g} given with {rules.web_holes} holes; a web has one of the two: leave one out"
        elif pair.kind == "face":
            fix = f"write 0 in [pairs.{name}.gears]" if path == "gears.web_dish" else "leave it out"
            message = f"{rules.web_dish:g} given; must be 0, as webs of face gears are straight: {fix}"
        else:
            continue
        if (problem := Problem(path, message)) not in found:
            found.add(problem)
            yield problem


def _agma_steels(design: Design) -> Iterator[Problem]:
    """Find steels and grades that the tables of AGMA 2001 and 2003 do not have, once where they are written."""
    rules = {}
    for name in design.stages:
        table = RATINGS[design.rating(name)].table
        if table in ("agma2001", "agma2003"):
            rules[design.key_of(name, f"gears.{table}").removesuffix(f".{table}"), table] = design.rules(name)
    for (path, table), every in rules.items():
        standard = every.agma2001 if table == "agma2001" else every.agma2003
        told = [*_strengths(standard), *_unread_hardness(standard)]
        if "material" in every.model_fields_set and {"steel", "hardness_hb"} & standard.model_fields_set:
            told += _contradicted(every, standard, design)
        yield from (Problem(f"{path}.{table}.{problem.path}", problem.message) for problem in told)
        if isinstance(standard, Agma2001Rules) and standard.wheel is not None:
            for problem in (*_strengths(standard.wheel), *_unread_hardness(standard.wheel)):
                yield Problem(f"{path}.{table}.wheel.{problem.path}", problem.message)


def _contradicted(rules: GearRules, standard: Agma2001Rules | Agma2003Rules, design: Design) -> Iterator[Problem]:
    """Find a steel of AGMA's tables that is not hardened as the stated material is, or is not as hard."""
    material = design.known_materials.get(rules.material)
    if material is None:
        return
    ours = _HARDENED[standard.steel]
    its = next((hardening for hardening in _HARDENINGS if (material.steel or "").startswith(hardening)), ours)
    if its != ours:
        fitting = {"case-hardened": "carburised", _THROUGH: _THROUGH, "nitrided": "nitrided-4140"}.get(its)
        fix = f'write steel = "{fitting}", or another material' if fitting else "give another material, or no material"
        yield Problem("steel", f"{standard.steel!r}, but {rules.material!r} is {its}; {fix}")
    hard = material.surface_hardness or standard.hardness_hb
    if its == ours == _THROUGH and abs(standard.hardness_hb / hard - 1.0) > AGREEMENT:
        message = f"{standard.hardness_hb:g} HB, but {rules.material!r} has {hard:g} HB; keep one of them"
        yield Problem("hardness_hb", message)


def _unread_hardness(rules: Agma2001Rules | AgmaWheelSteel | Agma2003Rules) -> Iterator[Problem]:
    """Find the hardness of carburised gears, which go by their grade."""
    if rules.steel == "carburised" and "hardness_hb" in rules.model_fields_set:
        message = "has no effect: carburised gears go by their grade; leave it out, or write another steel"
        yield Problem("hardness_hb", message)


def _strengths(rules: Agma2001Rules | AgmaWheelSteel | Agma2003Rules) -> Iterator[Problem]:
    """Find a grade or a hardness that a table of strengths does not have."""
    keys = {"hardness": "hardness_hb"}
    try:
        if not isinstance(rules, Agma2003Rules):
            agma_strength(AgmaSteel(rules.steel), rules.grade, rules.hardness_hb)
            return
        bevel_strength(BevelSteel(rules.steel), rules.grade, rules.hardness_hb)
        if rules.wheel_hardness_hb is not None:
            keys["hardness"] = "wheel_hardness_hb"
            bevel_strength(BevelSteel(rules.steel), rules.grade, rules.wheel_hardness_hb)
    except DesignError as error:
        yield from (Problem(keys.get(problem.path, problem.path), problem.message) for problem in error.problems)


def _covered(path: str, stage: Pair | Planetary | Epicyclic, method: str) -> Iterator[Problem]:
    """Find stages with meshes that their method does not rate, and say which methods do."""
    if not (kinds := uncovered(method, stage.meshes)):
        return
    able = [name for name in RATINGS if not uncovered(name, stage.meshes)]
    titles = " or ".join(f'"{name}" ({RATINGS[method_of(name, stage.meshes)].title})' for name in able)
    yield Problem(path, f"{RATINGS[method].title} does not cover {kinds[0]} gears; write rating = {titles}")


def _shared(name: str, side: Role, design: Design) -> Iterator[Problem]:
    """Find a pair that says otherwise of a gear that it shares than the pair that owns it."""
    pair = design.pairs[name]
    stage, role = pair.shared(side) or ("", side)
    owner, gear = design.pairs.get(stage), gear_part(stage, role)
    if owner is None:
        return
    path, ours, theirs = f"pairs.{name}", getattr(pair, f"{side}_teeth"), getattr(owner, f"{role}_teeth")
    if ours is not None and ours != theirs:
        rest = "gearwright chooses them" if theirs is None else f"has {theirs} there"
        yield Problem(
            f"{path}.{side}_teeth", f"{ours}, but {gear} is the gear of pairs.{stage} and {rest}; give it there"
        )
    values = ((pair.kind, owner.kind), (pair.halves, owner.halves))
    for key, (mine, its) in zip(("kind", "halves"), values, strict=True):
        if mine != its and "face" not in (mine, its):
            yield Problem(
                f"{path}.{key}", f"{mine!r}, but the gear that it shares with pairs.{stage} has {its!r} there"
            )
    rules, others = design.rules(name), design.rules(stage)
    if pair.kind == owner.kind and rules.rating != others.rating:
        ours_by, theirs_by = (RATINGS[design.rating(one)].title for one in (name, stage))
        message = f"{ours_by} here, but the gear that it shares with pairs.{stage} is rated by {theirs_by}; give one"
        yield Problem(f"{path}.gears.rating", message)
    for key in ("pressure_angle", "helix_angle"):
        if getattr(rules, key) != getattr(others, key):
            here, there = (math.degrees(getattr(stage_rules, key)) for stage_rules in (rules, others))
            message = f"{here:.6g} deg, but the gear that it shares with pairs.{stage} has {there:.6g} deg; give one"
            yield Problem(f"{path}.gears.{key}", message)
    ends = ((rules.profile_shift, side), (others.profile_shift, role))
    shifts = [-shift if end is Role.WHEEL else shift for shift, end in ends]
    if shifts[0] != shifts[1]:
        message = f"{gear} would have the shift {shifts[0]:g} here and {shifts[1]:g} at pairs.{stage}; give 0 to both"
        yield Problem(f"{path}.gears.profile_shift", message)


def _inside(name: str, pair: Pair) -> Iterator[Problem]:
    """Find pinions that do not go into their ring."""
    path, pinion, wheel = f"pairs.{name}", pair.pinion_teeth, pair.wheel_teeth
    if pair.internal and pinion is not None and wheel is not None and wheel <= pinion:
        yield Problem(f"{path}.wheel_teeth", f"{wheel} teeth leave no room inside for a pinion of {pinion}; give more")
    if pair.internal and pair.ratio is not None and pair.ratio <= 1.0:
        message = f"{pair.ratio:g} leaves no room inside the wheel for the pinion; an internal pair needs more than 1"
        yield Problem(f"{path}.ratio", message)


def _shifted(name: str, pair: Pair, design: Design) -> Iterator[Problem]:
    """Find shifts of given teeth that contradict each other, or make no gears."""
    if pair.pinion_teeth is None or pair.wheel_teeth is None:
        return
    try:
        stage_shifts(design, name, {Role.PINION: pair.pinion_teeth, Role.WHEEL: pair.wheel_teeth})
    except DesignError as error:
        yield from error.problems


def _crossing(name: str, pair: Pair, design: Design) -> Iterator[Problem]:
    path = f"pairs.{name}"
    if pair.kind == "cylindrical":
        if pair.axis_angle is not None:
            message = 'only face and bevel gears have one; write kind = "face" or "bevel", or leave it out'
            yield Problem(f"{path}.axis_angle", message)
        return
    if pair.axis_angle is None:
        yield Problem(f"{path}.axis_angle_deg", f"a {pair.kind}-gear pair needs the angle between its axes; write 90")
    elif abs(pair.axis_angle - SQUARE) > ROUNDING:
        angle = math.degrees(pair.axis_angle)
        yield Problem(f"{path}.axis_angle", f"{angle:.6g} deg is not understood; only square axes are, 90")
    if pair.internal or pair.halves > 1:
        yield Problem(path, f"a {pair.kind}-gear pair is neither internal nor double-helical; leave that out")
    if design.rules(name).helix_angle:
        message = (
            "face gears are spur here; write 0" if pair.kind == "face" else "bevel gears have a spiral_angle; write 0"
        )
        yield Problem(f"{path}.gears.helix_angle_deg", message)
