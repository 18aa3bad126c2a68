"""Checks of a design file as a whole: part names, references, tooth numbers and keys without effect."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping

from gearwright.base import SIDES, Problem, near, text
from gearwright.spec.checks.airscrews import airscrew_problems
from gearwright.spec.checks.epicyclics import (
    epicyclic_problems,
    load_factor_problems,
    planetary_problems,
    sharing_problems,
)
from gearwright.spec.checks.gears import contradiction_problems, gear_problems, material_problems, oil_problems
from gearwright.spec.checks.machines import electric_problems
from gearwright.spec.checks.mounting import motion_problems, mounting_problems
from gearwright.spec.design import (
    CONCEPT,
    GROUND,
    INTERNAL,
    MACHINES,
    PAIR_ROLES,
    PRELIMINARY,
    RATED,
    RATINGS,
    SET_ROLES,
    WEIGHED,
    Case,
    Damper,
    Design,
    Drive,
    Epicyclic,
    GearRules,
    Machine,
    Pair,
    Planetary,
    case_named,
    cases_of,
    drives_of,
    gear_named,
    given_values,
    shares_of,
)
from gearwright.spec.record import NAME_RULE, Record, is_name, keys_of

# ----------------------------------------------------------------------------------------------------------------------
# What can be wrong with load cases: who does what, who balances, how long each lasts, what is engaged.
# ----------------------------------------------------------------------------------------------------------------------


WHOLE = 1e-6
"""How far from 1 the sum of the shares may be [-]."""
_AMOUNTS = ("power", "torque", "rating")


def case_problems(design: Design) -> Iterator[Problem]:
    """Yield what is wrong with the load cases of a design.

    Args:
        design: As typed.
    """
    for name, case in design.cases.items():
        for machine, drive in case.machines.items():
            path = f"cases.{name}.{machine}"
            if machine not in design.machines:
                yield Problem(path, f"there is no machine {machine!r}; {near(machine, design.machines)}")
            else:
                yield from _drive(path, drive, design.machines[machine])
        yield from _engaged(name, case, design)
    yield from _balanced(design)
    yield from _lasting(design)
    yield from _spectra(design)


def _drive(path: str, drive: Drive, machine: Machine) -> Iterator[Problem]:
    """Find what a machine cannot do."""
    said = [key for key in _AMOUNTS if getattr(drive, key) is not None]
    if len(said) + drive.balances > 1:
        both = " and ".join([*said, "balances"] if drive.balances else said)
        yield Problem(path, f"{both} are given; one of them says what the machine does, keep one")
        return
    if drive.rating is not None and machine.rating is None:
        yield Problem(f"{path}.rating", "this machine has no rated power; give its power")
        return
    for key in said:
        amount, kind = getattr(drive, key), type(machine).__name__.lower()
        if amount < 0.0 and not machine.takes:
            yield Problem(f"{path}.{key}", f"{_amount(amount, key)}: a {kind} gives power; use 0 or more")
        if amount > 0.0 and not machine.gives:
            message = f"{_amount(amount, key)}: this machine ({kind}) takes power; write {_amount(-amount, key)}, or 0"
            yield Problem(f"{path}.{key}", message)
        elif amount > 0.0 and not (machine.drives or drive.drives):
            message = (
                f"{_amount(amount, key)}: this machine ({kind}) takes power, and what a case takes is negative; write"
                f" {_amount(-amount, key)}, or drives = true beside it if it gives power"
            )
            yield Problem(f"{path}.{key}", message)
    yield from _driving(path, drive, machine)


def _driving(path: str, drive: Drive, machine: Machine) -> Iterator[Problem]:
    """Find a machine that is said to drive, and always does, never does, or is given nothing to do it with."""
    kind = type(machine).__name__.lower()
    if not drive.drives:
        return
    if machine.drives or not machine.gives:
        yield Problem(f"{path}.drives", f"a {kind} {'always' if machine.drives else 'never'} drives; leave it out")
    elif not max(drive.power or 0.0, drive.torque or 0.0) > 0.0:
        yield Problem(f"{path}.drives", "what it gives is not said; give a power or torque above 0, or leave it out")


def _amount(value: float, key: str) -> str:
    return f"{value:g}" if key == "rating" else text(value, key)


def _engaged(name: str, case: Case, design: Design) -> Iterator[Problem]:
    for clutch in case.engaged or []:
        path = f"cases.{name}.engaged"
        if clutch not in design.clutches:
            yield Problem(path, f"there is no clutch or brake {clutch!r}; {near(clutch, design.clutches)}")
        elif design.clutches[clutch].kind == "overrunning":
            yield Problem(path, f"{clutch!r} is overrunning and acts by itself; leave it out, or make it engaged")


def _balanced(design: Design) -> Iterator[Problem]:
    """Find cases in which nothing is left to balance, and designs that nothing loads."""
    if not design.machines:
        return
    loaded = False
    for case in cases_of(design):
        drives = drives_of(design, case)
        loaded |= any(drive.stated and not drive.idles for drive in drives.values())
        if all(drive.stated for drive in drives.values()) and not _braked(design, case):
            yield _none_balances(design, case)
    if not loaded and not design.turbines:
        fix = "write balances = false at a motor" if design.motors else "add a table such as [turbines.gas-turbine]"
        if design.cases:
            fix = "give a machine a power in a case"
        yield Problem("", f"no machine of a stated power drives this train, so that nothing loads it; {fix}")


def _braked(design: Design, case: str) -> bool:
    """Return whether a brake holds in a case: it bears what the machines leave."""
    held = [design.clutches[name] for name in case_named(design, case).engaged or [] if name in design.clutches]
    return any(GROUND in (clutch.driving, clutch.driven) for clutch in held)


def _none_balances(design: Design, case: str) -> Problem:
    if case not in design.cases:
        return Problem("propellers", "nothing takes the power; add a table such as [propellers.propeller]")
    return Problem(
        f"cases.{case}",
        f"the power of every machine is given ({', '.join(design.machines)}), so that none balances the rest and the"
        " losses; leave one out, or write balances = true at one",
    )


def _lasting(design: Design) -> Iterator[Problem]:
    """Find durations and shares that do not make up a life."""
    lasting = {name: case for name, case in design.cases.items() if not case.static}
    said = {name for name, case in design.cases.items() if case.duration is not None or case.share is not None}
    for name in said - lasting.keys():
        yield Problem(f"cases.{name}.static", "a static case counts no cycles; leave out its duration or share")
    if design.cases and not lasting:
        yield Problem("cases", "all of them are static, so that nothing makes up the life; add one that lasts")
    said &= lasting.keys()
    if design.service.shares:
        yield from _service_shares(design, said)
        return
    shares = [case.share for case in lasting.values() if case.share is not None]
    durations = [case.duration for case in lasting.values() if case.duration is not None]
    if shares and durations:
        yield Problem("cases", "some last a duration and some a share of the life; give all of them one of the two")
    elif said and len(said) < len(lasting):
        missing = ", ".join(name for name in lasting if name not in said)
        yield Problem("cases", f"{missing}: how long it lasts is not said; give it a {_written(shares)}, as the others")
    elif shares and abs(sum(shares) - 1.0) > WHOLE:
        yield Problem("cases", f"the sum of their shares is {sum(shares):.6g}; give shares with sum 1")
    elif not said and len(lasting) > 1 and _has_lives(design):
        names = ", ".join(lasting)
        message = f"{names}: how long each lasts is not said, and lives are asked; give each a duration_min or a share"
        yield Problem("cases", message)
    if shares_of(design) and "mean_load" in design.service.model_fields_set:
        yield Problem("service.mean_load", "it follows from the cases' durations or shares; keep one of the two")


def _spectra(design: Design) -> Iterator[Problem]:
    """Find spectra that are no spectra, and names that none has."""
    for name, spectrum in design.spectra.items():
        path, levels, total = f"spectra.{name}", spectrum.load, sum(spectrum.share)
        if len(levels) != len(spectrum.share):
            yield Problem(path, f"{len(levels)} levels of load and {len(spectrum.share)} shares; give one for each")
        elif abs(total - 1.0) > WHOLE or min(spectrum.share) < 0.0:
            yield Problem(f"{path}.share", f"their sum is {total:.6g}; give positive shares with sum 1")
        if min(levels) < 0.0 or max(levels) > 1.0:
            message = "a level is a part of what the case says, which is the highest; give 0 to 1"
            yield Problem(f"{path}.load", f"{min(levels):g} to {max(levels):g}: {message}")
    named = {f"cases.{name}": case for name, case in design.cases.items()} | {"service": design.service}
    for path, holder in named.items():
        if holder.spectrum is not None and holder.spectrum not in design.spectra:
            message = f"there is no spectrum {holder.spectrum!r}; {near(holder.spectrum, design.spectra)}"
            yield Problem(f"{path}.spectrum", message)
    for name, case in design.cases.items():
        if case.static and case.spectrum is not None:
            yield Problem(f"cases.{name}.spectrum", "a static case counts no cycles; leave it out")
    if design.service.spectrum is not None and "mean_load" in design.service.model_fields_set:
        yield Problem("service.mean_load", "it follows from service.spectrum; keep one of the two")


def _written(shares: list[float]) -> str:
    return "share" if shares else "duration"


def _service_shares(design: Design, said: set[str]) -> Iterator[Problem]:
    shares, known = design.service.shares, [*design.cases] or [RATED]
    for case in shares:
        if case not in known:
            yield Problem(f"service.shares.{case}", f"there is no case {case!r}; {near(case, known)}")
        elif case in design.cases and design.cases[case].static:
            yield Problem(f"service.shares.{case}", f"{case!r} is static and counts no cycles; leave it out")
    for case in said:
        yield Problem(f"cases.{case}", "how long it lasts stands here and in service.shares; keep one of the two")
    total = sum(shares.values())
    if abs(total - 1.0) > WHOLE or min(shares.values()) < 0.0:
        yield Problem("service.shares", f"their sum is {total:.6g}; give positive shares with sum 1")
    if "mean_load" in design.service.model_fields_set:
        yield Problem("service.mean_load", "it follows from service.shares; keep one of the two")


def _has_lives(design: Design) -> bool:
    """Tell whether something is rated for a life: gears by a standard, or bearings."""
    return bool(design.bearings) or any(RATINGS[design.rating(stage)].fatigue for stage in design.stages)


# ----------------------------------------------------------------------------------------------------------------------
# What can be wrong with forbidden bands of frequencies: reversed ends, cases and planets that are not there.
# ----------------------------------------------------------------------------------------------------------------------


def band_problems(design: Design) -> Iterator[Problem]:
    """Yield what is wrong with the bands of frequencies that teeth shall not pass at.

    Args:
        design: As typed.
    """
    for name, band in design.teeth.forbidden.items():
        path = f"teeth.forbidden.{name}"
        if band.highest <= band.lowest:
            ends = f"{text(band.highest, 'frequency')} is not above lowest, {text(band.lowest, 'frequency')}"
            yield Problem(f"{path}.highest", f"{ends}; give the upper end here, or leave the band out")
        for case in band.cases or []:
            if case not in cases_of(design):
                yield Problem(f"{path}.cases", f"there is no case {case!r}; {near(case, cases_of(design))}")
        if band.cases == []:
            yield Problem(f"{path}.cases", "is empty, so that the band holds nowhere; name a case, or leave it out")
        if band.of == "planet-pass" and not design.sets:
            yield Problem(f"{path}.of", "'planet-pass', but the design has no planets; write \"mesh\"")


# ----------------------------------------------------------------------------------------------------------------------
# What can be wrong with names: some that no path of a result can hold, and two parts that would be called alike.
# ----------------------------------------------------------------------------------------------------------------------


STAGES = {"pairs": "the pair", "planetaries": "the set", "epicyclics": "the set"}
"""Table of stages -> what stands in it."""
ALONE = {
    **dict.fromkeys(MACHINES, "the machine"), **STAGES, "clutches": "the clutch", "dampers": "the damper",
    "bearings": "the bearing",
}  # fmt: skip
"""Table -> what stands in it, of parts that lie along shafts by their names, which therefore differ."""
_DIFFERENT = "results, places along shafts and overrides need different names: rename"


def name_problems(design: Design) -> Iterator[Problem]:
    """Yield every name of a design that cannot be one.

    Args:
        design: As typed.
    """
    yield from _shaft_names(design)
    yield from _whole(design)
    tables = _tables(design)
    for table, names in tables.items():
        for name in names:
            if not is_name(name):
                yield Problem(f"{table}.{name}", f"{name!r} {NAME_RULE}")
    for table in MACHINES:
        for name in tables[table]:
            if name in keys_of(Case):
                yield Problem(f"{table}.{name}", f"{name!r} is a key of load cases; give the machine another name")
    yield from _in_the_model(design)


def _tables(design: Design) -> dict[str, Mapping[str, object]]:
    return {
        **{table: getattr(design, table) for table in MACHINES},
        "pairs": design.pairs, "planetaries": design.planetaries, "epicyclics": design.epicyclics,
        "clutches": design.clutches, "dampers": design.dampers, "cases": design.cases,
    }  # fmt: skip


def _shaft_names(design: Design) -> Iterator[Problem]:
    seen: set[str] = set()
    for name in design.shafts:
        if name in seen:
            yield Problem("shafts", f"{name!r} stands twice; every shaft has one name")
        if name == GROUND:
            yield Problem("shafts", f"{GROUND!r} is the frame and stands still; give the shaft another name")
        seen.add(name)


def _whole(design: Design) -> Iterator[Problem]:
    """Find parts whose mass would be given by the path of the whole gearbox's."""
    named = [("shafts", name) for name in design.shafts]
    named += [(f"{table}.{name}", name) for table in WEIGHED for name in getattr(design, table)]
    for path, name in named:
        if name == "gearbox":
            yield Problem(path, f"{name!r} is the whole, whose mass {name}.mass is; give the part another name")


def alike_problems(design: Design) -> Iterator[Problem]:
    """Yield every part that is called like another, where results, places or overrides know them by their names.

    Args:
        design: As typed.
    """
    owners = dict[str, str]()
    for table, what in ALONE.items():
        for name in getattr(design, table):
            path = f"{table}.{name}"
            if table in MACHINES and name in design.shafts:
                yield Problem(path, f"shafts has a shaft of this name already; {_DIFFERENT} {what}")
            elif (first := owners.setdefault(name, path)) != path:
                yield Problem(path, f"{first} is called {name!r} already; {_DIFFERENT} {what}")


def _in_the_model(design: Design) -> Iterator[Problem]:
    """Find parts that are called like a line of the dynamic model."""
    lines = {f"{name} shaft": f"the shaft of {name!r}" for name in (*design.shafts, *design.machines)}
    lines |= {f"{name} hub": f"the hub of {name!r}" for name in design.shafts}
    lines |= {f"{name} clutch": f"the clutch {name!r}" for name in design.clutches}
    lines |= {f"{name} damper": f"the damper {name!r}" for name in design.dampers}
    for table in (*MACHINES, *STAGES):
        for name in getattr(design, table):
            if name in lines:
                yield Problem(f"{table}.{name}", f"the dynamic model calls {lines[name]} so; give it another name")


# ----------------------------------------------------------------------------------------------------------------------
# Keys that are given and that nothing reads, in the structure in which they stand: what a user wrote has an effect.
#
# The tables of rules ([gears], [teeth], [shafting], [carriers]) hold for whatever a design has, so that one study can
# vary them over several architectures; a key there is told only where it belongs to another method of rating.
# ----------------------------------------------------------------------------------------------------------------------


_OF_ELECTRIC = {
    "flux": "inertia", "tip_speed": "mass", "inverter": "inverter_mass", "cooling": "cooling_mass",
}  # fmt: skip
_DECIDED = {
    "turbines": {"diameter": "inertia"},
    "motors": _OF_ELECTRIC,
    "generators": _OF_ELECTRIC,
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
        yield from _idle("housing", rules, ("material", "wall", "mass", "rings", "reaction"), why)
    elif rules.mass is not None:
        yield from _idle("housing", rules, ("material", "wall"), "mass states the whole housing")
    if rules.oil_system != "own":
        why = f'oil_system = "{rules.oil_system}" has no tank and no pump'
        yield from _idle("housing", rules, ("oil_dwell", "oil_temperature_rise"), why)


# ----------------------------------------------------------------------------------------------------------------------
# What the types cannot see: names that must exist, names that must differ, teeth that must fit together.
# ----------------------------------------------------------------------------------------------------------------------


WIDEST = 60
"""Largest face width in modules that a design may ask for."""


def reference_problems(design: Design) -> list[Problem]:
    """Return every name in a design that points nowhere or clashes, and every impossible set of given teeth.

    Args:
        design: As typed; its references are not resolved yet.
    """
    problems = _problems(design)
    if not problems or design.level != PRELIMINARY or "level" in design.model_fields_set:
        return problems
    at_concept = {problem.path for problem in _problems(design.stating(level=CONCEPT))}
    why = f'no level is stated, so it is {PRELIMINARY!r}: level = "{CONCEPT}" asks for nothing of it'
    return [
        problem if problem.path in at_concept else Problem(problem.path, f"{problem.message}; {why}")
        for problem in problems
    ]


def _problems(design: Design) -> list[Problem]:
    """Return what is wrong with a design at its level; parts of one name alone, as all else asks for parts by name."""
    if alike := list(alike_problems(design)):
        return [*name_problems(design), *alike]
    checks = (
        name_problems, _idle_shafts, _machines, airscrew_problems, electric_problems, _speeds, _pairs,
        planetary_problems, load_factor_problems, sharing_problems,
        epicyclic_problems, _links, _teeth, _layout, case_problems, _keep, _widths, _given, _waivers, _level,
    )  # fmt: skip
    problems = [problem for check in checks for problem in check(design)]
    more = (
        material_problems, gear_problems, effect_problems, motion_problems, mounting_problems, oil_problems,
        contradiction_problems, band_problems,
    )  # fmt: skip
    return [*problems, *(problem for check in more for problem in check(design))]


def _idle_shafts(design: Design) -> Iterator[Problem]:
    used = _used_shafts(design)
    for name in design.shafts:
        if name not in used:
            yield Problem("shafts", f"{name!r} carries nothing; remove it, or put a machine or a gear on it")


def _used_shafts(design: Design) -> set[str]:
    used = {machine.shaft for machine in design.machines.values()}
    for pair in design.pairs.values():
        used |= {name for side in SIDES for name in pair.named(side)}
    for stage in design.sets.values():
        used |= set(stage.members)
    for link in design.links.values():
        used |= {link.driving, link.driven}
    return used


def _shaft(path: str, name: str, design: Design) -> Iterator[Problem]:
    if name not in design.shafts:
        yield Problem(path, f"there is no shaft {name!r}; {near(name, design.shafts)}")


def _machines(design: Design) -> Iterator[Problem]:
    for table in MACHINES:
        for name, machine in getattr(design, table).items():
            path = f"{table}.{name}.shaft"
            if machine.shaft == GROUND:
                yield Problem(path, f"{GROUND!r} stands still, and no machine turns there; name a shaft that turns")
            else:
                yield from _shaft(path, machine.shaft, design)
            poles = getattr(machine, "poles", None)
            if poles is not None and poles % 2:
                yield Problem(f"{table}.{name}.poles", f"{poles} is odd; poles come in pairs: give an even number")
    if not design.machines:
        yield Problem("", "no machine drives or loads this train; add a table such as [turbines.gas-turbine]")


def _speeds(design: Design) -> Iterator[Problem]:
    """Find machines on one shaft that ask for different speeds, or senses, and trains of which no speed is asked."""
    if design.machines and all(machine.asked_speed is None for machine in design.machines.values()):
        yield Problem("", "no machine has a speed; give one to a machine, such as speed_rpm of a turbine or motor")
    first: dict[str, str] = {}
    for name, machine in design.machines.items():
        if machine.asked_speed is None:
            continue
        partner = first.setdefault(machine.shaft, name)
        asked, speed = signed_speed(name, design), signed_speed(partner, design)
        if abs(asked / speed - 1.0) > design.teeth.speed_tolerance:
            yield Problem(
                f"{table_of(name, design)}.{name}.speed",
                f"{text(asked, 'speed')} on shaft {machine.shaft!r}, where {partner} turns at {text(speed, 'speed')};"
                " give one speed to both, or put a gear stage between them",
            )


def signed_speed(machine: str, design: Design) -> float:
    """Return the speed that a machine asks for, negative where it turns against the first [rad/s]; 0 if it asks none.

    Args:
        machine: Its name.
        design: The design.
    """
    asked = design.machines[machine].asked_speed or 0.0
    return -asked if machine in design.motors and design.motors[machine].reverse else asked


def table_of(machine: str, design: Design) -> str:
    """Return the table of the file that describes a machine.

    Args:
        machine: Its name.
        design: The design.
    """
    return next(table for table in MACHINES if machine in getattr(design, table))


def _pairs(design: Design) -> Iterator[Problem]:
    for name, pair in design.pairs.items():
        path = f"pairs.{name}"
        if pair.pinion == [] or pair.wheel == []:
            yield Problem(path, "a gear sits on at least one shaft; name one in pinion and in wheel")
            continue
        sides = {side: pair.named(side) for side in SIDES}
        if all(isinstance(getattr(pair, side), list) for side in SIDES):
            yield Problem(
                path, "pinion and wheel are both lists; one gear meshes with several, so only one side may be a list"
            )
        for side, names in sides.items():
            for shaft in names:
                yield from _gear_reference(f"{path}.{side}", shaft, name, design)
            if len(set(names)) < len(names) or (len(names) > 1 and any("." in shaft for shaft in names)):
                yield Problem(f"{path}.{side}", f"{names}: a list names different shafts, and no shared gear")
        if set.intersection(*map(set, sides.values())):
            yield Problem(path, f"{pair.pinion!r} carries both gears; pinion and wheel turn on two shafts")
        if pair.coaxial_with is not None and (pair.coaxial_with == name or pair.coaxial_with not in design.pairs):
            others = [other for other in design.pairs if other != name]
            yield Problem(f"{path}.coaxial_with", f"there is no other pair {pair.coaxial_with!r}; {near(name, others)}")
        meshes = max(len(names) for names in sides.values())
        if pair.share is not None and not _is_share(pair.share, meshes):
            yield Problem(
                f"{path}.share",
                f"{pair.share} does not share the load of {meshes} meshes; give as many positive numbers, sum 1",
            )


def _is_share(share: list[float], meshes: int) -> bool:
    return len(share) == meshes and min(share) > 0.0 and abs(sum(share) - 1.0) <= 1e-9


def _gear_reference(path: str, name: str, pair_name: str, design: Design) -> Iterator[Problem]:
    if "." not in name:
        yield from _shaft(path, name, design)
        return
    stage, gear = gear_named(name) or ("", SIDES[0])
    others = [f"{pair}.{side}" for pair in design.pairs if pair != pair_name for side in SIDES]
    if stage == pair_name or stage not in design.pairs:
        yield Problem(path, f"there is no gear {name!r} in another pair; {near(name, others)}")
    elif any("." in shaft for shaft in design.pairs[stage].named(gear)):
        yield Problem(path, f"{name!r} is itself a shared gear; name the pair that owns it")


def _links(design: Design) -> Iterator[Problem]:
    for name, link in design.links.items():
        table, kind = ("dampers", "damper") if isinstance(link, Damper) else ("clutches", "clutch")
        for side in ("driving", "driven"):
            if isinstance(link, Damper) or getattr(link, side) != GROUND:  # a clutch to the ground is a brake
                yield from _shaft(f"{table}.{name}.{side}", getattr(link, side), design)
        if link.driving == link.driven:
            message = f"{link.driven!r} drives already; a {kind} joins two different shafts"
            yield Problem(f"{table}.{name}.driven", message)


def _teeth(design: Design) -> Iterator[Problem]:
    rules = design.teeth
    largest = rules.largest_sun()
    if rules.sun_minimum > largest:
        yield Problem("teeth.sun_minimum", f"{rules.sun_minimum} is above teeth.sun_maximum, {largest}")
    if rules.pinion_minimum is not None and rules.pinion_minimum > rules.pinion_maximum:
        yield Problem(
            "teeth.pinion_minimum", f"{rules.pinion_minimum} is above teeth.pinion_maximum, {rules.pinion_maximum}"
        )


def _layout(design: Design) -> Iterator[Problem]:
    given = given_values(design).values
    for name, layout in design.layout.items():
        yield from _shaft(f"layout.{name}", name, design)
        if layout.bore is not None and layout.bore_ratio is not None:
            yield Problem(f"layout.{name}", "bore and bore_ratio are both given; keep one")
        diameter = given.get(f"{name}.diameter")
        if layout.bore is not None and diameter is not None and layout.bore >= diameter.value:
            yield Problem(
                f"layout.{name}.bore",
                f"the bore {layout.bore * 1e3:g} mm leaves no wall in a shaft of {diameter.value * 1e3:g} mm",
            )


def _keep(design: Design) -> Iterator[Problem]:
    for machine in design.speeds.keep or []:
        if machine not in design.machines:
            yield Problem("speeds.keep", f"there is no machine {machine!r}; {near(machine, design.machines)}")


def _given(design: Design) -> Iterator[Problem]:
    yield from given_values(design).problems


def _waivers(design: Design) -> Iterator[Problem]:
    for name, reason in design.waivers.items():
        if not reason.strip():
            yield Problem(f"waivers.{name}", "has no reason; write why the design accepts that this check fails")


def _level(design: Design) -> Iterator[Problem]:
    """Find a level that the bearings contradict, and stages that a preliminary design cannot rate."""
    if design.level in ("concept", "preliminary") and design.bearings:
        message = (
            f'{design.level!r}, but [bearings] stand, which build the shafts; write level = "built", or leave them out'
        )
        yield Problem("level", message)
    if design.level == "preliminary":
        yield from _preliminary(design)
    if design.level == "built" and not design.bearings:
        yield Problem("level", "'built' needs [bearings]; give each shaft two, or write level = \"concept\"")


def _preliminary(design: Design) -> Iterator[Problem]:
    """Find stages whose method knows no fatigue."""
    for name in design.stages:
        if not RATINGS[design.rating(name)].fatigue:
            message = (
                f'{design.rating(name)!r} knows no fatigue, which level = "preliminary" asks for; write rating ='
                ' "iso6336", or size the design with --level preliminary'
            )
            yield Problem(f"{design.table(name)}.gears.rating", message)


def _widths(design: Design) -> Iterator[Problem]:
    """Find helix angles so small that no face width gives the overlap."""
    rules = {"gears": design.gears} if design.pairs else {}
    rules |= {
        f"pairs.{name}.gears": design.rules(name) for name, pair in design.pairs.items() if pair.gears is not None
    }
    for path, rule in rules.items():
        smallest = math.asin(rule.overlap_ratio * math.pi / WIDEST)
        if rule.face_width_ratio is None and 0.0 < rule.helix_angle < smallest:
            yield Problem(
                f"{path}.helix_angle",
                f"{text(rule.helix_angle, 'angle')} needs gears wider than {WIDEST} modules for the overlap ratio"
                f" {rule.overlap_ratio:g}; use 0, {text(smallest, 'angle')} or more, or give face_width_ratio",
            )
