"""The numbers behind the thesis's claims on mass, one function for each, in the units that are shown."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from types import MappingProxyType

from gearwright.catalogue import engines
from gearwright.replays.pulvirenti.runs import NDARC, THESIS, Computed, by_laws, hybrids, in_line_h2, off_set, sized

SLOW, BEST, MIDDLE, FAST = 3500, 4100, 4500, 5500
"""Motor speeds of In-Line H2 that the claims are about [rpm]."""
_SLOW_PAIR = (("h2", 10000), ("h2", 5000))
_FAST_PAIR = (("h1", 20000), ("h1", 10000))
"""The four points of figure 2.30: Off-Set hybrid and motor speed [rpm]."""


def _percent(new: float, old: float) -> float:
    return 100.0 * (new / old - 1.0)


def _in_line_lightest() -> Computed:
    kg = {name.replace("-", "_"): sized(name).mass for name in ("in-line", "mixed", "off-set")}
    return Computed(min(kg["mixed"], kg["off_set"]) / kg["in_line"], numbers=kg)


def _h3_heaviest() -> Computed:
    kg = {name: sized(f"off-set-{name}").mass for name in ("h1", "h2", "h3")}
    return Computed(kg["h3"] / max(kg["h1"], kg["h2"]), numbers=kg)


def _conventional_density() -> Computed:
    sizing = sized("off-set")
    return Computed(sizing.power_density / 1e3, numbers={"mass": sizing.mass})


def _hybrid_density() -> Computed:
    sizing = sized("in-line-h2")
    power = sizing.power_density * sizing.mass / 1e3
    mass = {law: in_line_h2(law)[MIDDLE] for law in (THESIS, NDARC)}
    return by_laws(
        lambda law: power / mass[law].total,
        {
            "gearbox": sizing.mass,
            "needed": power / 18.0 - sizing.mass,
            "thesis": mass[THESIS].motor,
            "ndarc": mass[NDARC].motor,
        },
    )


def _in_line_h2_best() -> Computed:
    def ratio(law: str) -> float:
        of = hybrids(law)
        return min(kg.total for name, kg in of.items() if name != "in-line-h2") / of["in-line-h2"].total

    by_thesis, by_ndarc = hybrids(THESIS), hybrids(NDARC)
    return by_laws(
        ratio,
        {
            "h1": by_thesis["in-line-h1"].total,
            "h2": by_thesis["in-line-h2"].total,
            "h1_ndarc": by_ndarc["in-line-h1"].total,
            "h2_ndarc": by_ndarc["in-line-h2"].total,
            "quick": by_ndarc["in-line-h1"].motor,
            "slow": by_ndarc["in-line-h2"].motor,
        },
    )


def _optimum_speed() -> Computed:
    def best(law: str) -> int:
        of = in_line_h2(law)
        return min(of, key=lambda speed: of[speed].total)

    by_thesis, by_ndarc = in_line_h2(THESIS), in_line_h2(NDARC)
    flat = [speed for speed, kg in by_thesis.items() if kg.total <= 1.03 * by_thesis[best(THESIS)].total]
    gain = by_ndarc[SLOW].motor - by_ndarc[FAST].motor
    return by_laws(best, {"flat_from": min(flat), "flat_to": max(flat), "motor_gain": gain})


def _in_line_heavier(new: int, old: int = MIDDLE) -> Computed:
    gearbox = in_line_h2(THESIS)
    return by_laws(
        lambda law: _percent(in_line_h2(law)[new].total, in_line_h2(law)[old].total),
        {"gearbox": _percent(gearbox[new].gearbox, gearbox[old].gearbox)},
    )


def _optimum_gain() -> Computed:
    """Return by how much density falls from 4100 to 4500 rpm; the power is one, so masses suffice."""
    gearbox = in_line_h2(THESIS)
    return by_laws(
        lambda law: -_percent(in_line_h2(law)[BEST].total, in_line_h2(law)[MIDDLE].total),
        {"gearbox": -_percent(gearbox[BEST].gearbox, gearbox[MIDDLE].gearbox)},
    )


def _motor_flat() -> Computed:
    return by_laws(
        lambda law: in_line_h2(law)[FAST].motor / in_line_h2(law)[SLOW].motor, {"torque": 100.0 * SLOW / FAST}
    )


def _motor_share() -> Computed:
    kg = {law: in_line_h2(law)[MIDDLE] for law in (THESIS, NDARC)}
    return by_laws(
        lambda law: 100.0 * kg[law].motor / kg[law].total, {"thesis": kg[THESIS].motor, "ndarc": kg[NDARC].motor}
    )


def _h2_slow_heavier() -> Computed:
    slow, fast = (off_set(THESIS)["h2", speed].gearbox for speed in (5000, 10000))
    return by_laws(
        lambda law: _percent(off_set(law)["h2", 5000].total, off_set(law)["h2", 10000].total),
        {"gearbox": _percent(slow, fast), "slow": slow, "fast": fast},
    )


def _off_set_slow_heavier() -> Computed:
    of = off_set(THESIS)
    gearbox = _percent(sum(of[point].gearbox for point in _SLOW_PAIR), sum(of[point].gearbox for point in _FAST_PAIR))

    def heavier(law: str) -> float:
        slow, fast = (sum(off_set(law)[point].total for point in pair) for pair in (_SLOW_PAIR, _FAST_PAIR))
        return _percent(slow, fast)

    return by_laws(heavier, {"gearbox": gearbox})


def _off_set_faster() -> Computed:
    def h1(law: str) -> float:
        return off_set(law)["h1", 20000].total / off_set(law)["h1", 10000].total

    def h2(law: str) -> float:
        return off_set(law)["h2", 10000].total / off_set(law)["h2", 5000].total

    heaviest = off_set(THESIS)["h2", 20000].gearbox
    return by_laws(lambda law: max(h1(law), h2(law)), {"h1": h1(THESIS), "h2": h2(THESIS), "h2_fast": heaviest})


def _h1_best() -> Computed:
    def ratio(law: str) -> float:
        best, *others = (off_set(law)[point].total for point in (*_FAST_PAIR, *_SLOW_PAIR))
        return min(others) / best

    of = off_set(THESIS)
    return by_laws(ratio, {"h1": of["h1", 20000].total, "h2": of["h2", 5000].total})


def _pt6t_densest() -> Computed:
    def printed(column: str) -> dict[tuple[str, str], float]:
        digits_by_engine = {
            (engine.series.name, engine.model): engine.as_meant(column) for engine in engines() if engine.has_gearbox
        }
        return {key: digits.value for key, digits in digits_by_engine.items() if digits is not None}

    density, torque = printed("gearbox_kw_kg"), printed("torque_nm_kg")
    pt6t = {key for key in density if key[0].startswith("PT6T")}
    best, mine = (max(value for key, value in density.items() if (key in pt6t) is mine) for mine in (False, True))
    lowest = {"torque": min(torque[key] for key in pt6t), "lowest": min(torque.values())}
    return Computed(mine / best, numbers={"density": best, "own": mine, **lowest})


MASS_CLAIMS: Mapping[str, Callable[[], Computed]] = MappingProxyType({
    "in-line-lightest": _in_line_lightest,
    "off-set-h3-heaviest": _h3_heaviest,
    "conventional-density": _conventional_density,
    "hybrid-density": _hybrid_density,
    "in-line-h2-best": _in_line_h2_best,
    "optimum-speed": _optimum_speed,
    "fast-heavier": lambda: _in_line_heavier(FAST),
    "slow-heavier": lambda: _in_line_heavier(SLOW),
    "optimum-gain": _optimum_gain,
    "motor-mass-flat": _motor_flat,
    "motor-share": _motor_share,
    "off-set-h2-slow-heavier": _h2_slow_heavier,
    "off-set-slow-heavier": _off_set_slow_heavier,
    "off-set-faster-lighter": _off_set_faster,
    "off-set-h1-best": _h1_best,
    "pt6t-densest": _pt6t_densest,
})  # fmt: skip
"""Key of a claim -> what computes it."""
