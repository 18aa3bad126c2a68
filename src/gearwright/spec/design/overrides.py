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
        keys = _keys(path, dimension)
        self.offered |= set(keys)
        written = [key for key in keys if key in self.given]
        if not written:
            return computed
        if len(written) > 1:
            self.twice.append(Problem(f"overrides.{written[1]}", f"{path} is given twice; keep one of {written}"))
        self.used[path] = self.given[written[0]] * keys[written[0]]
        self.origins[path] = self.sources.get(written[0], NO_ORIGIN)
        return self.used[path]

    def gives(self, path: str, dimension: str) -> bool:
        """Tell whether the user gives a value, which need not have been taken yet.

        Args:
            path: Such as ``first.module``.
            dimension: Of the value.
        """
        return not self.given.keys().isdisjoint(_keys(path, dimension))

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


def _keys(path: str, dimension: str) -> dict[str, float]:
    """Return every key under which a value may be given, with its unit in SI."""
    if dimension not in SUFFIXES:
        return {path: 1.0}
    return {f"{path}_{suffix}": factor for suffix, factor in SUFFIXES[dimension].items()}
