"""Writes the pages that are made from the package, so that a clone can be read as it is: python docs/generate.py."""

from __future__ import annotations

import importlib.util
import sys
from collections.abc import Callable, Mapping
from pathlib import Path

from gearwright.catalogue import materials, rated_steel
from gearwright.particulars import used_material
from gearwright.parts import Material
from gearwright.render.diagrams import DIAGRAMS
from gearwright.render.tables.sizing import properties
from gearwright.replays.colibri.pages import colibri_markdown
from gearwright.units import written

sys.path.insert(0, str(Path(__file__).parent))
from file_reference import (
    anchor,
    design_file_markdown,
    mission_file_markdown,
    mix_file_markdown,
    study_file_markdown,
)

FOLDER = Path(__file__).parent

_MATERIALS_HEAD = """# Materials

The materials that a design may name, as `[gears] material`, as that of a stage or as `[shafting] material`, beside
[its own](../how-to/materials.md). The allowable stresses of the [first sizing](../theory/first-sizing.md) are
$R_{p0.2}/S_F$ in bending and $2.5\\,HB/S_H$ in contact, with HB the Brinell number of the flanks; ISO 6336 takes
σ_Hlim, σ_Flim, HV and the S-N lines. A `~` marks a number that no source gives: the rule by which it is estimated
stands below, where every number has its source. A `–` is not known, and refused where it is needed. This page is made
from the table that the tool reads.
"""
_COLUMNS = (
    "name", "E [GPa]", "ν", "ρ [kg/m³]", "$R_{p0.2}$ [MPa]", "$R_m$ [MPa]", "HB", "HV", "class, grade",
    "σ_Hlim [MPa]", "σ_Flim [MPa]", "melting",
)  # fmt: skip
_SCALES = {"surface_hardness": "hardness"}
"""Property -> the one whose source it shares where it has none of its own."""


def materials_markdown() -> str:
    """Return the table of the catalogue's materials, and where each number of each comes from."""
    known = materials().values()
    head = f"{_MATERIALS_HEAD}\n| {' | '.join(_COLUMNS)} |\n|{' --- |' * len(_COLUMNS)}\n"
    return head + "".join(map(_row, known)) + "".join(map(_origins, known))


def _row(material: Material) -> str:
    steel = None if material.steel is None else rated_steel(material)
    words = (None, None) if steel is None else (steel.contact_strength, steel.bending_strength)
    cells = (
        f"`{material.name}`",
        _cell(material, "elastic_modulus", 1e-9),
        _cell(material, "poisson_ratio"),
        _cell(material, "density"),
        _cell(material, "yield_strength", 1e-6),
        _cell(material, "ultimate_strength", 1e-6),
        _cell(material, "surface_hardness"),
        _cell(material, "hardness"),
        "–" if steel is None else f"{steel.name} {steel.grade}",
        *(
            "–" if value is None else f"{1e-6 * value:.0f}{_guess(material, key)}"
            for key, value in zip(("contact_strength", "bending_strength"), words, strict=True)
        ),
        material.melting or "–",
    )
    return f"| {' | '.join(cells)} |\n"


def _cell(material: Material, key: str, factor: float = 1.0) -> str:
    value = getattr(material, key)
    own = key if key in material.sources or key in material.estimated else _SCALES.get(key, key)
    return "–" if value is None else f"{factor * value:.4g}{_guess(material, own)}"


def _guess(material: Material, key: str) -> str:
    return " ~" if key in material.estimated else ""


def _origins(material: Material) -> str:
    """Return the properties of a material with their sources, those of one source in one line."""
    steel = None if material.steel is None else rated_steel(material)
    lines: dict[str, list[str]] = {}
    for line in properties(used_material(material, steel)):
        value = line.value if isinstance(line.value, str) else written(line.value)
        lines.setdefault(line.source, []).append(f"{line.quantity} {value} {line.unit}".rstrip())
    rows = "".join(f"| {'; '.join(what)} | {source} |\n" for source, what in lines.items())
    return f"\n## {material.name}\n\n{material.source}.\n\n| property | source |\n| --- | --- |\n{rows}"


def pictures() -> dict[str, str]:
    """Return table of the design file -> its diagrams, drawn at the first table that they show keys of."""
    shown: dict[str, list[str]] = {}
    for diagram in DIAGRAMS:
        home, *others = diagram.tables
        shown.setdefault(home, []).append(f"![{diagram.title}](../figures/{diagram.name}.svg)\n\n")
        for table in others:
            link = f"[`[{home}]`](#{anchor(home.split('.'))})"
            shown.setdefault(table, []).append(f"Drawn at {link}: {diagram.title[0].lower()}{diagram.title[1:]}.\n\n")
    return {table: "".join(sorted(lines)) for table, lines in shown.items()}


def beside(name: str) -> Callable[[], str]:
    """Return what makes a page in a module that lies beside this file and is no package.

    Args:
        name: Of the module, whose function is called ``NAME_markdown``.
    """

    def made() -> str:
        spec = importlib.util.spec_from_file_location(name, FOLDER / f"{name}.py")
        assert spec is not None and spec.loader is not None
        module = importlib.util.module_from_spec(spec)
        sys.modules[spec.name] = module
        spec.loader.exec_module(module)
        page: str = getattr(module, f"{name}_markdown")()
        return page

    return made


PAGES: Mapping[str, Callable[[], str]] = {
    "reference/design-file.md": lambda: design_file_markdown(pictures()),
    "reference/mission-file.md": mission_file_markdown,
    "reference/mix-file.md": mix_file_markdown,
    "reference/study-file.md": study_file_markdown,
    "reference/materials.md": materials_markdown,
    "theory/colibri.md": colibri_markdown,
    "reference/commands.md": beside("commands"),
    "how-to/helicopter.md": beside("helicopter"),
    "validation.md": beside("checked"),
    "architecture.md": beside("walks"),
}
"""Page -> what makes it."""


def main() -> None:
    """Write all made pages."""
    for name, made in PAGES.items():
        (FOLDER / name).write_text(made(), encoding="utf-8")


if __name__ == "__main__":
    main()
