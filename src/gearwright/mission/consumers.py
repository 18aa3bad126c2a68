"""What takes power in flight: the propeller or rotor that balances, accessories by demand, others by their part."""

from __future__ import annotations

from collections.abc import Mapping

from gearwright.errors import DesignError, Problem
from gearwright.sizing import Sizing
from gearwright.spec import Accessory, drives_of


def flown_airscrew(sizing: Sizing) -> str:
    """Return the propeller or rotor that a mission is flown with: the one that balances in its first case.

    Args:
        sizing: What was sized.

    Raises:
        DesignError: If there is none, or more than one.
    """
    drives = drives_of(sizing.design, sizing.reference.case)
    names = [name for name in sizing.design.airscrews if not drives[name].stated]
    if len(names) != 1:
        balance = f"{len(names)} propellers or rotors balance in case {sizing.reference.case}"
        raise DesignError([Problem("propellers", f"{balance}; a mission is flown with one per gearbox")])
    return names[0]


def taken_parts(sizing: Sizing) -> dict[str, float]:
    """Return every other machine that only takes -> its part of the power that the train is given [-].

    Tail rotors, generators and loads take in flight the part that they take in the case that speaks for the design;
    accessories are not among them: they take their own power at any speed, as in a case that says nothing of them.

    Args:
        sizing: What was sized.
    """
    flown, powers = flown_airscrew(sizing), sizing.reference.machine_powers
    given = sum(power for power in powers.values() if power > 0.0)
    takers = [
        name
        for name, machine in sizing.design.machines.items()
        if name != flown and not machine.drives and not isinstance(machine, Accessory)
    ]
    return {name: powers[name] / given for name in takers} if given else dict.fromkeys(takers, 0.0)


def own_demand(sizing: Sizing) -> float:
    """Return what all accessories take in flight, whatever the machines give [W].

    Args:
        sizing: What was sized.
    """
    return sum(accessory.power for accessory in sizing.design.accessories.values())


def with_consumers(powers: Mapping[str, float], taken: Mapping[str, float]) -> dict[str, float]:
    """Return the machines' powers with those of what takes its part of them [W].

    Args:
        powers: Machine -> power into the train [W].
        taken: From `taken_parts`; one whose power is among the others keeps that.
    """
    given = abs(sum(power for name, power in powers.items() if name not in taken))
    return {**{name: part * given for name, part in taken.items()}, **powers}
