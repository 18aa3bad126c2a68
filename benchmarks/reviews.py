"""Processor time of the review of every shipped design, without a mission: python benchmarks/reviews.py."""

import time

import gearwright as gw
from gearwright.reviews import review_of
from gearwright.sizing import size

ROW = "| `{}` | {} | {:.3g} | {} | {} | {:.2f} |"


def main() -> None:
    """Print the worst entry of every shipped design, and the processor time of its review, as a table."""
    review_of(size(gw.read(gw.shipped_design("star"))))  # what is loaded and compiled at first is not counted
    print("| design | worst check | margin | fail | not assessed | time [s] |\n| --- | --- | --- | --- | --- | --- |")
    for name in gw.shipped_designs():
        design, began = gw.read(gw.shipped_design(name)), time.process_time()
        reviewed = gw.review(design)
        spent, first = time.process_time() - began, reviewed.worst
        if first is not None:
            counts = (len(reviewed.failing), len(reviewed.open))
            print(ROW.format(name, first.name, first.margin, *counts, spent))


if __name__ == "__main__":
    main()
