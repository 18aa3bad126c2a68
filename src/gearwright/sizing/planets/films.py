"""Films between pin and planet: their oil, how they run in every load case, and what limits them."""

from __future__ import annotations

from collections.abc import Iterator
from typing import NamedTuple

from gearwright.parts.bearings import (
    FilmOil,
    FilmState,
    Journal,
    laminar_limit,
    run_film,
    usual_clearance,
    usual_least_film,
)
from gearwright.parts.losses import oil_viscosity
from gearwright.sizing.bearings import PlanetLoad
from gearwright.sizing.pinned import PlanetBearingSizing
from gearwright.spec import Design
from gearwright.spec.design import PlanetBearing
from gearwright.units import CELSIUS

HEAT_CAPACITY = 2000.0
"""Of lubricating oil [J/(kg K)]."""
STANDING = 1e-3
"""Speed below which a planet is taken to stand on its pin: a film needs motion [rad/s]."""


class Judged(NamedTuple):
    """A film in one case, with what is allowed there."""

    case: int
    """Of the load cases."""
    state: FilmState
    least_film: float
    """h_lim [m]."""


def film_oil(grade: tuple[float, float], density: float, supply: float) -> FilmOil:
    """Return the oil that enters a plain bearing.

    Args:
        grade: Kinematic viscosity at 40 °C and at 100 °C [m²/s].
        density: [kg/m³].
        supply: Its temperature [K].
    """
    return FilmOil(lambda at: density * oil_viscosity(at, grade), density, HEAT_CAPACITY, supply)


def design_oil(design: Design, asked: PlanetBearing) -> FilmOil:
    """Return the oil that enters a plain bearing of a design.

    Args:
        design: With its oil.
        asked: With the temperature, where it is given.
    """
    oil = design.oil
    grade = (oil.viscosity_40 * 1e-6, oil.viscosity_100 * 1e-6)
    supply = oil.temperature if asked.oil_temperature is None else asked.oil_temperature
    return film_oil(grade, oil.density, supply + CELSIUS)


def on_film(asked: PlanetBearing, pin: float, width: float, fastest: float = 0.0) -> PlanetBearingSizing:
    """Return a plain bearing of a size.

    Args:
        asked: As in the design.
        pin: D [m].
        width: B [m].
        fastest: Speed of the planet against its carrier, for the usual clearance [rad/s].
    """
    clearance = asked.clearance or usual_clearance(fastest * pin / 2.0)
    return PlanetBearingSizing(
        kind="plain",
        bearing=None,
        side_by_side=1,
        pin_diameter=pin,
        outer_diameter=pin * (1.0 + clearance),
        width=width,
        clearance=clearance,
        turning_mass=0.0,
        turning_inertia=0.0,
        standing_mass=0.0,
    )


def judged(journal: Journal, load: PlanetLoad, asked: PlanetBearing, oil: FilmOil) -> Iterator[Judged]:
    """Yield how a film runs in every case in which the planet turns.

    Args:
        journal: The bearing.
        load: By load case.
        asked: With its limits.
        oil: That enters.
    """
    for case, (radial, speed) in enumerate(zip(load.radial.tolist(), load.speeds, strict=True)):
        if speed > STANDING and radial > 0.0:
            state = run_film(journal, radial, speed, oil)
            yield Judged(case, state, asked.least_film or usual_least_film(journal.diameter, state.sliding_speed))


def film_margin(found: Judged, journal: Journal, asked: PlanetBearing, oil: FilmOil) -> float:
    """Return the least of what a film has over what it must have: pressure, film, temperature, laminar flow [-].

    Args:
        found: A film in one case.
        journal: The bearing.
        asked: With its limits.
        oil: That enters.
    """
    state, allowed = found.state, asked.largest_temperature + CELSIUS - oil.supply
    return min(
        asked.largest_pressure / state.pressure,
        state.film / found.least_film,
        allowed / state.rise,
        laminar_limit(journal.clearance) / state.reynolds,
    )
