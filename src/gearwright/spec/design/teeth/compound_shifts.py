"""Pin positions and profile shift coefficients of compound planetary stages."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from dataclasses import dataclass, replace
from functools import cached_property
from typing import NamedTuple

from gearwright.base import DesignError, Problem, refuse
from gearwright.parts.gears import (
    ISO53_A,
    BasicRack,
    CylindricalGear,
    GearPair,
    ToothShift,
    least_profile_shift,
    reference_centre,
)
from gearwright.parts.planetary import CompoundSet, module_ratios, pin_radii, reaches
from gearwright.spec.design.design import Design
from gearwright.spec.design.rules import GearRules
from gearwright.spec.design.stages import Epicyclic
from gearwright.spec.design.teeth.profile_shifts import (
    WIDEST,
    Basis,
    Keys,
    StageShifts,
    disagreements,
    divided,
    fouling,
    impossible_teeth,
    in_the_root,
    off_the_involute,
    placed,
    refuse_wide,
    shortening,
)

# ----------------------------------------------------------------------------------------------------------------------
# Where the pins of a compound set stand, over one module, and what its meshes with suns and rings so ask of shifts.
# ----------------------------------------------------------------------------------------------------------------------


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


# ----------------------------------------------------------------------------------------------------------------------
# Profile shifts of compound sets: those given, what closes every mesh on the pins of its planets, and balanced rest.
#
# A planet reaches the suns and rings that it meshes with on one distance of its pin from the axis, which all steps of a
# stepped planet share. Gears that such meshes join make a chain: with the pins known, one shift of a chain leaves all
# others. Two planets that mesh are of two chains, and the distance of their pins follows from their shifts.
# ----------------------------------------------------------------------------------------------------------------------


class CompoundShifts(NamedTuple):
    """Profile shifts and tip alterations of the gears of a compound set, and where they mesh."""

    gears: Mapping[str, ToothShift]
    """Gear, as the design calls it -> its shift."""
    meshes: Mapping[str, StageShifts]
    """Mesh, such as ``sun-planet`` -> the shifts of its gears and its centre distance."""

    def shape(self, compound: CompoundSet) -> CompoundSet:
        """Return a set with the centre distances and the tips that the shifts give it.

        Args:
            compound: The set without shifts.
        """
        centres = {pair: self.meshes["-".join(pair)].centre for pair in compound.meshes}
        return replace(
            compound,
            centres={pair: centre for pair, centre in centres.items() if centre is not None},
            heights={gear: 1.0 + sum(shift) for gear, shift in self.gears.items() if any(shift)},
        )


class _Follows(NamedTuple):
    """How the shift of a gear follows from that of the first gear of its chain: x = ``start`` + ``sense`` x_1."""

    start: float
    sense: float


def compound_shifts(design: Design, name: str) -> CompoundShifts:
    """Return the profile shifts of a compound set.

    Args:
        design: As read.
        name: Of the set, whose names all mean something.

    Source: ISO 21771:2007 at every mesh; DIN 3960:1987 for tips; DIN 3992:1964 for balanced shifts.

    Raises:
        DesignError: Shifts and centre distances that contradict each other or make no teeth; with what would.
    """
    epicyclic = design.epicyclics[name]
    own = PinnedTeeth(f"epicyclics.{name}", epicyclic, design.rules(name))
    shifts = {gear: shift for chain in _chains(own) for gear, shift in _chain_shifts(own, chain).items()}
    for central, planet in own.compound.at_centre:
        _held(own, (central, planet), shifts)
    centres = {pair: _centre(own, pair, shifts) for pair in own.compound.meshes}
    gears = {gear: ToothShift(shifts[gear], tip) for gear, tip in zip(shifts, _tips(own, shifts, centres), strict=True)}
    found = CompoundShifts(
        {gear: gears[gear] for gear in epicyclic.toothed},
        {"-".join(pair): StageShifts((gears[pair[0]], gears[pair[1]]), centre) for pair, centre in centres.items()},
    )
    found = _rings_off_the_involute(own, found)
    refuse(_impossible(own, found))
    return found


def _chains(own: PinnedTeeth) -> Iterator[tuple[str, ...]]:
    """Yield the gears of every chain, from a sun on, or from a ring."""
    left = dict.fromkeys(own.epicyclic.toothed)
    while left:
        chain = [next(iter(left))]
        for gear in chain:
            for pair in own.compound.at_centre:
                chain += [mate for mate in pair if gear in pair and mate not in chain]
        left = {gear: None for gear in left if gear not in chain}
        yield tuple(chain)


def _followers(own: PinnedTeeth, chain: tuple[str, ...]) -> dict[str, _Follows]:
    """Return how the shifts of a chain follow from that of its first gear, mesh by mesh."""
    follows = {chain[0]: _Follows(0.0, 1.0)}
    for gear in chain:
        for pair in own.compound.at_centre:
            if gear in pair and (mate := pair[pair[0] == gear]) not in follows:
                start, sense = follows[gear]
                follows[mate] = _Follows(own.asked(pair) - start, -sense)
    return follows


def _chain_shifts(own: PinnedTeeth, chain: tuple[str, ...]) -> dict[str, float]:
    """Return the shifts of a chain: those given, and what closes or balances the rest."""
    given = {gear: shift for gear in chain if (shift := own.epicyclic.toothed[gear].shift) is not None}
    if len(chain) == 1:
        return {chain[0]: given.get(chain[0], 0.0 - own.rules.profile_shift)}
    follows = _followers(own, chain)
    if given:
        gear, shift = next(iter(given.items()))
        first = (shift - follows[gear].start) * follows[gear].sense
    elif own.rules.balanced_shifts is None and all(own.centre(pair) is None for pair in _pairs(own, chain)):
        first = own.rules.profile_shift
    else:
        first = _balanced(own, chain, follows)
    return {gear: given.get(gear, start + sense * first + 0.0) for gear, (start, sense) in follows.items()}


def _pairs(own: PinnedTeeth, chain: tuple[str, ...]) -> list[tuple[str, str]]:
    return [pair for pair in own.compound.at_centre if pair[0] in chain]


def _balanced(own: PinnedTeeth, chain: tuple[str, ...], follows: Mapping[str, _Follows]) -> float:
    """Return the shift of the first gear of a chain with which it and its first mate are balanced [-]."""
    pair = next(pair for pair in _pairs(own, chain) if pair[0] == chain[0])
    driver, driven = pair if own.compound.teeth[pair[0]] > 0 else pair[::-1]
    start, sense = follows[driver]
    ends = [_room(own, gear, follows[gear]) for gear in chain]
    least, most = max(low for low, _ in ends), min(high for _, high in ends)
    within = sorted(start + sense * end for end in (least, most)) if least <= most else [1.0, -1.0]
    teeth = own.compound.teeth[driver], own.compound.teeth[driven]
    with own.naming(pair[1]):
        shift = divided(own.basis(pair[1]), teeth, own.asked(pair), own.centre(pair), within=(within[0], within[1]))
    # Balanced shifts are rounded, limits are not.
    return min(max((shift - start) * sense, least), most)


def _room(own: PinnedTeeth, gear: str, follows: _Follows) -> tuple[float, float]:
    """Return between which shifts of the first gear of its chain a gear is free of undercut, and no wider than any."""
    angles, teeth = own.basis(gear).angles, own.compound.teeth[gear]
    least = -WIDEST
    if teeth > 0:
        least = max(least, least_profile_shift(teeth, ISO53_A.straight_dedendum, **angles))
    low, high = sorted((end - follows.start) * follows.sense for end in (least, WIDEST))
    return low, high


def _loose(own: PinnedTeeth, pair: tuple[str, str]) -> str:
    """Return the gear of a mesh whose shift puts no pin: the sun or ring, but where another mesh of it does alone."""
    shifts = {name: gear.shift for name, gear in own.epicyclic.toothed.items()}
    others = [
        mesh for mesh in own.compound.at_centre if mesh != pair and None not in (shifts[mesh[0]], shifts[mesh[1]])
    ]
    central, planet = (any(gear in mesh for mesh in others) for gear in pair)
    return pair[1] if central and not planet else pair[0]


def _held(own: PinnedTeeth, pair: tuple[str, str], shifts: Mapping[str, float]) -> None:
    """Refuse shifts of a sun or ring and a planet that close elsewhere than on the pin, or are too wide."""
    central, planet = pair
    basis, total, centre = own.basis(planet), own.total(pair), own.centre(pair)
    teeth = own.compound.teeth
    stands = centre or reference_centre(total, 0.0)
    keys = {gear: f"{own.kind(gear)}s.{gear}.shift" for gear in pair}
    named, changed = {key: shifts[gear] for gear, key in keys.items()}, keys[_loose(own, pair)]
    with own.naming(planet):
        wrong = list(disagreements(basis._replace(path=own.path), named, changed=changed, teeth=total, centre=stands))
    refuse(wrong)
    with own.naming(planet):
        for gear in pair:
            if own.epicyclic.toothed[gear].shift is None:
                mates = (teeth[planet], teeth[central]) if teeth[central] < 0 else (teeth[central], teeth[planet])
                refuse_wide(basis, f"{own.kind(gear)} {gear}", shifts[gear], mates)


def _centre(own: PinnedTeeth, pair: tuple[str, str], shifts: Mapping[str, float]) -> float | None:
    """Return the centre distance of a mesh over its module: of the pin, of two planets by their shifts [-]."""
    if pair not in own.compound.between:
        return own.centre(pair if pair[0] in own.epicyclic.centrals else pair[::-1])
    total = shifts[pair[0]] + shifts[pair[1]]
    with own.naming(pair[0]):
        return None if abs(total) <= ROUNDED else own.basis(pair[0]).centre_of(own.total(pair), total)


def _tips(
    own: PinnedTeeth, shifts: Mapping[str, float], centres: Mapping[tuple[str, str], float | None]
) -> Iterator[float]:  # fmt: skip
    """Yield the tip alteration of every gear: given, or what keeps the tip clearance in all its external meshes."""
    for gear in shifts:
        kept = [
            shortening(own.basis(gear), (teeth[0], teeth[1]), tuple(shifts[end] for end in pair), centre)
            for pair, centre in centres.items()
            if gear in pair and min(teeth := [own.compound.teeth[end] for end in pair]) > 0
        ]
        given = own.epicyclic.toothed[gear].tip_alteration
        yield min(kept, default=0.0) if given is None else given


def _rings_off_the_involute(own: PinnedTeeth, found: CompoundShifts) -> CompoundShifts:
    """Return the shifts with the tips of rings as short as the involutes of their planets ask."""
    tips = {
        ring: min(off_the_involute(pair) for pair, outer in _internal(own, found) if outer == ring)
        for ring, entry in own.epicyclic.rings.items()
        if entry.tip_alteration is None
    }
    gears = {
        gear: shift._replace(tip_alteration=tips.get(gear, shift.tip_alteration)) for gear, shift in found.gears.items()
    }
    meshes = {
        "-".join(pair): found.meshes["-".join(pair)]._replace(gears=(gears[pair[0]], gears[pair[1]]))
        for pair in own.compound.meshes
    }
    return CompoundShifts(gears, meshes)


def _internal(own: PinnedTeeth, found: CompoundShifts) -> Iterator[tuple[GearPair, str]]:
    """Yield every mesh with a ring in a module of one metre, and the ring."""
    for ring, planet in own.compound.at_centre:
        if ring in own.epicyclic.rings:
            yield _mesh(own, found, (planet, ring)), ring


def _mesh(own: PinnedTeeth, found: CompoundShifts, ends: tuple[str, str]) -> GearPair:
    """Return a mesh in a module of one metre."""
    first, second = (_shape(own, found, gear) for gear in ends)
    if ends[1] in own.epicyclic.rings:
        second = replace(second, teeth=-second.teeth)
    return GearPair(first, second, found.meshes["-".join(ends)].centre)


def _shape(own: PinnedTeeth, found: CompoundShifts, gear: str) -> CylindricalGear:
    shift, rack = found.gears[gear], BasicRack(pressure_angle=own.rules.pressure_angle)
    return CylindricalGear(
        abs(own.compound.teeth[gear]), 1.0, 1.0, 0.0, shift.profile_shift, rack, shift.tip_alteration
    )  # fmt: skip


def _impossible(own: PinnedTeeth, found: CompoundShifts) -> Iterator[Problem]:
    for gear in own.epicyclic.toothed:
        if gear not in own.epicyclic.rings:
            yield from impossible_teeth(_keys(own, gear), _shape(own, found, gear))
    for pair, ring in _internal(own, found):
        yield from fouling(_keys(own, ring), pair)
    keys = {gear: _keys(own, gear) for gear in own.epicyclic.toothed}
    yield from in_the_root(keys, {ends: _mesh(own, found, ends) for ends in own.compound.meshes})


def _keys(own: PinnedTeeth, gear: str) -> Keys:
    path, module = own.key(gear), own.epicyclic.module(gear)
    return Keys(f"{path}.shift", f"{path}.teeth", "tip_alteration", module)
