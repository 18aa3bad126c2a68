"""Pages of one design: the report, its review, its drawings, the gearbox that turns.

What every page has is in `page`, flights and many designs are beside this folder.
"""
