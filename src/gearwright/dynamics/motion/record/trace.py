"""Trace: what a simulated system did, labelled and with units; it does not draw itself."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any, NamedTuple

import numpy as np

from gearwright.arrays import Complexes, Floats, Ints
from gearwright.dynamics.equations import Work
from gearwright.dynamics.model import Labels, System, Tone
from gearwright.dynamics.motion.record.labelled import dataset, line_columns
from gearwright.errors import DesignError, Problem, near
from gearwright.showing import Shown, frame


def index_of(name: str, names: Sequence[str], what: str) -> int:
    """Return the place of a name.

    Args:
        name: What was asked for.
        names: What there is.
        what: ``"line"``, ``"coordinate"`` or ``"drive"``, for the message.

    Raises:
        DesignError: If there is no such name; with the nearest one.
    """
    if name not in names:
        raise DesignError([Problem(f"outputs.{name}", f"no such {what}; {near(name, names)}")])
    return names.index(name)


def line_numbers(system: System, names: Sequence[str]) -> Ints:
    """Return the places of lines in the arrays.

    Args:
        system: Where they are looked up.
        names: Of parallel lines.
    """
    return np.array([index_of(name, system.labels.lines, "line") for name in names], dtype=np.int64)


@dataclass(frozen=True, eq=False, repr=False)
class Samples(Shown):
    """The state at some instants."""

    time: Floats
    """[s], shape (instants,)."""
    position: Floats
    """q, from the rigid motion [rad or m], shape (instants, coordinates)."""
    velocity: Floats
    """q̇ [rad/s or m/s], shape (instants, coordinates)."""
    line_force: Floats
    """Line forces, elastic and damping [N or N m], shape (instants, lines)."""
    line_deflection: Floats
    """Line deflections δ [m or rad], shape (instants, lines): for a mesh the dynamic transmission error."""
    labels: Labels
    """Names and units."""
    drives: Floats
    """States of the drives, then torque, speed and flag of each, shape (instants, numbers)."""

    def drive(self, name: str) -> Floats:
        """Return what is recorded of a drive, such as ``"propeller pitch"``, shape (instants,).

        Args:
            name: One of `Labels.drives`.
        """
        return self.drives[:, index_of(name, self.labels.drives, "drive")]

    def force(self, line: str) -> Floats:
        """Return the force of a line, or the torque of a shaft [N or N m], shape (instants,).

        Args:
            line: Its name.
        """
        return self.line_force[:, index_of(line, self.labels.lines, "line")]

    def deflection(self, line: str) -> Floats:
        """Return the deflection of a line [m or rad], shape (instants,).

        Args:
            line: Its name.
        """
        return self.line_deflection[:, index_of(line, self.labels.lines, "line")]

    def to_xarray(self) -> Any:
        """Return an xarray ``Dataset``: force [N] by ``line``, torque [N m] by ``shaft``, and all else."""
        return dataset(self)

    def to_dataframe(self) -> Any:
        """Return a pandas ``DataFrame``: the load of every line over time, units in ``attrs["units"]``."""
        return frame(line_columns(self), "time")

    def motion(self, coordinate: str) -> Floats:
        """Return a coordinate, measured from the rigid motion [rad or m], shape (instants,).

        Args:
            coordinate: Its name.
        """
        return self.position[:, index_of(coordinate, self.labels.coordinates, "coordinate")]


class Extent(NamedTuple):
    """Statistics of one quantity over all time bins, in the unit of the quantity."""

    mean: float
    minimum: float
    maximum: float
    rms: float
    """Root mean square of the value itself."""


@dataclass(frozen=True, eq=False, repr=False)
class Statistics(Shown):
    """Mean, least, greatest and root mean square of one quantity in each time bin, from every step of the run."""

    names: tuple[str, ...]
    """Lines or coordinates."""
    what: str
    """``"line"``, ``"coordinate"`` or ``"drive"``."""
    edges: Floats
    """Bin edges [s], shape (bins + 1,)."""
    mean: Floats
    """Shape (bins, names)."""
    minimum: Floats
    """Shape (bins, names)."""
    maximum: Floats
    """Shape (bins, names)."""
    rms: Floats
    """Root mean square of the value itself, shape (bins, names)."""

    @property
    def bins(self) -> int:
        """Time bins: none if the run was interrupted before the time from which statistics look."""
        return len(self.edges) - 1

    def of(self, name: str) -> dict[str, Floats]:
        """Return mean, least, most and rms of one line or coordinate, shape (bins,) each.

        Args:
            name: Its name.
        """
        column = index_of(name, self.names, self.what)
        return {key: getattr(self, key)[:, column] for key in ("mean", "minimum", "maximum", "rms")}

    def whole(self, name: str) -> Extent:
        """Return one line or coordinate over all bins together.

        Args:
            name: Its name.
        """
        of, weights = self.of(name), np.diff(self.edges) / np.sum(np.diff(self.edges))
        return Extent(float(weights @ of["mean"]), float(np.min(of["minimum"])), float(np.max(of["maximum"])),
                      float(np.sqrt(weights @ of["rms"] ** 2)))  # fmt: skip


@dataclass(frozen=True, eq=False, repr=False)
class Orders(Shown):
    """Complex amplitudes of line forces at every turning tone: the real part times e^(iφ) is the tone's share."""

    names: tuple[str, ...]
    """Lines."""
    tones: tuple[Tone, ...]
    """Which angle each tone is."""
    edges: Floats
    """Bin edges [s], shape (bins + 1,)."""
    amplitude: Complexes
    """Peak amplitudes [N or N m], shape (bins, lines, tones)."""

    def of(self, line: str) -> Complexes:
        """Return the amplitudes of one line's force [N or N m], shape (bins, tones).

        Args:
            line: Its name.
        """
        return self.amplitude[:, index_of(line, self.names, "line")]


@dataclass(frozen=True, eq=False, repr=False)
class Checkpoints(Shown):
    """States from which any part of the run can be repeated bit for bit."""

    step: Ints
    """Steps at which the states were kept, shape (checkpoints,)."""
    state: Floats
    """q, q̇ and works, shape (checkpoints, states)."""


@dataclass(frozen=True, eq=False, repr=False)
class Trace(Shown):
    """A simulated stretch of time."""

    method: str
    """Method that was used."""
    step: float
    """Time step; of adaptive methods the spacing of the instants that statistics and windows look at [s]."""
    duration: float
    """Time that was simulated [s]: less than asked if it was interrupted."""
    error: float
    """Measured error of the peaks of line forces over them, beside the whole run at another step [-]."""
    work: Work
    """Energy balance."""
    samples: Samples
    """Evenly spaced instants over the whole run."""
    windows: tuple[Samples, ...]
    """Every step of the windows that were asked for."""
    force: Statistics
    """Of line forces [N or N m]."""
    deflection: Statistics
    """Of line deflections [m or rad]."""
    velocity: Statistics
    """Of q̇ [rad/s or m/s]."""
    checkpoints: Checkpoints
    """States for `replay`."""
    notes: tuple[str, ...]
    """What a reader must know: contact losses with line and time, interruption."""
    labels: Labels
    """Names and units."""
    tolerance: float = 0.0
    """Root of the energy that the error of one adaptive step might hold; 0 for fixed steps [√J]."""
    orders: Orders | None = None
    """Amplitudes of line forces at the tones, if they were asked for."""
    drive: Statistics | None = None
    """Of what is recorded of drives; None without drives."""
    rms_error: float = 0.0
    """Measured error of the root mean squares of line forces over them [-]."""
    interrupted: bool = False
    """Whether the user stopped the run before its end."""
    exponent: float | None = None
    """Largest Lyapunov exponent where teeth part, about: positive, the motion is chaotic; None where none do [1/s]."""

    def to_xarray(self) -> Any:
        """Return the samples of the whole run as an xarray ``Dataset``, as `Samples.to_xarray`."""
        return self.samples.to_xarray()

    def to_dataframe(self) -> Any:
        """Return the samples of the whole run as a pandas ``DataFrame``, as `Samples.to_dataframe`."""
        return self.samples.to_dataframe()

    def whole(self) -> Trace:
        """Return the run, for what needs all of it.

        Raises:
            KeyboardInterrupt: If it was interrupted, as if the run had not kept what was done so far.
        """
        if self.interrupted:
            raise KeyboardInterrupt
        return self
