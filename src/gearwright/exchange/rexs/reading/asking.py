"""Asking a document for numbers and texts: units are held against REXS, and what nobody asked for is listed."""

from __future__ import annotations

import math
from collections.abc import Iterable
from dataclasses import dataclass, field

from gearwright.errors import Problem, excerpt
from gearwright.exchange.rexs.files import Attribute, Component, Document
from gearwright.exchange.rexs.words import UNITS, spellings, words

FORMER = {
    "radial_dynamic_load_rating": ("dynamic_capacity",),
    "operating_time_fraction": ("load_duration_fraction",),
    "application_factor_iso_6336_2019": ("application_factor_iso_6336_2006",),
    "mesh_load_factor_iso_6336_2019": ("mesh_load_factor_iso_6336_2006",),
    "allowable_stress_number_contact_iso_6336_2016": ("endurance_limit_flank",),
    "nominal_stress_number_tooth_root_iso_6336_2016": ("endurance_limit_root",),
    "catalogue_designation": ("name",),
    "radial_static_load_rating": ("static_capacity",),
}
"""Attribute -> names that it had in former versions, or that others write for it."""
GEOMETRY = {"reference_component_for_position", "w_axis_vector"}
"""Attributes that say where a component stands, which other attributes say, too."""


@dataclass
class Asking:
    """A document, what of it was read, and what is wrong with it."""

    document: Document
    problems: list[Problem] = field(default_factory=list)
    notes: list[str] = field(default_factory=list)
    """What was assumed."""
    asked: set[int] = field(default_factory=set)
    """Identities of the attributes that were read."""
    used: set[int] = field(default_factory=set)
    """Ids of the components that were understood."""

    def number(self, component: Component, name: str) -> float | None:
        """Return a number in SI, or None where it is not written.

        Args:
            component: That has it, or what a load case says of it.
            name: Of the attribute.
        """
        found = self.attribute(component, name)
        if found is None or (not found.text and not found.cells):
            return None
        factor = self._factor(component, name, found)
        return None if factor is None else self._parsed(component, name, found, found.text, factor)

    def needed(self, component: Component, name: str) -> float:
        """Return a number in SI; where it is missing that is a problem, and 1 stands for it.

        Args:
            component: That must have it.
            name: Of the attribute.
        """
        known = len(self.problems)
        value = self.number(component, name)
        if value is None:
            if len(self.problems) == known:
                said = f"is missing; give it in {words()[name].unit}"
                self.problems.append(Problem(f"{component.path}.{name}", said, component.line))
            return 1.0
        return value

    def vector(self, component: Component, name: str) -> tuple[float, ...] | None:
        """Return numbers in SI, or None where they are not written.

        Args:
            component: That has them.
            name: Of the attribute.
        """
        found = self.attribute(component, name)
        factor = None if found is None else self._factor(component, name, found)
        if found is None or factor is None:
            return None
        numbers = [self._parsed(component, name, found, cell, factor) for cell in found.cells]
        return tuple(number for number in numbers if number is not None)

    def text(self, component: Component, name: str) -> str:
        """Return a text, empty where it is not written; of an array its first entry.

        Args:
            component: That has it.
            name: Of the attribute.
        """
        found = self.attribute(component, name)
        return "" if found is None else found.text or next(iter(found.cells), "")

    def attribute(self, component: Component, name: str) -> Attribute | None:
        """Return an attribute by its name or a former one, and count it as read.

        Args:
            component: That may have it.
            name: Of the attribute.
        """
        for spelling in (name, *FORMER.get(name, ())):
            if spelling in component.attributes:
                found = component.attributes[spelling]
                self.asked.add(id(found))
                return found
        return None

    def _factor(self, component: Component, name: str, found: Attribute) -> float | None:
        """Return what a unit is in SI; None where it is missing or measures something else."""
        wanted = UNITS[words()[name].unit].dimension
        if wanted == "number" and (found.unit or "") in ("", "none"):
            return 1.0
        unit = UNITS.get(found.unit or "")
        if unit is not None and unit.dimension == wanted and found.unit:
            return unit.factor
        said = f"is in {excerpt(found.unit)!r}" if found.unit else "has no unit"
        allowed = " or ".join(spellings(wanted)) if wanted != "number" else "none or %"
        self.problems.append(Problem(f"{component.path}.{name}", f"{said}; allowed: {allowed}", found.line))
        return None

    def _parsed(self, component: Component, name: str, found: Attribute, text: str, factor: float) -> float | None:
        try:
            value = float(text)
        except ValueError:
            value = math.nan
        if math.isfinite(value):
            return value * factor
        said = f"is {excerpt(text)!r}; give a number"
        self.problems.append(Problem(f"{component.path}.{name}", said, found.line))
        return None

    def refuse(self, component: Component, said: str) -> None:
        """Note that a component cannot be read.

        Args:
            component: What is wrong.
            said: Why, and what to do.
        """
        self.problems.append(Problem(component.path, said, component.line))

    def unread(self) -> tuple[str, ...]:
        """Return every kind of attribute and component that nobody asked for, with its first place and its count."""
        places: dict[str, list[tuple[str, int]]] = {}
        spoken = [*self.document.components.values(), *(said for case in self.document.cases for said in case.values())]
        for component in spoken:
            if component.number not in self.used:
                places.setdefault(component.kind, []).append((component.path, component.line))
                continue
            for name, attribute in component.attributes.items():
                if id(attribute) not in self.asked and name not in GEOMETRY:
                    key = f"{component.kind}.{name}"
                    places.setdefault(key, []).append((f"{component.path}.{name}", attribute.line))
        return tuple(_listed(found) for found in places.values())


def _listed(places: Iterable[tuple[str, int]]) -> str:
    (path, line), *others = places
    return f"line {line}: {path}" + (f" and {len(others)} more of its kind" if others else "")
