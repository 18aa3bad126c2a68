"""The reader of design, mission, mix and study files: text to records, and every problem with its line."""

from __future__ import annotations

import math
import re
import tomllib
from collections.abc import Iterable, Iterator, Mapping
from itertools import pairwise
from pathlib import Path
from typing import Any, cast

import numpy as np

from gearwright.air import height
from gearwright.base import DesignError, Problem, excerpt, near, verb
from gearwright.catalogue import USUAL_HARDNESS, gear_steel
from gearwright.files import beside, numbers_of, text_of
from gearwright.parts.stiffness import sampled_curve
from gearwright.shipped import find_design, find_mission
from gearwright.spec.checks import STEEL_KEYS, bearing_problems, reference_problems
from gearwright.spec.design import Design, MeshCurve
from gearwright.spec.missions import (
    GROUND_KINDS,
    KEYS_OF,
    NEEDED,
    NO_MAP,
    BatteryRules,
    GearLifeRules,
    Mission,
    OilRules,
    Phase,
    WindingRules,
    window_problems,
)
from gearwright.spec.record import STAND_INS, Location, build

# ----------------------------------------------------------------------------------------------------------------------
# Line numbers of the keys of a TOML text, which TOML readers do not give.
# ----------------------------------------------------------------------------------------------------------------------


HEADER = re.compile(r"^\s*\[{1,2}([^\[\]]+)\]{1,2}\s*(?:#.*)?$")
KEY = re.compile(r"""^\s*((?:"[^"]*"|'[^']*'|[A-Za-z0-9_-]+)(?:\s*\.\s*(?:"[^"]*"|'[^']*'|[A-Za-z0-9_-]+))*)\s*=""")
_PART = re.compile(r"""\s*(?:"([^"]*)"|'([^']*)'|([^.\s"']+))\s*(?:\.|$)""")
_MULTILINE = ('"""', "'''")


def key_lines(text: str) -> dict[str, int]:
    """Return the line, counted from 1, of every table and key by its dotted path.

    Args:
        text: A TOML document. Keys of inline tables are not listed; their table is.
    """
    lines: dict[str, int] = {}
    table, closing = "", ""
    for number, line in enumerate(text.split("\n"), start=1):
        if closing:
            closing = "" if closing in line else closing
            continue
        header, key = HEADER.match(line), KEY.match(line)
        if header and not key:
            table = dotted(header[1])
            lines.setdefault(table, number)
        elif key:
            path = dotted(key[1])
            lines.setdefault(f"{table}.{path}" if table else path, number)
            closing = next((mark for mark in _MULTILINE if line.count(mark) == 1), "")
    return lines


def line_of(path: str, lines: Mapping[str, int]) -> int | None:
    """Return the line of a path, or of the nearest table above it.

    Args:
        path: Dotted path.
        lines: As `key_lines` gives them.
    """
    while path:
        if path in lines:
            return lines[path]
        path = path.rpartition(".")[0]
    return None


def line_in(path: str, lines: Mapping[str, int]) -> int | None:
    """Return the line of a path whose key has its unit behind it, or of the nearest table above it.

    Args:
        path: Dotted path without the unit of its key.
        lines: As `key_lines` gives them.

    >>> line_in("motors.electric.power", {"motors.electric": 3, "motors.electric.power_kw": 4})
    4
    """
    head = f"{path}_"
    exact = next((line for key, line in lines.items() if key == path or key.startswith(head)), None)
    return line_of(path, lines) if exact is None else exact


def dotted(key: str) -> str:
    """Return a key of TOML, whose parts may stand in quotes, as a dotted path.

    Args:
        key: As written.
    """
    return ".".join("".join(match) for match in _PART.findall(key))


# ----------------------------------------------------------------------------------------------------------------------
# What TOML's reader calls a wrong character, as people say it: commas in numbers, things given twice.
# ----------------------------------------------------------------------------------------------------------------------


_PLACE = re.compile(r"at line (\d+)")
_COMMA = re.compile(r"=\s*([-+]?\d+),(\d+)\s*(?:#.*)?$")


def slip(text: str, reason: str) -> Problem | None:
    """Return the slip behind an error of TOML's reader, with its line; None if it is none of those that are known.

    Args:
        text: Of the file.
        reason: What the reader says, which ends in the place.

    >>> slip("ratio = 2,67", "Expected newline (at line 1, column 10)").message
    'numbers have a decimal point, not a comma; write 2.67'
    """
    place = _PLACE.search(reason)
    lines = text.split("\n")
    if place is None or int(place[1]) > len(lines):
        return None
    number = int(place[1])
    line, paths = lines[number - 1].rstrip("\r"), _paths(lines[:number])
    path, comma = paths[-1], _COMMA.search(line)
    if comma:
        return Problem(path, f"numbers have a decimal point, not a comma; write {comma[1]}.{comma[2]}", number)
    if not path or path not in paths[:-1]:
        return None
    first = paths.index(path) + 1
    if HEADER.match(line):
        said = f"the table [{excerpt(path)}] stands in line {first} already; put all its keys below one heading"
    else:
        said = f"is given in line {first} already; keep one of them"
    return Problem(path, said, number)


def _paths(lines: list[str]) -> list[str]:
    """Return the dotted path that each line gives a table or a value; empty where it gives none."""
    table, paths = "", []
    for line in lines:
        header, key = HEADER.match(line), KEY.match(line)
        if header and not key:
            table = dotted(header[1])
            paths.append(table)
        else:
            path = dotted(key[1]) if key else ""
            paths.append(f"{table}.{path}" if table and path else path)
    return paths


# ----------------------------------------------------------------------------------------------------------------------
# A user's own mesh stiffness: CSV files beside the design file become part of the design, which then needs no file.
# ----------------------------------------------------------------------------------------------------------------------


COLUMNS = ("phase_cycles", "stiffness_n_m")
"""Of the file, in its first row; others are left alone."""


def with_curves(design: Design, folder: Path) -> tuple[Design, list[Problem]]:
    """Return a design whose own stiffness curves hold their points, and what is wrong with them.

    Args:
        design: As written.
        folder: Where the files are looked for.
    """
    curves, problems = dict(design.dynamics.curves), []
    for mesh, curve in design.dynamics.curves.items():
        path = f"dynamics.curves.{mesh}"
        problems += list(_unknown(path, mesh, design))
        try:
            curves[mesh] = _filled(path, curve, folder)
        except DesignError as error:
            problems += error.problems
    if not curves or problems:
        return design, problems
    dynamics = design.dynamics.model_copy(update={"curves": curves})
    return design.model_copy(update={"dynamics": dynamics}), []


def _unknown(path: str, mesh: str, design: Design) -> Iterator[Problem]:
    sets = [f"{name}.{end}" for name in design.planetaries for end in ("sun-planet", "planet-ring")]
    sets += [
        f"{name}.{first}-{second}"
        for name, epicyclic in design.epicyclics.items()
        for first, second in epicyclic.mesh_pairs
    ]
    if mesh not in (*sets, *design.pairs):
        yield Problem(path, f"there is no mesh {mesh!r}; {near(mesh, [*sets, *design.pairs])}")


def _filled(path: str, curve: MeshCurve, folder: Path) -> MeshCurve:
    has_points = bool(curve.phase_cycles or curve.stiffness_n_m)
    if curve.file is None and not has_points:
        raise DesignError([Problem(path, "has no points; give file, or phase_cycles and stiffness_n_m")])
    if curve.file is not None and not has_points:
        phase, stiffness = _columns(f"{path}.file", beside(curve.file, folder, f"{path}.file"))
        curve = curve.model_copy(update={"phase_cycles": phase, "stiffness_n_m": stiffness})
    try:
        sampled_curve(2.0 * math.pi * np.array(curve.phase_cycles), curve.stiffness_n_m, harmonics=1, source="")
    except DesignError as error:
        raise DesignError([Problem(path, f"{problem.path}: {problem.message}") for problem in error.problems]) from None
    return curve


def _columns(path: str, file: Path) -> tuple[list[float], list[float]]:
    try:
        points = numbers_of(text_of(file, path), COLUMNS)
    except ValueError as error:
        raise DesignError([Problem(path, f"{file} {error}")]) from None
    return [phase for phase, _ in points], [stiffness for _, stiffness in points]


# ----------------------------------------------------------------------------------------------------------------------
# Read a design file: TOML to `Design`, with every problem of the file at once.
# ----------------------------------------------------------------------------------------------------------------------


_MISSING = "there is no such file; `gearwright new` lists the shipped designs, `fly` missions, `study` studies"
_REASON = 160
"""Characters of what TOML's reader says, which may repeat a key [-]."""
DEEPEST = 8
"""Names that a dotted key or a heading may have: a reader takes time with the square of them [-]."""
MOST_ENTRIES = 5_000
"""Tables and entries that a file may have: each is looked up, and what is wrong with it is explained [-]."""
_TEXT = re.compile(
    r'''"""(?:[^"\\]|\\.|"(?!""))*+"""|\'\'\'(?:[^']|'(?!\'\'))*+\'\'\''''
    r"""|"(?:[^"\\\n]|\\.)*+"|'[^'\n]*+'|#[^\n]*+""",
    re.DOTALL,
)
"""Texts in quotes and comments, in which points are only points."""
_DEEP = re.compile(rf"(?<![\w-])(?:[\w-]++[ \t]*+\.[ \t]*+){{{DEEPEST}}}")
_DOTTED = re.compile(r"(?<![\w-])((?:[\w-]++[ \t]*+\.[ \t]*+)++)[\w-]++[ \t]*+=")


@verb
def read(path: str | Path) -> Design:
    """Return the design that a file describes.

    Args:
        path: A TOML file, or the name of a shipped design; a file of that name comes first.

    Raises:
        DesignError: With every problem of the file: its path, line, what was given, what is allowed and the fix.
    """
    file = find_design(str(path))
    return parse(file_text(file), source=str(path), folder=file.parent)


@verb
def parse(text: str, *, source: str = "", folder: Path | None = None) -> Design:
    """Return the design that a TOML text describes.

    Args:
        text: The file's content.
        source: Name of the file, for messages.
        folder: Where the files that it names are looked for; left out: where the program runs.

    Raises:
        DesignError: As `read`.
    """
    if not text.strip():
        raise DesignError(
            [Problem("", "the file is empty; `gearwright new` writes a complete one to start from")], source
        )
    tables = toml_tables(text, source)
    record, written = build(Design, tables)
    problems = list(written.problems)
    if record is not None:
        more = _in_written_keys(reference_problems(cast(Design, record)), written.keys)
        problems += _without_stand_ins(more, problems, tables) if problems else more
    if problems:
        raise DesignError(placed(problems, text), source)
    design, problems = with_curves(cast(Design, record), folder or Path())
    problems += bearing_problems(design)
    if problems:
        raise DesignError(placed(problems, text), source)
    return design


def _without_stand_ins(more: list[Problem], told: list[Problem], tables: dict[str, Any]) -> list[Problem]:
    """Return problems that are none of what stands for faulty and missing quantities: other ones give them, too."""
    other, written = build(Design, tables, stand_in=STAND_INS[1])
    if other is None:
        return []
    again = _in_written_keys(reference_problems(cast(Design, other)), written.keys)
    paths = {problem.path for problem in told}
    return [problem for problem in more if problem in again and problem.path not in paths]


def toml_tables(text: str, source: str) -> dict[str, Any]:
    """Return the tables of a TOML text that a user wrote.

    Args:
        text: The file's content.
        source: Name of the file, for messages.

    Raises:
        DesignError: If it is not TOML, or too much of it.
    """
    if deep := _DEEP.search(_keys(text)):
        message = (
            f"a key or heading has more than {DEEPEST} names with points between them; put shorter keys below headings"
        )
        raise DesignError([Problem("", message, deep.string.count("\n", 0, deep.start()) + 1)], source)
    try:
        tables = tomllib.loads(text)
    except (ValueError, RecursionError) as error:  # ValueError also for whole numbers of thousands of digits
        found = slip(text, str(error))
        if found is not None:
            raise DesignError([found], source) from None
        reason = "its brackets nest too deeply" if isinstance(error, RecursionError) else excerpt(str(error), _REASON)
        place = _PLACE.search(str(error))
        line = int(place[1]) if place else text.count("\n") + 1 if "end of document" in str(error) else None
        message = f"this is not TOML: {reason}; a line reads  key = value  or  [table]"
        raise DesignError([Problem("", message, line)], source) from None
    if (count := _entries(tables)) > MOST_ENTRIES:
        message = f"the file has {count:,} tables and entries; {MOST_ENTRIES:,} are allowed: divide it"
        raise DesignError([Problem("", message)], source)
    return tables


def dotted_names(text: str) -> int:
    """Return how many names the dotted keys of a TOML text have before their last ones.

    Args:
        text: The file's content, with keys of no more than `DEEPEST` names.

    >>> dotted_names("x.y = 1.5  # a.b\\n[p.q]\\nz = {a.b.c = 1}")
    3
    """
    return sum(found.count(".") for found in _DOTTED.findall(_keys(text)))


def _keys(text: str) -> str:
    """Return a TOML text line by line, with a mark in the place of every text in quotes and comment."""
    return _TEXT.sub(lambda found: "_" + "\n" * found[0].count("\n"), text)


def _entries(value: object) -> int:
    """Return how many tables and entries there are."""
    if isinstance(value, dict):
        return len(value) + sum(map(_entries, value.values()))
    return sum(map(_entries, value)) if isinstance(value, list) else 0


def placed(problems: Iterable[Problem], text: str) -> list[Problem]:
    """Return problems with their lines, in the order of the file.

    Args:
        problems: With paths in the keys of the file.
        text: The file's content.
    """
    lines = key_lines(text)
    at_lines = [Problem(problem.path, problem.message, line_of(problem.path, lines)) for problem in problems]
    return sorted(at_lines, key=lambda problem: (problem.line or 0, problem.path))


def _in_written_keys(problems: Iterable[Problem], keys: Mapping[Location, str]) -> list[Problem]:
    """Return problems whose paths end in the key with its unit, as the user wrote it."""
    written = {".".join(location): path for location, path in keys.items()}
    return [Problem(written.get(problem.path, problem.path), problem.message) for problem in problems]


def file_text(path: str | Path) -> str:
    """Return the text of a file that a user writes, or say why there is none to be had.

    Args:
        path: Of a design file, or of any other TOML file that a user writes.

    Raises:
        DesignError: If there is no such text file, or it is too large.
    """
    return text_of(path, missing=_MISSING)


# ----------------------------------------------------------------------------------------------------------------------
# Reader of mission files, and checks of phases, aircraft, power plant and strategies for consistency.
#
# What a mission says is in `spec/missions`; nothing here flies it.
# ----------------------------------------------------------------------------------------------------------------------


# ----------------------------------------------------------------------------------------------------------------------
# What does not fit together in an aircraft, and in the phases that it flies.
# ----------------------------------------------------------------------------------------------------------------------


SPEEDS = ("cas", "tas", "mach")
_WAYS = ("rate_of_climb", "path_angle", "power", "pitch", "duration")
_RISES = ("climb", "descent", "approach")
_NEEDS = {
    "taxi": ("duration",),
    "take-off": ("power", "pitch"),
    "climb": ("rate_of_climb", "path_angle", "power", "pitch"),
    "descent": ("rate_of_climb", "path_angle", "power", "pitch"),
    "approach": ("rate_of_climb", "path_angle", "power", "pitch"),
    "speed-change": ("duration", "power", "pitch"),
    "cruise": ("duration", "distance"),
    "hold": ("duration",),
    "landing": ("power", "pitch"),
}
"""Kind -> of what it needs one."""
_ALSO = {"cruise": ("power", "pitch"), "hold": (), "taxi": ("power", "pitch")}
"""Kind -> what may stand beside it."""


def aircraft_problems(mission: Mission) -> Iterator[Problem]:
    """Yield what does not fit together in an aircraft.

    Args:
        mission: Typed, but not yet checked.
    """
    aircraft = mission.aircraft
    if aircraft is None:
        return
    drag = (aircraft.induced_drag is not None, aircraft.aspect_ratio is not None, aircraft.oswald is not None)
    if drag not in ((True, False, False), (False, True, True)):
        yield Problem("aircraft", "give induced_drag, or aspect_ratio and oswald, of which it follows")
    if aircraft.fuel is not None and aircraft.fuel >= aircraft.mass:
        message = f"{aircraft.fuel:g} kg of fuel in an aircraft of {aircraft.mass:g} kg; give less, or its whole mass"
        yield Problem("aircraft.fuel", message)
    for setting in ("take_off", "landing"):
        flaps = getattr(aircraft, setting)
        if flaps is not None and flaps.highest_lift < (aircraft.highest_lift or 0.0):
            message = f"{flaps.highest_lift:g} is less than the clean {aircraft.highest_lift:g}; flaps lift more"
            yield Problem(f"aircraft.{setting}.highest_lift", message)


def kind_problems(phase: Phase, mission: Mission, start: float) -> Iterator[str]:
    """Yield what does not fit together in a phase that an aircraft flies.

    Args:
        phase: With its kind.
        mission: Of it.
        start: Altitude at its start [m].
    """
    if mission.aircraft is None:
        yield f'kind = "{phase.kind}" without an [aircraft]; give one, or leave kind out'
        return
    if mission.propeller_map == NO_MAP:
        yield "an aircraft needs a thrust, and there is no propeller map; give a propeller_map, or leave kind out"
    yield from _ways(phase)
    yield from _speeds(phase, mission)
    yield from _heights(phase, start)
    if phase.end_power is not None:
        yield "end_power in a phase that an aircraft flies; give power only"
    if phase.power is not None and phase.pitch is not None:
        yield "power and pitch given; the propeller's speed allows only one of them"


def _ways(phase: Phase) -> Iterator[str]:
    """Yield what is too much or too little to say how a phase goes."""
    kind = phase.kind or ""
    needed, stated = _NEEDS[kind], [key for key in (*_WAYS, "distance") if getattr(phase, key) is not None]
    asked = [key for key in stated if key in needed]
    if len(asked) != 1:
        yield f"{' and '.join(asked) or 'nothing'} given; a {kind} needs one of {', '.join(needed)}"
    if others := [key for key in stated if key not in needed and key not in _ALSO.get(kind, ())]:
        yield f"a {kind} does not read {', '.join(others)}; leave it out, or give another kind"
    if phase.end_speed is not None and kind != "landing":
        yield f"a {kind} does not read end_speed; leave it out"


def _speeds(phase: Phase, mission: Mission) -> Iterator[str]:
    """Yield what is wrong with the airspeeds of a phase."""
    kind, stated = phase.kind, [key for key in SPEEDS if getattr(phase, key) is not None]
    pair = kind in _RISES and set(stated) == {"cas", "mach"}
    if len(stated) > 1 and not pair:
        yield f"{' and '.join(stated)} given; give one of {', '.join(SPEEDS)}"
    follows = kind in ("take-off", "landing") or (kind == "cruise" and phase.power is not None)
    if not stated and not follows:
        yield f"no speed given; give one of {', '.join(SPEEDS)}"
    if kind == "landing" and stated:
        yield "a landing rolls from the speed at which the phase before ended; leave its speed out"
    if kind == "cruise" and stated and (phase.power is not None or phase.pitch is not None):
        yield f"{stated[0]} and power given; a cruise at a power finds its speed: keep one of them"
    if kind == "cruise" and not stated and phase.pitch is not None:
        yield "a cruise at a held pitch is not flown; give a speed, or power"
    if (phase.from_cas is not None or phase.from_tas is not None) and kind not in ("take-off", "speed-change"):
        yield "from_cas or from_tas given; a phase that an aircraft flies starts at the speed of the one before"
    aircraft, flaps = mission.aircraft, None
    if aircraft is not None:
        flaps = aircraft.flaps(phase.flaps or "take-off")
    if kind == "take-off" and not stated and flaps is None:
        yield "no speed of rotation, and no stall to take it from; give cas, or aircraft.take_off.highest_lift"


def _heights(phase: Phase, start: float) -> Iterator[str]:
    """Yield what is wrong with the altitudes of a phase."""
    rise, kind = phase.altitude - start, phase.kind
    ways = {"climb": 1.0, "take-off": 1.0, "descent": -1.0, "approach": -1.0}
    way = f"from {height(start)} to {height(phase.altitude)}"
    if kind in ways and kind != "take-off" and rise * ways[kind] <= 0.0:
        word = "up" if ways[kind] > 0.0 else "down"
        yield f"a {kind} leads {word}, and this one {way}; change its altitude"
    elif kind == "take-off" and rise < 0.0:
        yield f"a take-off leads up, and this one {way}; change its altitude"
    elif kind not in ways and abs(rise) > 0.1:
        word = "stays on the ground" if kind in GROUND_KINDS else "is level"
        yield f"a {kind} {word}, and this one leads {way}; make them equal"
    for key in ("rate_of_climb", "path_angle"):
        value = getattr(phase, key)
        if kind in ways and value is not None and not value * ways[kind] > 0.0:
            yield f"{key} of {value:.3g} in a {kind}; turn its sign"


# ----------------------------------------------------------------------------------------------------------------------
# What does not fit together in a mission's strategies and the phases that name them.
# ----------------------------------------------------------------------------------------------------------------------


def strategy_problems(mission: Mission) -> Iterator[Problem]:
    """Yield what does not fit together in strategies.

    Args:
        mission: Typed, but not yet checked.
    """
    for name, strategy in mission.strategies.items():
        at, read = f"strategies.{name}", KEYS_OF[strategy.rule]
        if (needed := NEEDED.get(strategy.rule)) and getattr(strategy, needed) is None:
            yield Problem(at, f"rule {strategy.rule!r} without {needed}; give it, or another rule")
        for key in type(strategy).model_fields:
            if key != "rule" and key not in read and getattr(strategy, key) is not None:
                others = ", ".join(rule for rule, keys in KEYS_OF.items() if key in keys)
                yield Problem(f"{at}.{key}", f"rule {strategy.rule!r} does not read it; leave it out, or use {others}")
    for name, phase in mission.phases.items():
        if phase.strategy is not None:
            yield from (Problem(f"phases.{name}", message) for message in _phase(mission, phase.strategy, name))


def _phase(mission: Mission, strategy: str, name: str) -> Iterator[str]:
    phase = mission.phases[name]
    if strategy not in mission.strategies:
        yield f"there is no strategy {strategy!r}; {near(strategy, mission.strategies)}, or add [strategies.{strategy}]"
    elif mission.strategies[strategy].rule != "turbine-alone" and mission.battery is None:
        yield f"strategy {strategy!r} without a [battery]; give one with energy_kwh"
    if phase.mode != "conventional":
        yield f'strategy and mode = "{phase.mode}" given; a strategy sets who drives: keep one of them'


# ----------------------------------------------------------------------------------------------------------------------
# What does not fit together in a mission: phases, powers, altitudes, battery, steel, oil.
# ----------------------------------------------------------------------------------------------------------------------


_SAME_ALTITUDE = 0.1
"""Altitudes nearer than this are the same [m]."""
SLOWEST = 30.0
"""Airspeed of a cruise over a distance, for a count of intervals before it is flown [m/s]."""
MOST_INTERVALS = 10_000
"""Intervals into which a mission may be cut: some seconds of work, and a day of flight in steps of ten [-]."""


def mission_problems(mission: Mission) -> list[Problem]:
    """Return what does not fit together in a mission.

    Args:
        mission: Typed, but not yet checked.
    """
    problems: list[Problem] = []
    last: float | None = None
    for name, phase in mission.phases.items():
        messages = (*_plain(phase, mission, last), *_drive(phase, mission), *_start(phase, last))
        problems += [Problem(f"phases.{name}", message) for message in messages]
        last = phase.altitude
    problems += aircraft_problems(mission)
    if mission.rotorcraft is not None and (mission.aircraft is not None or mission.propeller_map != NO_MAP):
        message = f'a helicopter has neither wing nor propeller; leave [aircraft] out, propeller_map = "{NO_MAP}"'
        problems.append(Problem("rotorcraft", message))
    problems += strategy_problems(mission)
    problems += _network(mission)
    problems += _shares(mission.motor.loss_shares)
    problems += [
        *_steel(mission.gears),
        *_battery(mission.battery),
        *_cells(mission.battery),
        *_windings(mission.motor.heat),
        *_dips(mission.oil),
    ]
    if not problems:
        problems += _intervals(mission)
    return [*problems, *window_problems(mission.windows, mission.phases, spools=mission.engine.spool is not None)]


def _battery(rules: BatteryRules | None) -> Iterator[Problem]:
    if rules is not None and rules.full_voltage_v < rules.empty_voltage_v:
        message = f"{rules.full_voltage_v:g} V is less than the {rules.empty_voltage_v:g} V at no charge; exchange them"
        yield Problem("battery.full_voltage_v", message)


def _cells(rules: BatteryRules | None) -> Iterator[Problem]:
    """Yield what is wrong with a curve of open-circuit voltage."""
    cells = rules.cells if rules else None
    if cells is None:
        return
    charges, voltages, at = cells.ocv_charge, cells.ocv_v, "battery.cells"
    if (charges is None) != (voltages is None):
        yield Problem(at, "a curve needs ocv_charge and ocv_v; give both, or none")
    elif charges and voltages:
        if len(charges) != len(voltages):
            yield Problem(
                f"{at}.ocv_v", f"{len(voltages)} voltages at {len(charges)} states of charge; give one for each"
            )
        if charges[0] != 0.0 or charges[-1] != 1.0 or any(b <= a for a, b in pairwise(charges)):
            yield Problem(f"{at}.ocv_charge", "they must rise from 0 to 1; sort them, and add the ends")
        if min(voltages) <= 0.0 or any(b < a for a, b in pairwise(voltages)):
            yield Problem(f"{at}.ocv_v", "they must be above 0 and never fall; exchange them")
    if cells.lowest_temperature_k >= cells.highest_temperature_k:
        message = (
            f"{cells.highest_temperature_k:g} K is not above the lowest, {cells.lowest_temperature_k:g} K; raise it"
        )
        yield Problem(f"{at}.highest_temperature_k", message)


def _network(mission: Mission) -> Iterator[Problem]:
    network = mission.oil.network
    if network is not None and network.dry_from is not None and network.dry_from not in mission.phases:
        message = f"there is no phase {network.dry_from!r}; {near(network.dry_from, mission.phases)}"
        yield Problem("oil.network.dry_from", message)


def _shares(shares: list[float] | None) -> Iterator[Problem]:
    if shares is not None and (min(shares) < 0.0 or abs(sum(shares) - 1.0) > 1e-6):
        message = f"parts of a loss are 0 or more and add up to 1, and these to {sum(shares):g}; change them"
        yield Problem("motor.loss_shares", message)


def _windings(rules: WindingRules | None) -> Iterator[Problem]:
    if rules is None:
        return
    for key in ("coolant_temperature_k", "start_temperature_k", "derate_from_k"):
        value = getattr(rules, key)
        if value is not None and value >= rules.highest_winding_k:
            message = f"{rules.highest_winding_k:g} K is not above {key}, {value:g} K; raise it, or lower the other"
            yield Problem("motor.heat.highest_winding_k", message)


def _dips(oil: OilRules) -> Iterator[Problem]:
    for gear, dip in oil.dip.items():
        if not 0.0 <= dip <= 1.0:
            yield Problem(f"oil.dip.{gear}", f"{dip:g} of a gear cannot dip into oil; give 0 to 1")


def _intervals(mission: Mission) -> Iterator[Problem]:
    """Yield that a mission has more intervals than can be flown."""
    count, altitude = 0.0, None
    for phase in mission.phases.values():
        start = phase.from_altitude if phase.from_altitude is not None else altitude
        climb, altitude = phase.altitude - (phase.altitude if start is None else start), phase.altitude
        duration = climb / phase.rate_of_climb if phase.rate_of_climb else phase.duration or 0.0
        duration += (phase.distance or 0.0) / SLOWEST
        count += duration / mission.step + 2.0
    if count > MOST_INTERVALS:
        message = (
            f"cuts the phases into {count:,.0f} intervals, at most {MOST_INTERVALS:,} are flown; longer steps help"
        )
        yield Problem("step", message)


def _steel(rules: GearLifeRules) -> list[Problem]:
    if rules.steel is None:
        return []  # a flight knows the material
    try:
        gear_steel(rules.steel, rules.grade or "MQ", rules.hardness_hv or USUAL_HARDNESS)
    except DesignError as error:
        return [
            Problem(f"gears.{STEEL_KEYS.get(problem.path, problem.path)}", problem.message)
            for problem in error.problems
        ]
    return []


def _plain(phase: Phase, mission: Mission, last: float | None) -> Iterator[str]:
    """Yield what is wrong with speed, power and altitude, by what a phase says of itself or of its aircraft."""
    if phase.kind is not None:
        yield from kind_problems(phase, mission, _first_altitude(phase, last))
        return
    for key in ("distance", "path_angle", "flaps", "end_speed"):
        if getattr(phase, key) is not None:
            yield f"{key} is read where an aircraft flies; give a kind too, or leave it out"
    yield from _speed(phase)
    yield from _power(phase, mission)
    yield from _altitude(phase, last)


def _first_altitude(phase: Phase, last: float | None) -> float:
    start = phase.from_altitude if phase.from_altitude is not None else last
    return phase.altitude if start is None else start


def _start(phase: Phase, last: float | None) -> Iterator[str]:
    start = _first_altitude(phase, last)
    if last is not None and abs(start - last) > _SAME_ALTITUDE:
        yield f"it starts at {height(start)}, but the phase before ended at {height(last)}; make them equal"


def _speed(phase: Phase) -> Iterator[str]:
    stated = [name for name in ("cas", "tas", "mach") if getattr(phase, name) is not None]
    if len(stated) != 1:
        yield f"{' and '.join(stated) or 'no speed'} given; give one of cas, tas and mach"
    if phase.from_cas is not None and phase.from_tas is not None:
        yield "from_cas and from_tas given; give one of them"


def _power(phase: Phase, mission: Mission) -> Iterator[str]:
    stated = [name for name in ("power", "pitch") if getattr(phase, name) is not None]
    if len(stated) > 1:
        yield "power and pitch given; the propeller's speed allows only one of them"
    craft = mission.rotorcraft
    if not stated and mission.aircraft is None and craft is None:
        yield "nothing sets its power; give power or pitch, or an [aircraft] that needs a thrust"
    if phase.power is None and mission.propeller_map == NO_MAP and (craft is None or phase.pitch is not None):
        yield "without a propeller map only a power can be flown; give power, or a propeller_map"
    if phase.end_power is not None and phase.power is None:
        yield "end_power without power; give both, or only power"


def _drive(phase: Phase, mission: Mission) -> Iterator[str]:
    """Yield what is wrong with who drives."""
    if phase.mode == "hybrid" and phase.electric_share is None:
        yield "hybrid without electric_share; give the motors' part of the power, such as 0.3"
    if phase.mode != "hybrid" and phase.electric_share is not None:
        yield f'electric_share in {phase.mode} mode; write mode = "hybrid", or leave it out'
    if phase.mode != "conventional" and mission.battery is None:
        yield f"{phase.mode} mode without a [battery]; give one with energy_kwh"
    if phase.engines is not None and phase.engines > mission.engines:
        yield f"{phase.engines} engines work of {mission.engines}; give at most those"


def _altitude(phase: Phase, last: float | None) -> Iterator[str]:
    start = _first_altitude(phase, last)
    climb = phase.altitude - start
    if (phase.duration is None) == (phase.rate_of_climb is None):
        yield "give one of duration and rate_of_climb"
    elif phase.rate_of_climb is not None and not phase.rate_of_climb * climb > 0.0:
        yield (
            f"a rate of climb of {phase.rate_of_climb:.3g} m/s never leads from {height(start)} to"
            f" {height(phase.altitude)}; turn its sign, or give a duration"
        )


# ----------------------------------------------------------------------------------------------------------------------
# Reading a mission: the file, its problems all at once, and the propeller map and engine deck that it names.
# ----------------------------------------------------------------------------------------------------------------------


_MAP_FILE = ".csv"
"""How the name of a map ends that is a file."""


@verb
def read_mission(path: str | Path) -> Mission:
    """Return the mission that a file describes.

    Args:
        path: A TOML file, or the name of a shipped mission; a file of that name comes first.

    Raises:
        DesignError: With every problem of the file.
    """
    file = find_mission(str(path))
    return parse_mission(file_text(file), source=str(path), folder=file.parent)


def parse_mission(text: str, *, source: str = "", folder: Path | None = None) -> Mission:
    """Return the mission that a TOML text describes.

    Args:
        text: The file's content.
        source: Name of the file, for messages.
        folder: Where propeller map and engine deck are looked for; left out: where the program runs.

    Raises:
        DesignError: With every problem of the text.
    """
    record, written = build(Mission, toml_tables(text, source))
    problems = list(written.problems)
    if record is not None and not problems:
        problems += mission_problems(cast(Mission, record))
        problems += map_problems(cast(Mission, record).propeller_map, folder or Path())
        problems += deck_problems(cast(Mission, record).engine.deck, folder or Path())
    if problems:
        raise DesignError(placed(problems, text), source)
    return cast(Mission, record)


def is_map_file(name: str) -> bool:
    """Tell whether a propeller map is a file of the user's, not a shipped one.

    Args:
        name: As a mission or a study gives it.
    """
    return name.endswith(_MAP_FILE)


def map_problems(name: str, folder: Path) -> tuple[Problem, ...]:
    """Return why a propeller map cannot be had from where it is said to be.

    Args:
        name: Of a shipped map or a file.
        folder: Of the mission, in which the file must stand.
    """
    try:
        if is_map_file(name):
            beside(name, folder, "propeller_map")
    except DesignError as error:
        return error.problems
    return ()


def deck_problems(name: str | None, folder: Path) -> tuple[Problem, ...]:
    """Return why an engine deck cannot be had from where it is said to be.

    Args:
        name: Of the file; None: there is none.
        folder: Of the mission, in which the file must stand.
    """
    try:
        if name is not None:
            beside(name, folder, "engine.deck")
    except DesignError as error:
        return error.problems
    return ()
