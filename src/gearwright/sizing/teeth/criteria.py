"""What partial choices of tooth numbers are judged by: their gear masses, and forbidden frequency bands."""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator, Mapping, Sequence, Set
from dataclasses import replace
from typing import Any, NamedTuple

import numpy as np

from gearwright.base import (
    ROUNDING,
    Bools,
    DesignError,
    Floats,
    Ints,
    Kind,
    PartId,
    Problem,
    Role,
    largest,
    text,
)
from gearwright.sizing.rating import (
    BEARING_GAP,
    LEAST_TORQUE,
    RIM,
    STANDARD_MODULES,
    Ask,
    Load,
    LoadedMesh,
    Rating,
    bevel_module,
    bevel_pair,
    bevel_width,
    least_width,
    mean_module,
    method_for,
    modules,
    next_standard,
    rating_of,
    stage_width_ratio,
    under_spectrum,
    whole,
    widest_bevel,
)
from gearwright.sizing.rough_mass import around_mass, oil_mass
from gearwright.sizing.teeth.candidates import Ban, Front, StageTask, ring_teeth
from gearwright.spec import GROUND, Design, Pair, Planetary, case_named, edited
from gearwright.spec.design import ForbiddenBand, cases_forbidding, module_owners
from gearwright.train import (
    Mesh,
    PowerFlow,
    Targets,
    Train,
    Turning,
    asked_speeds,
    build_train,
    gears_of,
    members_of,
    passes,
    power_flow,
)

# ----------------------------------------------------------------------------------------------------------------------
# Forbidden bands of frequencies in the search: which teeth of a stage pass at none, in every case that turns alike.
#
# A case turns as the search does where the same machine keeps its speed and the same clutches hold: all its speeds are
# then those of the search times one factor, whatever the teeth. What other cases do only whole trains tell.
# ----------------------------------------------------------------------------------------------------------------------


_STILL = 1e-9
"""Part of the largest speed below which a shaft stands still [-]."""
_SAME = 1e-9
"""Part by which factors of two kept machines may differ [-]."""


class Banned(NamedTuple):
    """Stages with the bands that they are held against, and what they cannot tell."""

    tasks: list[StageTask]
    whole: frozenset[str]
    """Bands that only whole trains can be held against, in some case."""


def banned(
    tasks: Sequence[StageTask], design: Design, train: Train, nominal: Targets, flows: Mapping[str, PowerFlow]
) -> Banned:
    """Return the stages with what the forbidden bands of a design ask of each.

    Args:
        tasks: Stages of the search.
        design: With the bands.
        train: Its graph.
        nominal: Asked speeds.
        flows: Every load case at the asked ratios.
    """
    bans: dict[str, list[Ban]] = {task.name: [] for task in tasks}
    whole = set[str]()
    for name, band in design.teeth.forbidden.items():
        if design.epicyclics:
            whole.add(name)  # whose own teeth are given, and whose speeds stages after them read
        for case in cases_forbidding(design, band):
            factor = _factor(design, train, nominal, flows[case])
            for task in tasks:
                if not _passes(task, band, flows[case]):
                    continue
                if factor is None or task.edge is None:
                    whole.add(name)
                else:
                    bans[task.name].append(Ban(name, band, factor))
    return Banned([replace(task, bans=_distinct(bans[task.name])) for task in tasks], frozenset(whole))


def _distinct(bans: Sequence[Ban]) -> tuple[Ban, ...]:
    """Return bans of which no two ask the same: most cases turn at the same speeds."""
    kept: list[Ban] = []
    for ban in bans:
        if not any(ban.name == other.name and bool(ban.factor == other.factor) for other in kept):
            kept.append(ban)
    return tuple(kept)


def _passes(task: StageTask, band: ForbiddenBand, flow: PowerFlow) -> bool:
    """Tell whether anything of a stage passes that a band is about; not where it stands still, or turns as one."""
    planetary = isinstance(task.stage, Planetary)
    if band.of == "planet-pass" and not planetary:
        return False
    still = _STILL * max(abs(speed) for speed in flow.speeds.values())
    if isinstance(task.stage, Planetary):
        sun, ring, carrier = (flow.speeds[member] for member in members_of(task.stage))
        return bool(abs((ring if band.of == "planet-pass" else sun) - carrier) > still)
    shafts = () if task.edge is None else task.edge.fast
    return any(bool(abs(flow.speeds[shaft]) > still) for shaft in shafts)


def _factor(design: Design, train: Train, nominal: Targets, flow: PowerFlow) -> float | None:
    """Return by what all speeds of a case are those of the search, whatever the teeth; None where nothing tells [-]."""
    still = _STILL * max(abs(speed) for speed in flow.speeds.values())
    standing = {shaft for shaft in design.shafts if bool(abs(flow.speeds[shaft]) <= still)}
    brakes = {joint.name for joint in train.joints if joint.is_brake}
    if set(flow.joints) - brakes != set(nominal.design.clutches) or not standing <= {GROUND, *_held(design, nominal)}:
        return None
    said = case_named(design, flow.case).machines
    stated = any(drive.speed is not None for drive in said.values())
    asked = asked_speeds(design, said if stated else {})
    rated = asked_speeds(nominal.design, {})
    first, second = next(iter(asked), ""), next(iter(rated), "")
    if first != second or len(_kept(asked, flow)) != 1:
        return None
    return abs(asked[first]) / nominal.speeds[design.machines[first].shaft]


def _held(design: Design, nominal: Targets) -> Iterator[str]:
    """Yield the shafts that a brake holds in the case that asks for the speeds."""
    return (shaft for shaft in design.shafts if shaft not in nominal.design.shafts)


def _kept(asked: Mapping[str, float], flow: PowerFlow) -> list[str]:
    """Return the machines whose speeds a case keeps, of those that it asks for."""
    yielded = {machine.machine for machine in flow.yielded}
    return [name for name in asked if name not in yielded]


def clear(front: Front, task: StageTask) -> Bools:
    """Tell which choices pass at no frequency that is forbidden.

    Args:
        front: Choices with the stage's teeth.
        task: The stage, with its bans; their numbers may be one of each choice.
    """
    good = np.ones(len(front), dtype=bool)
    for ban in task.bans:
        good &= ~inside(front, task, ban)
    return good


def inside(front: Front, task: StageTask, ban: Ban) -> Bools:
    """Tell which choices pass at a frequency inside a band.

    Args:
        front: Choices with the stage's teeth.
        task: The stage.
        ban: One of its own.
    """
    return taken(ban.band, ban.factor * _rate(front, task, ban.band) / (2.0 * math.pi))


def taken(band: ForbiddenBand, frequency: Floats) -> Bools:
    """Tell which frequencies a band takes, themselves or a multiple of them, shape (n,).

    Args:
        band: The band; at its ends a frequency is allowed.
        frequency: Of teeth or planets that pass, shape (n,) [Hz].
    """
    within = np.zeros(len(frequency), dtype=bool)
    for harmonic in range(1, band.harmonics + 1):
        within |= (harmonic * frequency > band.lowest) & (harmonic * frequency < band.highest)
    return within


def ends_of(band: ForbiddenBand) -> str:
    """Return the ends of a band in words.

    Args:
        band: The band.
    """
    return f"{text(band.lowest, 'frequency')} to {text(band.highest, 'frequency')}"


def _rate(front: Front, task: StageTask, band: ForbiddenBand) -> Floats:
    """Return how often teeth mesh, or planets pass, in 2π s [1/s]."""
    stage, small = task.stage, gears_of(task.name, task.stage)[0]
    zero = np.zeros(len(front))
    if isinstance(stage, Planetary):
        sun, ring, carrier = (zero if node == GROUND else front.speeds[node] for node in members_of(stage))
        if band.of == "planet-pass":
            return np.asarray(front.planets[task.name] * np.abs(carrier - ring))
        return np.asarray(front.teeth[small] * np.abs(sun - carrier))
    assert task.edge is not None
    return np.asarray(front.teeth[small] * front.speeds[task.edge.fast[0]])


def refused(task: StageTask, fronts: Sequence[Front]) -> DesignError:
    """Return the error of a stage whose teeth all pass at forbidden frequencies, with what each band takes.

    Args:
        task: The stage.
        fronts: Its choices, all of which pass at some.
    """
    front = fronts[0].joined(fronts[1:])
    teeth = len(np.unique(np.stack([front.teeth[gear] for gear in gears_of(task.name, task.stage)]), axis=1).T)
    path = f"{'pairs' if isinstance(task.stage, Pair) else 'planetaries'}.{task.name}"
    names = dict.fromkeys(ban.name for ban in task.bans)
    return DesignError(_problem(path, task, front, name, teeth) for name in names)


def _problem(path: str, task: StageTask, front: Front, name: str, teeth: int) -> Problem:
    """Return what one band takes of the teeth of a stage."""
    own = [ban for ban in task.bans if ban.name == name]
    band = own[0].band
    within = np.any([inside(front, task, ban) for ban in own], axis=0)
    rates = np.concatenate([ban.factor * _rate(front, task, band) / (2.0 * math.pi) for ban in own])
    low, high = (text(float(end), "frequency") for end in (rates.min(), rates.max()))
    others = "" if bool(within.all()) else ", other bands the rest"
    passing = "planets pass" if band.of == "planet-pass" else "teeth mesh"
    message = (
        f"{ends_of(band)} takes {within.mean():.0%} of what {path} may have{others}: in {teeth} combinations its"
        f" {passing} at {low} to {high}; narrow the band, limit its cases, or allow more in [teeth] or in the speeds"
    )
    return Problem(f"teeth.forbidden.{name}", message)


# ----------------------------------------------------------------------------------------------------------------------
# Whole trains against forbidden bands of frequencies that no stage alone can be held against.
# ----------------------------------------------------------------------------------------------------------------------


Teeth = tuple[Mapping[str, int], Mapping[str, int]]
"""Gear -> tooth number, and planetary set -> number of planets where the design leaves it open [-]."""
TRIED = 2_000
"""Trains that are held against them [-]."""


def clear_places(
    design: Design, train: Train, bands: Set[str], trains: Iterable[tuple[int, Teeth]], *, wanted: int,
) -> list[int]:  # fmt: skip
    """Return the places of the first trains that pass at no frequency of some bands, as many as are wanted.

    Args:
        design: With its cases.
        train: Its graph.
        bands: Names of bands.
        trains: Place and teeth of each, the lightest first.
        wanted: How many [-].

    Raises:
        DesignError: If none of those that are tried is clear, with the bands.
    """
    clear, tried = list[int](), 0
    for place, (teeth, planets) in trains:
        if len(clear) == wanted or tried == TRIED:
            break
        tried += 1
        if _is_clear(design, train, bands, teeth, planets):
            clear.append(place)
    if not clear:
        raise DesignError(_problems(design, bands, tried))
    return clear


def _is_clear(
    design: Design, train: Train, bands: Set[str], teeth: Mapping[str, int], planets: Mapping[str, int]
) -> bool:
    """Tell whether a train passes at no frequency of some bands in any of their cases."""
    if planets:
        design = edited(design, {f"planetaries.{stage}.planets": count for stage, count in planets.items()})
        train = build_train(design)
    turning = Turning(design, train, teeth)
    for name in bands:
        band = design.teeth.forbidden[name]
        for case in cases_forbidding(design, band):
            flow = power_flow(design, train, teeth, case, turning=turning)
            frequencies = [frequency for _, frequency in passes(design, train, teeth, flow, band.of)]
            if taken(band, np.array(frequencies)).any():
                return False
    return True


def _problems(design: Design, bands: Set[str], tried: int) -> Iterator[Problem]:
    most = "" if tried < TRIED else " lightest"
    for name in sorted(bands):
        band = design.teeth.forbidden[name]
        message = (
            f"none of the {tried}{most} trains that the rules of [teeth] allow keeps out of {ends_of(band)} in every"
            " case, with what else is forbidden; narrow the band, limit its cases, or allow more in [teeth] or in the"
            " speeds"
        )
        yield Problem(f"teeth.forbidden.{name}", message)


# ----------------------------------------------------------------------------------------------------------------------
# Module and face width of a bevel pair as sizing makes them, for the search.
#
# A narrower face of the same outer module has a larger mean module and bears about as much, so that faces become much
# narrower than the widest that are allowed: the search cannot leave that out.
# ----------------------------------------------------------------------------------------------------------------------


ENLARGED, LEAST_STEP = 6, 0.02
"""Larger modules that are tried of a bevel pair for its films, and by which part each is larger at least [-]."""


def bevel_size(
    rating: Rating, rows: Sequence[Load], teeth: tuple[int, int], ratio: float, *, films: bool = False
) -> tuple[float, float]:
    """Return mean normal module and face width of a bevel pair under the heaviest case of each row [m].

    Args:
        rating: Resolved rules.
        rows: Loads of its rows, as a task of the search has them.
        teeth: z_1, z_2 [-].
        ratio: λ = b/m_mn of the widest face [-].
        films: Whether its films count, too.
    """
    if not rows:
        return 0.0, 0.0
    loaded = [_with_teeth(load, teeth, ratio) for load in rows]
    method, rules = method_for(rating), rating.proportions

    def gap(module: float, width: float) -> float:
        meshes = (LoadedMesh(rating, module, width, load, (load,), (0.0, 0.0)) for load in loaded)
        return min(method.reserve_of(mesh) for mesh in meshes)

    needed = max(float(module) for load in loaded for module in modules(load.ask, rating))

    def outer_of(module: float) -> float:
        outer = bevel_pair(teeth, module, ratio * module, rating).outer_module
        return next_standard(outer) if rules is not None and rules.standard_modules else outer

    def with_films(module: float, width: float) -> float:
        meshes = [LoadedMesh(rating, module, width, load, (load,), (0.0, 0.0)) for load in loaded]
        strength, part = gap(module, width), PartId(Kind.STAGE, "bevel")
        if strength < 1.0:
            return strength
        checks = (check for mesh in meshes for check in method.checks(method.rate(mesh), part, (part, part)))
        return min((check.ratio for check in checks if check.ratio is not None), default=strength)

    outer = bevel_module(teeth, outer_of(under_spectrum(needed, ratio, gap, outer_of)), ratio, rating, gap)
    for _ in range(ENLARGED if films else 0):
        widest = whole(widest_bevel(teeth, outer, ratio, rating))
        near = with_films(mean_module(teeth, outer, widest, rating), widest)
        if near >= 1.0 - ROUNDING:
            break
        larger = outer / min(near, 1.0 - LEAST_STEP)
        outer = next_standard(larger) if rules is not None and rules.standard_modules else larger
    width = bevel_width(teeth, outer, ratio, rating, with_films if films else gap)
    return mean_module(teeth, outer, width, rating), width


def bevel_rows(
    design: Design, meshes: Sequence[Mesh], flows: Mapping[str, PowerFlow], rating: Rating
) -> tuple[Load, ...]:
    """Return of each loaded row of a pair the heaviest case, over the whole life.

    Args:
        design: With its cases.
        meshes: The rows.
        flows: Every load case at the asked ratios.
        rating: Resolved rules.
    """
    lasting = {case: flow for case, flow in flows.items() if not case_named(design, case).static}
    rows = (
        largest((_load(case, mesh, flow, rating) for case, flow in lasting.items()), lambda load: load.torque)
        for mesh in meshes
    )
    return tuple(load for load in rows if load.torque > LEAST_TORQUE)


def _load(case: str, mesh: Mesh, flow: PowerFlow, rating: Rating) -> Load:
    """Return a case as one mesh of a row feels it over the whole life."""
    torque = abs(flow.meshes[mesh.name].torques[0]) / mesh.count * rating.load_factor
    speed = abs(flow.speeds[mesh.nodes[0]] - flow.speeds[mesh.nodes[2]])
    return Load(case, torque, Ask(0.0, (1, 1), 1.0, speed=speed), rating.service.life)


def _with_teeth(load: Load, teeth: tuple[int, int], ratio: float) -> Load:
    return load._replace(ask=load.ask._replace(per_tooth=load.torque / teeth[0], teeth=teeth, width_ratio=ratio))


# ----------------------------------------------------------------------------------------------------------------------
# What the gears of partial choices weigh: their modules, and their bodies over the module's cube.
# ----------------------------------------------------------------------------------------------------------------------


_MM = 1e-3


def weigh(front: Front, task: StageTask, small: Ints, large: Ints, *, planets: int) -> Front:
    """Return the front with a stage's teeth, module and bodies.

    Args:
        front: Choices of the stages before.
        task: The stage.
        small: Teeth of pinion or sun.
        large: Teeth of wheel or planet.
        planets: Of a planetary set; 1 of a pair [-].
    """
    stage, rating = task.stage, task.rating
    names, discs = _bodies(task, small, large, planets=planets)
    by_ring = isinstance(stage, Planetary) and task.edge is not None and task.edge.grounded is Role.SUN
    reference = ring_teeth(task, small, large) if by_ring else small
    speed = front.speeds[task.edge.fast[0]] if task.edge is not None else np.full(len(small), task.speed)
    width_ratio = stage_width_ratio(rating, small, large)
    ask = Ask(
        _torque(task, planets) * task.speed / speed / reference / planets,
        (small, large),
        width_ratio,
        internal=isinstance(stage, Pair) and stage.internal,
        idlers=(False, isinstance(stage, Planetary)),
        speed=task.rolling,
        passes=(planets, 1.0) if isinstance(stage, Planetary) else _mates(stage),
        roles=(Role.SUN, Role.PLANET) if isinstance(stage, Planetary) else (Role.PINION, Role.WHEEL),
        held=(isinstance(stage, Planetary) and stage.sun == GROUND, False),
        bores=_bores(stage),
    )
    ask = _relieved(ask, task)
    if rating.proportions is None:
        cube = _cubes(ask, task)
    else:
        cube, width_ratio, around = _known_sizes(ask, task, reference, speed, planets=planets, discs=discs)
        discs = discs + around / width_ratio
    group = task.group
    cubes = {**front.cubes, group: np.maximum(front.cubes.get(group, 0.0), cube)}
    volume = width_ratio * discs
    volumes = {**front.volumes, group: front.volumes.get(group, 0.0) + volume}
    counts = {task.name: np.full(len(small), planets)} if isinstance(stage, Planetary) else {}
    weighed = Front({**front.teeth, **names}, front.speeds, cubes, volumes, {**front.planets, **counts})
    return replace(weighed, tally=tallied(front.tally, weighed.mass - front.mass))


def tallied(tally: Mapping[str, Floats], added: Floats) -> Mapping[str, Floats]:
    """Return what choices stand for when each of them grows heavier.

    Args:
        tally: Before.
        added: By how much [kg].
    """
    return {**tally, "second": tally["second"] + added} if tally else tally


def _torque(task: StageTask, planets: int) -> float:
    """Return the largest nominal torque of a stage with so many planets, their own K_γ included [N m]."""
    return task.torque * task.factors.get(planets, task.rating.load_factor) / task.rating.load_factor


def _relieved(ask: Ask, task: StageTask) -> Ask:
    """Return what is asked with the load for which tips are relieved and the greatest speed."""
    return ask._replace(relieved=task.steady * np.asarray(ask.per_tooth), fastest=task.fastest * np.asarray(ask.speed))


def _cubes(ask: Ask, task: StageTask) -> Floats:
    """Return the cube of the module that each mesh asks for, in a set that a standard rates that with the ring too."""
    module = np.maximum(*modules(ask, task.rating))
    if isinstance(task.stage, Planetary) and task.rating.proportions is not None:
        module = np.maximum(module, np.maximum(*modules(_in_ring(ask, task), task.rating)))
    return np.asarray(module * module * module)


def _in_ring(ask: Ask, task: StageTask) -> Ask:
    """Return what is asked of the mesh of planets and ring where sun and planets are asked for."""
    assert isinstance(task.stage, Planetary)
    small, large = (np.asarray(teeth) for teeth in ask.teeth)
    turns = small / large
    return ask._replace(
        teeth=(large, ring_teeth(task, small, large)),
        internal=True,
        idlers=(True, False),
        passes=(1.0, ask.passes[0]),
        roles=(Role.PLANET, Role.RING),
        held=(False, task.stage.ring == GROUND),
        bores=(ask.bores[1], None),
        speed=np.asarray(ask.speed) * turns,
        fastest=np.asarray(ask.fastest) * turns,
    )


def _mates(stage: Pair) -> tuple[float, float]:
    """Return how many mates a tooth of pinion and wheel meets in a turn [-]."""
    return float(len(stage.named(Role.WHEEL))), float(len(stage.named(Role.PINION)))


def _bores(stage: Pair | Planetary) -> tuple[float | None, float | None]:
    if isinstance(stage, Planetary):
        return stage.sun_bore, stage.planet_bore
    return stage.pinion_bore, stage.wheel_bore


def _known_sizes(
    ask: Ask, task: StageTask, reference: Ints, speed: Floats, *, planets: int, discs: Floats
) -> tuple[Floats, Floats, Floats]:
    """Return m_n³, λ and what is around the gears over m_n³ where a standard rates them: of each pair of numbers once.

    Scaled by m³ ∝ T.
    """
    small, large = (np.asarray(teeth) for teeth in ask.teeth)
    load = task.speed / speed
    pairs = zip(small.tolist(), large.tolist(), strict=True)
    keys = [(first, second, planets, task.deviation) for first, second in pairs]
    if missing := list({key: place for place, key in enumerate(keys) if key not in task.known}.values()):
        new = ask._replace(
            per_tooth=_torque(task, planets) / reference[missing] / planets,
            teeth=(small[missing], large[missing]),
            width_ratio=np.asarray(ask.width_ratio)[missing],
        )
        sizes = _sizes(_relieved(new, task), task, np.asarray(discs)[missing], planets=planets)
        task.known.update(zip([keys[k] for k in missing], sizes, strict=True))
    cubes, widths, around = np.array([task.known[key] for key in keys]).reshape(-1, 3).T
    return cubes * load, widths, around


def _sizes(ask: Ask, task: StageTask, discs: Floats, *, planets: int) -> Iterator[tuple[float, float, float]]:
    """Yield m_n³ [m³], λ and what is around over m_n³ [kg/m³] of every choice, about as sizing makes them."""
    small, large, ratios = (np.asarray(column).tolist() for column in (*ask.teeth, ask.width_ratio))
    if task.rating.kind == "bevel":
        for teeth, ratio in zip(zip(small, large, strict=True), ratios, strict=True):
            mean, width = bevel_size(task.rating, task.rows, teeth, ratio, films=task.films)
            own = ask._replace(teeth=(np.array(teeth[:1]), np.array(teeth[1:])))
            (beside,) = _around(own, task, np.array([mean]), np.array([width]), planets=planets).tolist()
            yield mean * mean * mean, width / mean, beside / mean**3
        return
    needed = np.cbrt(_cubes(ask, task))
    found = _on_grid(ask, task, needed, discs, planets=planets) if task.rating.width_is_open else None
    if found is None:
        modules, widths = needed, np.asarray(ask.width_ratio) * needed
        around = _around(ask, task, modules, widths, planets=planets)
    else:
        modules, widths, masses = found
        around = masses - np.asarray(discs) * widths * modules**2
    yield from zip(*(column.tolist() for column in (modules**3, widths / modules, around / modules**3)), strict=True)


# ----------------------------------------------------------------------------------------------------------------------
# Standard modules and whole millimetres of width of many choices at once, by a few ratings of each module.
# ----------------------------------------------------------------------------------------------------------------------


_TRIED = 11
"""Standard modules that are tried of each choice [-]."""
_BELOW = 3
"""How many of them are smaller than what it needs at the widest face in its heaviest case [-]."""
_ROUNDS = 5
"""Ratings by which the face width of each is found [-]."""
_SLOPES = (0.5, 8.0)
"""Powers of the width with which the load may grow that a size bears [-]."""
_SHORT = 10.0
"""Factor on the mass of a size that is too weak, so that it is taken where none is strong enough [-]."""
_BESIDE = 1.5
"""Factor on the mass of a size that runs in a resonance or the like, for which a wider face may do [-]."""


def _on_grid(
    ask: Ask, task: StageTask, needed: Floats, discs: Floats, *, planets: int
) -> tuple[Floats, Floats, Floats] | None:
    """Return module and face width [m] with which a gearbox of every choice weighs least, and what it weighs [kg].

    None where its method rates no arrays.

    Args:
        ask: Of choices.
        task: The stage.
        needed: Module that each needs with its widest face [m].
        discs: What its bodies weigh over b m_n² [kg/m³].
        planets: Of a planetary set [-].
    """
    modules = _modules(task, needed)
    count, asks = modules.shape[1], (ask, _in_ring(ask, task)) if isinstance(task.stage, Planetary) else (ask,)
    each = [_repeated(own, count) for own in asks]
    wide = np.asarray(ask.width_ratio)[:, None] * modules
    asked = _narrow(task, modules, planets * np.asarray(ask.teeth[1])[:, None])
    narrow = np.minimum(asked, wide)
    widths, before, slope = np.clip(wide * (needed[:, None] / modules) ** 3, narrow, wide), None, np.ones_like(modules)
    for _ in range(_ROUNDS):
        near = [_near(task, own, modules, widths) for own in each]
        if any(one is None for one in near):
            return None
        strength, rest = (np.minimum.reduce(column).reshape(modules.shape) for column in zip(*near, strict=True))
        now = np.log(widths), np.log(np.maximum(strength, 1e-6))
        if before is not None:
            moved = np.where(now[0] == before[0], 1.0, now[0] - before[0])
            slope = np.clip(np.where(now[0] == before[0], slope, (now[1] - before[1]) / moved), *_SLOPES)
        wanted = np.ceil(widths * np.exp(-now[1] / slope) / _MM - 1e-6) * _MM
        widths, before = np.clip(wanted, narrow, wide), now
    weak = (wanted > wide * (1.0 + 1e-9)) | (asked > wide * (1.0 + 1e-9) if task.rating.least_area else False)
    short = np.where(weak, _SHORT, 1.0) * np.where(rest < 1.0, _BESIDE, 1.0)
    around = _around(each[0], task, modules.ravel(), widths.ravel(), planets=planets).reshape(modules.shape)
    masses = short * (discs[:, None] * widths * modules**2 + around)
    best = np.arange(len(modules)), np.argmin(masses, axis=1)
    return modules[best], widths[best], masses[best]


def _modules(task: StageTask, needed: Floats) -> Floats:
    """Return the modules that are tried of every choice, shape (choices, modules) [m]."""
    rules = task.rating.proportions
    assert rules is not None
    if not rules.standard_modules:
        return needed[:, None] * np.asarray(1.12 ** np.arange(-_BELOW, _TRIED - _BELOW))
    series = [_MM * module for module in STANDARD_MODULES]
    while series[-1] < needed.max(initial=0.0):
        series.append(1.1 * series[-1])
    table = np.array(series + [series[-1] * 1.1 ** (k + 1) for k in range(_TRIED)])
    first = np.maximum(np.searchsorted(table, needed * (1.0 - 1e-9)) - _BELOW, 0)
    return np.asarray(table[first[:, None] + np.arange(_TRIED)])


def _narrow(task: StageTask, modules: Floats, teeth: Floats) -> Floats:
    """Return the narrowest faces that are tried, in whole millimetres [m]; as bearings of all planets ask for them."""
    asked = task.rating.least_area * math.cos(task.rating.helix_angle) / (modules * teeth)
    least = np.maximum(modules * least_width(task.rating, 1.0), asked)
    return np.ceil(least / _MM - 1e-9) * _MM


def _repeated(ask: Ask, count: int) -> Ask:
    """Return what is asked of choices, each so many times."""

    def each(value: Any) -> Any:
        numbers = np.asarray(value)
        return np.repeat(numbers, count) if numbers.ndim else value

    return ask._replace(
        teeth=(each(ask.teeth[0]), each(ask.teeth[1])),
        per_tooth=each(ask.per_tooth),
        width_ratio=each(ask.width_ratio),
        speed=each(ask.speed),
        relieved=each(ask.relieved),
        fastest=each(ask.fastest),
    )


def _near(task: StageTask, ask: Ask, modules: Floats, widths: Floats) -> tuple[Floats, Floats] | None:
    """Return how near sizes come to what all cases ask of a mesh; None: no arrays are rated."""
    torque, speed = np.asarray(ask.per_tooth, dtype=float) * np.asarray(ask.teeth[0]), np.asarray(ask.speed)
    loads = [
        Load(part.case, part.torque * torque, ask._replace(speed=part.speed * speed), part.life, part.static)
        for part in task.parts
    ]
    alone = Load("", torque, ask, task.rating.service.life)
    lasting = tuple(load for load in loads if load.life > 0.0) or (alone,)
    others = tuple(load for load in loads if load.life <= 0.0)
    mesh = LoadedMesh(task.rating, modules.ravel(), widths.ravel(), alone, lasting, (0.0, 0.0), others)
    return method_for(task.rating).of_sizes(mesh, ())


def _around(ask: Ask, task: StageTask, modules: Floats, widths: Floats, *, planets: int) -> Floats:
    """Return about what carries, encloses and cools the gears of sizes [kg]."""
    if task.around is None:
        return np.zeros(len(modules))
    small, large = (np.asarray(teeth) for teeth in ask.teeth)
    teeth, planet = [small, large], np.zeros(1)
    if isinstance(task.stage, Planetary):
        teeth.append(ring_teeth(task, small, large))
        square = large**2 - BEARING_GAP * _inside(large) if task.made else large**2
        planet = task.rating.material.density * math.pi / 4.0 * square * widths * modules**2
    factor = task.factors.get(planets, task.rating.load_factor)
    return around_mass(
        task.around, teeth, modules, widths, planet=planet, planets=planets, factor=factor
    ) + oil_mass(task.around, teeth, modules, widths, planets=planets)  # fmt: skip


def _bodies(task: StageTask, small: Ints, large: Ints, *, planets: int) -> tuple[dict[str, Ints], Floats]:
    """Return the stage's gears and the mass of its own bodies over b m_n² [kg/m³]."""
    stage, rating = task.stage, task.rating
    cosine = math.cos(rating.helix_angle)
    disc = math.pi / 4.0 * rating.material.density / cosine**2
    wall = rating.rules.rim_thickness_ratio
    if isinstance(stage, Planetary):
        ring = ring_teeth(task, small, large)
        annulus = _annulus(ring, wall)
        teeth = dict(zip(gears_of(task.name, stage), (small, large, ring), strict=True))
        planet = large**2 - BEARING_GAP * _inside(large) if task.made else large**2
        return teeth, np.asarray(disc * (small**2 + planets * planet + annulus), dtype=np.float64)
    pinion, wheel = gears_of(task.name, stage)
    wheel_square = (
        _annulus(large, wall * cosine) if stage.internal else rating.rules.web_ratio * large.astype(float) ** 2
    )
    if task.made and not stage.internal and rating.rules.web_ratio == 1.0:
        wheel_square = large**2 - (1.0 - rating.rules.web_thickness_ratio) * _inside(large)
    squares = {Role.PINION: small.astype(float) ** 2, Role.WHEEL: wheel_square}
    factor: Floats = np.zeros(len(small))
    for side, square in squares.items():
        if stage.shared(side) is None:
            factor = np.asarray(factor + disc * (len(stage.named(side)) * stage.halves) * square, dtype=np.float64)
    return {pinion: small, wheel: large}, factor


def _inside(teeth: Ints) -> Floats:
    """Return (d_i/m)² inside the rim of a gear whose wall is as thick as teeth and their backing ask [-]."""
    return np.asarray(np.maximum(teeth - 2.0 * RIM, 0.0) ** 2, dtype=np.float64)


def _annulus(teeth: Ints, wall: float) -> Floats:
    """Return (d_o² − d²)/m_t² of a ring whose wall is so many transverse modules thick [-]."""
    return np.asarray((teeth + 2.0 * wall) ** 2 - teeth**2, dtype=np.float64)


def aligned(front: Front, design: Design) -> Front:
    """Return the front with modules at which pairs on the same axes have one centre distance, that of the larger.

    Args:
        front: Choices of all stages.
        design: With the pairs.
    """
    cubes, group = dict(front.cubes), module_owners(design)
    for name, pair in design.pairs.items():
        if pair.coaxial_with is None:
            continue
        spans = {tied: _span(front, tied, design) for tied in (name, pair.coaxial_with)}
        distance = np.max([cubes[group[tied]] * span**3 for tied, span in spans.items()], axis=0)
        cubes |= {group[tied]: distance / span**3 for tied, span in spans.items()}
    return replace(front, cubes=cubes)


def _span(front: Front, name: str, design: Design) -> Floats:
    """Return a pair's centre distance over its normal module [-]."""
    pair = design.pairs[name]
    pinion, wheel = (front.teeth[gear] for gear in gears_of(name, pair))
    helix = math.cos(rating_of(design, name).helix_angle)
    return np.asarray((wheel - pinion if pair.internal else wheel + pinion) / (2.0 * helix))
