"""What computes cases in the tests of workers: some cases kill their worker."""

import os
import random
import signal
import threading
import time
from multiprocessing.connection import Connection
from pathlib import Path

from gearwright.notices import notice
from gearwright.sizing import Named
from gearwright.study.tables import Row


def sized_at_once(study, design, case):
    """Return a row that needs no sizing; kill the worker where the study's description says so."""
    how, _, number = study.description.partition(" ")
    if case.number == int(number or -1) and (how == "always" or _first_time(study.name)):
        os.kill(os.getpid(), signal.SIGKILL)
    return _row(study, case)


def dead_within_its_answer(study, design, case):
    """Return a row; kill the worker when it has sent half of its next message, once."""
    if _first_time(study.name):
        Connection._send = _half_sent
    return _row(study, case)


def large_and_killed(study, design, case):
    """Return a row of 20 MB; for every third case kill the worker at a random moment of its sending, once."""
    place, _, seed = study.description.rpartition(" ")
    if case.number % 3 == 2 and _first_time(f"{place}{case.number}"):
        wait = random.Random(f"{seed} {case.number}").uniform(0.0, 0.04)
        threading.Thread(target=_killed_after, args=(wait,)).start()
    return Row(case.design, case.inputs, {}, "x" * 20_000_000)


def _row(study, case):
    return Row(case.design, case.inputs, {name: Named(float(case.number), "mass") for name in study.asked})


def _half_sent(pipe, message):
    os.write(pipe.fileno(), bytes(message)[: len(message) // 2])
    os.kill(os.getpid(), signal.SIGKILL)


def _killed_after(wait):
    time.sleep(wait)
    os.kill(os.getpid(), signal.SIGKILL)


def _first_time(place):
    try:
        Path(place).touch(exist_ok=False)
    except FileExistsError:
        return False
    return True


def said_first(study, design, case):
    """Return a row, and say that what it needs takes long."""
    notice("compiling")
    return _row(study, case)
