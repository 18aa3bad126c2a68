"""Random trains with one free speed: any stages, one after the other or branching, machines anywhere."""

from __future__ import annotations

from typing import Any

from hypothesis import strategies as st

from gearwright.spec import Design

KINDS = ("external", "internal", "ring", "carrier", "sun", "layshafts")
COMPOUND = ("wolfrom", "meshed", "stepped")


@st.composite
def tables(
    draw: st.DrawFn, kinds: tuple[str, ...] = KINDS, least: float = 0.97
) -> tuple[dict[str, Any], dict[str, int], dict[str, float]]:
    """Return the table of a design with a case, the teeth of its gears and the efficiency of its stages."""
    shafts, teeth, efficiency = ["s0"], {}, {}
    pairs: dict[str, Any] = {}
    planetaries: dict[str, Any] = {}
    epicyclics: dict[str, Any] = {}
    for k in range(draw(st.integers(1, 5))):
        start, end, name = draw(st.sampled_from(shafts)), f"s{k + 1}", f"stage{k}"
        ends = (start, end) if draw(st.booleans()) else (end, start)
        kind = draw(st.sampled_from(kinds))
        efficiency[name] = draw(st.floats(least, 1.0))
        small, large = draw(st.integers(15, 60)), draw(st.integers(15, 90))
        shafts.append(end)
        match kind:
            case "external" | "internal":
                pairs[name] = {"pinion": ends[0], "wheel": ends[1], "internal": kind == "internal"}
                teeth |= {f"{name}.pinion": small, f"{name}.wheel": small + large}
            case "layshafts":
                left, right = f"left{k}", f"right{k}"
                shafts += [left, right]
                pairs[f"{name}a"] = {"pinion": start, "wheel": [left, right]}
                pairs[f"{name}b"] = {"pinion": [left, right], "wheel": end}
                efficiency |= {f"{name}a": efficiency[name], f"{name}b": efficiency[name]}
                teeth |= {f"{name}a.pinion": small, f"{name}a.wheel": large}
                teeth |= {f"{name}b.pinion": large, f"{name}b.wheel": small + large}
            case "wolfrom" | "meshed" | "stepped":
                epicyclics[name], its_teeth = _compound(draw, kind, name, ends)
                shafts += [f"cage{k}"] if kind == "wolfrom" else []
                teeth |= {f"{name}.{gear}": count for gear, count in its_teeth.items()}
            case _:
                members = [member for member in ("sun", "ring", "carrier") if member != kind]
                planetaries[name] = {kind: "ground", **dict(zip(members, ends, strict=True))}
                teeth |= {f"{name}.sun": small, f"{name}.planet": large, f"{name}.ring": small + 2 * large}
    machine = {"speed": 500.0, "power": 1e5}
    motors = {f"m{k}": {"shaft": draw(st.sampled_from(shafts)), **machine} for k in range(draw(st.integers(0, 3)))}
    table = {
        "name": "random", "shafts": shafts, "pairs": pairs, "planetaries": planetaries, "motors": motors,
        "epicyclics": epicyclics,
        "turbines": {"turbine": {"shaft": "s0", **machine}},
        "propellers": {"propeller": {"shaft": shafts[-1], "speed": 100.0, "diameter": 2.0}},
    }  # fmt: skip
    names = ["turbine", "propeller", *motors]
    balancing = draw(st.sampled_from(names))
    powers = {name: {"power": draw(_powers(name))} for name in names}
    table["cases"] = {"case": {**powers, balancing: {"speed": 300.0}}}
    return table, teeth, efficiency


def _compound(
    draw: st.DrawFn, kind: str, name: str, ends: tuple[str, str]
) -> tuple[dict[str, Any], dict[str, int]]:  # fmt: skip
    """Return a compound set of one freedom between two shafts, and its teeth: of equal modules, axes where they fit."""
    sun, wide, narrow = draw(st.integers(12, 40)), draw(st.integers(20, 60)), draw(st.integers(15, 19))
    gear = {"s": {"shaft": ends[0], "teeth": sun}}
    match kind:
        case "wolfrom":
            rings = {"held": ("ground", sun + 2 * wide), "turned": (ends[1], sun + wide + narrow)}
            planets = {"wide": (wide, ["s", "held"], None), "narrow": (narrow, ["turned"], "wide")}
            carrier = f"cage{name.removeprefix('stage')}"
        case "stepped":
            rings = {"r": ("ground", sun + wide + narrow)}
            planets = {"wide": (wide, ["s"], None), "narrow": (narrow, ["r"], "wide")}
            carrier = ends[1]
        case _:
            rings = {"r": ("ground", sun + 2 * wide + narrow)}
            planets = {"inner": (wide, ["s", "outer"], None), "outer": (narrow, ["r"], None)}
            carrier = ends[1]
    table = {
        "carrier": carrier,
        "suns": gear,
        "rings": {key: {"shaft": shaft, "teeth": count} for key, (shaft, count) in rings.items()},
        "planets": {
            key: {"teeth": count, "meshes": mates, "in_one_piece_with": piece}
            for key, (count, mates, piece) in planets.items()
        },
    }
    teeth = {"s": sun} | {key: ring[1] for key, ring in rings.items()} | {key: p[0] for key, p in planets.items()}
    return table, teeth


def shuffled(draw: st.DrawFn, table: dict[str, Any]) -> dict[str, Any]:
    """Return a table of a design with its entries and shafts in another order."""
    result = {key: _reordered(draw, value) for key, value in table.items()}
    return _reordered(draw, result)


def _reordered(draw: st.DrawFn, value: Any) -> Any:
    if isinstance(value, dict):
        return {key: value[key] for key in draw(st.permutations(list(value)))}
    return draw(st.permutations(value)) if isinstance(value, list) else value


def design_of(table: dict[str, Any]) -> Design:
    """Return the design of a table in SI."""
    return Design.model_validate(table)


def _powers(name: str) -> st.SearchStrategy[float]:
    """Return powers that a file may ask for: none, or between a milliwatt and a megawatt; motors take them, too [W]."""
    given = st.floats(1e-3, 1e6)
    return st.just(0.0) | given if name == "turbine" else st.just(0.0) | given | given.map(lambda power: -power)
