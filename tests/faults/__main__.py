"""Inject faults one at a time, run the tests concerned, report the survivors.

    PYTHONPATH=tests/faults pytest -p recorder --calls calls.json tests/unit tests/verification tests/validation
    python tests/faults --calls calls.json --count 330 --seed 14 --jobs 2 --out score.json

The first command notes which test calls which function (once, some minutes). The second draws faults from all that
there are and runs, for each, the tests that call the faulty function until one turns red: at first in a child of a
process that has collected them all, with the code of the faulty function exchanged (`in_place`); what that does not
notice, as something may have been computed before, in a child that imports the faulty module anew (`anew`). Nothing is
written into the sources.
"""

from __future__ import annotations

import argparse
import json
import os
from collections import Counter
from collections.abc import Sequence
from hashlib import sha256
from operator import itemgetter
from pathlib import Path

# Threads do not survive a fork.
os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")
os.environ.setdefault("NUMBA_NUM_THREADS", "1")

from anew import noticed_anew
from children import Trial
from concerned import Calls, source_of, targets
from hypothesis import settings
from in_place import noticed_in_place
from mutators import APART, Fault, faults_of


def draw(modules: Sequence[str], count: int, seed: int) -> list[Fault]:
    """Return faults drawn with equal chances from all that there are, but for those that are counted apart.

    A seed gives every fault a rank by its own text, so that a draw stays the same where other code comes or goes.
    """
    every = [fault for module in modules for fault in faults_of(module, source_of(module))]
    faults = [fault for fault in every if fault.kind not in APART]
    print(f"{len(faults)} faults in {len(modules)} modules", flush=True)
    for kind in APART:
        print(f"  apart: {sum(fault.kind == kind for fault in every)} of {kind}", flush=True)
    seen = Counter[str]()
    ranked = []
    for fault in faults:
        text = f"{fault.module} {fault.function} {fault.name} {fault.kind} {fault.change}"
        seen[text] += 1
        ranked.append((sha256(f"{seed} {text} {seen[text]}".encode()).digest(), fault))
    return [fault for _, fault in sorted(ranked, key=itemgetter(0))[:count]]


def command_line() -> argparse.Namespace:
    """Return what was asked for."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--calls", type=Path, nargs="+", required=True, help="what the recorder wrote")
    parser.add_argument("--count", type=int, default=330, help="faults to draw")
    parser.add_argument("--seed", type=int, default=14, help="of the draw")
    parser.add_argument("--jobs", type=int, default=2, help="children at once")
    parser.add_argument("--slowest", type=float, default=10.0, help="tests that take longer are not run [s]")
    parser.add_argument("--budget", type=float, default=30.0, help="time of the tests of one fault, as recorded [s]")
    parser.add_argument("--only", nargs="+", default=[""], help="modules whose name has one of these")
    parser.add_argument("--quick", action="store_true", help="do not import anew what is not noticed in place")
    parser.add_argument("--again", type=Path, help="only the survivors of this earlier score")
    parser.add_argument("--out", type=Path, help="where the score goes")
    return parser.parse_args()


def main() -> None:
    """Draw, run, report."""
    given = command_line()
    calls = Calls.read(given.calls, given.slowest)
    faults = draw(
        [module for module in targets() if any(part in module for part in given.only)], given.count, given.seed
    )
    if given.again:
        earlier = set(json.loads(given.again.read_text())["survivors"])
        faults = [fault for fault in faults if str(fault) in earlier]
    # What is red need not be made small, and what is drawn is the same every time.
    settings.register_profile("faults", derandomize=True, database=None, phases=["explicit", "generate"])
    settings.load_profile("faults")
    trials = [Trial(fault, calls.concerned(fault, given.budget), calls.seconds) for fault in faults]
    noticed = noticed_in_place(trials, given.jobs)
    if not given.quick:
        noticed |= noticed_anew([trial for trial in trials if str(trial.fault) not in noticed], given.jobs)
    report(trials, noticed, given)


def report(trials: Sequence[Trial], noticed: dict[str, str], given: argparse.Namespace) -> None:
    """Say what was noticed, kind by kind, and what was not."""
    kinds = Counter(trial.fault.kind for trial in trials)
    seen = Counter(trial.fault.kind for trial in trials if noticed.get(str(trial.fault)))
    print(f"{seen.total()} of {len(trials)} noticed, seed {given.seed}")
    for kind, count in sorted(kinds.items()):
        print(f"  {kind}: {seen[kind]} of {count}")
    survivors = [str(trial.fault) for trial in trials if not noticed.get(str(trial.fault))]
    for survivor in survivors:
        print(f"  survived: {survivor}")
    if given.out:
        score = {"seed": given.seed, "faults": len(trials), "survivors": survivors, "noticed": noticed}
        given.out.write_text(json.dumps(score, indent=1))


if __name__ == "__main__":
    main()
