"""Machines, clutches and load cases as components and spectra of REXS."""

from __future__ import annotations

from gearwright.exchange.rexs.writing.sheet import Value
from gearwright.exchange.rexs.writing.task import Task
from gearwright.sizing import governing_case
from gearwright.spec import GROUND
from gearwright.spec.design import levels_of, shares_of


def write_machines(task: Task) -> None:
    """Write every machine as a load on its shaft.

    Args:
        task: Whose shafts are written.
    """
    sizing = task.sizing
    powers = sizing.reference.machine_powers
    follows = min(powers, key=lambda name: powers[name])  # what takes most follows from all others
    for machine in sizing.machines:
        number = task.sheet.add("external_load", machine.name, {
            "u_coordinate_on_shaft": sizing.arrangement.plans[machine.shaft].places[machine.name],
            "transmits_torque": True, "defines_torque": machine.name != follows,
        })  # fmt: skip
        task.sheet.relate("assembly", {"assembly": task.shafts[machine.shaft], "part": number})
        task.loads[machine.name] = number


def write_clutches(task: Task) -> None:
    """Write every clutch and brake, engaged as it is in the case that speaks for the design.

    Args:
        task: Whose shafts are written.
    """
    for name, clutch in task.sizing.design.clutches.items():
        ends = [end for end in (clutch.driving, clutch.driven) if end != GROUND]
        outer = task.casing if len(ends) == 1 else task.shafts[ends[1]]
        number = task.sheet.add("switchable_coupling", name, {})
        task.sheet.relate("side", {"assembly": number, "inner_part": task.shafts[ends[0]], "outer_part": outer})
        task.loads[name] = number


def write_cases(task: Task) -> None:
    """Write every level of every load case: torques of machines, speeds of shafts, clutches that hold.

    Args:
        task: Whose machines and clutches are written.
    """
    sizing = task.sizing
    shares = shares_of(sizing.design) or {governing_case(sizing): 1.0}
    for name in sizing.flows:
        for load, share in levels_of(sizing.design, name):
            if share > 0.0:  # a case without a share of the life is a static one
                task.sheet.cases.append(_case(task, name, load, float(shares.get(name, 0.0) * share)))


def _case(task: Task, name: str, load: float, share: float) -> dict[int, dict[str, Value]]:
    """Return what the components say in a part of the loads of a case, which lasts a share of the life."""
    sizing, flow = task.sizing, task.sizing.flows[name]
    said: dict[int, dict[str, Value]] = {
        task.unit: {"operating_time_fraction": share},
        task.casing: {"temperature_lubricant": sizing.design.oil.temperature},
    }
    for machine in sizing.machines:
        torque, power = load * flow.machine_torques[machine.name], load * flow.machine_powers[machine.name]
        said[task.loads[machine.name]] = {"torque_around_u_axis": torque, "power": power}
    for shaft in sizing.shafts:
        said[task.shafts[shaft.name]] = {"rotational_speed": flow.speeds[shaft.name]}
    for clutch in sizing.design.clutches:
        said[task.loads[clutch]] = {"is_engaged": (clutch in flow.joints,)}
    return said
