"""What compiles for seconds says so while it does, whichever command it is for, also into a pipe, and once."""

from types import SimpleNamespace

import pytest

from designs import PAIR
from gearwright.app.questions import Question
from gearwright.app.workers import _safely
from gearwright.cli import main
from gearwright.dynamics.code_cache import CodeCache
from gearwright.dynamics.codegen import assembler, generate as native
from gearwright.dynamics.model import system as plan
from gearwright.memo import Memo
from gearwright.notices import notice, noticed
from gearwright.shipped import shipped_mission

THESIS = shipped_mission("thesis").read_text(encoding="utf-8")
TOLD = "compiling the steps"
CUT = '[windows.cut]\nphase = "cruise"\nevent = "motor-cut"\nevent_at_s = 0.1\nduration_s = 0.2\n'
STUDY = (
    'schema = 1\nname = "s"\ndesigns = ["pair.toml"]\nresults = ["simulate.largest_factor"]\n'
    'simulate = {duration_ms = 2}\n[axes]\n"gears.face_width_ratio" = {values = [7, 8]}\n'
)
COMMANDS = {
    "simulate": "simulate pair.toml --duration 0.001",
    "run": "run pair.toml --duration 0.001",
    "runup": "runup pair.toml --speeds 2",
    "review": "review pair.toml",
    "close": "close pair.toml",
    "window": "window in-line-h2 flight.toml cut",
    "fly": "fly in-line-h2 flight.toml --window cut --report page.html",
    "study": "study study.toml --workers 0",
}


@pytest.fixture(autouse=True)
def folder(monkeypatch, tmp_path):
    monkeypatch.chdir(tmp_path)
    for name, text in {"pair.toml": PAIR, "flight.toml": f"{THESIS}\n{CUT}", "study.toml": STUDY}.items():
        (tmp_path / name).write_text(text, encoding="utf-8")


@pytest.fixture
def nothing_kept(monkeypatch):
    """Compile anew what is small, and count that as much as what is large."""
    monkeypatch.setattr(assembler, "kept_code", lambda _: None)
    monkeypatch.setattr(assembler, "keep_code", lambda *_: None)
    monkeypatch.setattr(assembler, "LONG", 0)
    native.compiled.cache_clear()
    monkeypatch.setattr(plan, "_PLANS", Memo(plan.PLANS))
    monkeypatch.setattr(plan, "_KNOWN", Memo(plan.PLANS))


def errors_of(command, monkeypatch, capsys):
    monkeypatch.setattr("sys.argv", ["gearwright", *command.split()])
    with pytest.raises(SystemExit):
        main()
    return capsys.readouterr().err


@pytest.mark.parametrize("name", COMMANDS)
def test_a_command_that_compiles_says_so_once(name, nothing_kept, monkeypatch, capsys):
    assert errors_of(COMMANDS[name], monkeypatch, capsys).count(TOLD) == 1


def test_what_is_compiled_in_less_than_a_second_is_not_told(nothing_kept, monkeypatch, capsys):
    monkeypatch.setattr(assembler, "LONG", 10**9)
    assert TOLD not in errors_of(COMMANDS["simulate"], monkeypatch, capsys)


def test_numba_is_told_before_it_compiles_and_not_of_what_is_kept(monkeypatch):
    kept, target = CodeCache(notice), SimpleNamespace(refresh=lambda: None, codegen=lambda: None)
    monkeypatch.setattr(CodeCache, "_path", lambda *_: None)
    said = []
    with noticed(said.append):
        assert kept.load_overload("f8", target) is None
        assert kept.load_overload("f4", target) is None
    assert len(said) == 1
    assert said[0].startswith(TOLD)


def test_the_workbench_shows_it_beside_how_far_it_is(nothing_kept):
    told = []
    answer = _safely(Question("simulate", PAIR, ".", {"duration": 0.06}), told.append)
    assert answer.status == 200
    assert [progress.lasting for progress in told if progress.words.startswith(TOLD)] == [True]
