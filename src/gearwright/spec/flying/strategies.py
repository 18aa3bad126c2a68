"""What does not fit together in a mission's strategies and the phases that name them."""

from __future__ import annotations

from collections.abc import Iterator

from gearwright.errors import Problem, near
from gearwright.spec.missions import Mission
from gearwright.spec.power import KEYS_OF, NEEDED


def strategy_problems(mission: Mission) -> Iterator[Problem]:
    """Yield what does not fit together in strategies.

    Args:
        mission: Typed, but not yet checked.
    """
    for name, strategy in mission.strategies.items():
        at, read = f"strategies.{name}", KEYS_OF[strategy.rule]
        if (needed := NEEDED.get(strategy.rule)) and getattr(strategy, needed) is None:
            yield Problem(at, f"rule {strategy.rule!r} without {needed}; give it, or another rule")
        for key in type(strategy).model_fields:
            if key != "rule" and key not in read and getattr(strategy, key) is not None:
                others = ", ".join(rule for rule, keys in KEYS_OF.items() if key in keys)
                yield Problem(f"{at}.{key}", f"rule {strategy.rule!r} does not read it; leave it out, or use {others}")
    for name, phase in mission.phases.items():
        if phase.strategy is not None:
            yield from (Problem(f"phases.{name}", message) for message in _phase(mission, phase.strategy, name))


def _phase(mission: Mission, strategy: str, name: str) -> Iterator[str]:
    phase = mission.phases[name]
    if strategy not in mission.strategies:
        yield f"there is no strategy {strategy!r}; {near(strategy, mission.strategies)}, or add [strategies.{strategy}]"
    elif mission.strategies[strategy].rule != "turbine-alone" and mission.battery is None:
        yield f"strategy {strategy!r} without a [battery]; give one with energy_kwh"
    if phase.mode != "conventional":
        yield f'strategy and mode = "{phase.mode}" given; a strategy sets who drives: keep one of them'
