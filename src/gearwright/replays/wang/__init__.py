"""The paper on load sharing in a face-gear split-torque transmission, its claims held against gearwright.

A client of the public verbs; nothing in the engine knows it.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from gearwright.replays.replay import Replay, register

if TYPE_CHECKING:
    from gearwright.render.pages.motion import Paper
    from gearwright.sizing import Sizing


def _paper(sizing: Sizing) -> Paper | None:
    from gearwright.replays.wang.claims import paper

    return paper(sizing)


register(
    Replay(
        "wang",
        "Wang, Zhao, Tao, Jia & Guo, load sharing of a face-gear split torque with a floating shaft (paper)",
        _paper,
    )
)
