"""The order on an axis against all permutations of what stands there, with the rules written a second time."""

from itertools import combinations, permutations

import pytest

from gearwright.shipped import shipped_design
from gearwright.sizing.arrangement import axles_in
from gearwright.sizing.axis_order import best_way
from gearwright.sizing.rating import Context
from gearwright.spec import read
from gearwright.train import build_train


def axle_of(name):
    """Return what stands on the axis of a shipped design's sets; the order reads only the design and its train."""
    design = read(shipped_design(name))
    context = object.__new__(Context)
    object.__setattr__(context, "design", design)
    object.__setattr__(context, "train", build_train(design))
    (axle,) = [axle for axle in axles_in(context) if any(token.kind == "set" for token in axle.tokens)]
    return axle


def spans(axle, order):
    """Return shaft -> first and last place in the order on which it has something."""
    at = {}
    for place, k in enumerate(order):
        for shaft in axle.tokens[k].shafts:
            at.setdefault(shaft, []).append(place)
    return {shaft: (min(places), max(places)) for shaft, places in at.items()}


def relations(axle, order):
    """Return pairs (inner, outer) that an order asks for, or None where a shaft has no way; no planes, no links."""
    reach, asked = spans(axle, order), set()
    for place, k in enumerate(order):
        token = axle.tokens[k]
        passing = [s for s, (low, high) in reach.items() if low < place < high and s not in token.shafts]
        if token.kind != "set":
            asked |= {(inner, token.shafts[0]) for inner in passing}
            continue
        layer = {member.shaft: member.layer for member in token.members}
        for side in (-1, 1):
            leaving = [s for s in token.shafts if (reach[s][0] < place if side < 0 else reach[s][1] > place)]
            asked |= {(a, b) for a in leaving for b in leaving if layer[a] < layer[b]}
            asked |= {(p, s) for p in passing for s in leaving}
    return asked


def holds(axle, order):
    """Tell whether what an order asks for contradicts itself where shafts lie beside each other."""
    asked = relations(axle, order)
    if any((outer, inner) in asked for inner, outer in asked):
        return False
    reach, closed = spans(axle, order), set(asked)
    overlap = [
        pair for pair in combinations(reach, 2)
        if min(reach[pair[0]][1], reach[pair[1]][1]) > max(reach[pair[0]][0], reach[pair[1]][0])
    ]  # fmt: skip
    # Some layering of all shafts must agree with every pair, restricted to shafts that lie in each other.
    shafts = sorted({shaft for pair in overlap for shaft in pair} | {shaft for pair in closed for shaft in pair})
    return any(all(order.index(a) < order.index(b) for a, b in closed) for order in permutations(shafts))


def stretches(axle, order):
    """Return how many stretches of shaft an order needs."""
    return sum(high - low for low, high in spans(axle, order).values())


@pytest.mark.parametrize("name", ["in-line-h2", "in-line-h2-star", "contra-rotating-propellers", "differential-hybrid"])
def test_no_permutation_that_holds_has_fewer_stretches(name):
    """All orders of at most six tokens; machines with something through them count first."""
    axle = axle_of(name)
    way = best_way(axle)
    turbines = [k for k, token in enumerate(axle.tokens) if token.kind == "machine"]

    def cost(order):
        reach = spans(axle, order)
        through = sum(
            low < place < high
            for place, k in enumerate(order) if k in turbines
            for shaft, (low, high) in reach.items() if shaft not in axle.tokens[k].shafts
        )  # fmt: skip
        sides = sum(
            reach[member.shaft][0] < place < reach[member.shaft][1]
            for place, k in enumerate(order) for member in axle.tokens[k].members if member.layer == 1
        )  # fmt: skip
        return through, sides, stretches(axle, order)

    fits = [order for order in permutations(range(len(axle.tokens))) if holds(axle, order)]
    assert way is not None and holds(axle, way.order)
    assert cost(way.order) == min(map(cost, fits))
    assert len(fits) < len(list(permutations(range(len(axle.tokens)))))
