"""Model: bodies, lines and loads by name; `build` checks them all and gives the flat `System`.

>>> model = Model()
>>> motor, wheel = model.rotation("motor", inertia=211.4), model.rotation("wheel", inertia=8.3)
>>> model.shaft("shaft", motor, wheel, stiffness=9.775e6)
>>> print(model.build())
System: 2 coordinates, 1 lines, 0 tones
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field

from gearwright.dynamics.model.drives import Drive
from gearwright.dynamics.model.flatten import flatten
from gearwright.dynamics.model.line import DampingRatio, Line, Periodic
from gearwright.dynamics.model.system import NOBODY, Owner, System
from gearwright.dynamics.model.written import Body, Following, Load, Order, Pair, Written


@dataclass
class Model:
    """A drive train while it is being written down. Problems are reported by `build`, all at once."""

    bodies: list[Body] = field(default_factory=list)
    """Coordinates in the order in which they were added."""
    lines: list[Line] = field(default_factory=list)
    """Lines in the order in which they were added."""
    loads: list[Load] = field(default_factory=list)
    """Loads; several on one coordinate add up."""
    pairs: list[Pair] = field(default_factory=list)
    """Gyroscopic and centripetal terms."""
    profile: Sequence[tuple[float, float]] = ((0.0, 1.0),)
    """Speed factor: (time [s], factor [-])."""
    drives: list[Drive] = field(default_factory=list)
    """Propellers, machines and slipping clutches."""
    orders: list[Order] = field(default_factory=list)
    """Excitations that no line makes."""
    follows: list[Following] = field(default_factory=list)
    """Unsymmetric terms of bearings."""

    def rotation(self, name: str, *, inertia: float, speed: float | None = None, owner: Owner = NOBODY) -> str:
        """Add a rotation θ and return its name.

        Args:
            name: Unique name.
            inertia: Polar mass moment of inertia [kg m²].
            speed: Reference speed [rad/s]; left out, it follows from the lines and the speeds that are given.
            owner: Whose it is.
        """
        self.bodies.append(Body(name, inertia, "rad", speed, owner))
        return name

    def translation(self, name: str, *, mass: float, owner: Owner = NOBODY) -> str:
        """Add a translation and return its name.

        Args:
            name: Unique name, such as ``"sun.x"``.
            mass: Mass that moves [kg].
            owner: Whose it is, and the direction.
        """
        self.bodies.append(Body(name, mass, "m", 0.0, owner))
        return name

    def add(self, line: Line) -> None:
        """Add any line.

        Args:
            line: Weights, stiffness and the rest.
        """
        self.lines.append(line)

    def mesh(
        self,
        name: str,
        weights: Mapping[str, float],
        *,
        stiffness: float,
        damping: float | DampingRatio = 0.0,
        backlash: float = 0.0,
        variation: Periodic | None = None,
        errors: Sequence[Periodic] = (),
        owner: Owner = NOBODY,
    ) -> None:
        """Add a gear mesh: one line along its line of action.

        Args:
            name: Unique name.
            weights: Coordinate -> signed base radius [m/rad], or direction cosine of a translation [-].
            stiffness: Mean mesh stiffness [N/m].
            damping: c [N s/m] or a `DampingRatio`.
            backlash: Along the line of action [m]; 0 keeps the teeth in contact both ways.
            variation: Stiffness over its mean, less 1, in the mesh phase.
            errors: Errors along the line of action [m].
            owner: Whose it is.
        """
        self.lines.append(Line(name, weights, stiffness, damping, backlash, variation, tuple(errors), "mesh", owner))

    def shaft(
        self,
        name: str,
        first: str,
        second: str,
        *,
        stiffness: float,
        damping: float | DampingRatio = 0.0,
        owner: Owner = NOBODY,
    ) -> None:
        """Add a torsional shaft, spline or key: its torque is positive if `first` leads.

        Args:
            name: Unique name.
            first: Rotation at one end.
            second: Rotation at the other.
            stiffness: Torsional stiffness [N m/rad].
            damping: c [N m s/rad] or a `DampingRatio`.
            owner: Shaft, machine or clutch.
        """
        self.lines.append(Line(name, _between(first, second), stiffness, damping, kind="shaft", owner=owner))

    def damper(self, name: str, first: str, second: str, *, damping: float, owner: Owner = NOBODY) -> None:
        """Add a viscous damper: its torque is c times the speed at which `first` leads, steady slip with it.

        It holds nothing at rest, so that its bodies may turn at different reference speeds.

        Args:
            name: Unique name.
            first: Rotation at one end.
            second: Rotation at the other.
            damping: c [N m s/rad].
            owner: Damper.
        """
        self.lines.append(Line(name, _between(first, second), 0.0, damping, kind="damper", owner=owner))

    def support(
        self,
        name: str,
        body: str,
        *,
        stiffness: float,
        damping: float | DampingRatio = 0.0,
        owner: Owner = NOBODY,
    ) -> None:
        """Hold a coordinate to the housing: a bearing's direction or a torsional anchor.

        Args:
            name: Unique name.
            body: Coordinate that is held.
            stiffness: [N/m or N m/rad].
            damping: c [N s/m or N m s/rad] or a `DampingRatio`.
            owner: Whose it is, and the direction.
        """
        self.lines.append(Line(name, {body: 1.0}, stiffness, damping, kind="support", owner=owner))

    def load(
        self,
        body: str,
        *,
        constant: float = 0.0,
        damping: float = 0.0,
        quadratic: float = 0.0,
        schedule: Sequence[tuple[float, float]] = (),
    ) -> None:
        """Load a coordinate with constant + schedule − damping q̇ − quadratic |θ̇| θ̇.

        Args:
            body: Coordinate that is loaded.
            constant: [N or N m], positive along the coordinate.
            damping: Loss per speed above the reference [N s/m or N m s/rad].
            quadratic: Resistance over speed squared [N m s²/rad²].
            schedule: (time [s], load [N or N m]), joined by straight lines.
        """
        self.loads.append(Load(body, constant, damping, quadratic, tuple(schedule)))

    def drive(self, drive: Drive) -> None:
        """Add a propeller, a machine or a slipping clutch.

        Args:
            drive: A `PropellerDrive`, `MachineDrive` or `ClutchDrive`.
        """
        self.drives.append(drive)

    def order(
        self, name: str, turns: Mapping[str, float], *, on: Sequence[str] = (), why: str = "", owner: Owner = NOBODY
    ) -> None:
        """Add an excitation in proportion to speeds that no line makes: blades, poles, slots, planets that pass.

        It is a ray of the Campbell diagram; what it shakes decides which natural frequencies it excites.

        Args:
            name: Unique name, such as ``"propeller blade pass"``.
            turns: Rotation -> how often it acts in a turn of it [-]; several add up.
            on: Coordinates or lines that it shakes.
            why: Where the multiple is from, such as ``"6 blades"``.
            owner: Whose it is.
        """
        self.orders.append(Order(name, turns, on, why, owner))

    def following(self, x: Mapping[str, float], y: Mapping[str, float], *, stiffness: float, damping: float) -> None:
        """Add what a turning film does to a journal: F_x = −k y − c ẏ, F_y = +k x + c ẋ.

        It is in `campbell` and `frequency_response`; runs and statics, which need a potential, refuse it.

        Args:
            x: Motion along x, by coordinates.
            y: Motion along y.
            stiffness: k = ½ (k_xy − k_yx) [N/m].
            damping: c = ½ (c_xy − c_yx) [N s/m].
        """
        self.follows.append(Following(x, y, stiffness, damping))

    def rotating_frame(self, x: str, y: str, *, speed: float) -> None:
        """Write two translations of one mass in a frame that turns: Coriolis and centripetal terms.

        Args:
            x: First translation.
            y: Second, a quarter turn ahead.
            speed: Of the frame at the reference speeds [rad/s].

        Source: Lin, Parker 1999, J. Vib. Acoust. 121, eq. 3: G = [[0, −2m], [2m, 0]], K_Ω = diag(m, m).
        """
        self.pairs.append(Pair(x, y, speed, None))

    def gyroscopic(self, first: str, second: str, *, moment: float) -> None:
        """Couple two coordinates gyroscopically: the first feels −moment·q̇ of the second, the second +moment·q̇.

        Args:
            first: Coordinate with the term +moment q̇_second on the left of its equation.
            second: Coordinate with the term −moment q̇_first.
            moment: J_p Ω of a rotor that tilts, at the reference speeds [N m s/rad].
        """
        self.pairs.append(Pair(first, second, 0.0, moment))

    def build(self) -> System:
        """Check everything and return the flat system.

        Raises:
            DesignError: With every problem: names, inertias, stiffness, phases, speeds that do not fit together.
        """
        return flatten(
            Written(
                self.bodies,
                self.lines,
                self.loads,
                self.pairs,
                self.profile,
                self.drives,
                self.orders,
                self.follows,
            )
        )


def _between(first: str, second: str) -> dict[str, float]:
    """Return the weights of what joins two rotations; none where they are the same one, which `build` refuses."""
    return {first: 1.0, second: -1.0} if first != second else {first: 0.0}
