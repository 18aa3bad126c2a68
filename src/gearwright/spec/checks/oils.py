"""What can be wrong with an oil and with flanks in it: that it thickens as it warms, and two words for one thing."""

from __future__ import annotations

from collections.abc import Iterator

from gearwright.errors import Problem
from gearwright.parts.iso6336 import RZ_OVER_RA
from gearwright.spec.design import GRADE_KEYS, RATINGS, WARMTH_KEYS, Agma2001Rules, Design, Iso6336Rules

ROUGHNESS_SCATTER = 2.0
"""Factor by which R_z/R_a may differ from 6, one way or the other, and still be of one surface [-]."""


def oil_problems(design: Design) -> Iterator[Problem]:
    """Yield every oil that is no thinner at 100 °C than at 40 °C, and oils and flanks that are told twice, not alike.

    Args:
        design: As typed.
    """
    yield from _thickens("oil.viscosity_100", design.oil.viscosity_40, design.oil.viscosity_100)
    own = {f"{design.table(name)}.": stage.gears for name, stage in design.stages.items()}
    for path, rules in {"": design.gears, **own}.items():
        if rules is not None:
            oil = rules.iso6336
            yield from _thickens(f"{path}gears.iso6336.oil_viscosity_100", oil.oil_viscosity, oil.oil_viscosity_100)
    yield from _two_oils(design)
    yield from _two_surfaces(design)


def _thickens(path: str, at_40: float, at_100: float | None) -> Iterator[Problem]:
    if at_100 is not None and at_100 >= at_40:
        message = f"{at_100:g} mm²/s at 100 °C is not below the {at_40:g} mm²/s at 40 °C; oils thin as they warm"
        yield Problem(path, message)


def _two_oils(design: Design) -> Iterator[Problem]:
    """Find rules of all gears that name another oil than [oil]; a stage may have one of its own."""
    rules, oil = design.gears.iso6336, design.oil
    for key, of_oil in {**GRADE_KEYS, **WARMTH_KEYS}.items():
        if key in rules.model_fields_set and of_oil in oil.model_fields_set:
            ours, its = getattr(rules, key), getattr(oil, of_oil)
            if ours != its:
                message = (
                    f"{ours:g} here and {its:g} in oil.{of_oil}; leave it out: the teeth take the oil of [oil]"
                    " (a stage with another oil says it in its own gears.iso6336)"
                )
                yield Problem(f"gears.iso6336.{key}", message)


def _two_surfaces(design: Design) -> Iterator[Problem]:
    """Find a roughness for losses that the flanks, as they are rated, do not have."""
    if "roughness" not in design.losses.model_fields_set:
        return
    stated = design.losses.roughness
    for name in design.stages:
        rules, table = design.rules(name), RATINGS[design.rating(name)].table
        tables: dict[str, Iso6336Rules | Agma2001Rules] = {"iso6336": rules.iso6336, "agma2001": rules.agma2001}
        standard = tables.get(table)
        if standard is None or "flank_roughness" not in standard.model_fields_set:
            continue
        by_depth = isinstance(standard, Iso6336Rules)
        rated = standard.flank_roughness / (RZ_OVER_RA if by_depth else 1.0)
        if not 1.0 / ROUGHNESS_SCATTER <= stated / rated <= ROUGHNESS_SCATTER:
            message = (
                f"R_a {1e6 * stated:g} µm, but the flanks of {name} are rated with {1e6 * rated:.3g} µm"
                f" (gears.{table}.flank_roughness{', R_z/6' if by_depth else ''}); leave it out, or say one"
            )
            yield Problem("losses.roughness", message)
            return
