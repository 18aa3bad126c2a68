"""Values that the user gives in place of computed ones: by path in [overrides], or by a key in the table of their part.

Both places say the same. What can be given is seen from the design; sizing reads one table of it, path -> value.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import NamedTuple

from gearwright.errors import Problem, near
from gearwright.identity import SIDES
from gearwright.spec.bounds import range_of
from gearwright.spec.design.design import Design
from gearwright.spec.design.latest import of_the_latest
from gearwright.spec.design.shafts import NOTHING_GIVEN
from gearwright.spec.design.sharing import gear_owner, module_owners
from gearwright.spec.keys import Key as Written
from gearwright.spec.keys import keys_of
from gearwright.spec.record import Record
from gearwright.units import suffix_unit

NO_ORIGIN = "user's design file"
"""Origin of a value that the user gave without saying where it comes from."""
_OF_PAIRS = {
    "module": "module", "outer_module": "outer_module", "face_width": "face_width",
    "pinion_mass": "pinion.mass", "pinion_inertia": "pinion.inertia",
    "wheel_mass": "wheel.mass", "wheel_inertia": "wheel.inertia",
}  # fmt: skip
"""Key of a pair -> end of the path."""
_OF_SETS = {
    "module": "module", "face_width": "face_width",
    "sun_mass": "sun.mass", "sun_inertia": "sun.inertia", "planet_mass": "planet.mass",
    "planet_inertia": "planet.inertia", "ring_mass": "ring.mass", "ring_inertia": "ring.inertia",
    "pin_diameter": "pin_diameter", "plate_thickness": "plate_thickness", "eye_wall": "eye_wall",
    "carrier_mass": "carrier.mass", "carrier_inertia": "carrier.inertia",
}  # fmt: skip
"""Key of a planetary set -> end of the path."""
_OF_CARRIERS = ("pin_diameter", "plate_thickness", "eye_wall", "carrier_mass", "carrier_inertia")
"""Those of them that compound sets have, too."""
_OF_COMPOUND_GEARS = ("module", "face_width", "mass", "inertia")
"""Keys of a gear of a compound set."""
_OF_SHAFTS = ("length", "diameter", "mass")
"""Keys of a shaft's layout."""
WEIGHED = ("motors", "generators", "accessories")
"""Tables of machines that have a mass."""


class Key(NamedTuple):
    """A computed value that can be given."""

    path: str
    """Its name in [overrides], without the unit: ``first.carrier.mass``."""
    table: str
    """Table of the design file that has a key for it: ``planetaries.first``."""
    field: str
    """Of that table: ``carrier_mass``."""
    record: Record
    """What stands in that table; an empty one where the file has no such table."""

    @property
    def written(self) -> float | None:
        """What stands in its own table [SI]."""
        value: float | None = getattr(self.record, self.field)
        return value

    @property
    def entries(self) -> Mapping[str, Written]:
        """Name in [overrides] -> how a value is written under it."""
        stem = self.path.removesuffix(self.field)
        keys = {key: meant for key, meant in keys_of(type(self.record)).items() if meant.field == self.field}
        named = {key: meant for key, meant in keys.items() if meant.inverse}
        suffixed = {f"{self.path}_{meant.suffix}": meant for meant in keys.values() if not meant.inverse}
        return suffixed | {f"{stem}{key}": meant for key, meant in named.items()}


class _Entry(NamedTuple):
    """A name that [overrides] may have."""

    key: Key
    meant: Written


class Given(NamedTuple):
    """A value that the user gives in place of a computed one."""

    value: float
    """In SI."""
    entry: str
    """Where it stands: a path of [overrides], or a key with its table, each with a unit."""
    amount: float
    """In the unit of that entry."""
    origin: str = NO_ORIGIN
    """Where the user has it from."""


class GivenValues(NamedTuple):
    """Everything that a design gives in place of computed values."""

    values: Mapping[str, Given]
    """By path, without the unit."""
    problems: tuple[Problem, ...]
    """What names nothing, is given twice, or is none that a part has."""


@of_the_latest
def given_values(design: Design) -> GivenValues:
    """Return what a design gives in place of computed values, from both places.

    Args:
        design: As typed.
    """
    keys = list(givable(design))
    values = {key.path: _own(key, key.written) for key in keys if key.written is not None}
    problems = [*_without_effect(design)]
    if design.overrides or design.origins:
        entries = {name: _Entry(key, meant) for key in keys for name, meant in key.entries.items()}
        problems += _add_overrides(design, entries, values)
        problems += _add_origins(design, entries, values)
    return GivenValues(values, tuple(problems))


def _add_overrides(design: Design, entries: Mapping[str, _Entry], values: dict[str, Given]) -> Iterator[Problem]:
    """Put what [overrides] gives among the values, and yield what is wrong with it."""
    for entry, amount in design.overrides.items():
        fault = _fault(entry, amount, entries, values)
        if fault:
            yield Problem(f"overrides.{entry}", fault)
        else:
            key, meant = entries[entry]
            values[key.path] = Given(meant.si(amount), entry, amount)


def _add_origins(design: Design, entries: Mapping[str, _Entry], values: dict[str, Given]) -> Iterator[Problem]:
    """Put where values come from beside them, and yield what belongs to none."""
    for entry, origin in design.origins.items():
        path = entries[entry].key.path if entry in entries else ""
        if path in values:
            values[path] = values[path]._replace(origin=origin)
        elif entry not in design.overrides:
            known = [name for name, (key, _) in entries.items() if key.path in values]
            yield Problem(f"origins.{entry}", f"nothing of this name is given; {near(entry, known)}")


def _own(key: Key, value: float) -> Given:
    meant = next(iter(key.entries.values()))
    return Given(value, f"{key.table}.{key.field}_{meant.suffix}", meant.written(value))


def _fault(entry: str, amount: float, entries: Mapping[str, _Entry], values: Mapping[str, Given]) -> str | None:
    """Return what is wrong with an entry of [overrides], if anything is."""
    if entry not in entries:
        usual = {key.path: name for name, (key, _) in reversed(list(entries.items()))}
        return f"nothing of this name is computed; {near(entry, entries, usual.values())}"
    key, meant = entries[entry]
    allowed = range_of(type(key.record).model_fields[key.field])
    if not allowed.holds(meant.si(amount)):
        return f"{amount:g} {suffix_unit(meant.suffix)} is not allowed; give {meant.words(allowed)}"
    if key.path in values:
        first = values[key.path].entry
        place = f"overrides.{first}" if first in entries else first
        return f"{key.path} is given twice: here, and as {place}; keep one of the two"
    return None


def givable(design: Design) -> Iterator[Key]:
    """Yield everything that is computed of a design and can be given.

    Args:
        design: As typed.
    """
    owners = module_owners(design)
    yield Key("gearbox.mass", "gearbox", "mass", design.gearbox)
    for name, pair in design.pairs.items():
        idle = {field for field, _ in _idle(design, name, owners[name])}
        yield from (Key(f"{name}.{end}", f"pairs.{name}", f, pair) for f, end in _OF_PAIRS.items() if f not in idle)
    for name, planetary in design.planetaries.items():
        yield from (Key(f"{name}.{end}", f"planetaries.{name}", f, planetary) for f, end in _OF_SETS.items())
    yield from _of_compounds(design)
    for name in design.shafts:
        layout = design.layout.get(name, NOTHING_GIVEN)
        yield from (Key(f"{name}.{field}", f"layout.{name}", field, layout) for field in _OF_SHAFTS)
    for table in WEIGHED:
        for name, machine in getattr(design, table).items():
            yield Key(f"{name}.mass", f"{table}.{name}", "mass", machine)


def _of_compounds(design: Design) -> Iterator[Key]:
    """Yield what can be given of compound sets: of every gear, of the carrier and of its pins."""
    for name, epicyclic in design.epicyclics.items():
        table = f"epicyclics.{name}"
        for kind, gears in (("suns", epicyclic.suns), ("rings", epicyclic.rings), ("planets", epicyclic.planets)):
            for gear_name, gear in gears.items():
                place = f"{table}.{kind}.{gear_name}"
                yield from (Key(f"{name}.{gear_name}.{field}", place, field, gear) for field in _OF_COMPOUND_GEARS)
        yield from (Key(f"{name}.{end}", table, f, epicyclic) for f, end in _OF_SETS.items() if f in _OF_CARRIERS)


def _idle(design: Design, name: str, owner: str) -> Iterator[tuple[str, str]]:
    """Yield the keys of a pair that give nothing, and why: its module or its gear is another's."""
    is_bevel = design.pairs[name].kind == "bevel"
    if is_bevel or owner != name:
        why = "a bevel pair has an outer_module" if is_bevel else f"it has the module of pairs.{owner}; give it there"
        yield "module", why
    if not is_bevel or owner != name:
        why = f"it has that of pairs.{owner}; give it there" if is_bevel else "only a bevel pair has one"
        yield "outer_module", why
    for side in SIDES:
        gear = gear_owner(design, name, side)
        if gear != name:
            why = f"the gear is that of pairs.{gear}; give it there"
            yield from ((f"{side}_mass", why), (f"{side}_inertia", why))


def _without_effect(design: Design) -> Iterator[Problem]:
    """Yield every key of a pair that is written and gives nothing."""
    owners = module_owners(design)
    for name, pair in design.pairs.items():
        for field, why in _idle(design, name, owners[name]):
            if getattr(pair, field) is not None:
                yield Problem(f"pairs.{name}.{field}", f"has no effect: {why}")
