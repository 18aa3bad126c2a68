"""What ``import gearwright as gw`` offers: one list of verbs, told the same way in four places."""

from __future__ import annotations

import ast
import importlib
import re
import subprocess
import sys
from pathlib import Path

import pytest

import gearwright as gw

ROOT = Path(__file__).parents[2]
API = (ROOT / "docs" / "reference" / "api.md").read_text(encoding="utf-8")
ERRANDS = {"app", "check", "export", "import", "new", "run", "status", "resume", "merge", "cluster"}
"""Commands that serve people or read and write their files, and are no verb of their own."""


def typed_names() -> dict[str, tuple[str | None, str]]:
    """Return what type checkers see: name -> module that it is imported from, and what it is called there."""
    tree = ast.parse(Path(gw.__file__).read_text(encoding="utf-8"))
    guard = next(node for node in tree.body if isinstance(node, ast.If))
    return {
        alias.asname or alias.name: (node.module, alias.name)
        for node in guard.body
        if isinstance(node, ast.ImportFrom)
        for alias in node.names
    }


def loaded_names() -> dict[str, tuple[str | None, str]]:
    """Return what the loader does, in the same form."""
    return {name: (f"gearwright.{module}", gw._CALLED.get(name, name)) for name, module in gw._VERBS.items()}


def test_loader_types_and_exports_hold_the_same_names():
    assert typed_names() == loaded_names()
    assert gw.__all__ == list(gw._VERBS) == sorted(gw._VERBS)
    assert set(gw._CALLED) < set(gw._VERBS)


def test_every_verb_is_listed_and_there():
    assert set(gw.__all__) < set(dir(gw))
    for name in gw.__all__:
        assert callable(getattr(gw, name)), name


def test_the_reference_shows_every_verb_under_its_name_with_its_import_path():
    entries = re.findall(r'^::: (\S+)\n    options: \{heading: "gw\.(\w+)"\}$', API, re.MULTILINE)
    shown = {name: path for path, name in entries}
    assert sorted(shown) == gw.__all__
    for name, (layer, called) in loaded_names().items():
        module, _, attribute = shown[name].rpartition(".")
        there = getattr(importlib.import_module(module), attribute)
        assert there is getattr(importlib.import_module(layer), called), name
        assert f"| [`gw.{name}`](#{shown[name]}) |" in API
        assert f"| `{layer}.{called}` |" in API


def test_every_command_that_is_no_errand_has_its_verb():
    """``gearwright runup`` is ``gw.runup``; ``campbell`` with its margins is ``critical_speeds``, too."""
    from gearwright.cli import COMMANDS

    commands = {command.__name__ for group in COMMANDS.values() for command in group}
    assert commands - ERRANDS <= set(gw.__all__)


def test_a_layer_that_has_a_verbs_name_is_both():
    from gearwright import study

    assert gw.study is study and gw.study.Table is study.Table
    assert len(gw.study(gw.read_study("motor-speed")).good) == 21
    with pytest.raises(gw.DesignError, match=r"give a Study, from gw.read_study\(path or shipped name\)"):
        gw.study("motor-speed")
    assert all(number.holds for number in gw.validate("planetary set, N = 3"))


def test_the_package_alone_loads_no_layer():
    code = "import sys, gearwright; print(sorted(m for m in sys.modules if m.split('.')[0] in ('gearwright', 'numpy')))"
    found = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True).stdout
    assert found.strip() == "['gearwright', 'gearwright.version']"
