"""Where the power of every case goes, as tables: by origin, and part by part for the first case."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from typing import Annotated

from gearwright.render.grid.table import Table, table
from gearwright.sizing import Sizing
from gearwright.sizing.losses import ORIGINS, Loss, LossBalance, loss_balance
from gearwright.spec import Design
from gearwright.units import Origin, Power, Quantity

_NAMED = 3
"""Parts that a note names; more are counted [-]."""
_NOTE = (
    "; the torques of the case do not know them, but gears.mesh_efficiency. Bearings of unknown size rub by a constant"
    " coefficient."
)


def _note(design: Design) -> str:
    """Say by what the losses are: whose oil, and that it is assumed where the design says none."""
    oil = design.oil
    kind = "the oil of [oil]" if "oil" in design.model_fields_set else "an assumed turbine oil, as [oil] is left out"
    degrees = oil.temperature
    return f"By the formulas of [losses], with {kind}: {oil.viscosity_40:g} mm²/s at 40 °C, {degrees:g} °C{_NOTE}"


@dataclass(frozen=True)
class LossesOfCase:
    """What one case loses, by origin."""

    case: str
    power: Power
    """Into the gearbox [W]."""
    meshes: Power
    """[W]"""
    bearings: Power
    """[W]"""
    windage: Power
    """[W]"""
    churning: Power
    """[W]"""
    seals: Power
    """[W]"""
    lost: Power
    """In all [W]."""
    efficiency: Annotated[float, Quantity("ratio"), Origin("η = 1 − Σ P_V/P_in", "[losses] of the design")]
    """[-]"""


def losses_of_cases(sizing: Sizing) -> tuple[LossesOfCase, ...]:
    """Return what every case loses, by origin.

    Args:
        sizing: As sized.
    """
    return tuple(_row(loss_balance(sizing, case)) for case in sizing.flows)


def _limits(losses: Iterable[Loss]) -> str:
    """Say of which losses the formula is at a limit, and at which: every limit once, with the parts that have it."""
    held: dict[str, list[str]] = {}
    for loss in losses:
        if loss.limit:
            held.setdefault(loss.limit, []).append(loss.part)
    return "".join(f" {_parts(parts)}: {limit}." for limit, parts in held.items())


def _parts(names: list[str]) -> str:
    return ", ".join(names) if len(names) <= _NAMED else f"{names[0]} and {len(names) - 1} more"


def _row(balance: LossBalance) -> LossesOfCase:
    parts = dict.fromkeys(ORIGINS, 0.0) | balance.by_origin()
    return LossesOfCase(balance.case, balance.power, **parts, lost=balance.lost, efficiency=balance.efficiency)


def loss_tables(sizing: Sizing) -> dict[str, Table]:
    """Return the tables of losses by a short name.

    Args:
        sizing: As sized.
    """
    fields = ("case", "power", *ORIGINS, "lost", "efficiency")
    losses = loss_balance(sizing).losses
    limits = ("limit",) if any(loss.limit for loss in losses) else ()
    columns = ("origin", "part", "count", "power", "share", "method", *limits)
    return {
        "losses": table(
            "Losses by origin", losses_of_cases(sizing), fields, note=_note(sizing.design) + _limits(losses)
        ),
        "loss_parts": table("Losses part by part", losses, columns, note=f"Case {sizing.reference.case}."),
    }
