"""Every verb of dynamics works with one thread of BLAS: it solves with a system's matrices, or calls what does."""

import ast

from sources import MODULES, functions


def decorators(path):
    """Return the decorators of every verb of a module, by name."""
    named = {node.name: [ast.unparse(one) for one in node.decorator_list] for node in functions(path)}
    return {name: given for name, given in named.items() if "verb" in given}


def test_every_verb_of_dynamics_is_limited_to_one_thread():
    verbs = [
        found for name, path in MODULES.items() if name.startswith("dynamics/") for found in decorators(path).items()
    ]
    assert len(verbs) > 20
    assert [name for name, given in verbs if "one_blas_thread()" not in given] == []
