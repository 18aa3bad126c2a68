"""Mode shapes on the drawn train: who swings with whom on the skeleton, and each planetary set from the front."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import NamedTuple

from gearwright.dynamics import Modes
from gearwright.dynamics.model import Owner, System
from gearwright.identity import SIDES, Kind, Role, carrier_part, gear_part
from gearwright.render.schematic import glyphs
from gearwright.render.schematic.drawing import draw_train, member_side
from gearwright.render.schematic.layout import Layout, lay_out
from gearwright.render.style import theme
from gearwright.render.style.theme import WIDTH
from gearwright.render.vector.axes import Axes
from gearwright.render.vector.figure import Figure
from gearwright.render.vector.marks import circle
from gearwright.sizing import Sizing, planet_positions
from gearwright.spec import GROUND
from gearwright.train import attachments

LARGEST_DOT = 190.0
"""Area of a dot that holds all of a mode's kinetic energy [pt²]."""
SHOWN = 0.5
"""Largest displacement from the front, over the radius of a planet [-]."""
STILL = 0.01
"""Displacement on paper over the radius of a planet below which a body is drawn as standing still [-]."""
QUIET = 1e-3
"""Share of the kinetic energy below which a body counts as still [-]."""


@theme.drawn
def drawn_modes_figure(sizing: Sizing, system: System, modes: Modes, *, numbers: Sequence[int]) -> Figure:
    """Return some modes on the skeleton of the train and, beside it, on its planetary sets from the front.

    Args:
        sizing: As sized.
        system: Assembled from it.
        modes: Of that.
        numbers: Modes, counted from 1 as the table of modes does.
    """
    sets = list(sizing.design.planetaries)
    layout = lay_out(sizing.train, sizing.gears, {machine.name: machine.kind for machine in sizing.machines})
    figure = theme.sheet(WIDTH, 12.0 + 50.0 * len(numbers))
    grid = figure.grid(len(numbers), 1 + len(sets), widths=[2.2, *[1.0] * len(sets)])
    for row, number in zip(grid, numbers, strict=True):
        motion = _Motion(system, modes, number - 1)
        scale = _scale(sizing, motion)
        _draw_skeleton(row[0], sizing, layout, motion)
        row[0].set_title(f"{number}:  {modes.frequency[number - 1]:.4g} Hz")
        for axes, name in zip(row[1:], sets, strict=True):
            _draw_front(axes, sizing, name, motion=motion, scale=scale)
            axes.set_title(name, fontsize=7.5, weight="normal")
    figure.caption = "dots: kinetic energy of rotation; blue and orange: the two senses; sets: common scale"
    return figure


@dataclass(frozen=True)
class _Motion:
    """One mode shape, by name."""

    system: System
    modes: Modes
    place: int

    def of(self, name: str) -> float:
        """Return the displacement of a coordinate, zero where there is none."""
        names = self.system.labels.coordinates
        return float(self.modes.shapes[names.index(name), self.place]) if name in names else 0.0

    def share(self, name: str) -> float:
        """Return a coordinate's share of the kinetic energy [-]."""
        names = self.system.labels.coordinates
        mass = self.system.arrays.mass[names.index(name)] if name in names else 0.0
        return float(mass * self.of(name) ** 2)


def _draw_skeleton(axes: Axes, sizing: Sizing, layout: Layout, motion: _Motion) -> None:
    """Draw a dot on every body that turns: area by kinetic energy, colour by sense."""
    axes.set_axis_off()
    axes.set_aspect("box")
    draw_train(axes, sizing.train, layout, kinds={machine.name: machine.kind for machine in sizing.machines})
    for name, x, y in _spots(sizing, layout):
        share = motion.share(name)
        if share > QUIET:
            colour = theme.BLUE if motion.of(name) > 0.0 else theme.ORANGE
            axes.scatter([x], [y], s=max(LARGEST_DOT * share, 5.0), color=colour, alpha=0.8, lw=0.0, zorder=9)


def _spots(sizing: Sizing, layout: Layout) -> Iterator[tuple[str, float, float]]:
    """Yield body, x and y of everything that turns [mm]; of planets the first above and the second below the axis."""
    for machine in sizing.machines:
        yield machine.name, layout.places[machine.name].x, layout.heights[machine.shaft]
    for stage, planetary in sizing.design.planetaries.items():
        x, radii = layout.places[stage].x, _radii(sizing, stage)
        shaft = next(member for member in (planetary.sun, planetary.carrier, planetary.ring) if member != GROUND)
        y, centre = layout.heights[shaft], (radii[Role.SUN] + radii[Role.PLANET]) * layout.scale
        yield str(gear_part(stage, Role.SUN)), x, y
        yield str(gear_part(stage, Role.PLANET, number=1)), x, y + centre
        yield str(gear_part(stage, Role.PLANET, number=2)), x, y - centre
        yield str(carrier_part(stage)), x + _arm(sizing, layout, stage), y + 0.5 * centre
        yield str(gear_part(stage, Role.RING)), x, y + radii[Role.RING] * layout.scale
    for gear in sizing.gears:
        for shaft in gear.shafts if gear.role in SIDES else ():
            yield str(gear.body(shaft)), layout.places[gear.stage].x, layout.heights[shaft]


def _arm(sizing: Sizing, layout: Layout, stage: str) -> float:
    """Return where the carrier's arm stands beside its planets [mm]."""
    width = max(layout.outlines[sizing.train.gear_of(stage, Role.SUN).name].width * layout.scale, glyphs.LEAST_WIDTH)
    seats = [seat for seat in attachments(sizing.train) if seat.stage == stage and seat.member is Kind.CARRIER]
    side = member_side(seats[0], layout) if seats and seats[0].shaft != GROUND else 1.0
    return side * (0.5 * width + 2.5)


def _radii(sizing: Sizing, stage: str) -> Mapping[Role, float]:
    return {gear.role: 0.5 * gear.pitch_diameter for gear in sizing.gears if gear.stage == stage}


def _scale(sizing: Sizing, motion: _Motion) -> float:
    """Return paper over motion for all planetary sets of a mode; zero if they stand still."""
    sets = [(_radii(sizing, stage), stage) for stage in sizing.design.planetaries]
    largest = max((disc.reach for radii, stage in sets for disc in _discs(sizing, stage, radii, motion)), default=0.0)
    labels = motion.system.labels
    owned = zip(labels.coordinates, labels.coordinate_owners, strict=True)
    energy = sum(motion.share(name) for name, owner in owned if _stage(owner) in sizing.design.planetaries)
    return SHOWN * min(radii[Role.PLANET] for radii, _ in sets) / largest if energy > QUIET else 0.0


def _stage(owner: Owner) -> str:
    """Return the stage that a coordinate belongs to; empty for what belongs to none."""
    return owner.part.name if owner.part is not None and owner.part.kind in (Kind.GEAR, Kind.CARRIER) else ""


class _Disc(NamedTuple):
    """A gear of a planetary set from the front, and how a mode moves it."""

    centre: tuple[float, float]
    """(x, y) at rest [m]."""
    shift: tuple[float, float]
    """Displacement of the centre in the mode's own scale."""
    radius: float
    """[m]"""
    turn: float
    """Rotation in the mode's own scale."""

    @property
    def reach(self) -> float:
        """Largest displacement, of the centre or the rim."""
        return max(math.hypot(*self.shift), self.radius * abs(self.turn))


def _draw_front(axes: Axes, sizing: Sizing, stage: str, *, motion: _Motion, scale: float) -> None:
    """Draw a planetary set from the front, at rest in grey and displaced in colour."""
    axes.set_axis_off()
    axes.set_aspect("box")
    radii = _radii(sizing, stage)
    for disc in _discs(sizing, stage, radii, motion):
        moved = _Disc(
            (disc.centre[0] + scale * disc.shift[0], disc.centre[1] + scale * disc.shift[1]),
            (0.0, 0.0), disc.radius, scale * disc.turn,
        )  # fmt: skip
        still = scale * disc.reach < STILL * radii[Role.PLANET]
        colour = theme.MUTED if still else theme.BLUE if disc.turn >= 0.0 else theme.ORANGE
        _draw_disc(axes, disc._replace(turn=0.0), theme.HAIR)
        _draw_disc(axes, moved, colour)
    reach = 1.25 * radii[Role.RING]
    axes.set(xlim=(-reach, reach), ylim=(-reach, reach))


def _draw_disc(axes: Axes, disc: _Disc, colour: str) -> None:
    """Draw a circle with a spoke that points up when it is not turned."""
    (x, y), radius = disc.centre, disc.radius
    axes.shape(circle(disc.centre, 2.0 * radius, 2.0 * radius), cubic=True, ec=colour, lw=1.0)
    tip = (x - radius * math.sin(disc.turn), y + radius * math.cos(disc.turn))
    axes.plot([x, tip[0]], [y, tip[1]], color=colour, lw=1.0)


def _arm_of(sizing: Sizing, stage: str) -> float:
    """Return how far the planets stand from the middle [m]."""
    return next(carrier.radius for carrier in sizing.carriers if carrier.stage == stage)


def _discs(sizing: Sizing, stage: str, radii: Mapping[Role, float], motion: _Motion) -> Iterator[_Disc]:
    for role in (Role.RING, Role.SUN):
        name = str(gear_part(stage, role))
        yield _Disc((0.0, 0.0), (motion.of(f"{name}.x"), motion.of(f"{name}.y")), radii[role], motion.of(name))
    arm, carrier = _arm_of(sizing, stage), motion.of(str(carrier_part(stage)))
    for k, angle in enumerate(planet_positions(sizing.design, stage, sizing.teeth), start=1):
        planet, cosine, sine = gear_part(stage, Role.PLANET, number=k), math.cos(angle), math.sin(angle)
        # Rotating bearings only: the planet's centre goes where its pin goes.
        along = motion.of(f"{planet}.tangential") or arm * carrier
        out = motion.of(f"{planet}.radial")
        shift = (out * cosine - along * sine, out * sine + along * cosine)
        yield _Disc((arm * cosine, arm * sine), shift, radii[Role.PLANET], motion.of(str(planet)))
