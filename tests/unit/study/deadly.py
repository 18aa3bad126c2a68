"""What computes cases in the tests of workers: some cases kill their worker."""

import os
import signal
from pathlib import Path

from gearwright.sizing import Named
from gearwright.study.answers import Row


def sized_at_once(study, design, case):
    """Return a row that needs no sizing; kill the worker where the study's description says so."""
    how, _, number = study.description.partition(" ")
    if case.number == int(number or -1) and (how == "always" or _first_time(study.name)):
        os.kill(os.getpid(), signal.SIGKILL)
    return Row(case.design, case.inputs, {name: Named(float(case.number), "mass") for name in study.asked})


def _first_time(place):
    try:
        Path(place).touch(exist_ok=False)
    except FileExistsError:
        return False
    return True
