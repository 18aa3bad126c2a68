"""Compare architectures: designs fitted to one engine, in one table."""

from __future__ import annotations

from collections.abc import Iterable, Mapping

from gearwright.shipped import shipped_study
from gearwright.spec import Design, Study, read, read_study
from gearwright.spec.studies import Value
from gearwright.study.answers import Table
from gearwright.study.cases import cases, evaluate, for_requirement, refuse_no_size
from gearwright.study.running.run import table_of
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
        DesignError: If a power or speed is none, or all designs fail; one that fails is a row with its reason.
    """
    study = comparison_of(designs, changes=changes)
    chosen = {name: read(name) for name in study.designs} if designs is None else designs

    def fitted(design: Design) -> Design:
        return for_requirement(design, power=power, engine_speed=engine_speed, propeller_speed=propeller_speed)

    refuse_no_size(power=power, engine_speed=engine_speed, propeller_speed=propeller_speed)
    return table_of(study, [evaluate(study, chosen[case.design], case, fitted=fitted) for case in cases(study)])


def comparison_of(designs: Iterable[str] | None, *, changes: Mapping[str, Value] | None = None) -> Study:
    """Return the study of which `compare` gives the table.

    Args:
        designs: Their names; left out: those of the shipped study.
        changes: Dotted path -> value, the same in every design.
    """
    study = read_study(shipped_study("architectures"))
    names = study.designs if designs is None else list(designs)
    name = study.name if names == list(study.designs) else f"{len(names)} designs for one engine"
    return study.model_copy(update={"designs": names, "name": name, "changes": dict(changes or {})})
