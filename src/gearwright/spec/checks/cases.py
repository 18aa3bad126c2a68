"""Checks of load cases and of forbidden frequency bands."""

from __future__ import annotations

from collections.abc import Iterator

from gearwright.errors import Problem, near
from gearwright.spec.design import (
    GROUND,
    RATED,
    RATINGS,
    Case,
    Design,
    Drive,
    Machine,
    case_named,
    cases_of,
    drives_of,
    shares_of,
)
from gearwright.units import text

# ----------------------------------------------------------------------------------------------------------------------
# What can be wrong with load cases: who does what, who balances, how long each lasts, what is engaged.
# ----------------------------------------------------------------------------------------------------------------------


WHOLE = 1e-6
"""How far from 1 the sum of the shares may be [-]."""
_AMOUNTS = ("power", "torque", "rating")


def case_problems(design: Design) -> Iterator[Problem]:
    """Yield what is wrong with the load cases of a design.

    Args:
        design: As typed.
    """
    for name, case in design.cases.items():
        for machine, drive in case.machines.items():
            path = f"cases.{name}.{machine}"
            if machine not in design.machines:
                yield Problem(path, f"there is no machine {machine!r}; {near(machine, design.machines)}")
            else:
                yield from _drive(path, drive, design.machines[machine])
        yield from _engaged(name, case, design)
    yield from _balanced(design)
    yield from _lasting(design)
    yield from _spectra(design)


def _drive(path: str, drive: Drive, machine: Machine) -> Iterator[Problem]:
    """Find what a machine cannot do."""
    said = [key for key in _AMOUNTS if getattr(drive, key) is not None]
    if len(said) + drive.balances > 1:
        both = " and ".join([*said, "balances"] if drive.balances else said)
        yield Problem(path, f"{both} are given; one of them says what the machine does, keep one")
        return
    if drive.rating is not None and machine.rating is None:
        yield Problem(f"{path}.rating", "this machine has no rated power; give its power")
        return
    for key in said:
        amount, kind = getattr(drive, key), type(machine).__name__.lower()
        if amount < 0.0 and not machine.takes:
            yield Problem(f"{path}.{key}", f"{_amount(amount, key)}: a {kind} gives power; use 0 or more")
        if amount > 0.0 and not machine.gives:
            message = f"{_amount(amount, key)}: this machine ({kind}) takes power; write {_amount(-amount, key)}, or 0"
            yield Problem(f"{path}.{key}", message)
        elif amount > 0.0 and not (machine.drives or drive.drives):
            message = (
                f"{_amount(amount, key)}: this machine ({kind}) takes power, and what a case takes is negative; write"
                f" {_amount(-amount, key)}, or drives = true beside it if it gives power"
            )
            yield Problem(f"{path}.{key}", message)
    yield from _driving(path, drive, machine)


def _driving(path: str, drive: Drive, machine: Machine) -> Iterator[Problem]:
    """Find a machine that is said to drive, and always does, never does, or is given nothing to do it with."""
    kind = type(machine).__name__.lower()
    if not drive.drives:
        return
    if machine.drives or not machine.gives:
        yield Problem(f"{path}.drives", f"a {kind} {'always' if machine.drives else 'never'} drives; leave it out")
    elif not max(drive.power or 0.0, drive.torque or 0.0) > 0.0:
        yield Problem(f"{path}.drives", "what it gives is not said; give a power or torque above 0, or leave it out")


def _amount(value: float, key: str) -> str:
    return f"{value:g}" if key == "rating" else text(value, key)


def _engaged(name: str, case: Case, design: Design) -> Iterator[Problem]:
    for clutch in case.engaged or []:
        path = f"cases.{name}.engaged"
        if clutch not in design.clutches:
            yield Problem(path, f"there is no clutch or brake {clutch!r}; {near(clutch, design.clutches)}")
        elif design.clutches[clutch].kind == "overrunning":
            yield Problem(path, f"{clutch!r} is overrunning and acts by itself; leave it out, or make it engaged")


def _balanced(design: Design) -> Iterator[Problem]:
    """Find cases in which nothing is left to balance, and designs that nothing loads."""
    if not design.machines:
        return
    loaded = False
    for case in cases_of(design):
        drives = drives_of(design, case)
        loaded |= any(drive.stated and not drive.idles for drive in drives.values())
        if all(drive.stated for drive in drives.values()) and not _braked(design, case):
            yield _none_balances(design, case)
    if not loaded and not design.turbines:
        fix = "write balances = false at a motor" if design.motors else "add a table such as [turbines.gas-turbine]"
        if design.cases:
            fix = "give a machine a power in a case"
        yield Problem("", f"no machine of a stated power drives this train, so that nothing loads it; {fix}")


def _braked(design: Design, case: str) -> bool:
    """Return whether a brake holds in a case: it bears what the machines leave."""
    held = [design.clutches[name] for name in case_named(design, case).engaged or [] if name in design.clutches]
    return any(GROUND in (clutch.driving, clutch.driven) for clutch in held)


def _none_balances(design: Design, case: str) -> Problem:
    if case not in design.cases:
        return Problem("propellers", "nothing takes the power; add a table such as [propellers.propeller]")
    return Problem(
        f"cases.{case}",
        f"the power of every machine is given ({', '.join(design.machines)}), so that none balances the rest and the"
        " losses; leave one out, or write balances = true at one",
    )


def _lasting(design: Design) -> Iterator[Problem]:
    """Find durations and shares that do not make up a life."""
    lasting = {name: case for name, case in design.cases.items() if not case.static}
    said = {name for name, case in design.cases.items() if case.duration is not None or case.share is not None}
    for name in said - lasting.keys():
        yield Problem(f"cases.{name}.static", "a static case counts no cycles; leave out its duration or share")
    if design.cases and not lasting:
        yield Problem("cases", "all of them are static, so that nothing makes up the life; add one that lasts")
    said &= lasting.keys()
    if design.service.shares:
        yield from _service_shares(design, said)
        return
    shares = [case.share for case in lasting.values() if case.share is not None]
    durations = [case.duration for case in lasting.values() if case.duration is not None]
    if shares and durations:
        yield Problem("cases", "some last a duration and some a share of the life; give all of them one of the two")
    elif said and len(said) < len(lasting):
        missing = ", ".join(name for name in lasting if name not in said)
        yield Problem("cases", f"{missing}: how long it lasts is not said; give it a {_written(shares)}, as the others")
    elif shares and abs(sum(shares) - 1.0) > WHOLE:
        yield Problem("cases", f"the sum of their shares is {sum(shares):.6g}; give shares with sum 1")
    elif not said and len(lasting) > 1 and _has_lives(design):
        names = ", ".join(lasting)
        message = f"{names}: how long each lasts is not said, and lives are asked; give each a duration_min or a share"
        yield Problem("cases", message)
    if shares_of(design) and "mean_load" in design.service.model_fields_set:
        yield Problem("service.mean_load", "it follows from the cases' durations or shares; keep one of the two")


def _spectra(design: Design) -> Iterator[Problem]:
    """Find spectra that are no spectra, and names that none has."""
    for name, spectrum in design.spectra.items():
        path, levels, total = f"spectra.{name}", spectrum.load, sum(spectrum.share)
        if len(levels) != len(spectrum.share):
            yield Problem(path, f"{len(levels)} levels of load and {len(spectrum.share)} shares; give one for each")
        elif abs(total - 1.0) > WHOLE or min(spectrum.share) < 0.0:
            yield Problem(f"{path}.share", f"their sum is {total:.6g}; give positive shares with sum 1")
        if min(levels) < 0.0 or max(levels) > 1.0:
            message = "a level is a part of what the case says, which is the highest; give 0 to 1"
            yield Problem(f"{path}.load", f"{min(levels):g} to {max(levels):g}: {message}")
    named = {f"cases.{name}": case for name, case in design.cases.items()} | {"service": design.service}
    for path, holder in named.items():
        if holder.spectrum is not None and holder.spectrum not in design.spectra:
            message = f"there is no spectrum {holder.spectrum!r}; {near(holder.spectrum, design.spectra)}"
            yield Problem(f"{path}.spectrum", message)
    for name, case in design.cases.items():
        if case.static and case.spectrum is not None:
            yield Problem(f"cases.{name}.spectrum", "a static case counts no cycles; leave it out")
    if design.service.spectrum is not None and "mean_load" in design.service.model_fields_set:
        yield Problem("service.mean_load", "it follows from service.spectrum; keep one of the two")


def _written(shares: list[float]) -> str:
    return "share" if shares else "duration"


def _service_shares(design: Design, said: set[str]) -> Iterator[Problem]:
    shares, known = design.service.shares, [*design.cases] or [RATED]
    for case in shares:
        if case not in known:
            yield Problem(f"service.shares.{case}", f"there is no case {case!r}; {near(case, known)}")
        elif case in design.cases and design.cases[case].static:
            yield Problem(f"service.shares.{case}", f"{case!r} is static and counts no cycles; leave it out")
    for case in said:
        yield Problem(f"cases.{case}", "how long it lasts stands here and in service.shares; keep one of the two")
    total = sum(shares.values())
    if abs(total - 1.0) > WHOLE or min(shares.values()) < 0.0:
        yield Problem("service.shares", f"their sum is {total:.6g}; give positive shares with sum 1")
    if "mean_load" in design.service.model_fields_set:
        yield Problem("service.mean_load", "it follows from service.shares; keep one of the two")


def _has_lives(design: Design) -> bool:
    """Tell whether something is rated for a life: gears by a standard, or bearings."""
    return bool(design.bearings) or any(RATINGS[design.rating(stage)].fatigue for stage in design.stages)


# ----------------------------------------------------------------------------------------------------------------------
# What can be wrong with forbidden bands of frequencies: reversed ends, cases and planets that are not there.
# ----------------------------------------------------------------------------------------------------------------------


def band_problems(design: Design) -> Iterator[Problem]:
    """Yield what is wrong with the bands of frequencies that teeth shall not pass at.

    Args:
        design: As typed.
    """
    for name, band in design.teeth.forbidden.items():
        path = f"teeth.forbidden.{name}"
        if band.highest <= band.lowest:
            ends = f"{text(band.highest, 'frequency')} is not above lowest, {text(band.lowest, 'frequency')}"
            yield Problem(f"{path}.highest", f"{ends}; give the upper end here, or leave the band out")
        for case in band.cases or []:
            if case not in cases_of(design):
                yield Problem(f"{path}.cases", f"there is no case {case!r}; {near(case, cases_of(design))}")
        if band.cases == []:
            yield Problem(f"{path}.cases", "is empty, so that the band holds nowhere; name a case, or leave it out")
        if band.of == "planet-pass" and not design.sets:
            yield Problem(f"{path}.of", "'planet-pass', but the design has no planets; write \"mesh\"")
