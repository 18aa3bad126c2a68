"""A command that compiles for seconds says so while it does, also into a pipe."""

from importlib import import_module

import pytest

from gearwright.cli import main


@pytest.mark.parametrize(("largest", "told"), [(0, True), (10**6, False)])
def test_what_has_to_be_compiled_is_told_before_it_is(largest, told, monkeypatch, capsys, tmp_path):
    """Of a small design, for which the number of lines that counts as large is set below and above its own."""
    monkeypatch.chdir(tmp_path)
    monkeypatch.setattr(import_module("gearwright.dynamics.motion.simulate"), "LARGEST_GENERATED", largest)
    monkeypatch.setattr("sys.argv", ["gearwright", "simulate", "in-line", "--duration", "0.001"])
    with pytest.raises(SystemExit):
        main()
        raise SystemExit
    assert ("compiling their steps" in capsys.readouterr().err) is told
