"""The page on validation: published numbers beside those that gearwright computes while the page is made.

Each row names the test that holds it; below the table stand all tests against published numbers, in their own words.
"""

from __future__ import annotations

import ast
import math
import re
from collections import Counter
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from functools import cache
from pathlib import Path

import gearwright as gw
from gearwright.parts.gears import hertz_coefficient
from gearwright.parts.planetary import most_planets
from gearwright.replays.pulvirenti.claims import claims
from gearwright.sizing import Sizing
from gearwright.units import RPM
from gearwright.validate import gears, shafts, shafts as bearings
from gearwright.weights import beta, mass_afdd00, mass_afdd83, mass_tm215680, mass_wate2

TESTS = Path(__file__).parents[1] / "tests"
PW127 = (2051e3, 20204.0 * RPM, 1212.0 * RPM)
"""Power, engine speed and propeller speed of table 1.3 of Pulvirenti (2023)."""


@dataclass(frozen=True)
class Checked:
    """One published number."""

    what: str
    unit: str
    source: str
    expected: float
    tolerance: float
    """Largest allowed difference, in the unit."""
    computed: Callable[[], float]
    test: str
    """File below ``tests``."""


@cache
def _sized(name: str) -> Sizing:
    return gw.size(gw.read(gw.shipped_design(name)))


def _torque(machine: str) -> Callable[[], float]:
    return lambda: abs(_sized("in-line-h2").flows["rated"].machine_torques[machine])


def _claim(key: str) -> Callable[[], float]:
    return lambda: next(one.value for one in claims() if one.printed.key == key)


_SIZING, _OFF_SET = "validation/test_turboprop_sizing.py", "validation/test_off_set_mass.py"
_MASS, _CLAIMS = "validation/test_gearbox_mass_methods.py", "validation/test_thesis_claims.py"
_ERRATA, _THESIS = "verification/test_thesis_errata.py", "Pulvirenti 2023"
_APART = "calculated apart with the corrected equations of Pulvirenti 2023, chapter 2"

CHECKED: Sequence[Checked] = (
    Checked("Off-Set, gears", "kg", _APART, 176.7, 1.8, lambda: _sized("off-set").gear_mass, _OFF_SET),
    Checked("In-Line, gears", "kg", _APART, 40.4, 0.4, lambda: _sized("in-line").gear_mass, _SIZING),
    Checked("In-Line H2, gears", "kg", _APART, 34.0, 0.34, lambda: _sized("in-line-h2").gear_mass, _SIZING),
    Checked("In-Line H2, T_GT", "N m", "P/ω, 1046 kW at 20 000 rpm", 499.4, 0.1, _torque("gas-turbine"), _SIZING),
    Checked("In-Line H2, T_EM", "N m", "P/ω, 1005 kW at 4500 rpm", 2132.7, 0.1, _torque("electric"), _SIZING),
    Checked(
        "Off-Set, power density",
        "kW/kg",
        f"{_THESIS}, chapter 5: as today's turboprops, 10 to 11.5",
        10.75,
        0.75,
        _claim("conventional-density"),
        _CLAIMS,
    ),
    Checked("T_EM/T_GT in cruise", "", f"{_THESIS}, §4.1: about 2", 2.0, 0.2, _claim("torque-motor-turbine"), _CLAIMS),
    Checked(
        "T_c1/T_GT in cruise", "", f"{_THESIS}, §4.1: about 6", 6.0, 0.6, _claim("torque-carrier-turbine"), _CLAIMS
    ),
    Checked(
        "optimum motor speed of In-Line H2",
        "rpm",
        f"{_THESIS}, figure 2.33: around 4100, flat",
        4100.0,
        200.0,
        _claim("optimum-speed"),
        _CLAIMS,
    ),
    Checked("PW127 gearbox by AFDD00", "kg", f"{_THESIS}, table 1.3", 183.5, 0.2, lambda: mass_afdd00(*PW127), _MASS),
    Checked(
        "PW127 gearbox by AFDD83",
        "kg",
        "formula of NASA/TP-2015-218751, calculated apart",
        224.0,
        1.0,
        lambda: mass_afdd83(*PW127),
        _MASS,
    ),
    Checked(
        "PW127 gearbox by WATE-2",
        "kg",
        "NASA TM-83458, calculated apart",
        160.6,
        0.5,
        lambda: mass_wate2(*PW127),
        _MASS,
    ),
    Checked(
        "PW127 gearbox by TM-2009-215680",
        "kg",
        "formula of the figure, calculated apart",
        131.8,
        0.1,
        lambda: mass_tm215680(beta(*PW127)),
        _MASS,
    ),
    Checked(
        "coefficient of line contact, ν = 0.3",
        "",
        "Hertz 1882, 0.418",
        0.418,
        5e-4,
        lambda: hertz_coefficient(0.3),
        _ERRATA,
    ),
    Checked(
        "planets that fit, z_s 18, z_p 27",
        "",
        "geometry: tips clear",
        4.0,
        0.0,
        lambda: float(most_planets(22.5, 14.5)),
        _ERRATA,
    ),
)
"""Headline numbers; the tests hold many more."""


def checked_markdown() -> str:
    """Return the page."""
    rows = "".join(_row(one) for one in CHECKED)
    return f"{_HEAD}{rows}{_DIFFERS}{sources_markdown()}{_TESTS_HEAD}{''.join(_sections())}"


def sources_markdown() -> str:
    """Return the publications that ratings are held to, with how many printed numbers of each."""
    counts: Counter[tuple[str, str]] = Counter()
    for what, cases in _RATED:
        for case in cases:
            counts[_publication(case.source), what] += len(case.expected)
    rows = "".join(f"| {source} | {what} | {count} |\n" for (source, what), count in counts.items())
    sources = len({source for source, _ in counts})
    return f"{_SOURCES_HEAD}{rows}| **{sources} publications** | | **{counts.total()}** |\n"


def _publication(source: str) -> str:
    """Return a publication without its tables and examples; parts of one book are one."""
    return _BOOK if "Shigley" in source else re.split(_PLACE, source)[0]


def _row(one: Checked) -> str:
    got = one.computed()
    if not math.isclose(got, one.expected, rel_tol=0.0, abs_tol=one.tolerance + 1e-12):
        raise ValueError(f"{one.what}: {got:g} is not {one.expected:g} ± {one.tolerance:g} {one.unit}")
    cells = (one.what, f"{one.expected:g} {one.unit}", f"± {one.tolerance:g}", f"{got:.5g} {one.unit}", one.source)
    return f"| {' | '.join(cells)} | `{Path(one.test).stem}` |\n"


def _sections() -> Iterator[str]:
    """Yield one section for each file of tests against published numbers."""
    for path in sorted((TESTS / "validation").rglob("test_*.py")):
        module = ast.parse(path.read_text(encoding="utf-8"))
        rows = "".join(_test(node) for node in module.body if isinstance(node, ast.FunctionDef))
        if rows:
            about = " ".join((ast.get_docstring(module) or "").split())
            yield f"\n### `{path.relative_to(TESTS)}`\n\n{_plain(about)}\n\n{_COLUMNS}{rows}"


def _test(node: ast.FunctionDef) -> str:
    if not node.name.startswith("test_"):
        return ""
    words = " ".join((ast.get_docstring(node) or "").split())
    return f"| {node.name.removeprefix('test_').replace('_', ' ')} | {_plain(words)} |\n"


def _plain(words: str) -> str:
    """Return words in which Markdown finds nothing to do."""
    for sign in "\\`*_|<":
        words = words.replace(sign, f"\\{sign}" if sign != "<" else "&lt;")
    return words


_RATED = (("gears", gears.CASES), ("bearings", bearings.BEARING_CASES), ("shafts", shafts.SHAFT_CASES))
_BOOK = "Budynas & Nisbett, Shigley's Mechanical Engineering Design"
_PLACE = r"[;(]|, (?:as tabulated|stage|example|problem|table|annex|pair|test|in |\d)| \("
_SOURCES_HEAD = """
## Sources of ratings

Printed numbers that ratings are held to by `gearwright validate`, a row a publication, whatever its tables and examples
(`python docs/checked.py` counts them; `gearwright validate --json` has each with its place, tolerance and reason).
Some are at hand as others tabulate them, which their sources there say. Tests below hold more.

| publication | of | numbers |
| --- | --- | --- |
"""
_COLUMNS = "| test | reference and tolerance |\n| --- | --- |\n"
_HEAD = """# Validation

What gearwright computes beside what is published. `python docs/generate.py` computes the numbers of this table and
refuses to write it if one leaves its tolerance; a test fails if the page is not what it writes.

| quantity | expected | tolerance | gearwright | source | test |
| --- | --- | --- | --- | --- | --- |
"""
_DIFFERS = """
Not everything that is published holds: [the thesis](theory/thesis.md) makes claims that its own equations, once they
are right, do not confirm, and [its tables of engines](reference/engines.md) have numbers that their own columns
contradict. Where gearwright differs, it says by how much and why.
[Flights and propellers](theory/flight.md#flights-and-propellers-case-by-case) are told case by case.
"""
_TESTS_HEAD = """
## All tests against published numbers

Each test is a sentence; its docstring says where the number comes from and why the tolerance is what it is.
`pytest tests/validation` runs them. Whether equations are solved right (closed forms, conservation, order of
convergence) is in `tests/verification`, whether anything moved in `tests/golden`.
"""

if __name__ == "__main__":
    print(sources_markdown())
