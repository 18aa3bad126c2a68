"""Replays of published work: each holds a document against what gearwright computes.

Clients of the public verbs; no layer below knows them. Every folder is one replay and registers itself.
"""

from importlib import import_module
from pkgutil import iter_modules

from gearwright.replays.replay import REPLAYS, Replay, Verdict, paper_on, register

__all__ = ["REPLAYS", "Replay", "Verdict", "paper_on", "register"]

for _folder in iter_modules(__path__):
    if _folder.ispkg:
        import_module(f"{__name__}.{_folder.name}")
