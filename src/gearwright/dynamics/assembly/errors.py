"""Errors of gears and shafts, as each mesh of a model feels them."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping
from dataclasses import replace

from gearwright.dynamics.model import Contact, Line, Model, contact_errors
from gearwright.errors import Problem, near, refuse
from gearwright.spec import GROUND
from gearwright.spec.design import PartErrors


def add_errors(model: Model, contacts: tuple[Contact, ...], parts: Mapping[str, PartErrors]) -> None:
    """Give every mesh the errors of its gears and shafts.

    Args:
        model: With every mesh as a line.
        contacts: From `contacts_of`.
        parts: Gear body, shaft or planet -> its errors.

    Raises:
        DesignError: If a part does not exist, or a clocking angle at which teeth do not go together.
    """
    refuse(_unknown(contacts, parts))
    by_line = {contact.line: contact for contact in contacts}
    refuse(
        problem for line in model.lines if line.name in by_line for problem in _jams(line, by_line[line.name], parts)
    )
    for number, line in enumerate(model.lines):
        if line.name in by_line:
            model.lines[number] = replace(line, errors=(*line.errors, *contact_errors(by_line[line.name], parts)))


def _unknown(contacts: tuple[Contact, ...], parts: Mapping[str, PartErrors]) -> Iterator[Problem]:
    known = {name for contact in contacts for side in contact.sides for name in (side.gear, side.shaft)} - {GROUND}
    for name in parts:
        if name not in known:
            yield Problem(f"errors.{name}", f"there is no such gear, shaft or planet; {near(name, known)}")


def _jams(line: Line, contact: Contact, parts: Mapping[str, PartErrors]) -> Iterator[Problem]:
    """Yield clocking angles at which the teeth of a mesh with backlash do not go together."""
    for side in contact.sides:
        moved = abs(side.lever * parts[side.gear].clocking) if side.gear in parts else 0.0
        if moved > line.backlash > 0.0:
            largest = math.degrees(line.backlash / abs(side.lever))
            message = (
                f"it moves the teeth of {line.name} by {moved * 1e6:.4g} µm, more than their backlash of "
                f"{line.backlash * 1e6:.4g} µm, so they do not go together; give at most {largest:.4g} deg"
            )
            yield Problem(f"errors.{side.gear}.clocking", message)
