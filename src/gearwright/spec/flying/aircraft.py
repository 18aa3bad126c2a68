"""What does not fit together in an aircraft, and in the phases that it flies."""

from __future__ import annotations

from collections.abc import Iterator

from gearwright.air import height
from gearwright.errors import Problem
from gearwright.spec.missions import GROUND_KINDS, NO_MAP, Mission, Phase

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
