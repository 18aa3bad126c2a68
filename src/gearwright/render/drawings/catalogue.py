"""All drawings of a sizing by name."""

from collections.abc import Collection, Iterator
from dataclasses import replace

from gearwright.base import Problem, near, refuse, verb
from gearwright.render.drawings.assembly_sheets import arrangement_content, casing_content, housing_content
from gearwright.render.drawings.carriers import carrier_content
from gearwright.render.drawings.gear_sheet import gear_content
from gearwright.render.drawings.gear_view import hub_of
from gearwright.render.drawings.paper import Content, Sheet, compose
from gearwright.render.drawings.shaft_sheet import shaft_content
from gearwright.shape import scene
from gearwright.shape.stands import Scene, hand_of, kind_of
from gearwright.sizing import GearSizing, Sizing
from gearwright.sizing.places import runs


@verb
def sheets(sizing: Sizing, names: Collection[str] = (), *, solids: Scene | None = None) -> list[Sheet]:
    """Return the sheets of a sizing.

    Args:
        sizing: What was sized.
        names: Of sheets, or of kinds of them (``shaft``, ``gear``, ``carrier``); none: all sheets.
        solids: A scene of it, coarse; left out: it is made here.

    Raises:
        DesignError: If there is no sheet of a name.
    """
    every = list(contents(sizing, solids or scene(sizing, detail="coarse")))
    known = {content.name for content in every} | {content.kind for content in every}
    refuse(Problem("--what", f"there is no sheet {name!r}; {near(name, known)}") for name in names if name not in known)
    numbered = [
        replace(content, title=replace(content.title, sheet=(k, len(every))))
        for k, content in enumerate(every, start=1)
    ]
    wanted = [content for content in numbered if not names or {content.name, content.kind} & set(names)]
    return [compose(content) for content in wanted]


def contents(sizing: Sizing, solids: Scene) -> Iterator[Content]:
    """Yield what every sheet shows: the general arrangement, shafts, gears, carriers, the housing and its bores.

    Args:
        sizing: What was sized.
        solids: A scene of it.
    """
    yield arrangement_content(sizing, solids)
    made = {run.shaft for run in runs(sizing)[0]}  # a shaft that is the cage of its planets alone is none
    yield from (
        shaft_content(sizing, shaft.name) for shaft in sizing.shafts if shaft.diameter > 0.0 and shaft.name in made
    )
    for gear in sizing.gears:
        for label, shaft in gear_sheets(sizing, gear).items():
            yield gear_content(sizing, gear, shaft, label)
    yield from (carrier_content(sizing, carrier) for carrier in sizing.carriers)
    yield from (content for content in (casing_content(sizing, solids), housing_content(sizing)) if content is not None)


def gear_sheets(sizing: Sizing, gear: GearSizing) -> dict[str, str]:
    """Return the sheets of a gear with the shaft that carries it: one for all shafts whose bodies are alike.

    A cylindrical gear that is one piece with its shaft is on the sheet of that shaft.

    Args:
        sizing: What was sized.
        gear: One of its gears.
    """
    integral = {joint.shaft for joint in sizing.joints if joint.part == gear.name and joint.kind == "integral"}
    bodies: dict[tuple[object, object], str] = {}
    for shaft in gear.shafts:
        if shaft not in integral or kind_of(sizing, gear.stage) == "bevel":
            bodies.setdefault((hub_of(sizing, gear, shaft), hand_of(sizing, gear, shaft)), shaft)
    several = len(bodies) > 1
    return {f"{gear.name}-{shaft}" if several else gear.name: shaft for shaft in bodies.values()}
