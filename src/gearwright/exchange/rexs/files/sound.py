"""Whether the parts of a document hold together: relations name what is there, and nothing is a part of itself."""

from __future__ import annotations

from collections.abc import Iterator

from gearwright.errors import Problem, excerpt
from gearwright.exchange.rexs.files.document import Document

_WHOLES = {"assembly": ("assembly", "part"), "ordered_assembly": ("assembly", "part")}
"""Relation -> roles of the whole and of its part."""


def unsound(document: Document) -> list[Problem]:
    """Return what of a document refers to nothing, or to itself.

    Args:
        document: As read.
    """
    return [*_missing(document), *_cycles(document)]


def _missing(document: Document) -> Iterator[Problem]:
    """Yield references to components that are not there."""
    said = "there is no component with the id"
    for relation in document.relations:
        for role, number in relation.ends:
            if number not in document.components and number >= 0:
                path = f"relations.{excerpt(relation.kind)}.{excerpt(role)}"
                yield Problem(
                    path, f"{said} {number}; refer to one that is there, or remove the relation", relation.line
                )
    for case in document.cases:
        for number, component in case.items():
            if number not in document.components:
                yield Problem(
                    f"load_spectrum.{component.path}", f"{said} {number}; refer to one that is there", component.line
                )


def _cycles(document: Document) -> Iterator[Problem]:
    """Yield what is a part of itself, once for each circle."""
    parts: dict[int, list[int]] = {}
    lines: dict[tuple[int, int], int] = {}
    for relation in document.relations:
        roles = _WHOLES.get(relation.kind)
        if roles and all(role in relation.roles for role in roles):
            whole, part = (relation.roles[role] for role in roles)
            parts.setdefault(whole, []).append(part)
            lines.setdefault((whole, part), relation.line)
    done: set[int] = set()
    for start in parts:
        trail: list[int] = []
        stack = [(start, 0)]
        while stack:
            number, depth = stack.pop()
            del trail[depth:]
            if number in trail:
                circle = [*trail[trail.index(number) :], number]
                listed = " > ".join(map(str, circle))
                said = f"the components {listed} are parts of each other in a circle; remove one of the relations"
                yield Problem("relations.assembly", said, lines[circle[-2], number])
                continue
            if number in done:
                continue
            done.add(number)
            trail.append(number)
            stack += [(part, depth + 1) for part in parts.get(number, ())]
