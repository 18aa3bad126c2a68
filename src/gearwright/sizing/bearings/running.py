"""How the bearing of a seat runs: with its oil, its least load and its speeds."""

from __future__ import annotations

from gearwright.catalogue import (
    Bearing,
    BearingOil,
    BearingSpectrum,
    ModifiedLife,
    bearing_friction,
    equivalent_loads,
    modified_life,
)
from gearwright.errors import DesignError, Problem
from gearwright.parts.bearings import Cleanliness, OilFilter, least_load, speed_factor, thermal_reference_speed
from gearwright.parts.losses import oil_viscosity
from gearwright.sizing.mounted import Running
from gearwright.spec import Design
from gearwright.units import CELSIUS


def oil_of(design: Design) -> BearingOil:
    """Return the oil in the bearings of a design.

    Args:
        design: With its oil and its rules for bearings.
    """
    oil = design.oil
    viscosity = oil_viscosity(oil.temperature + CELSIUS, (oil.viscosity_40 * 1e-6, oil.viscosity_100 * 1e-6))
    word = oil.cleanliness.upper().replace("-", "_")
    dirt = OilFilter[word] if word in OilFilter.__members__ else Cleanliness[word]
    return BearingOil(viscosity, dirt, design.bearing_rules.reliability)


def oiled_life(design: Design, fitted: Bearing, duty: BearingSpectrum, *, path: str) -> ModifiedLife | None:
    """Return the modified life of a bearing; None where nothing loads it, or the standard gives none and none is asked.

    Args:
        design: With its oil and its rules for bearings.
        fitted: The bearing.
        duty: What it bears.
        path: Where the design says what sits there.

    Raises:
        DesignError: The oil is too thin for the standard, and the design asks for this life.
    """
    try:
        return modified_life(fitted, duty, oil_of(design))
    except DesignError as error:
        if design.bearing_rules.life == "basic":
            return None
        raise DesignError([Problem(path, f"{problem.message}, in [oil]") for problem in error.problems]) from None


def running_of(fitted: Bearing, duty: BearingSpectrum) -> Running:
    """Return how a bearing runs under a duty.

    Args:
        fitted: The bearing.
        duty: What it bears.
    """
    loads = [
        duty.mean_factor * equivalent_loads(fitted, radial, axial)[0]
        for radial, axial, speed in zip(duty.radial, duty.axial, duty.speed, strict=True)
        if speed
    ]
    friction, fastest = bearing_friction(fitted), max((abs(speed) for speed in duty.speed), default=0.0)
    return Running(
        lightest_load=min(loads, default=0.0),
        least_load=least_load(fitted.dynamic_rating, fitted.kind),
        highest_speed=fastest,
        reference_speed=thermal_reference_speed(
            fitted.bore, fitted.outer_diameter, fitted.width,
            static_rating=fitted.static_rating, oil_factor=friction.oil_factor, load_factor=friction.load_factor,
        ),
        speed_factor=speed_factor(fastest, fitted.bore, fitted.outer_diameter),
    )  # fmt: skip
