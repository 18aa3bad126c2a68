"""The modules of the package, each read and parsed once; a rule goes over all of them and names whoever breaks it."""

import ast
from functools import cache
from pathlib import Path

import gearwright

ROOT = Path(gearwright.__file__).parent
MODULES = {str(path.relative_to(ROOT)): path for path in sorted(ROOT.rglob("*.py"))}


@cache
def tree(path):
    """Return the syntax of a module."""
    return ast.parse(path.read_text(encoding="utf-8"))


def functions(path):
    """Return every function of a module, methods and inner ones among them."""
    return [node for node in ast.walk(tree(path)) if isinstance(node, ast.FunctionDef | ast.AsyncFunctionDef)]


def breaking(rule, modules=MODULES):
    """Return module -> what a rule finds wrong in it, of those where it finds anything."""
    return {name: wrong for name, path in modules.items() if (wrong := rule(path))}
