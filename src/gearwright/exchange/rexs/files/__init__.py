"""REXS files in each of their forms (XML, JSON, archives) as records, and whether their parts hold together.

What the records mean for a design is not known here.
"""

from gearwright.exchange.rexs.files.document import Attribute, Component, Document, Relation
from gearwright.exchange.rexs.files.opening import LARGEST, opened
from gearwright.exchange.rexs.files.sound import unsound

__all__ = ["LARGEST", "Attribute", "Component", "Document", "Relation", "opened", "unsound"]
