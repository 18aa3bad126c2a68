"""What nobody assesses of a design, and why: a verdict reaches as far as what was looked at."""

from __future__ import annotations

from collections.abc import Iterable, Iterator

from gearwright.checks import Check, not_assessed
from gearwright.dynamics.assembly import untold_orders
from gearwright.identity import GEARBOX, Kind, PartId
from gearwright.sizing import MeshSizing, Sizing
from gearwright.sizing.bearings import planet_bodies
from gearwright.sizing.rating import Unloaded
from gearwright.sizing.shafts import unsealed_exits
from gearwright.sizing.summaries import tips_in_fillets
from gearwright.spec.design import RATINGS

_LIVES = "no mission is given; gearwright review DESIGN MISSION flies one"
_NO_BEARING = "the design names none: no life, no room in the rim, and no kilogram of it; gearwright close chooses one"


def open_checks(sizing: Sizing, looked_at: Iterable[Check], *, flown: bool) -> Iterator[Check]:
    """Yield what neither sizing nor motion nor a flight looks at.

    Args:
        sizing: As sized.
        looked_at: The checks of sizing, motion and flight.
        flown: True where a mission is flown.
    """
    if not flown:
        yield not_assessed(GEARBOX, "lives of gears and bearings, heat, charge", "mission", _LIVES)
    built = {shaft.name for shaft in sizing.built_shafts}
    for shaft in sizing.shafts:
        if shaft.name not in built:
            why = "the design gives it no [bearings]: no steps, bearings, joints, seals, slopes, bending modes"
            yield not_assessed(PartId(Kind.SHAFT, shaft.name), "bearings and joints", "ISO 281, ISO 76", why)
    for leaves in (one for one in unsealed_exits(sizing) if one.way or one.elastomer is None):
        yield not_assessed(PartId(Kind.MACHINE, leaves.machine), "shaft seal", "SKF, speeds of lips", leaves.lacking)
    for machine, why in untold_orders(sizing):
        yield not_assessed(PartId(Kind.MACHINE, machine), "electrical and slot orders", "", why)
    for stage in sizing.design.stages:
        yield from _teeth(sizing, stage)
    for one in tips_in_fillets(sizing):
        yield not_assessed(one.mesh.part, "tips in fillets", "ISO 21771", one.sentence)
    bearings = {str(check.part) for check in looked_at if check.part.kind is Kind.BEARING}
    for body in planet_bodies(sizing.design, sizing.gears):
        if str(body.part) not in bearings:
            yield not_assessed(body.part, "bearing of the planets", "ISO 281", _NO_BEARING)
        if len(body.steps) > 1 and not body.supports:
            why = "needs place_mm of every step, and two bearings or more; until then its whole force acts in one place"
            yield not_assessed(body.part, "moment that tilts a stepped planet", "statics", why)
    yield from _shared_axes(sizing, built)
    why = "weighed as a shell with what is on it; its strength and stiffness, and what heat does to clearances,"
    yield not_assessed(GEARBOX, "housing", "", f"{why} are not assessed")


def _shared_axes(sizing: Sizing, built: set[str]) -> Iterator[Check]:
    """Yield the shafts of one axis of which some have no bearings, nor what is between them a length."""
    on_axis: dict[tuple[float, float], list[str]] = {}
    for name, axis in sizing.arrangement.axes.items():
        on_axis.setdefault((round(axis.real, 9), round(axis.imag, 9)), []).append(name)
    names = [name for shafts in on_axis.values() if len(shafts) > 1 and not built >= set(shafts) for name in shafts]
    if names:
        why = f"without [bearings], machines, clutches and bearings among these have no length: {', '.join(names)}"
        yield not_assessed(GEARBOX, "room of shafts on one axis", "", why)


def _teeth(sizing: Sizing, stage: str) -> Iterator[Check]:
    """Yield what is left open of the teeth of a stage."""
    part, pair = PartId(Kind.STAGE, stage), sizing.design.pairs.get(stage)
    meshes = [mesh for mesh in sizing.meshes if mesh.stage == stage]
    scuffed = {check.part for check in sizing.checks if check.mode == "scuffing"}
    open_meshes = [mesh for mesh in meshes if mesh.part not in scuffed]
    if pair is not None and pair.kind == "face":
        yield not_assessed(part, "rating of face gears", "", "no standard rates them; Lewis and Hertz stand in")
    elif not (method := RATINGS[sizing.design.rules(stage).rating]).fatigue:
        why = f'{method.title}: static strength only; rating = "iso6336" knows life, scuffing, what can be cut'
        yield not_assessed(part, "tooth fatigue and scuffing", "ISO 6336", why)
    elif method.table != "iso6336":
        why = f'{method.title} does not rate it; rating = "iso6336" does'
        yield not_assessed(part, "scuffing", "ISO/TS 6336-21", why)
    else:
        for mesh in open_meshes:
            idle = isinstance(mesh.rating, Unloaded)
            why = "no load case loads these teeth" if idle else "tips interfere, so that nothing rolls"
            yield not_assessed(mesh.part, "scuffing", "ISO/TS 6336-21", why)
        if sizing.design.rules(stage).iso6336.micropitting_stage is not None:
            yield from _without_film(meshes)


def _without_film(meshes: Iterable[MeshSizing]) -> Iterator[Check]:
    """Yield the loaded meshes whose oil was tested for micropitting, and that are not rated against it."""
    for mesh in meshes:
        rated = mesh.rating
        if isinstance(rated, Unloaded) or getattr(rated, "micropitting", None) is not None:
            continue
        if not hasattr(rated, "micropitting"):
            why = "the document is of cylindrical gears"
        elif getattr(rated, "flash", None) is None:
            why = "tips interfere, so that nothing rolls"
        else:
            why = "the document has no W_W of cast irons"
        yield not_assessed(mesh.part, "micropitting", "ISO/TS 6336-22", why)
