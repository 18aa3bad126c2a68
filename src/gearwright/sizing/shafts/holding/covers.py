"""Covers that screw onto the housing before outer rings, and the radial seals in them where shafts leave.

A cover is a plate that holds the outer ring. Where its shaft leaves the housing, a boss stands on the plate, whose bore
d_2 takes the seal: pressed in from outside against a step, so that it can be changed without taking the cover off, its
lip towards the oil. It lies beyond what turns beside the bearing, a retaining ring or a nut.
"""

from __future__ import annotations

import math
from collections.abc import Sequence

from gearwright.catalogue import HousingMaterial, RadialSeal, housing_materials
from gearwright.catalogue.standard_parts.centre_holes import PRELOAD, PROOF_STRESS
from gearwright.sizing.mounted import BearingSizing
from gearwright.sizing.result import Sizing
from gearwright.sizing.sealing import Exit
from gearwright.sizing.shafts.holding.holders import Holder, Ring, clamped_plate, made, span_from
from gearwright.sizing.shafts.stretches import SHOULDER

SCREWS = 6
"""Of a cover, an assumption [-]."""
SURPLUS = 1.5
"""Clamping of a cover's screws over the force that they hold, an assumption [-]."""
COVER_SCREWS = ((5e-3, 0.8e-3), (6e-3, 1.0e-3), (8e-3, 1.25e-3), (10e-3, 1.5e-3), (12e-3, 1.75e-3), (16e-3, 2e-3))
"""Thread and pitch of screws of covers, coarse threads of ISO 261 [m]."""
CIRCLE, RIM = 3.0, 5.5
"""Diameter of the circle of screws, and of the cover, beyond the bearing's over the screw's diameter [-]: a screw's
head of 1.5 d lies between, as does as much wall of the housing inside the thread."""
HEAD = 1.5
"""Diameter of a screw's head over its thread [-]: ISO 4762."""
STEP = 1.5e-3
"""Height of the step against which a seal is pressed, an assumption [m]."""
RELIEF = 2e-3
"""Depth of a cover with a seal over inner ring and cage, at least, an assumption [m]."""
CLEAR = 1e-3
"""Between a cover and what turns or slides beside it, an assumption [m]."""
SEAL = "radial seal"
"""Kind of holder that a seal is."""


def covers(
    sizing: Sizing, bearing: BearingSizing, way: int, force: float,
    *, leaves: Exit | None = None, turning: Sequence[Holder] = (), apart: float = 0.0,
) -> tuple[Holder, ...]:  # fmt: skip
    """Return the cover before an outer ring, and the seal in it where the shaft leaves there.

    Args:
        sizing: As sized.
        bearing: That it holds.
        way: Towards which end it lies.
        force: That the outer ring presses on it with [N].
        leaves: Of the shaft there, with its seal; None where none runs in the cover.
        turning: What goes round with the shaft beside the bearing, inside of the cover.
        apart: Between the outer ring and the cover, where the ring slides [m].
    """
    material = housing_materials()[sizing.design.housing.material]
    screw, clamps = next(((d, clamp) for d, clamp in _clamps() if clamp >= SURPLUS * force), _clamps()[-1])
    bore = bearing.outer_diameter - SHOULDER * (bearing.outer_diameter - bearing.inner_diameter)
    seal = None if leaves is None or leaves.elastomer is None else leaves.seal
    boss = 0.0 if seal is None else seal.bore + 2.0 * material.least_wall
    circle = max(bearing.outer_diameter + CIRCLE * screw, boss + HEAD * screw if seal else 0.0)
    allowed = math.sqrt(3.0) * material.shear_strength
    thick = max(material.least_wall, clamped_plate(force, (bore + bearing.outer_diameter) / 2.0, circle, allowed))
    face = bearing.position + way * (bearing.width / 2.0 + apart)
    designation, density = f"{SCREWS} screws M{1e3 * screw:g}, 8.8", material.density
    rim = circle + (RIM - CIRCLE) * screw
    if leaves is None or seal is None or leaves.elastomer is None:
        plain = made(bearing, "cover", designation, span_from(face, way, thick), (bore, rim), density, turns=False)
        return (plain._replace(force=force, capacity=clamps),)
    reached = max((way * (place - face) for part in turning for place in (part.start, part.end)), default=0.0)
    around = max((part.outer for part in turning), default=0.0)
    rings, at = _bossed(material, seal, (bore, rim, boss), (thick, reached, around))
    turned = tuple(sorted(Ring(*span_from(face + way * low, way, high - low), inner, outer)
                          for low, high, inner, outer in rings))  # fmt: skip
    whole = (turned[0].start, turned[-1].end)
    held = made(bearing, "cover", designation, whole, (min(one.bore for one in turned), rim), density, turns=False)
    held = held._replace(
        mass=sum(_volume(one) for one in turned) * density, force=force, capacity=clamps, stepped=turned
    )
    lip = made(bearing, SEAL, seal.designation(leaves.elastomer), span_from(face + way * at, way, seal.width),
               (seal.shaft, seal.bore), leaves.elastomer.density, turns=False)  # fmt: skip
    return held, lip._replace(lip=-way, mass=seal.mass(leaves.elastomer))


def _bossed(
    material: HousingMaterial, seal: RadialSeal, size: tuple[float, float, float], inside: tuple[float, float, float]
) -> tuple[list[tuple[float, float, float, float]], float]:
    """Return start, end, bore and outside of the parts of a cover with a seal, and where the seal begins [m].

    Args:
        material: Of the cover.
        seal: In it.
        size: Bore of the plain cover, outside of its plate and of its boss [m].
        inside: Thickness of its plate, how far beyond its face something turns, and the diameter of that [m].
    """
    (bore, rim, boss), (thick, reached, around) = size, inside
    hollow = max(reached + CLEAR, RELIEF)
    plate = max(thick, hollow + material.least_wall)
    step = min(bore, seal.bore - 2.0 * STEP)
    return [
        (0.0, hollow, max(bore, around + 2.0 * CLEAR), rim),
        (hollow, plate, step, rim),
        (plate, plate + seal.depth, seal.bore, boss),
    ], plate


def _volume(ring: Ring) -> float:
    return math.pi / 4.0 * (ring.outer**2 - ring.bore**2) * (ring.end - ring.start)


def _clamps() -> list[tuple[float, float]]:
    """Return diameters of screws [m] and what all of a cover's clamp with [N]: 0.7 S_p A_s each."""
    return [(d, SCREWS * PRELOAD * math.pi / 4.0 * (d - 0.9382 * pitch) ** 2 * _proof(d)) for d, pitch in COVER_SCREWS]


def _proof(thread: float) -> float:
    return next(stress for largest, stress in PROOF_STRESS if thread <= largest)
