"""The page on which the gearbox turns, and the report's chapters on dynamics."""

import json
import math
from base64 import b64encode
from collections.abc import Iterable, Iterator, Mapping, Sequence
from typing import Any, NamedTuple

import numpy as np
from markupsafe import Markup
from rich.console import Group, RenderableType
from rich.text import Text

from gearwright.base import (
    HOUSING,
    Check,
    Floats,
    Kind,
    Origin,
    PartId,
    largest,
    margin_text,
    smallest_first,
    text,
    worst_first,
)
from gearwright.dynamics import Modes, System, Trace
from gearwright.dynamics.sharing import Allocation, Floating, PlanetCounts, SharingStudy
from gearwright.dynamics.vibration import SpeedCase, first_meshes
from gearwright.particulars import Particulars, Reported
from gearwright.render import solids, style as theme
from gearwright.render.figures.dynamics import (
    LIMIT,
    RING,
    allocation_figure,
    around_figure,
    campbell_figure,
    distribution_figure,
    orbit_figure as sharing_orbit_figure,
    planets_figure,
    published_notes,
    sharing_figure,
    support_figure,
    tornado_figure,
)
from gearwright.render.figures.motion import (
    drawn_modes_figure,
    every_step,
    mesh_frequencies,
    moving_centres,
    orbit_figure,
    phase_figure,
    transmission_error_figure,
)
from gearwright.render.pages.page import Number, Page, PageFigure, Section, Tone, Verdict, environment, figure, set_page
from gearwright.render.schematic import schematic_figure
from gearwright.render.tables.dynamics import assumption_table, critical_table, machine_table
from gearwright.render.tables.weights import summary as mass_summary
from gearwright.render.terminal import Grid
from gearwright.render.vector.figure import Figure as Drawing
from gearwright.shape import Node, Scene
from gearwright.sizing import CarrierSizing, GearSizing, ShaftSizing, Sizing
from gearwright.version import __version__

# ----------------------------------------------------------------------------------------------------------------------
# What the page of the turning gearbox says of every part, and how far its solids move apart.
# ----------------------------------------------------------------------------------------------------------------------


MOST = 8
"""Checks of a part that are shown [-]."""
Rows = list[list[str]]


def labels_of(scene: Scene) -> dict[str, str]:
    """Return node -> label of the part whose numbers are shown where it is picked.

    Args:
        scene: The scene.
    """
    return {node.name: _label(node.part) for node in scene.nodes}


def _label(part: PartId) -> str:
    return str(part) if part.kind is not Kind.BEARING else f"bearing {part}"


def parts_of(sizing: Sizing, scene: Scene, checks: Sequence[Check]) -> dict[str, dict[str, Any]]:
    """Return label -> title, numbers, worst margin and checks of every part of a scene, stage by stage, then shafts.

    Args:
        sizing: As sized.
        scene: Of it.
        checks: Of its parts.
    """
    parts = {_label(node.part): node for node in scene.nodes}
    stages = list(dict.fromkeys(gear.part.name for gear in sizing.gears))

    def place(label: str) -> tuple[int, bool, bool]:
        part = parts[label].part
        return (stages.index(part.name) if part.name in stages else len(stages), part.kind is Kind.BEARING,
                part.kind is Kind.CARRIER)  # fmt: skip

    return {label: _part(sizing, scene, parts[label], checks) for label in sorted(parts, key=place)}


def _part(sizing: Sizing, scene: Scene, node: Node, checks: Sequence[Check]) -> dict[str, Any]:
    own = worst_first(
        check for check in checks if check.margin is not None and _concerns(sizing, check.part, node.part)
    )
    margins = [check.margin for check in own if check.margin is not None and math.isfinite(check.margin)]
    shown = [[f"{check.part} {check.what}", margin_text(check.margin or 0.0)] for check in own[:MOST]
             if check.margin is not None and math.isfinite(check.margin)]  # fmt: skip
    found: dict[str, Any] = {"title": _label(node.part), "rows": _rows(sizing, node.part), "checks": shown,
                             "margin": round(min(margins), 4) if margins else None}  # fmt: skip
    gear, force = _gear(sizing, node.part), _force(sizing, node.part)
    found |= {"force": force, "force_text": "" if force is None else text(force, "force")}
    if gear is not None and node.part.kind is Kind.GEAR:
        found["teeth"] = gear.teeth
    return found


def _force(sizing: Sizing, part: PartId) -> float | None:
    """Return the largest force of a part in the cases that it is sized for [N]: of a mesh, a bearing or a pin."""
    gear = _gear(sizing, part)
    if part.kind is Kind.GEAR and gear is not None:
        rows = [mesh for mesh in sizing.meshes if gear.name in mesh.gears]
        return max(math.hypot(row.tangential_force, row.radial_force, row.axial_force) for row in rows)
    carried = [math.hypot(own.radial, own.axial) for own in sizing.bearings
               if part == PartId(Kind.BEARING, own.name)]  # fmt: skip
    carried += [carrier.pin_force for carrier in sizing.carriers
                if part == carrier.part or (gear is not None and carrier.stage == gear.stage)]  # fmt: skip
    return max(carried, default=None)


def _concerns(sizing: Sizing, checked: PartId, part: PartId) -> bool:
    """Tell whether a check of a part or of a mesh concerns the part of a body."""
    gear = _gear(sizing, part)
    if part.kind is Kind.GEAR and gear is not None:
        rows = [mesh.part for mesh in sizing.meshes if gear.name in mesh.gears]
        return checked in (part, gear.part) or any(checked.is_of(row) for row in rows)
    return checked._replace(number=None) == part or (checked.kind is Kind.JOINT and checked.branch == part.name)


def _gear(sizing: Sizing, part: PartId) -> GearSizing | None:
    same = (gear for gear in sizing.gears
            if (gear.stage, gear.role, gear.own) == (part.name, part.role, part.own))  # fmt: skip
    return next(same, None)


def _rows(sizing: Sizing, part: PartId) -> Rows:
    gear = _gear(sizing, part)
    if part.kind is Kind.GEAR and gear is not None:
        return _of_gear(sizing, gear, part)
    for shaft in sizing.shafts:
        if part == PartId(Kind.SHAFT, shaft.name):
            return _of_shaft(sizing, shaft)
    for carrier in sizing.carriers:
        if part == carrier.part:
            return _of_carrier(carrier)
    for bearing in sizing.bearings:
        if part == PartId(Kind.BEARING, bearing.name):
            return [
                ["bearing", bearing.designation], ["on shaft", bearing.shaft],
                ["bore", text(bearing.inner_diameter, "length")], ["outside", text(bearing.outer_diameter, "length")],
                ["width", text(bearing.width, "length")], ["mass", text(bearing.mass, "mass")],
            ]  # fmt: skip
    if part == HOUSING:
        return [["material", sizing.design.housing.material], ["shell", "as the complete mass weighs it"]]
    runs_on = gear.runs_on if gear is not None else None
    return [["of", str(gear.part) if gear else str(part)], ["bearing", runs_on.designation if runs_on else "not sized"]]


def _of_gear(sizing: Sizing, gear: GearSizing, part: PartId) -> Rows:
    rules, node = sizing.design.rules(gear.stage), part.branch or gear.shafts[0]
    speeds = [[f"speed, {case}", text(flow.speeds[node], "speed")] for case, flow in sizing.flows.items()]
    word = "spiral angle" if getattr(sizing.design.stages[gear.stage], "kind", "") == "bevel" else "helix angle"
    leaning = [[word, text(gear.helix_angle, "angle")]] if gear.helix_angle else []
    return [
        ["teeth", str(gear.teeth)], ["normal module", text(gear.module, "length")], *leaning,
        ["pressure angle", text(rules.pressure_angle, "angle")], ["profile shift", f"{gear.profile_shift:.4g}"],
        ["face width", text(gear.face_width, "length")], ["pitch diameter", text(gear.pitch_diameter, "length")],
        ["material", rules.material], ["equal bodies", str(gear.bodies)],
        ["mass of one, as sized", text(gear.mass, "mass")], *speeds[:4],
    ]  # fmt: skip


def _of_shaft(sizing: Sizing, shaft: ShaftSizing) -> Rows:
    speeds = [[f"speed, {case}", text(flow.speeds[shaft.name], "speed")] for case, flow in sizing.flows.items()]
    return [
        ["diameter", text(shaft.diameter, "length")], ["bore", text(shaft.bore, "length")],
        ["length", text(shaft.length, "length")], ["torque", text(shaft.torque, "torque")],
        ["bending moment", text(shaft.bending_moment, "torque")],
        ["material", sizing.design.shaft_material.name], ["mass, as sized", text(shaft.mass, "mass")], *speeds[:4],
    ]  # fmt: skip


def _of_carrier(carrier: CarrierSizing) -> Rows:
    return [
        ["on shaft", carrier.shaft], ["pin circle", text(2.0 * carrier.radius, "length")],
        ["pins", text(carrier.pin_diameter, "length")], ["plate", text(carrier.plate_thickness, "length")],
        ["torque", text(carrier.torque, "torque")], ["force on a pin", text(carrier.pin_force, "force")],
        ["mass, as sized", text(carrier.mass, "mass")],
    ]  # fmt: skip


def parted(scene: Scene) -> dict[str, list[float]]:
    """Return node -> how far it moves where the gearbox is drawn apart: shafts off each other, sets along their axis.

    Args:
        scene: The scene.
    """
    low, high = scene.box
    middle, size = 0.5 * (low + high), float(np.linalg.norm(high - low))
    along = {"sun": -0.10, "ring": 0.12, "tie": 0.20, "carrier": 0.26}
    ways: dict[str, list[float]] = {}
    for node in scene.nodes:
        axis = node.axes.along
        if node.part == HOUSING:
            ways[node.name] = [0.0, 0.0, 0.0]
            continue
        if node.on:
            back = -along["carrier"] * size if node.look == "planet" else 0.0
            half = -0.5 * along["carrier"] * size if node.look == "bearing" else 0.0
            ways[node.name] = [0.0, 0.0, back + half]
            continue
        beside = _square(node.axes.origin - middle, axis)
        ways[node.name] = (0.5 * beside + along.get(node.look, 0.0) * size * axis).tolist()
    return ways


def _square(way: Floats, axis: Floats) -> Floats:
    return np.asarray(way - (way @ axis) * axis)


# ----------------------------------------------------------------------------------------------------------------------
# The page on which the gearbox turns: solids, their numbers and margins, in one file that loads nothing.
# ----------------------------------------------------------------------------------------------------------------------


def turning(facts: Particulars, built: Scene, model: bytes) -> str:
    """Return a page on which the gearbox turns, as one self-contained HTML text.

    Args:
        facts: Of a sizing.
        built: Its solids.
        model: The same as a GLB file.
    """
    sizing = facts.sizing
    said = solid_facts(sizing, built)
    three = solids.bundled()
    return environment().get_template("turning.html.j2").render(
        name=sizing.design.name,
        summary=mass_summary(facts),
        style=Markup(solids.text("turning.css")),
        scripts=[Markup(script) for script in solids.scripts()],
        facts=Markup(_json(said)),
        model=Markup(b64encode(model).decode()),
        drawing=Markup(theme.to_svg(schematic_figure(sizing), "train")),
        most=text(max((part["force"] or 0.0 for part in said["parts"].values()), default=0.0), "force"),
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


# ----------------------------------------------------------------------------------------------------------------------
# Chapters of the report on dynamics: critical speeds, drawn mode shapes, transmission error and paths, assumptions.
# ----------------------------------------------------------------------------------------------------------------------


MOST_DRAWN = 4
"""Mode shapes that are drawn on the train."""
MOST_PATHS = 6
"""Meshes or centres in one figure of paths."""


def dynamics_sections(
    reported: Reported,
    system: System,
    *,
    case: str,
    modes: Modes | None = None,
    trace: Trace | None = None,
    campbell: Sequence[SpeedCase] = (),
) -> tuple[Section, ...]:
    """Return the report's chapters on dynamics beside the tables of modes and forces, as far as there is something.

    Args:
        reported: What the report shows of the sizing.
        system: Assembled from it for the case.
        case: Load case of the run.
        modes: Of the system.
        trace: A run of the system.
        campbell: From `critical_speeds`.
    """
    sizing = reported.particulars.sizing
    sections = [
        _critical(sizing, campbell),
        _shapes(reported.particulars, system, modes, campbell, case=case),
        _paths(sizing, system, trace, case),
        Section("Assumptions of the dynamic model", tables=(assumption_table(reported.assumptions),)),
    ]
    return tuple(section for section in sections if section.tables or section.figures)


def _critical(sizing: Sizing, campbell: Sequence[SpeedCase]) -> Section:
    caption = "Natural frequencies, orders and excited resonances against speed; separation margins of the nearest."
    figures = [figure(campbell_figure(sizing, case), f"campbell-{n}", caption) for n, case in enumerate(campbell)]
    tables = (*map(critical_table, campbell), *map(machine_table, campbell))
    return Section("Critical speeds", tables=tables, figures=tuple(figures))


def _shapes(
    facts: Particulars, system: System, modes: Modes | None, campbell: Sequence[SpeedCase], *, case: str
) -> Section:
    """Draw the modes that are excited nearest to the operating speed, or the lowest ones if none is known."""
    if modes is None:
        return Section("Mode shapes")
    near = [critical.modes[0] for case in campbell for critical in case.nearest]
    lowest = list(range(modes.rigid + 1, len(modes.frequency) + 1))
    numbers = sorted(list(dict.fromkeys([*near, *lowest]))[:MOST_DRAWN])
    which = "Modes excited nearest to the operating speed" if near else "Lowest modes"
    caption = f"{which}, on the train, case {case}."
    drawing = drawn_modes_figure(facts, system, modes, numbers=numbers)
    return Section("Mode shapes", figures=(figure(drawing, "drawn-modes", caption),))


def _paths(sizing: Sizing, system: System, trace: Trace | None, case: str) -> Section:
    samples = every_step(trace) if trace is not None else None
    if samples is None:
        return Section("Transmission error and paths")
    lines = first_meshes(sizing, system)
    centres = moving_centres(samples)[:MOST_PATHS]
    caption = f"Phase portraits of the meshes, case {case}: a closed curve repeats; the teeth part left of zero."
    figures = [
        *_errors(sizing, lines, trace, case),
        figure(phase_figure(samples, lines[:MOST_PATHS]), "phase", caption),
    ]
    if centres:
        caption = f"Paths of centres about their means, case {case}; of planetary sets in the frame of the carrier."
        figures.append(figure(orbit_figure(samples, centres), "orbits", caption))
    return Section("Transmission error and paths", figures=tuple(figures))


def _errors(sizing: Sizing, lines: Sequence[str], trace: Trace | None, case: str) -> Iterator[PageFigure]:
    """Yield one figure for each stage: its meshes share a mesh frequency."""
    samples, rates = every_step(trace) if trace is not None else None, mesh_frequencies(sizing, case)
    for stage in sizing.design.stages:
        rows = {mesh.name: line for mesh, line in zip(sizing.train.meshes, lines, strict=True) if mesh.stage == stage}
        meshes, rate = list(rows.values()), max(rates[row] for row in rows)
        if samples is not None and meshes and rate > 0.0:
            drawing = transmission_error_figure(samples, meshes, mesh_frequency=rate)
            yield figure(drawing, f"error-{_safe(stage)}", f"Dynamic transmission error of {stage}, case {case}.")


def _safe(stage: str) -> str:
    return "".join(letter if letter.isalnum() else "-" for letter in stage)


# ----------------------------------------------------------------------------------------------------------------------
# The load sharing of a design for the terminal.
# ----------------------------------------------------------------------------------------------------------------------


PERCENTILES = (50.0, 95.0, 99.0)
_UNITS = {"clocking": ("mrad", 1e-3)}


def sharing_text(study: SharingStudy) -> RenderableType:
    """Return the answers of a load-sharing study as text and tables.

    Args:
        study: From `sharing_study`.
    """
    parts: list[RenderableType] = [Text(line) for line in summary(study)]
    if study.influences:
        parts.append(_influences(study))
    if study.allocation is not None:
        parts.append(_allocation(study.allocation))
    return Group(*parts)


def summary(study: SharingStudy) -> list[str]:
    """Return the answers in a few sentences.

    Args:
        study: From `sharing_study`.
    """
    problem, sharing = study.problem, study.sharing
    count, cycle = len(problem.lines), sharing.tooth_cycle
    perfect = ", ".join(
        f"{name} {value / count:.2%}" for name, value in zip(problem.lines, problem.perfect, strict=True)
    )
    cycled = ", ".join(
        f"{name} {_range(low / count, high / count)}"
        for name, low, high in zip(problem.lines, cycle.min(axis=0), cycle.max(axis=0), strict=True)
    )
    lines = [
        f"{problem.stage}: {count} paths; loops of the load in the train: {problem.train.count}",
        f"without errors: {perfect}",
        f"with the errors as given: {cycled} over a tooth cycle, K_γ {sharing.load_factor:.3f} ({sharing.reason})",
    ]
    if problem.stated is not None:
        stated = ", ".join(f"{name} {share:.2%}" for name, share in zip(problem.lines, problem.stated, strict=True))
        lines.insert(1, f"stated in the design and taken by sizing: {stated}; all below is what stiffness makes of it")
    if not problem.shifts:
        lines.append("statically determinate: equilibrium alone shares the load, and no error shifts it")
    if study.distribution is not None and problem.shifts:
        shares = ", ".join(
            f"{percent:g} % below {study.distribution.percentile(percent):.2%}" for percent in PERCENTILES
        )
        lines.append(
            f"{len(study.distribution.peak)} gearboxes with random phases (seed {study.distribution.seed}): {shares}"
        )
    if study.clocking is not None:
        angles = ", ".join(f"{gear} {1e3 * angle:+.3f} mrad" for gear, angle in study.clocking.angles)
        window, target = 1e3 * study.clocking.window, study.clocking.target
        lines.append(f"equal without errors with clocking: {angles}; {target:.0%} within ±{window:.2f} mrad of it")
    return lines


def _range(low: float, high: float) -> str:
    """Return a share that changes, or stays, in per cent."""
    ends = (f"{low:.2%}", f"{high:.2%}")
    return " to ".join(dict.fromkeys(ends))


def _influences(study: SharingStudy) -> Grid:
    table = Grid("One error at a time")
    table.add_column("error")
    for header in ("size", "change of b [%]"):
        table.add_column(header, justify="right")
    table.add_column("")
    for influence in study.influences:
        effect = f"±{100.0 * influence.effect:.3f}"
        table.add_row(
            influence.source, _size(influence.kind, influence.size), effect, "turns" if influence.turns else "stays"
        )
    return table


def _size(kind: str, size: float) -> str:
    unit, scale = _UNITS.get(kind, ("µm", 1e-6))
    return f"{size / scale:.4g} {unit}"


def _allocation(allocation: Allocation) -> Grid:
    share = f"{100.0 * allocation.target:g}/{100.0 * (1.0 - allocation.target):g}"
    title = f"Tolerances for {share} in {allocation.percent:g} % of gearboxes (reached: {allocation.reached:.2%})"
    table = Grid(title)
    table.add_column("error")
    for header in ("given", "allowed"):
        table.add_column(header, justify="right")
    for row in smallest_first(allocation.sizes, lambda row: row.allowed / row.given):
        allowed = _size(row.kind, row.allowed) if row.allowed < row.given else "as given"
        table.add_row(row.error, _size(row.kind, row.given), allowed)
    return table


# ----------------------------------------------------------------------------------------------------------------------
# The load sharing of a design as one self-contained HTML page: answers, figures, and a paper's claims.
# ----------------------------------------------------------------------------------------------------------------------


_FOOTER = "Shares are those of forces along the lines of action; b is the share times the number of paths."
_OF_A_HUNDRED = 95.0
"""Gearboxes below the share in the head [%]."""
AROUND = 3
"""Paths that are drawn round their shaft, at least."""
Drawn = tuple[str, Drawing]
"""Caption and figure."""


class ClaimRow(NamedTuple):
    """A published claim and what becomes of it."""

    place: str
    """Where it stands."""
    printed: str
    """In few words."""
    verdict: str
    """In words."""
    sign: str
    """``yes``, ``partly`` or ``no``."""
    why: str
    """Reason, with numbers."""


class Paper(NamedTuple):
    """What a publication shows of such a design."""

    figures: Iterable[Drawn]
    """Counterparts of its figures, drawn as they are asked for."""
    claims: tuple[ClaimRow, ...]


def sharing_page(
    sizing: Sizing,
    studies: Sequence[SharingStudy],
    *,
    counts: Sequence[PlanetCounts] = (),
    floats: Floating | None = None,
    target: float | None = None,
    paper: Paper | None = None,
) -> str:
    """Return the page; it makes no request to anywhere.

    Args:
        sizing: What was sized.
        studies: One for each stage that is shown.
        counts: K_γ against planets, of the sets that have it.
        floats: What the supports of shafts buy, from `floating`.
        target: Share that was asked for [-].
        paper: Figures and claims of a publication on such a design, which follow at the end.
    """
    chapters = [
        Section(f"Stage {study.problem.stage}", notes=_sentences(summary(study)),
                figures=_drawn(_figures(study, target), f"stage{k}"))
        for k, study in enumerate(studies)
    ]  # fmt: skip
    chapters += [_planets(count, f"planets{k}") for k, count in enumerate(counts)]
    if floats is not None:
        chapters.append(Section("Floating", figures=_drawn(_supports(floats), "floating")))
    claims = () if paper is None else paper.claims
    if paper is not None:
        chapters.append(Section("Figures of the paper", figures=_drawn(paper.figures, "paper")))
        chapters.insert(0, _claimed(claims))
    return set_page(
        Page("Load sharing", sizing.design.name, sizing.design.description, _verdict(studies, claims, target),
             tuple(_numbers(studies)), tuple(chapters), design=sizing.design, footer=_FOOTER)
    )  # fmt: skip


def _verdict(studies: Sequence[SharingStudy], claims: Sequence[ClaimRow], target: float | None) -> Verdict:
    """Return how equally the paths share, whether a target is kept, and how many claims of a paper do not hold."""
    worst = largest(studies, lambda study: study.sharing.load_factor)
    factor = worst.sharing.load_factor
    said = f"With the errors as given the most loaded path of {worst.problem.stage} carries K_γ = {factor:.3f} times"
    said += " its equal share."
    failing = sum(claim.sign == "no" for claim in claims)
    if failing:
        return Verdict(Tone.BAD, f"{failing} of {len(claims)} claims of the paper do not hold", said)
    if target is not None:
        missed = any(study.sharing.load_factor > target * len(study.problem.lines) for study in studies)
        word = "Misses the target with the errors as given" if missed else "Keeps the target with the errors as given"
        return Verdict(Tone.BAD if missed else Tone.GOOD, word, said)
    return Verdict(Tone.OPEN, "No target is asked for", said)


def _numbers(studies: Sequence[SharingStudy]) -> Iterator[Number]:
    for study in studies:
        stage, sharing = study.problem.stage, study.sharing
        origin = Origin("K_γ = max(F_i) / mean(F_i)", sharing.reason)
        yield Number(f"K_γ of {stage}", f"{sharing.load_factor:.3f}", value=sharing.load_factor, origin=origin)
        yield Number(f"paths of {stage}", f"{len(study.problem.lines)}")
        if study.distribution is not None and study.problem.shifts:
            share = study.distribution.percentile(_OF_A_HUNDRED)
            yield Number(f"{_OF_A_HUNDRED:g} % of gearboxes below", f"{share:.2%}".replace("%", " %"))


def _claimed(claims: Sequence[ClaimRow]) -> Section:
    content = environment().get_template("claims.html.j2").render(claims=claims)
    return Section("Claims of the paper", content=Markup(content))


def _sentences(words: Iterable[str]) -> tuple[str, ...]:
    return tuple(f"{line[:1].upper()}{line[1:]}." for line in words)


def _planets(counts: PlanetCounts, prefix: str) -> Section:
    """Return K_γ against the number of planets of one set."""
    drawn = (f"K_γ against planets; {LIMIT}", planets_figure(counts))
    title = f"Planets of stage {counts.stage}"
    return Section(title, notes=_sentences(published_notes()), figures=_drawn((drawn,), prefix))


def _drawn(figures: Iterable[Drawn], prefix: str) -> tuple[PageFigure, ...]:
    """Draw figures; the prefix keeps their ids apart and the same each time."""
    return tuple(figure(drawn, f"{prefix}-{k}", words) for k, (words, drawn) in enumerate(figures))


def _figures(study: SharingStudy, target: float | None) -> Iterator[Drawn]:
    yield "Sharing with the errors as given", sharing_figure({study.problem.stage: study.sharing})
    if len(study.problem.lines) >= AROUND:
        yield (
            f"Round the shaft: wedges are mean coefficients b, bars go from the least to the greatest; rings stand"
            f" {RING:g} apart, the dark one is the equal share",
            around_figure(study.sharing),
        )
    if study.influences:
        yield "What every error does alone", tornado_figure(study)
        yield "What chance makes of all errors", distribution_figure(study, target)
    if study.allocation is not None:
        yield "Which tolerance to tighten", allocation_figure(study.allocation)


def _supports(floats: Floating) -> Iterator[Drawn]:
    """Yield what the softest support buys, and the orbits of shafts that move."""
    yield f"Support of shaft {floats.sweep.shaft}", support_figure(floats.sweep, {floats.stiffness: "design"})
    yield "Orbits of the shafts", sharing_orbit_figure(floats.paths)
