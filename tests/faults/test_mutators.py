"""The injector's own test: what it changes, what it leaves alone, and that a fault does what it says."""

import os
import subprocess
import sys
from pathlib import Path

from mutators import faults_of

SOURCE = '''
"""Not 1.0 of this."""
LIMIT = 0.2


def held(value: float, power: int = 2) -> float:
    """Return 3.0 of nothing."""
    if value < 0.0:
        raise ValueError(f"{value - 1.0} is below {2.0}")
    return min(-value**0.5 + shared(value, LIMIT), LIMIT) if value else 4.0
'''


def test_every_kind_of_fault_is_found_once_where_it_can_be():
    changes = [(fault.function, fault.kind, fault.change) for fault in faults_of("m", SOURCE)]
    assert len(changes) == len(set(changes))
    assert ("<module>", "constant", "0.2 -> 0.25") in changes
    assert ("held", "constant", "2 -> 3") in changes
    assert ("held", "guard", "value < 0.0 -> value > 0.0") in changes
    assert ("held", "exponent", "0.5 -> 0.625") in changes
    assert ("held", "operator", "value ** 0.5 -> value * 0.5") in changes
    assert ("held", "sign", "-value ** 0.5 -> value ** 0.5") in changes
    assert ("held", "swap", "shared(value, LIMIT) -> shared(LIMIT, value)") in changes
    assert {"choice"} == {kind for _, kind, change in changes if "min(" in change}
    assert sum(kind == "choice" for _, kind, _ in changes) == 2


def test_every_fault_can_be_compiled():
    """A fault that cannot be would end its process and look as if a test had noticed it."""
    for fault in faults_of("m", SOURCE):
        assert compile(fault.tree(SOURCE), "m", "exec")


def test_texts_errors_and_annotations_are_left_alone():
    texts = " ".join(fault.change for fault in faults_of("m", SOURCE))
    assert "1.0 ->" not in texts and "2.0 ->" not in texts and "3.0 ->" not in texts


def test_a_fault_changes_what_the_module_computes_and_nothing_else():
    source = "def area(r):\n    return 3.0 * r**2\n\n\ndef twice(x):\n    return x + x\n"
    results = {}
    for fault in faults_of("m", source):
        space = {}
        exec(compile(fault.tree(source), "m", "exec"), space)
        results[fault.change] = (space["area"](2.0), space["twice"](2.0))
    assert results == {
        "3.0 * r ** 2 -> 3.0 / r ** 2": (0.75, 4.0),
        "3.0 -> 3.75": (15.0, 4.0),
        "r ** 2 -> r * 2": (12.0, 4.0),
        "2 -> 3": (24.0, 4.0),
        "x + x -> x - x": (12.0, 0.0),
    }


def test_a_choice_of_sentences_is_counted_apart_and_a_choice_of_words_is_not():
    source = 'def f(x):\n    return ("add one to it" if x > 1.0 else ""), ("planet" if x > 2.0 else "sun")\n'
    kinds = {fault.change: fault.kind for fault in faults_of("m", source)}
    assert kinds["x > 1.0 -> x < 1.0"] == kinds["1.0 -> 1.25"] == "words"
    assert kinds["x > 2.0 -> x < 2.0"] == "comparison" and kinds["2.0 -> 2.5"] == "constant"
    assert sum(kind == "choice" for kind in kinds.values()) == 1


COUNTED = """
import sys
from anew import noticed_anew
from children import Trial
import os
import subprocess
import sys
from pathlib import Path

from mutators import faults_of
from concerned import source_of

module = "gearwright.parts.gears.gear_pair"
fault = next(faults_of(module, source_of(module)))
for test in sys.argv[1:]:
    noticed = noticed_anew([Trial(fault, [test], {test: 1.0})], 1)
    print("counted", list(noticed.values()))
"""


def test_a_test_that_is_not_there_has_noticed_nothing():
    """pytest ends with 4 or 5 where it finds no test: that is no red test."""
    here = Path(__file__).parent
    gone = ["tests/faults/test_mutators.py::test_gone", "tests/unit/test_units.py::test_gone"]
    done = subprocess.run(
        [sys.executable, "-c", COUNTED, *gone],
        env={**os.environ, "PYTHONPATH": os.pathsep.join([str(here), *sys.path])},  # the same gearwright as here
        cwd=here.parents[1],
        capture_output=True,
        text=True,
        check=False,
    )
    assert [line for line in done.stdout.splitlines() if line.startswith("counted")] == ["counted ['']"] * 2, (
        done.stderr
    )
