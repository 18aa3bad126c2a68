"""Search by brute force for the lightest gearbox that passes, among those that a design leaves open.

A design of `oracle_designs` leaves modules and face widths open, often teeth and numbers of planets. Whatever the
search tries is written into the design and sized by `gearwright.size`, with every module, width, tooth number and
number of planets given, so that nothing here depends on how `size` chooses. Tried are the modules of ISO 54 from four
below to six above the chosen one, the teeth within the tolerance of the ratio that can be put together, two planets to
five, and of each combination whole millimetres of face width, down to the least that passes, none below the least that
rules of rating methods let `size` choose. The 60 combinations of a stage are looked at that are the lightest by an
estimate from the margins of the choice. Stages that share no axis are tried one after the other, twice at most; those
on common axes together.

What weighs is the complete gearbox, as `complete_mass` has it. What passes: every check of `size`. Where none is found
of a design whose own choice fails some, the lightest is looked for that fails no other check, and those no worse.

A combination that fails at the face width with which it would weigh as much as the best that is known is left out, as a
narrower face bears less. That is so but for resonances of the mesh, which may let a narrower face pass: where the
choice fails and combinations are few, their widths are looked through, and `exhaust` tells what is hidden elsewhere.
What is found is therefore a gearbox that exists, not always the lightest of all.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from itertools import product
from typing import Any, NamedTuple

from gearwright import DesignError, complete_mass, edited, size
from gearwright.sizing.result import Sizing
from gearwright.spec import Design, Epicyclic, Pair, Planetary
from gearwright.spec.design import relative_modules

MODULES = (
    1.0, 1.125, 1.25, 1.375, 1.5, 1.75, 2.0, 2.25, 2.5, 2.75, 3.0, 3.5, 4.0, 4.5, 5.0, 5.5, 6.0, 7.0, 8.0, 9.0, 10.0,
    11.0, 12.0, 14.0, 16.0, 18.0, 20.0, 22.0, 25.0, 28.0, 32.0, 36.0, 40.0, 45.0, 50.0,
)  # fmt: skip
"""Series I and II of ISO 54:1996 [mm]."""
BELOW, ABOVE = 4, 6
"""Steps of them that are tried on either side of the chosen one [-]."""
MOST = 80
"""Sizings of one design; half as many more where none is found that passes [-]."""
SHARES = (0.65, 0.35)
"""Parts of them in the first and the second round over several stages [-]."""
FAR = 0.8
"""Face width that is estimated over the one with which a combination weighs as much as the best that is known, below
which it is tried first [-]."""
LARGEST = 10.0
"""Mass of the best that is known over that of the choice, of which the search takes notice [-]."""
HOPELESS, TRIED = 0.7, 40
"""Ratio that some combination has come to in every check by so many sizings, or the search for one that passes is given
up [-]."""
WORTH = 1.3
"""Estimate of a combination's mass over that of the choice up to which it is looked at [-]."""
STEEP = 1.5
"""Mass of a gearbox for every millimetre of face width over that of its gears [-], about."""
WIDER = 1.4
"""Estimated face width over the widest that is allowed up to which a combination is looked at [-]."""
CONSIDERED = 60
"""Combinations of one stage that are looked at [-]."""
LOOSE = (1.1, 1.4, 9.0)
"""Face widths that are tried over the estimate where no lighter gearbox is known, the last as wide as allowed [-]."""
TOGETHER = (1.1, 1.2, 1.3, 1.4, 1.6, 1.8, 2.2, 9.0)
"""Likewise, of several face widths at once [-]."""
FEW, WIDTHS = 12, 20
"""Combinations whose face widths are looked through where resonances part those that pass, and how many of each [-]."""
TIGHT = 1e-9
"""Of a ratio that counts as rounding [-]."""

Changes = dict[str, Any]
"""Dotted path -> value, as `edited` takes them."""


# ----------------------------------------------------------------------------------------------------------------------
# What comes of a design with some entries given.
# ----------------------------------------------------------------------------------------------------------------------


class Outcome(NamedTuple):
    """A sized design as the search reads it."""

    mass: float
    """Complete [kg]."""
    ratios: Mapping[str, float]
    """Name of a check -> its least value over limit [-], of what is assessed and not waived."""

    @property
    def failing(self) -> dict[str, float]:
        """Checks that fail, with their ratios."""
        return {name: ratio for name, ratio in self.ratios.items() if ratio < 1.0 - TIGHT}

    def width_factor(self, stage: str) -> float:
        """Return by what the face width of a stage could change until it is just strong enough, roughly [-]."""
        bending, pitting = strengths(self.ratios, stage)
        return max(1.0 / bending, 1.0 / pitting**2)


def outcome_of(sizing: Sizing) -> Outcome:
    """Return mass and checks of a sizing.

    Args:
        sizing: Any.
    """
    ratios = dict[str, float]()
    for check in sizing.checks:
        if check.ratio is not None and not check.waiver:
            ratios[check.name] = min(check.ratio, ratios.get(check.name, math.inf))
    return Outcome(complete_mass(sizing).total, ratios)


def strengths(ratios: Mapping[str, float], stage: str) -> tuple[float, float]:
    """Return the least ratios of a stage's roots and flanks [-]; 1 where it has none.

    Args:
        ratios: Name of a check -> its ratio.
        stage: Its name.
    """

    def least(modes: tuple[str, ...]) -> float:
        own = (ratio for name, ratio in ratios.items() if stage_of(name) == stage and name.endswith(modes))
        return max(min(own, default=1.0), 1e-3)

    return least(("tooth root",)), least(("pitting", "scuffing"))


def stage_of(check: str) -> str:
    """Return the stage of a check, by its name.

    Args:
        check: Such as ``set.sun pitting``.
    """
    return check.split(" ")[0].split(".")[0]


Accepts = Callable[[Outcome], bool]
"""What an outcome has to meet."""


@dataclass
class Trials:
    """The sizings of one design."""

    design: Design
    most: int = MOST
    """Sizings that may be made [-]."""
    known: dict[tuple[tuple[str, Any], ...], Outcome | None] = field(default_factory=dict)

    @property
    def spent(self) -> bool:
        """Whether no more may be made."""
        return len(self.known) >= self.most

    def hopeless(self, accepts: Accepts) -> bool:
        """Tell whether one and the same check is far from its limit in all that was tried."""
        outcomes = [outcome for outcome in self.known.values() if outcome is not None]
        most = dict[str, float]()
        for outcome in outcomes:
            for name, ratio in outcome.ratios.items():
                most[name] = max(ratio, most.get(name, 0.0))
        lost = {name: ratio for name, ratio in most.items() if ratio < HOPELESS}
        return bool(outcomes) and not accepts(outcomes[0]._replace(ratios=lost))

    def of(self, changes: Changes) -> Outcome | None:
        """Return what comes of some changes; None where the design is refused.

        Args:
            changes: Of the open design.
        """
        key = tuple(sorted(changes.items()))
        if key not in self.known:
            try:
                self.known[key] = outcome_of(size(edited(self.design, changes)))
            except DesignError:
                self.known[key] = None
        return self.known[key]


# ----------------------------------------------------------------------------------------------------------------------
# Asked ratios and tooth numbers that can be made and put together.
# ----------------------------------------------------------------------------------------------------------------------


def asked_ratios(design: Design) -> dict[str, float]:
    """Return stage -> z_2/z_1 or z_r/z_s that speeds of machines and given ratios ask for, as far as they tell.

    Args:
        design: As read.
    """
    speeds = {"ground": 0.0} | {
        machine.shaft: machine.asked_speed for machine in design.machines.values() if machine.asked_speed is not None
    }
    found = dict[str, float]()
    for _ in range(len(design.simple_stages)):
        for name, stage in design.simple_stages.items():
            if isinstance(stage, Pair):
                _ask_pair(name, stage, speeds, found)
            else:
                _ask_set(name, stage, speeds, found)
    return found


def _ask_pair(name: str, pair: Pair, speeds: dict[str, float], found: dict[str, float]) -> None:
    pinions, wheels = _names(pair.pinion), _names(pair.wheel)
    fast = next((speeds[shaft] for shaft in pinions if shaft in speeds), None)
    slow = next((speeds[shaft] for shaft in wheels if shaft in speeds), None)
    ratio = pair.ratio
    if pair.pinion_teeth and pair.wheel_teeth:
        ratio = pair.wheel_teeth / pair.pinion_teeth
    if ratio is None and fast and slow:
        ratio = abs(fast / slow)
    if ratio is not None:
        found[name] = ratio
        if fast and slow is None:
            speeds.update(dict.fromkeys(wheels, fast / ratio))


def _names(side: object) -> list[str]:
    return [str(name) for name in side] if isinstance(side, tuple | list) else [str(side)]


def _ask_set(name: str, stage: Planetary, speeds: dict[str, float], found: dict[str, float]) -> None:
    sun, ring, carrier = (speeds.get(shaft) for shaft in (stage.sun, stage.ring, stage.carrier))
    ratio = None if stage.ratio is None else stage.ratio - 1.0
    if stage.known_teeth is not None:
        ratio = stage.known_teeth[2] / stage.known_teeth[0]
    if ratio is None and None not in (sun, ring, carrier):
        assert sun is not None and ring is not None and carrier is not None
        ratio = abs((sun - carrier) / (ring - carrier))
    if ratio is None:
        return
    found[name] = ratio
    if sun is not None and carrier is None and ring == 0.0:
        speeds[stage.carrier] = sun / (1.0 + ratio)
    elif sun is not None and ring is None and carrier == 0.0:
        speeds[stage.ring] = sun / ratio


class Teeth(NamedTuple):
    """Tooth numbers of a stage, of sun, planet and ring or of pinion and wheel, and its number of planets."""

    numbers: tuple[int, ...]
    planets: int = 1


def set_choices(design: Design, name: str, ratio: float, counts: Iterable[int]) -> Iterator[Teeth]:
    """Yield the teeth of a planetary set that can be put together and come near enough to its ratio.

    Args:
        design: With the rules of the search.
        name: Of the set.
        ratio: z_r/z_s that is asked [-].
        counts: Numbers of planets that are looked at [-].
    """
    rules, stage = design.teeth, design.planetaries[name]
    given = stage.known_teeth
    for count in counts:
        for sun in range(rules.sun_minimum, (rules.sun_maximum or 59) + 1):
            middle = sun * (ratio - 1.0) / 2.0
            for planet in range(max(math.floor(0.95 * middle) - 2, rules.planet_minimum), math.ceil(1.05 * middle) + 3):
                teeth = (sun, planet, sun + 2 * planet)
                near = abs((1.0 + teeth[2] / sun) / (1.0 + ratio) - 1.0) <= rules.stage_tolerance
                if given is None and near and _stands(teeth, count):
                    yield Teeth(teeth, count)
        if given is not None and _stands(given, count):
            yield Teeth(tuple(given), count)


def _stands(teeth: tuple[int, ...], planets: int) -> bool:
    sun, planet, ring = teeth
    return (sun + ring) % planets == 0 and (sun + planet) * math.sin(math.pi / planets) > planet + 2.0


def pair_choices(design: Design, name: str, ratio: float) -> Iterator[Teeth]:
    """Yield the teeth of a pair that come near enough to its ratio.

    Args:
        design: With the rules of the search.
        name: Of the pair.
        ratio: z_2/z_1 that is asked [-].
    """
    rules, pair = design.teeth, design.pairs[name]
    if pair.pinion_teeth and pair.wheel_teeth:
        yield Teeth((pair.pinion_teeth, pair.wheel_teeth))
        return
    gears = design.rules(name)
    lean = 0.0 if pair.kind != "cylindrical" else gears.helix_angle
    transverse = math.atan(math.tan(gears.pressure_angle) / math.cos(lean))
    fewest = 12 if pair.kind == "bevel" else math.ceil(2.0 * math.cos(lean) / math.sin(transverse) ** 2)
    for pinion in range(rules.pinion_minimum or fewest, rules.pinion_maximum + 1):
        for wheel in range(math.floor(0.95 * ratio * pinion), math.ceil(1.05 * ratio * pinion) + 1):
            if wheel >= fewest and abs(wheel / pinion / ratio - 1.0) <= rules.stage_tolerance:
                yield Teeth((pinion, wheel))


# ----------------------------------------------------------------------------------------------------------------------
# Blocks: what is tried together, and combinations of its modules, teeth and planets with an estimate of their mass.
# ----------------------------------------------------------------------------------------------------------------------


class Combination(NamedTuple):
    """Modules, teeth and planets of a block, without its face widths."""

    changes: Changes
    low: tuple[int, ...]
    """Narrowest faces that its rules allow [mm]."""
    cap: tuple[int, ...]
    """Widest [mm]."""
    guess: tuple[float, ...]
    """Face widths that strength asks for, by the margins of the choice [mm]."""
    volume: float
    """Of its gears for one millimetre of width, to compare them."""
    reach: float
    """Length times breadth of its gears, to compare them."""

    @property
    def size(self) -> float:
        """Volume of its gears, to compare them."""
        return self.volume * (sum(map(max, self.guess, self.low)) or 1.0)


class Weight(NamedTuple):
    """What the stages of a block weigh as they are chosen, by which others are estimated."""

    gears: float
    """Mass of their gears [kg]."""
    rest: float
    """Their share of all else [kg], which goes with the area that the gears take up."""
    volume: float
    """As of combinations, times face widths."""
    reach: float
    """As of combinations."""
    mass: float
    """Of the whole choice [kg]."""

    def of(self, own: Combination) -> float:
        """Return about what a combination weighs [kg]."""
        return self.gears * own.size / self.volume + self.rest * own.reach / self.reach

    def per_width(self, own: Combination) -> float:
        """Return what the gears of a combination weigh for a millimetre of face width [kg]."""
        return self.gears * own.volume / self.volume

    def even(self, own: Combination, mass: float) -> float:
        """Return about the face width with which the whole weighs so much [mm].

        Args:
            own: Combination of one face width.
            mass: [kg].
        """
        left = self.gears + self.rest * (1.0 - own.reach / self.reach) - (self.mass - mass)
        return left / self.per_width(own)


@dataclass(frozen=True)
class Block:
    """Stages that are tried together."""

    stages: tuple[str, ...]
    widths: tuple[str, ...]
    """Paths of the face widths, in millimetres; none where no standard proportions them."""
    start: Changes
    """The choice of `size`, written out."""
    combinations: tuple[Combination, ...]
    """The most promising first."""
    choice: Weight


def modules_around(module: float) -> list[float]:
    """Return the standard modules around one, and that one [mm].

    Args:
        module: [mm].
    """
    place = next((at for at, one in enumerate(MODULES) if one >= module * (1.0 - 1e-6)), len(MODULES) - 1)
    return sorted({*MODULES[max(place - BELOW, 0) : place + ABOVE + 1], round(module, 9)})


def blocks_of(design: Design, sizing: Sizing) -> list[Block]:
    """Return the blocks of a design.

    Args:
        design: With its freedoms.
        sizing: With its choice.
    """
    found = list[Block]()
    tied = {pair.coaxial_with: name for name, pair in design.pairs.items() if pair.coaxial_with}
    asked = asked_ratios(design)
    for name, stage in design.stages.items():
        if not isinstance(stage, Epicyclic) and (stage.module or stage.face_width):
            continue
        if isinstance(stage, Epicyclic):
            found.append(_compound(design, sizing, name))
        elif name in tied:
            found.append(_on_axes(design, sizing, name, tied[name]))
        elif name not in tied.values():
            found.append(_alone(design, sizing, name, asked.get(name)))
    return found


def _gears(sizing: Sizing, stage: str) -> list[Any]:
    return [gear for gear in sizing.gears if gear.stage == stage]


def _weight(sizing: Sizing, stages: Iterable[str]) -> float:
    return math.fsum(gear.mass * gear.bodies for stage in stages for gear in _gears(sizing, stage))


def _weighed(sizing: Sizing, stages: Iterable[str], volume: float, reach: float) -> Weight:
    own, every = _weight(sizing, stages), _weight(sizing, sizing.design.stages)
    mass = complete_mass(sizing).total
    return Weight(own, (mass - every) * own / every, volume, reach, mass)


class Faces(NamedTuple):
    """How wide faces may be and are chosen."""

    diameters: float
    """Widest over the pinion's diameter [-]."""
    modules: float
    """Widest over the module [-]."""
    narrowest: float
    """Narrowest over the module [-]."""
    overlap: float
    """Overlap ratio that is asked of helical teeth [-]."""

    def least(self, module: float, lean: float) -> float:
        """Return the narrowest face that is chosen [mm].

        Args:
            module: [mm].
            lean: Of the teeth [rad].
        """
        return max(self.narrowest * module, self.overlap * math.pi * module / math.sin(lean) if lean else 0.0)


def _proportions(design: Design, stage: str) -> Faces | None:
    """Return how wide faces of a stage may be; None where no standard says so."""
    rules = design.rules(stage)
    method = {"iso10300": "iso6336"}.get(design.rating(stage), design.rating(stage))
    own = getattr(rules, method.replace("-2006", ""), None)
    if own is None or method == "lewis-hertz":
        return None
    return Faces(own.widest_diameters, own.widest_modules, own.narrowest_modules, rules.overlap_ratio)


def _alone(design: Design, sizing: Sizing, name: str, asked: float | None) -> Block:
    """Return the block of a pair or planetary set that shares no axis whose distance matters."""
    stage, table = design.simple_stages[name], design.table(name)
    is_set, gears = isinstance(stage, Planetary), _gears(sizing, name)
    bevel = isinstance(stage, Pair) and stage.kind == "bevel"
    lean = 0.0 if is_set else gears[0].helix_angle
    order = ("sun", "planet", "ring") if is_set else ("pinion", "wheel")
    of = {gear.role.value: gear for gear in gears}
    teeth, width = tuple(of[role].teeth for role in order), 1e3 * gears[0].face_width
    module = 1e3 * gears[0].module
    if bevel:
        module = module / math.cos(lean) + width / math.hypot(*teeth)
    planets = sizing.design.planetaries[name].planets if is_set else 1
    chosen = Teeth(teeth, planets or 1)
    key, limits = f"{table}.{'outer_module_mm' if bevel else 'module_mm'}", _proportions(design, name)
    widths = (f"{table}.face_width_mm",) if limits is not None else ()

    def written(own: Teeth, size_: float) -> Changes:
        found: Changes = {key: round(size_, 9)}
        keys = {f"{table}.{role}_teeth": z for role, z in zip(order, own.numbers, strict=True)}
        if any(getattr(stage, f"{role}_teeth") is None for role in order):
            found |= keys | ({f"{table}.ratio": None} if stage.ratio is not None else {})
        if is_set and design.planetaries[name].planets_given is None:
            found[f"{table}.planets"] = own.planets
        return found

    choices = [chosen]
    if isinstance(stage, Planetary):
        given = stage.planets_given
        counts = (given,) if given is not None else range(2, design.teeth.planets_maximum + 1)
        choices += set_choices(design, name, asked if asked is not None else teeth[2] / teeth[0], counts)
    elif not stage.pinion_teeth or not stage.wheel_teeth:
        choices += pair_choices(design, name, asked if asked is not None else teeth[1] / teeth[0])
    margins = strengths(outcome_of(sizing).ratios, name)
    needs = _needs(chosen, module)
    combinations = []
    for own, size_ in product(dict.fromkeys(choices), modules_around(module)):
        rolls, flanks = _needs(own, size_)
        guess = width * max(rolls / needs[0] / margins[0], flanks / needs[1] / margins[1] ** 2)
        cap, low = width, 1.0
        if limits is not None:
            cap = min(limits.diameters * size_ * own.numbers[0] / math.cos(lean), limits.modules * size_)
            low = limits.least(size_, lean)
            if bevel:
                cone = math.hypot(*own.numbers) / 2.0
                cap = min(cone / 3.0, 10.0) * size_
                mean = math.cos(lean) * (size_ - cap / (2.0 * cone))
                low = limits.least(mean, lean)
        most = max(math.floor(cap + 1e-9), 1)
        least = min(math.ceil(low - 1e-9), most)
        combination = Combination(
            written(own, size_), (least,), (most,), (guess,), _volume(own, size_, lean), _reach(own, size_, lean)
        )
        combinations.append(combination if widths else combination._replace(low=(), cap=(), guess=()))
    volume = _volume(chosen, module, lean) * (width if widths else 1.0)
    start = written(chosen, module) | ({widths[0]: round(width, 6)} if widths else {})
    weight = _weighed(sizing, (name,), volume, _reach(chosen, module, lean))
    return Block((name,), widths, start, _promising(combinations, weight), weight)


SHARING = {2: 1.05, 3: 1.05, 4: 1.15, 5: 1.25}
"""Planets -> about what K_γ is, for estimates alone [-]."""


def _needs(own: Teeth, module: float) -> tuple[float, float]:
    """Return the face widths that roots and flanks ask for, to compare combinations."""
    first, second = (module * z for z in own.numbers[:2])
    share = SHARING.get(own.planets, 1.0) / own.planets
    return share / (first * module), share / first * (1.0 / first + 1.0 / second)


def _volume(own: Teeth, module: float, lean: float) -> float:
    """Return what gears of one millimetre of width fill, to compare combinations."""
    if len(own.numbers) == 2:
        return sum(z**2 for z in own.numbers) * (module / math.cos(lean)) ** 2
    sun, planet, ring = own.numbers
    return float(sun**2 + own.planets * planet**2 + 4.0 * ring * 3.95) * module**2


def _reach(own: Teeth, module: float, lean: float) -> float:
    """Return length times breadth of gears, to compare combinations."""
    first, *_, last = own.numbers
    length = max(own.numbers) if len(own.numbers) == 3 else first + last
    return length * max(own.numbers) * (module / math.cos(lean)) ** 2


def _promising(combinations: Sequence[Combination], choice: Weight) -> tuple[Combination, ...]:
    """Return the combinations that may be light, the lightest by their estimate first.

    Args:
        combinations: Of a stage.
        choice: What they are held against.
    """
    fits = [one for one in combinations if all(g <= WIDER * cap for g, cap in zip(one.guess, one.cap, strict=True))]
    light = [one for one in fits if choice.of(one) <= WORTH * (choice.gears + choice.rest)]
    return tuple(sorted(light, key=choice.of)[:CONSIDERED])


def _compound(design: Design, sizing: Sizing, name: str) -> Block:
    """Return the block of a compound set: one module that sets the others, a face width for every group of gears."""
    epicyclic = design.epicyclics[name]
    ratios = relative_modules(epicyclic)
    tables = {gear: kind for kind in ("suns", "rings", "planets") for gear in getattr(epicyclic, kind)}
    of = {gear.own: gear for gear in _gears(sizing, name)}
    groups = {group: [gear for gear in epicyclic.toothed if epicyclic.group(gear) == group] for group in ratios}
    first = next(group for group, ratio in ratios.items() if abs(ratio - 1.0) < 1e-12)
    path = f"epicyclics.{name}"
    lead = groups[first][0]
    key = f"{path}.{tables[lead]}.{lead}.module_mm"
    unit = 1e3 * of[lead].module
    # A gear that meshes in two planes is as long as both faces: a gear of one plane tells the width of its group.
    width_of = {group: 1e3 * min(of[gear].face_width for gear in own) for group, own in groups.items()}
    widths = tuple(f"{path}.{tables[own[0]]}.{own[0]}.face_width_mm" for own in groups.values())
    limits = _proportions(design, name)
    volumes = {
        group: sum((of[gear].teeth * ratios[group]) ** 2 * of[gear].bodies for gear in own)
        for group, own in groups.items()
    }
    combinations = []
    for module in modules_around(unit):
        low, cap, guess = [], [], []
        for group, own in groups.items():
            size_ = ratios[group] * module
            least = min(of[gear].teeth for gear in own)
            most = min(limits.modules, limits.diameters * least) * size_ if limits else 2.0 * width_of[group]
            cap.append(max(math.floor(most + 1e-9), 1))
            low.append(min(math.ceil((limits.least(size_, 0.0) if limits else size_) - 1e-9), cap[-1]))
            guess.append(width_of[group] * (unit / module) ** 2)
        combinations.append(
            Combination(
                {key: round(module, 9)},
                tuple(low),
                tuple(cap),
                tuple(guess),
                module**2 * sum(volumes.values()),
                module**2,
            )
        )
    start = {key: round(unit, 9)} | {at: round(w, 6) for at, w in zip(widths, width_of.values(), strict=True)}
    whole = unit**2 * sum(volumes.values()) * sum(width_of.values())
    return Block((name,), widths, start, tuple(combinations), _weighed(sizing, (name,), whole, unit**2))


AXES = (0.70, 0.75, 0.80, 0.84, 0.88, 0.92, 0.96, 1.0, 1.04, 1.08, 1.15)
"""Factors on the modules of pairs on common axes, which are no standard ones [-]."""


def _on_axes(design: Design, sizing: Sizing, first: str, second: str) -> Block:
    """Return the block of two pairs of one centre distance, whose teeth are given."""
    gears = {name: _gears(sizing, name) for name in (first, second)}
    modules = {name: 1e3 * own[0].module for name, own in gears.items()}
    width = {name: 1e3 * own[0].face_width for name, own in gears.items()}
    widths = tuple(f"pairs.{name}.face_width_mm" for name in gears)
    combinations = []
    for factor in AXES:
        low, cap, guess = [], [], []
        for name, own in gears.items():
            limits = _proportions(design, name)
            assert limits is not None
            lean, module = own[0].helix_angle, factor * modules[name]
            pinion = next(gear.teeth for gear in own if gear.role.value == "pinion")
            most = min(limits.diameters * pinion / math.cos(lean), limits.modules) * module
            cap.append(math.floor(most + 1e-9))
            low.append(min(math.ceil(limits.least(module, lean) - 1e-9), cap[-1]))
            guess.append(width[name] / factor**2)
        changes = {f"pairs.{name}.module_mm": round(factor * module, 9) for name, module in modules.items()}
        combinations.append(Combination(changes, tuple(low), tuple(cap), tuple(guess), factor**2, factor**2))
    start = {f"pairs.{name}.module_mm": round(module, 9) for name, module in modules.items()}
    start |= {at: round(w, 6) for at, w in zip(widths, width.values(), strict=True)}
    weight = _weighed(sizing, gears, sum(width.values()), 1.0)
    return Block((first, second), widths, start, tuple(combinations), weight)


# ----------------------------------------------------------------------------------------------------------------------
# The search: of every combination the least face widths that pass, as long as they may be lighter than the best.
# ----------------------------------------------------------------------------------------------------------------------


def passes(outcome: Outcome) -> bool:
    """Tell whether every check passes.

    Args:
        outcome: Of a sizing.
    """
    return not outcome.failing


def no_worse_than(choice: Outcome) -> Accepts:
    """Return what tells whether an outcome fails nothing that a choice does not fail as badly.

    Args:
        choice: That fails something.
    """
    allowed = choice.failing

    def accepts(outcome: Outcome) -> bool:
        return all(ratio >= allowed.get(name, 1.0) - 1e-9 for name, ratio in outcome.failing.items())

    return accepts


@dataclass
class Best:
    """The lightest that is known."""

    changes: Changes
    mass: float = math.inf
    """[kg]; infinite where none is accepted yet."""


def improve(trials: Trials, block: Block, best: Best, accepts: Accepts) -> None:
    """Look through the combinations of a block for a lighter one that is accepted.

    Args:
        trials: Of the design.
        block: What is tried.
        best: Where the search stands; it is changed.
        accepts: What an outcome has to meet.
    """
    others = {path: value for path, value in best.changes.items() if path not in block.start}
    begun, narrowed = len(trials.known), _faces if len(block.widths) > 1 else _face
    for loose in LOOSE:
        for combination in block.combinations:
            hopeless = best.mass == math.inf and len(trials.known) > begun + TRIED and trials.hopeless(accepts)
            if trials.spent or hopeless:
                return
            base = {**others, **combination.changes}
            asked = Asked(best.mass, accepts, loose)
            for changes, mass in narrowed(trials, block, base, combination, asked):
                if mass < best.mass * (1.0 - TIGHT):
                    best.changes, best.mass = changes, mass
        if best.mass < math.inf:
            return


class Asked(NamedTuple):
    """What a combination has to meet."""

    limit: float
    """Mass below which it is of interest [kg]."""
    accepts: Accepts
    loose: float
    """Face width that is tried over the estimate where no gearbox is known [-]."""


def _face(
    trials: Trials, block: Block, base: Changes, own: Combination, asked: Asked
) -> Iterator[tuple[Changes, float]]:
    """Yield a combination of one face width, or of none, if it is accepted and lighter than a limit [kg]."""
    limit, accepts = asked.limit, asked.accepts
    if not block.widths:
        outcome = trials.of(base)
        if outcome is not None and outcome.mass < limit and accepts(outcome):
            yield base, outcome.mass
        return
    (path,), (low,), (cap,) = block.widths, own.low, own.cap

    def at(width: int) -> Outcome | None:
        return trials.of({**base, path: width})

    width: int | None = min(max(math.ceil(asked.loose * own.guess[0]), low), cap)
    assert width is not None
    even = block.choice.even(own, min(limit, LARGEST * block.choice.mass))
    if limit < math.inf and width < FAR * even and accepted(at(width), accepts):
        pass  # the best that is known is a heavy one: narrowed from there
    elif limit < math.inf:
        start = min(max(round(even), low), cap)
        width = _break_even(at, (low, start, cap), limit, STEEP * block.choice.per_width(own))
    if width is None or not accepted(at(width), accepts):
        return
    width = _narrowest(at, low, width, accepts, block.stages[0])
    outcome = at(width)
    assert outcome is not None
    yield {**base, path: width}, outcome.mass


def accepted(outcome: Outcome | None, accepts: Accepts) -> bool:
    """Tell whether there is an outcome, and it is accepted.

    Args:
        outcome: Of a trial.
        accepts: What it has to meet.
    """
    return outcome is not None and accepts(outcome)


def _break_even(
    at: Callable[[int], Outcome | None], widths: tuple[int, int, int], limit: float, slope: float
) -> int | None:
    """Return about the widest face with which a combination is lighter than a limit; None where none is.

    Args:
        at: Face width [mm] -> what comes of it.
        widths: The narrowest, where to start, and the widest [mm].
        limit: Mass [kg].
        slope: Mass for one millimetre [kg], roughly.
    """
    low, width, cap = widths
    for _ in range(4):
        outcome = at(width)
        if outcome is None:
            return None
        wanted = min(max(width + math.floor((limit - outcome.mass) / slope), low), cap)
        if outcome.mass < limit and abs(wanted - width) <= max(1, 0.02 * width):
            return width
        if wanted == width:
            return None
        width = wanted
    outcome = at(width)
    return width if outcome is not None and outcome.mass < limit else None


def _narrowest(at: Callable[[int], Outcome | None], low: int, width: int, accepts: Accepts, stage: str) -> int:
    """Return the least face width down from one that is accepted, by its strength and then by halves [mm].

    Args:
        at: Face width [mm] -> what comes of it.
        low: The narrowest [mm].
        width: One that is accepted [mm].
        accepts: What an outcome has to meet.
        stage: Whose strength tells where to look.
    """
    low -= 1
    by_strength = True
    while width - low > 1:
        outcome = at(width)
        assert outcome is not None
        middle = (low + width) // 2
        if by_strength:
            middle = min(max(math.ceil(width * outcome.width_factor(stage)), low + 1), width - 1)
        if accepted(at(middle), accepts):
            width, by_strength = middle, True
        else:
            low, by_strength = middle, not by_strength
    return width


def _faces(
    trials: Trials, block: Block, base: Changes, own: Combination, asked: Asked
) -> Iterator[tuple[Changes, float]]:
    """Yield a combination of several face widths, each narrowed in turn, if it is accepted."""
    limit, accepts = asked.limit, asked.accepts
    bounds = list(zip(own.guess, own.low, own.cap, strict=True))
    tries = ([min(max(math.ceil(factor * guess), low), cap) for guess, low, cap in bounds] for factor in TOGETHER)
    widths = next((tried for tried in tries if accepted(_at(trials, block, base, tried), accepts)), None)
    if widths is None:
        return
    for place, low in enumerate(own.low):

        def at(width: int, place: int = place, widths: list[int] = widths) -> Outcome | None:
            return _at(trials, block, base, [*widths[:place], width, *widths[place + 1 :]])

        widths[place] = _narrowest(at, low, widths[place], accepts, block.stages[min(place, len(block.stages) - 1)])
    outcome = _at(trials, block, base, widths)
    if outcome is not None and outcome.mass < limit:
        yield {**base, **dict(zip(block.widths, widths, strict=True))}, outcome.mass


def _at(trials: Trials, block: Block, base: Changes, widths: Sequence[int]) -> Outcome | None:
    return trials.of({**base, **dict(zip(block.widths, widths, strict=True))})


def searched(trials: Trials, blocks: Sequence[Block], choice: Outcome) -> tuple[Changes, Outcome | None]:
    """Return the lightest that passes, and what comes of it; without any, the lightest no worse than the choice.

    Args:
        trials: Of the design.
        blocks: From `blocks_of`.
        choice: Of `size`.
    """
    start: Changes = {path: value for block in blocks for path, value in block.start.items()}
    best, most = Best(dict(start)), trials.most
    for share in SHARES if len(blocks) > 1 else (1.0,):
        before = best.mass
        for block in blocks:
            trials.most = len(trials.known) + math.ceil(share * most / len(blocks))
            _improve_one(trials, block, best, choice)
        if best.mass >= before < math.inf:
            break
    if not passes(choice) and accepted(trials.of(best.changes), passes):  # the first that passes may be a heavy one
        for block in blocks:
            trials.most = len(trials.known) + math.ceil(0.6 * most / len(blocks))
            _improve_one(trials, block, best, choice)
    if not passes(choice) and len(blocks) == 1 and len(blocks[0].widths) == 1:
        _scan(trials, blocks[0], best)
    found = trials.of(best.changes)
    if found is not None and passes(found):
        return best.changes, found
    best = Best(dict(start), choice.mass)
    for block in blocks:
        trials.most = len(trials.known) + math.ceil(0.5 * most / len(blocks))
        improve(trials, block, best, no_worse_than(choice))
    return best.changes, trials.of(best.changes)


def _scan(trials: Trials, block: Block, best: Best) -> None:
    """Look through few combinations of one face width from narrow to wide: between resonances some may pass."""
    limit = best.mass if accepted(trials.of(best.changes), passes) else math.inf
    hopeless = limit == math.inf and len(trials.known) > TRIED and trials.hopeless(passes)
    if len(block.combinations) > FEW or hopeless:
        return
    for own in block.combinations:
        (low,), (cap,) = own.low, own.cap
        step = max(1, (cap - low) // WIDTHS)
        for width in range(low, cap + 1, step):
            changes = {**own.changes, block.widths[0]: width}
            outcome = trials.of(changes)
            if outcome is None or outcome.mass >= limit:
                break
            if passes(outcome):
                finer = ({**changes, block.widths[0]: less} for less in range(max(low, width - step + 1), width))
                best.changes = next((one for one in finer if accepted(trials.of(one), passes)), changes)
                found = trials.of(best.changes)
                assert found is not None
                limit = best.mass = found.mass
                break


def _improve_one(trials: Trials, block: Block, best: Best, choice: Outcome) -> None:
    """Look for a lighter block of which everything passes, whatever fails in other blocks."""
    now = trials.of(best.changes) or choice
    elsewhere = {name for name in now.failing if stage_of(name) in trials.design.stages} - {
        name for name in now.failing if stage_of(name) in block.stages
    }

    def accepts(outcome: Outcome) -> bool:
        return outcome.failing.keys() <= elsewhere

    best.mass = now.mass if accepts(now) else math.inf
    improve(trials, block, best, accepts)
    if best.mass == math.inf:
        best.mass = now.mass
