"""Follows three numbers through the package, and lists the rooms of every layer, for docs/architecture.md.

python docs/walks.py

Each walk runs a shipped design and notes which functions are entered; its stations are names that are looked for, and
the run gives their files and the order in which they are first entered. The rooms of a layer are those of its contract
"Rooms of …" in pyproject.toml, and all that its folder holds where it has none.
"""

from __future__ import annotations

import inspect
import re
import sys
import tomllib
from collections.abc import Callable, Iterator
from importlib import import_module
from operator import attrgetter
from pathlib import Path
from types import FrameType
from typing import NamedTuple

from gearwright.mission import durability, fly
from gearwright.particulars import particulars
from gearwright.render.tables.checks import factor_tables
from gearwright.render.tables.flights import bearing_table
from gearwright.render.tables.sizing import tables_of
from gearwright.shipped import shipped_design, shipped_mission
from gearwright.sizing import rated_factors, size
from gearwright.spec import read, read_mission

ROOT = Path(__file__).parents[1]
SOURCE = ROOT / "src" / "gearwright"
PAGE = ROOT / "docs" / "architecture.md"
HEAD, FOOT = "<!-- made by docs/walks.py: from here -->\n", "<!-- to here -->\n"


class Walk(NamedTuple):
    """A number on its way, and what is looked for there."""

    title: str
    run: Callable[[], object]
    stations: frozenset[str]
    """Functions, methods with their class."""


def _mesh_force() -> object:
    return tables_of(particulars(size(read(shipped_design("hybrid-turboprop")))))


def _contact_safety() -> object:
    return factor_tables(rated_factors(size(read(shipped_design("hybrid-turboprop")))))


def _bearing_life() -> object:
    sizing = size(read(shipped_design("in-line-h2")))
    return bearing_table(durability(fly(sizing, read_mission(shipped_mission("hybrid-reserves")))))


WALKS = (
    Walk(
        "A turbine's `power_kw` to a planet's mesh force, of `hybrid-turboprop`",
        _mesh_force,
        frozenset({
            "Key.si", "build_train", "solve_speeds", "_machine_torques", "solve_torques", "worst_case", "size_meshes",
            "tables_of",
        }),
    ),
    Walk(
        "A stage's module to its S_H, of the same design",
        _contact_safety,
        frozenset({
            "modules", "module_for", "rate_mesh", "load_distribution", "pitting_rating", "combinations", "rate_row",
            "Iso6336.rate", "factor_tables",
        }),
    ),
    Walk(
        "An altitude to a bearing's life, of `in-line-h2` on the mission `hybrid-reserves`",
        _bearing_life,
        frozenset({
            "air_at", "followed", "needed_thrust", "angle_for_thrusts", "along", "seat_duties", "mean_load",
            "basic_life", "bearing_table",
        }),
    ),
)  # fmt: skip


def entered(walk: Walk) -> list[tuple[str, str]]:
    """Return module and name of every station of a walk, in the order in which they are first entered.

    Args:
        walk: Which one.

    Raises:
        ValueError: One was not entered, or several of one name were.
    """
    found: dict[tuple[str, str], None] = {}

    def note(frame: FrameType, event: str, _: object) -> None:
        if event == "call" and frame.f_code.co_qualname in walk.stations:
            found.setdefault((frame.f_globals["__name__"], frame.f_code.co_qualname))

    before = sys.getprofile()
    sys.setprofile(note)
    try:
        walk.run()
    finally:
        sys.setprofile(before)
    own = [(module, name) for module, name in found if module.startswith("gearwright.")]
    names = [name for _, name in own]
    wrong = sorted(name for name in walk.stations if names.count(name) != 1)
    if wrong:
        raise ValueError(f"{walk.title}: entered in no module or in several: {', '.join(wrong)}")
    return own


def _told(walk: Walk) -> Iterator[str]:
    """Yield the lines of a walk."""
    yield f"**{walk.title}.**\n\n"
    for number, (name, station) in enumerate(entered(walk), 1):
        module = import_module(name)
        words = inspect.getdoc(attrgetter(station)(module))
        if not words:
            raise ValueError(f"{name}: {station} has no docstring")
        file = Path(module.__file__ or "").relative_to(SOURCE).as_posix()
        yield f"{number}. `{file}: {station}`: {_first(words)}\n"
    yield "\n"


def _first(words: str) -> str:
    """Return what the first line of a docstring says that a function returns, up to a semicolon."""
    return re.split(r"[\n;]", words.removeprefix("Return "))[0].removesuffix(".")


def rooms() -> dict[str, str]:
    """Return layer -> its rooms as the table shows them, the lowest first; those that no law orders by name."""
    rules = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))["tool"]["importlinter"]["contracts"]
    laws = {rule["name"]: rule["layers"] for rule in rules if rule["type"] == "layers"}
    found = {}
    for folder in (home.parent for home in SOURCE.glob("*/__init__.py")):
        held = {path.stem for path in folder.glob("*.py")} | {home.parent.name for home in folder.glob("*/__init__.py")}
        law = laws.get(f"Rooms of {folder.name}", [" | ".join(sorted(held - {"__init__"}))])
        lines = [[name.strip().rpartition(".")[2] for name in line.split("|")] for line in reversed(law)]
        found[folder.name] = " · ".join(" ".join(f"`{name}`" for name in line) for line in lines)
    return found


def walks_markdown() -> str:
    """Return the page on the architecture with its made parts as they come.

    Raises:
        ValueError: The page has not one place for the walks, or a station was not entered.
    """
    text = PAGE.read_text(encoding="utf-8")
    if text.count(HEAD) != 1 or text.count(FOOT) != 1:
        raise ValueError(f"{PAGE.name}: {HEAD.strip()} and {FOOT.strip()} belong there once")
    before, _, rest = text.partition(HEAD)
    walks = "".join(line for walk in WALKS for line in _told(walk))
    text = f"{before}{HEAD}\n{walks}{FOOT}{rest.partition(FOOT)[2]}"
    for layer, told in rooms().items():
        text = re.sub(rf"^(\| `{layer}` \| [^|]* \|)[^|\n]*\|$", rf"\1 {told} |", text, flags=re.MULTILINE)
    return text


if __name__ == "__main__":
    PAGE.write_text(walks_markdown(), encoding="utf-8")
