"""What stands in a REXS file, as records: components, their attributes, relations, load cases, with their lines."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from functools import cached_property


@dataclass(frozen=True)
class Attribute:
    """An attribute as written."""

    text: str
    """Of a plain one; empty where it holds several."""
    cells: tuple[str, ...]
    """Of an array or a matrix, one after the other."""
    unit: str | None
    """None where none is written."""
    line: int
    """Counted from 1 [-]."""


@dataclass(frozen=True)
class Component:
    """A component, or what a load case says of it."""

    number: int
    """Its id [-]."""
    kind: str
    """Its type, such as ``shaft``."""
    name: str
    line: int
    """Counted from 1 [-]."""
    attributes: Mapping[str, Attribute] = field(default_factory=dict)

    @property
    def path(self) -> str:
        """Where it stands, for messages."""
        return f"components.{self.kind}[{self.number}]"


@dataclass(frozen=True)
class Relation:
    """What belongs together."""

    kind: str
    """Its type, such as ``assembly``."""
    ends: tuple[tuple[str, int], ...]
    """Roles, and the ids of what plays them, as written."""
    line: int
    """Counted from 1 [-]."""

    @property
    def roles(self) -> dict[str, int]:
        """Role -> id."""
        return dict(self.ends)


@dataclass(frozen=True)
class Document:
    """A REXS file."""

    version: str
    application: str
    """Name and version of what wrote it."""
    components: Mapping[int, Component]
    """By id."""
    relations: tuple[Relation, ...]
    cases: tuple[Mapping[int, Component], ...]
    """Load cases of all spectra: what each says, by the id of the component."""
    accumulations: int = 0
    """Results over whole spectra, which are not read [-]."""

    def of_kind(self, *kinds: str) -> list[Component]:
        """Return all components of some types.

        Args:
            kinds: Such as ``shaft``.
        """
        return [component for component in self.components.values() if component.kind in kinds]

    def related(self, kind: str, role: str, number: int, other: str) -> list[int]:
        """Return what stands opposite a component in all relations of a type.

        Args:
            kind: Type of the relations.
            role: That the component plays.
            number: Id of the component.
            other: Role of what is returned.
        """
        return [roles[other] for roles in self._related.get((kind, role, number), ()) if other in roles]

    @cached_property
    def _related(self) -> dict[tuple[str, str, int], list[dict[str, int]]]:
        """Type of relation, role and component -> the relations in which it plays that role."""
        found: dict[tuple[str, str, int], list[dict[str, int]]] = {}
        for relation in self.relations:
            for role, number in relation.roles.items():
                found.setdefault((relation.kind, role, number), []).append(relation.roles)
        return found
