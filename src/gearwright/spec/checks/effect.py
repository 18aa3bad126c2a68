"""Keys that are given and that nothing reads, in the structure in which they stand: what a user wrote has an effect.

The tables of rules ([gears], [teeth], [shafting], [carriers]) hold for whatever a design has, so that one study can
vary them over several architectures; a key there is told only where it belongs to another method of rating.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping

from gearwright.errors import Problem
from gearwright.identity import SIDES
from gearwright.spec.design import (
    INTERNAL,
    PAIR_ROLES,
    RATINGS,
    SET_ROLES,
    Design,
    Epicyclic,
    GearRules,
    Pair,
    Planetary,
    given_values,
)
from gearwright.spec.record import Record

_DECIDED = {
    "turbines": {"diameter": "inertia"},
    "motors": {"flux": "inertia", "mass_law": "mass"},
    "generators": {"flux": "inertia", "mass_law": "mass"},
}
"""Table -> key that only estimates what another key states."""
_OF_BEVELS = ("spiral_angle", "pinion_apex", "wheel_apex")
_OF_PAIRS = ("helix_angle", "overlap_ratio", "contact_angles", "web_ratio", "web_holes", "web_dish", "cutter_radius")
"""Rules of gears that planetary sets, spur and without wheels, do not read."""
_OF_SETS = ("idler_factor", "rim_thickness_ratio", "planet_load_factors")
"""Rules of gears that pairs, without planets and rings, do not read."""
_OF_HELICAL = ("overlap_ratio", "contact_angles")
_OF_CYLINDERS = (
    "helix_modification", "widest_diameters", "widest_modules", "dynamic_method", "least_dynamic_factor", "face_method",
    "tip_relief", "tip_relief_for", "tip_relief_tolerance", "blank_factor",
    "root_method",
    "micropitting_stage", "micropitting_safety",
    "static_pitting_safety", "static_bending_safety", "yielding_safety", "wheel",
)  # fmt: skip
"""Rules of ISO 6336 that ISO 10300 does not read."""
_OF_RINGS = ("ring_cutter",)
_OF_RINGS_OR_WHEELS = ("ring_cutter", "wheel")
_OF_CONES = ("mounting", "profile_crowning")
_OF_FITS = ("allowance", "centre_allowance")
"""Rules of gears that only cylindrical ones read."""


def effect_problems(design: Design) -> Iterator[Problem]:
    """Yield every key of a design that is given and has no effect where it stands.

    Args:
        design: As typed.
    """
    given = given_values(design).values
    for table, decided in _DECIDED.items():
        for name, machine in getattr(design, table).items():
            for key, by in decided.items():
                if key in machine.model_fields_set and (by in machine.model_fields_set or f"{name}.{by}" in given):
                    message = f"it only estimates the {by}, which is given too; keep one of the two"
                    yield Problem(f"{table}.{name}.{key}", message)
    for name, pair in design.pairs.items():
        yield from _ratio(f"pairs.{name}", pair, given=bool(pair.pinion_teeth and pair.wheel_teeth))
        yield from _pair(name, pair, design)
    for name, planetary in design.planetaries.items():
        path, teeth = f"planetaries.{name}", (planetary.sun_teeth, planetary.planet_teeth, planetary.ring_teeth)
        yield from _ratio(path, planetary, given=sum(tooth is not None for tooth in teeth) > 1)
        yield from _stage_rules(path, design.rules(name), planetary.gears, _OF_PAIRS, "planetary sets are spur here")
        yield from _set(path, planetary)
    for name, epicyclic in design.epicyclics.items():
        path = f"epicyclics.{name}"
        yield from _stage_rules(path, design.rules(name), epicyclic.gears, _OF_PAIRS, "compound sets are spur here")
        yield from _set(path, epicyclic)
    yield from _axes(design)
    yield from _methods(design)
    yield from _joints(design)
    yield from _bearings(design)
    yield from _housing(design)


def _ratio(path: str, stage: Pair | Planetary, *, given: bool) -> Iterator[Problem]:
    """Find ratios that the stage's own teeth decide, and a split of what is not open."""
    if given and stage.ratio is not None:
        yield Problem(f"{path}.ratio", f"{stage.ratio:g}, but its teeth are given and decide it; keep one of the two")
    if "ratio_split" in stage.model_fields_set and (given or stage.ratio is not None):
        by = "its teeth decide" if given else "ratio states"
        yield Problem(f"{path}.ratio_split", f"it splits an open ratio, and {by} this one; leave it out")


def _pair(name: str, pair: Pair, design: Design) -> Iterator[Problem]:
    path, rules = f"pairs.{name}", design.rules(name)
    if pair.kind != "bevel":
        yield from _idle(path, pair, _OF_BEVELS, f"only bevel gears have one, and this pair is {pair.kind}")
    of_sets = _OF_SETS[:1] if pair.internal else _OF_SETS
    yield from _stage_rules(path, rules, pair.gears, of_sets, "only planetary sets have planets and rings")
    yield from _fits(path, pair)
    if pair.gears is None:
        return
    if pair.kind != "bevel" or not pair.spiral_angle:
        yield from _idle(f"{path}.gears", pair.gears, ("cutter_radius",), "only spiral bevel gears are cut by one")
    if pair.kind != "bevel" and not rules.helix_angle:
        yield from _idle(f"{path}.gears", pair.gears, _OF_HELICAL, "only helical gears read it, and these are spur")
    written, foreign = pair.gears.iso6336, _OF_CYLINDERS if pair.kind == "bevel" else _OF_CONES
    standard = "ISO 10300 does not read it" if pair.kind == "bevel" else "only bevel gears read it"
    yield from _idle(f"{path}.gears.iso6336", written, foreign, standard)
    if not pair.internal:
        yield from _idle(f"{path}.gears.iso6336", written, _OF_RINGS, "this pair has no ring")


def _set(path: str, stage: Planetary | Epicyclic) -> Iterator[Problem]:
    """Find a set's own rules of ISO 6336 that are of bevel gears, or of a ring that it does not have."""
    if stage.gears is None:
        return
    own = stage.gears.iso6336
    yield from _idle(f"{path}.gears.iso6336", own, _OF_CONES, "only bevel gears read it")
    if INTERNAL not in stage.meshes:
        why = "this set has no ring"
        yield from _idle(f"{path}.gears.iso6336", own, _OF_RINGS_OR_WHEELS, why)
        yield from _idle(f"{path}.gears", stage.gears, ("rim_thickness_ratio",), why)


def _fits(path: str, pair: Pair) -> Iterator[Problem]:
    """Find fits of teeth that are no cylindrical ones, or that another pair owns."""
    for side in SIDES:
        if pair.kind != "cylindrical":
            why = f"allowances of tooth thickness are those of cylindrical gears, and this pair is {pair.kind}"
            yield from _idle(path, pair, (f"{side}_allowance",), why)
        elif (owner := pair.shared(side)) is not None:
            yield from _idle(path, pair, (f"{side}_allowance",), f"the gear is {'.'.join(owner)}; give it there")
    if pair.kind != "cylindrical" and pair.gears is not None:
        yield from _idle(f"{path}.gears", pair.gears, _OF_FITS, f"this pair is {pair.kind}")


def _stage_rules(
    path: str, rules: GearRules, written: GearRules | None, foreign: tuple[str, ...], why: str
) -> Iterator[Problem]:
    """Find a stage's own rules that belong to the other kind of stage, or to the other method."""
    if written is None:
        return
    yield from _idle(f"{path}.gears", written, foreign, why)
    told = {problem.path for problem in _idle(f"{path}.gears", written, foreign, why)}
    yield from (problem for problem in _unread(f"{path}.gears", written, {rules.rating}) if problem.path not in told)


def _unread(path: str, rules: GearRules, methods: set[str]) -> Iterator[Problem]:
    """Yield the rules that are given and that no method reads by which these gears are rated."""
    read = {key for method in methods for key in RATINGS[method].reads}
    titles = " and ".join(RATINGS[method].title for method in sorted(methods))
    tables = {facts.table: method for method, facts in reversed(RATINGS.items()) if facts.table}
    where = " and ".join(f"gears.{RATINGS[method].table}" for method in sorted(methods) if RATINGS[method].table)
    stands = f"; its safeties stand in {where}" if where else ""
    for key in {key: None for facts in RATINGS.values() for key in facts.reads if key not in read}:
        if key in tables and key in rules.model_fields_set:
            message = f'has no effect with {titles}; write rating = "{tables[key]}", or leave it out'
            yield Problem(f"{path}.{key}", message)
        else:
            yield from _idle(path, rules, (key,), f"{titles} does not read it{stands}")


def _idle(path: str, record: Record, keys: tuple[str, ...], why: str) -> Iterator[Problem]:
    """Yield the keys of a record that are given, although nothing reads them."""
    for key in keys:
        if key in record.model_fields_set:
            yield Problem(f"{path}.{key}", f"has no effect: {why}; leave it out")


def _axes(design: Design) -> Iterator[Problem]:
    """Find tolerances of centre distances where no gear says how thick its teeth are, so that no backlash follows."""
    for name, stage in design.simple_stages.items():
        rules, roles = design.rules(name), PAIR_ROLES if isinstance(stage, Pair) else SET_ROLES
        own = stage.gears is not None and "centre_allowance" in stage.gears.model_fields_set
        fits = (rules.allowance, *(getattr(stage, f"{role}_allowance") for role in roles))
        if own and not any(fits):
            why = "backlash follows from it only with the allowance of a tooth thickness"
            yield Problem(f"{design.table(name)}.gears.centre_allowance", f"has no effect: {why}; give allowance, too")


def _methods(design: Design) -> Iterator[Problem]:
    """Find rules of a method by which no stage is rated."""
    methods = {design.rules(name).rating for name in design.stages}
    if not methods:
        return
    yield from _unread("gears", design.gears, methods)
    if not any(INTERNAL in stage.meshes for stage in design.stages.values()):
        yield from _idle("gears.iso6336", design.gears.iso6336, _OF_RINGS, "this design has no ring")
    lives = any(RATINGS[method].table for method in methods)
    if "service" in design.model_fields_set and not design.bearings and not lives:
        message = (
            'has no effect without a rated part; write gears.rating = "iso6336", give [bearings], or leave it out;'
            " gearwright size --level preliminary takes --life-h"
        )
        yield Problem("service", message)


def _joints(design: Design) -> Iterator[Problem]:
    """Find joints on shafts without bearings, which are cylinders without seats."""
    built = {seat.shaft for seat in design.bearings.values()}
    for part in design.joints:
        shafts = _carriers_of(part, design)
        if shafts and not shafts & built:
            names = ", ".join(sorted(shafts))
            message = f"has no effect: {names} has no bearings and is one cylinder; give it [bearings], or leave it out"
            yield Problem(f"joints.{part}", message)


def _carriers_of(part: str, design: Design) -> set[str]:
    """Return the shafts that carry a gear or a machine; none where there is no such part."""
    if part in design.machines:
        return {design.machines[part].shaft}
    stage, _, role = part.partition(".")
    if stage in design.pairs and role in ("pinion", "wheel"):
        shafts = getattr(design.pairs[stage], role)
        return {shafts} if isinstance(shafts, str) else set(shafts)
    if stage in design.epicyclics:
        suns = design.epicyclics[stage].suns
        return {suns[role].shaft} if role in suns else set()
    return {design.planetaries[stage].sun} if stage in design.planetaries and role == "sun" else set()


def _bearings(design: Design) -> Iterator[Problem]:
    """Find the places of bearings on shafts that nothing bends, and a reliability that basic lives do not have."""
    if design.bearing_rules.life == "basic" and "reliability" in design.bearing_rules.model_fields_set:
        message = 'has no effect on basic lives, L_10h; write life = "modified" in [bearing_rules], or leave it out'
        yield Problem("bearing_rules.reliability", message)
    bent = _bent(design)
    for shaft, layout in design.layout.items():
        if shaft in design.shafts and shaft not in bent:
            why = "only torque acts on this shaft, so that its bearings bear nothing"
            yield from _idle(f"layout.{shaft}", layout, ("first_bearing", "second_bearing"), why)


def _bent(design: Design) -> set[str]:
    """Return the shafts that a gear of a pair or a rotor may bend, and those that the design gives bearings."""
    gears: Mapping[str, Pair] = design.pairs
    sides = [side for pair in gears.values() for side in (pair.pinion, pair.wheel)]
    bent = {name for side in sides for name in ([side] if isinstance(side, str) else side)}
    rotors = design.airscrews.values()
    bent |= {rotor.shaft for rotor in rotors if rotor.thrust or rotor.in_plane_force or rotor.hub_moment}
    return bent | {seat.shaft for seat in design.bearings.values()}


def _housing(design: Design) -> Iterator[Problem]:
    """Find what a housing that is weighed, or no part of the gearbox, does not read; and an oil system without flow."""
    rules = design.housing
    if not rules.own:
        why = "own = false leaves the housing out of the gearbox"
        yield from _idle("housing", rules, ("material", "wall", "mass"), why)
    elif rules.mass is not None:
        yield from _idle("housing", rules, ("material", "wall"), "mass states the whole housing")
    if rules.oil_system != "own":
        why = f'oil_system = "{rules.oil_system}" has no tank and no pump'
        yield from _idle("housing", rules, ("oil_dwell", "oil_temperature_rise"), why)
