"""How large the house is, layer by layer: what docs/architecture.md says of it.

python docs/counted.py

Statements are those of Python's own grammar, docstrings left out. Code is what a layer has in lines that are neither
empty, comment nor docstring. Whether arrows point down is asked by `lint-imports`.
"""

from __future__ import annotations

import ast
import io
import statistics
import tokenize
from collections import Counter
from collections.abc import Sequence
from pathlib import Path

SOURCE = Path(__file__).parents[1] / "src" / "gearwright"
NOT_CODE = (tokenize.NL, tokenize.NEWLINE, tokenize.COMMENT, tokenize.INDENT, tokenize.DEDENT, tokenize.ENDMARKER)


def statements(tree: ast.AST) -> int:
    """Return how many statements a module has, without its docstrings."""
    return sum(isinstance(node, ast.stmt) and not is_text(node) for node in ast.walk(tree))


def is_text(node: ast.AST) -> bool:
    """Tell whether a statement is a text and nothing else: a docstring, of a module, function, class or field."""
    return isinstance(node, ast.Expr) and isinstance(node.value, ast.Constant) and isinstance(node.value.value, str)


def documented(tree: ast.AST) -> Counter[bool]:
    """Return how many functions and classes have a docstring, and how many have none."""
    kinds = (ast.FunctionDef, ast.AsyncFunctionDef, ast.ClassDef)
    return Counter(ast.get_docstring(node) is not None for node in ast.walk(tree) if isinstance(node, kinds))


def code_lines(text: str) -> int:
    """Return how many lines of a module hold code."""
    texts = [node for node in ast.walk(ast.parse(text)) if is_text(node)]
    told = {line for node in texts for line in range(node.lineno, node.end_lineno + 1)}
    tokens = tokenize.generate_tokens(io.StringIO(text).readline)
    held = {line for token in tokens if token.type not in NOT_CODE for line in range(token.start[0], token.end[0] + 1)}
    return len(held - told)


def counted(paths: Sequence[Path]) -> list[int]:
    """Return modules, statements, lines of code, definitions and those of them that have a docstring."""
    texts = [path.read_text(encoding="utf-8") for path in paths]
    trees = [ast.parse(text) for text in texts]
    told = sum(map(documented, trees), Counter[bool]())
    return [len(paths), sum(map(statements, trees)), sum(map(code_lines, texts)), told.total(), told[True]]


def main() -> None:
    """Print a table of the layers, and what the house rules ask of modules and folders."""
    modules = sorted(SOURCE.rglob("*.py"))
    layers: dict[str, list[Path]] = {}
    for path in modules:
        layers.setdefault(path.relative_to(SOURCE).parts[0].removesuffix(".py"), []).append(path)
    rows = {layer: counted(paths) for layer, paths in layers.items()}
    print("| layer | modules | statements | lines of code | definitions | with a docstring |")
    print("| --- | --- | --- | --- | --- | --- |")
    for layer, row in sorted(rows.items(), key=lambda item: -item[1][1]):
        print("|", " | ".join([f"`{layer}`", *(f"{number:,}" for number in row)]), "|")
    print("|", " | ".join(["all", *(f"{sum(column):,}" for column in zip(*rows.values(), strict=True))]), "|")
    lengths = {path: len(path.read_text(encoding="utf-8").splitlines()) for path in modules}
    longest = max(lengths, key=lengths.__getitem__)
    print(f"\nlines of a module: median {statistics.median(lengths.values()):g}, largest {lengths[longest]}", end="")
    print(f" ({longest.relative_to(SOURCE)}), over 350: {sum(length > 350 for length in lengths.values())}")
    files = Counter(path.parent for path in modules if path.name != "__init__.py")
    fullest = max(files, key=files.__getitem__)
    crowded = sum(number > 15 for number in files.values())
    print(f"files in a folder, without its __init__: at most {files[fullest]} ({fullest.relative_to(SOURCE)})", end="")
    print(f", over 15: {crowded} of {len(files)}")


if __name__ == "__main__":
    main()
