"""Where the pins of a compound set stand, over one module, and what its meshes with suns and rings so ask of shifts."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from functools import cached_property

from gearwright.errors import DesignError, Problem
from gearwright.parts.planetary import CompoundSet, module_ratios, pin_radii, reaches
from gearwright.spec.design.epicyclics import Epicyclic
from gearwright.spec.design.rules import GearRules
from gearwright.spec.design.teeth.shifts import Basis, placed

ROUNDED = 1e-9
"""Part of a distance by which rounding may part two that are one [-]."""
_KINDS = ("sun", "ring", "planet")


@dataclass(frozen=True)
class PinnedTeeth:
    """A compound set, and where its file speaks of it."""

    path: str
    epicyclic: Epicyclic
    rules: GearRules

    @cached_property
    def compound(self) -> CompoundSet:
        """Its gears without shifts."""
        return self.epicyclic.compound

    @cached_property
    def modules(self) -> dict[str, float]:
        """Group of gears -> module over that of the first group [-]."""
        return relative_modules(self.epicyclic)

    @cached_property
    def pins(self) -> dict[str, float | None]:
        """Body -> working distance of its pin over the first group's module; None: the reference one [-]."""
        return {body: _pin(self, body) for body in reaches(self.compound)}

    def key(self, gear: str) -> str:
        """Return the path of a gear.

        Args:
            gear: As the design calls it.
        """
        return f"{self.path}.{self.kind(gear)}s.{gear}"

    def kind(self, gear: str) -> str:
        """Return sun, ring or planet.

        Args:
            gear: As the design calls it.
        """
        return next(kind for kind in _KINDS if gear in getattr(self.epicyclic, f"{kind}s"))

    def basis(self, gear: str) -> Basis:
        """Return what the shifts of the meshes of a gear are found from.

        Args:
            gear: As the design calls it.
        """
        return Basis(self.key(gear), self.rules, {"pressure_angle": self.rules.pressure_angle, "helix_angle": 0.0})

    def total(self, pair: tuple[str, str]) -> int:
        """Return z_1 + z_2 of a mesh, negative inside a ring [-].

        Args:
            pair: Its gears.
        """
        return self.compound.teeth[pair[0]] + self.compound.teeth[pair[1]]

    def asks(self, body: str) -> list[float]:
        """Return at which distances from the axis the unshifted meshes of a body want its pin, over one module [-].

        Args:
            body: One of its planets' bodies.
        """
        return [self.modules[group] * distance for group, distance in reaches(self.compound)[body]]

    def meshes_of(self, body: str) -> list[tuple[str, str]]:
        """Return the meshes of a body with suns and rings, those first.

        Args:
            body: One of its planets' bodies.
        """
        return [pair for pair in self.compound.at_centre if self.compound.bodies[pair[1]] == body]

    def centre(self, pair: tuple[str, str]) -> float | None:
        """Return the working distance of a planet from the axis over their module, by its pin [-].

        Args:
            pair: Sun or ring, and planet.
        """
        pin = self.pins[self.compound.bodies[pair[1]]]
        return None if pin is None else pin / self.modules[self.compound.group(pair[1])]

    def asked(self, pair: tuple[str, str]) -> float:
        """Return the sum of shifts that closes the mesh of a sun or ring with a planet [-].

        Args:
            pair: Sun or ring, and planet.
        """
        centre = self.centre(pair)
        with self.naming(pair[1]):
            return 0.0 if centre is None else self.basis(pair[1]).sum_at(self.total(pair), centre)

    @contextmanager
    def naming(self, planet: str) -> Iterator[None]:
        """Say at which planet a mesh does not close, and why its pin stands where nobody put it.

        Args:
            planet: Of the mesh.
        """
        try:
            yield
        except DesignError as error:
            key = self.key(planet)
            raise DesignError(_at_pin(self, planet, placed(key, problem)) for problem in error.problems) from None


def relative_modules(epicyclic: Epicyclic) -> dict[str, float]:
    """Return group of gears -> module over that of the first group, by what is given and by common pins [-].

    Args:
        epicyclic: As in the design.
    """
    ratios = module_ratios(epicyclic.compound)
    given = {epicyclic.group(name): gear.module for name, gear in epicyclic.toothed.items() if gear.module is not None}
    known = next(iter(given), None)
    if known is None:
        return ratios
    unit = given[known] / ratios[known]
    return {group: given.get(group, unit * ratio) / unit for group, ratio in ratios.items()}


def _pin(own: PinnedTeeth, body: str) -> float | None:
    """Return the distance of a pin: given, of shifts that are given, or the mean of what its meshes ask."""
    asked, reference = own.asks(body), pin_radii(own.compound, own.modules)[body]
    stated = _given_pin(own, body)
    if stated is None and max(asked) - min(asked) > ROUNDED * reference:
        stated = reference
    if stated is None or max(abs(stated - distance) for distance in asked) <= ROUNDED * reference:
        return None
    return stated


def _given_pin(own: PinnedTeeth, body: str) -> float | None:
    """Return the distance of a pin that its table gives, or both shifts of one of its meshes."""
    given = _written_pins(own, body)
    for step, distance in given.items():
        if (first := next(iter(given))) != step and abs(distance - given[first]) > ROUNDED * distance:
            message = f"{1e3 * distance:g} mm, but {first}, on the same pin, has {1e3 * given[first]:g}; give one"
            raise own.basis(step).refused("centre_distance", message)
    if given:
        step, distance = next(iter(given.items()))
        return distance / _unit(own, step)
    for pair in own.meshes_of(body):
        shifts = [own.epicyclic.toothed[gear].shift for gear in pair]
        if shifts[0] is not None and shifts[1] is not None:
            try:
                centre = own.basis(pair[1]).centre_of(own.total(pair), shifts[0] + shifts[1])
            except DesignError as error:
                raise DesignError(placed(own.key(pair[1]), problem) for problem in error.problems) from None
            return centre * own.modules[own.compound.group(pair[1])]
    return None


def _written_pins(own: PinnedTeeth, body: str) -> dict[str, float]:
    """Return step of a body -> centre distance in its table [m]."""
    planets = own.epicyclic.planets
    return {
        step: distance
        for step, planet in planets.items()
        if own.epicyclic.body(step) == body and (distance := planet.centre_distance) is not None
    }


def _unit(own: PinnedTeeth, step: str) -> float:
    """Return the module of the first group, by any that is given [m]."""
    for gear, entry in own.epicyclic.toothed.items():
        if entry.module is not None:
            return entry.module / own.modules[own.compound.group(gear)]
    message = "shifts follow from a centre distance only with a module; give module_mm of one of its gears, too"
    raise own.basis(step).refused("centre_distance", message)


def _at_pin(own: PinnedTeeth, planet: str, problem: Problem) -> Problem:
    """Return a problem of where a pin stands at what puts it there: a step of the planet, or what its meshes want."""
    key, body = own.key(planet), own.compound.bodies[planet]
    if problem.path != f"{key}.centre_distance":
        return problem
    if (given := next(iter(_written_pins(own, body)), None)) is not None:
        return Problem(f"{own.key(given)}.centre_distance", problem.message)
    if _given_pin(own, body) is not None:
        return Problem(f"{key}.shift", problem.message)
    words = ", ".join(
        f"{central}-{step} {distance:.4g}"
        for (central, step), distance in zip(own.meshes_of(body), own.asks(body), strict=True)
    )
    why = f"its meshes want the pin at different distances from the axis, in modules: {words}; on their mean"
    return Problem(key, f"{why}, {problem.message}")
