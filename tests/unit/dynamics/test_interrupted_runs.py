"""A run that was interrupted is marked, also in its file; what needs a whole run ends as the interruption asked."""

import pytest

from designs import HYBRID
from gearwright.dynamics import simulate
from gearwright.dynamics.assembly import assemble
from gearwright.dynamics.vibration import run_up
from gearwright.sizing import size
from gearwright.spec import parse
from gearwright.store import StoredRun, load, save


@pytest.fixture(scope="module")
def in_line_h2():
    return size(parse(HYBRID))


def stop(_: float) -> None:
    raise KeyboardInterrupt


def test_the_mark_is_in_the_trace_and_in_its_file(in_line_h2, tmp_path) -> None:
    system = assemble(in_line_h2)
    stopped = simulate(system, 0.1, progress=stop)
    assert stopped.interrupted
    with pytest.raises(KeyboardInterrupt):
        stopped.whole()
    save(StoredRun(in_line_h2.design, "cruise", stopped), tmp_path / "run.nc")
    assert load(tmp_path / "run.nc").trace.interrupted
    whole = simulate(system, 1e-4)
    assert not whole.interrupted
    assert whole.whole() is whole


def test_a_run_up_does_not_take_a_stopped_run_for_a_whole_one(in_line_h2, monkeypatch) -> None:
    """Ctrl-C in one of its runs ends the run-up."""
    place = "gearwright.dynamics.vibration.runup.simulate"
    monkeypatch.setattr(place, lambda *given, **named: simulate(*given, **named, progress=stop))
    with pytest.raises(KeyboardInterrupt):
        run_up(in_line_h2, assemble(in_line_h2), [1.0], lines=["first.sun-planet-1"], settle=0.001, window=0.01)
