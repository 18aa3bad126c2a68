"""Whether equal, evenly spaced compound planets can be put in, and how each turns to fit: cosets of whole teeth.

The set at φ = 2π n/N is the first one turned by φ with the carrier, while suns and rings stay. A planet body turns on
its pin by ψ so that its teeth meet theirs again: z_p ψ ≡ z_c φ for each mesh with a sun or ring (rings negative), and
z_a ψ_a ≡ −z_b ψ_b for two planets, all in whole turns. What ψ may be is a coset: one angle, plus whole parts of a turn.
"""

from __future__ import annotations

import math
from fractions import Fraction
from typing import NamedTuple

from gearwright.parts.planetary.compound import CompoundSet


class Turns(NamedTuple):
    """Angles that a body may have, in turns: ``first`` + k/``parts`` for every whole k; any where ``parts`` is 0."""

    first: Fraction
    parts: int

    def common(self, other: Turns) -> Turns | None:
        """Return what both allow, or None."""
        if not self.parts or not other.parts:
            return other if not self.parts else self
        step = math.lcm(self.parts, other.parts)
        gap = (other.first - self.first) * step
        if gap.denominator != 1:
            return None
        # first + k/parts for the k that hits the other: k (step/parts) ≡ gap (mod step/other.parts)
        left, right = step // self.parts, step // other.parts
        count = int(gap) * pow(left, -1, right) % right if right > 1 else 0
        return Turns(self.first + Fraction(count, self.parts), math.gcd(self.parts, other.parts))

    def seen_by(self, teeth: int, mate: int) -> Turns:
        """Return what a mate of so many teeth may turn where this body meshes with it by some teeth of its own."""
        if not self.parts:
            return self
        fine = self.parts // math.gcd(teeth, self.parts)
        return Turns(-self.first * teeth / mate, fine * mate)


ANY = Turns(Fraction(0), 0)


def fitting_turns(compound: CompoundSet, *, number: int = 1) -> dict[str, Turns] | None:
    """Return body -> how it may turn on its pin in a set, beside the first set; None where it cannot be put in.

    Args:
        compound: Whose meshes make no circle.
        number: Of the set, counted from the first, which is 0.

    Source: integer conditions of whole teeth; of simple planets (z_s + z_r)/N, VDI 2157; of stepped ones the condition
        with the least common multiple, Müller 1998, Die Umlaufgetriebe.
    """
    part = Fraction(number, compound.sets)
    own: dict[str, Turns] = dict.fromkeys(compound.bodies.values(), ANY)
    for central, planet in compound.at_centre:
        body, teeth = compound.bodies[planet], compound.teeth[planet]
        asked = Turns(compound.teeth[central] * part / teeth, teeth)
        both = own[body].common(asked)
        if both is None:
            return None
        own[body] = both
    # A tree of planets settles when each has heard as many times from its mates as there are meshes.
    for _ in compound.between:
        for first, second in (*compound.between, *(pair[::-1] for pair in compound.between)):
            here, there = compound.bodies[first], compound.bodies[second]
            heard = own[there].common(own[here].seen_by(compound.teeth[first], compound.teeth[second]))
            if heard is None:
                return None
            own[there] = heard
    return own


def can_assemble(compound: CompoundSet) -> bool:
    """Tell whether equal, evenly spaced sets of planets can be put in.

    Args:
        compound: The set.

    Source: as `fitting_turns`; what holds from the first set to the second holds on to every other.

    >>> simple = {"s": 18, "r": -54}, {"p": 18}, {"p": "p"}, (("s", "p"), ("p", "r"))
    >>> can_assemble(CompoundSet(4, *simple)), can_assemble(CompoundSet(5, *simple))
    (True, False)
    """
    return fitting_turns(compound) is not None
