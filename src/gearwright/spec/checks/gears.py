"""Checks of gears, materials and oil: axes, shared gears, contradictory requirements and strengths."""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator

from gearwright.base import SIDES, DesignError, Problem, Role, gear_part, near, text
from gearwright.catalogue import gear_steel_names, hardnesses_of, is_cast_iron, material_of, materials, rated_steel
from gearwright.parts import Material
from gearwright.parts.agma2001 import AgmaSteel, agma_strength
from gearwright.parts.agma2003 import BevelSteel, bevel_strength
from gearwright.parts.iso6336 import RZ_OVER_RA, GearSteel
from gearwright.spec.design import (
    GRADE_KEYS,
    RATINGS,
    SIDE_ANGLES,
    WARMTH_KEYS,
    Agma2001Rules,
    Agma2003Rules,
    AgmaWheelSteel,
    Design,
    Epicyclic,
    GearRules,
    Iso6336Rules,
    LifeLineRules,
    MaterialRules,
    Pair,
    Planetary,
    WheelSteel,
    given_values,
    method_of,
    stage_shifts,
    uncovered,
)
from gearwright.spec.record import keys_of

# ----------------------------------------------------------------------------------------------------------------------
# What can be wrong with gears beyond their teeth: axes that do not meet squarely, shared gears, rings.
# ----------------------------------------------------------------------------------------------------------------------


SQUARE = 0.5 * math.pi
"""Axis angle of face and bevel gears that is understood [rad]."""
ROUNDING = 1e-6
"""How near to it a written angle must be [rad]."""
STEEL_AGREEMENT = 0.08
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
    if its == ours == _THROUGH and abs(standard.hardness_hb / hard - 1.0) > STEEL_AGREEMENT:
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


# ----------------------------------------------------------------------------------------------------------------------
# Wishes that contradict each other, both named: sides and angles, pins given twice, overlap wider than is allowed.
#
# Keep-outs without a body are found here, too.
# ----------------------------------------------------------------------------------------------------------------------


_SAME = 1e-9
"""Part by which two lengths may differ that are one [-]."""


_THIN = 1e-6
"""Edges and axes of a keep-out that are shorter are none [m]."""


def contradiction_problems(design: Design) -> Iterator[Problem]:
    """Yield wishes that contradict each other, and keep-outs that enclose nothing or say no reason.

    Args:
        design: As typed.
    """
    yield from _places(design)
    yield from _pins(design)
    yield from _overlaps(design)


def _pins(design: Design) -> Iterator[Problem]:
    given = given_values(design).values
    for name, stage in design.planetaries.items():
        pin, bearing = given.get(f"{name}.pin_diameter"), stage.planet_bearing
        if pin is None or bearing is None or bearing.diameter is None:
            continue
        if abs(bearing.diameter - pin.value) > _SAME * pin.value:
            message = (
                f"{text(bearing.diameter, 'length')}, but {pin.entry} gives the same pin {text(pin.value, 'length')};"
                " keep one of them"
            )
            yield Problem(f"planetaries.{name}.planet_bearing.diameter", message)


def _overlaps(design: Design) -> Iterator[Problem]:
    """Find overlap ratios that are asked of gears whose face may not be as wide; the usual one yields by itself."""
    rules = {"gears": design.gears} if design.pairs else {}
    rules |= {f"pairs.{name}.gears": own for name, pair in design.pairs.items() if (own := pair.gears) is not None}
    for path, rule in rules.items():
        whole = rule if path == "gears" else design.rules(path.split(".")[1])
        if "overlap_ratio" in rule.model_fields_set and whole.face_width_ratio is None and whole.helix_angle > 0.0:
            yield from _too_wide(path, whole)


def _too_wide(path: str, rule: GearRules) -> Iterator[Problem]:
    table = RATINGS[rule.rating].table
    if not table:
        return
    asked = rule.overlap_ratio * math.pi / math.sin(rule.helix_angle)
    allowed = getattr(rule, table).widest_modules
    if asked > allowed * (1.0 + _SAME):
        lean = math.asin(min(rule.overlap_ratio * math.pi / allowed, 1.0))
        message = (
            f"{rule.overlap_ratio:g} asks for a face of {asked:.4g} modules at a helix angle of"
            f" {text(rule.helix_angle, 'angle')}, but {path}.{table}.widest_modules allows {allowed:g}; ask for less,"
            f" lean the teeth by {text(lean, 'angle')}, or allow wider faces"
        )
        yield Problem(f"{path}.overlap_ratio", message)


def _places(design: Design) -> Iterator[Problem]:
    """Find angles that point away from their sides, and keep-outs that enclose nothing or say no reason."""
    for name, layout in design.layout.items():
        if layout.side is None or layout.angle is None:
            continue
        off = layout.angle - SIDE_ANGLES[layout.side]
        if math.cos(off) <= 0.0:
            message = (
                f"{layout.side!r} contradicts angle_deg = {math.degrees(layout.angle):g}; leave one of them out, or"
                f" give an angle within 90° of {math.degrees(SIDE_ANGLES[layout.side]):g}"
            )
            yield Problem(f"layout.{name}.side", message)
    for name, keep in design.keep_out.items():
        edges = [abs(end - start) for start, end in ((getattr(keep.start, k), getattr(keep.end, k)) for k in "xyz")]
        if keep.radius is None and min(edges) < _THIN:
            thin = ", ".join(k for k, edge in zip("xyz", edges, strict=True) if edge < _THIN)
            message = f"the box is flat: start and end are equal in {thin}; give it a thickness, or a radius_mm"
            yield Problem(f"keep_out.{name}.end", message)
        if keep.radius is not None and math.hypot(*edges) < _THIN:
            message = "start and end of the cylinder's axis are one place; give it a length"
            yield Problem(f"keep_out.{name}.end", message)
        if not keep.reason.strip():
            yield Problem(f"keep_out.{name}.reason", "is empty; write what is there")


# ----------------------------------------------------------------------------------------------------------------------
# What can be wrong with materials: half of one, two numbers that disagree, and what a use needs and it lacks.
# ----------------------------------------------------------------------------------------------------------------------


STEEL_KEYS = {"material": "steel", "grade": "grade", "hardness": "hardness_hv"}
"""What the table of steels complains of -> key of the design file."""
SCALES = {"hardness_hv": "HV", "hardness_hb": "HB", "hardness_hrc": "HRC"}
FLANK_AGREEMENT = 0.08
"""How far two hardnesses of a flank may lie apart after conversion [-]."""
WRITTEN = {
    "yield_strength": "yield_strength_mpa", "ultimate_strength": "ultimate_strength_mpa",
    "surface_hardness": "hardness_hv",
}  # fmt: skip
"""Property of a material -> key that states it."""
_PAIRS = (("contact_strength", "bending_strength"), ("bending_strength", "contact_strength"))
_OF_CLASS = ("grade", "contact_strength", "bending_strength", "contact_life", "bending_life")
"""Fields that mean something only with a class of ISO 6336-5, which sets the other factors."""
_ISO = "iso6336"
"""Table of rules that names a class of ISO 6336-5."""
_UNTYPED = ("source", "sources", "estimated")


def material_problems(design: Design) -> Iterator[Problem]:
    """Yield what is wrong with the materials of a design and with their uses.

    Args:
        design: As typed.
    """
    for name, rules in design.materials.items():
        for key, message in _own(name, rules):
            yield Problem(f"materials.{name}{key and '.'}{key}", message)
    for path, gear_rules in _gear_rules(design).items():
        yield from _gears(path, gear_rules, design)
    yield from _shafts(design)


def _own(name: str, rules: MaterialRules) -> Iterator[tuple[str, str]]:
    """Yield key and message of what is wrong with one material by itself."""
    if name in materials():
        yield "", f"the catalogue has a material of this name; give it another, such as {name}-mine"
    if name in gear_steel_names():
        yield "", f"ISO 6336-5 has a class of this name; give it another, such as {name}-mine"
    yield from _words(rules)
    yield from _material_strengths(rules)
    if rules.steel is None:
        for key in _OF_CLASS:
            if getattr(rules, key) is not None:
                names = ", ".join(gear_steel_names())
                yield key, f"a gear's life needs a class of ISO 6336-5 with it; give steel, one of {names}"
    elif rules.steel not in gear_steel_names():
        yield "steel", f"{rules.steel!r} is no class of ISO 6336-5; {near(rules.steel, gear_steel_names())}"
    else:
        yield from _rated(name, rules)
    for mode in ("contact_life", "bending_life"):
        line: LifeLineRules | None = getattr(rules, mode)
        if line is not None and line.static_factor and line.knee_cycles < line.static_factor**line.exponent:
            message = f"{line.exponent:g} carries the line to less than one cycle; give a smaller one, or static_factor"
            yield f"{mode}.exponent", message


def _words(rules: MaterialRules) -> Iterator[tuple[str, str]]:
    """Find sources and rules of estimates of properties that the material does not have."""
    names = [name for name in MaterialRules.model_fields if name not in _UNTYPED and not name.startswith("hardness")]
    names += ["hardness", "surface_hardness"]
    for table in ("sources", "estimated"):
        for key, words in getattr(rules, table).items():
            if key not in names:
                yield f"{table}.{key}", f"a material has no such property; {near(key, names)}"
            elif table == "estimated" and not words.strip():
                yield f"{table}.{key}", "is empty; say by which rule it is estimated"


def _material_strengths(rules: MaterialRules) -> Iterator[tuple[str, str]]:
    """Find strengths and hardnesses that contradict each other, or of which one half is missing."""
    proof, ultimate = rules.yield_strength, rules.ultimate_strength
    if proof is not None and ultimate is not None and proof > ultimate:
        message = f"{1e-6 * proof:g} MPa is more than the tensile strength {1e-6 * ultimate:g} MPa; allowed: up to that"
        yield "yield_strength", message
    for stated, missing in _PAIRS:
        if getattr(rules, stated) is not None and getattr(rules, missing) is None:
            key = next(key for key, meant in keys_of(MaterialRules).items() if meant.field == missing)
            yield stated, f"is half of what a gear needs; give {key} too, or leave both to the class"
    given = [scale for scale in SCALES if getattr(rules, scale) is not None]
    vickers = {scale: hardnesses_of({scale: getattr(rules, scale)})[0] or 0.0 for scale in given}
    for scale in given[1:]:
        first, other = vickers[given[0]], vickers[scale]
        if abs(other / first - 1.0) > FLANK_AGREEMENT:
            message = f"{getattr(rules, scale):g} {SCALES[scale]} is about {other:.0f} HV and {given[0]} {first:.0f} HV"
            yield scale, f"{message} (ISO 18265); keep one"


def _rated(name: str, rules: MaterialRules) -> Iterator[tuple[str, str]]:
    """Find a hardness that the class does not have, or none where it takes one."""
    given = [scale for scale in SCALES if getattr(rules, scale) is not None]
    try:
        rated_steel(material_of(name, rules.model_dump()))
    except DesignError as error:
        for problem in error.problems:
            key = {"hardness": given[0] if given else "hardness_hv"}.get(problem.path, problem.path)
            missing = problem.path == "hardness" and not given
            yield (
                key,
                f"is required with steel = {rules.steel!r}; or hardness_hb, hardness_hrc"
                if missing
                else (
                    f"{problem.message} (of the class {rules.steel!r}); or give contact_strength and bending_strength"
                ),
            )


def _gear_rules(design: Design) -> dict[str, GearRules]:
    """Return the rules of gears by the table in which they say something of the material."""
    rules = {"gears": design.gears}
    for name, stage in design.stages.items():
        if stage.gears is not None and {"material", "iso6336", "rating"} & stage.gears.model_fields_set:
            rules[f"{design.table(name)}.gears"] = design.rules(name)
    return rules


def _gears(path: str, rules: GearRules, design: Design) -> Iterator[Problem]:
    """Find a material that a stage's gears cannot be rated with."""
    name = rules.material
    if name not in design.known_materials:
        yield Problem(f"{path}.material", f"there is no material {name!r}; {near(name, design.known_materials)}")
        return
    method = RATINGS[rules.rating]
    if method.table != _ISO:
        yield from _needs(f"{path}.material", name, method.needs, design, f"rating {rules.rating!r}")
        return
    standard = rules.iso6336
    if standard.steel in design.known_materials:
        message = f"{standard.steel!r} is a material and no class; write material = {standard.steel!r} and leave it out"
        yield Problem(f"{path}.iso6336.steel", message)
        return
    yield from _replaced(path, rules, design)
    asked = {"steel", "grade", "hardness_hv"} & standard.model_fields_set
    try:
        steel = rated_steel(design.material(name), standard.steel, standard.grade, hardness=standard.hardness_hv)
    except DesignError as error:
        for problem in error.problems:
            if problem.path == "material" or asked or name not in design.materials:  # else its own table tells
                key = STEEL_KEYS.get(problem.path, problem.path)
                yield Problem(f"{path}.iso6336.{key}", problem.message)
    else:
        if _needs_yield(steel):
            yield from _needs(f"{path}.material", name, ("yield_strength",), design, f"{steel.name} by ISO 6336-3")
        yield from _of_iron(f"{path}.iso6336.steel", standard.steel, design.material(name))
    if standard.wheel is not None:
        yield from _wheel(f"{path}.iso6336.wheel", standard.wheel, design.material(name))


def _of_iron(path: str, name: str | None, material: Material) -> Iterator[Problem]:
    """Find a class of steel in the place of a material of cast iron, whose E would make its contact too soft."""
    if name is not None and is_cast_iron(material.steel) and not is_cast_iron(name):
        message = (
            f"{name!r} given, and {material.name!r} is {material.steel}: no cast iron is hardened to a class of steel"
        )
        yield Problem(
            path, f"{message}; give material a steel, and [gears.iso6336.wheel] the iron if that is the wheel's"
        )


def _wheel(path: str, wheel: WheelSteel, material: Material) -> Iterator[Problem]:
    """Find a class, grade or hardness of wheels that ISO 6336-5 does not have, and a soft one without its yield."""
    try:
        steel = rated_steel(material, wheel.steel, wheel.grade, hardness=wheel.hardness_hv)
    except DesignError as error:
        for problem in error.problems:
            yield Problem(f"{path}.{STEEL_KEYS.get(problem.path, problem.path)}", problem.message)
        return
    yield from _of_iron(f"{path}.steel", wheel.steel, material)
    foreign = steel.treatment.is_cast_iron and not is_cast_iron(material.steel)  # R_p0.2 of a steel is none of iron
    if _needs_yield(steel) and wheel.yield_strength is None and (foreign or material.yield_strength is None):
        message = f"is required: {steel.name} by ISO 6336-3 goes by its proof stress"
        yield Problem(f"{path}.yield_strength_mpa", message)


def _needs_yield(steel: GearSteel) -> bool:
    """Tell whether the notch sensitivity of a steel goes by its proof stress (ISO 6336-3:2019, clause 13)."""
    return not (steel.treatment.is_surface_hardened or steel.treatment.is_brittle_iron)


def _replaced(path: str, rules: GearRules, design: Design) -> Iterator[Problem]:
    """Find keys that would put numbers of the standard in place of those that the material states itself."""
    material, standard = design.material(rules.material), rules.iso6336
    stated = [key for key in _OF_CLASS[1:] if getattr(material, key) is not None]
    for key, value in (("steel", material.steel), ("grade", material.grade), ("hardness_hv", None)):
        given = getattr(standard, key)
        if stated and given is not None and given != value:
            message = (
                f"{given!r} would replace what {material.name!r} states itself ({', '.join(stated)}); leave it out"
            )
            yield Problem(f"{path}.iso6336.{key}", message)


def _shafts(design: Design) -> Iterator[Problem]:
    """Find what shafts and carriers need of their material and it does not have."""
    name, given = design.shafting.material or design.gears.material, design.shafting.material is not None
    if name in design.known_materials:
        needed = ("yield_strength", "ultimate_strength", "group") if design.bearings else ("yield_strength",)
        purpose = "a shaft with bearings" if design.bearings else "a shaft"
        yield from _needs("shafting.material", name, needed, design, purpose)
    elif given:
        yield Problem("shafting.material", f"there is no material {name!r}; {near(name, design.known_materials)}")


def _needs(path: str, name: str, needed: Iterable[str], design: Design, purpose: str) -> Iterator[Problem]:
    """Find properties that a use needs and a material does not have."""
    known, needed = design.known_materials, tuple(needed)
    missing = [key for key in needed if getattr(known[name], key) is None]
    if not missing:
        return
    enough = [rich for rich, steel in known.items() if _has(steel, needed)]
    keys = ", ".join(WRITTEN.get(key, key) for key in missing)
    own = f"give {keys} under [materials.{name}], or " if name in design.materials else ""
    words = f"{name!r} has no {' and no '.join(missing)}, which {purpose} needs"
    yield Problem(path, f"{words}; {own}use one of {', '.join(enough)}")


def _has(steel: Material, needed: Iterable[str]) -> bool:
    return all(getattr(steel, key) is not None for key in needed)


# ----------------------------------------------------------------------------------------------------------------------
# What can be wrong with an oil and with flanks in it: that it thickens as it warms, and two words for one thing.
# ----------------------------------------------------------------------------------------------------------------------


ROUGHNESS_SCATTER = 2.0
"""Factor by which R_z/R_a may differ from 6, one way or the other, and still be of one surface [-]."""


def oil_problems(design: Design) -> Iterator[Problem]:
    """Yield every oil that is no thinner at 100 °C than at 40 °C, and oils and flanks that are told twice, not alike.

    Args:
        design: As typed.
    """
    yield from _thickens("oil.viscosity_100", design.oil.viscosity_40, design.oil.viscosity_100)
    own = {f"{design.table(name)}.": stage.gears for name, stage in design.stages.items()}
    for path, rules in {"": design.gears, **own}.items():
        if rules is not None:
            oil = rules.iso6336
            yield from _thickens(f"{path}gears.iso6336.oil_viscosity_100", oil.oil_viscosity, oil.oil_viscosity_100)
    yield from _two_oils(design)
    yield from _two_surfaces(design)


def _thickens(path: str, at_40: float, at_100: float | None) -> Iterator[Problem]:
    if at_100 is not None and at_100 >= at_40:
        message = f"{at_100:g} mm²/s at 100 °C is not below the {at_40:g} mm²/s at 40 °C; oils thin as they warm"
        yield Problem(path, message)


def _two_oils(design: Design) -> Iterator[Problem]:
    """Find rules of all gears that name another oil than [oil]; a stage may have one of its own."""
    rules, oil = design.gears.iso6336, design.oil
    for key, of_oil in {**GRADE_KEYS, **WARMTH_KEYS}.items():
        if key in rules.model_fields_set and of_oil in oil.model_fields_set:
            ours, its = getattr(rules, key), getattr(oil, of_oil)
            if ours != its:
                message = (
                    f"{ours:g} here and {its:g} in oil.{of_oil}; leave it out: the teeth take the oil of [oil]"
                    " (a stage with another oil says it in its own gears.iso6336)"
                )
                yield Problem(f"gears.iso6336.{key}", message)


def _two_surfaces(design: Design) -> Iterator[Problem]:
    """Find a roughness for losses that the flanks, as they are rated, do not have."""
    if "roughness" not in design.losses.model_fields_set:
        return
    stated = design.losses.roughness
    for name in design.stages:
        rules, table = design.rules(name), RATINGS[design.rating(name)].table
        tables: dict[str, Iso6336Rules | Agma2001Rules] = {"iso6336": rules.iso6336, "agma2001": rules.agma2001}
        standard = tables.get(table)
        if standard is None or "flank_roughness" not in standard.model_fields_set:
            continue
        by_depth = isinstance(standard, Iso6336Rules)
        rated = standard.flank_roughness / (RZ_OVER_RA if by_depth else 1.0)
        if not 1.0 / ROUGHNESS_SCATTER <= stated / rated <= ROUGHNESS_SCATTER:
            message = (
                f"R_a {1e6 * stated:g} µm, but the flanks of {name} are rated with {1e6 * rated:.3g} µm"
                f" (gears.{table}.flank_roughness{', R_z/6' if by_depth else ''}); leave it out, or say one"
            )
            yield Problem("losses.roughness", message)
            return
