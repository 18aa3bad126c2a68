"""The component itself: what OpenMDAO asks of it, answered by a design."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from importlib.util import find_spec
from typing import Any, Literal

from gearwright.errors import Problem, install, refuse
from gearwright.exchange.openmdao.held import Held
from gearwright.spec import Design, Mission, Study
from gearwright.verbs import verb


@verb
def component(
    design: Design, inputs: Sequence[str] | Mapping[str, float], outputs: Sequence[str], *,
    teeth: Literal["chosen", "frozen"] = "chosen", mission: Mission | None = None,
) -> Any:  # fmt: skip
    """Return a design as an ``ExplicitComponent`` of OpenMDAO: entries of its file in, results of its sizing out.

    Inputs are in the unit of their path, outputs in SI. A dotted name becomes one with colons (`variable`). A place
    that takes whole numbers alone, such as ``planets``, is a discrete input. Partials are central differences with
    the teeth held as they are chosen where they are asked for, whatever ``teeth`` says. What cannot be sized or flown
    is an ``AnalysisError`` in the words of gearwright. ``component.designed()`` is the design at the last values.

    Args:
        design: As read.
        inputs: Dotted paths of the design, or with ``mission.`` of the mission, which begin at what stands there; or
            path -> number to begin with. Several paths with commas between them have one value.
        outputs: Results as studies name them: ``mass``, ``meshes.first.sun-planet.contact_margin``, ``fly.fuel`` …
        teeth: ``chosen`` anew for all values, or ``frozen`` as they are chosen at the start.
        mission: What is flown, for results named ``fly.…`` and paths named ``mission.…``.

    Raises:
        DesignError: If OpenMDAO is not here, a path or result is unknown or no number, or the start cannot be sized.
    """
    if find_spec("openmdao") is None:
        refuse([Problem("", f"this needs OpenMDAO, which is not here; {install('openmdao')}")])
    from gearwright.exchange.openmdao.explicit import transmission

    asked = {"inputs": inputs, "outputs": outputs}
    refuse(Problem(name, "it is empty; give a list of at least one name") for name, names in asked.items() if not names)
    given: dict[str, float | None] = dict(inputs) if isinstance(inputs, Mapping) else dict.fromkeys(inputs)
    study = Study(name="component", designs=[design.name], results=list(outputs), mission=mission)
    return transmission()(Held(design, given, study, frozen=teeth == "frozen"))
