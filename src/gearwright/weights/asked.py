"""What users ask of this layer in one call: what a gearbox weighs, and which engines there are."""

from __future__ import annotations

from typing import Literal

from gearwright.catalogue import select
from gearwright.verbs import verb
from gearwright.weights.comparison import Comparison, StatedMass, compare
from gearwright.weights.engine_check import CheckedEngine, check_engine
from gearwright.weights.requirement import Requirement


@verb
def mass(
    power: float,
    engine_speed: float,
    propeller_speed: float,
    *,
    bottom_up: float | None = None,
    stated: StatedMass | None = None,
) -> Comparison:
    """Return what a gearbox weighs by every public method, with the band of the real weights.

    Args:
        power: At the rating that sizes the gearbox [W].
        engine_speed: Of the input [rad/s].
        propeller_speed: Of the propeller or rotor [rad/s].
        bottom_up: Sum of the parts of a sized design, as the total of `gw.complete_mass` [kg].
        stated: The user's own mass with its origin; it wins over every estimate.

    Raises:
        DesignError: If power and speeds are no gearbox's.

    >>> from gearwright.units import RPM
    >>> round(mass(2051e3, 20204 * RPM, 1212 * RPM).taken.mass, 1)
    136.5
    """
    return compare(Requirement(power, engine_speed, propeller_speed), bottom_up=bottom_up, stated=stated)


@verb
def engines(
    *,
    series: str = "",
    manufacturer: str = "",
    kind: Literal["turboprop", "turboshaft"] | None = None,
    model: str = "",
    power: tuple[float, float] | None = None,
) -> tuple[CheckedEngine, ...]:
    """Return engines of the catalogue as printed and computed again; names match by any part, in any case of letters.

    Args:
        series: Such as ``PW100``.
        manufacturer: Such as ``pratt``.
        kind: Of engine; left out: both.
        model: Such as ``127``.
        power: Least and greatest power [W].

    Raises:
        DesignError: If no engine answers to all of it.

    >>> len(engines())
    121
    """
    chosen = select(series=series, manufacturer=manufacturer, kind=kind or "", model=model, power=power)
    return tuple(check_engine(engine) for engine in chosen)
