"""Whose the coordinates, lines and numbers of a stored run are: a line of text for each, and for runs without them."""

from __future__ import annotations

import json
from collections.abc import Iterable, Sequence

from gearwright.dynamics.assembly import assemble
from gearwright.dynamics.model import NOBODY, Excitation, Owner
from gearwright.identity import Kind, PartId, Role, Row
from gearwright.sizing import size
from gearwright.spec import Design


def written_owners(owners: Iterable[Owner]) -> str:
    """Return owners as text, one a line.

    Args:
        owners: Of coordinates, lines or numbers of drives.
    """
    return "\n".join(json.dumps([owner.what, *(owner.part or ())]) for owner in owners)


def read_owners(text: str) -> tuple[Owner, ...]:
    """Return owners as they were.

    Args:
        text: From `written_owners`.
    """
    return tuple(_owner(json.loads(line)) for line in text.splitlines())


def _owner(record: object) -> Owner:
    match record:
        case [str(what)]:
            return Owner(None, what)
        case [str(what), str(kind), str(name), None | str() as role, str(branch), None | int() as number, *words]:
            which = None if role is None else Row(role) if kind == Kind.MESH else Role(role)
            return Owner(PartId(Kind(kind), name, which, branch, number, *map(str, words)), what)
    raise ValueError(f"{record} is no owner")


def written_orders(orders: Iterable[Excitation]) -> str:
    """Return orders of machines and teeth as text.

    Args:
        orders: As labelled.
    """
    rows = list(orders)
    return json.dumps({"rows": [row[:5] for row in rows], "owners": written_owners(row.owner for row in rows)})


def read_orders(text: str) -> tuple[Excitation, ...]:
    """Return orders from their text.

    Args:
        text: From `written_orders`; empty: none.
    """
    if not text:
        return ()
    stored = json.loads(text)
    return tuple(
        Excitation(name, tuple((body, float(times)) for body, times in turns), tuple(on), why, float(rate), owner)
        for (name, turns, on, why, rate), owner in zip(stored["rows"], read_owners(stored["owners"]), strict=True)
    )


def found_owners(
    coordinates: Sequence[str], lines: Sequence[str], design: Design | None, case: str
) -> tuple[tuple[Owner, ...], tuple[Owner, ...]]:
    """Return the owners of coordinates and lines of a run that was stored without them: those of its design.

    Args:
        coordinates: Names.
        lines: Names.
        design: That made the run; None where it is not known.
        case: Load case.
    """
    if design is None:
        return (NOBODY,) * len(coordinates), (NOBODY,) * len(lines)
    labels = assemble(size(design), case).labels
    of_coordinate = dict(zip(labels.coordinates, labels.coordinate_owners, strict=True))
    of_line = dict(zip(labels.lines, labels.line_owners, strict=True))
    owners = tuple(of_coordinate.get(name, NOBODY) for name in coordinates)
    return owners, tuple(of_line.get(name, NOBODY) for name in lines)
