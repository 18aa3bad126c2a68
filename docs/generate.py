"""Writes the pages that are made from the package, so that a clone can be read as it is: python docs/generate.py."""

from __future__ import annotations

import importlib.util
import sys
from collections.abc import Callable, Mapping
from pathlib import Path

from gearwright.catalogue import materials
from gearwright.parts import Material
from gearwright.render.words.design_file import design_file_markdown, mission_file_markdown, study_file_markdown
from gearwright.replays.colibri.page import colibri_markdown

FOLDER = Path(__file__).parent

_MATERIALS_HEAD = """# Materials

The materials that a design may name, as `[gears] material` or `[shafts] material`. The allowable stresses of the
[first sizing](../theory/first-sizing.md) are $R_{p0.2}/S_F$ in bending and $2.5\\,HB/S_H$ in contact, with HB the
Brinell number of the flanks. This page is made from the table that the tool reads.

| name | E [GPa] | ν | ρ [kg/m³] | $R_{p0.2}$ [MPa] | HB | source |
| --- | --- | --- | --- | --- | --- | --- |
"""


def materials_markdown() -> str:
    """Return the table of the catalogue's materials."""
    return _MATERIALS_HEAD + "".join(_row(each) for each in materials().values())


def _row(material: Material) -> str:
    strength, hardness = material.yield_strength, material.surface_hardness
    cells = (
        f"`{material.name}`",
        f"{1e-9 * material.elastic_modulus:g}",
        f"{material.poisson_ratio:g}",
        f"{material.density:g}",
        "–" if strength is None else f"{1e-6 * strength:g}",
        "–" if hardness is None else f"{hardness:g}",
        material.source,
    )
    return f"| {' | '.join(cells)} |\n"


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
    "reference/design-file.md": design_file_markdown,
    "reference/mission-file.md": mission_file_markdown,
    "reference/study-file.md": study_file_markdown,
    "reference/materials.md": materials_markdown,
    "theory/colibri.md": colibri_markdown,
    "how-to/helicopter.md": beside("helicopter"),
    "validation.md": beside("checked"),
}
"""Page -> what makes it."""


def main() -> None:
    """Write all made pages."""
    for name, made in PAGES.items():
        (FOLDER / name).write_text(made(), encoding="utf-8")


if __name__ == "__main__":
    main()
