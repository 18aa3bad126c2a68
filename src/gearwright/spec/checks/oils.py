"""What can be wrong with an oil: that it thickens as it warms."""

from __future__ import annotations

from collections.abc import Iterator

from gearwright.errors import Problem
from gearwright.spec.design import Design


def oil_problems(design: Design) -> Iterator[Problem]:
    """Yield every oil that is no thinner at 100 °C than at 40 °C.

    Args:
        design: As typed.
    """
    yield from _thickens("oil.viscosity_100", design.oil.viscosity_40, design.oil.viscosity_100)
    own = {f"{design.table(name)}.": stage.gears for name, stage in design.stages.items()}
    for path, rules in {"": design.gears, **own}.items():
        if rules is not None:
            oil = rules.iso6336
            yield from _thickens(f"{path}gears.iso6336.oil_viscosity_100", oil.oil_viscosity, oil.oil_viscosity_100)


def _thickens(path: str, at_40: float, at_100: float | None) -> Iterator[Problem]:
    if at_100 is not None and at_100 >= at_40:
        message = f"{at_100:g} mm²/s at 100 °C is not below the {at_40:g} mm²/s at 40 °C; oils thin as they warm"
        yield Problem(path, message)
