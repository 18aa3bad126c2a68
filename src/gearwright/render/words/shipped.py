"""What comes with gearwright: every shipped file with its kind, its name and its title."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

from gearwright.shipped import (
    shipped_design,
    shipped_designs,
    shipped_mission,
    shipped_missions,
    shipped_mix,
    shipped_mixes,
    shipped_notebook,
    shipped_notebooks,
    shipped_studies,
    shipped_study,
)
from gearwright.shipped.gallery import notebook_title
from gearwright.spec import read, read_mission, read_mix, read_study


@dataclass(frozen=True)
class ShippedFile:
    """A file that comes with gearwright."""

    kind: Literal["design", "mission", "mix", "study", "notebook"]
    name: str
    """For the commands."""
    title: str


def shipped_files() -> tuple[ShippedFile, ...]:
    """Return designs, missions, mixes, studies and notebooks, each kind by name."""
    return (
        *(ShippedFile("design", name, read(shipped_design(name)).name) for name in shipped_designs()),
        *(ShippedFile("mission", name, read_mission(shipped_mission(name)).name) for name in shipped_missions()),
        *(ShippedFile("mix", name, read_mix(shipped_mix(name)).name) for name in shipped_mixes()),
        *(ShippedFile("study", name, read_study(shipped_study(name)).name) for name in shipped_studies()),
        *(ShippedFile("notebook", name, notebook_title(shipped_notebook(name))) for name in shipped_notebooks()),
    )
