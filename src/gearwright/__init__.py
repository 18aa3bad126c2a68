"""gearwright designs aircraft transmissions and shows how they behave.

>>> import gearwright as gw
>>> design = gw.read("in-line-h2")
>>> sizing = gw.size(design)
>>> round(sizing.gear_mass, 1)
34.0
"""

from importlib import import_module
from typing import TYPE_CHECKING

from gearwright.version import __version__ as __version__

if TYPE_CHECKING:
    from gearwright.catalogue import (
        engine_slam,
        engine_start,
        propeller,
        propeller_loads,
        read_blades,
        rotor,
        turboshaft,
    )
    from gearwright.closure import Wishes, arrange, close, close_arranged, contradictions, nearest_variant
    from gearwright.dynamics import (
        Model,
        Outputs,
        campbell,
        frequency_response,
        modes,
        periodic,
        simulate,
        simulate_many,
        speed_map,
        statics,
        waterfall,
    )
    from gearwright.dynamics.assembly import assemble
    from gearwright.dynamics.sharing import sharing
    from gearwright.dynamics.vibration import answer as response, critical_speeds, run_up as runup
    from gearwright.enumeration import Effort, architectures
    from gearwright.errors import DesignError, Problem, SolveError
    from gearwright.exchange import from_rexs, to_fmu, to_rexs
    from gearwright.mission import (
        durability,
        duty_spectrum as duty,
        fly,
        fly_mix as mix,
        phase_forces,
        read_duty,
        size_for_life,
    )
    from gearwright.mission.windows import fly_window as window
    from gearwright.optimum import optimise, search
    from gearwright.render.drawings.catalogue import sheets as draw
    from gearwright.render.pages.notebook import figure
    from gearwright.render.pages.report import report
    from gearwright.render.schematic import power_flow_figure, schematic_figure
    from gearwright.reviews import review
    from gearwright.shape import scene
    from gearwright.shipped import (
        shipped_design,
        shipped_designs,
        shipped_mission,
        shipped_missions,
        shipped_mix,
        shipped_mixes,
        shipped_studies,
        shipped_study,
    )
    from gearwright.shipped.gallery import notebook
    from gearwright.sizing import influences, methods_beside, named_results, size, size_many
    from gearwright.sizing.losses import loss_balance
    from gearwright.sizing.mass import complete_mass
    from gearwright.spec import (
        at_level,
        design_text,
        edited,
        edited_mission,
        parse,
        read,
        read_mission,
        read_mix,
        read_study,
        schema,
    )
    from gearwright.store import StoredRun, load, save
    from gearwright.study import compare, equal_life, fly_many, for_engine, run as study
    from gearwright.validate import validate
    from gearwright.weights import engines, mass

_VERBS = {
    "DesignError": "errors",
    "Effort": "enumeration",
    "Model": "dynamics",
    "Outputs": "dynamics",
    "Problem": "errors",
    "SolveError": "errors",
    "StoredRun": "store",
    "Wishes": "closure",
    "architectures": "enumeration",
    "arrange": "closure",
    "assemble": "dynamics.assembly",
    "at_level": "spec",
    "campbell": "dynamics",
    "close": "closure",
    "close_arranged": "closure",
    "compare": "study",
    "complete_mass": "sizing.mass",
    "contradictions": "closure",
    "critical_speeds": "dynamics.vibration",
    "design_text": "spec",
    "draw": "render.drawings.catalogue",
    "durability": "mission",
    "duty": "mission",
    "edited": "spec",
    "edited_mission": "spec",
    "engine_slam": "catalogue",
    "engine_start": "catalogue",
    "engines": "weights",
    "equal_life": "study",
    "figure": "render.pages.notebook",
    "fly": "mission",
    "fly_many": "study",
    "for_engine": "study",
    "frequency_response": "dynamics",
    "from_rexs": "exchange",
    "influences": "sizing",
    "load": "store",
    "loss_balance": "sizing.losses",
    "mass": "weights",
    "methods_beside": "sizing",
    "mix": "mission",
    "modes": "dynamics",
    "named_results": "sizing",
    "nearest_variant": "closure",
    "notebook": "shipped.gallery",
    "optimise": "optimum",
    "parse": "spec",
    "periodic": "dynamics",
    "phase_forces": "mission",
    "power_flow_figure": "render.schematic",
    "propeller": "catalogue",
    "propeller_loads": "catalogue",
    "read": "spec",
    "read_blades": "catalogue",
    "read_duty": "mission",
    "read_mission": "spec",
    "read_mix": "spec",
    "read_study": "spec",
    "report": "render.pages.report",
    "response": "dynamics.vibration",
    "review": "reviews",
    "rotor": "catalogue",
    "runup": "dynamics.vibration",
    "save": "store",
    "scene": "shape",
    "schema": "spec",
    "schematic_figure": "render.schematic",
    "search": "optimum",
    "sharing": "dynamics.sharing",
    "shipped_design": "shipped",
    "shipped_designs": "shipped",
    "shipped_mission": "shipped",
    "shipped_missions": "shipped",
    "shipped_mix": "shipped",
    "shipped_mixes": "shipped",
    "shipped_studies": "shipped",
    "shipped_study": "shipped",
    "simulate": "dynamics",
    "simulate_many": "dynamics",
    "size": "sizing",
    "size_for_life": "mission",
    "size_many": "sizing",
    "speed_map": "dynamics",
    "statics": "dynamics",
    "study": "study",
    "to_fmu": "exchange",
    "to_rexs": "exchange",
    "turboshaft": "catalogue",
    "validate": "validate",
    "waterfall": "dynamics",
    "window": "mission.windows",
}
"""Public name -> module; loaded on first use, so that ``gearwright --help`` stays quick."""

_CALLED = {
    "draw": "sheets",
    "duty": "duty_spectrum",
    "mix": "fly_mix",
    "response": "answer",
    "runup": "run_up",
    "study": "run",
    "window": "fly_window",
}
"""Public name -> what it is called in its module, where it is another."""

__all__ = [
    "DesignError",
    "Effort",
    "Model",
    "Outputs",
    "Problem",
    "SolveError",
    "StoredRun",
    "Wishes",
    "architectures",
    "arrange",
    "assemble",
    "at_level",
    "campbell",
    "close",
    "close_arranged",
    "compare",
    "complete_mass",
    "contradictions",
    "critical_speeds",
    "design_text",
    "draw",
    "durability",
    "duty",
    "edited",
    "edited_mission",
    "engine_slam",
    "engine_start",
    "engines",
    "equal_life",
    "figure",
    "fly",
    "fly_many",
    "for_engine",
    "frequency_response",
    "from_rexs",
    "influences",
    "load",
    "loss_balance",
    "mass",
    "methods_beside",
    "mix",
    "modes",
    "named_results",
    "nearest_variant",
    "notebook",
    "optimise",
    "parse",
    "periodic",
    "phase_forces",
    "power_flow_figure",
    "propeller",
    "propeller_loads",
    "read",
    "read_blades",
    "read_duty",
    "read_mission",
    "read_mix",
    "read_study",
    "report",
    "response",
    "review",
    "rotor",
    "runup",
    "save",
    "scene",
    "schema",
    "schematic_figure",
    "search",
    "sharing",
    "shipped_design",
    "shipped_designs",
    "shipped_mission",
    "shipped_missions",
    "shipped_mix",
    "shipped_mixes",
    "shipped_studies",
    "shipped_study",
    "simulate",
    "simulate_many",
    "size",
    "size_for_life",
    "size_many",
    "speed_map",
    "statics",
    "study",
    "to_fmu",
    "to_rexs",
    "turboshaft",
    "validate",
    "waterfall",
    "window",
]


def __getattr__(name: str) -> object:
    """Load a public verb on its first use."""
    if name not in _VERBS:
        raise AttributeError(f"module 'gearwright' has no attribute {name!r}")
    value: object = getattr(import_module(f"gearwright.{_VERBS[name]}"), _CALLED.get(name, name))
    return value


def __dir__() -> list[str]:
    """List the verbs, also those that are not loaded yet, so that an editor completes them."""
    return sorted([*__all__, "__version__"])
