"""Geometry of sized gears: working pitch circles, root circles, backlash, planet positions and blanks."""

from __future__ import annotations

import cmath
import math
from collections.abc import Callable, Mapping
from dataclasses import dataclass, replace
from typing import Annotated, NamedTuple, Protocol, TypeVar

from gearwright.base import INCH, DesignError, Length, Origin, Problem, Quantity, Role, gear_part, text
from gearwright.catalogue import centre_allowance, thickness_allowances
from gearwright.parts.gears import (
    ISO53_A,
    BasicRack,
    Blank,
    CylindricalGear,
    TransverseTooth,
    base_helix_angle,
    blank_volume,
    centre_play,
    circumferential_play,
    outline_area,
    span_allowance,
    transverse_pressure_angle,
    widest_rounding,
)
from gearwright.parts.planetary import even_positions, nearest_positions, pin_angles, pin_radii, planes
from gearwright.sizing.rating import (
    BACKUP,
    RIMMED,
    THINNEST_RIM,
    TOOTH_HEIGHT,
    Context,
    Rating,
    push_angle,
    working_radii,
)
from gearwright.sizing.result import GearSizing, MeshSizing, Sizing
from gearwright.spec import Design, Epicyclic, GearRules, Pair, Planetary
from gearwright.train import INTERNAL, Mesh

# ----------------------------------------------------------------------------------------------------------------------
# Where the pins of compound sets stand, and in which planes their gears lie, with the modules that were found.
# ----------------------------------------------------------------------------------------------------------------------


class Sized(Protocol):
    """A gear that has its module."""

    @property
    def stage(self) -> str:
        """Stage that owns it."""

    @property
    def own(self) -> str:
        """What the design calls it."""

    @property
    def module(self) -> float:
        """m_n [m]."""


def pins_of(
    epicyclic: Epicyclic, gears: Mapping[str, Sized], centres: Mapping[str, float]
) -> dict[str, complex]:  # fmt: skip
    """Return planet body -> place of its pin in the first set, from the axis, y + i z [m].

    Args:
        epicyclic: As in the design.
        gears: Its gears by the design's names.
        centres: Mesh by the design's names, such as ``sun-planet`` -> working centre distance [m].
    """
    modules = {epicyclic.group(name): gear.module for name, gear in gears.items()}
    distances = {pair: centres["-".join(pair)] / gears[pair[0]].module for pair in epicyclic.mesh_pairs}
    compound = replace(epicyclic.compound, centres=distances)
    angles = pin_angles(compound, modules)
    return {body: cmath.rect(radius, angles[body]) for body, radius in pin_radii(compound, modules).items()}


def towards(epicyclic: Epicyclic, pins: Mapping[str, complex], gear: str, mate: str) -> complex:
    """Return the direction from a gear's axis to the point at which it meshes with a mate in the first set [-].

    Args:
        epicyclic: As in the design.
        pins: Planet body -> place of its pin [m].
        gear: In the design's words.
        mate: In the design's words.
    """
    here, there = (pins[epicyclic.body(name)] if name in epicyclic.planets else 0j for name in (gear, mate))
    between = here + there if {gear, mate} & epicyclic.rings.keys() else there - here  # a ring meshes beyond the pin
    return between / abs(between)


def plane_counts(epicyclic: Epicyclic) -> dict[str, int]:
    """Return gear -> how many face widths long it is: a long planet lies in several planes [-].

    Args:
        epicyclic: As in the design.
    """
    return {gear: len(keys) for gear, keys in planes(epicyclic.compound).items()}


# ----------------------------------------------------------------------------------------------------------------------
# Where two gears roll on each other, and what their teeth push with: the working pitch circles of a sized mesh.
# ----------------------------------------------------------------------------------------------------------------------


class Rolling(NamedTuple):
    """Working pitch circles of a mesh; of bevel and face gears their pitch circles."""

    radii: tuple[float, float]
    """r_w of both gears [m]."""
    centre_distance: float
    """a_w [m]."""
    pressure_angle: float
    """α_wt [rad]."""
    lean: float
    """tan β at the working pitch circle [-]."""

    def radial(self, force: float) -> float:
        """Return the force that parts the gears [N].

        Args:
            force: Tangential at the working pitch circle [N].
        """
        return force * math.tan(self.pressure_angle)

    def axial(self, force: float) -> float:
        """Return the force along the axes [N].

        Args:
            force: Tangential at the working pitch circle [N].
        """
        return force * self.lean


def rolling_of(rating: Rating, pair: tuple[GearSizing, GearSizing], mesh: Mesh) -> Rolling:
    """Return where the gears of a mesh roll on each other.

    Args:
        rating: Resolved rules of its stage.
        pair: Its gears.
        mesh: A row of the train.

    Source: ISO 21771:2007: r_w1 = a_w z_1/(z_1 + z_2), cos α_wt = a cos α_t/a_w, tan β_w = tan β r_w/r.
    """
    internal, teeth = mesh.sign == INTERNAL, (pair[0].teeth, pair[1].teeth)
    first, second = (gear.pitch_diameter / 2.0 for gear in pair)
    lean = math.tan(rating.helix_angle)
    if rating.shifts.centre is None or rating.kind != "cylindrical":
        angle = transverse_pressure_angle(rating.rules.pressure_angle, rating.helix_angle)
        return Rolling((first, second), second - first if internal else second + first, angle, lean)
    radii = working_radii(*teeth, rating, internal=internal, module=pair[0].module)
    angle = push_angle(*teeth, rating, internal=internal)
    centre = rating.shifts.centre * pair[0].module
    return Rolling(radii, centre, angle, lean * radii[0] / first)


def rollings(context: Context, gears: Mapping[str, GearSizing]) -> dict[str, Rolling]:
    """Return mesh row -> where its gears roll on each other.

    Args:
        context: What sizing reads.
        gears: By name.
    """
    return {
        mesh.name: rolling_of(context.rating(mesh), (gears[mesh.gears[0]], gears[mesh.gears[1]]), mesh)
        for mesh in context.train.meshes
    }


def set_rollings(context: Context, stage: str, gears: Mapping[str, GearSizing]) -> dict[str, Rolling]:
    """Return mesh, by the names of its gears in the design -> where they roll on each other.

    Args:
        context: What sizing reads.
        stage: Name of a compound set.
        gears: Its gears by the design's names.
    """
    names = {gear.name: gear for gear in gears.values()}
    return {
        mesh.own: rolling_of(context.rating(mesh), (names[mesh.gears[0]], names[mesh.gears[1]]), mesh)
        for mesh in context.train.meshes
        if mesh.stage == stage
    }


def set_pins(context: Context, stage: str, gears: Mapping[str, GearSizing]) -> dict[str, complex]:
    """Return planet body -> place of its pin in the first set of a compound set, y + i z [m].

    Args:
        context: What sizing reads.
        stage: Name of a compound set.
        gears: Its gears by the design's names.
    """
    centres = {mesh: rolls.centre_distance for mesh, rolls in set_rollings(context, stage, gears).items()}
    return pins_of(context.design.epicyclics[stage], gears, centres)


def pin_circle(context: Context, stage: str, gears: Mapping[str, GearSizing]) -> float:
    """Return the radius of the circle on which the pins of a planetary set stand [m].

    Args:
        context: What sizing reads.
        stage: Name of a planetary set.
        gears: By name.
    """
    sun, planet = (gears[str(gear_part(stage, role))] for role in (Role.SUN, Role.PLANET))
    centre = context.ratings[stage].shifts.centre
    return (sun.pitch_diameter + planet.pitch_diameter) / 2.0 if centre is None else centre * sun.module


def planet_push(context: Context, gears: Mapping[str, GearSizing], stage: str) -> float:
    """Return the radial force of both meshes on a planet over their tangential force, outwards [-].

    Args:
        context: What sizing reads.
        gears: By name.
        stage: Name of a planetary set.

    Source: equal normal forces of both meshes: (sin α_ws − sin α_wr)/(cos α_ws + cos α_wr); 0 without shift.
    """
    angles = {
        mesh.sign: rolling_of(context.ratings[stage], (gears[mesh.gears[0]], gears[mesh.gears[1]]), mesh).pressure_angle
        for mesh in context.train.meshes
        if mesh.stage == stage
    }
    sun, ring = (angle for sign, angle in sorted(angles.items(), key=lambda entry: entry[0] == INTERNAL))
    return math.tan(0.5 * (sun - ring))


# ----------------------------------------------------------------------------------------------------------------------
# Root circles of gears, inside which a shaft and a bore must stay.
# ----------------------------------------------------------------------------------------------------------------------


def root_diameter(context: Context, gear: GearSizing) -> float:
    """Return the diameter of a gear's root circle, of a bevel gear at its thin end [m].

    Args:
        context: What sizing reads.
        gear: An external one.

    Source: ISO 21771:2007: d_f = d − 2 m_n (1.25 − x); ISO 23509:2016 at the mean cone, less b sin δ at the thin end.
    """
    rating = context.ratings[gear.stage]
    depth = 2.0 * gear.module * (ISO53_A.dedendum - gear.profile_shift)
    if rating.kind != "bevel":
        return gear.pitch_diameter - depth
    mesh = next(mesh for mesh in context.train.meshes if mesh.stage == gear.stage and gear.name in mesh.gears)
    mate = next(name for name in mesh.gears if name != gear.name)
    cone = math.atan2(gear.teeth, context.teeth[mate])  # tan δ = z/z_mate on square axes, ISO 23509:2016
    return gear.pitch_diameter - depth * math.cos(cone) - gear.face_width * math.sin(cone)


def widest_bore(context: Context, gear: GearSizing) -> float:
    """Return the widest bore that leaves a gear a rim which can be rated [m].

    Args:
        context: What sizing reads.
        gear: An external one.

    Source: ISO 6336-3:2019, clause 9: Y_B holds above half a tooth's height below the roots; thinner rims are to be
        avoided. AGMA 2001-D04 has the same end of its rim thickness factor.
    """
    return root_diameter(context, gear) - 2.0 * THINNEST_RIM * TOOTH_HEIGHT * gear.module


def bore_problem(context: Context, gear: GearSizing, path: str, bore: float) -> Problem | None:
    """Return what is wrong with a bore that leaves a gear too thin a rim; None where it leaves enough.

    Args:
        context: What sizing reads.
        gear: An external one.
        path: Key of the bore.
        bore: Its diameter [m].
    """
    most = widest_bore(context, gear)
    if bore <= most:
        return None
    given, module, root, room = (text(x, "length") for x in (bore, gear.module, root_diameter(context, gear), most))
    message = (
        f"{given}, and {gear.name} (z {gear.teeth}, m_n {module}) has a root circle of {root}; allowed: up to {room},"
        " which leaves half a tooth's height under the teeth; give a smaller bore, or the gear more teeth or a larger"
        " module"
    )
    return Problem(path, message)


# ----------------------------------------------------------------------------------------------------------------------
# The teeth of a sized cylindrical gear, as formulas and drawings take them, and where the planets of a set stand.
# ----------------------------------------------------------------------------------------------------------------------


_LONGEST = 5
"""Digits of a pitch that somebody writes [-]."""


def cylindrical_gear(design: Design, gear: GearSizing) -> CylindricalGear:
    """Return the teeth of a cylindrical gear as an external one, with the basic rack ISO 53 A.

    Args:
        design: With the rules of its stage.
        gear: As sized; a ring's teeth count negative where they mesh, which is for the caller.
    """
    return CylindricalGear(
        gear.teeth,
        gear.module,
        gear.face_width,
        gear.helix_angle,
        profile_shift=gear.profile_shift,
        rack=BasicRack(pressure_angle=design.rules(gear.stage).pressure_angle),
        tip_alteration=gear.tip_alteration,
    )


def stated_pitch(module: float) -> float | None:
    """Return the diametral pitch π/p of a module where it is the shorter of the two numbers, as a design in inches has.

    Args:
        module: m [m].

    Returns:
        P = 1/m [1/m]; None where the module in millimetres has as few digits.

    >>> [pitch and round(0.0254 * pitch, 9) for pitch in map(stated_pitch, (3.175e-3, 2.54e-3, 2.5e-3, 1.4911e-3))]
    [8.0, 10.0, None, None]
    """
    pitch, most = 1.0 / module, _LONGEST + 1
    return pitch if _digits(INCH * pitch) < min(_digits(1e3 * module), most) else None


def _digits(number: float) -> int:
    """Return how many digits a number is written with; one more than any where it takes more."""
    lengths = range(1, _LONGEST + 1)
    return next((n for n in lengths if math.isclose(float(f"{number:.{n}g}"), number, rel_tol=1e-9)), _LONGEST + 1)


def planet_positions(design: Design, stage: str, teeth: Mapping[str, int]) -> tuple[float, ...]:
    """Return the angles of the planets of a set, the first at zero [rad].

    Args:
        design: That says whether they may stand unequally.
        stage: Name of the set.
        teeth: Gear -> tooth number [-].

    Source: `gearwright.parts.planetary.nearest_positions`.
    """
    planetary = design.planetaries[stage]
    if not planetary.unequal_places:
        return even_positions(planetary.planets)
    sun, ring = (teeth[str(gear_part(stage, role))] for role in (Role.SUN, Role.RING))
    return nearest_positions(sun, ring, planetary.planets)


# ----------------------------------------------------------------------------------------------------------------------
# Backlash of sized teeth: what their thicknesses, as the design allows them, and the place of the axes leave.
# ----------------------------------------------------------------------------------------------------------------------


_DIN = "DIN 3967:1978; DIN 3964:1980"
Both = tuple[float, float]
T = TypeVar("T")


@dataclass(frozen=True)
class Backlash:
    """Backlash of a mesh, the least and the most that its tolerances leave."""

    normal: Annotated[Both, Quantity("length"), Origin("j_bn = −Σ E_sn cos α_n ± 2 A_a sin α_wt cos β_b", _DIN)]
    """Along the normal of the flanks j_bn [m]."""
    circumferential: Annotated[Both, Quantity("length"), Origin("j_wt = j_bn/(cos α_wt cos β_b)", "ISO 21771:2007")]
    """Along the working pitch circles j_wt [m]."""
    mean: Annotated[float, Quantity("length"), Origin("(j_bn,min + j_bn,max)/(2 cos β_b)", "ISO 21771:2007")]
    """Half way between, along the transverse line of action, as dynamics takes it [m]."""
    opened: Length
    """What the thickest teeth leave along the normal where the axes stand as drawn [m]."""
    closed: Length
    """What the axes may take of it, or add [m]."""


def fit_of(design: Design, gear: GearSizing) -> str | None:
    """Return the fit of the teeth of a cylindrical gear; None where the design says nothing of it.

    Args:
        design: With the gear's stage.
        gear: As sized.
    """
    stage = design.stages[gear.stage]
    if isinstance(stage, Pair) and stage.kind != "cylindrical":
        return None
    if isinstance(stage, Pair | Planetary):
        own: str | None = getattr(stage, f"{gear.role}_allowance")
    else:
        own = stage.toothed[gear.own].allowance
    return own or design.rules(gear.stage).allowance


def thickness_of(design: Design, gear: GearSizing) -> Both | None:
    """Return lower and upper allowance of the normal tooth thickness of a gear; None where the design gives none [m].

    Args:
        design: With the gear's stage.
        gear: As sized.

    Source: DIN 3967:1978.
    """
    fit = fit_of(design, gear)
    return None if fit is None else _of_table(design, gear.stage, thickness_allowances, (gear.pitch_diameter, fit))


def _of_table(design: Design, stage: str, table: Callable[[float, str], T], asked: tuple[float, str]) -> T:
    """Return what a table has, or say of which stage it has none."""
    try:
        return table(*asked)
    except DesignError as error:
        path = design.key_of(stage, f"gears.{'centre_' if table is centre_allowance else ''}allowance")
        raise DesignError(Problem(path, f"{asked[1]!r}, but {part.message}") for part in error.problems) from None


def backlash_of(design: Design, gears: Mapping[str, GearSizing], mesh: MeshSizing) -> Backlash | None:
    """Return the backlash of a mesh; None where the design gives none of its gears an allowance.

    Args:
        design: With the mesh's stage.
        gears: By name.
        mesh: As sized.

    Source: DIN 3967:1978, DIN 3964:1980.
    """
    pair = [gears[name] for name in mesh.gears]
    allowances = [allowed for gear in pair if (allowed := thickness_of(design, gear)) is not None]
    if not allowances:
        return None
    rules = design.rules(mesh.stage)
    helix = base_helix_angle(rules.pressure_angle, pair[0].helix_angle)
    low, high = (
        -span_allowance(sum(allowed[end] for allowed in allowances), pressure_angle=rules.pressure_angle)
        for end in (1, 0)
    )
    fit = rules.centre_allowance
    missed = 0.0 if fit is None else _of_table(design, mesh.stage, centre_allowance, (mesh.centre_distance, fit))
    play = centre_play(missed, working_angle=mesh.working_pressure_angle, helix_angle=helix)
    normal = (low - play, high + play)
    around = tuple(
        circumferential_play(end, working_angle=mesh.working_pressure_angle, helix_angle=helix) for end in normal
    )
    return Backlash(normal, (around[0], around[1]), 0.5 * sum(normal) / math.cos(helix), opened=low, closed=play)


def play_in_motion(sizing: Sizing, mesh: str) -> Length:
    """Return the backlash of a mesh along its line of action: given, or the mean that its fits leave [m].

    Args:
        sizing: What was sized.
        mesh: Name of a row.
    """
    row = next(row for row in sizing.meshes if row.name == mesh)
    stage = sizing.design.stages[row.stage]
    if "backlash" in stage.model_fields_set:
        return stage.backlash
    play = backlash_of(sizing.design, {gear.name: gear for gear in sizing.gears}, row)
    return stage.backlash if play is None else play.mean


# ----------------------------------------------------------------------------------------------------------------------
# The bodies under the teeth of external gears by the rules of their stage, and planets around what they turn on.
# ----------------------------------------------------------------------------------------------------------------------


PLANET_HUB = 1.1
"""Seat of a bearing in a planet: outside over the bearing's own outside [-], an estimate."""
CORNER = 2e-3
"""Radius between web, rim and hub [m], an assumption."""
GROOVE = 2.0
"""Depth of a groove beside a web over its width between the corners, at most [-]: what is turned with usual tools, an
estimate."""
WALL = 0.6
"""Metal left under the roots where a shaft is as thick as they are, and around the roots of a ring, in modules [-]."""


def external_tooth(design: Design, gear: GearSizing) -> TransverseTooth:
    """Return what the outline of an external cylindrical gear follows from.

    Args:
        design: With the rules of its stage.
        gear: As sized.
    """
    rack = cylindrical_gear(design, gear).rack
    rack = replace(rack, fillet_radius=min(rack.fillet_radius, widest_rounding(rack)))
    return TransverseTooth(gear.teeth, gear.module, gear.helix_angle, gear.profile_shift, gear.tip_alteration, rack)


def ring_radii(design: Design, ring: GearSizing) -> tuple[float, float]:
    """Return the radius of a ring's roots and that of its outside, of which the former leaves some metal [m].

    Args:
        design: With the rules of its stage.
        ring: An internal gear, as sized.
    """
    root = external_tooth(design, ring)._replace(side=-1).root_radius
    return root, max(ring.pitch_diameter / 2.0 + ring.rim, root + WALL * ring.module)


def crown_volume(design: Design, gear: GearSizing) -> float:
    """Return what the teeth of an external cylindrical gear fill [m³].

    Args:
        design: With the rules of its stage.
        gear: As sized.
    """
    return gear.teeth * outline_area(external_tooth(design, gear)) * gear.face_width


def blank_by_rules(gear: GearSizing, rules: GearRules, root: float, *, seat: tuple[float, float]) -> Blank:
    """Return the body under the teeth of an external gear by the rules of its stage.

    Args:
        gear: As sized.
        rules: Of its stage.
        root: Radius of the root circle [m].
        seat: Diameters of bore and hub [m].
    """
    height = TOOTH_HEIGHT * gear.module
    stated = rules.rim_ratio if gear.role in RIMMED else None
    rim = root - (BACKUP if stated is None else stated) * height
    bore = min(seat[0] / 2.0, root - WALL * gear.module)
    hub = max(min(seat[1] / 2.0, root), bore)
    return Blank(root, max(rim, 0.0), hub, bore, gear.face_width, rules.web_thickness_ratio * gear.face_width)


def turned_out(blank: Blank) -> Blank:
    """Return a body whose grooves beside the web are at most as deep as a tool reaches; a narrow one is not turned.

    Args:
        blank: Its radii and widths, with the web that the rules give.
    """
    deepest = GROOVE * max(blank.rim_radius - blank.hub_radius - 2.0 * CORNER, 0.0)
    return blank._replace(web_width=max(blank.web_width, blank.width - 2.0 * deepest))


def planet_body_volume(design: Design, planet: GearSizing, outside: float) -> float:
    """Return what a planet fills under its teeth: rim, web, and a hub around what it turns on [m³].

    Args:
        design: With the rules of its stage.
        planet: As sized.
        outside: Diameter of what it turns on [m].
    """
    root = cylindrical_gear(design, planet).root_radius
    seat = (outside, PLANET_HUB * outside)
    return blank_volume(turned_out(blank_by_rules(planet, design.rules(planet.stage), root, seat=seat)))
