"""REXS files as designs: shafts, gears, stages, bearings and loads.

Nothing is written or sized here; only a file of gearwright's own is held against the sizing of its design.
"""

import math
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any, Literal, cast

import numpy as np

from gearwright.base import ALIKE, DesignError, Problem, Ratio, Role, Shown, largest, refuse, smallest, verb
from gearwright.exchange.rexs.arrangement import (
    Bodies,
    Gearing,
    Mounting,
    bodies_of,
    gears_of,
    holds,
    lone_shafts,
    read_layout,
    read_materials,
    read_mounting,
    read_service,
    with_gears,
    with_places,
)
from gearwright.exchange.rexs.files import DESIGN, GEAR, MESH, Asking, Component, Document, opened, unsound
from gearwright.exchange.rexs.stages import read_stages, refuse_nothing
from gearwright.machines import largest_power
from gearwright.sizing import GearSizing, MeshSizing, Sizing, size
from gearwright.sizing.rating.iso6336 import Iso6336Rating
from gearwright.sizing.rating.iso10300 import Iso10300Rating
from gearwright.spec import GROUND, Design, build, design_text, edited, parse
from gearwright.spec.design import FATIGUE

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
    asking.notes.append(
        "what drives is read as a motor, or as a turbine where no electric rotor bears its speed, what is driven as a"
        " load: REXS does not say which machines they are"
    )
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
    cased = _cases(asking, gearing, cases, {names[load]: load for load in known}, loads, tables["motors"])
    turbines = _turbines(tables["motors"], cased.get("cases", {}).values())
    return tables | turbines | cased


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
        most = smallest(given, lambda load: cases[0].power(load, loads[load]))
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
    return torque if torque is not None or power is None or abs(speed) < _SLOW else power / speed


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
    most = largest(range(len(powers)), lambda place: abs(powers[place]))
    if powers[most] > 0.0:
        machine: Table = {"shaft": shaft, "power_w": max(powers), "speed_rad_s": abs(speeds[most])}
        leads = next(iter(tables["motors"].values()), None)
        if leads is not None and speeds[most] * tables.get("sense", 1.0) < 0.0:
            machine["reverse"] = True
        tables.setdefault("sense", 1.0 if speeds[most] >= 0.0 else -1.0)
        tables["motors"][name] = machine
    else:
        tables["loads"][name] = {"shaft": shaft, "power_w": -powers[most]}


def _turbines(motors: Table, cases: Iterable[Table]) -> Table:
    """Return the table of turbines, with what drives faster than electric rotors bear; that leaves the motors."""
    named = [
        name
        for name, machine in motors.items()
        if machine.keys() <= {"shaft", "power_w", "speed_rad_s"}
        and machine["speed_rad_s"] > 0.0
        and machine["power_w"] > largest_power(machine["speed_rad_s"])
        and all(case.get(name, {}).get("power_w", 0.0) >= 0.0 for case in cases)
    ]
    return {"turbines": {name: motors.pop(name) for name in named}} if named else {}


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


# ----------------------------------------------------------------------------------------------------------------------
# Files that gearwright wrote itself: their own design, with what another tool has changed since.
# ----------------------------------------------------------------------------------------------------------------------


SAME = 1e-9
"""Relative difference below which a number of the file is the one that was written [-]."""
Change = tuple[str, float]
"""Path in the design, and what stands there now."""


def own_design(asking: Asking, source: str) -> Design | None:
    """Return the design that travels in a file of gearwright's own, with what was changed since; None of other files.

    Args:
        asking: The document.
        source: Name of the file, for messages.

    Raises:
        DesignError: If the design in it is broken, or its gears are others than the file's.
    """
    units = [unit for unit in asking.document.of_kind("gear_unit") if DESIGN in unit.attributes]
    if not units:
        return None
    try:
        design = parse(units[0].attributes[DESIGN].text, source=source)
        sizing = size(design)
    except DesignError as error:
        said = f"does not give a design: {error.problems[0]}; remove the attribute to read what REXS itself says"
        line = units[0].attributes[DESIGN].line
        raise DesignError([Problem(f"{units[0].path}.{DESIGN}", said, line)], source) from None
    changes = dict(_changes(asking, sizing))
    refuse(asking.problems, source)
    _count_as_read(asking)
    asking.notes.append(f"the design is that of {DESIGN}; loads, shafts, bearings and materials are as it has them")
    asking.notes += [f"{path} is {value:.6g}, as the file has it now" for path, value in changes.items()]
    return edited(design, changes) if changes else design


def own_labels(asking: Asking) -> dict[int, str]:
    """Return gear -> what its design calls it, in a file of gearwright's own.

    Args:
        asking: The document.
    """
    components = asking.document.components
    return {number: label for number, component in components.items() if (label := asking.text(component, GEAR))}


def _count_as_read(asking: Asking) -> None:
    """Count as read what gearwright wrote from its own design."""
    for component in asking.document.components.values():
        asking.used.add(component.number)
        asking.asked.update(map(id, component.attributes.values()))
    for case in asking.document.cases:
        for said in case.values():
            asking.asked.update(map(id, said.attributes.values()))


def _changes(asking: Asking, sizing: Sizing) -> Iterator[Change]:
    """Yield what differs between the file and its own design as sized."""
    gears = {gear.name: gear for gear in sizing.gears}
    written = {name: [component for component in asking.document.components.values()
                      if asking.text(component, GEAR) == name] for name in gears}  # fmt: skip
    for name, gear in gears.items():
        for component in written[name]:
            yield from _of_gear(asking, sizing.design, gear, component)
    distances = {mesh.name: mesh for mesh in sizing.meshes}
    for stage in asking.document.of_kind("cylindrical_stage"):
        mesh, distance = distances.get(asking.text(stage, MESH)), asking.number(stage, "center_distance")
        if mesh is not None and distance is not None and not _same(distance, mesh.centre_distance):
            if mesh.stage in sizing.design.epicyclics:
                asking.refuse(stage, "has another center_distance than it was written with; change that in the design")
            else:
                yield f"{sizing.design.table(mesh.stage)}.centre_distance_m", distance


def _of_gear(asking: Asking, design: Design, gear: GearSizing, component: Component) -> Iterator[Change]:
    bevel = component.kind == "bevel_gear"
    table = design.table(gear.stage)
    own = f"{table}.{_table_of(gear)}.{gear.own}." if gear.stage in design.epicyclics else f"{table}."
    role = "" if gear.stage in design.epicyclics else f"{gear.role}_"
    module = asking.number(component, "mean_normal_module" if bevel else "normal_module")
    width, teeth = asking.number(component, "face_width"), asking.number(component, "number_of_teeth")
    if teeth is not None and round(abs(teeth)) != abs(gear.teeth):
        yield f"{own}{role}teeth", round(abs(teeth))
    if module is not None and not _same(module, gear.module):
        if bevel:
            asking.refuse(
                component,
                "has another mean_normal_module than it was written with; change outer_module_mm in the design",
            )
        else:
            yield f"{own}module_m", module
    if width is not None and not _same(width, gear.face_width):
        yield f"{own}face_width_m", width
    for flank in (flank for role_ in ("left", "right")
                  for flank in asking.document.related("flank", "gear", component.number, role_)):  # fmt: skip
        shift = asking.number(asking.document.components[flank], "addendum_modification_coefficient")
        if shift is not None and not _same(shift, gear.profile_shift):
            yield f"{own}{role}shift", shift


def _table_of(gear: GearSizing) -> str:
    return {Role.SUN: "suns", Role.RING: "rings"}.get(gear.role, "planets")


def _same(one: float, other: float) -> bool:
    return math.isclose(one, other, rel_tol=SAME, abs_tol=SAME * 1e-3)


# ----------------------------------------------------------------------------------------------------------------------
# Safeties of gears that a document states, to be held beside those of a sizing.
# ----------------------------------------------------------------------------------------------------------------------


Symbol = Literal["S_H", "S_F"]
SAFETIES: Mapping[str, tuple[Symbol, str]] = {
    "safety_factor_pitting_iso_6336_2019": ("S_H", "ISO 6336:2019"),
    "safety_factor_tooth_root_iso_6336_2019": ("S_F", "ISO 6336:2019"),
    "safety_factor_pitting_iso_6336_2006": ("S_H", "ISO 6336:2006"),
    "safety_factor_tooth_root_iso_6336_2006": ("S_F", "ISO 6336:2006"),
    "safety_factor_root_din_3990_1987": ("S_F", "DIN 3990:1987"),
    "safety_factor_pitting_iso_10300_2023": ("S_H", "ISO 10300:2023"),
    "safety_factor_tooth_root_iso_10300_2023": ("S_F", "ISO 10300:2023"),
    "safety_factor_pitting_iso_10300_2014": ("S_H", "ISO 10300:2014"),
    "safety_factor_tooth_root_iso_10300_2014": ("S_F", "ISO 10300:2014"),
}
"""Attribute -> what it is, and by which standard."""


@dataclass(frozen=True)
class Stated:
    """A safety of a gear in a mesh, as a file states it."""

    gear: str
    """As the design calls it, such as ``first.pinion``."""
    mate: str
    """The gear that it meshes with."""
    symbol: Symbol
    """Against pitting or against fracture of the root."""
    standard: str
    """By which it is."""
    value: Ratio
    """[-]"""
    line: int
    """Of the file [-]."""

    def ours(self, sizing: Sizing) -> float | None:
        """Return what a sizing of the design makes of it [-]; None where it rates by no ISO standard.

        Args:
            sizing: Of the design that was read.
        """
        for mesh in sizing.meshes:
            if {self.gear, self.mate} == set(mesh.gears):
                return _safety(mesh, mesh.gears.index(self.gear), self.symbol)
        return None


def _safety(mesh: MeshSizing, side: int, symbol: Symbol) -> float | None:
    rating = mesh.rating
    if not isinstance(rating, Iso6336Rating | Iso10300Rating):
        return None
    return float((rating.pitting if symbol == "S_H" else rating.bending)[side])


def read_stated(asking: Asking, labels: Mapping[int, str]) -> tuple[Stated, ...]:
    """Return every safety that a document states, once for equal planets and paths.

    Args:
        asking: The document.
        labels: Gear -> what the design calls it.
    """
    found: list[Stated] = []
    for stated in _all(asking, labels):
        if not any(_alike(stated, other) for other in found):
            found.append(stated)
    return tuple(found)


def _alike(first: Stated, second: Stated) -> bool:
    """Return whether two safeties are one and the same but for rounding."""
    same = replace(first, value=second.value, line=second.line) == second
    return same and math.isclose(first.value, second.value, rel_tol=ALIKE)


def _all(asking: Asking, labels: Mapping[int, str]) -> Iterator[Stated]:
    document = asking.document
    for relation in document.relations:
        roles = relation.roles
        data = document.components.get(roles.get("stage_gear_data", -1))
        if relation.kind != "stage_gear_data" or data is None or roles.get("gear") not in labels:
            continue
        asking.used.add(data.number)
        mate = _mate(document, roles.get("stage", -1), roles["gear"])
        for name, (symbol, standard) in SAFETIES.items():
            attribute = asking.attribute(data, name)
            value = None if attribute is None else asking.number(data, name)
            if attribute is not None and value is not None and mate in labels:
                yield Stated(labels[roles["gear"]], labels[mate], symbol, standard, value, attribute.line)


def _mate(document: Document, stage: int, gear: int) -> int:
    ends = (document.related("stage", "stage", stage, role) for role in ("gear_1", "gear_2"))
    return next((end for both in ends for end in both if end != gear), -1)


# ----------------------------------------------------------------------------------------------------------------------
# The verb: a REXS file as a design.
# ----------------------------------------------------------------------------------------------------------------------


@dataclass(frozen=True, repr=False)
class ImportedRexs(Shown):
    """A design that was read from a REXS file, and what became of the rest of the file."""

    design: Design
    version: str
    """Of REXS."""
    application: str
    """What wrote the file."""
    assumed: tuple[str, ...]
    """What the file does not say, and what was taken instead."""
    not_read: tuple[str, ...]
    """Every kind of component and attribute that was not read: the line and path of the first, and how many more."""
    stated: tuple[Stated, ...] = ()
    """Safeties of gears that the file states; `Stated.ours` finds those of a sizing."""


@verb
def from_rexs(path: str | Path) -> ImportedRexs:
    """Return the design that a REXS file describes: parallel and bevel pairs, planetary sets, loads and load cases.

    A file that `to_rexs` wrote gives its own design again, with the teeth, modules, widths, shifts and centre distances
    that another tool has changed since.

    Args:
        path: Of a file of REXS 1.0 to 1.7: XML (.rexs), JSON (.rexsj), or one of them in an archive (.rexsz).

    Raises:
        DesignError: With every problem of the file: its line, path, what was given, what is allowed and the fix.

    Source: REXS 1.0 to 1.7, FVA GmbH, rexs.info.
    """
    source = str(path)
    document = with_gears(opened(path))
    refuse(unsound(document), source)
    asking = Asking(document)
    own = own_design(asking, source)
    design, labels = _design(asking, source) if own is None else (own, own_labels(asking))
    stated = read_stated(asking, labels)
    _refuse(asking, source)
    notes = tuple(dict.fromkeys(asking.notes))
    return ImportedRexs(design, document.version, document.application, notes, asking.unread(), stated)


def _design(asking: Asking, source: str) -> tuple[Design, Mapping[int, str]]:
    """Return a design of what REXS itself says, and what it calls the gears."""
    document = asking.document
    bodies, gears = bodies_of(asking), gears_of(asking)
    gearing = read_stages(asking, bodies, gears)
    refuse_nothing(asking, gearing)
    _refuse(asking, source)
    read_clutches(asking, bodies, gearing)
    loads = read_loads(asking, bodies, gearing)
    _refuse(asking, source)
    units = document.of_kind("gear_unit")
    asking.used |= {unit.number for unit in units}
    name = next((asking.text(unit, "model_name") or unit.name for unit in units), "") or "gearbox"
    rules = read_materials(asking, gearing, gears)
    layout = read_layout(asking, bodies, gearing, gears)
    mounting = read_mounting(asking, bodies, gearing, lone_shafts(asking, bodies, gearing, layout))
    table: dict[str, Any] = {
        "schema": 1, "name": name, "description": f"Read from {Path(source).name}: REXS {document.version}"
        f" of {document.application or 'an unnamed tool'}",
        "shafts": gearing.shafts, "pairs": gearing.pairs, "planetaries": gearing.planetaries,
        "epicyclics": gearing.compounds,
        "clutches": gearing.clutches,
        "gears": rules, "layout": layout,
        "oil": read_oil(asking), "service": read_service(asking) if rules["rating"] == FATIGUE else {},
    }  # fmt: skip
    _refuse(asking, source)
    whole = {key: value for key, value in (table | loads).items() if value}
    return _mounted(asking, whole, mounting, source), gearing.labels


def _mounted(asking: Asking, table: Mapping[str, Any], mounting: Mounting, source: str) -> Design:
    """Return a design with what sits where on its shafts, shaft by shaft as far as it can then be sized."""
    best, table = _made(table, source), dict(table)
    wishes = [("places on the shafts", with_places(table, mounting), frozenset[int]())]
    wishes += [(f"bearings of {name}", {"bearings": seats}, read) for name, seats, read in mounting.shafts]
    for what, wish, read in wishes:
        wanted = table | wish | {"bearings": {**table.get("bearings", {}), **wish.get("bearings", {})}}
        try:
            design = _made({key: value for key, value in wanted.items() if value}, source)
            size(design)
        except DesignError as error:
            asking.notes.append(f"{what} are not taken, for {error.problems[0]}")
            continue
        best, table = design, wanted
        asking.used |= read
    return best


def _refuse(asking: Asking, source: str) -> None:
    """Raise for every problem so far, in the order of the file."""
    refuse(sorted(dict.fromkeys(asking.problems), key=lambda problem: (problem.line or 0, problem.path)), source)


def _made(table: Mapping[str, Any], source: str) -> Design:
    record, written = build(Design, table)
    if record is None or written.problems:
        raise DesignError([_of_design(problem) for problem in written.problems], source)
    try:
        return parse(design_text(cast(Design, record)), source=source)
    except DesignError as error:
        raise DesignError([_of_design(problem) for problem in error.problems], source) from None


def _of_design(problem: Problem) -> Problem:
    """Return a problem of the design that was read; lines of its text are no lines of the file."""
    return Problem(problem.path, f"{problem.message} (in the design that was read)")
