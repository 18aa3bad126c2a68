"""Compare architectures: designs fitted to one engine, in one table."""

from __future__ import annotations

from collections.abc import Mapping

from gearwright.shipped import shipped_study
from gearwright.spec import Design, read, read_study
from gearwright.spec.axis import Value
from gearwright.study.answers import Table
from gearwright.study.cases import for_requirement
from gearwright.study.running.run import run
from gearwright.verbs import verb


@verb
def compare(
    designs: Mapping[str, Design] | None = None,
    *,
    power: float | None = None,
    engine_speed: float | None = None,
    propeller_speed: float | None = None,
    changes: Mapping[str, Value] | None = None,
) -> Table:
    """Return masses, margins and power densities of designs, each as it is or fitted to one engine by `for_engine`.

    Where a power or speed is asked, the designs are architectures: tooth numbers and how many planets there are become
    free and are chosen for the least mass. `changes` may give them.

    Args:
        designs: Name -> design; left out: the architectures of the shipped study.
        power: Rated power of turbines and motors together [W]; left out: each design's own, as the speeds below.
        engine_speed: Speed of the turbines [rad/s].
        propeller_speed: Speed of the propellers [rad/s].
        changes: Dotted path -> value, the same in every design.

    Raises:
        DesignError: If a design has no turbine, or all of them fail.
    """
    study = read_study(shipped_study("architectures"))
    designs = {name: read(name) for name in study.designs} if designs is None else designs
    name = study.name if list(designs) == list(study.designs) else f"{len(designs)} designs for one engine"
    asked = study.model_copy(update={"designs": list(designs), "name": name, "changes": dict(changes or {})})
    fitted = {
        name: for_requirement(design, power=power, engine_speed=engine_speed, propeller_speed=propeller_speed)
        for name, design in designs.items()
    }
    return run(asked, fitted)
