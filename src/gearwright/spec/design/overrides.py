"""Computed values that the user gives instead, and which of them were taken."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field

from gearwright.errors import DesignError, Problem, near
from gearwright.units import SUFFIXES

NO_ORIGIN = "user's design file"
"""Origin of a value that the user gave without saying where it comes from."""


@dataclass
class Overrides:
    """Hands out the user's value where there is one, and remembers what was asked for."""

    given: Mapping[str, float]
    """As in the design file: dotted path with unit -> value."""
    sources: Mapping[str, str] = field(default_factory=dict)
    """Dotted path with unit -> where the user has the value from."""
    used: dict[str, float] = field(default_factory=dict)
    """Path without unit -> value that was taken [SI]."""
    origins: dict[str, str] = field(default_factory=dict)
    """Path without unit -> where the value that was taken comes from."""
    offered: set[str] = field(default_factory=set)
    """Every key that would have been taken."""
    twice: list[Problem] = field(default_factory=list)
    """Values that are given in several units."""

    def take(self, path: str, dimension: str, computed: float) -> float:
        """Return the user's value for a path, or the computed one.

        Args:
            path: Such as ``first.module``.
            dimension: Of the value; ``ratio`` has no unit in the key.
            computed: In SI.
        """
        if not self.given:
            return computed
        keys = {path: 1.0} if dimension not in SUFFIXES else {
            f"{path}_{suffix}": factor for suffix, factor in SUFFIXES[dimension].items()
        }  # fmt: skip
        self.offered |= set(keys)
        written = [key for key in keys if key in self.given]
        if not written:
            return computed
        if len(written) > 1:
            self.twice.append(Problem(f"overrides.{written[1]}", f"{path} is given twice; keep one of {written}"))
        self.used[path] = self.given[written[0]] * keys[written[0]]
        self.origins[path] = self.sources.get(written[0], NO_ORIGIN)
        return self.used[path]

    def require_all_used(self) -> None:
        """Raise for every override that no computed value has taken, or that is given twice.

        Raises:
            DesignError: With the nearest path.
        """
        unknown = [
            Problem(f"overrides.{key}", f"nothing of this name is computed; {near(key, self.offered)}")
            for key in self.given
            if key not in self.offered
        ]
        if unknown or self.twice:
            raise DesignError([*unknown, *self.twice])
