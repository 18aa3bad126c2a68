"""Loads, load cases, speeds and oil of a document as machines, cases and rules of a design."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np

from gearwright.errors import Problem
from gearwright.exchange.rexs.arrangement import Bodies, Gearing, holds
from gearwright.exchange.rexs.files import Asking, Component
from gearwright.spec import GROUND

# ----------------------------------------------------------------------------------------------------------------------
# Speeds of a read train: what a file states of some shafts, led on through its teeth to all others.
# ----------------------------------------------------------------------------------------------------------------------


Relation = tuple[tuple[str, float], ...]
"""Speeds that add up to zero: shaft and factor [-]."""


def led_on(gearing: Gearing, known: Mapping[str, float], held: Iterable[str] = ()) -> dict[str, float]:
    """Return the speeds of all shafts that follow from those of some [rad/s].

    Args:
        gearing: Pairs, sets and clutches.
        known: Shaft -> its speed [rad/s].
        held: Clutches that hold.

    Source: z_1 ω_1 ∓ z_2 ω_2 = 0; z_s ω_s + z_r ω_r = (z_s + z_r) ω_c (Willis).
    """
    speeds = {GROUND: 0.0, **known}
    relations = _relations(gearing, held)
    grown = True
    while grown:
        grown = False
        for relation in relations:
            unknown = {shaft for shaft, _ in relation if shaft not in speeds}
            if len(unknown) == 1:
                (shaft,) = unknown
                rest = sum(factor * speeds[name] for name, factor in relation if name != shaft)
                own = sum(factor for name, factor in relation if name == shaft)
                if own:  # else its gears mesh with each other, of which the design will be refused
                    speeds[shaft] = -rest / own
                    grown = True
    return speeds


def free_speeds(gearing: Gearing, held: Iterable[str] = ()) -> int:
    """Return how many speeds of a train are free, and so how many torques of its machines follow from all others [-].

    Args:
        gearing: Pairs, sets and clutches.
        held: Clutches that hold.
    """
    places = {shaft: place for place, shaft in enumerate(gearing.shafts)}
    relations = _relations(gearing, held)
    matrix = np.zeros((len(relations), len(places)))
    for row, relation in zip(matrix, relations, strict=True):
        for shaft, factor in relation:
            if shaft in places:
                row[places[shaft]] += factor
    return len(places) - (int(np.linalg.matrix_rank(matrix)) if relations else 0)


def _relations(gearing: Gearing, held: Iterable[str]) -> list[Relation]:
    owners = {gear: gearing.shaft(gear) for gear in gearing.owners.values()}
    joints = [gearing.clutches[name] for name in held]
    return [
        *_of_pairs(gearing.pairs, owners), *_of_sets(gearing.planetaries), *_of_compounds(gearing.compounds),
        *(((joint["driving"], 1.0), (joint["driven"], -1.0)) for joint in joints),
    ]  # fmt: skip


def _of_pairs(pairs: Mapping[str, Mapping[str, Any]], owners: Mapping[str, str]) -> Iterator[Relation]:
    for pair in pairs.values():
        sign = -1.0 if pair.get("internal") else 1.0
        pinion, wheel = (owners.get(pair[role], pair[role]) for role in ("pinion", "wheel"))
        yield (pinion, float(pair["pinion_teeth"])), (wheel, sign * pair["wheel_teeth"])


def _of_sets(sets: Mapping[str, Mapping[str, Any]]) -> Iterator[Relation]:
    for members in sets.values():
        sun, ring = float(members["sun_teeth"]), float(members["ring_teeth"])
        yield (members["sun"], sun), (members["ring"], ring), (members["carrier"], -sun - ring)


def _of_compounds(compounds: Mapping[str, Mapping[str, Any]]) -> Iterator[Relation]:
    """Yield, of every compound set, how each sun and ring turns against the first one, seen from the carrier."""
    for table in compounds.values():
        centrals = {**table.get("suns", {}), **table.get("rings", {})}
        turns = _turns(table)
        first, *others = [name for name in centrals if name in turns]
        for other in others:
            ratio = turns[other] / turns[first]
            yield (centrals[other]["shaft"], 1.0), (centrals[first]["shaft"], -ratio), (table["carrier"], ratio - 1.0)


def _turns(table: Mapping[str, Any]) -> dict[str, float]:
    """Return gear -> its speed against the carrier, of all that the first planet turns, whose is 1 [-]."""
    planets, rings = table["planets"], table.get("rings", {})
    teeth = {
        name: gear["teeth"] for group in ("suns", "rings", "planets") for name, gear in table.get(group, {}).items()
    }
    turns, grown = {next(iter(planets)): 1.0}, True
    while grown:
        known = len(turns)
        for name, gear in planets.items():
            piece = gear.get("in_one_piece_with")
            links = [(mate, (1.0 if mate in rings else -1.0) * teeth[name] / teeth[mate]) for mate in gear["meshes"]]
            for other, ratio in [*links, *([(piece, 1.0)] if piece else [])]:
                if name in turns:
                    turns.setdefault(other, turns[name] * ratio)
                elif other in turns:
                    turns[name] = turns[other] / ratio
        grown = len(turns) > known
    return turns


# ----------------------------------------------------------------------------------------------------------------------
# Loads, load cases and oil of a document as machines, cases and rules of a design.
# ----------------------------------------------------------------------------------------------------------------------


Table = dict[str, Any]
_SLOW = 1e-6
"""Speed below which a shaft stands still [rad/s]."""


@dataclass(frozen=True)
class Said:
    """What one load case says."""

    share: float | None
    """Of the life [-]."""
    torques: Mapping[int, float]
    """Load -> torque [N m]."""
    speeds: Mapping[str, float]
    """Shaft -> speed, of all shafts [rad/s]."""

    def power(self, load: int, shaft: str) -> float:
        """Return what a load gives [W].

        Args:
            load: Its id.
            shaft: On which it is.
        """
        return self.torques[load] * self.speeds.get(shaft, 0.0)


def read_loads(asking: Asking, bodies: Bodies, gearing: Gearing) -> Table:
    """Return the tables of machines and cases.

    Args:
        asking: The document.
        bodies: What of it turns as one.
        gearing: Its gears.
    """
    loads = _loads(asking, bodies, gearing)
    shares = bool(gearing.planetaries or gearing.compounds)  # whose members divide torques among several that follow
    if asking.problems:
        return {}
    cases = [_said(asking, bodies, gearing, loads, place) for place in range(len(asking.document.cases) or 1)]
    if shares:
        _hold_still(asking, gearing, loads, cases)
    known = _known(asking, gearing, loads, cases)
    for load in [load for load in known if not any(said.torques[load] for said in cases)]:
        known.remove(load)
        component = asking.document.components[load]
        asking.notes.append(f"line {component.line}: {component.path} has a torque of 0 in every case; it is left out")
        del loads[load]
    names = {load: bodies.new_name(asking.document.components[load]) for load in loads}
    gearing.machines |= names
    others = [load for load in loads if load not in known]
    if not _is_enough(asking, loads, known, others, cases, shares=shares):
        return {}
    tables: Table = {"motors": {}, "loads": {}}
    said_once = "what drives is read as a motor, what is driven as a load: REXS does not say which machines they are"
    asking.notes.append(said_once)
    for load in known:
        _machine(tables, names[load], loads[load], [said.power(load, loads[load]) for said in cases],
                 [said.speeds[loads[load]] for said in cases])  # fmt: skip
    for load in others:
        powers = [-sum(said.power(one, loads[one]) for one in known) for said in cases]
        speeds = [said.speeds[loads[load]] for said in cases]
        if len(others) == 1 and max(powers, key=abs) > 0.0:
            _machine(tables, names[load], loads[load], powers, speeds)
            tables["motors"][names[load]]["balances"] = True
        else:
            tables["loads"][names[load]] = {"shaft": loads[load]}
    tables.pop("sense", None)
    _free_speeds(tables, gearing, cases[0])
    return tables | _cases(asking, gearing, cases, {names[load]: load for load in known}, loads, tables["motors"])


def _hold_still(asking: Asking, gearing: Gearing, loads: dict[int, str], cases: list[Said]) -> None:
    """Put shafts of sets that a load holds in every case on the ground."""
    for load, shaft in list(loads.items()):
        if len(loads) > 2 and all(abs(said.speeds.get(shaft, 1.0)) < _SLOW for said in cases):
            held = asking.document.components[load]
            asking.notes.append(f"line {held.line}: {held.path} holds a shaft that never turns; it is the ground")
            gearing.hold(loads.pop(load))


def _known(asking: Asking, gearing: Gearing, loads: Mapping[int, str], cases: list[Said]) -> list[int]:
    """Return the loads whose torques are given: not those that follow, as a file says or as many as must."""
    stated = [load for load in loads if all(load in said.torques for said in cases)]
    given = [load for load in stated
             if asking.text(asking.document.components[load], "defines_torque") != "false"] or stated  # fmt: skip
    free = free_speeds(gearing, [clutch for clutch, held in gearing.engaged.items() if held[0]])
    while given and len(given) > max(len(loads) - free, 1):
        most = min(given, key=lambda load: cases[0].power(load, loads[load]))
        asking.notes.append(f"the torque of {asking.document.components[most].path} follows from all others")
        given.remove(most)
    return given


def _loads(asking: Asking, bodies: Bodies, gearing: Gearing) -> dict[int, str]:
    """Return load -> its shaft, of all that transmit torque."""
    loads: dict[int, str] = {}
    for load in asking.document.of_kind("external_load"):
        said = asking.text(load, "transmits_torque")
        asking.text(load, "defines_torque")
        if said == "false":
            continue
        shafts = asking.document.related("assembly", "part", load.number, "assembly")
        asking.used.add(load.number)
        asking.number(load, "u_coordinate_on_shaft")
        if not shafts:
            asking.refuse(load, "acts on no shaft; give it an assembly relation with one")
            continue
        loads[load.number] = bodies.name(shafts[0])
        if loads[load.number] not in gearing.shafts:
            asking.refuse(
                load, f"acts on {loads[load.number]}, which has no gear and no carrier; put it on a shaft that has"
            )
    return loads


def _said(asking: Asking, bodies: Bodies, gearing: Gearing, loads: Mapping[int, str], place: int) -> Said:
    document = asking.document
    case = (document.cases or ({},))[place]
    speeds: dict[str, float] = {}
    for shaft in document.of_kind("shaft"):
        own = bodies.name_of(shaft.number)
        spoken = [said for said in (case.get(shaft.number), shaft) if said is not None]
        values = [value for said in spoken if (value := asking.number(said, "rotational_speed")) is not None]
        if values and own in gearing.shafts:
            speeds.setdefault(str(own), values[0])
    led = led_on(gearing, speeds, [clutch for clutch, held in gearing.engaged.items() if held[place]])
    torques = {}
    for load, name in loads.items():
        for said in (case.get(load), document.components[load]):
            torque = None if said is None else _torque(asking, said, led.get(name, 0.0))
            if torque is not None and load not in torques:
                torques[load] = torque
    unit = next((said for said in case.values() if said.kind == "gear_unit"), None)
    share = None if unit is None else asking.number(unit, "operating_time_fraction")
    return Said(share, torques, led)


def _torque(asking: Asking, said: Component, speed: float) -> float | None:
    """Return the torque of a load: as stated, or of its power at the speed of its shaft [N m]."""
    torque, power = asking.number(said, "torque_around_u_axis"), asking.number(said, "power")
    if torque is not None or power is None or abs(speed) < _SLOW:
        return torque
    return power / speed


def _is_enough(
    asking: Asking, loads: Mapping[int, str], known: list[int], others: list[int], cases: list[Said], *, shares: bool
) -> bool:
    """Tell whether torques and speeds are enough for a design, and refuse what is missing."""
    said = ""
    if not loads:
        said = "there is no external_load that transmits torque; give one on the driving and one on the driven shaft"
    elif not known:
        said = "no external_load has a torque_around_u_axis; give that of the driving machine"
    elif len(others) > 1 and not shares:
        said = f"{len(others)} loads have no torque_around_u_axis; it follows for one of them, give that of the others"
    elif not others and len(known) == 1:
        said = "one external_load alone transmits torque; give one on the driven shaft, too"
    elif any(loads[load] not in case.speeds for load in loads for case in cases):
        said = "the speeds of the loads do not follow from any rotational_speed; give that of the driving shaft"
    if said:
        asking.problems.append(Problem("components.external_load", said))
    return not said


def _machine(tables: Table, name: str, shaft: str, powers: list[float], speeds: list[float]) -> None:
    """Add what drives as a motor, and what is driven as a load."""
    most = max(range(len(powers)), key=lambda place: abs(powers[place]))
    if powers[most] > 0.0:
        machine: Table = {"shaft": shaft, "power_w": max(powers), "speed_rad_s": abs(speeds[most])}
        leads = next(iter(tables["motors"].values()), None)
        if leads is not None and speeds[most] * tables.get("sense", 1.0) < 0.0:
            machine["reverse"] = True
        tables.setdefault("sense", 1.0 if speeds[most] >= 0.0 else -1.0)
        tables["motors"][name] = machine
    else:
        tables["loads"][name] = {"shaft": shaft, "power_w": -powers[most]}


def _free_speeds(tables: Table, gearing: Gearing, said: Said) -> None:
    """Give driven machines their speeds where those do not follow from the speeds of what drives."""
    known = {machine["shaft"]: said.speeds[machine["shaft"]] for machine in tables["motors"].values()}
    for machine in tables["loads"].values():
        shaft = machine["shaft"]
        if shaft not in led_on(gearing, known) and not gearing.clutches:
            known[shaft] = said.speeds[shaft]
            machine["speed_rad_s"] = abs(said.speeds[shaft])


def _cases(
    asking: Asking,
    gearing: Gearing,
    cases: list[Said],
    names: Mapping[str, int],
    loads: Mapping[int, str],
    motors: Table,
) -> Table:
    """Return the table of cases where there are several; what may drive has its speed, also where it brakes."""
    if len(cases) < 2:
        return {}
    shares = [said.share for said in cases]
    if None in shares:
        asking.notes.append("load cases without a share of the time last equally long")
    whole = sum(share or 0.0 for share in shares) if None not in shares else 0.0
    if None not in shares and whole and abs(whole - 1.0) > 1e-9:
        asking.notes.append(
            f"the shares of the load cases add up to {100.0 * whole:g} %, which counts as all of the life"
        )
    tables: Table = {}
    for place, said in enumerate(cases, start=1):
        share = (said.share or 0.0) / whole if whole else 1.0 / len(cases)
        table: Table = {"share": share}
        if gearing.engaged:
            table["engaged"] = _held(asking, gearing, [loads[load] for load in names.values()], said, place)
        for name, load in names.items():
            speed, power = said.speeds[loads[load]], said.power(load, loads[load])
            table[name] = {"power_w": power} if abs(speed) > _SLOW else {"torque_nm": said.torques[load]}
            if name not in motors and max(table[name].values()) > 0.0:
                table[name]["drives"] = True
            if (power > 0.0 or name in motors) and abs(speed) > _SLOW:
                table[name]["speed_rad_s"] = abs(speed)
        if said.share == 0.0:
            table = {"static": True} | {key: value for key, value in table.items() if key != "share"}
            asking.notes.append(f"load case {place} has no share of the time; it is read as static")
        tables[f"case-{place}"] = table
    return {"cases": tables}


def _held(asking: Asking, gearing: Gearing, driven: list[str], said: Said, place: int) -> list[str]:
    """Return the clutches that hold in a case, and those that let a shaft which nothing turns turn along, unloaded."""
    held = [clutch for clutch, holds_in in gearing.engaged.items() if holds_in[place - 1]]
    known = {shaft: said.speeds[shaft] for shaft in driven}
    led, idle = led_on(gearing, known, held), list[str]()
    for name, clutch in gearing.clutches.items():
        if len(led.keys() & {clutch["driving"], clutch["driven"]}) == 1:
            idle.append(name)
            led = led_on(gearing, known, [*held, *idle])
    if not idle or not led.keys() >= set(gearing.shafts):
        return held
    asking.notes.append(f"load case {place} engages {', '.join(idle)}, too, so that no shaft is without a speed")
    return [*held, *idle]


def read_clutches(asking: Asking, bodies: Bodies, gearing: Gearing) -> None:
    """Add couplings that hold in some load cases, or in none.

    Args:
        asking: The document.
        bodies: What of it turns as one.
        gearing: To which they are added.
    """
    for coupling in asking.document.of_kind("switchable_coupling"):
        asking.used.add(coupling.number)
        held = holds(asking, coupling)
        parts = [part for role in ("inner_part", "outer_part")
                 for part in asking.document.related("side", "assembly", coupling.number, role)]  # fmt: skip
        if all(held) or len(parts) != 2:
            continue
        ends = [gearing.add_shaft(bodies.name(part)) for part in parts]
        driving, driven = sorted(ends, key=lambda end: end == GROUND)
        name = bodies.new_name(coupling)
        gearing.clutches[name] = {"driving": driving, "driven": driven, "kind": "open"}
        gearing.engaged[name] = held


def read_oil(asking: Asking) -> Table:
    """Return the table of the oil.

    Args:
        asking: The document.
    """
    table: Table = {}
    for lubricant in asking.document.of_kind("lubricant")[:1]:
        asking.used.add(lubricant.number)
        for name, key in (("viscosity_at_40_degree_celsius", "viscosity_40"),
                          ("viscosity_at_100_degree_celsius", "viscosity_100")):  # fmt: skip
            value = asking.number(lubricant, name)
            if value is not None:
                table[key] = value
    for casing in asking.document.of_kind("gear_casing"):
        asking.used.add(casing.number)
        spoken = [casing, *(case[casing.number] for case in asking.document.cases if casing.number in case)]
        warmth = [value for said in spoken if (value := asking.number(said, "temperature_lubricant")) is not None]
        if warmth:
            table["temperature"] = max(warmth)
    return table
