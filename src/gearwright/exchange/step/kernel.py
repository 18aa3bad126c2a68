"""Open CASCADE by the names of its classes, loaded on their first use: the rooms beside import without it, too."""

from __future__ import annotations

from importlib import import_module
from typing import Any

_ELSEWHERE = {"HArray1": "collections"}
"""Beginning of a name -> its module, where that is not the beginning itself."""


class Kernel:
    """The classes of Open CASCADE: ``occ.gp_Pnt`` is ``OCP.gp.gp_Pnt``."""

    def __getattr__(self, name: str) -> Any:
        """Return a class, and keep it.

        Args:
            name: As Open CASCADE has it, with its package before the first underscore.

        Raises:
            ModuleNotFoundError: If it is not installed.
            AttributeError: If it has no such class.
        """
        package = name.partition("_")[0]
        if not package:  # what looks a module through asks every object for names of Python's own
            raise AttributeError(name)
        found = getattr(import_module(f"OCP.{_ELSEWHERE.get(package, package)}"), name)
        setattr(self, name, found)
        return found


occ = Kernel()
"""What the rooms beside ask for classes."""
