"""Words on complete masses beside the statistics of real gearboxes, for designs of one requirement."""

from __future__ import annotations

from gearwright.sizing import Sizing
from gearwright.sizing.mass import band_of, requirement_of
from gearwright.study import Table
from gearwright.units import text

_ROWS = ("complete_mass.low", "complete_mass.high")


def beside_statistics(table: Table, sizing: Sizing) -> str:
    """Return what 61 real gearboxes say of a comparison's power and speeds, and which designs do not meet their band.

    Args:
        table: Of designs with their complete masses.
        sizing: Any of them.
    """
    need = requirement_of(sizing)
    found = None if need is None else band_of(need)
    if found is None or any(name not in table.results for name in _ROWS):
        return ""
    _, low, high = found
    limits = {row.design: [row.number(name) for name in _ROWS] for row in table.good}
    lighter = [name for name, (_, most) in limits.items() if most < low]
    heavier = [name for name, (least, _) in limits.items() if least > high]
    shown = [text(value, "mass", 3) for value in found]
    words = [f"61 real gearboxes: {shown[0]}, 68 % from {shown[1]} to {shown[2]}."]
    if lighter:
        words.append(f"Sums of parts below that: {', '.join(lighter)}; margins below 1 are part of the reason.")
    if heavier:
        words.append(f"Sums of parts above that: {', '.join(heavier)}.")
    return " ".join(words)
