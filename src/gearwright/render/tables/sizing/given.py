"""What the user gave in place of computed values, and how it is marked."""

from __future__ import annotations

from gearwright.render.grid.table import Mark, Table, table
from gearwright.sizing import MachineSizing, ShaftSizing, Sizing
from gearwright.spec.design import NOTHING_GIVEN, module_owners

_LAYOUT = {"stiffness": "torsional_stiffness"}
"""Field of a sized shaft -> its name in the layout, where they differ."""


def given_by_user(sizing: Sizing, record: object, field: str) -> Mark:
    """Return whether a value was computed, given by the user, or estimated.

    Args:
        sizing: With what is given of it.
        record: One of its records.
        field: Name of the field.
    """
    name, stage = getattr(record, "name", "") or str(getattr(record, "part", "")), getattr(record, "stage", "")
    owner = module_owners(sizing.design).get(stage, stage)
    paths = {f"{name}.{field}", f"{stage}.{field}"}
    if field == "module":
        paths.add(f"{owner}.module")
    if paths & set(sizing.given) or _in_design(sizing, record, field):
        return "given"
    if isinstance(record, MachineSizing) and field == "inertia" and not record.inertia_is_given:
        return "estimated"
    return ""


def _in_design(sizing: Sizing, record: object, field: str) -> bool:
    """Tell whether the design file itself states a value that would else be computed."""
    if isinstance(record, ShaftSizing):
        layout = sizing.design.layout.get(record.name, NOTHING_GIVEN)
        return getattr(layout, _LAYOUT.get(field, field), None) is not None
    if isinstance(record, MachineSizing) and field in ("mass", "inertia"):
        return getattr(sizing.design.machines[record.name], field, None) is not None
    return False


def overrides_table(sizing: Sizing) -> Table:
    """Return the values that the user gave in place of computed ones, with where they are from.

    Args:
        sizing: As sized.
    """
    return table("Given in place of computed values", list(sizing.given.values()), ("entry", "amount", "origin"))
