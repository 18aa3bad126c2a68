"""Planet carriers: pins, plates, bridges between two plates, and how far planets tilt under torque."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

from gearwright.base import Floats
from gearwright.elementwise import Values

# ----------------------------------------------------------------------------------------------------------------------
# First sizing of a planet carrier: cantilever pins in bending, a plate that carries the torque.
# ----------------------------------------------------------------------------------------------------------------------


WIDEST_PIN_BORE = 0.8
"""Bore of a pin over its diameter, at most: thinner walls go out of round under rollers or film, an assumption [-]."""
LEAST_EYE = 0.25
"""Metal outside the hole of a pin over the diameter that a solid pin needs, at least [-]: an estimate."""


def pin_diameter(force: float, face_width: float, allowable: float) -> float:
    """Return the diameter of a cantilever planet pin [m].

    Args:
        force: Of one planet on its pin: T_c/(N r_c) from the teeth and m r_c ω_c² from the planet, at right angles [N].
        face_width: Planet face width; the force acts at its middle [m].
        allowable: Allowable bending stress [Pa].

    Source: cantilever beam, d³ = 32 M/(π σ) with M = F b/2; Pulvirenti 2023, §2.4 (model), with the force 2 F_t.
    """
    return math.cbrt(32.0 * force * face_width / 2.0 / (math.pi * allowable))


PIN_BORE = 0.6
"""Bore of pins that two plates hold over their diameter [-], an estimate; thicker by 1/∛(1 − κ⁴) they are as strong."""
BRIDGE = 0.5
"""Depth of a carrier's bridge over a planet's diameter [-], an estimate from drawings of two-plate carriers."""
BESIDE = 1e-3
"""Room between a bridge and each planet beside it [m], an assumption."""


def bridge_thickness(force: float, length: float, depth: float, allowable: float) -> float:
    """Return the thickness around the axis that a bridge between two plates needs [m].

    Args:
        force: Around the axis that crosses to the second plate through it, T/(2 N r) [N].
        length: Between both plates [m].
        depth: Away from the axis [m].
        allowable: Bending stress [Pa].

    Source: beam with both ends held that shift by each other, M = F L/2; t = √(6 M/(h σ)).

    >>> round(1e3 * bridge_thickness(10e3, 0.08, 0.06, 400e6), 3)
    10.0
    """
    return math.sqrt(6.0 * force * length / 2.0 / (depth * allowable))


def shared_lever(width: float, thickness: float) -> float:
    """Return the bending moment of a pin that two plates hold, over half of its force [m], as `pin_diameter` takes it.

    Args:
        width: Of the planet, over which the force is spread [m].
        thickness: Of a plate, in whose middle the pin is held [m].

    Source: beam on two supports L = b + t apart under a force spread over b, M = F/4 (L − b/2); between F b/8, of
        plates without thickness, and F L/4, of a force at one place.

    Valid for: a force in the middle between both plates; pins that turn freely in them, which is the larger moment.

    >>> round(shared_lever(0.08, 0.01), 4)
    0.025
    """
    return (width + thickness - width / 2.0) / 2.0


def pin_bore(diameter: float, needed: float) -> float:
    """Return the bore that a pin may have which is thicker than its strength asks [m].

    Args:
        diameter: Of the pin, as its bearing asks [m].
        needed: Of a solid pin that is strong enough [m].

    Source: equal section moduli: 1 − κ⁴ = (d_needed/d)³; at most `WIDEST_PIN_BORE`.
    """
    spare = max(1.0 - (needed / diameter) ** 3, 0.0)
    return diameter * min(math.pow(spare, 0.25), WIDEST_PIN_BORE)


def pin_stress(force: float, face_width: float, diameter: float, *, bore: float = 0.0) -> float:
    """Return the bending stress of a cantilever planet pin at its root [Pa].

    Args:
        force: Of one planet on its pin, at the middle of the face width [N].
        face_width: Planet face width [m].
        diameter: Of the pin [m].
        bore: Of a hollow pin [m].

    Source: cantilever beam, σ = 32 (F b/2) / (π d³), of a hollow one over 1 − κ⁴.
    """
    return 32.0 * force * face_width / 2.0 / (math.pi * diameter**3 * (1.0 - (bore / diameter) ** 4))


def pin_mass(diameter: float, face_width: float, density: float, *, bore: float = 0.0) -> float:
    """Return the mass of one planet pin of the planet's width [kg].

    Args:
        diameter: [m].
        face_width: [m].
        density: ρ [kg/m³].
        bore: Of a hollow pin [m].

    Source: cylinder.
    """
    return math.pi / 4.0 * (diameter**2 - bore**2) * face_width * density


def eye_wall(force: float, thickness: float, shear: float, *, needed: float) -> float:
    """Return the metal that a plate needs outside the hole of a pin [m].

    Args:
        force: Of one planet on its pin; what one plate bears of it: half, where two hold the pin [N].
        thickness: Of the plate [m].
        shear: Allowable shear stress [Pa].
        needed: Diameter of a solid pin that is strong enough [m].

    Source: equilibrium of a block that a pin tears out of an eye along two planes, F = 2 w t τ; by Tresca both sides of
        the eye in tension, F = 2 w t σ, then bear twice as much. At least `LEAST_EYE` of a solid pin, an estimate.

    Valid for: lugs under a force towards their edge, without the stress concentration at the hole.

    >>> round(1e3 * eye_wall(29428.0, 4.2e-3, 196.25e6, needed=18.58e-3), 2)
    17.85
    """
    return max(force / (2.0 * thickness * shear), LEAST_EYE * needed)


def eye_stress(force: float, thickness: float, wall: float) -> float:
    """Return the shear stress along both planes by which a pin would tear out of its eye [Pa].

    Args:
        force: Of one planet on its pin [N].
        thickness: Of the plate [m].
        wall: Metal outside the hole [m].

    Source: equilibrium, τ = F/(2 w t).
    """
    return force / (2.0 * wall * thickness)


def hole_pressure(force: float, diameter: float, thickness: float) -> float:
    """Return the pressure of a pin in the hole of its plate [Pa].

    Args:
        force: Of one planet on its pin [N].
        diameter: Of the pin [m].
        thickness: Of the plate [m].

    Source: force over the projected area, p = F/(d t).
    """
    return force / (diameter * thickness)


def plate_mass(radius: float, thickness: float, density: float, *, fill: float) -> float:
    """Return the mass of the carrier's plate [kg].

    Args:
        radius: Outer radius, pin circle plus half a pin and the metal outside it [m].
        thickness: [m].
        density: ρ [kg/m³].
        fill: Share of the disc that is not cut out [-].

    Source: disc.
    """
    return math.pi * radius**2 * thickness * density * fill


def plate_shear_stress(torque: float, hub_diameter: float, thickness: float) -> float:
    """Return the shear stress in the plate where it meets its shaft [Pa].

    Args:
        torque: Carrier torque T_c [N m].
        hub_diameter: Diameter of the shaft that the plate is one piece with [m].
        thickness: Plate thickness [m].

    Source: torque over the cylinder of the hub, τ = 2 T_c / (π d² t); the carrier's plate bears T_c, which Pulvirenti
        2023, §2.4 leaves out.
    """
    return 2.0 * torque / (math.pi * hub_diameter**2 * thickness)


_HUB = 2.16
"""Diameter of a shaft as it is sized by its torque over ∛(T/σ) [-]."""


class Plate(NamedTuple):
    """Of what and how the plates of carriers are made."""

    allowable: float
    """Stress of pins and plate [Pa]."""
    density: float
    """[kg/m³]"""
    ratio: float
    """Thickness over the face width of the planets, at least [-]."""
    fill: float
    """Share of the plate that is not cut out [-]."""
    turns: bool
    """Whether a shaft stands in the plate, 2.16 ∛(T/σ) thick as it is sized."""


def first_carrier_mass(
    loads: Sequence[tuple[float, float]], radius: Floats, face_width: Floats, tips: tuple[Floats, Floats, Floats],
    *, planet: Floats, planets: int, plate: Plate,
) -> Floats:  # fmt: skip
    """Return about what the carriers of arrays of simple sets weigh, to rank them: pins, two plates, bridges [kg].

    Args:
        loads: Torque [N m], K_γ included, and speed [rad/s] of the carrier in every case.
        radius: Of the circle of pins [m].
        face_width: Of the planets [m].
        tips: Radii of the tips of sun, planets and ring [m].
        planet: Mass of one planet [kg].
        planets: Their number [-].
        plate: Of the carrier.

    Source: as `pin_diameter`, with `shared_lever` where planets leave room for bridges, `hole_pressure`,
        `plate_shear_stress`, `eye_wall` and `plate_mass`; bridges as wide as neighbouring planets leave on their chord.
    """
    allowable = plate.allowable
    forces = [np.hypot(torque / (planets * radius), planet * radius * speed**2) for torque, speed in loads]
    sun, own, ring = tips
    chord = np.maximum(2.0 * (radius * math.sin(math.pi / planets) - own), 0.0)
    plates = np.where(chord > 0.0, 2.0, 1.0)
    thinnest = plate.ratio * face_width / plates
    force, lever = np.maximum.reduce(forces), np.where(chord > 0.0, (face_width / 2.0 + thinnest) / 2.0, face_width)
    needed = np.cbrt(16.0 * force * lever / (math.pi * allowable))
    pin, force = needed / np.where(chord > 0.0, math.cbrt(1.0 - PIN_BORE**4), 1.0), force / plates
    hub = 4.0 / (math.pi * _HUB**2) * math.cbrt(max(torque for torque, _ in loads) / allowable) if plate.turns else 0.0
    thinnest = np.maximum(thinnest, force / (pin * allowable))
    thickness = np.maximum(thinnest, hub)
    wall = np.maximum(force / (np.where(chord > 0.0, thinnest, thickness) * allowable), LEAST_EYE * needed)
    discs = math.pi * (radius + pin / 2.0 + wall) ** 2 * (thickness + thinnest) * plate.fill
    middle = radius * math.cos(math.pi / planets)
    outer = np.minimum(middle + BRIDGE * own, np.sqrt(np.maximum(ring**2 - chord**2 / 4.0, 0.0)))
    bridge = chord * np.maximum(outer - np.maximum(middle - BRIDGE * own, sun), 0.0)
    section = np.where(chord > 0.0, 1.0 - PIN_BORE**2, 1.0) * math.pi / 4.0 * pin**2
    posts = planets * face_width * (section + bridge)
    return np.asarray(plate.density * (posts + discs))


# ----------------------------------------------------------------------------------------------------------------------
# Tilt of planets under torque: a plate lags behind the other by the bridges between them, and carries the pins' ends.
#
# Torque enters at one plate. Half of the force of every pin goes into the other, free plate and from there through the
# bridges to the first: bridges bend and shear, built in at plates that bend and twist between them, and all pins lean.
# ----------------------------------------------------------------------------------------------------------------------


SHEAR = 5.0 / 6.0
"""Shear coefficient κ of rectangular sections [-]."""
ROUND_SHEAR = 0.9
"""Shear coefficient κ of round sections [-]."""


class Elastic(NamedTuple):
    """Moduli of what carriers are made of."""

    young: float
    """E [Pa]."""
    shear: float
    """G [Pa]."""


class Frame(NamedTuple):
    """Two plates with bridges between neighbouring planets; numbers, or arrays of candidates."""

    planets: int
    """And bridges, N [-]."""
    pins: float
    """Radius of the circle of pins r [m]."""
    length: float
    """Between both plates L [m]."""
    width: Values
    """Of a bridge, around the axis w [m]."""
    depth: Values
    """Of a bridge, away from the axis h [m]."""
    radius: Values
    """Of the middle of a bridge r_b [m]."""
    plate: Values
    """Thickness t of either plate [m]."""
    band: Values
    """Of either plate, away from the axis, as a ring around the circle of pins c [m]."""


def torsion_section(wide: Values, thick: Values) -> Floats:
    """Return the torsion constant of a rectangle [m⁴].

    Args:
        wide: One side [m].
        thick: The other [m].

    Source: Roark, J = a b³ (1/3 − 0.21 b/a (1 − b⁴/(12 a⁴))), a ≥ b; within 4 % of Saint-Venant's series.

    >>> round(float(torsion_section(1.0, 1.0)), 4)
    0.1408
    """
    a, b = np.maximum(wide, thick), np.minimum(wide, thick)
    return np.asarray(a * b**3 * (1.0 / 3.0 - 0.21 * b / a * (1.0 - b**4 / (12.0 * a**4))))


def plate_stiffness(
    planets: int, radius: Values, rigid: Values, *, plate: Values, band: Values, moduli: Elastic
) -> Floats:
    """Return the moment about the radius that turns a plate by a radian at each of equal places on a circle [N m/rad].

    Args:
        planets: Number of places N [-].
        radius: Of their circle [m].
        rigid: Width around the axis of what stands there and does not bend w [m].
        plate: Thickness t [m].
        band: Of the plate as a ring, away from the axis c [m].
        moduli: Of the plate.

    Returns:
        12 E I ℓ²/(ℓ_c³ (1 + Φ)) cos²(π/N) + 4 G J/ℓ_c sin²(π/N), with ℓ = 2 r sin(π/N), ℓ_c = ℓ − w.

    Source: slope-deflection of Timoshenko beams, straight from place to place, of which both ends turn alike.

    Valid for: N ≥ 3, moments that are alike at all places.
    """
    span = 2.0 * radius * math.sin(math.pi / planets)
    clear = np.maximum(span - rigid, 1e-3 * span)
    bent, twisted = band * plate**3 / 12.0, torsion_section(band, plate)
    stubby = 12.0 * moduli.young * bent / (SHEAR * moduli.shear * band * plate * clear**2)
    across, along = math.cos(math.pi / planets) ** 2, math.sin(math.pi / planets) ** 2
    bends = 12.0 * moduli.young * bent * span**2 / (clear**3 * (1.0 + stubby))
    return np.asarray(bends * across + 4.0 * moduli.shear * twisted / clear * along)


def plate_lag(force: float, frame: Frame, moduli: Elastic) -> Floats:
    """Return how far the free plate lags behind the other on the circle of pins [m].

    Args:
        force: Of one planet on its pin around the axis F [N].
        frame: Plates and bridges.
        moduli: Of their material.

    Returns:
        r² (F/2)/(r_b²/c + G J/L): bridges that bend and shear with c = L³/(12 E I) + L/(κ G A) + L²/(2 K), and twist; K
        from `plate_stiffness`.

    Source: slope-deflection (Timoshenko), bridges with both ends in plates that turn and shift by each other.

    Valid for: pins that turn freely in both plates and so do not stiffen them; N ≥ 3; in-plane bending of plates, which
        moves both alike, left out. Against frames of beams: `tests/verification/test_carrier_twist.py`.
    """
    young, shear = moduli
    w, h, length = frame.width, frame.depth, frame.length
    area, inertia = w * h, h * w**3 / 12.0
    turns = plate_stiffness(
        frame.planets, frame.radius, w, plate=frame.plate, band=frame.band, moduli=moduli
    )  # fmt: skip
    own = length**3 / (12.0 * young * inertia) + length / (SHEAR * shear * area)
    shifts = frame.radius**2 / (own + length**2 / (2.0 * turns))
    return np.asarray(frame.pins**2 * force / 2.0 / (shifts + shear * torsion_section(w, h) / length))


def lag_tilt(lag: Values, length: float, plate: Values) -> Values:
    """Return the tilt of planets on pins that two plates hold [rad].

    Args:
        lag: From `plate_lag` [m].
        length: Between both plates [m].
        plate: Thickness of either, in whose middle the pin is held [m].

    Source: geometry; a pin's own bending is alike on both sides of the middle of its planet and tilts it by nothing.

    >>> round(1e6 * lag_tilt(60e-6, 0.5, 0.1))
    100
    """
    return lag / (length + plate)


def cantilever_tilt(force: float, width: float, diameter: float, moduli: Elastic, *, bore: float = 0.0) -> float:
    """Return the mean tilt of a planet on a cantilever pin [rad].

    Args:
        force: Of the planet on its pin around the axis, spread over its width F [N].
        width: Of the planet b [m].
        diameter: Of the pin [m].
        moduli: Of the pin.
        bore: Of a hollow pin [m].

    Returns:
        F b²/(8 E I) + F/(2 κ G A), the deflection of the pin's end over b.

    Source: cantilever under a uniform load, any text.

    Valid for: a pin that is built into a rigid plate.

    >>> round(1e6 * cantilever_tilt(20e3, 0.04, 0.025, Elastic(206e9, 79e9)))
    1299
    """
    inertia, area = math.pi / 64.0 * (diameter**4 - bore**4), math.pi / 4.0 * (diameter**2 - bore**2)
    return force * width**2 / (8.0 * moduli.young * inertia) + force / (2.0 * ROUND_SHEAR * moduli.shear * area)


def clamped_pressure(force: float, width: float, diameter: float, plate: Values) -> Values:
    """Return the largest pressure of a cantilever pin in the hole of its plate [Pa].

    Args:
        force: Of one planet on its pin, at the middle of its width F [N].
        width: Of the planet b [m].
        diameter: Of the pin d [m].
        plate: Thickness t [m].

    Source: equilibrium, linear along the hole: F/(d t) + 6 F (b + t)/2/(d t²).

    >>> round(clamped_pressure(20e3, 0.04, 0.04, 0.02) / 1e6)
    250
    """
    return force / (diameter * plate) + 3.0 * force * (width + plate) / (diameter * plate**2)


# ----------------------------------------------------------------------------------------------------------------------
# Plates and bridges that keep planets straight: the lightest of some hundred that do.
# ----------------------------------------------------------------------------------------------------------------------


class Window(NamedTuple):
    """Room for bridges and plates of a set."""

    planets: int
    """N [-]."""
    pins: float
    """Radius of the circle of pins [m]."""
    tip: float
    """Radius of the tips of a planet, with the room beside it [m]."""
    inner: float
    """Radius of the sun's tips, with the room beside it [m]."""
    outer: float
    """Largest radius of plates and bridges: through the ring [m]."""
    length: float
    """Between both plates [m]."""


class Asked(NamedTuple):
    """What plates and bridges have to bear, and the least of them that is strong enough."""

    force: float
    """Of one planet on its pin around the axis [N]."""
    tilt: float
    """Of planets, at most [rad]."""
    plates: tuple[float, float]
    """Least thickness, of the plate at the shaft and of the free one [m]."""
    reach: float
    """Least radius of plates [m]."""
    bending: float
    """Stress of bridges, at most [Pa]."""
    fill: float
    """Share of plates that is not cut out [-]."""


class Stiff(NamedTuple):
    """Plates and bridges that were found."""

    plates: tuple[float, float]
    """Thickness of the plate at the shaft and of the free one [m]."""
    reach: float
    """Radius of plates [m]."""
    width: float
    """Of a bridge, around the axis; 0 where planets leave none that is strong enough [m]."""
    depth: float
    """Of a bridge, away from the axis [m]."""
    radius: float
    """Of the middle of a bridge [m]."""
    tilt: float
    """Of planets [rad]."""
    volume: float
    """Of plates and bridges together [m³]."""


WIDTHS = (0.25, 0.4, 0.55, 0.7, 0.85, 1.0)
"""Widths of bridges that are looked at, over what planets leave there [-]."""
_REACHES, _STARTS, _HALVINGS = 5, 9, 24
LEAST_DEPTH = 0.25
"""Of bridges over their width, at least [-]: shallower ones are shells and no beams."""
THICKEST_PLATE = 1.0
"""Plate over the distance between both, at most [-]: beyond, no plate keeps planets straight."""


def plate_band(reach: Values, fill: float) -> Values:
    """Return the width of a plate as a ring whose outside is the plate's and which has as much metal [m].

    Args:
        reach: Radius of the plate [m].
        fill: Share of it that is not cut out [-].

    Source: geometry, π (R² − R_i²) = fill π R².

    >>> round(plate_band(1.0, 0.75), 3)
    0.5
    """
    return reach * (1.0 - math.sqrt(1.0 - fill))


def stiff_frame(window: Window, asked: Asked, moduli: Elastic) -> Stiff:
    """Return the lightest plates and bridges that are strong and keep planets straight; the stiffest if none do.

    Bridges stand on the chord between neighbouring pins, or farther out, where planets leave more; planets go in
    between them along the radius. Plates are as thick as the tilt asks, and as large as bridges or their eyes.

    Args:
        window: Room for them.
        asked: What they bear.
        moduli: Of their material.

    Source: `plate_lag`; bridges as `bridge_thickness`.
    """
    room = _candidates(window, asked)
    force = asked.force * window.pins / (2.0 * room.radius)
    deep = room.depth >= np.maximum(LEAST_DEPTH * room.width, 1e-3 * window.tip)
    strong = deep & (room.width**2 * room.depth * asked.bending >= 3.0 * force * window.length)
    if not strong.any():
        return Stiff(asked.plates, asked.reach, 0.0, 0.0, 0.0, math.inf, 0.0)
    room = _Room(*(column[strong] for column in room))
    least, most = max(asked.plates), THICKEST_PLATE * window.length
    low, high = np.full(room.width.shape, asked.plates[1]), np.full(room.width.shape, max(most, least))
    straight = _tilt(window, asked, moduli, room, low) <= asked.tilt
    high = np.where(straight, low, high)
    for _ in range(_HALVINGS):
        middle = (low + high) / 2.0
        fits = _tilt(window, asked, moduli, room, middle) <= asked.tilt
        low, high = np.where(fits, low, middle), np.where(fits, middle, high)
    tilts, first = _tilt(window, asked, moduli, room, high), np.maximum(high, asked.plates[0])
    volume = window.planets * room.width * room.depth * window.length
    volume = volume + math.pi * asked.fill * room.reach**2 * (first + high)
    kept = tilts <= asked.tilt * (1.0 + 1e-9)
    best = int(np.argmin(np.where(kept, volume, np.inf))) if kept.any() else int(np.argmin(tilts))
    sizes = (float(column[best]) for column in (room.reach, room.width, room.depth, room.radius, tilts, volume))
    return Stiff((float(first[best]), float(high[best])), *sizes)


class _Room(NamedTuple):
    """Bridges with the plates that hold them, one a row."""

    reach: Floats
    width: Floats
    depth: Floats
    radius: Floats


def _candidates(window: Window, asked: Asked) -> _Room:
    """Return bridges on the chord between pins and farther out, with plates as large as they ask."""
    half, middle = (turn(math.pi / window.planets) * window.pins for turn in (math.sin, math.cos))
    reaches = np.linspace(min(asked.reach, window.outer), window.outer, _REACHES)
    deep = BRIDGE * window.tip
    starts = np.linspace(middle, max(window.outer, middle), _STARTS)[:-1]
    reach, start, part = (grid.ravel() for grid in np.meshgrid(reaches, starts, np.array(WIDTHS), indexing="ij"))
    gap = half - np.sqrt(np.maximum(window.tip**2 - (start - middle) ** 2, 0.0))
    path = (start * math.sin(math.pi / window.planets) - window.tip) / math.cos(math.pi / window.planets)
    gap = np.where(start > middle, np.minimum(gap, np.maximum(path, half - window.tip)), gap)
    width = np.maximum(2.0 * part * gap, 0.0)
    inner = np.where(start > middle, start, max(middle - deep, window.inner))
    outer = np.sqrt(np.maximum(reach**2 - width**2 / 4.0, 0.0))
    outer = np.where(start > middle, outer, np.minimum(outer, middle + deep))
    return _Room(reach, width, outer - inner, (outer + inner) / 2.0)


def _tilt(window: Window, asked: Asked, moduli: Elastic, room: _Room, plate: Floats) -> Floats:
    frame = Frame(
        window.planets, window.pins, window.length, room.width, room.depth, room.radius, plate,
        plate_band(room.reach, asked.fill),
    )  # fmt: skip
    return np.asarray(lag_tilt(plate_lag(asked.force, frame, moduli), window.length, plate))
