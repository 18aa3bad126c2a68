"""Review: the one place that says good or not good of a design, from every check that there is.

What is judged and how is for the layers below: sizing, dynamics, mission. How it is shown is for `render`.
"""

from gearwright.reviews.review import Review, Verdict, review, review_of

__all__ = ["Review", "Verdict", "review", "review_of"]
