"""Rules by which turbines and motors divide the power of an interval."""

from __future__ import annotations

from typing import NamedTuple

from gearwright.machines import Battery, stored_energy
from gearwright.spec import Phase, StrategyRules

USUAL_END = 0.95
"""State of charge at which charging ends where a strategy does not say it [-]."""


class Demand(NamedTuple):
    """What an interval asks of all machines together, and what could answer."""

    power: float
    """Of all machines, with drag and spin-up; negative where the air drives the propeller [W]."""
    available: float
    """What all turbines can give [W]."""
    charge: float
    """State of charge at its start [-]."""
    duration: float
    """[s]"""


def electric_share(rules: StrategyRules, demand: Demand, battery: Battery | None, planned: float) -> float:
    """Return the motors' part of the machines' power in an interval [-]; negative charges.

    Args:
        rules: The strategy; one that is optimal is planned before.
        demand: Of the interval.
        battery: Of the motors.
        planned: Share by the plan of an optimal strategy.
    """
    power = max(demand.power, _LEAST)
    match rules.rule:
        case "share":
            return rules.electric_share or 0.0
        case "boost":
            most = min(rules.turbine_power or demand.available, demand.available)
            return min(max(1.0 - most / power, 0.0), 1.0)
        case "electric-taxi":
            return 1.0
        case "regenerate":
            return 1.0 * (demand.power < 0.0)
        case "charge":
            return -min(_charging(rules, demand, battery) / power, LARGEST_CHARGE) * (demand.power > 0.0)
        case "optimal":
            return planned
    return 0.0


LARGEST_CHARGE = 9.0
"""Most that motors take over the machines' power [-]: a tenth of the turbines' work goes on."""
_LEAST = 1e-9
"""Power that shares are at least parts of, so that arrays need no branch [W]."""


def _charging(rules: StrategyRules, demand: Demand, battery: Battery | None) -> float:
    """Return what motors take from the gearbox: as asked, as turbines can give, as the battery still holds [W]."""
    if battery is None:
        return 0.0
    end = rules.until_charge or USUAL_END
    room = stored_energy(battery, max(end, demand.charge)) - stored_energy(battery, demand.charge)
    return max(min(rules.charge_power or 0.0, demand.available - demand.power, room / demand.duration), 0.0)


def driven(phase: Phase, share: float) -> Phase:
    """Return a phase as the share of one of its intervals drives it.

    Args:
        phase: With a strategy.
        share: Motors' part of the machines' power [-].
    """
    mode = "conventional" if share == 0.0 else "electric" if share == 1.0 else "hybrid"
    return phase.model_copy(update={"mode": mode, "electric_share": share if mode == "hybrid" else None})
