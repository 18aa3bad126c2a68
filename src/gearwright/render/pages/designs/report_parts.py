"""What the report says beside its tables and figures: key numbers, warnings, assumptions."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from gearwright.checks import Check, worst
from gearwright.dynamics import Trace
from gearwright.dynamics.vibration import DynamicLoad, dynamic_loads
from gearwright.render.pages.page import Number, quantity, reserve
from gearwright.render.tables.checks import check_sentence
from gearwright.render.words.headline import unneeded_text
from gearwright.reviews import Review
from gearwright.sizing import Sizing, asked_speeds, remarks
from gearwright.sizing.mass import complete_mass
from gearwright.sizing.rating import method_for, rating_of
from gearwright.spec import Design, implied
from gearwright.spec.design import RATINGS
from gearwright.train import recirculation
from gearwright.units import Origin, margin_text, text

EQUAL = 1e-6
"""Part by which a peak of one run may lie above that of another and be the same [-]."""
TOLD = ("contact", "interrupted", "chaotic", "sensitive", "asked were")
"""Words of a run's notes that its reader is warned of."""


def key_numbers(sizing: Sizing, review: Review | None = None) -> tuple[Number, ...]:
    """Return what a reader asks first, with bands where they are known.

    Args:
        sizing: As sized.
        review: Of it; left out: the margin is that of the checks of sizing alone.
    """
    rated = sizing.reference
    taken = [name for name, power in rated.machine_powers.items() if power < 0.0]
    torque = max((abs(rated.machine_torques[name]) for name in taken), default=0.0)
    whole = complete_mass(sizing)
    gears = Origin("gears, shafts, carriers", "sum; by this mass designs are chosen")
    numbers = [
        quantity("complete mass", whole.total, "mass", digits=3, band=whole.band, share="68 %"),
        quantity("rated power", sizing.rated_power, "power"),
        quantity("output torque", torque, "torque"),
        quantity("power density of the train as sized", sizing.power_density, "specific_power"),
        *reserve(worst(sizing.checks) if review is None else review.worst),
        *([quantity("its gears, shafts, carriers", whole.train, "mass", digits=3)] if whole.train else []),
        quantity("train as sized", sizing.mass, "mass", origin=gears),
        *([quantity("motors", sizing.motor_mass, "mass")] if sizing.motor_mass else []),
        Number("level", sizing.level if "level" not in implied(sizing.design) else f"{sizing.level}, by default"),
    ]
    return tuple(numbers)


def warnings(sizing: Sizing, traces: Mapping[str, Trace], review: Review | None = None) -> tuple[str, ...]:
    """Return what is not as asked.

    Args:
        sizing: As sized.
        traces: Load case -> run, of those that were simulated.
        review: Of it, if it is shown.
    """
    checks = sizing.checks if review is None else review.checks
    sentences = [f"{check_sentence(check)}; it should be 1 or more." for check in checks if check.fails]
    sentences += [f"{check_sentence(check)}; waived: {check.waiver}." for check in checks if check.waiver]
    if review is not None:
        sentences += [f"{unneeded_text(name)}." for name in review.unneeded]
    sentences += remarks(sizing)
    sentences += _yielded(sizing)
    sentences += [
        f"{text(loop.power, 'power')} circulate in case {case}: {', '.join(loop.path)}."
        for case, flow in sizing.flows.items()
        for loop in recirculation(sizing.train, flow)
    ]
    sentences += _given(sizing)
    for case, trace in traces.items():
        sentences += [
            f"{load.mesh}, case {case}: with the simulated peak force, {load.peak_over_mean:.2f} times the mean, the"
            f" margins are {margin_text(load.bending_margin)} (bending) and {margin_text(load.contact_margin)}"
            " (contact)."
            for load in dynamic_loads(sizing, trace)
            if min(load.bending_margin, load.contact_margin) < 1.0 and not _said(load, checks)
        ]
        telling = (note for note in trace.notes if any(words in note for words in TOLD))
        sentences += [f"Case {case}: {note}." for note in telling]
    return tuple(sentences)


def _said(load: DynamicLoad, checks: Sequence[Check]) -> bool:
    """Return whether a review tells of a peak that is as large, in whatever case."""
    peaks = {check.mode: check.margin or 0.0 for check in checks if str(check.part) == load.mesh}
    both = (("peak bending", load.bending_margin), ("peak contact", load.contact_margin))
    return all(mode in peaks and peaks[mode] <= margin * (1.0 + EQUAL) for mode, margin in both)


def _given(sizing: Sizing) -> list[str]:
    """Return one sentence for each origin of values that are given in place of computed ones."""
    paths: dict[str, list[str]] = {}
    for path, given in sizing.given.items():
        paths.setdefault(given.origin, []).append(path)
    return [f"Given in place of computed values ({origin}): {', '.join(names)}." for origin, names in paths.items()]


def _yielded(sizing: Sizing) -> list[str]:
    """Return one sentence for each speed that yields, whatever the number of cases."""
    cases: dict[str, list[str]] = {}
    for speed in asked_speeds(sizing):
        words = (
            f"{speed.machine} turns at {text(speed.actual, 'speed')}, asked were {text(speed.asked, 'speed')}"
            f" ({speed.deviation:+.2%}): the teeth give no better"
        )
        cases.setdefault(words, []).append(speed.case)
    return [f"{words} (case {', '.join(names)})." for words, names in cases.items()]


_COUNTED = (
    "The train as sized, by which designs are chosen, counts gears, shafts and carriers before webs and seats are cut"
    " out of them or added; the complete mass takes them as manufactured, with housing, bearings, oil system and small"
    " parts. Motors are in neither."
)
_MOUNTED = (
    "Shafts rest on two radial bearings, each at the middle of its width and rigid; stresses by forces along shafts are"
    " left out.",
    "Loads of rotors act in every load case, across the shaft in the direction that bends it most.",
    "Bearings have basic rating lives, without a_ISO for oil and dirt; catalogue ratings are those of ISO 281 and"
    " ISO 76 for an assumed inside.",
)


def assumptions(sizing: Sizing) -> tuple[str, ...]:
    """Return what was assumed, as far as the design leaves it open.

    Args:
        sizing: As sized.
    """
    design = sizing.design
    sentences = [_COUNTED]
    if not any(flow.loss for flow in sizing.flows.values()):
        sentences.append("Power flow without losses in the meshes.")
    if all(mesh.load_factor == 1.0 for mesh in sizing.meshes):
        sentences.append("Parallel meshes share the load equally: K_γ = 1.")
    sentences += _nominal(design)
    if any(_keeps_idlers(design, stage) for stage in design.planetaries):
        sentences.append("Planets, loaded on both flanks, keep the full bending allowable; ISO 6336-3 takes 0.7 of it.")
    if all(shaft.bending_moment == 0.0 for shaft in sizing.shafts):
        sentences.append("Shafts carry torsion alone.")
    if sizing.built_shafts:
        sentences += _MOUNTED
    estimated = [machine.name for machine in sizing.machines if not machine.inertia_is_given]
    if estimated:
        sentences.append(f"Inertia estimated, not given: {', '.join(estimated)}.")
    if any(pair.kind == "face" for pair in design.pairs.values()):
        sentences.append("Face-gear pairs are drawn as if their axes were parallel.")
    return tuple(sentences)


def _nominal(design: Design) -> list[str]:
    """Return a sentence where the method of some stages has no factors for peaks of the load."""
    ratings = {stage: rating_of(design, stage) for stage in design.stages}
    stages = [stage for stage, rating in ratings.items() if not method_for(rating).peaks]
    if not stages:
        return []
    whose = "Gears" if len(stages) == len(ratings) else f"Gears of {', '.join(stages)}"
    return [f"{whose} are sized without application and dynamic factor (K_A = K_v = 1); see the peaks of a run."]


def _keeps_idlers(design: Design, stage: str) -> bool:
    """Tell whether the method of a stage leaves it to a factor what idlers bear, and none is given."""
    return "idler_factor" in RATINGS[design.rating(stage)].reads and design.rules(stage).idler_factor == 1.0
