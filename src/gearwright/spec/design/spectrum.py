"""Which load cases a design has, and what share of its life each lasts."""

from __future__ import annotations

from collections.abc import Mapping

from gearwright.spec.design.design import Design
from gearwright.spec.design.duty import Case, Drive
from gearwright.spec.design.latest import of_the_latest
from gearwright.spec.design.rules import ForbiddenBand

RATED = "rated"
"""Name of the one case of a design without cases: each machine at its rated power."""
_ALONE = Case()


def cases_of(design: Design) -> tuple[str, ...]:
    """Return the names of the cases that size a design; the first speaks for it: ``rated``, or the first that lasts.

    Args:
        design: With its cases, or none.
    """
    return tuple(sorted(design.cases, key=lambda name: (name != RATED, design.cases[name].static))) or (RATED,)


def cases_forbidding(design: Design, band: ForbiddenBand) -> tuple[str, ...]:
    """Return the names of the cases in which a forbidden band of frequencies holds: those named, or all that last.

    Args:
        design: With its cases, or none.
        band: Of the rules for its teeth.
    """
    named = cases_of(design) if band.cases is None else band.cases
    return tuple(case for case in named if band.cases is not None or not case_named(design, case).static)


def case_named(design: Design, case: str) -> Case:
    """Return a case of a design.

    Args:
        design: With its cases, or none.
        case: Name of one of them, or ``rated``.
    """
    return design.cases.get(case, _ALONE)


def drives_of(design: Design, case: str) -> Mapping[str, Drive]:
    """Return what every machine does in a case.

    Args:
        design: With its machines.
        case: Name of one of its cases; any other is the one of a design without cases.
    """
    drives = _drives(design)
    return drives[case if case in drives else ""]


@of_the_latest
def _drives(design: Design) -> dict[str, dict[str, Drive]]:
    """Return case -> what every machine does in it; under an empty name what it does in a design without cases."""
    machines = design.machines
    alone = {"": {name: machine.fully for name, machine in machines.items()}}
    return alone | {
        case: {
            name: _drive(machine.unsaid, said.machines[name], machine.rating)
            if name in said.machines
            else machine.unsaid
            for name, machine in machines.items()
        }
        for case, said in design.cases.items()
    }


def _drive(unsaid: Drive, said: Drive, rating: float | None) -> Drive:
    """Return what a machine does that a case names: what it says, or what is usual at the speed that it says."""
    if said.rating is not None:
        return Drive.model_construct(power=said.rating * (rating or 0.0), speed=said.speed)
    if said.stated or said.balances:
        return said
    if unsaid.idles:
        return Drive.model_construct(balances=True, speed=said.speed)
    return unsaid.model_copy(update={"speed": said.speed})


def levels_of(design: Design, case: str) -> tuple[tuple[float, float], ...]:
    """Return the levels of a case: part of its loads [-], share of its time [-]; of a static case its own alone.

    Args:
        design: With its cases and spectra.
        case: Name of one of its cases, or ``rated``.
    """
    said = case_named(design, case)
    name = None if said.static else said.spectrum or design.service.spectrum
    if name is None:
        return ((1.0, 1.0),)
    return tuple(zip(design.spectra[name].load, design.spectra[name].share, strict=True))


def shares_of(design: Design) -> Mapping[str, float]:
    """Return case -> share of the life [-]; empty where none is said: then one case lasts all of it.

    Args:
        design: With its service and its cases.
    """
    lasting = {name: case for name, case in design.cases.items() if not case.static}
    if design.service.shares or not lasting:
        return design.service.shares
    durations = [case.duration for case in lasting.values()]
    whole = sum(duration or 0.0 for duration in durations)
    if whole and None not in durations:
        return {name: (case.duration or 0.0) / whole for name, case in lasting.items()}
    if all(case.share is not None for case in lasting.values()):
        return {name: case.share or 0.0 for name, case in lasting.items()}
    return {}
