"""The workbench: a server on this machine alone, and the pages that it gives to a browser here.

Every route is one public verb and adds no number; what commands print is `cli`'s, figures and pages are `render`'s.
"""

from gearwright.app.serving import serve

__all__ = ["serve"]
