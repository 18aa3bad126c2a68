"""Which components of a document turn as one: shafts, carriers and plates that couplings join, and the housing."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field, replace

from gearwright.errors import Problem
from gearwright.exchange.rexs.files import Attribute, Component, Document
from gearwright.exchange.rexs.reading.asking import Asking
from gearwright.spec import GROUND, LONGEST_NAME

RIGID = (
    "coupling", "feather_key_connection", "cylindrical_interference_fit", "tapered_interference_fit",
    "involute_spline_connection",
)  # fmt: skip
"""Components that let their sides turn as one."""
MOST_GEARS = 24
"""Most gears of a transmission that become load cases [-]."""
LONGEST = 40
"""Longest name of a component that a design takes up; a longer one is a sentence [-]."""


@dataclass
class Bodies:
    """Components that turn as one, and what bodies are called."""

    asking: Asking
    joined: dict[int, int] = field(default_factory=dict)
    """Component -> another of its body, or itself."""
    names: dict[int, str] = field(default_factory=dict)
    """First component of a body -> its name in the design."""
    taken: set[str] = field(default_factory=lambda: {GROUND})
    """Names of the design so far."""

    def of(self, number: int) -> int:
        """Return the component that speaks for a body.

        Args:
            number: One of its components.
        """
        while (following := self.joined.get(number, number)) != number:
            number = following
        return number

    def join(self, first: int, second: int) -> None:
        """Make one body of two; the first speaks for it.

        Args:
            first: A component.
            second: Another one.
        """
        if self.of(first) != self.of(second):
            self.joined[self.of(second)] = self.of(first)

    def name(self, number: int) -> str:
        """Return what the design calls the body of a component.

        Args:
            number: Of the component.
        """
        body = self.of(number)
        if body not in self.asking.document.components:
            return GROUND  # of a gear without a shaft, which is refused
        if body not in self.names:
            self.names[body] = self.new_name(self.asking.document.components[number])
        return self.names[body]

    def name_of(self, number: int) -> str | None:
        """Return what the design calls the body of a component; None of one that nothing asked the name of.

        Args:
            number: Of the component.
        """
        return self.names.get(self.of(number))

    def new_name(self, component: Component) -> str:
        """Return a name for a component that nothing else has.

        Args:
            component: To be called so.
        """
        told = component.name if len(component.name) <= LONGEST else ""
        plain = "".join(mark if mark.isalnum() else " " for mark in told or component.kind)
        stem = "-".join(plain.split())[: LONGEST_NAME - 4].strip("-") or component.kind
        name = next(name for name in _numbered(stem) if name not in self.taken)
        self.taken.add(name)
        return name


def _numbered(stem: str) -> Iterator[str]:
    yield stem
    yield from (f"{stem}-{k}" for k in range(2, 10_000))


def bodies_of(asking: Asking) -> Bodies:
    """Return what of a document turns as one.

    Args:
        asking: The document.
    """
    document = asking.document
    bodies = Bodies(asking)
    for casing in document.of_kind("gear_casing"):
        bodies.join(document.of_kind("gear_casing")[0].number, casing.number)
    for carrier in document.of_kind("planet_carrier"):
        for part in document.related("assembly", "assembly", carrier.number, "part"):
            bodies.join(carrier.number, part)
    for coupling in document.of_kind(*RIGID, "switchable_coupling"):
        if coupling.kind in RIGID or all(holds(asking, coupling)):
            _couple(bodies, coupling)
    for casing in document.of_kind("gear_casing"):
        bodies.names[bodies.of(casing.number)] = GROUND
    return bodies


def holds(asking: Asking, coupling: Component) -> tuple[bool, ...]:
    """Return whether a switchable coupling is engaged, load case by load case.

    Args:
        asking: The document.
        coupling: Of it.
    """
    cases = asking.document.cases or ({},)
    return tuple(_held(asking, coupling, case) for case in cases)


def _held(asking: Asking, coupling: Component, case: Mapping[int, Component]) -> bool:
    """Tell whether a coupling is engaged in a case; of one that says so gear by gear, in the gear of the case."""
    spoken = [said for said in (case.get(coupling.number), coupling) if said is not None]
    for said in spoken:
        found = asking.attribute(said, "is_engaged")
        if found is not None and (found.text or found.cells):
            place = _gear_of(asking, case) - 1
            return (found.text or found.cells[place if place < len(found.cells) else 0]) == "true"
    return False


def _gear_of(asking: Asking, case: Mapping[int, Component]) -> int:
    """Return which of its gears a transmission is in, counted from 1 [-]."""
    units = asking.document.of_kind("gear_unit")
    for said in (*(case[unit.number] for unit in units if unit.number in case), *units):
        text = asking.text(said, "gear_shift_index")
        if text.isascii() and text.isdigit() and int(text) > 0:
            return int(text)
    return 1


def with_gears(document: Document) -> Document:
    """Return a document in which each gear of a transmission is a load case, where it has no load cases.

    Args:
        document: As read.
    """
    units = [unit for unit in document.of_kind("gear_unit") if "number_of_gears" in unit.attributes]
    couplings = document.of_kind("switchable_coupling")
    shifts = any("is_engaged" in one.attributes and len(one.attributes["is_engaged"].cells) > 1 for one in couplings)
    if document.cases or not units or not shifts:
        return document
    unit, count = units[0], units[0].attributes["number_of_gears"].text
    if not (count.isascii() and count.isdigit() and 1 < int(count) <= MOST_GEARS):
        return document
    said = [{"gear_shift_index": Attribute(str(gear), (), "none", unit.line)} for gear in range(1, int(count) + 1)]
    cases = tuple({unit.number: Component(unit.number, unit.kind, "", unit.line, index)} for index in said)
    return replace(document, cases=cases)


def _couple(bodies: Bodies, coupling: Component) -> None:
    """Join both sides of a coupling."""
    relations = [relation for relation in bodies.asking.document.relations
                 if relation.kind == "side" and relation.roles.get("assembly") == coupling.number]  # fmt: skip
    bodies.asking.used.add(coupling.number)
    for relation in relations:
        ends = [relation.roles.get(role) for role in ("inner_part", "outer_part")]
        if None in ends:
            said = f"joins {len(relation.roles) - 1} part; give an inner_part and an outer_part"
            bodies.asking.problems.append(Problem("relations.side", said, relation.line))
            continue
        inner, outer = (end for end in ends if end is not None)
        kind = bodies.asking.document.components[outer].kind
        bodies.join(*((outer, inner) if kind == "gear_casing" else (inner, outer)))
