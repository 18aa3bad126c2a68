"""Power losses of a sized gearbox by origin: meshes, bearings, windage and churning, seals.

The formulas are `parts.losses`'s; what losses do to the torques of a case is `train.load_case`'s.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from math import degrees
from types import MappingProxyType
from typing import Annotated, NamedTuple

import numpy as np

from gearwright.base import (
    CELSIUS,
    RPM,
    Floats,
    Number,
    Origin,
    Power,
    Problem,
    Quantity,
    Ratio,
    Shown,
    by_name,
    largest_first,
    near,
    refuse,
    verb,
)
from gearwright.catalogue import bearing_friction, equivalent_loads
from gearwright.elementwise import Values, functions, plain
from gearwright.parts.bearings import BearingKind, LoadFactors, run_film, taper_factors
from gearwright.parts.gears import ToothShift
from gearwright.parts.iso6336 import RZ_OVER_RA
from gearwright.parts.losses import (
    FASTEST,
    HIGHEST_FRICTION,
    LEAST_HELIX,
    LEAST_INTENSITY,
    LEAST_MODULE,
    LEAST_OIL_FACTOR,
    LEAST_PRODUCT,
    MOST_INTENSITY,
    NITRILE,
    OIL_DENSITY,
    SLOWEST,
    TURBINE_OIL,
    VITON,
    Friction,
    LossDuty,
    MeshLaw,
    OilState,
    RunningBearing,
    ToothContact,
    bearing_torque_constant,
    bearing_torque_palmgren,
    bearing_torque_skf,
    churning_power,
    load_intensity,
    mesh_friction,
    mesh_loss_part,
    oil_viscosity,
    seal_oil_factor,
    seal_power_14179_1,
    seal_power_14179_2,
    seal_power_oil,
    tooth_contact,
    windage_power,
    windage_power_dawson,
)
from gearwright.parts.micropitting import BASES
from gearwright.sizing.airscrew_loads import usual_thrust
from gearwright.sizing.arrangement import axial_forces
from gearwright.sizing.bearing_seats import Seat, bearing_seats, seat_forces
from gearwright.sizing.bearings import SeatedBearing, fitted_in
from gearwright.sizing.planets import STANDING, film_oil
from gearwright.sizing.result import GearSizing, MeshSizing, Sizing
from gearwright.sizing.shafts.ends import exits_of
from gearwright.spec import GROUND, case_named
from gearwright.spec.design import LOCATES, RATINGS, BearingSeat
from gearwright.train import PowerFlow

# ----------------------------------------------------------------------------------------------------------------------
# The oil and the formulas by which a gearbox loses power.
# ----------------------------------------------------------------------------------------------------------------------


NOTHING: Mapping[str, float] = MappingProxyType({})
"""No gear dips."""


class Flank(NamedTuple):
    """What losses need of the flanks of one stage."""

    roughness: float
    """R_a [m]."""
    lubricant_factor: float
    """X_L [-]."""


UNTOLD: Mapping[str, Flank] = MappingProxyType({})
"""No stage says anything of its flanks."""


class Oil(NamedTuple):
    """What losses need of oil, flanks and seals, and by whose formulas they are found."""

    temperature: Values
    """[K]"""
    roughness: float
    """R_a of the flanks [m]."""
    dip: Mapping[str, float] = NOTHING
    """Gear -> part of it that dips into an oil bath [-]; one left out runs dry."""
    friction: MeshLaw = MeshLaw.SCHLENK
    """Whose friction of the teeth."""
    bearings: str = "constant"
    """Whose friction of the bearings."""
    windage: str = "anderson-loewenthal"
    """Whose windage of the gears."""
    seals: str = "none"
    """Whose friction of the seals."""
    enclosure: float = 1.0
    """λ of Dawson's windage [-]."""
    lubricant_factor: float = 1.0
    """X_L [-]."""
    grade: tuple[float, float] = TURBINE_OIL
    """Kinematic viscosity at 40 °C and at 100 °C [m²/s]."""
    density: float = OIL_DENSITY
    """[kg/m³]"""
    of_stages: Mapping[str, Flank] = UNTOLD
    """Stage -> its flanks, where its rating says how rough they are or what oil they run in."""

    @property
    def viscosity(self) -> Values:
        """Kinematic, at its temperature [m²/s]."""
        return oil_viscosity(self.temperature, self.grade)

    def on_teeth(self, stage: str = "") -> OilState:
        """Return the oil between the teeth of a stage.

        Args:
            stage: Its name; one without flanks of its own has those of all.
        """
        flank = self.of_stages.get(stage, Flank(self.roughness, self.lubricant_factor))
        return OilState(self.viscosity * self.density, self.density, *flank)


def oil_of_design(sizing: Sizing) -> Oil:
    """Return the oil and the formulas that a design asks for.

    Args:
        sizing: With its design.

    Raises:
        DesignError: A gear dips that there is not.
    """
    oil, rules = sizing.design.oil, sizing.design.losses
    return Oil(
        temperature=oil.temperature + CELSIUS,
        roughness=rules.roughness,
        dip=dipping(sizing, rules.dip, "losses.dip"),
        friction=MeshLaw(rules.friction),
        bearings=rules.bearings,
        windage=rules.windage,
        seals=rules.seals,
        enclosure=rules.enclosure,
        lubricant_factor=rules.lubricant_factor,
        grade=(oil.viscosity_40 * 1e-6, oil.viscosity_100 * 1e-6),
        density=oil.density,
        of_stages={name: _flank(sizing, name) for name in sizing.design.stages},
    )


def _flank(sizing: Sizing, stage: str) -> Flank:
    """Return roughness and X_L of a stage: of [losses], and where that leaves them out as its rating has them."""
    losses, rules = sizing.design.losses, sizing.design.rules(stage)
    roughness, factor = losses.roughness, losses.lubricant_factor
    table = RATINGS[sizing.design.rating(stage)].table
    if "roughness" not in losses.model_fields_set:
        if table == "iso6336" and "flank_roughness" in rules.iso6336.model_fields_set:
            roughness = rules.iso6336.flank_roughness / RZ_OVER_RA
        elif table == "agma2001" and "flank_roughness" in rules.agma2001.model_fields_set:
            roughness = rules.agma2001.flank_roughness
    if "lubricant_factor" not in losses.model_fields_set and table == "iso6336":
        factor = BASES[rules.iso6336.oil_type].lubricant
    return Flank(roughness, factor)


def dipping(sizing: Sizing, dip: Mapping[str, float], path: str) -> Mapping[str, float]:
    """Return how far gears dip, refused where there is no such gear or it cannot dip so far.

    Args:
        sizing: With its gears.
        dip: Gear -> part of it [-].
        path: Where that is written.

    Raises:
        DesignError: With every gear that there is not, and the nearest.
    """
    gears = [gear.name for gear in sizing.gears]
    messages = {name: f"there is no gear {name!r}; {near(name, gears)}" for name in dip if name not in gears}
    messages |= {
        name: f"{part:g} of a gear cannot dip into oil; give 0 to 1"
        for name, part in dip.items()
        if not 0.0 <= part <= 1.0
    }
    refuse(Problem(f"{path}.{name}", message) for name, message in messages.items())
    return dip


# ----------------------------------------------------------------------------------------------------------------------
# At which limit of its formula a loss is taken, in words: there it no longer answers to what it depends on.
# ----------------------------------------------------------------------------------------------------------------------


_PART_1 = "ISO/TR 14179-1"


def mesh_limits(contact: ToothContact, duty: LossDuty, oil: OilState, law: MeshLaw, kind: str) -> str:
    """Return the limits at which the loss of a mesh is taken; empty where its formula holds.

    Args:
        contact: Of the pair.
        duty: Load and velocity.
        oil: Between the teeth.
        law: Whose formula.
        kind: Of the mesh: cylindrical, bevel or face.
    """
    words = [*_of_law(contact, duty, oil, law)] if duty.velocity and duty.line_load else []
    if kind in ("bevel", "face"):
        words.append(f"{kind} gears as the cylindrical pair of their teeth")
    return "; ".join(words)


def _of_law(contact: ToothContact, duty: LossDuty, oil: OilState, law: MeshLaw) -> Iterator[str]:
    if law is MeshLaw.ISO_TR_14179_1:
        yield from _held("V", abs(duty.velocity), (SLOWEST, FASTEST), "m/s")
        intensity = load_intensity(contact, duty.line_load) * 1e-6
        yield from _held("K", intensity, (LEAST_INTENSITY * 1e-6, MOST_INTENSITY * 1e-6), "N/mm²")
    elif law is MeshLaw.ANDERSON_LOEWENTHAL:
        if contact.helix:
            yield f"made for spur gears; β {degrees(contact.helix):.3g}° as its transverse section (NASA TP-1622)"
    else:
        friction = mesh_friction(
            contact, duty.line_load, duty.velocity,
            viscosity=oil.viscosity, roughness=oil.roughness, law=Friction(law.value),
        )  # fmt: skip
        if friction >= HIGHEST_FRICTION:
            yield f"μ_mz held at {HIGHEST_FRICTION:g}, boundary lubrication: an assumption"


def _held(symbol: str, value: float, span: tuple[float, float], unit: str) -> Iterator[str]:
    least, most = span
    if not least <= value <= most:
        counted = least if value < least else most
        yield f"{symbol} {value:.3g} {unit} counts as {counted:g} ({_PART_1}: {least:g} to {most:g})"


def churning_limits(gear: GearSizing) -> str:
    """Return the limits at which the churning of a gear is taken.

    Args:
        gear: That dips.
    """
    words = []
    if gear.helix_angle < LEAST_HELIX:
        words.append(f"β {degrees(gear.helix_angle):.3g}° counts as {degrees(LEAST_HELIX):g}° ({_PART_1})")
    if gear.module * 1e3 < LEAST_MODULE:
        words.append(f"m {gear.module * 1e3:.3g} mm counts as {LEAST_MODULE:g} in R_f")
    return "; ".join(words)


def seal_limits(oil: Oil) -> str:
    """Return the limits at which the loss of a seal is taken; none are told of an oil that warms up.

    Args:
        oil: Before it.
    """
    if oil.seals != "simrit" or isinstance(oil.temperature, np.ndarray):
        return ""
    factor = seal_oil_factor(oil.temperature, oil.grade[0])
    if factor >= LEAST_OIL_FACTOR:
        return ""
    at = f"at {oil.temperature - CELSIUS:g} °C and ν_40 {oil.grade[0] * 1e6:g} mm²/s"
    return f"factor {factor:.3g} {at} held at half of ISO/TR 14179-2, {LEAST_OIL_FACTOR:.3g}: an assumption"


def bearing_limits(method: str, turning: float, oil: Oil) -> str:
    """Return the limits at which the friction of a bearing is taken.

    Args:
        method: Whose friction it is.
        turning: Speed [rad/s].
        oil: In it.
    """
    if method != oil.bearings:
        return f"its size is not known: a constant coefficient in place of {oil.bearings}"
    product = oil.viscosity * 1e6 * turning / RPM
    if method == "palmgren" and 0.0 < product < LEAST_PRODUCT:
        return f"ν n {product:.3g} counts as {LEAST_PRODUCT:g}"
    return ""


# ----------------------------------------------------------------------------------------------------------------------
# What the meshes of a sized train lose.
# ----------------------------------------------------------------------------------------------------------------------


class Teeth(NamedTuple):
    """What the losses of the meshes depend on and no load changes; one entry for each mesh row."""

    contacts: tuple[ToothContact, ...]
    radii: Floats
    """Working pitch radius of gear a, shape (meshes,) [m]."""
    widths: Floats
    """Narrower face, shape (meshes,) [m]."""


def teeth_of(sizing: Sizing) -> Teeth:
    """Return what the losses of the meshes depend on.

    Args:
        sizing: As sized.
    """
    gears = {gear.name: gear for gear in sizing.gears}
    pairs = [(gears[mesh.gears[0]], gears[mesh.gears[1]]) for mesh in sizing.train.meshes]
    return Teeth(
        contacts=tuple(_contact(sizing, pair, mesh) for pair, mesh in zip(pairs, sizing.meshes, strict=True)),
        radii=np.array([mesh.working_diameter / 2.0 for mesh in sizing.meshes]),
        widths=np.array([min(gear.face_width, mate.face_width) for gear, mate in pairs]),
    )


def mesh_loss_parts(
    sizing: Sizing, teeth: Teeth, torques: Floats, *, speeds: Mapping[str, Values], oil: Oil
) -> dict[str, Values]:
    """Return mesh row -> part of the power of its teeth that it loses [-].

    Args:
        sizing: As sized.
        teeth: Its contacts.
        torques: On gear a of one single mesh of each row, shape (meshes,) or (meshes, n) [N m].
        speeds: Node -> its speed, of the ground too, one or shape (n,) [rad/s].
        oil: Between the teeth.
    """
    return {
        mesh.name: mesh_loss_part(teeth.contacts[k], duty, oil.on_teeth(mesh.stage), law=oil.friction)
        for k, (mesh, duty) in enumerate(zip(sizing.train.meshes, _duties(sizing, teeth, torques, speeds), strict=True))
    }


def mesh_loss_limits(
    sizing: Sizing, teeth: Teeth, torques: Floats, *, speeds: Mapping[str, float], oil: Oil
) -> dict[str, str]:
    """Return mesh row -> limits at which its loss is taken, as words; empty where the formula holds.

    Args:
        sizing: As sized.
        teeth: Its contacts.
        torques: On gear a of one single mesh of each row, shape (meshes,) [N m].
        speeds: Node -> its speed, of the ground too [rad/s].
        oil: Between the teeth.
    """
    kinds = {name: pair.kind for name, pair in sizing.design.pairs.items()}
    duties = _duties(sizing, teeth, torques, speeds)
    return {
        mesh.name: mesh_limits(
            teeth.contacts[k], duty, oil.on_teeth(mesh.stage), oil.friction, kinds.get(mesh.stage, "")
        )
        for k, (mesh, duty) in enumerate(zip(sizing.train.meshes, duties, strict=True))
    }


def _duties(sizing: Sizing, teeth: Teeth, torques: Floats, speeds: Mapping[str, Values]) -> Iterator[LossDuty]:
    """Yield load and velocity of every mesh row."""
    for k, mesh in enumerate(sizing.train.meshes):
        normal = abs(torques[k]) / (teeth.radii[k] * np.cos(teeth.contacts[k].pressure_angle))
        velocity = (speeds[mesh.nodes[0]] - speeds[mesh.nodes[2]]) * teeth.radii[k]
        yield LossDuty(plain(normal / teeth.widths[k]), float(teeth.widths[k]), plain(velocity))


def _contact(sizing: Sizing, pair: tuple[GearSizing, GearSizing], mesh: MeshSizing) -> ToothContact:
    gear, mate = pair
    shifted = gear.profile_shift + mate.profile_shift != 0.0
    return tooth_contact(
        (gear.teeth, -mate.teeth if mate.name in sizing.train.internal else mate.teeth),
        gear.module,
        pressure_angle=sizing.design.rules(mesh.stage).pressure_angle,
        helix_angle=gear.helix_angle,
        shifts=(_shift(gear), _shift(mate)),
        working_angle=mesh.working_pressure_angle if shifted else None,
    )


def _shift(gear: GearSizing) -> ToothShift:
    return ToothShift(gear.profile_shift, gear.tip_alteration)


# ----------------------------------------------------------------------------------------------------------------------
# What the bearings of a sized train lose.
# ----------------------------------------------------------------------------------------------------------------------


@dataclass(frozen=True)
class SeatLoss:
    """What the bearings of one seat, or of several equal ones, lose."""

    seat: str
    count: int
    """Equal bearings [-]."""
    power: float
    """Of all of them [W]."""
    method: str
    """Whose friction."""
    limit: str
    """Limits of it at which it is taken; empty where it holds."""


class Rubbing(NamedTuple):
    """What the bearings of one seat, or of several equal ones, lose under one load or under many."""

    seat: Seat
    bearings: int
    """Equal ones [-]."""
    power: Values
    """Of all of them [W]."""
    method: str
    """Whose friction."""


def bearing_losses(
    sizing: Sizing, seats: tuple[Seat, ...], torques: Floats, *, speeds: Mapping[str, float], oil: Oil
) -> Iterator[SeatLoss]:
    """Yield what the bearings of every seat lose; one of unknown size by a constant coefficient.

    Args:
        sizing: As sized.
        seats: From `bearing_seats`.
        torques: On gear a of one single mesh of each row, shape (meshes,) [N m].
        speeds: Node -> its speed, of the ground too [rad/s].
        oil: In them.
    """
    forces = {seat.name: seat_forces(seat, torques, np.array(speeds[seat.carrier])) for seat in seats}
    for seat, count, power, method in rubbing(sizing, seats, forces, speeds=speeds, oil=oil):
        turning = abs(speeds[seat.nodes[0]] - speeds[seat.nodes[1]])
        limit = "" if method == "film" else bearing_limits(method, turning, oil)
        yield SeatLoss(seat.name, count, power, method, limit)


def rubbing(
    sizing: Sizing,
    seats: tuple[Seat, ...],
    forces: Mapping[str, tuple[Values, Values]],
    *,
    speeds: Mapping[str, Values],
    oil: Oil,
) -> Iterator[Rubbing]:
    """Yield what the bearings of every seat lose; one of unknown size by a constant coefficient.

    Args:
        sizing: As sized.
        seats: From `bearing_seats`.
        forces: Seat -> radial force, and the meshes' force along its shaft, one or shape (n,) each [N].
        speeds: Node -> its speed, of the ground too, one or shape (n,) [rad/s].
        oil: In them.
    """
    along = {} if oil.bearings == "constant" else _along(sizing, seats, forces)
    for seat in seats:
        turning, radial = abs(speeds[seat.nodes[0]] - speeds[seat.nodes[1]]), plain(forces[seat.name][0])
        if seat.runs_on is not None and seat.runs_on.journal is not None:
            yield Rubbing(seat, seat.count, seat.count * _film_power(seat, radial, turning, oil), "film")
            continue
        fitted = None if oil.bearings == "constant" else fitted_in(sizing, seat)
        if fitted is None:
            torque = bearing_torque_constant(radial, seat.bore)
            yield Rubbing(seat, seat.count, seat.count * torque * turning, "constant")
        else:
            load = (radial / fitted.side_by_side, along.get(seat.name, 0.0) / fitted.side_by_side)
            power = fitted.side_by_side * _torque(fitted, load, turning, oil) * turning
            yield Rubbing(seat, seat.count * fitted.side_by_side, seat.count * power, oil.bearings)


def _film_power(seat: Seat, radial: Values, turning: Values, oil: Oil) -> Values:
    """Return what the film of one planet loses [W]; its oil enters as the design says, or as warm as all of it."""
    assert seat.runs_on is not None and seat.runs_on.journal is not None and seat.fitted is not None
    of, stands = functions(radial, turning), (turning < STANDING) | (radial <= 0.0)
    given = seat.fitted.oil_temperature
    entering = film_oil(oil.grade, oil.density, oil.temperature if given is None else given + CELSIUS)
    state = run_film(seat.runs_on.journal, of.where(stands, 1.0, radial), of.where(stands, 1.0, turning), entering)
    return of.where(stands, 0.0, state.power)


def _torque(fitted: SeatedBearing, load: tuple[Values, Values], turning: Values, oil: Oil) -> Values:
    """Return the friction torque of one bearing [N m]."""
    taken, friction = fitted.bearing, bearing_friction(fitted.bearing)
    radial, axial = load
    if oil.bearings == "palmgren":
        return bearing_torque_palmgren(
            _deciding(fitted, radial, axial), (taken.bore + taken.outer_diameter) / 2.0, turning,
            viscosity=oil.viscosity, oil_factor=friction.oil_factor, load_factor=friction.load_factor,
        )  # fmt: skip
    running = RunningBearing(
        taken.kind, taken.bore, taken.outer_diameter, taken.static_rating, taken.geometry.contact_angle, radial, axial
    )
    return bearing_torque_skf(running, friction, turning, viscosity=oil.viscosity)


def _deciding(fitted: SeatedBearing, radial: Values, axial: Values) -> Values:
    """Return the load P_1 that decides Palmgren's friction [N]: at least the radial one."""
    if not isinstance(radial, np.ndarray):
        return max(equivalent_loads(fitted.bearing, radial, axial)[0], radial)
    pushed = np.flatnonzero(axial)
    loads = [radial, np.broadcast_to(axial, radial.shape)]
    equal = [
        equivalent_loads(fitted.bearing, *load)[0]
        for load in zip(*(one[pushed].tolist() for one in loads), strict=True)
    ]
    deciding = radial.copy()
    deciding[pushed] = np.maximum(equal, radial[pushed])
    return deciding


_NOTHING = 1e-9
"""Part of the largest radial force below which an axial one is rounding [-]."""


def _along(sizing: Sizing, seats: tuple[Seat, ...], forces: Mapping[str, tuple[Values, Values]]) -> dict[str, Values]:
    """Return the axial force in every bearing that the design seats [N]."""
    found: dict[str, Values] = {}
    for shaft in dict.fromkeys(seat.nodes[0] for seat in seats if seat.given is not None):
        given = {seat.name: seat.given for seat in seats if seat.nodes[0] == shaft and seat.given is not None}
        first = next(seat for seat in seats if seat.name in given)
        thrust = usual_thrust(sizing.design, sizing.flows, shaft, in_bearings=True)
        along = forces[first.name][1] + first.rotor_side * thrust
        tapers = {
            sized.name: taper_factors(sized.bearing.geometry.contact_angle)
            for sized in sizing.bearings
            if sized.name in given and sized.bearing.kind is BearingKind.TAPER
        }
        radial = {name: np.atleast_1d(forces[name][0]) for name in given}
        axial = _divided(shaft, given, np.atleast_1d(along), radial=radial, tapers=tapers)
        many = isinstance(forces[first.name][0], np.ndarray) and forces[first.name][0].ndim
        found |= {name: force if many else float(force[0]) for name, force in axial.items()}
    return found


def _divided(
    shaft: str,
    given: Mapping[str, BearingSeat],
    along: Floats,
    *,
    radial: Mapping[str, Floats],
    tapers: Mapping[str, LoadFactors],
) -> dict[str, Floats]:
    """Return the axial force in every bearing of a shaft, shape (n,) each [N].

    What no bearing takes, as beside the cases that sized it, rubs in none.
    """
    if len({LOCATES[seat.locates][0] for seat in given.values() if seat.kind == "taper"}) == 2:
        return axial_forces(shaft, given, along, radial=radial, factors=tapers, cases=("",) * len(along))
    taken, nobody = {name: np.zeros_like(along) for name in given}, np.zeros(len(along), bool)
    largest = np.max(list(radial.values()), axis=0)
    for sign in (-1, 1):
        pushed = np.maximum(sign * along, 0.0)
        felt = pushed > _NOTHING * largest
        takers = [name for name, seat in given.items() if sign in LOCATES[seat.locates]]
        if takers:
            taken[takers[0]] += np.where(felt, pushed, 0.0)
        else:
            nobody |= felt
    return {name: np.where(nobody, 0.0, force) for name, force in taken.items()}


# ----------------------------------------------------------------------------------------------------------------------
# What gears lose in oil and mist, and shafts in their seals.
# ----------------------------------------------------------------------------------------------------------------------


_DEDENDUM = 1.25
"""Of the rack in modules, for root diameters [-] (ISO 53, profile A)."""


@dataclass(frozen=True)
class BodyLoss:
    """What one part of the gearbox loses beside what it carries."""

    part: str
    origin: str
    """windage, churning or seals."""
    count: int
    """Equal parts [-]."""
    power: Values
    """Of all of them [W]."""
    limit: str = ""
    """Limits of its formula at which it is taken; empty where it holds."""


def gear_losses(sizing: Sizing, speeds: Mapping[str, Values], oil: Oil) -> Iterator[BodyLoss]:
    """Yield the windage, or the churning, of every gear; one that dips churns the bath instead of the mist.

    Args:
        sizing: As sized.
        speeds: Node -> its speed, one or shape (n,) [rad/s].
        oil: Around them.
    """
    for gear in sizing.gears:
        turning, dip = speeds.get(gear.shafts[0], 0.0), oil.dip.get(gear.name, 0.0)
        if dip:
            transverse = gear.module / functions(turning).cos(gear.helix_angle)
            power = churning_power(
                gear.pitch_diameter, gear.face_width, turning,
                viscosity=oil.viscosity, dip=dip, module=transverse, helix_angle=gear.helix_angle,
            )  # fmt: skip
        else:
            power = _windage(gear, turning, oil)
        origin, limit = ("churning", churning_limits(gear)) if dip else ("windage", "")
        yield BodyLoss(gear.name, origin, gear.bodies, gear.bodies * power, limit)


def _windage(gear: GearSizing, turning: Values, oil: Oil) -> Values:
    if oil.windage == "dawson":
        root = gear.pitch_diameter - 2.0 * (_DEDENDUM - gear.profile_shift) * gear.module
        return windage_power_dawson(root, gear.face_width, turning, module=gear.module, enclosure=oil.enclosure)
    viscosity = oil.viscosity * oil.density
    return windage_power(gear.pitch_diameter / 2.0, gear.face_width, turning, viscosity=viscosity)


def seal_losses(sizing: Sizing, speeds: Mapping[str, Values], oil: Oil) -> Iterator[BodyLoss]:
    """Yield what the seal of every machine's shaft loses; nothing where no seals are counted.

    A chosen seal counts with its shaft and its lip, all others as FKM on the shaft's one diameter.

    Args:
        sizing: As sized.
        speeds: Node -> its speed, one or shape (n,) [rad/s].
        oil: Before them.
    """
    if oil.seals == "none":
        return
    diameters = {shaft.name: shaft.diameter for shaft in sizing.shafts}
    chosen = {leaves.machine: leaves for leaves in exits_of(sizing) if leaves.seal is not None}
    for machine in sizing.machines:
        leaves = chosen.get(machine.name)
        diameter = diameters[machine.shaft] if leaves is None else leaves.diameter
        nitrile = leaves is not None and leaves.elastomer is not None and leaves.elastomer.name == "nbr"
        power = _seal(diameter, speeds[machine.shaft], oil, torque=NITRILE if nitrile else VITON)
        yield BodyLoss(f"seal at {machine.name}", "seals", 1, power, seal_limits(oil))


def _seal(diameter: float, speed: Values, oil: Oil, *, torque: float) -> Values:
    if oil.seals == "iso-tr-14179-1":
        return seal_power_14179_1(diameter, speed, torque_per_mm=torque)
    if oil.seals == "iso-tr-14179-2":
        return seal_power_14179_2(diameter, speed)
    return seal_power_oil(diameter, speed, temperature=oil.temperature, viscosity_40=oil.grade[0])


# ----------------------------------------------------------------------------------------------------------------------
# Where the power of a case goes: a row for every mesh, bearing, gear and seal.
# ----------------------------------------------------------------------------------------------------------------------


ORIGINS = ("meshes", "bearings", "windage", "churning", "seals")
"""Where power is lost, in the order of tables."""
_SOURCE = "[losses] of the design"


@dataclass(frozen=True)
class Loss:
    """What one part of the gearbox loses in a case."""

    case: str
    origin: str
    """meshes, bearings, windage, churning or seals."""
    part: str
    count: Number
    """Equal parts [-]."""
    power: Annotated[float, Quantity("power"), Origin("P_V", _SOURCE)]
    """Of all of them [W]."""
    share: Annotated[float, Quantity("percent"), Origin("P_V/P_in", _SOURCE)]
    """Of the power into the gearbox [-]."""
    method: str
    """Whose formula."""
    limit: str
    """Limits of the formula at which it is taken; empty where it holds."""


@dataclass(frozen=True, repr=False)
class LossBalance(Shown):
    """Where the power of a case goes."""

    case: str
    power: Power
    """Into the gearbox [W]."""
    losses: tuple[Loss, ...]
    """By origin, the largest of each first."""

    @property
    def lost(self) -> Power:
        """By all parts [W]."""
        return sum(loss.power for loss in self.losses)

    @property
    def efficiency(self) -> Annotated[Ratio, Origin("η = 1 − Σ P_V/P_in", _SOURCE)]:
        """Power out over power in [-]; 1 where none goes in."""
        return 1.0 - self.lost / self.power if self.power else 1.0

    def by_origin(self) -> dict[str, float]:
        """Return origin -> power that is lost there [W]."""
        return {
            origin: sum(loss.power for loss in self.losses if loss.origin == origin)
            for origin in ORIGINS
            if any(loss.origin == origin for loss in self.losses)
        }


@verb
def loss_balance(sizing: Sizing, case: str | None = None) -> LossBalance:
    """Return where the power of a case goes, by the formulas of the design's [losses] and with its [oil].

    Args:
        sizing: As sized.
        case: One of its cases; left out: the one that speaks for the design.

    Raises:
        DesignError: There is no such case, or a gear dips that there is not.

    Source: `mesh_loss_parts`, `bearing_losses`, `gear_losses`, `seal_losses`.
    """
    asked = _asked(sizing, case)
    losses = list(_losses(sizing, asked))
    return LossBalance(
        asked.name,
        asked.given,
        tuple(sorted(largest_first(losses, lambda loss: loss.power), key=lambda loss: ORIGINS.index(loss.origin))),
    )


def lost_power(sizing: Sizing) -> float:
    """Return what all parts lose in the case that speaks for the design [W]: the sum of `loss_balance`.

    Args:
        sizing: As sized.
    """
    return sum(loss.power for loss in _losses(sizing, _asked(sizing, None)))


def largest_heat(sizing: Sizing) -> float:
    """Return the most that all parts lose in a case that lasts [W]: what the oil carries away.

    Args:
        sizing: As sized.
    """
    lasting = [case for case in sizing.flows if not case_named(sizing.design, case).static]
    return max(sum(loss.power for loss in _losses(sizing, _asked(sizing, case))) for case in lasting)


def _asked(sizing: Sizing, case: str | None) -> _Case:
    """Return a case, or the one that speaks for the design."""
    flow = sizing.reference if case is None else by_name(case, sizing.flows, "case")
    given = sum(power for power in flow.machine_powers.values() if power > 0.0)
    return _Case(flow.case, given, {**flow.speeds, GROUND: 0.0}, _torques(sizing, flow), oil_of_design(sizing))


def _losses(sizing: Sizing, case: _Case) -> Iterator[Loss]:
    """Yield the loss of every part, in the order of the design."""
    yield from _meshes(sizing, case)
    yield from _bearings(sizing, case)
    yield from _bodies(sizing, case)


class _Case(NamedTuple):
    """What turns and what is borne in a case."""

    name: str
    given: float
    speeds: Mapping[str, float]
    torques: Floats
    oil: Oil

    def loss(self, origin: str, part: str, *, count: int, power: float, method: str, limit: str) -> Loss:
        share = power / self.given if self.given else 0.0
        return Loss(self.name, origin, part, count, power, share, method, limit)


def _torques(sizing: Sizing, flow: PowerFlow) -> Floats:
    """Return the torque on gear a of one single mesh of each row [N m]."""
    return np.array([flow.meshes[mesh.name].torques[0] / mesh.count for mesh in sizing.train.meshes])


def _meshes(sizing: Sizing, case: _Case) -> Iterator[Loss]:
    teeth, method = teeth_of(sizing), case.oil.friction.value
    parts = mesh_loss_parts(sizing, teeth, case.torques, speeds=case.speeds, oil=case.oil)
    limits = mesh_loss_limits(sizing, teeth, case.torques, speeds=case.speeds, oil=case.oil)
    for torque, mesh in zip(case.torques.tolist(), sizing.train.meshes, strict=True):
        rolling = abs(torque * (case.speeds[mesh.nodes[0]] - case.speeds[mesh.nodes[2]]))
        power = mesh.count * parts[mesh.name] * rolling
        limit = limits[mesh.name]
        yield case.loss("meshes", mesh.name, count=mesh.count, power=power, method=method, limit=limit)


def _bearings(sizing: Sizing, case: _Case) -> Iterator[Loss]:
    for seat in bearing_losses(sizing, bearing_seats(sizing), case.torques, speeds=case.speeds, oil=case.oil):
        yield case.loss("bearings", seat.seat, count=seat.count, power=seat.power, method=seat.method, limit=seat.limit)


def _bodies(sizing: Sizing, case: _Case) -> Iterator[Loss]:
    methods = {"windage": case.oil.windage, "churning": "iso-tr-14179-1", "seals": case.oil.seals}
    for body in (*gear_losses(sizing, case.speeds, case.oil), *seal_losses(sizing, case.speeds, case.oil)):
        method = methods[body.origin]
        yield case.loss(body.origin, body.part, count=body.count, power=body.power, method=method, limit=body.limit)
