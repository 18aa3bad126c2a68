"""Whether teeth and planets stay out of the bands of frequencies that the design forbids, in every case of each."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from operator import attrgetter

from gearwright.checks import Check
from gearwright.identity import Kind, PartId
from gearwright.sizing.rating import Context
from gearwright.spec.design import ForbiddenBand, cases_forbidding
from gearwright.train import Mesh, passes

CLAUSE = "design, [teeth.forbidden]"
_PASS = {"mesh": "mesh frequency", "planet-pass": "planet pass"}


def pass_checks(context: Context) -> Iterator[Check]:
    """Yield of every forbidden band and every row that passes at all how far the nearest frequency of a case is off.

    Args:
        context: What sizing reads.
    """
    for name, band in context.design.teeth.forbidden.items():
        rows: dict[str, list[Check]] = {}
        for case in cases_forbidding(context.design, band):
            for mesh, frequency in passes(context.design, context.train, context.teeth, context.flows[case], band.of):
                part = _part(context, mesh)
                for harmonic in range(1, band.harmonics + 1):
                    check = _held(part, name, band, harmonic * frequency, case=case)
                    where = "" if harmonic == 1 else f"{harmonic} times"
                    rows.setdefault(mesh.name, []).append(replace(check, place=where))
        yield from (min(checks, key=attrgetter("ratio")) for checks in rows.values())


def _part(context: Context, mesh: Mesh) -> PartId:
    """Return the stage of a row, where no other row of it is alike, or else the row."""
    alike = [row for row in context.train.meshes if (row.stage, row.row) == (mesh.stage, mesh.row)]
    return PartId(Kind.STAGE, mesh.stage) if len(alike) == 1 else mesh.part


def _held(part: PartId, name: str, band: ForbiddenBand, frequency: float, *, case: str) -> Check:
    """Return one frequency against the nearer end of a band; inside it, against the one that is sooner reached."""
    below = bool(band.lowest / frequency >= frequency / band.highest)
    return Check(
        part, f"{_PASS[band.of]} in {name}", CLAUSE, frequency, band.lowest if below else band.highest, "frequency",
        at_most=below, exponent=None, symbol="f", case=case, why=band.reason,
    )  # fmt: skip
