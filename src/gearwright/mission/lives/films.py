"""What warm oil does to flanks in flight: scuffing and micropitting where load, speed and temperature are worst."""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import replace

import numpy as np

from gearwright.arrays import Floats, Ints
from gearwright.checks import Check
from gearwright.mission.flight import Flight
from gearwright.mission.lives.damage import extremes
from gearwright.sizing.as_sized import made_of, rating_as_sized
from gearwright.sizing.rating import Load, LoadedMesh, method_for, row_ask
from gearwright.sizing.rating.rules import Rating
from gearwright.train import Mesh
from gearwright.units import CELSIUS

MODES = ("scuffing", "micropitting")
"""Judgements of a mesh that hang on the temperature of its oil."""
FILMED = ("iso6336", "iso6336-2006", "din3990", "iso10300")
"""Methods that judge films."""
_LEAST_TORQUE = 1e-6
"""Torque below which nothing is loaded [N m]."""


def film_checks_of(flight: Flight) -> Iterator[Check]:
    """Yield scuffing and micropitting of meshes with the oil as warm as the flight makes it, the worst of each.

    Args:
        flight: As flown, with a network of temperatures; others, and stages that no such method rates, yield nothing.

    Source: the judgements of sizing (ISO/TS 6336-20, -21, -22) at the intervals that no other surpasses in load,
        temperature and speed, or in load, temperature and slowness; K_A as in sizing.
    """
    warm = flight.history.oil_temperature
    if warm is None:
        return
    for mesh in flight.sizing.train.meshes:
        yield from _of_mesh(flight, mesh, warm - CELSIUS)


def _of_mesh(flight: Flight, mesh: Mesh, warm: Floats) -> Iterator[Check]:
    sizing = flight.sizing
    rating = rating_as_sized(sizing, mesh.stage).of_mesh(mesh)
    if rating.method not in FILMED:
        return
    torque = np.abs(flight.meshes[mesh.name].torque)
    speed = np.abs(flight.speed(mesh.nodes[0]) - flight.speed(mesh.nodes[2]))
    loaded = np.flatnonzero((torque > _LEAST_TORQUE) & (speed > 0.0))
    worst = dict[tuple[str, str], Check]()
    for k in np.union1d(_extreme(torque, warm, speed, loaded), _extreme(torque, warm, -speed, loaded)).tolist():
        at = (float(torque[k]), float(speed[k]), float(warm[k]))
        for check in _judged(flight, mesh, rating, at, flight.phase[k]):
            key = (check.mode, check.clause)
            if key not in worst or _ratio(check) < _ratio(worst[key]):
                worst[key] = check
    yield from worst.values()


def _judged(flight: Flight, mesh: Mesh, rating: Rating, at: tuple[float, float, float], phase: str) -> Iterator[Check]:
    """Yield the judgements at a torque [N m], a speed [rad/s] and a temperature of the oil [°C]."""
    torque, speed, warm = at
    sizing, rules = flight.sizing, rating.rules
    warmed = replace(
        rating,
        rules=rules.model_copy(update={"iso6336": rules.iso6336.model_copy(update={"oil_temperature": warm})}),
    )
    gears = [gear for name in mesh.gears for gear in sizing.gears if gear.name == name]
    ask = row_ask(sizing.train, sizing.teeth, mesh, extremes(flight), sizing.design)
    sized = next(row for row in sizing.meshes if row.name == mesh.name)
    ask = ask._replace(speed=speed, made=made_of(sized))
    load = Load(phase, torque * rating.load_factor, ask, rating.service.life)
    width = min(gear.face_width for gear in gears)
    loaded = LoadedMesh(warmed, gears[0].module, width, load, (load,), (0.0, 0.0))
    method = method_for(warmed)
    parts = (gears[0].part, gears[1].part)
    for check in method.checks(method.rate(loaded), mesh.part, parts):
        if check.mode in MODES:
            yield replace(check, case=phase, place=", ".join(filter(None, (check.place, f"oil of {warm:.0f} °C"))))


def _ratio(check: Check) -> float:
    return math.inf if check.ratio is None else check.ratio


def _extreme(torque: Floats, warm: Floats, speed: Floats, among: Ints) -> Ints:
    """Return the intervals that no other surpasses in all three."""
    points = np.column_stack([torque, warm, speed])[among]
    unique, first = np.unique(np.round(points, 9), axis=0, return_index=True)
    beaten = [bool(np.any(np.all(unique >= one, axis=1) & np.any(unique > one, axis=1))) for one in unique]
    return np.asarray(among[first[~np.array(beaten, bool)]])
