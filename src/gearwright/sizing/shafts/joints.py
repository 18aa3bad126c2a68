"""What joins a gear or a machine to its shaft: a key, a spline, a press fit, long enough for the torque."""

from __future__ import annotations

import math
from dataclasses import replace
from typing import NamedTuple

from gearwright.base import DesignError, Problem, apart, text
from gearwright.catalogue import LENGTHS, StandardKey, key_for_shaft
from gearwright.parts import Material
from gearwright.parts.joints import (
    LONGEST_BEARING,
    MODULES,
    SHORTEST_RATIO,
    FitPart,
    Spline,
    centrifugal_loss,
    fit_interference,
    fit_pressure,
    fit_torque,
    hub_stress,
    key_length,
    key_pressure,
    shaft_fit_stress,
    spline,
    spline_length,
    spline_pressure,
)
from gearwright.sizing.shaft_results import JointSizing
from gearwright.spec.design import Joint

KEY_PRESSURE, SPLINE_PRESSURE = 150e6, 100e6
"""Flank pressure that is allowed where the design says nothing [Pa]."""
SPLINE_TEETH = 25.0
"""Reference diameter over module of a spline, about; DIN 5480 prefers 20 to 50 teeth [-]."""
FIT_ROUGHNESS = 4e-6
"""R_z of ground seats of press fits [m]."""


class Seat(NamedTuple):
    """Where a joint sits."""

    part: str
    """Gear or machine."""
    shaft: str
    position: float
    """[m]"""
    hub_length: float
    """Room for the joint [m]; infinite where the design sets no limit."""
    root: float
    """Root diameter of the gear [m]; infinite for a machine."""
    torque: float
    """Largest of all cases, application factor included [N m]."""
    bore: float
    """Of the shaft [m]."""
    tooth: float
    """Height of the gear's teeth [m]."""
    speed: float = 0.0
    """Highest of all cases [rad/s]."""
    hub: Material | None = None
    """Of the gear; None: a machine, whose hub counts as the shaft's."""


def size_joint(joint: Joint, seat: Seat, diameter: float, steel: Material) -> JointSizing:
    """Return a joint on a shaft.

    Args:
        joint: As the design gives it.
        seat: Where it sits.
        diameter: Of the shaft [m].
        steel: Of the shaft.

    Raises:
        DesignError: If it is longer than its hub, or does not fit on the shaft; with what would do.
    """
    law = {"integral": _integral, "key": _key, "spline": _spline, "press-fit": _press_fit}[joint.kind]
    sized = law(joint, seat, diameter, steel)
    if joint.kind == "integral" or not math.isfinite(seat.root):
        return sized
    return replace(sized, rim=((seat.root - diameter) / 2.0 - keyway_depth(joint, diameter)) / seat.tooth)


def keyway_depth(joint: Joint, diameter: float) -> float:
    """Return how deep a joint cuts into its hub: t_2 of a key, else nothing [m].

    Args:
        joint: As the design gives it.
        diameter: Of the shaft [m].
    """
    return key_for_shaft(diameter).section.hub_depth if joint.kind == "key" else 0.0


def refuse_thick(sized: JointSizing, seat: Seat) -> None:
    """Raise where a shaft leaves nothing of its gear.

    Args:
        sized: From `size_joint`.
        seat: Where it sits.

    Raises:
        DesignError: With what would do.
    """
    if sized.rim is not None and sized.rim <= 0.0:
        message = (
            f"a {sized.kind} on {1e3 * sized.diameter:.4g} mm leaves no rim: the root circle of the gear has"
            f' {1e3 * seat.root:.4g} mm; write kind = "integral", or give more teeth or a larger module'
        )
        raise DesignError([Problem(f"joints.{seat.part}", message)])


def joint_fits(joint: Joint, seat: Seat, sized: JointSizing) -> bool:
    """Tell whether a thicker shaft would not help: the joint fits its hub and bears its torque.

    Args:
        joint: As the design gives it.
        seat: Where it sits.
        sized: From `size_joint`.
    """
    if joint.kind not in ("spline", "press-fit") or joint.length is not None:
        return True
    return sized.length <= seat.hub_length + 1e-9 and sized.pressure <= sized.allowed_pressure * (1.0 + 1e-9)


def refuse_long(joint: Joint, seat: Seat, sized: JointSizing) -> None:
    """Raise where a joint is longer than its hub, a key longer than what bears or too short for its round ends.

    Args:
        joint: As the design gives it.
        seat: Where it sits.
        sized: From `size_joint`.

    Raises:
        DesignError: With what would do.
    """
    if math.isinf(sized.pressure):
        shortest = 1e3 * key_for_shaft(sized.diameter).section.width
        message = (
            f"{1e3 * sized.length:g} mm leaves no flat flank between round ends; give more than {shortest:g} mm, or"
            ' write form = "B"'
        )
        raise DesignError([Problem(f"joints.{seat.part}.length", message)])
    room, why = seat.hub_length, "its hub has {}"
    if joint.kind == "key" and joint.length is None:
        key = key_for_shaft(sized.diameter)
        ends = key.section.width if joint.form == "A" else 0.0
        useful = min(key.longest, LONGEST_BEARING * sized.diameter + ends)
        if useful < room:
            room, why = useful, f"more than {{}} does not bear on {text(sized.diameter, 'length')}"
    if sized.length > room + 1e-9:
        asked, has = apart(sized.length, room, "length")
        message = (
            f"{sized.torque:.4g} N m ask for {asked} of {sized.designation}, but {why.format(has)};"
            f" {_instead(joint, seat, sized.diameter)}"
        )
        raise DesignError([Problem(f"joints.{seat.part}", message)])


def _sized(joint: Joint, seat: Seat, designation: str, diameter: float, *, length: float, pressure: float,
           allowed: float, interference: float = 0.0) -> JointSizing:  # fmt: skip
    return JointSizing(
        part=seat.part,
        shaft=seat.shaft,
        position=seat.position,
        kind=joint.kind,
        designation=designation,
        torque=seat.torque,
        diameter=diameter,
        length=length,
        pressure=pressure,
        allowed_pressure=allowed,
        interference=interference,
    )


def _integral(joint: Joint, seat: Seat, diameter: float, steel: Material) -> JointSizing:
    return _sized(joint, seat, "", diameter, length=0.0, pressure=0.0, allowed=0.0)


def _key(joint: Joint, seat: Seat, diameter: float, steel: Material) -> JointSizing:
    """Return the shortest standard key that bears the torque, or what it would have to be."""
    key, allowed = key_for_shaft(diameter), joint.pressure or KEY_PRESSURE
    ends = key.section.width if joint.form == "A" else 0.0
    asked = key_length(seat.torque, diameter, key.section, allowable=allowed) + ends
    shortest = max(asked, key.shortest)
    length = joint.length or next((size for size in LENGTHS if size >= shortest - 1e-9), _whole(shortest))
    flank = length - ends
    pressure = key_pressure(seat.torque, diameter, key.section, bearing_length=flank) if flank > 0.0 else math.inf
    name = _key_name(key, joint.form, length)
    sized = _sized(joint, seat, name, diameter, length=length, pressure=pressure, allowed=allowed)
    return replace(sized, form=joint.form)


def _key_name(key: StandardKey, form: str, length: float) -> str:
    width, height = 1e3 * key.section.width, 1e3 * key.section.height
    return f"DIN 6885 - {form} {width:g} x {height:g} x {1e3 * length:.5g}"


def _instead(joint: Joint, seat: Seat, diameter: float) -> str:
    """Say what would do where a joint is too long: a spline, one piece, a longer hub."""
    teeth = _teeth(joint, diameter)
    length = _spline_length(teeth, seat, SPLINE_PRESSURE)
    if joint.kind != "spline" and length <= seat.hub_length:
        return f'a spline does with {1e3 * length:.4g} mm, {_spline_name(teeth)}: write kind = "spline"'
    return 'write kind = "integral", or give a longer hub, a wider gear or a thicker shaft by diameter_mm'


def _spline(joint: Joint, seat: Seat, diameter: float, steel: Material) -> JointSizing:
    teeth, allowed = _teeth(joint, diameter), joint.pressure or SPLINE_PRESSURE
    length = joint.length or _spline_length(teeth, seat, allowed)
    pressure = spline_pressure(seat.torque, teeth, length) if length else 0.0
    name = _spline_name(teeth)
    sized = _sized(joint, seat, name, diameter, length=length, pressure=pressure, allowed=allowed)
    return replace(sized, module=teeth.module)


def _teeth(joint: Joint, diameter: float) -> Spline:
    """Return the spline on a shaft, of the module that is given or that leaves about 25 teeth."""
    wanted = diameter / SPLINE_TEETH
    module = joint.module if joint.kind == "spline" and joint.module else None
    return spline(diameter, module or max((size for size in MODULES if size <= wanted + 1e-9), default=MODULES[0]))


def _spline_length(teeth: Spline, seat: Seat, allowed: float) -> float:
    """Return the length that the torque asks for, and as much of 0.6 d_B, which keeps a hub from rocking, as fits."""
    steady = min(SHORTEST_RATIO * teeth.reference_diameter, seat.hub_length)
    return max(_whole(spline_length(seat.torque, teeth, allowable=allowed)), steady)


def _whole(length: float) -> float:
    """Return a length rounded up to millimetres."""
    return math.ceil(1e3 * length - 1e-6) / 1e3


def _spline_name(teeth: Spline) -> str:
    return f"DIN 5480 - W {1e3 * teeth.reference_diameter:g} x {1e3 * teeth.module:g} x {teeth.teeth}"


def spline_root(joint: Joint, diameter: float) -> float:
    """Return the root diameter that a spline leaves of its shaft [m].

    Args:
        joint: As the design gives it.
        diameter: Of the shaft [m].
    """
    return _teeth(joint, diameter).shaft_root


def hub_bore(joint: Joint, diameter: float) -> float:
    """Return what a hub slides over: its seat, of a spline the tip circle of the hub [m].

    Args:
        joint: As the design gives it.
        diameter: Of the seat [m].
    """
    return _teeth(joint, diameter).hub_tip if joint.kind == "spline" else diameter


def _press_fit(joint: Joint, seat: Seat, diameter: float, steel: Material) -> JointSizing:
    """Return a press fit as long as its hub that holds at speed; what the weaker of hub and shaft bears is allowed."""
    length = joint.length or (seat.hub_length if math.isfinite(seat.hub_length) else diameter)
    root = seat.root if math.isfinite(seat.root) else 2.0 * diameter
    around = seat.hub or steel
    shaft, hub = _fit_part(seat.bore / diameter, steel), _fit_part(min(diameter / root, 0.99), around)
    needed = joint.safety * seat.torque / fit_torque(1.0, diameter, length, friction=joint.friction)
    own = steel.yield_strength or 0.0
    allowed = min(own / shaft_fit_stress(1.0, shaft), (around.yield_strength or own) / hub_stress(1.0, hub))
    loosened = centrifugal_loss(seat.speed, diameter, shaft, hub)
    interference = joint.interference or fit_interference(needed, diameter, shaft, hub) + loosened
    name = f"DIN 7190 - {1e3 * diameter:.4g} with {1e6 * interference:.0f} µm"
    sized = _sized(joint, seat, name, diameter, length=length, allowed=allowed, interference=interference,
                   pressure=_fit_pressure(interference, diameter, shaft, hub))  # fmt: skip
    running = _fit_pressure(interference - loosened, diameter, shaft, hub)
    return replace(sized, running_pressure=running, needed_pressure=needed, speed=seat.speed)


def _fit_part(ratio: float, steel: Material) -> FitPart:
    return FitPart(ratio, steel.elastic_modulus, steel.poisson_ratio, FIT_ROUGHNESS, steel.density)


def _fit_pressure(interference: float, diameter: float, shaft: FitPart, hub: FitPart) -> float:
    """Return the pressure in a fit, none where its parts do not touch [Pa]."""
    try:
        return fit_pressure(interference, diameter, shaft, hub)
    except DesignError:
        return 0.0
