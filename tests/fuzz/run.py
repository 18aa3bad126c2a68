"""Feed fuzzed files to a verb: ``python tests/fuzz/run.py --stage read --count 1000000 --seed 1 --workers 2``.

The same stage, seed and number always give the same file. With ``--out FOLDER`` a run goes on where it stopped, and
every kind of failure is kept there as the shortest file that shows it, with its traceback beside. Exit code 1 says that
something was found.
"""

import argparse
import sys
from pathlib import Path

from fuzz_files import Case, corpus
from fuzz_runner import Run, run
from fuzz_stages import FLOWN, STAGES, Finding, coarse, fed, made


def main() -> int:
    """Run the command; return its exit code."""
    parser = argparse.ArgumentParser(description=__doc__.partition("\n")[0])
    parser.add_argument("--stage", choices=[*STAGES, "all"], default="all", help="Verb that is fed")
    parser.add_argument("--count", type=int, default=1000, help="Files")
    parser.add_argument("--seed", type=int, default=1, help="Of the files")
    parser.add_argument("--workers", type=int, default=1, help="Processes")
    parser.add_argument("--out", type=Path, help="Folder for what is found, and for going on")
    parser.add_argument("--show", type=int, metavar="NUMBER", help="Print one file of the stage, and what it gives")
    asked = parser.parse_args()
    stages = list(STAGES) if asked.stage == "all" else [asked.stage]
    if asked.show is not None:
        return _show(stages[0], asked.seed, asked.show)
    found = 0
    for stage in stages:
        one = Run(stage, asked.seed, asked.count, asked.out)
        one.load()
        warm(stage)
        run(one, asked.workers, _say)
        _say(one.told())
        for signature, count in one.findings.most_common():
            _say(f"  {count:6} {signature}")
        found += sum(one.findings.values())
    return 1 if found else 0


def warm(stage: str) -> None:
    """Feed the shipped files first: they pass, and what is compiled or loaded for them serves all workers."""
    for name, text in corpus("design").items():
        if stage != "fly":
            answer = fed(stage, Case("design", name, text))
            assert answer == "answered", (name, answer)
    for name in FLOWN if stage == "fly" else ():
        answer = fed(stage, Case("mission", name, coarse(corpus("mission")[name])))
        assert answer == "answered", (name, answer)


def _show(stage: str, seed: int, number: int) -> int:
    fuzzed = made(stage, seed, number)
    answer = fed(stage, fuzzed)
    told = answer.told if isinstance(answer, Finding) else answer
    _say(f"# {fuzzed.kind} from {fuzzed.base}\n{fuzzed.text}\n# {told}")
    return 1 if isinstance(answer, Finding) else 0


def _say(line: str) -> None:
    sys.stdout.write(f"{line}\n")
    sys.stdout.flush()


if __name__ == "__main__":
    sys.exit(main())
