"""Sized stages: gears, meshes and bores, and checks of strength, tooth geometry and machine limits.

Where they stand is for `arrangement`.
"""

from __future__ import annotations

import math
from collections.abc import Collection, Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace
from functools import cached_property

from gearwright.base import (
    ROUNDING,
    Check,
    DesignError,
    Kind,
    PartId,
    Problem,
    Role,
    accepted,
    gear_part,
    not_assessed,
    refuse,
    smallest,
    text,
)
from gearwright.parts.bevel_geometry import WIDEST, WIDEST_MODULES, least_cutter_radius
from gearwright.parts.gears import (
    ISO53_A,
    CylindricalGear,
    GearPair,
    assembly_room,
    disc_inertia,
    disc_mass,
    involute_room,
    least_teeth,
    ring_inertia,
    ring_mass,
    tip_room,
    tip_thickness,
)
from gearwright.parts.planetary import tip_gap
from gearwright.sizing.gear_geometry import (
    backlash_of,
    bore_problem,
    cylindrical_gear,
    plane_counts,
    planet_positions,
    rolling_of,
)
from gearwright.sizing.rating import (
    Context,
    Demand,
    Known,
    Rating,
    Unloaded,
    bevel_pair,
    bevel_push,
    bore_of,
    cone_ratio,
    context_of,
    demands_of,
    fewest_virtual_teeth,
    load_sharing,
    made_share,
    method_for,
    rate_row,
    shared,
)
from gearwright.sizing.result import GearSizing, MeshSizing
from gearwright.sizing.stage_sizes import (
    ROUNDS,
    STILL,
    StageSize,
    all_sizes,
    combinations,
    larger_modules,
    other_faces,
    sharing_of_sizes,
)
from gearwright.sizing.teeth import Chosen, refuse_contradictions
from gearwright.spec import Design, Epicyclic, case_named, edited
from gearwright.spec.checks import relief_problem, table_of
from gearwright.spec.design import NOTHING_GIVEN, ForbiddenBand, Given, allowed_in_case, cases_forbidding
from gearwright.train import INTERNAL, Gear, Mesh, PowerFlow, Train, Turning, build_train, passes, power_flows

# ----------------------------------------------------------------------------------------------------------------------
# Gears and meshes of a train whose stages are sized: diameters, forces, stresses, margins, masses.
# ----------------------------------------------------------------------------------------------------------------------


def size_gears(context: Context, sizes: Mapping[str, StageSize]) -> tuple[GearSizing, ...]:
    """Return every kind of gear body.

    Args:
        context: What gear sizing reads.
        sizes: Stage, or group of gears of a compound set -> its module and face width.
    """
    lengths = {name: plane_counts(epicyclic) for name, epicyclic in context.design.epicyclics.items()}
    planes = {gear.name: lengths.get(gear.stage, {}).get(gear.own, 1) for gear in context.train.gears}
    return tuple(
        _gear(context, gear, sizes[gear.sized].planes(planes[gear.name])) for gear in context.train.gears
    )  # fmt: skip


def _gear(context: Context, gear: Gear, size: StageSize) -> GearSizing:
    rating, teeth, given = context.ratings[gear.stage], context.teeth[gear.name], context.given
    module, width = size.module, size.face_width
    diameter = module * teeth / math.cos(rating.helix_angle)
    density = rating.material.density
    ring = gear.name in context.train.internal
    wall = rating.rules.rim_thickness_ratio * module if ring else 0.0
    shift = rating.shift_of(gear)
    # Profile shift moves teeth and roots as they are; what is cut off thin tips is left out.
    thicker = shift.profile_shift * module if rating.kind == "cylindrical" else 0.0
    if ring:
        mean, depth = diameter - 2.0 * thicker, wall
        mass = ring_mass(mean, depth, width, density=density)
    else:
        mean, depth = diameter + 2.0 * thicker, 0.0
        mass = disc_mass(mean, width, density) * (rating.rules.web_ratio if gear.role is Role.WHEEL else 1.0)
    mass = given.get(f"{gear.name}.mass", mass)
    inertia = ring_inertia(mass, mean, depth) if ring else disc_inertia(mass, mean)
    return GearSizing(
        stage=gear.stage,
        role=gear.role,
        shafts=gear.nodes,
        bodies=gear.bodies,
        teeth=teeth,
        module=module,
        helix_angle=rating.helix_angle,
        face_width=width,
        pitch_diameter=diameter,
        rim=wall - thicker if ring else 0.0,  # the root circle moves with the teeth, and the wall behind it
        mass=mass,
        inertia=given.get(f"{gear.name}.inertia", inertia),
        profile_shift=shift.profile_shift,
        tip_alteration=shift.tip_alteration,
        own=gear.own,
    )


def size_meshes(
    context: Context, gears: tuple[GearSizing, ...], demands: Mapping[str, Demand]
) -> tuple[MeshSizing, ...]:
    """Return every mesh row at its worst case.

    Args:
        context: What gear sizing reads.
        gears: From `size_gears`.
        demands: Mesh row -> what it asks for.
    """
    by_name = {gear.name: gear for gear in gears}
    return tuple(
        _mesh(context, mesh, (by_name[mesh.gears[0]], by_name[mesh.gears[1]]), demands[mesh.name])
        for mesh in context.train.meshes
    )


def _mesh(context: Context, mesh: Mesh, pair: tuple[GearSizing, GearSizing], demand: Demand) -> MeshSizing:
    rating, (first, _) = context.rating(mesh), pair
    case, per_tooth, module_bending, module_contact = demand
    width = min(gear.face_width for gear in pair)
    rolls = rolling_of(rating, pair, mesh)
    force = per_tooth * first.teeth / rolls.radii[0]
    flow = context.flows[case]
    rolling = abs(flow.speeds[mesh.nodes[0]] - flow.speeds[mesh.nodes[2]])
    if rating.kind == "bevel":
        axial, radial = (float(push) for push in bevel_push(rating, force, first.teeth / pair[1].teeth))
    else:
        axial = rolls.axial(force)
        radial = rolls.radial(force)
    return MeshSizing(
        stage=mesh.stage,
        row=mesh.row,
        gears=mesh.gears,
        count=mesh.count,
        case=case,
        load_factor=rating.load_factor,
        tangential_force=force,
        radial_force=radial,
        axial_force=axial,
        pitch_line_velocity=rolling * rolls.radii[0],
        centre_distance=rolls.centre_distance,
        working_pressure_angle=rolls.pressure_angle,
        working_diameter=2.0 * rolls.radii[0],
        rating=rate_row(context, mesh, first.module, width, asked=(module_bending, module_contact)),
        branch=mesh.branch,
        own=mesh.own,
    )


# ----------------------------------------------------------------------------------------------------------------------
# Bores that a design gives to gears and to shafts through them, against the roots of the teeth around them.
# ----------------------------------------------------------------------------------------------------------------------


ROOTED = (Role.PINION, Role.WHEEL, Role.SUN)
"""Gears that a shaft goes through."""


def bores_beyond_roots(context: Context, gears: Sequence[GearSizing]) -> Iterator[Problem]:
    """Yield bores of gears, and of shafts through them, that leave no rim under the teeth.

    Args:
        context: What gear sizing reads.
        gears: As sized.
    """
    for gear in gears:
        for path, bore in () if gear.name in context.train.internal else _bores(context, gear):
            if (problem := bore_problem(context, gear, path, bore)) is not None:
                yield problem


def _bores(context: Context, gear: GearSizing) -> Iterator[tuple[str, float]]:
    """Yield key and diameter [m] of the bore that a design gives to a gear, and of those of shafts through it."""
    design = context.design
    if (own := bore_of(design, context.train.gear(gear.name))) is not None:
        compound = isinstance(design.stages[gear.stage], Epicyclic)
        key = f"{gear.role.value}s.{gear.own}.bore_mm" if compound else f"{gear.role.value}_bore_mm"
        yield f"{design.table(gear.stage)}.{key}", own
    for shaft in gear.shafts if gear.role in ROOTED else ():
        if (bore := design.layout.get(shaft, NOTHING_GIVEN).bore) is not None:
            yield f"layout.{shaft}.bore_mm", bore


# ----------------------------------------------------------------------------------------------------------------------
# Whether teeth can be cut, run and be put together: undercut, tips, contact, interference in rings, planets.
# ----------------------------------------------------------------------------------------------------------------------


LEAST_CONTACT_RATIO = 1.0
"""Least transverse contact ratio ε_α with which motion is passed on without a gap [-]."""
THINNEST_TIP = 0.2
"""Least tooth thickness at the tip over the module [-]; DIN 3960:1987, 0.4 where the tip is hardened through."""


def tooth_checks(
    context: Context, stage: str, gears: Mapping[str, GearSizing], meshes: list[MeshSizing]
) -> Iterator[Check]:
    """Yield what the teeth of a stage of cylindrical gears are held against.

    Args:
        context: What sizing reads.
        stage: A pair or planetary set.
        gears: By name.
        meshes: Its rows.
    """
    rows = {mesh.name: mesh for mesh in context.train.meshes}
    own = {name: gears[name] for mesh in meshes for name in mesh.gears}
    shapes = {name: cylindrical_gear(context.design, gear) for name, gear in own.items()}
    pairs = [_tooth_pair(context, rows[mesh.name], shapes, mesh.centre_distance) for mesh in meshes]
    yield _undercut(context, list(own.values()))
    part = PartId(Kind.STAGE, stage)
    ratio = min(pair.transverse_contact_ratio for pair in pairs)
    yield Check(part, "contact ratio", "ISO 21771", ratio, LEAST_CONTACT_RATIO, exponent=None, symbol="ε_α")
    for gear in own.values():
        if gear.name not in context.train.internal and (gear.profile_shift or gear.tip_alteration):
            tip = tip_thickness(shapes[gear.name]) * math.cos(gear.helix_angle) / gear.module
            yield Check(gear.part, "tip thickness", "DIN 3960", tip, THINNEST_TIP, exponent=None, symbol="s_an/m_n")
    for mesh, pair in zip(meshes, pairs, strict=True):
        yield from _play(context, mesh, gears)
        if pair.side < 0:
            yield from _inside(mesh.part, pair)
    yield from _neighbours(context, stage, gears, shapes)


def _tooth_pair(context: Context, mesh: Mesh, shapes: Mapping[str, CylindricalGear], centre: float) -> GearPair:
    """Return one mesh of a row of cylindrical gears on its working centre distance [m]."""
    first, second = (shapes[name] for name in mesh.gears)
    if mesh.sign == INTERNAL:
        second = replace(second, teeth=-second.teeth)
    return GearPair(first, second, centre if context.rating(mesh).shifts.centre is not None else None)


def _undercut(context: Context, gears: list[GearSizing]) -> Check:
    """Return the check of the gear that is nearest to undercut, or furthest beyond it."""
    external = [gear for gear in gears if gear.name not in context.train.internal]
    gear = min(external, key=lambda candidate: candidate.teeth - fewest_uncut(context, candidate))
    limit = math.ceil(fewest_uncut(context, gear) - 1e-9)
    return Check(gear.part, "undercut", "ISO 21771, z_min", gear.teeth, limit, "number", exponent=None, symbol="z")


def fewest_uncut(context: Context, gear: GearSizing) -> float:
    """Return the teeth of a gear of its angles and shift that are just not undercut [-].

    Args:
        context: What sizing reads.
        gear: External.
    """
    rating, height = context.ratings[gear.stage], ISO53_A.straight_dedendum - gear.profile_shift
    return least_teeth(height, pressure_angle=rating.rules.pressure_angle, helix_angle=rating.helix_angle)


def _play(context: Context, mesh: MeshSizing, gears: Mapping[str, GearSizing]) -> Iterator[Check]:
    """Yield whether the thickest teeth leave a gap where the axes stand as badly as they may."""
    if (play := backlash_of(context.design, gears, mesh)) is not None:
        clause = "DIN 3967, DIN 3964"
        yield Check(mesh.part, "backlash", clause, play.opened, play.closed, "length", exponent=None, symbol="j_bn")


def _inside(part: PartId, pair: GearPair) -> Iterator[Check]:
    """Yield the three interferences of a gear inside a ring: of involutes, of tips, on the way in."""
    kinds = {
        "involute interference": (involute_room(pair), "Niemann & Winter II", "length", "r_a2"),
        "tip interference": (tip_room(pair), "Colbourne 1987", "angle", "θ"),
        "radial assembly": (assembly_room(pair), "Colbourne 1987, trimming", "length", "s"),
    }
    for mode, (room, clause, dimension, symbol) in kinds.items():
        if room is not None:
            yield Check(part, mode, clause, room.there, room.needed, dimension, exponent=None, symbol=symbol)


def _neighbours(
    context: Context, stage: str, gears: Mapping[str, GearSizing], shapes: Mapping[str, CylindricalGear]
) -> Iterator[Check]:
    """Yield the gap between the tips of neighbouring planets."""
    if stage not in context.design.planetaries:
        return
    planet, sun = (gears[str(gear_part(stage, role))] for role in (Role.PLANET, Role.SUN))
    positions = planet_positions(context.design, stage, context.teeth)
    centre = context.ratings[stage].shifts.centre
    arm = (sun.pitch_diameter + planet.pitch_diameter) / 2.0 if centre is None else centre * sun.module
    if len(positions) > 1:
        tips = 2.0 * shapes[planet.name].tip_radius
        apart = tip_gap(arm, 0.0, positions)
        yield Check(PartId(Kind.STAGE, stage), "planets apart", "tip circles", apart, tips, "length", exponent=None)


# ----------------------------------------------------------------------------------------------------------------------
# Every check of the gears of a design: strength; of those that a standard rates scuffing, and what can be cut.
# ----------------------------------------------------------------------------------------------------------------------


SAME_AXES = 1e-5
"""By how much centre distances of pairs on the same axes may differ [m]: within js6, ±14.5 µm at 180 to 250 mm."""


def gear_checks(
    context: Context, gears: tuple[GearSizing, ...], meshes: tuple[MeshSizing, ...], sizes: Mapping[str, StageSize]
) -> Iterator[Check]:
    """Yield every check of the gears.

    Args:
        context: What sizing reads.
        gears: From `size_gears`.
        meshes: From `size_meshes`.
        sizes: From `all_sizes`.
    """
    by_name = {gear.name: gear for gear in gears}
    for mesh in meshes:
        parts = (by_name[mesh.gears[0]].part, by_name[mesh.gears[1]].part)
        yield from _strength(context.ratings[mesh.stage], mesh, parts)
    for sized, size in sizes.items():
        own = {mesh.name for mesh in context.train.meshes if mesh.sized == sized}
        rows = [mesh for mesh in meshes if mesh.name in own]
        rating, pair = context.ratings[rows[0].stage], (by_name[rows[0].gears[0]], by_name[rows[0].gears[1]])
        if rating.proportions is not None:
            yield from (_cone if rating.kind == "bevel" else _cylinder)(rating, pair, size)
        if rating.kind == "cylindrical":
            yield from tooth_checks(context, rows[0].stage, by_name, rows)
    yield from _axes(context, {mesh.stage: mesh.centre_distance for mesh in meshes})


def _axes(context: Context, distances: Mapping[str, float]) -> Iterator[Check]:
    """Yield the pairs on common axes whose centre distances differ, by how much."""
    for name, pair in context.design.pairs.items():
        other = pair.coaxial_with
        if other is not None and abs(distances[name] - distances[other]) > SAME_AXES:
            why = f"centre distances of {1e3 * distances[name]:.6g} and {1e3 * distances[other]:.6g} mm on common axes"
            yield Check(
                PartId(Kind.STAGE, name), f"axes of {other}", "geometry", abs(distances[name] - distances[other]),
                SAME_AXES, "length", at_most=True, exponent=None, why=why,
            )  # fmt: skip


def _strength(rating: Rating, mesh: MeshSizing, gears: tuple[PartId, PartId]) -> Iterator[Check]:
    """Yield what the method of a stage says of a mesh."""
    method = method_for(rating)
    if isinstance(mesh.rating, Unloaded):
        yield not_assessed(mesh.part, "strength", method.edition, "no load case sends power through it")
    else:
        yield from method.checks(mesh.rating, mesh.part, gears)


def _cylinder(rating: Rating, pair: tuple[GearSizing, GearSizing], size: StageSize) -> Iterator[Check]:
    first, widest, width = pair[0], rating.proportions, size.face_width
    assert widest is not None
    limits = {
        f"b ≤ {widest.widest_modules:g} m_n, usual": widest.widest_modules * size.module,
        f"b ≤ {widest.widest_diameters:g} d_1, usual": widest.widest_diameters * first.pitch_diameter,
    }
    for clause, largest in limits.items():
        yield Check(first.part, "face width", clause, width, largest, "length", at_most=True, exponent=None)


def _cone(rating: Rating, pair: tuple[GearSizing, GearSizing], size: StageSize) -> Iterator[Check]:
    first, second = pair
    cone = float(cone_ratio(first.teeth, second.teeth))
    outer = size.module / math.cos(rating.helix_angle) + size.face_width / (2.0 * cone)
    limit = min(WIDEST * cone, WIDEST_MODULES) * outer
    clause = "ISO 23509, annex B: R_e/3 and 10 m_et"
    part, asked, fewest = first.part, size.asked_width, fewest_virtual_teeth(rating)
    yield Check(part, "face width", clause, asked, limit, "length", at_most=True, exponent=None)
    virtual = first.teeth * math.hypot(first.teeth, second.teeth) / second.teeth
    if (cutter := rating.rules.cutter_radius) is not None and rating.helix_angle:
        least = least_cutter_radius(bevel_pair((first.teeth, second.teeth), size.module, size.face_width, rating))
        yield Check(part, "cutter", "ISO 23509, annex C.5", cutter, least, "length", exponent=None, symbol="r_c0")
    clause = "ISO 23509, z_1/cos δ_1"
    yield Check(part, "undercut", clause, virtual, fewest, "number", exponent=None, symbol="z_v")


# ----------------------------------------------------------------------------------------------------------------------
# Whether teeth and planets stay out of the bands of frequencies that the design forbids, in every case of each.
# ----------------------------------------------------------------------------------------------------------------------


CLAUSE = "design, [teeth.forbidden]"
_PASS = {"mesh": "mesh frequency", "planet-pass": "planet pass"}


def pass_checks(context: Context) -> Iterator[Check]:
    """Yield of every forbidden band and every row that passes at all how far the nearest frequency of a case is off.

    Args:
        context: What sizing reads.
    """
    for name, band in context.design.teeth.forbidden.items():
        rows: dict[str, list[Check]] = {}
        for case in cases_forbidding(context.design, band):
            for mesh, frequency in passes(context.design, context.train, context.teeth, context.flows[case], band.of):
                part = _part(context, mesh)
                for harmonic in range(1, band.harmonics + 1):
                    check = _held(part, name, band, harmonic * frequency, case=case)
                    where = "" if harmonic == 1 else f"{harmonic} times"
                    rows.setdefault(mesh.name, []).append(replace(check, place=where))
        yield from (smallest(checks, lambda check: check.ratio or 0.0) for checks in rows.values())


def _part(context: Context, mesh: Mesh) -> PartId:
    """Return the stage of a row, where no other row of it is alike, or else the row."""
    alike = [row for row in context.train.meshes if (row.stage, row.row) == (mesh.stage, mesh.row)]
    return PartId(Kind.STAGE, mesh.stage) if len(alike) == 1 else mesh.part


def _held(part: PartId, name: str, band: ForbiddenBand, frequency: float, *, case: str) -> Check:
    """Return one frequency against the nearer end of a band; inside it, against the one that is sooner reached."""
    below = bool(band.lowest / frequency >= frequency / band.highest)
    return Check(
        part, f"{_PASS[band.of]} in {name}", CLAUSE, frequency, band.lowest if below else band.highest, "frequency",
        at_most=below, exponent=None, symbol="f", case=case, why=band.reason,
    )  # fmt: skip


# ----------------------------------------------------------------------------------------------------------------------
# Machines that a load case asks for more than they may do while it lasts.
# ----------------------------------------------------------------------------------------------------------------------


_ROUNDING = 1e-6
"""Part by which a limit may be passed [-]."""
_LIMITS = "give it a limit beyond its rating for the time that the case lasts"


def refuse_beyond(design: Design, flows: Mapping[str, PowerFlow]) -> None:
    """Raise where a case asks a machine for more power, torque or speed than it may give or take so long.

    Static cases are limit loads, which no rating covers.

    Args:
        design: With its machines and cases.
        flows: Every load case.

    Raises:
        DesignError: With every such machine, its value and its limit.
    """
    lasting = [flow for case, flow in flows.items() if not case_named(design, case).static]
    refuse(problem for flow in lasting for problem in _beyond(design, flow))


def _beyond(design: Design, flow: PowerFlow) -> Iterator[Problem]:
    case = case_named(design, flow.case)
    for name, machine in design.machines.items():
        allowed, table = allowed_in_case(machine, case), table_of(name, design)
        stated = f"cases.{flow.case}.{name}" if name in case.machines else f"{table}.{name}"
        found = {
            "power": (abs(flow.machine_powers[name]), allowed.power, f"ask for less, raise its power, or {_LIMITS}"),
            "torque": (abs(flow.machine_torques[name]), allowed.torque, f"ask for less, or {_LIMITS}"),
            "speed": (abs(flow.speeds[machine.shaft]), allowed.speed, "let it turn slower, by other teeth or speeds"),
        }
        for key, (value, most, fix) in found.items():
            if most is not None and value > most * (1.0 + _ROUNDING):
                limits = f" ([{table}.{name}.limits.NAME])" if _LIMITS in fix else ""
                message = f"{text(value, key)} in case {flow.case}, and {text(most, key)} is its limit; {fix}{limits}"
                yield Problem(f"{stated}.{key}", message)


# ----------------------------------------------------------------------------------------------------------------------
# A transmission as far as its gears decide it: teeth become modules, widths, meshes, and the checks of the gears.
#
# What carries them comes after; of several choices of teeth only the one that is taken goes on to it.
# ----------------------------------------------------------------------------------------------------------------------


@dataclass(frozen=True)
class Geared:
    """Gears of chosen teeth."""

    context: Context
    gears: tuple[GearSizing, ...]
    """External ones as solid discs."""
    meshes: tuple[MeshSizing, ...]
    checks: tuple[Check, ...]
    """Of roots, flanks, scuffing, contact ratio, undercut, tips, interference, rims and frequencies."""
    sizes: Mapping[str, StageSize]
    demands: Mapping[str, Demand]
    choice: Chosen
    ranked: Mapping[frozenset[str], float] = field(default_factory=dict)
    """Stages that are sized together on a grid -> what they weigh with what is around them, to rank them [kg]."""

    @cached_property
    def failing(self) -> Mapping[str, float]:
        """Stage whose gears fall short of what is asked -> their least value over limit, but for what is waived [-]."""
        least = dict[str, float]()
        for check in accepted(self.checks, self.context.design.waivers):
            if check.fails:
                least[check.part.name] = min(least.get(check.part.name, math.inf), check.ratio or 0.0)
        return least

    @property
    def nearness(self) -> float:
        """Least value over limit of all that is asked of them, at most 1 [-]."""
        return min(self.failing.values(), default=1.0)

    @property
    def passes(self) -> bool:
        """Whether they meet all that is asked of them."""
        return not self.failing

    @property
    def estimate(self) -> float:
        """What the gears weigh with rims, webs and bores by the estimate of the search, to rank them [kg]."""
        gridded = frozenset[str]().union(*self.ranked)
        own = sum(_mass(self.context, gear) for gear in self.gears if gear.stage not in gridded)
        return sum(self.ranked.values()) + own


def _mass(context: Context, gear: GearSizing) -> float:
    solid = gear.name in context.train.internal
    share = 1.0 if solid else made_share(gear.role, gear.teeth, context.ratings[gear.stage].rules)
    return gear.bodies * gear.mass * share


def geared(
    design: Design, train: Train, choice: Chosen, *, given: Mapping[str, Given], known: Known | None = None
) -> Geared:
    """Return the gears of chosen teeth and numbers of planets.

    Args:
        design: As read.
        train: Its graph.
        choice: Teeth, and numbers of planets that the design leaves open.
        given: Path -> value that the user gives instead of the computed one.
        known: What meshes have given with other teeth of the design, and are to give.

    Raises:
        DesignError: If torques contradict each other, machines have too little power, or teeth are not covered.
    """
    context, sharing = _with_teeth(design, train, choice, given=given, known=known), dict[str, float]()
    for _ in range(ROUNDS):
        demands = demands_of(context)
        sizes = all_sizes(context, demands)
        found = _with_sizes(context, sizes, demands, choice)
        before, sharing = sharing, dict(sharing_of_sizes(context, found.gears, found.meshes))
        if all(abs(factor - before.get(stage, 0.0)) < STILL for stage, factor in sharing.items()):
            break
        context = shared(context, sharing)
    return _held_against(found)


def gearings(
    design: Design, train: Train, choice: Chosen, *, given: Mapping[str, Given], known: Known | None = None,
    areas: Mapping[str, float] | None = None, narrow: Collection[tuple[str, StageSize]] = (),
) -> Iterator[Geared]:  # fmt: skip
    """Yield the gears of chosen teeth in sizes that pass, those first that weigh least by an estimate.

    Where loads are shared by the sizes of gears, the lightest alone.

    Args:
        design: As read.
        train: Its graph.
        choice: Teeth, and numbers of planets that the design leaves open.
        given: Path -> value that the user gives instead of the computed one.
        known: What meshes of the design have given with other teeth, and are to give.
        areas: Set -> least face times diameter of all its planets [m²].
        narrow: Sizes of stages that are passed over; those that are added on the way are, too.

    Raises:
        DesignError: As `geared`.
    """
    if any(load_sharing(design, name).by_size for name in design.stages):
        yield geared(design, train, choice, given=given, known=known)
        return
    context = _with_teeth(design, train, choice, given=given, known=known)
    if areas:
        wider = {stage: replace(context.ratings[stage], least_area=area) for stage, area in areas.items()}
        context = replace(context, ratings={**context.ratings, **wider})
    demands = demands_of(context)
    refused, came_out = list[DesignError](), False
    for sizes, masses in combinations(context, demands):
        if came_out and not sizes.items().isdisjoint(narrow):
            continue
        try:
            found = _held_against(_with_sizes(context, sizes, demands, choice))
        except DesignError as error:  # bores and reliefs for which these sizes have no room
            refused.append(error)
            continue
        came_out = True
        yield replace(found, ranked=masses)
    if not came_out:
        raise refused[0]


def with_face(
    found: Geared, stage: str, least: float, most: float = math.inf, *, module: float | None = None
) -> Geared | None:
    """Return gears with the narrowest other face of a planetary set within limits that passes; None: no such.

    Args:
        found: Gears that pass.
        stage: The set.
        least: From which it is looked for; where that is wider than it may be, its widest beyond its own [m].
        most: Up to which it is looked for [m].
        module: Another module that it has then [m].
    """
    context, size = found.context, found.sizes[stage]
    faces = other_faces(context, stage, size, module)
    if module is None and least > size.face_width:
        faces = [face for face in faces if face.width > size.face_width]
    low = min(least, faces[-1].width) if faces else least
    for width, heavier, passes_ in faces:
        if not passes_ or not low * (1.0 - ROUNDING) <= width <= most * (1.0 + ROUNDING):
            continue
        own = StageSize(size.module if module is None else module, width, width)
        try:
            sizes = {**found.sizes, stage: own}
            other = _held_against(_with_sizes(context, sizes, found.demands, found.choice))
        except DesignError:
            continue
        if other.passes:
            together = next(stages for stages in found.ranked if stage in stages)
            return replace(other, ranked={**found.ranked, together: found.ranked[together] + heavier})
    return None


def with_module(found: Geared, stage: str, face: float) -> Geared | None:
    """Return gears with the least larger module of a set whose planets may bear as much as with a wider face.

    What planets turn on bears about as much as face times diameter.

    Args:
        found: Gears that pass.
        stage: The set.
        face: With which they would with the module that they have, wider than that may be [m].
    """
    size = found.sizes[stage]
    for module in larger_modules(found.context, stage, size.module):
        asked = face * size.module / module
        faces = other_faces(found.context, stage, size, module)
        able = any(face.passes and face.width >= asked for face in faces)
        if able and (larger := with_face(found, stage, asked, module=module)) is not None:
            return larger
    return None


def _with_teeth(
    design: Design, train: Train, choice: Chosen, *, given: Mapping[str, Given], known: Known | None
) -> Context:
    """Return what gear sizing reads with chosen teeth."""
    teeth = choice.teeth
    if choice.planets:
        design = edited(design, {f"planetaries.{stage}.planets": count for stage, count in choice.planets.items()})
        train = build_train(design)
    flows = power_flows(design, Turning(design, train, teeth), efficiency=design.efficiencies)
    refuse_contradictions(design, flows)
    refuse_beyond(design, flows)
    return context_of(design, train, teeth, flows, given, known=known)


def _with_sizes(
    context: Context, sizes: Mapping[str, StageSize], demands: Mapping[str, Demand], choice: Chosen
) -> Geared:
    """Return gears and meshes of sizes."""
    gears = size_gears(context, sizes)
    return Geared(context, gears, size_meshes(context, gears, demands), (), sizes, demands, choice)


def _held_against(found: Geared) -> Geared:
    """Return gears with their checks."""
    context, gears, meshes = found.context, found.gears, found.meshes
    refuse((*bores_beyond_roots(context, gears), *_reliefs(context, gears, meshes)))
    return replace(found, checks=(*gear_checks(context, gears, meshes, found.sizes), *pass_checks(context)))


def _reliefs(context: Context, gears: Sequence[GearSizing], meshes: Sequence[MeshSizing]) -> Iterator[Problem]:
    """Yield stated tip reliefs that are too large for the modules that stages have come to.

    By the gears in mesh, since a pair between gears of two other stages has none of its own.
    """
    modules = {gear.name: gear.module for gear in gears}
    for stage in context.design.stages:
        module = min(modules[gear] for mesh in meshes if mesh.stage == stage for gear in mesh.gears)
        if (problem := relief_problem(context.design, stage, module)) is not None:
            yield problem
