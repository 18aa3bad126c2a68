"""What shakes a sized gearbox: peaks of a short run at the loads of every case, and resonances near its speeds."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from gearwright.checks import Check, not_assessed
from gearwright.dynamics.assembly import assemble
from gearwright.dynamics.motion import Outputs, simulate
from gearwright.dynamics.vibration.campbell import FACTORS
from gearwright.dynamics.vibration.critical_speeds import (
    SEPARATION,
    Criterion,
    CriticalSpeed,
    SpeedCase,
    critical_speeds,
)
from gearwright.dynamics.vibration.rated_peaks import DynamicLoad, dynamic_loads
from gearwright.errors import GearwrightError
from gearwright.identity import GEARBOX, Kind, PartId
from gearwright.sizing import Sizing

DURATION = 0.2
"""Of the run whose peaks are looked at [s]: that of ``gearwright run``."""
START = 0.25
"""Share of it that is left to the start [-]."""


def motion_checks(sizing: Sizing, speeds: Sequence[SpeedCase] | None = None) -> Iterator[Check]:
    """Yield every mesh at the worst peak of all cases, and of every order that excites one the nearest resonance.

    Args:
        sizing: As sized.
        speeds: Its `critical_speeds`; left out: found here.
    """
    yield from peak_checks(sizing)
    yield from resonance_checks(sizing, speeds)


def peak_checks(sizing: Sizing) -> Iterator[Check]:
    """Yield every mesh at the worst peak of all cases, each run for a while.

    Args:
        sizing: As sized.
    """
    peaks: dict[tuple[PartId, str], Check] = {}
    for case in sizing.flows:
        try:
            checks = [*_peaks(sizing, case)]
        except GearwrightError as error:  # the design is good without a run of this case; say why there is none
            yield not_assessed(GEARBOX, f"peaks in case {case}", "run", " ".join(str(error).split()))
            continue
        for check in checks:
            known = peaks.get((check.part, check.mode))
            if known is None or (check.margin or 0.0) < (known.margin or 0.0):
                peaks[check.part, check.mode] = check
    yield from peaks.values()


def _peaks(sizing: Sizing, case: str) -> Iterator[Check]:
    """Yield what the peaks of a run leave of the margins of every mesh."""
    trace = simulate(assemble(sizing, case), DURATION, outputs=Outputs(start=START * DURATION))
    parts = {mesh.name: mesh.part for mesh in sizing.meshes}
    for load in dynamic_loads(sizing, trace):
        yield _peak(parts[load.mesh], "peak bending", load, load.bending_margin, 1.0, case)
        yield _peak(parts[load.mesh], "peak contact", load, load.contact_margin, 2.0, case)


def _peak(part: PartId, mode: str, load: DynamicLoad, margin: float, power: float, case: str) -> Check:
    """Return the peak force beside the one that leaves just enough; contact stress grows with the root of the force."""
    allowed, clause = load.peak_force * margin**power, f"run of {DURATION:g} s"
    return Check(part, mode, clause, load.peak_force, allowed, "force", at_most=True, exponent=power, case=case)


def resonance_checks(sizing: Sizing, speeds: Sequence[SpeedCase] | None = None) -> Iterator[Check]:
    """Yield for every excited order its critical speed nearest to the operating speed.

    Args:
        sizing: As sized.
        speeds: Its `critical_speeds`; left out: found here.
    """
    try:
        cases = critical_speeds(sizing) if speeds is None else speeds
    except GearwrightError as error:
        yield not_assessed(GEARBOX, "resonances", "ISO 6336-1, clause 6", " ".join(str(error).split()))
        return
    for case in cases:
        for critical in case.nearest:
            if critical.criterion is not None:
                yield _resonance(case.cases, critical, critical.criterion)
    for case in cases:
        yield from _far_orders(case)


def _far_orders(speeds: SpeedCase) -> Iterator[Check]:
    """Yield the orders of machines that meet no natural frequency at any speed that is looked at."""
    met = {critical.order for critical in speeds.assumed}
    slowest, fastest = FACTORS[0], FACTORS[-1]
    for excitation in speeds.system.labels.orders:
        part = excitation.owner.part
        if part is not None and part.kind is Kind.MACHINE and excitation.name not in met:
            place = f"no natural frequency from {slowest:.1f} to {fastest:.1f} of its speed"
            yield Check(
                GEARBOX, f"resonance of {excitation.name}", SEPARATION.clause, 1.0 - 1.0 / fastest, SEPARATION.limit,
                "percent", exponent=None, place=place, case=speeds.cases,
            )  # fmt: skip


def _resonance(names: str, critical: CriticalSpeed, criterion: Criterion) -> Check:
    mode = f"resonance of {critical.order.replace('×', 'x')}"  # what a waiver calls it is typed on any keyboard
    return Check(
        GEARBOX, mode, criterion.clause, abs(critical.separation_margin), criterion.limit,
        "percent", exponent=None, place=f"mode {critical.mode}", case=names,
    )  # fmt: skip
