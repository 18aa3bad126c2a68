"""What can be wrong with materials: half of one, two numbers that disagree, and what a use needs and it lacks."""

from __future__ import annotations

from collections.abc import Iterable, Iterator

from gearwright.catalogue import gear_steel_names, hardnesses_of, is_cast_iron, material_of, materials, rated_steel
from gearwright.errors import DesignError, Problem, near
from gearwright.parts import Material
from gearwright.parts.iso6336 import GearSteel
from gearwright.spec.design import RATINGS, Design, GearRules, LifeLineRules, MaterialRules, WheelSteel
from gearwright.spec.keys import keys_of

STEEL_KEYS = {"material": "steel", "grade": "grade", "hardness": "hardness_hv"}
"""What the table of steels complains of -> key of the design file."""
SCALES = {"hardness_hv": "HV", "hardness_hb": "HB", "hardness_hrc": "HRC"}
AGREEMENT = 0.08
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
    yield from _strengths(rules)
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


def _strengths(rules: MaterialRules) -> Iterator[tuple[str, str]]:
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
        if abs(other / first - 1.0) > AGREEMENT:
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
