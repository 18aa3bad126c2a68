"""What a rating rests on: the same mesh by every method, side by side, and what would move its safeties.

It rates anew what is sized; it sizes nothing.
"""

from gearwright.sizing.insight.defaults import UsualValue, usual_values
from gearwright.sizing.insight.sensitivity import Influence, MeshInfluences, influences
from gearwright.sizing.insight.side_by_side import Beside, MeshBeside, methods_beside
from gearwright.sizing.insight.trial import Trial, trial_of

__all__ = [
    "Beside",
    "Influence",
    "MeshBeside",
    "MeshInfluences",
    "Trial",
    "UsualValue",
    "influences",
    "methods_beside",
    "trial_of",
    "usual_values",
]
