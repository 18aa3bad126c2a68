"""Machines that a load case asks for more than they may do while it lasts."""

from __future__ import annotations

from collections.abc import Iterator, Mapping

from gearwright.errors import Problem, refuse
from gearwright.spec import Design, case_named
from gearwright.spec.checks import table_of
from gearwright.spec.design import allowed_in_case
from gearwright.train import PowerFlow
from gearwright.units import text

_ROUNDING = 1e-6
"""Part by which a limit may be passed [-]."""
_LIMITS = "give it a limit beyond its rating for the time that the case lasts"


def refuse_beyond(design: Design, flows: Mapping[str, PowerFlow]) -> None:
    """Raise where a case asks a machine for more power, torque or speed than it may give or take so long.

    Static cases are limit loads, which no rating covers.

    Args:
        design: With its machines and cases.
        flows: Every load case.

    Raises:
        DesignError: With every such machine, its value and its limit.
    """
    lasting = [flow for case, flow in flows.items() if not case_named(design, case).static]
    refuse(problem for flow in lasting for problem in _beyond(design, flow))


def _beyond(design: Design, flow: PowerFlow) -> Iterator[Problem]:
    case = case_named(design, flow.case)
    for name, machine in design.machines.items():
        allowed, table = allowed_in_case(machine, case), table_of(name, design)
        stated = f"cases.{flow.case}.{name}" if name in case.machines else f"{table}.{name}"
        found = {
            "power": (abs(flow.machine_powers[name]), allowed.power, f"ask for less, raise its power, or {_LIMITS}"),
            "torque": (abs(flow.machine_torques[name]), allowed.torque, f"ask for less, or {_LIMITS}"),
            "speed": (abs(flow.speeds[machine.shaft]), allowed.speed, "let it turn slower, by other teeth or speeds"),
        }
        for key, (value, most, fix) in found.items():
            if most is not None and value > most * (1.0 + _ROUNDING):
                limits = f" ([{table}.{name}.limits.NAME])" if _LIMITS in fix else ""
                message = f"{text(value, key)} in case {flow.case}, and {text(most, key)} is its limit; {fix}{limits}"
                yield Problem(f"{stated}.{key}", message)
