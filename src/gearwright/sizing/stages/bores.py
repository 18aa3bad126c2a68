"""Bores that a design gives, against the roots of the teeth around them."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from gearwright.errors import Problem, refuse
from gearwright.sizing.blanks import WALL
from gearwright.sizing.rating import Context, bore_of
from gearwright.sizing.result import GearSizing
from gearwright.spec import Epicyclic


def refuse_bores(context: Context, gears: Sequence[GearSizing]) -> None:
    """Refuse bores that leave no rim under the teeth.

    Args:
        context: What gear sizing reads.
        gears: As sized.

    Raises:
        DesignError: With the key of every such bore, and the most that leaves a rim.
    """
    refuse(_problems(context, gears))


def _problems(context: Context, gears: Sequence[GearSizing]) -> Iterator[Problem]:
    design = context.design
    for gear in gears:
        bore = bore_of(design, context.train.gear(gear.name))
        if bore is None or gear.name in context.train.internal:
            continue
        root = gear.pitch_diameter - 2.0 * (1.25 - gear.profile_shift) * gear.module
        most = root - 2.0 * WALL * gear.module
        if bore > most:
            stage = design.stages[gear.stage]
            own = (
                f"{gear.role.value}s.{gear.own}.bore_mm"
                if isinstance(stage, Epicyclic)
                else f"{gear.role.value}_bore_mm"
            )
            why = (
                f"{1e3 * bore:.4g} mm in roots of {1e3 * root:.4g} mm leave no rim under the teeth of {gear.name}"
                f" (z {gear.teeth}, m_n {1e3 * gear.module:.4g} mm); give {1e3 * most:.4g} mm or less"
            )
            yield Problem(f"{design.table(gear.stage)}.{own}", why)
