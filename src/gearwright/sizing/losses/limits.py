"""At which limit of its formula a loss is taken, in words: there it no longer answers to what it depends on."""

from __future__ import annotations

from collections.abc import Iterator
from math import degrees

from gearwright.parts.losses import (
    FASTEST,
    HIGHEST_FRICTION,
    LEAST_HELIX,
    LEAST_INTENSITY,
    LEAST_MODULE,
    LEAST_OIL_FACTOR,
    LEAST_PRODUCT,
    MOST_INTENSITY,
    SLOWEST,
    Friction,
    MeshDuty,
    MeshLaw,
    OilState,
    ToothContact,
    load_intensity,
    mesh_friction,
    seal_oil_factor,
)
from gearwright.sizing.losses.oil import Oil
from gearwright.sizing.result import GearSizing
from gearwright.units import CELSIUS, RPM

_PART_1 = "ISO/TR 14179-1"


def mesh_limits(contact: ToothContact, duty: MeshDuty, oil: OilState, law: MeshLaw, kind: str) -> str:
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


def _of_law(contact: ToothContact, duty: MeshDuty, oil: OilState, law: MeshLaw) -> Iterator[str]:
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
    """Return the limits at which the loss of a seal is taken.

    Args:
        oil: Before it.
    """
    if oil.seals != "simrit":
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
