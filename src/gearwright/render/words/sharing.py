"""The load sharing of a design for the terminal."""

from __future__ import annotations

from rich.console import Group, RenderableType
from rich.text import Text

from gearwright.dynamics.sharing import Allocation, SharingStudy
from gearwright.ranking import smallest_first
from gearwright.render.grid.grid import Grid

PERCENTILES = (50.0, 95.0, 99.0)
_UNITS = {"clocking": ("mrad", 1e-3)}


def sharing_text(study: SharingStudy) -> RenderableType:
    """Return the answers of a load-sharing study as text and tables.

    Args:
        study: From `sharing_study`.
    """
    parts: list[RenderableType] = [Text(line) for line in summary(study)]
    if study.influences:
        parts.append(_influences(study))
    if study.allocation is not None:
        parts.append(_allocation(study.allocation))
    return Group(*parts)


def summary(study: SharingStudy) -> list[str]:
    """Return the answers in a few sentences.

    Args:
        study: From `sharing_study`.
    """
    problem, sharing = study.problem, study.sharing
    count, cycle = len(problem.lines), sharing.tooth_cycle
    perfect = ", ".join(
        f"{name} {value / count:.2%}" for name, value in zip(problem.lines, problem.perfect, strict=True)
    )
    cycled = ", ".join(
        f"{name} {_range(low / count, high / count)}"
        for name, low, high in zip(problem.lines, cycle.min(axis=0), cycle.max(axis=0), strict=True)
    )
    lines = [
        f"{problem.stage}: {count} paths; loops of the load in the train: {problem.train.count}",
        f"without errors: {perfect}",
        f"with the errors as given: {cycled} over a tooth cycle, K_γ {sharing.load_factor:.3f} ({sharing.reason})",
    ]
    if problem.stated is not None:
        stated = ", ".join(f"{name} {share:.2%}" for name, share in zip(problem.lines, problem.stated, strict=True))
        lines.insert(1, f"stated in the design and taken by sizing: {stated}; all below is what stiffness makes of it")
    if not problem.shifts:
        lines.append("statically determinate: equilibrium alone shares the load, and no error shifts it")
    if study.distribution is not None and problem.shifts:
        shares = ", ".join(
            f"{percent:g} % below {study.distribution.percentile(percent):.2%}" for percent in PERCENTILES
        )
        lines.append(
            f"{len(study.distribution.peak)} gearboxes with random phases (seed {study.distribution.seed}): {shares}"
        )
    if study.clocking is not None:
        angles = ", ".join(f"{gear} {1e3 * angle:+.3f} mrad" for gear, angle in study.clocking.angles)
        window, target = 1e3 * study.clocking.window, study.clocking.target
        lines.append(f"equal without errors with clocking: {angles}; {target:.0%} within ±{window:.2f} mrad of it")
    return lines


def _range(low: float, high: float) -> str:
    """Return a share that changes, or stays, in per cent."""
    ends = (f"{low:.2%}", f"{high:.2%}")
    return " to ".join(dict.fromkeys(ends))


def _influences(study: SharingStudy) -> Grid:
    table = Grid("One error at a time")
    table.add_column("error")
    for header in ("size", "change of b [%]"):
        table.add_column(header, justify="right")
    table.add_column("")
    for influence in study.influences:
        effect = f"±{100.0 * influence.effect:.3f}"
        table.add_row(
            influence.source, _size(influence.kind, influence.size), effect, "turns" if influence.turns else "stays"
        )
    return table


def _size(kind: str, size: float) -> str:
    unit, scale = _UNITS.get(kind, ("µm", 1e-6))
    return f"{size / scale:.4g} {unit}"


def _allocation(allocation: Allocation) -> Grid:
    share = f"{100.0 * allocation.target:g}/{100.0 * (1.0 - allocation.target):g}"
    title = f"Tolerances for {share} in {allocation.percent:g} % of gearboxes (reached: {allocation.reached:.2%})"
    table = Grid(title)
    table.add_column("error")
    for header in ("given", "allowed"):
        table.add_column(header, justify="right")
    for row in smallest_first(allocation.sizes, lambda row: row.allowed / row.given):
        allowed = _size(row.kind, row.allowed) if row.allowed < row.given else "as given"
        table.add_row(row.error, _size(row.kind, row.given), allowed)
    return table
