"""The page on which the gearbox turns: solids, their numbers and margins, in one file that loads nothing."""

from __future__ import annotations

import json
from base64 import b64encode
from collections.abc import Mapping
from typing import Any, Literal

from markupsafe import Markup

from gearwright.render import solids
from gearwright.render.pages.designs.solid_parts import labels_of, parted, parts_of
from gearwright.render.schematic.schematic import schematic_figure
from gearwright.render.style import theme
from gearwright.render.style.templates import environment
from gearwright.render.words.masses import summary
from gearwright.shape import Scene, glb, scene
from gearwright.sizing import Sizing
from gearwright.units import text
from gearwright.verbs import verb
from gearwright.version import __version__


@verb
def turning(sizing: Sizing, *, detail: Literal["fine", "coarse"] = "fine") -> str:
    """Return a page on which the gearbox turns, as one self-contained HTML text.

    Args:
        sizing: As sized.
        detail: Of its solids.
    """
    built = scene(sizing, detail=detail)
    facts = solid_facts(sizing, built)
    three = solids.bundled()
    return environment().get_template("turning.html.j2").render(
        name=sizing.design.name,
        summary=summary(sizing),
        style=Markup(solids.text("turning.css")),
        scripts=[Markup(script) for script in solids.scripts()],
        facts=Markup(_json(facts)),
        model=Markup(b64encode(glb(built)).decode()),
        drawing=Markup(theme.to_svg(schematic_figure(sizing), "train")),
        most=text(max((part["force"] or 0.0 for part in facts["parts"].values()), default=0.0), "force"),
        approximations=built.approximations,
        three=three["version"],
        version=__version__,
    )  # fmt: skip


def solid_facts(sizing: Sizing, built: Scene) -> dict[str, Any]:
    """Return what a page says of solids: parts with numbers and margins, whose body is whose, ways apart, what is up.

    Args:
        sizing: As sized.
        built: Scene of it.
    """
    parts, labels = parts_of(sizing, built, sizing.checks), labels_of(built)
    toothed = [(abs(node.spins[built.cases[0]]), label) for node in built.nodes
               if (label := labels[node.name]) in parts and "teeth" in parts[label]]  # fmt: skip
    return {
        "parts": parts,
        "labels": labels,
        "first": max(toothed)[1],
        "explode": parted(built),
        "up": upright(sizing),
    }


def upright(sizing: Sizing) -> list[float]:
    """Return the direction that is up on the page: a rotor's shaft towards its rotor, or the z of the cross-section.

    Args:
        sizing: As sized.
    """
    for machine in sizing.machines:
        if machine.kind == "rotor":
            along = sizing.arrangement.frames[machine.shaft].along
            plan = sizing.arrangement.plans[machine.shaft]
            sign = 1.0 if plan.places[machine.name] >= plan.length / 2.0 else -1.0
            return [round(sign * part, 9) for part in along]
    return [0.0, 0.0, 1.0]


def _json(facts: Mapping[str, Any]) -> str:
    """Return facts as text that no tag can end."""
    return json.dumps(facts, ensure_ascii=False, allow_nan=False).replace("<", "\\u003c")
