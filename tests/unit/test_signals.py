"""An interruption arrives, whatever swallows it first, and never within what puts away."""

import os
import signal
import time

import pytest

from gearwright.signals import AGAIN, answered, heard_after, heard_by, interrupt

pytestmark = pytest.mark.skipif(not hasattr(signal, "setitimer"), reason="the system has no timer")
LONG = 20 * AGAIN


@pytest.fixture(autouse=True)
def heard():
    with heard_by(interrupt, [signal.SIGTERM]):
        yield
    answered()


def swallowed():
    """Do as a library in C does that is interrupted where it tells nobody of it."""
    try:
        os.kill(os.getpid(), signal.SIGTERM)
        time.sleep(LONG)
    except KeyboardInterrupt:
        pass


def test_what_is_swallowed_comes_again():
    swallowed()
    with pytest.raises(KeyboardInterrupt):
        time.sleep(LONG)


def test_what_is_answered_does_not_come_again():
    swallowed()
    answered()
    time.sleep(4 * AGAIN)


def test_what_is_imported_is_imported_whole(tmp_path, monkeypatch):
    text = "import os, signal, time\nos.kill(os.getpid(), signal.SIGTERM)\ntime.sleep(%s)\nwhole = True\n" % (4 * AGAIN)
    (tmp_path / "slow_to_import.py").write_text(text, encoding="utf-8")
    monkeypatch.syspath_prepend(tmp_path)
    whole = False
    with pytest.raises(KeyboardInterrupt):
        from slow_to_import import whole

        time.sleep(LONG)
    assert whole


def test_what_puts_away_is_not_interrupted():
    put_away = []

    def work():
        try:
            yield os.kill(os.getpid(), signal.SIGTERM)
        finally:
            time.sleep(4 * AGAIN)
            put_away.append("generator")

    with pytest.raises(RuntimeError):
        try:
            for _ in work():
                pass
        except KeyboardInterrupt as reason:
            raise RuntimeError("a library says it in its way") from reason
        finally:
            time.sleep(4 * AGAIN)
            put_away.append("block")
            answered()
    assert put_away == ["generator", "block"]


def test_what_is_ignored_stays_ignored_meanwhile():
    """As SIGHUP is under nohup."""
    came = []
    with heard_by(signal.SIG_IGN, [signal.SIGHUP]), heard_after(lambda: came.append("heard")):
        os.kill(os.getpid(), signal.SIGHUP)
        time.sleep(0.01)
    assert came == []


def test_what_comes_meanwhile_is_heard_at_once_and_raised_after():
    came = []
    with pytest.raises(KeyboardInterrupt), heard_after(lambda: came.append("heard")):
        os.kill(os.getpid(), signal.SIGTERM)
        time.sleep(0.01)
        came.append("done")
    assert came == ["heard", "done"]
